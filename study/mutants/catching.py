"""How many mutants of a source an audit catches, which it repairs, and which survive."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from time import perf_counter

from kowalevski_cas.audit.audit import Audit, audit
from kowalevski_cas.audit.restoration import AS_BEFORE
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.library import load
from kowalevski_cas.limits import is_watched, tell
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.processes import each
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.confirm import need_certificates
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.record import load_record
from study.mutants.equivalence import equivalence
from study.mutants.mutant import Mutant


@dataclass(frozen=True)
class Caught:
    """What an audit says about one mutant."""

    mutant: Mutant
    role: str
    changed: tuple[str, ...]
    """The claims, and formulas, of which the verdict or the repair is another one; none of those
    that were not decided in time."""
    named: bool
    """Whether the changed place is among the causes."""
    repair: str
    """For a claim that was true: an edit of the mutant has ``restored`` it, the ``derivation`` says
    what it was, another formula is ``true``, or there is ``none``."""
    equivalent: str
    late: bool
    """Whether something was not decided in time: then it is not known whether it survives."""
    seconds: float
    outcomes: tuple[Outcome, ...] = ()
    """What is said otherwise than of the source as it is, with what shows it."""

    @property
    def is_caught(self) -> bool:
        """Whether anything changed."""
        return bool(self.changed)


@dataclass
class Measurement:
    """The results for a sample of mutants."""

    results: list[Caught] = field(default_factory=list)
    seconds: float = 0.0

    @property
    def survivors(self) -> list[Caught]:
        """The mutants of which nothing was noticed."""
        return [result for result in self.results if not result.is_caught]

    @property
    def escapes(self) -> list[Caught]:
        """The survivors that are not shown to be equivalent, and were decided."""
        return [r for r in self.survivors if not r.equivalent and not r.late]

    @property
    def late(self) -> list[Caught]:
        """The mutants of which nothing was noticed in time."""
        return [r for r in self.survivors if not r.equivalent and r.late]

    def share(self) -> tuple[int, int]:
        """How many were caught, of how many that are not equivalent and were decided."""
        caught = sum(result.is_caught for result in self.results)
        return caught, caught + len(self.escapes)

    def repairs(self) -> Counter[str]:
        """The repairs of claims by kind."""
        return Counter(result.repair for result in self.results if result.repair)


@dataclass(frozen=True)
class Measure:
    """Audits mutants against the audit of the source as it is, which is made once in a process.

    Args:
        folder: where the derivation is kept.
        path: the name of the source.
        text: the source.
        timeout: the seconds for each claim.
    """

    folder: Path
    path: str
    text: str
    timeout: float

    @property
    def base(self) -> Audit:
        """The audit of the source as it is."""
        return _audit(self)

    def __call__(self, mutant: Mutant) -> Caught:
        """The result for one mutant, in a process in which limits hold."""
        if not is_watched():
            _audit(self)
            (caught,) = each(self, [mutant])
            return caught
        start = perf_counter()
        found = audit(Source(self.path, mutant.text), self.base.session.base)
        seconds = perf_counter() - start
        before, after = _signature(self.base), _signature(found)
        changed = tuple(
            name
            for name in {**before, **after}
            if before.get(name) != after.get(name) and not _late(after.get(name))
        )
        reason = ""
        if not changed:
            reason = equivalence(
                self.base.session.interpretation, mutant.printed, mutant.before, mutant.after
            )
        formula = next((f for f in self.base.formulas if f.place == mutant.printed), None)
        return Caught(
            mutant,
            formula.role if formula is not None else "none",
            changed,
            self._is_named(found, mutant),
            self._repair(found, mutant),
            reason,
            any(map(_late, after.values())),
            seconds,
            tuple(
                outcome
                for outcome in found.outcomes.values()
                if f"claim {outcome.claim}" in changed
            ),
        )

    def _is_named(self, found: Audit, mutant: Mutant) -> bool:
        causes = found.session.causes.places.values()
        if any(mutant.printed in places for places in causes):
            return True
        verdicts = {formula.place: formula.verdict for formula in self.base.formulas}
        return any(
            formula.wrong or formula.verdict != verdicts.get(formula.place)
            for formula in found.formulas
            if formula.place == mutant.printed or formula.id == mutant.printed.display.id
        )

    def _repair(self, found: Audit, mutant: Mutant) -> str:
        """What the repair of a mutated claim is, if the claim was true before."""
        claims = self.base.session.interpretation.derivation.claims
        about = [c for c in claims if mutant.printed in c.establishes()]
        if not about or any(not self.base.outcomes[c.id].verdict.green for c in about):
            return ""
        outcomes = [found.outcomes[c.id] for c in about]
        broken = [o for o in outcomes if not o.verdict.green]
        if not broken:
            return ""
        if any(o.correction is None or not o.correction.verdict.green for o in broken):
            return "none"
        corrections = [o.correction for o in broken if o.correction is not None]
        if any(correction.words == AS_BEFORE for correction in corrections):
            return "derivation"
        edits = (c.edit for c in corrections if c.printed == mutant.printed and c.edit is not None)
        return "restored" if any(edit.formula == mutant.before for edit in edits) else "true"


@cache
def _audit(measure: Measure) -> Audit:
    session = AuditSession(
        load(str(measure.folder)),
        ["flint"],
        certificates=load_certificates(measure.folder),
        timeout=measure.timeout,
        record=load_record(measure.folder),
    )
    return audit(Source(measure.path, measure.text), session)


def _signature(found: Audit) -> dict[str, object]:
    """Verdicts and repairs, by claim and by formula."""
    claims: dict[str, object] = {
        f"claim {outcome.claim}": _of(outcome) for outcome in found.outcomes.values()
    }
    formulas = {
        f"formula {formula.id}": (formula.verdict, formula.message if formula.wrong else "")
        for formula in found.formulas
    }
    return {**claims, **formulas}


def _late(said: object) -> bool:
    """Whether nothing was said in time, which catches nothing."""
    return isinstance(said, tuple) and said[0] == Verdict.TIMEOUT


def _of(outcome: Outcome) -> object:
    correction = outcome.correction
    return (
        outcome.verdict,
        tuple(condition.expression for condition in outcome.conditions),
        None if correction is None else (correction.formulas, correction.words),
    )


def measure(work: Measure, mutants: Sequence[Mutant], pool: Pool = HERE) -> Measurement:
    """Audit mutants of a source; it tells how far it has come.

    Raises ``Disagreement`` if the checker does not accept here what a worker has found.
    """
    start = perf_counter()
    found = Measurement()
    for result in pool.map(work, mutants):
        for outcome in result.outcomes:
            need_certificates(outcome)
        found.results.append(result)
        tell("mutants", len(found.results), len(mutants))
    found.seconds = perf_counter() - start
    return found
