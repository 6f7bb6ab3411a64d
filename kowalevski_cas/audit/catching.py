"""How many mutants of a source an audit catches, and which survive."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from time import perf_counter

from kowalevski_cas.audit.audit import Audit, audit
from kowalevski_cas.audit.equivalence import equivalence
from kowalevski_cas.audit.mutants import Mutant
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.audit.source import Source
from kowalevski_cas.library import load
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.processes import each, tell, watched
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.record import load_record


@dataclass(frozen=True)
class Caught:
    """What an audit says about one mutant."""

    mutant: Mutant
    changed: tuple[str, ...]
    """The claims, and formulas, of which the verdict or the repair is another one; none of those
    that were not decided in time."""
    named: bool
    """Whether the changed place is among the causes."""
    equivalent: str
    """Why a survivor says the same."""
    late: bool
    """Whether something was not decided in time: then it is not known whether it survives."""

    @property
    def caught(self) -> bool:
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
        return [result for result in self.results if not result.caught]

    @property
    def missed(self) -> list[Caught]:
        """The survivors that are not shown to be equivalent, and were decided."""
        return [r for r in self.survivors if not r.equivalent and not r.late]

    @property
    def late(self) -> list[Caught]:
        """The mutants of which nothing was noticed in time."""
        return [r for r in self.survivors if not r.equivalent and r.late]

    def share(self) -> tuple[int, int]:
        """How many were caught, of how many that are not equivalent and were decided."""
        caught = sum(result.caught for result in self.results)
        return caught, caught + len(self.missed)


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
        return _audited(self)

    def __call__(self, mutant: Mutant) -> Caught:
        """The result for one mutant, in a process in which limits hold."""
        if not watched():
            _audited(self)
            (caught,) = each(self, [mutant])
            return caught
        found = audit(Source(self.path, mutant.text), self.base.session.base)
        before, after = _signature(self.base), _signature(found)
        changed = tuple(
            name
            for name in {**before, **after}
            if before.get(name) != after.get(name) and not _late(after.get(name))
        )
        reason = ""
        if not changed:
            reason = equivalence(self.base.session, mutant.printed, mutant.before, mutant.after)
        late = any(map(_late, after.values()))
        return Caught(mutant, changed, self._named(found, mutant), reason, late)

    def _named(self, found: Audit, mutant: Mutant) -> bool:
        causes = found.session.causes.values()
        if any(mutant.printed in places for places in causes):
            return True
        verdicts = {formula.place: formula.verdict for formula in self.base.formulas}
        return any(
            formula.wrong or formula.verdict != verdicts.get(formula.place)
            for formula in found.formulas
            if formula.place == mutant.printed or formula.id == mutant.printed.display.id
        )


@cache
def _audited(measure: Measure) -> Audit:
    session = AuditSession(
        load(str(measure.folder)),
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
    """Audit mutants of a source; it tells how far it has come."""
    start = perf_counter()
    found = Measurement()
    for result in pool.map(work, mutants):
        found.results.append(result)
        tell("mutants", len(found.results), len(mutants))
    found.seconds = perf_counter() - start
    return found
