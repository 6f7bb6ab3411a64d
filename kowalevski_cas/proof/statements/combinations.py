"""Claims that equations follow from others, by the factors that searches found."""

from __future__ import annotations

from functools import partial
from itertools import combinations_with_replacement, product
from typing import TypeVar

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims import (
    DoubleZero,
    Equivalence,
    FirstIntegral,
    Implication,
    InvariantRelations,
    Limit,
)
from kowalevski_cas.claims.formulas import equation
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Relation
from kowalevski_cas.proof.parts import Parts, minus
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.statements.kinds import (
    Matrix,
    deny,
    found_row,
    matrix_of,
    printed_of,
    sides_of,
    state,
)
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.stage import Stage
from kowalevski_cas.paper.texts import Printed

Found = TypeVar("Found")


@state.register
def _first_integral(claim: FirstIntegral, parts: Parts) -> None:
    space = parts.space(claim.scene)
    constants = claim.constants(space.stage, space.stage.texts.formula(printed_of(claim)))
    rates: list[list[Tree]] = [[["D", space.tree(constant)], 0] for constant in constants]
    if not claim.on:
        parts.equal(space, *rates)
        return
    moving = (k for k, sides in enumerate(rates) if not space.difference(sides)[0].is_zero)
    sides = rates[next(moving, 0)]
    bench = parts.bench.finder
    row = combination(bench, claim.scene, claim.id, claim.rate, claim.generators, claim.main)
    parts.follows(space, [sides], sides_of(space, claim.on), [found_row(row)])
    parts.differ(space, sides)


@state.register
def _invariant_relations(claim: InvariantRelations, parts: Parts) -> None:
    space = parts.space(claim.scene)
    given = sides_of(space, claim.relations)
    targets = [[["D", minus(sides)], 0] for sides in given]
    parts.follows(space, targets, given, matrix_of(claim, parts))


@state.register
def _equivalence(claim: Equivalence, parts: Parts) -> None:
    space = parts.space(claim.scene)
    factor = _factor(claim, parts)
    own, other = sides_of(space, (printed_of(claim), claim.to))
    tree = space.element(factor)
    inverse = space.element(factor.inverse())
    parts.equal(space, [minus(own), ["*", tree, minus(other)]], [["*", tree, inverse], 1])


def _factor(claim: Equivalence, parts: Parts) -> Element:
    """The left side of the printed equation over that of the other one."""
    own = printed_of(claim)
    for top, bottom in ((own, claim.to), (claim.to, own)):
        row = combination(
            parts.bench.finder,
            claim.scene,
            (claim.id, top.place),
            partial(_side, top),
            partial(_sides, bottom),
        )
        if row and not row[0].is_zero:
            return row[0] if top is own else row[0].inverse()
    raise CertificateError("no factor was found")


@state.register
def _implication(claim: Implication, parts: Parts) -> None:
    space, bench = parts.space(claim.scene), parts.bench.finder
    formula = space.stage.texts.formula(printed_of(claim))
    is_equation = isinstance(formula, Relation)
    own = space.sides(printed_of(claim)) if is_equation else [space.tree(formula), 0]
    equations = [*sides_of(space, claim.together), own]
    targets = [element for sides in equations for element in space.difference(sides)]
    if claim.root is not None:
        bit = space.stage.ring.roots.index(claim.root)
        pairs = combinations_with_replacement(targets, 2)
        targets = [a * b.conjugate_root(bit) for a, b in pairs]
    rows = [
        combination(
            bench,
            claim.scene,
            ("certificate", claim.id, k),
            partial(_itself, target),
            claim.generators,
            claim.main,
        )
        for k, target in enumerate(targets)
    ]
    given = sides_of(space, claim.given)
    parts.follows(space, equations, given, [found_row(row) for row in rows], claim.root)


