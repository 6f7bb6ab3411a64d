"""What may be wrong where claims fail: formulas on which they stand, and what may mend them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from enum import IntEnum
from itertools import islice
from typing import NamedTuple

from kowalevski_cas.notation import (
    Derivative,
    Edit,
    Formula,
    Name,
    Negative,
    NotationError,
    Number,
    Power,
    Quotient,
    Relation,
    edits,
)
from kowalevski_cas.notation.common_edits import common_edits, printed_together
from kowalevski_cas.notation.edits import changes_subject
from kowalevski_cas.paper.claims import Claim, FirstIntegral, Neighbour
from kowalevski_cas.paper.texts import Printed, Texts, edited_formulas
from kowalevski_cas.verify.corrections import unlikeliness
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.missing_numbers import missing_numbers
from kowalevski_cas.verify.outcome import Correction
from kowalevski_cas.verify.own_letters import defined_beside, own_letters
from kowalevski_cas.verify.relations import ConstantRelation, relations, supposes

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


LAW = "vector field"
"""The role of equations of motion on a scene."""

IMAGINARY = Relation((Power(Name("i"), Number(2)), Negative(Number(1))), ("=",))
"""What the imaginary unit obeys: nobody suspects it."""


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
    beside: int = 0
    """How many more it mends of which nobody is sure that they are meant as they are read."""

    @property
    def tolerates(self) -> int:
        """How many true claims it may make false: none, if it is none of a law."""
        return most_broken(len(self.mends) + self.beside) if self.suspect is Suspect.LAW else 0

    @property
    def places(self) -> tuple[Printed, ...]:
        """What it changes: the place, and what is printed together with it."""
        if isinstance(self.change, ConstantRelation):
            return (self.place,)
        return (*edited_formulas(self.place, self.change),)

    def of(self, claim: Claim, texts: Texts) -> Neighbour:
        """What a claim says with the repair."""
        if isinstance(self.change, ConstantRelation):
            return self.change.neighbour(claim, texts)
        return claim.edited(texts, self.place, self.change)


def adds_something(change: Edit | ConstantRelation) -> bool:
    """Whether a change puts a name, or a derivative, where none stood.

    With one of these some law or other makes nearly any claim true: of one that fails alone it
    tells nothing.
    """
    if isinstance(change, ConstantRelation):
        return False
    before, after = (
        [isinstance(node, Name | Derivative) for node in formula.nodes()].count(True)
        for formula in (change.statement.formula, change.formula)
    )
    return after > before


Suspicion = tuple[Suspect, Edit | ConstantRelation, Printed, list[Claim]]
"""What is suspected, what may mend it, where, and the claims that stand on it."""

Repairs = dict[str, tuple[Correction, ...]]
"""Corrections of claims, the likeliest first."""


def changes(
    failing: Sequence[Claim],
    least: int,
    interpretation: Interpretation,
    right: Callable[[], Collection[Printed]],
) -> Iterator[Suspicion]:
    """What may mend so many claims, and the claims that it changes; the likeliest first.

    ``right`` are the places that nobody suspects; it is asked if relations of constants do not do.
    What is to mend one claim is to mend the first.
    """
    for claim in failing if least > 1 else failing[:1]:
        for relation in relations(interpretation.statement(claim)):
            texts = interpretation.on(claim).texts
            supposed = supposes(claim.scene, interpretation.derivation, texts)
            if not supposed and len(relation.formula.names()) == 1:
                continue  # a number for a constant, of which the paper does not think
            suspect = Suspect.ASSUMPTION if supposed else Suspect.RELATION
            standing = [claim for claim in failing if relation.concerns(claim.scene)]
            yield suspect, relation, relation.place, standing
    suspects = _suspects(failing, least, interpretation, right())
    texts = interpretation.on(failing[0]).texts
    names = _names(failing, suspects, texts)
    several = [
        (suspect, edit, place, [claim for claim in failing if place in claim.reads()])
        for place, suspect in suspects.items()
        if suspect is not Suspect.OWN or least > 1  # else they were tried
        for edit in edits(texts.statement(place), texts.vocabulary, names)
        if not changes_subject(edit)
    ]
    several += _common_changes(_suspected(failing, interpretation, right()), least, texts)
    statements = {claim: interpretation.statement(claim) for claim in failing}
    own = {claim: own_letters(statement) for claim, statement in statements.items()}
    beside = {claim: defined_beside(statements[claim], own[claim]) for claim in failing}
    for suspect, edit, place, standing in sorted(several, key=lambda one: (slip(one[1]), one[0])):
        there = edit.formula.names()
        mended = [
            claim
            for claim in standing
            if place in {*claim.establishes()} | beside[claim] or own[claim] <= there
        ]
        if len(mended) >= least:
            yield suspect, edit, place, mended


def _common_changes(
    suspected: Mapping[Printed, tuple[Suspect, list[Claim]]], least: int, texts: Texts
) -> Iterator[tuple[Suspect, Edit, Printed, list[Claim]]]:
    """The edits of what is printed once and read several times, and the claims that they change."""
    tried = set[Printed]()
    for place, (suspect, _) in suspected.items():
        if place in tried or suspect is Suspect.OWN:
            continue
        together = printed_together(texts.source(place.display), place.number)
        places = [place.display[number] for number in together]
        tried.update(places)
        if not suspected.keys() >= {*places}:
            continue
        standing = [*dict.fromkeys(claim for one in places for claim in suspected[one][1])]
        if len(standing) >= least:
            try:
                printed = texts.statements(place.display)
            except NotationError:  # something beside it cannot be read
                continue
            for edit in common_edits(printed, place.number, texts.vocabulary):
                if not changes_subject(edit):
                    yield suspect, edit, place, standing


def numbers(
    failing: Sequence[Claim],
    least: int,
    interpretation: Interpretation,
    right: Callable[[], Collection[Printed]],
    goes_on: Callable[[], bool],
) -> Iterator[Suspicion]:
    """Coefficients, however far from what is printed, by which the first of the claims holds.

    Whole ones come first. They are sought as long as ``goes_on`` says so.
    """
    suspects = _suspects(failing, least, interpretation, right())
    first, *_ = failing
    statement = interpretation.statement(first)
    own = own_letters(statement)
    own_places = {*first.establishes()} | defined_beside(statement, own)
    several = [
        (suspect, edit, place, [claim for claim in failing if place in claim.reads()])
        for place, suspect in suspects.items()
        if place in first.reads() and (not own or place in own_places)
        for edit in missing_numbers(first, place, interpretation.on(first), goes_on)
        if not changes_subject(edit)
    ]
    yield from sorted(several, key=lambda found: (found[0], _is_broken(found[1])))


def _is_broken(edit: Edit) -> bool:
    """Whether an edit prints a fraction more."""
    before, after = edit.statement.formula.nodes(), edit.formula.nodes()
    fractions = (sum(isinstance(node, Quotient) for node in nodes) for nodes in (after, before))
    return next(fractions) > next(fractions)


def _suspects(
    failing: Sequence[Claim], least: int, interpretation: Interpretation, right: Collection[Printed]
) -> dict[Printed, Suspect]:
    """The places on which so many of the failing claims stand, as what they are suspected.

    None of them is ``right``.
    """
    every = _suspected(failing, interpretation, right)
    return {place: one for place, (one, standing) in every.items() if len(standing) >= least}


def _suspected(
    failing: Sequence[Claim], interpretation: Interpretation, right: Collection[Printed]
) -> dict[Printed, tuple[Suspect, list[Claim]]]:
    """The places on which failing claims stand, with these; none of the places is ``right``."""
    standing: dict[Printed, list[Claim]] = {}
    found: dict[Printed, Suspect] = {}
    for claim in failing:
        roles = {place: role for scene in claim.scenes() for role, place in scene.roles()}
        established = {*claim.establishes()}
        texts = interpretation.on(claim).texts
        for place in interpretation.statement(claim).stands_on:
            if roles.get(place) == "unit" and texts.formula(place) == IMAGINARY:
                continue
            standing.setdefault(place, []).append(claim)
            law = roles.get(place) == LAW
            if place in established:
                found[place] = Suspect.OWN
            elif place in roles:
                found.setdefault(place, Suspect.LAW if law else Suspect.DEFINITION)
    return {place: (one, standing[place]) for place, one in found.items() if place not in right}


def determined_rates(
    failing: Sequence[Claim], interpretation: Interpretation, holds: Callable[[Claim], bool]
) -> set[Printed]:
    """The rates of variables on which more true integrals depend than a repair may make false.

    The derivative of an integral is linear in the rates: with any other one it does not vanish, if
    nothing more is supposed there, as that a constant is zero.
    """
    found, texts = set[Printed](), interpretation.texts
    for row in {place for claim in failing for role, place in claim.scene.roles() if role == LAW}:
        match texts.formula(row):
            case Relation((Derivative(Name(variable)), *_)):
                standing = [claim for claim in failing if row in claim.scene.places]
                readers = (c for c in interpretation.readers(row) if holds(c))
                integrals = (c for c in readers if any(_is_as_general(c, one) for one in standing))
                depending = (c for c in integrals if _depends(c.formulas(texts), variable))
                if any(islice(depending, most_broken(len(standing)), None)):
                    found.add(row)
    return found


def _is_as_general(claim: Claim, other: Claim) -> bool:
    """Whether a claim is an integral wherever another one is stated."""
    own = claim.scene.places.keys() - {*claim.establishes()}
    return isinstance(claim, FirstIntegral) and not claim.given and own <= other.scene.places.keys()


def most_broken(mended: int) -> int:
    """How many true claims a repair of a law may make false: fewer than half of what it mends.

    What was claimed of a misprinted law may be true of that by chance.
    """
    return (mended - 1) // 2


def _depends(formulas: Iterable[Formula], variable: str) -> bool:
    """Whether formulas depend on a variable, and on its rate only by the law."""
    nodes = {node for formula in formulas for node in formula.nodes()}
    return Name(variable) in nodes and not any(isinstance(node, Derivative) for node in nodes)


def _names(failing: Sequence[Claim], suspects: Iterable[Printed], texts: Texts) -> frozenset[str]:
    """The names that an edit may bring in: of the suspects, and what moves or is given."""
    scenes = [claim.scene for claim in failing]
    found = {name for scene in scenes for name in (*scene.variables, *scene.constants)}
    for place in suspects:
        found |= texts.statement(place).formula.names()
    undefined = {name for scene in scenes for name in scene.undefined}
    return frozenset(found & {n for scene in scenes for n in scene.names()}) - undefined


def likelihood(repair: Repair) -> tuple[object, ...]:
    """What sorts repairs: those that mend most first, then by what is suspected."""
    order = slip(repair.change) if isinstance(repair.change, Edit) else ()
    return (-len(repair.mends), repair.suspect, *order)


def slip(edit: Edit) -> tuple[object, ...]:
    """What sorts edits, the likelier slips of the pen first."""
    return (*unlikeliness(edit), KINDS.index(edit.kind))
