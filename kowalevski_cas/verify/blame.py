"""Blame: which printed formula is wrong when claims fail, and what it should say.

What claims that fail together share is suspected: the law, a definition, an assumption that misses
a relation of constants. An edit of it is a repair if it mends claims and breaks none. For several
claims that edit is likeliest which mends most of them; of those that mend as many, one of a
claim's own formula comes before a relation of constants, this before an edit of a definition, and
that before one of the law. A claim that fails alone has its own formula corrected, if that can be,
and if the law does not print a rate twice.

A run asks when all its claims are decided; who has a :class:`~.corrector.Corrector` asks for::

    found = Blame(corrector, {claim: outcome.verdict, …}).corrections()

the :class:`~.outcome.Correction` of each refuted claim that has one, and up to two alternatives, by
the ids of the claims. Of a repair of another formula ``blamed`` is what is printed there, and
``printed`` is its place. Every one is proved; nothing is green by it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import islice, takewhile
from math import inf
from typing import TYPE_CHECKING

from kowalevski_cas.limits import clock
from kowalevski_cas.notation import Edit, NotationError
from kowalevski_cas.notation.layout import EITHER_SIGN
from kowalevski_cas.paper.claims import (
    Claim,
    Inequality,
    InvariantRelations,
    Neighbour,
    RestPoint,
    RestPoints,
)
from kowalevski_cas.paper.claims.eigenvalue import OfLinearPart
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.corrections import fails_at_points, passes, statement_of
from kowalevski_cas.verify.corrector import Corrector
from kowalevski_cas.verify.outcome import Correction, Verdict
from kowalevski_cas.verify.relations import ConstantRelation
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.suspects import (
    Repair,
    Repairs,
    Suspect,
    Suspicion,
    adds_something,
    changes,
    determined_rates,
    likelihood,
    numbers,
)
from kowalevski_cas.verify.vacuous import count_equal_rates, says_something, stops
from kowalevski_cas.verify.variations import Variations

if TYPE_CHECKING:
    from kowalevski_cas.problem.sampled import Sampled

MOST = 3
"""How many repairs are proposed."""
SHARE = 10
"""The part of the time in which more corrections of a formula are sought, if there is one."""

LESS = 4
"""The part of the time in which a number is sought where no slip of the pen mends anything."""

_OF_POINTS = (InvariantRelations, RestPoint, RestPoints, OfLinearPart, Inequality)
"""The claims that say so little of the law that for one of them alone it is not suspected."""


def _as_printed(claim: Claim) -> tuple[str, ...]:
    """The formula of a claim that is printed for two signs at once; else the claim itself."""
    printed = claim.printed
    if printed is None or not EITHER_SIGN.search(printed.tex):
        return (claim.id,)
    return (printed.display.id, printed.tex)


@dataclass
class Blame:
    """The search for what makes claims fail, in a run that has come to its end."""

    corrector: Corrector
    verdicts: Mapping[str, Verdict]
    corrected: Collection[str] = ()
    """The claims that have a correction already."""
    seconds: float = inf
    """For the search of what claims stand on, which then has what was found so far."""
    doubted: Collection[str] = ()
    """Of those that have a correction, the claims that may have been meant otherwise."""
    lost: Mapping[str, Collection[str]] = field(default_factory=dict)
    """The names in claims that the paper defines nowhere, beside those of their scenes."""
    suspected: Mapping[Printed, Sequence[Edit]] = field(default_factory=dict)
    """What other signs than failing claims speak against, with the edits that would mend it."""
    decides_again: bool = False
    """Whether what stands on what several claims blame is decided again with that mended."""
    _true: dict[str, bool] = field(default_factory=dict)
    _varied: dict[str, Variations] = field(default_factory=dict)

    @property
    def _derivation(self) -> Derivation:
        return self.corrector.interpretation.derivation

    def _on(self, claim: Claim) -> Elaborations:
        return self.corrector.interpretation.on(claim)

    def corrections(self) -> Repairs:
        """The corrections of all claims that fail: what they share first, then one by one."""
        found: Repairs = {}
        for cluster in self.clusters():
            found |= self.shared(cluster)
        for claim in self.open():
            if claim.id not in found:
                found[claim.id] = self.alone(claim)
        return found

    def open(self) -> list[Claim]:
        """The refuted claims that were asked for, and have no correction."""
        refuted = {id for id, verdict in self.verdicts.items() if verdict is Verdict.REFUTED}
        return [c for c in self._derivation.claims if c.id in refuted.difference(self.corrected)]

    def clusters(self) -> list[list[Claim]]:
        """The claims that one change may mend together: they stand on formulas in common.

        What one formula prints for both of two signs is said once.
        """
        found: list[tuple[list[Claim], frozenset[Printed]]] = []
        for claim in self.open():
            if self._explains_itself(claim):
                continue
            reads = claim.reads()
            near = [cluster for cluster in found if cluster[1] & reads]
            found = [cluster for cluster in found if cluster not in near]
            claims = [one for ones, _ in near for one in ones]
            found.append(([*claims, claim], reads.union(*(read for _, read in near))))
        return [claims for claims, _ in found if len({*map(_as_printed, claims)}) > 1]

    def shared(self, cluster: Sequence[Claim]) -> Repairs:
        """The corrections of claims of a cluster that one change mends together."""
        found: Repairs = {}
        failing = [*cluster]
        while len(failing) > 1:
            best = self._proofs(self._search(failing, least=2), least=2)
            if not best:
                break
            found |= best
            failing = [claim for claim in failing if claim.id not in best]
        return found

    def alone(self, claim: Claim) -> tuple[Correction, ...]:
        """The corrections of one claim: of its own formula, or else of what it stands on."""
        printed = self.corrector.interpretation.statement(claim)
        is_printed = claim.printed is None or not claim.printed.display.source
        near = self.corrector.near(printed, MOST, self.seconds / SHARE) if is_printed else ()
        edits = tuple(near)
        if self._is_expected(claim):
            return edits
        if first := self._proofs(self._by_suspicion(claim), least=1).get(claim.id):
            return (*first, *edits)[:MOST]
        twice = self._equal_rates(claim)
        if (edits and not twice) or isinstance(claim, _OF_POINTS):
            return edits
        reads = claim.reads()
        others = [o for o in self._failing if o is not claim and reads & o.reads()]
        repairs = self._search([claim, *others], least=1, one=claim)
        repairs = [repair for repair in repairs if not adds_something(repair.change)]
        if edits:  # nobody prints a rate twice: a letter there was taken for another one
            repairs = [
                repair
                for repair in repairs
                if repair.suspect is Suspect.LAW and self._equal_rates(claim, repair) < twice
            ]
        return (*self._proofs(repairs, least=1).get(claim.id, ()), *edits)[:MOST]

    def _by_suspicion(self, claim: Claim) -> Iterator[Repair]:
        """The edits of what is suspected beside a claim that stands on it."""
        own = claim.establishes()
        for place, several in self.suspected.items():
            if place in claim.reads() and place not in own:
                yield from (Repair(Suspect.DEFINITION, edit, place, (claim,)) for edit in several)

    def _equal_rates(self, claim: Claim, repair: Repair | None = None) -> int:
        """How many pairs of variables have the same rate, which is not zero, with a repair."""
        on, scene = self._on(claim), claim.scene
        if repair is not None:
            edited = repair.of(claim, on.texts)
            on, scene = on.under(edited.texts), edited.claim.scene
        moved = scene.field and not isinstance(scene.field, Change)
        return count_equal_rates(on(scene)) if moved else 0

    # -- who fails ------------------------------------------------------------------

    @cached_property
    def _failing(self) -> list[Claim]:
        """The claims that are refuted, or fail at points if they were not asked for.

        Those are left out of which the author expects it, and those that are corrected already.
        """
        return [claim for claim in self._derivation.claims if self._fails(claim)]

    def _is_expected(self, claim: Claim) -> bool:
        """Whether the author knows that a claim fails: then nothing else is to blame for it."""
        return self._derivation.expected.get(claim.id) == Verdict.REFUTED

    def _explains_itself(self, claim: Claim) -> bool:
        """Whether nothing else is to blame: its author expects it, or a lost name is misprinted.

        What another formula spoils has no name that is defined nowhere.
        """
        if self._is_expected(claim):
            return True
        lost = {*self.lost.get(claim.id, ()), *claim.scene.undefined}
        on = self._on(claim)
        stages: dict[object, Sampled | None] = {}
        if not lost or not lost & {n for f in claim.formulas(on.texts) for n in f.names()}:
            return False
        near = claim.neighbours(on.texts)
        named = (n for n in near if n.edit and lost.isdisjoint(n.edit.formula.names()))
        return any(passes(neighbour, on, stages) for neighbour in named)

    def _fails(self, claim: Claim) -> bool:
        if self._is_expected(claim):
            return False
        if claim.id in self.verdicts:
            refuted = self.verdicts[claim.id] is Verdict.REFUTED
            return refuted and claim.id not in self.corrected
        on = self._on(claim)
        try:
            self._statement(claim)
        except (NotationError, Meaningless):
            return False  # what says nothing is not false
        return passes(Neighbour("", claim, on.texts), on, {}) is False

    def _holds(self, claim: Claim) -> bool:
        """Whether a claim is true as it is printed; what was not asked for, perhaps at points."""
        if claim.id not in self._true:
            verdict = self.verdicts.get(claim.id)
            self._true[claim.id] = self._seems(claim) if verdict is None else verdict.green
        return self._true[claim.id]

    def _seems(self, claim: Claim) -> bool:
        """Whether a claim is true at points, or by a proof if they cannot tell."""
        on = self._on(claim)
        at_points = passes(Neighbour("", claim, on.texts), on, {})
        return self.corrector.is_true(claim) if at_points is None else at_points

    def _statement(self, claim: Claim) -> Statement:
        return self.corrector.interpretation.statement(claim)

    @cached_property
    def _stated(self) -> frozenset[Printed]:
        """What true claims state, and what is accepted."""
        true = (claim for claim in self._derivation.claims if self._holds(claim))
        stated = (place for claim in true for place in claim.establishes())
        return frozenset(stated).union(self.corrector.interpretation.accepted)

    def _right(self, failing: Sequence[Claim]) -> set[Printed]:
        """What true claims state or determine, and what is accepted: nobody suspects that."""
        beside = [c for c in self._derivation.claims if self._is_doubted(c)]
        interpretation = self.corrector.interpretation
        return {
            *self._stated, *determined_rates([*failing, *beside], interpretation, self._holds)
        }  # fmt: skip

    def _is_doubted(self, claim: Claim) -> bool:
        """Whether a claim fails that may have been meant otherwise."""
        return claim.id in self.doubted and self.verdicts.get(claim.id) is Verdict.REFUTED

    # -- what mends -----------------------------------------------------------------

    def _search(
        self, failing: Sequence[Claim], least: int, one: Claim | None = None
    ) -> list[Repair]:
        """The repairs that at points mend so many claims, perhaps this one, and break none.

        Where no slip of the pen does, a coefficient may be any number.
        """
        on = self.corrector.interpretation, partial(self._right, failing)
        end = clock() + self.seconds
        in_time = takewhile(lambda _: clock() < end, changes(failing, least, *on))
        if found := self._mending(in_time, least, one):
            return found
        end = clock() + self.seconds / LESS
        return self._mending(numbers(failing, least, *on, lambda: clock() < end), least, one)

    def _mending(
        self, candidates: Iterable[Suspicion], least: int, one: Claim | None
    ) -> list[Repair]:
        """The changes that at points mend so many claims, perhaps this one, the likeliest first."""
        found: list[Repair] = []
        most = least
        for suspect, change, place, standing in candidates:
            repair = Repair(suspect, change, place, ())
            if one is not None and one not in standing:
                continue
            # with more failures than these it would mend fewer claims than the best so far
            allowed = len(standing) - most
            mends = []
            for claim in standing:
                if self._passes(repair, claim) is not False:
                    mends.append(claim)
                elif claim is one or (allowed := allowed - 1) < 0:
                    allowed = -1
                    break
            if allowed < 0 or len(mends) < most:
                continue
            repair = repair._replace(mends=tuple(mends))
            if suspect is Suspect.LAW:  # no other one may break anything
                repair = repair._replace(beside=self._mended_beside(repair))
            if not self._breaks_too_much(repair):
                most = len(mends)
                found.append(repair)
        return sorted(found, key=likelihood)

    def _mended_beside(self, repair: Repair) -> int:
        """How many claims a repair mends that may have been meant otherwise."""
        about = self._readers(repair)
        return sum(self._is_doubted(c) and self._is_mended(repair, c) for c in about)

    def _readers(self, repair: Repair) -> list[Claim]:
        """The claims of which a verdict can depend on what a repair changes."""
        readers = map(self.corrector.interpretation.readers, repair.places)
        return [*dict.fromkeys(claim for claims in readers for claim in claims)]

    def _is_mended(self, repair: Repair, claim: Claim) -> bool:
        """Whether a repair makes a claim true: at points, or by a proof if they cannot tell."""
        if (at_points := self._passes_at_real_points(repair, claim)) is not None:
            return at_points
        on = self._on(claim)
        try:
            return statement_of(repair.of(claim, on.texts), on).holds()
        except (NotationError, Meaningless, ZeroDivisionError):
            return False

    def _passes(self, repair: Repair, claim: Claim) -> bool | None:
        on = self._on(claim)
        if isinstance(repair.change, Edit):
            if claim.id not in self._varied:
                self._varied[claim.id] = Variations(claim, on)
            if self._varied[claim.id].exclude(repair.place, repair.change):
                return False
        return passes(repair.of(claim, on.texts), on.apart(on.texts), {})

    def _passes_at_real_points(self, repair: Repair, claim: Claim) -> bool | None:
        """Whether a claim passes with a repair; where that cannot be told, if it fails there."""
        verdict, on = self._passes(repair, claim), self._on(claim)
        if verdict is None and fails_at_points(repair.of(claim, on.texts), on, {}):
            return False
        return verdict

    def _broken(self, repair: Repair) -> Iterator[Claim]:
        """The true claims that a repair makes false, as points tell."""
        about = [] if isinstance(repair.change, ConstantRelation) else self._readers(repair)
        return (c for c in about if self._holds(c) and self._passes(repair, c) is False)

    def _breaks_too_much(self, repair: Repair) -> bool:
        """Whether a repair makes more claims false than it may."""
        return any(islice(self._broken(repair), repair.tolerates, None))

    # -- what is proved ---------------------------------------------------------------

    def _proofs(self, repairs: Iterable[Repair], least: int) -> Repairs:
        """The corrections by the likeliest repairs that are proved and mend the same claims."""
        found: Repairs = {}
        for repair in repairs:
            proved = {claim.id: self._proof(repair, claim) for claim in repair.mends}
            mended = {id: (proof,) for id, proof in proved.items() if proof is not None}
            if len(mended) < least or (found and mended.keys() != found.keys()):
                continue
            repair = repair._replace(mends=tuple(c for c in repair.mends if c.id in mended))
            if self._breaks_too_much(repair):  # points left open whether it mends more
                continue
            told = {proof.formulas for ones in found.values() for proof in ones}
            if any(proof.formulas in told for (proof,) in mended.values()) or self._spoils(repair):
                continue
            found = {id: (*found.get(id, ()), *proofs) for id, proofs in mended.items()}
            if all(len(ones) == MOST for ones in found.values()):
                break
        return found

    def _proof(self, repair: Repair, claim: Claim) -> Correction | None:
        """A claim with a repair as its correction, if it is proved and says something."""
        on = self._on(claim)
        neighbour = repair.of(claim, on.texts)
        try:
            statement = statement_of(neighbour, on)
            if not says_something(neighbour, statement, self._statement(claim)):
                return None
            if self._passes_at_real_points(repair, claim) is False:
                return None
            proved = self.corrector.correction_of(neighbour, statement)
            return proved and proved._replace(others=self._others(repair))
        except (NotationError, Meaningless, ZeroDivisionError):
            return None

    def _others(self, repair: Repair) -> tuple[str, ...]:
        """The true claims that stand on what a repair changes."""
        if not isinstance(repair.change, Edit):
            return ()
        broken = [*self._broken(repair)] if repair.tolerates else []
        true = (c for c in self._derivation.claims if self._holds(c) and c not in broken)
        changed = {*repair.places}
        return tuple(c.id for c in true if changed & {*self._statement(c).stands_on})

    def _spoils(self, repair: Repair) -> bool:
        """Whether a repair makes false what is true, or leaves nothing of what it changes."""
        place, edit = repair.place, repair.change
        if not isinstance(edit, Edit):
            return False
        keeps = self.corrector.keeps
        true = [c for c in self._readers(repair) if self._holds(c)]
        if sum(not keeps(claim, place, edit) for claim in true) > repair.tolerates:
            return True
        mended = ((self._on(claim), claim) for claim in repair.mends)
        return any(stops(claim, repair.of(claim, on.texts), on) for on, claim in mended)