@state.register
def _double_zero(claim: DoubleZero, parts: Parts) -> None:
    space = parts.space(claim.scene)
    given = [minus(sides) for sides in sides_of(space, claim.given)]
    pairs = combinations_with_replacement(given, 2)
    terms = [
        ["*", space.element(factor), first, second]
        for factor, (first, second) in zip(
            found_row(claim.form(parts.bench.finder)), pairs, strict=True
        )
        if not factor.is_zero
    ]
    right = ["+", *terms] if len(terms) > 1 else terms[0]
    parts.equal(space, [space.tree(space.stage.texts.formula(printed_of(claim))), right])
    parts.notes.append("where two functions vanish, so do their product and its gradient")


@deny.register
def _no_double_zero(claim: DoubleZero, parts: Parts) -> None:
    space = parts.space(claim.scene)
    tree = space.tree(space.stage.texts.formula(printed_of(claim)))
    sides = [[tree, 0], *([["d", name, tree], 0] for name in claim.scene.variables)]
    given = sides_of(space, claim.given)
    for k, target in enumerate(sides):
        against = partial(claim.against_zero, k)
        if counterexample(
            parts.bench.finder, claim.scene, (claim.id, k), against, claim.generators
        ):
            parts.differ(space, target, given)
            return
    raise CertificateError("no exact point was found")


@state.register
def _limit(claim: Limit, parts: Parts) -> None:
    state(claim.general, parts)
    state(claim.special, parts)
    space = parts.space(claim.scene)
    bench = parts.bench.finder
    special = sides_of(space, claim.special.relations)
    general = sides_of(space, claim.general.relations)
    rows = [
        combination(
            bench,
            claim.scene,
            (claim.id, "transition", k),
            partial(_side, claim.general.relations[k]),
            claim.special.functions,
        )
        for k in range(len(general))
    ]
    transition = [found_row(row) for row in rows]
    parts.follows(space, general, special, transition)
    stage = space.stage
    matrix = [[stage.carry(e) for e in row] for row in matrix_of(claim.general, parts)]
    direct = [[stage.carry(e) for e in row] for row in matrix_of(claim.special, parts)]
    targets = [[["D", minus(sides)], 0] for sides in special]
    parts.follows(space, targets, special, direct)
    scale = stage.time_factor("prime", False).inverse()
    rates = [[["D", minus(sides)], 0] for sides in general]
    carried = [[entry * scale for entry in row] for row in matrix]
    parts.follows(space, rates, general, carried)
    _compare(claim, parts, space, (transition, direct, carried))


def _compare(
    claim: Limit, parts: Parts, space: SpaceWriter, found: tuple[Matrix, Matrix, Matrix]
) -> None:
    """Both matrices say the same where the special relations hold: T' + T N - M T vanishes."""
    for letter, matrix in zip("TNM", found, strict=True):
        for i, row in enumerate(matrix):
            for j, entry in enumerate(row):
                space.let(_entry(letter, i, j), space.element(entry))
    first, second, third = found
    given = sides_of(space, claim.special.relations)
    places = range(len(given))
    equations, rows = [], []
    for i, j in product(range(len(first)), places):
        rest = space.stage.derivative(first[i][j])
        tree: list[Tree] = ["+", ["D", _entry("T", i, j)]]
        for k in places:
            rest = rest + first[i][k] * second[k][j] - third[i][k] * first[k][j]
            tree.append(["*", _entry("T", i, k), _entry("N", k, j)])
            tree.append(["-", ["*", _entry("M", i, k), _entry("T", k, j)]])
        cofactors = combination(
            parts.bench.finder,
            claim.scene,
            ("certificate", claim.id, i, j),
            partial(_itself, rest),
            claim.special.functions,
        )
        equations.append([tree, 0])
        rows.append(found_row(cofactors))
    parts.follows(space, equations, given, rows)


def _entry(letter: str, i: int, j: int) -> str:
    return f"{letter}_{{{i + 1}{j + 1}}}"


def _itself(value: Found, stage: Stage) -> Found:
    return value


def _sides(printed: Printed, stage: Stage) -> list[Element]:
    return [equation(printed, stage)]


def _side(printed: Printed, stage: Stage) -> Element:
    return equation(printed, stage)
