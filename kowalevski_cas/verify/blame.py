"""Blame: which printed formula is wrong when claims fail, and what it should say.

What claims that fail together share is suspected: the law, a definition, an assumption that misses
a relation of constants. An edit of it is a repair if it mends claims and breaks none. For several
claims that edit is likeliest which mends most of them; of those that mend as many, one of a
claim's own formula comes before a relation of constants, this before an edit of a definition, and
that before one of the law. A claim that fails alone has its own formula corrected, if that can be.

A run asks when all its claims are decided; who has a :class:`~.corrector.Corrector` asks for::

    found = Blame(corrector, {claim: outcome.verdict, …}).corrections()

the :class:`~.outcome.Correction` of each refuted claim that has one, and up to two alternatives, by
the ids of the claims. Of a repair of another formula ``blamed`` is what is printed there, and
``printed`` is its place. Every one is proved; nothing is green by it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from functools import cached_property
from math import inf
from time import perf_counter
from typing import NamedTuple

from kowalevski_cas.notation import Derivative, Edit, Name, NotationError, edits
from kowalevski_cas.notation.edits import changes_subject
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.corrections import passes, statement_of, unlikeliness
from kowalevski_cas.verify.corrector import Corrector
from kowalevski_cas.verify.outcome import Correction, Verdict
from kowalevski_cas.verify.relations import ConstantRelation, relations, supposes
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.vacuous import says_something, stands_still

MOST = 3
"""How many repairs are proposed."""


KINDS = (
    "sign",
    "index",
    "letter",
    "exponent",
    "coefficient",
    "factor",
    "power",
    "missing",
    "exchange",
)
"""The kinds of edits, the likelier ones first."""


class Suspect(IntEnum):
    """What may be wrong, in the order of suspicion."""

    OWN = 0
    ASSUMPTION = 1
    DEFINITION = 2
    LAW = 3
    RELATION = 4
    """A relation of constants, where the scene supposes none so far."""


class Repair(NamedTuple):
    """An edit of a printed formula, or a relation of constants, and the claims that it mends."""

    suspect: Suspect
    change: Edit | ConstantRelation
    place: Printed
    mends: tuple[Claim, ...]

    @property
    def tolerates(self) -> int:
        """How many true claims it may make false: of a law, fewer than half of what it mends.

        What was claimed of a misprinted law may be true of that by chance.
        """
        return (len(self.mends) - 1) // 2 if self.suspect is Suspect.LAW else 0

    def of(self, claim: Claim, texts: Texts) -> Neighbour:
        """What a claim says with the repair."""
        if isinstance(self.change, ConstantRelation):
            return self.change.neighbour(claim, texts)
        return claim.edited(texts, self.place, self.change)


Repairs = dict[str, tuple[Correction, ...]]
"""Corrections of claims, the likeliest first."""


@dataclass
class Blame:
    """The search for what makes claims fail, in a run that has come to its end."""

    corrector: Corrector
    verdicts: Mapping[str, Verdict]
    corrected: Collection[str] = ()
    """The claims that have a correction already."""
    seconds: float = inf
    """For the search of what claims stand on, which then has what was found so far."""
    _true: dict[str, bool] = field(default_factory=dict)

    @property
    def _derivation(self) -> Derivation:
        return self.corrector.interpretation.derivation

    def _on(self, claim: Claim) -> Elaborations:
        return self.corrector.interpretation.on(claim)

    def corrections(self) -> Repairs:
        """The corrections of all claims that fail: what they share first, then one by one."""
        found = self.shared()
        for claim in self.open():
            if claim.id not in found:
                found[claim.id] = self.alone(claim)
        return found

    def open(self) -> list[Claim]:
        """The refuted claims that were asked for, and have no correction."""
        refuted = {id for id, verdict in self.verdicts.items() if verdict is Verdict.REFUTED}
        return [c for c in self._derivation.claims if c.id in refuted.difference(self.corrected)]

    def shared(self) -> Repairs:
        """The corrections of claims that one change mends together."""
        found: Repairs = {}
        failing = [claim for claim in self.open() if not self._is_expected(claim)]
        while len(failing) > 1:
            best = self._proofs(self._search(failing, least=2), least=2)
            if not best:
                break
            found |= best
            failing = [claim for claim in failing if claim.id not in best]
        return found

    def alone(self, claim: Claim) -> tuple[Correction, ...]:
        """The corrections of one claim: of its own formula, or else of what it stands on."""
        own = tuple(self.corrector.near(self.corrector.interpretation.statement(claim), MOST))
        if own or self._is_expected(claim):
            return own
        others = [one for one in self._failing if one is not claim]
        repairs = self._search([claim, *others], least=1, one=claim)
        return self._proofs(repairs, least=1).get(claim.id, ())

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

    # -- what is suspected ------------------------------------------------------------

    def _suspects(self, failing: Sequence[Claim], least: int) -> dict[Printed, Suspect]:
        """The places on which so many of the failing claims stand, as what they are suspected."""
        standing: dict[Printed, list[Claim]] = {}
        found: dict[Printed, Suspect] = {}
        for claim in failing:
            roles = {place: role for scene in claim.scenes() for role, place in scene.roles()}
            own = {*claim.establishes()}
            for place in self._statement(claim).stands_on:
                standing.setdefault(place, []).append(claim)
                law = roles.get(place) == "vector field"
                if place in own:
                    found[place] = Suspect.OWN
                elif place in roles:
                    found.setdefault(place, Suspect.LAW if law else Suspect.DEFINITION)
        known = self._derivation.claims
        right = {place for c in known if self._holds(c) for place in c.establishes()}
        return {
            place: suspect
            for place, suspect in found.items()
            if len(standing[place]) >= least
            and place not in right
            and place not in self.corrector.interpretation.accepted
        }

    def _statement(self, claim: Claim) -> Statement:
        return self.corrector.interpretation.statement(claim)

    def _changes(
        self, failing: Sequence[Claim], least: int
    ) -> Iterator[tuple[Suspect, Edit | ConstantRelation, Printed, list[Claim]]]:
        """What may mend so many claims, and the claims that it changes; the likeliest first."""
        for claim in failing:
            for relation in relations(self._statement(claim)):
                supposed = supposes(claim.scene, self._derivation)
                if not supposed and len(relation.formula.names()) == 1:
                    continue  # a number for a constant, of which the paper does not think
                suspect = Suspect.ASSUMPTION if supposed else Suspect.RELATION
                standing = [one for one in failing if relation.concerns(one.scene)]
                yield suspect, relation, relation.place, standing
        suspects = self._suspects(failing, least)
        texts = self._on(failing[0]).texts
        names = self._names(failing, suspects, texts)
        found = [
            (suspect, edit, place, [claim for claim in failing if place in claim.reads()])
            for place, suspect in suspects.items()
            if suspect is not Suspect.OWN or least > 1  # else they were tried
            for edit in edits(texts.statement(place), texts.vocabulary, names)
            if not changes_subject(edit)
        ]
        yield from sorted(found, key=lambda one: (_slip(one[1]), one[0]))

    @staticmethod
    def _names(
        failing: Sequence[Claim], suspects: Iterable[Printed], texts: Texts
    ) -> frozenset[str]:
        """The names that an edit may bring in: of the suspects, and what moves or is given."""
        scenes = [claim.scene for claim in failing]
        found = {name for scene in scenes for name in (*scene.variables, *scene.constants)}
        for place in suspects:
            found |= texts.statement(place).formula.names()
        undefined = {name for scene in scenes for name in scene.undefined}
        return frozenset(found & {n for scene in scenes for n in scene.names()}) - undefined

    # -- what mends -----------------------------------------------------------------

    def _search(
        self, failing: Sequence[Claim], least: int, one: Claim | None = None
    ) -> list[Repair]:
        """The repairs that at points mend so many claims, perhaps this one, and break none."""
        found: list[Repair] = []
        most, end = least, perf_counter() + self.seconds
        for suspect, change, place, standing in self._changes(failing, least):
            if perf_counter() > end:
                break
            repair = Repair(suspect, change, place, ())
            if one is not None and one not in standing:
                continue
            allowed = len(standing) - most
            mends = []
            for claim in standing:
                if self._passes(repair, claim) is not False:
                    mends.append(claim)
                elif claim is one or (allowed := allowed - 1) < 0:
                    allowed = -1
                    break
            repair = repair._replace(mends=tuple(mends))
            if (
                allowed >= 0
                and len(mends) >= most
                and len(self._broken(repair)) <= repair.tolerates
            ):
                most = len(mends)
                found.append(repair)
        return sorted(found, key=_likelihood)

    def _passes(self, repair: Repair, claim: Claim) -> bool | None:
        on = self._on(claim)
        return passes(repair.of(claim, on.texts), on.apart(on.texts), {})

    def _broken(self, repair: Repair) -> list[Claim]:
        """The true claims that a repair makes false, as points tell."""
        if isinstance(repair.change, ConstantRelation):
            return []
        about = (c for c in self._derivation.claims if repair.place in c.reads())
        return [c for c in about if self._holds(c) and self._passes(repair, c) is False]

    # -- what is proved ---------------------------------------------------------------

    def _proofs(self, repairs: Iterable[Repair], least: int) -> Repairs:
        """The corrections by the likeliest repairs that are proved and mend the same claims."""
        found: Repairs = {}
        for repair in repairs:
            proved = {claim.id: self._proof(repair, claim) for claim in repair.mends}
            mended = {id: (one,) for id, one in proved.items() if one is not None}
            if len(mended) < least or (found and mended.keys() != found.keys()):
                continue
            told = {one.formulas for ones in found.values() for one in ones}
            if any(one.formulas in told for (one,) in mended.values()) or self._spoils(repair):
                continue
            found = {id: (*found.get(id, ()), *one) for id, one in mended.items()}
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
            proved = self.corrector.correction_of(neighbour, statement)
            return proved and proved._replace(others=self._others(repair))
        except (NotationError, Meaningless, ZeroDivisionError):
            return None

    def _others(self, repair: Repair) -> tuple[str, ...]:
        """The true claims that stand on what a repair changes."""
        if not isinstance(repair.change, Edit):
            return ()
        broken = self._broken(repair) if repair.tolerates else []
        true = (c for c in self._derivation.claims if self._holds(c) and c not in broken)
        return tuple(c.id for c in true if repair.place in self._statement(c).stands_on)

    def _spoils(self, repair: Repair) -> bool:
        """Whether a repair makes false what is true, or leaves nothing of what it changes."""
        place, edit = repair.place, repair.change
        if not isinstance(edit, Edit):
            return False
        keeps = self.corrector.keeps
        true = [c for c in self._derivation.claims if place in c.reads() and self._holds(c)]
        if sum(not keeps(claim, place, edit) for claim in true) > repair.tolerates:
            return True
        return any(self._stops(claim, repair) for claim in repair.mends)

    def _stops(self, claim: Claim, repair: Repair) -> bool:
        """Whether what moves stands still with a repair, or what is said to be constant."""
        on = self._on(claim)
        edited = repair.of(claim, on.texts)
        now = on.under(edited.texts)
        about = {
            node.name
            for formula in claim.formulas(now.texts)
            for rate in formula.nodes()
            if isinstance(rate, Derivative)
            for node in rate.nodes()
            if isinstance(node, Name) and node.name in claim.scene.definitions
        }
        return stands_still(on(claim.scene), now(edited.claim.scene), about)


def _likelihood(repair: Repair) -> tuple[object, ...]:
    """What sorts repairs: those that mend most first, then by what is suspected."""
    slip = _slip(repair.change) if isinstance(repair.change, Edit) else ()
    return (-len(repair.mends), repair.suspect, *slip)


def _slip(edit: Edit) -> tuple[object, ...]:
    """What sorts edits, the likelier slips of the pen first."""
    return (*unlikeliness(edit), KINDS.index(edit.kind))
