"""Mutants of a paper that is its own derivation: what becomes of the claims that were proved.

A mutant is *noticed* if a claim that was green turns red, or yellow with the changed formula named.
It is excluded, and counted, if that cannot be: it says the same by algebra (equivalent), or all
that rested on it is proved of the changed paper too (harmless). It is *lost* if a claim is no
longer green and nothing is said of the changed formula. Worst is what is green on a supposition on
which it was not green before: *strange*.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from random import Random

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import OPEN, SUSPECT, Audited
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.limits import is_watched, tell
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.processes import each
from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION, LAW, read
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Verdict
from study.mutants.equivalence import equivalence
from study.mutants.mutant import Mutant, sample

ROLES = (LAW, DEFINITION, ASSUMPTION, CLAIM)
NOTICED, LOST, STRANGE, LATE = "noticed", "lost", "strange", "late"
EQUIVALENT, HARMLESS = EXCLUDED = "equivalent", "harmless"

DRAWS = 40
"""How many mutants are drawn for each that is wanted of a role."""


@dataclass(frozen=True)
class Fate:
    """What becomes of a mutant."""

    mutant: Mutant
    role: str
    end: str
    words: str
    """The claim that shows it, or the reason."""


@dataclass
class Fates:
    """The fates of some mutants of a paper."""

    results: list[Fate] = field(default_factory=list)

    def share(self, role: str) -> tuple[int, int]:
        """How many mutants of a role are noticed, of how many that could be."""
        counts = Counter(result.end for result in self.results if result.role == role)
        return counts[NOTICED], counts[NOTICED] + counts[LOST] + counts[STRANGE]

    def of(self, *ends: str) -> list[Fate]:
        """The results that end so."""
        return [result for result in self.results if result.end in ends]


@dataclass(frozen=True)
class Alone:
    """Audits mutants of a paper without a derivation, against the audit of the paper as it is."""

    path: str
    text: str
    timeout: float

    @property
    def base(self) -> Audit:
        """The audit of the paper as it is."""
        return _audit_of(self)

    def __call__(self, mutant: Mutant) -> Fate:
        """The fate of a mutant, in a process in which limits hold."""
        if not is_watched():
            _audit_of(self)
            (fate,) = each(self, [mutant])
            return fate
        changed = next(f for f in self.base.formulas if f.place == mutant.printed)
        end, words = self.end(mutant, changed)
        return Fate(mutant, changed.role, end, words)

    def end(self, mutant: Mutant, changed: Audited) -> tuple[str, str]:
        """What becomes of a mutant, and the claim that shows it, or the reason."""
        resting = self.claims_on(changed)
        found = _audit(Source(self.path, mutant.text), self.timeout)
        pairs = list(zip(self.base.formulas, _pairs(self.base, found), strict=True))
        now = {one.name: other for one, other in pairs}
        for claim in resting:
            if _is_noticed(now[claim.name], now[changed.name]):
                return NOTICED, claim.name
        for claim in resting:
            if _suppositions(now[claim.name], found) - {id(now[name]) for name in claim.on}:
                return STRANGE, claim.name
        lost = next((one for one in resting if not _green(now[one.name])), None)
        if lost is None:
            return HARMLESS, "all that rested on it is proved"
        late = now[lost.name]
        if late is not None and late.verdict == Verdict.TIMEOUT:
            return LATE, lost.name
        reason = ""
        if changed.role != ASSUMPTION:  # on it an assumption says the same as any other that holds
            base = self.base.session.base.decider.interpretation
            reason = equivalence(base, mutant.printed, mutant.before, mutant.after)
        return (EQUIVALENT, reason) if reason else (LOST, _said(lost, late))

    def claims_on(self, changed: Audited) -> list[Audited]:
        """The formulas with green claims that read a formula, or are made of it."""
        claims = {claim.id: claim for claim in self.base.session.interpretation.derivation.claims}
        return [
            formula
            for formula in self.base.formulas
            if _green(formula)
            and (formula is changed or changed.role != CLAIM)
            and any(changed.place in claims[name].reads() for name in formula.claims)
        ]


def _is_noticed(claim: Audited | None, changed: Audited | None) -> bool:
    """Whether a claim is red, or yellow with the changed formula named, or this false as read."""
    if claim is None or _green(claim):
        return False
    if claim.verdict == Verdict.REFUTED:
        return True
    named = changed is not None and (
        claim is changed
        or changed.verdict in (SUSPECT, Verdict.REFUTED)
        or changed.message.startswith(FALSE_AS_READ)
        or changed.name in claim.causes
    )
    return named and claim.verdict in (Verdict.UNDECIDED, OPEN)


def _said(claim: Audited, now: Audited | None) -> str:
    """What is said of a claim instead of its verdict."""
    words = "not listed" if now is None else f"{now.role}, {now.verdict}: {now.message}"
    return f"{claim.name} ({words})"


def _green(formula: Audited | None) -> bool:
    green = (Verdict.PROVED, Verdict.CONDITIONAL)
    return formula is not None and formula.role == CLAIM and formula.verdict in green


def _suppositions(claim: Audited | None, audit: Audit) -> set[int]:
    """The formulas of an audit that are supposed for a claim, if it is green."""
    if claim is None or not _green(claim):
        return set()
    return {id(formula) for formula in audit.formulas if formula.name in claim.on}


def _pairs(base: Audit, found: Audit) -> Iterator[Audited | None]:
    """The formulas of a mutant that stand where those of the paper do, in their order."""
    if len(base.formulas) == len(found.formulas):
        yield from found.formulas
        return
    there: dict[int, list[Audited]] = {}
    for formula in found.formulas:
        there.setdefault(formula.line, []).append(formula)
    for formula in base.formulas:
        line = there.get(formula.line)
        yield line.pop(0) if line else None


def _audit(source: Source, timeout: float) -> Audit:
    return audit_reading(ReadingSession(read(source), ["flint"], timeout=timeout))


@cache
def _audit_of(work: Alone) -> Audit:
    return _audit(Source(work.path, work.text), work.timeout)


def draw_mutants(work: Alone, size: int, random: Random) -> list[Mutant]:
    """Mutants of the formulas of each role on which something green rests: as many as there are."""
    roles = {
        formula.place: formula.role for formula in work.base.formulas if work.claims_on(formula)
    }
    found: list[Mutant] = []
    counts: Counter[str] = Counter()
    for mutant in sample(work.base, DRAWS * size, random):
        role = roles.get(mutant.printed, "")
        if role in ROLES and counts[role] < size:
            counts[role] += 1
            found.append(mutant)
    return found


def fates(work: Alone, mutants: Sequence[Mutant], pool: Pool = HERE) -> Fates:
    """Audit mutants of a paper; it tells how far it has come."""
    found = Fates()
    for result in pool.map(work, mutants):
        found.results.append(result)
        tell("mutants", len(found.results), len(mutants))
    return found
