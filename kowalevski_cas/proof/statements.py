"""What each kind of claim states, in the parts of a certificate: one function a kind.

Where a claim rests on an argument in words as well, the words are noted.
"""

from __future__ import annotations

from functools import partial, singledispatch
from itertools import combinations_with_replacement, pairwise, product
from typing import TypeVar

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims import (
    ChangedEquation,
    Claim,
    Coefficient,
    ConstantRoot,
    CriticalSet,
    Degree,
    Dimension,
    DoubleZero,
    Equilibria,
    Equivalence,
    FirstIntegral,
    Identity,
    Implication,
    Independence,
    InvariantRelations,
    InvertibleChange,
    LastMultiplier,
    Limit,
    Reality,
    Scaling,
    SolvedExponents,
    Unit,
)
from kowalevski_cas.claims.dimension import Set
from kowalevski_cas.claims.formulas import equation, members
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.claims.points import counterexample
from kowalevski_cas.notation import Constant, Formula, Relation, Sum, Unwritten
from kowalevski_cas.proof.critical_sets import deny_critical_set, state_critical_set
from kowalevski_cas.proof.parts import Parts, minus
from kowalevski_cas.proof.rest_states import state_equilibria
from kowalevski_cas.proof.scales import scale
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.stage import Stage
from kowalevski_cas.texts import Printed

Matrix = list[list[Element]]
Found = TypeVar("Found")


@singledispatch
def state(claim: Claim, parts: Parts) -> None:
    """Write what the claim states, for one that holds."""
    raise CertificateError(f"the kind {type(claim).__name__} has no certificates")


@singledispatch
def deny(claim: Claim, parts: Parts) -> None:
    """Write a point at which the claim, as printed, fails."""
    raise CertificateError(f"the kind {type(claim).__name__} has no refutations")


# -- equalities ----------------------------------------------------------------


@state.register
def _identity(claim: Identity, parts: Parts) -> None:
    space = parts.space(claim.scene)
    parts.equal(space, *_chain(claim, space))


@state.register
def _changed_equation(claim: ChangedEquation, parts: Parts) -> None:
    for scene in (claim.scene, claim.old):
        space = parts.space(scene)
        parts.equal(space, *_chain(claim, space))


@deny.register
def _no_identity(claim: Identity, parts: Parts) -> None:
    space = parts.space(claim.scene)
    for sides in _chain(claim, space):
        if any(not element.is_zero for element in space.difference(sides)):
            parts.differ(space, sides)
            return
    raise CertificateError("all members are equal")


def _chain(claim: Identity, space: SpaceWriter) -> list[list[Tree]]:
    """The equations of a chain; ``const`` says that the first member does not move."""
    relation = space.stage.relation(claim.stated)
    trees = [space.tree(member) for member in members(relation)]
    equations = [list(pair) for pair in pairwise(trees)]
    if isinstance(relation.members[-1], Constant):
        equations.append([["D", trees[0]], 0])
    return equations


@state.register
def _coefficient(claim: Coefficient, parts: Parts) -> None:
    space = parts.space(claim.scene)
    formula = space.stage.texts.formula(_printed(claim))
    chain = members(formula) if isinstance(formula, Relation) else [formula]
    name = claim.variable
    if claim.derivative_of is None:
        left, right = (["d", name, space.tree(_written(member))] for member in chain)
        parts.equal(space, [left, right])
        return
    expression = space.tree(space.stage.texts.formula(claim.derivative_of))
    generated = ["d", name, ["D", expression]]
    equations = [[generated, space.tree(member)] for member in chain]
    parts.equal(space, *equations, [["d", name, generated], 0])


@state.register
def _degree(claim: Degree, parts: Parts) -> None:
    space = parts.space(claim.scene)
    equations = []
    for name in claim.scene.variables:
        if name != claim.variable:
            tree: Tree = ["D", name]
            for _ in range(claim.degree + 1):
                tree = ["d", claim.variable, tree]
            equations.append([tree, 0])
    parts.equal(space, *equations)
    parts.notes.append("the derivative of any expression is a combination of these components")


@state.register
def _reality(claim: Reality, parts: Parts) -> None:
    space = parts.space(claim.scene)
    real = [space.tex(tex) for tex in claim.real]
    imaginary = [space.tex(tex) for tex in claim.imaginary]
    parts.equal(
        space,
        *([tree, ["conj", tree]] for tree in real),
        *([tree, ["-", ["conj", tree]]] for tree in imaginary),
    )


@state.register
def _invertible_change(claim: InvertibleChange, parts: Parts) -> None:
    old, new = parts.space(claim.old), parts.space(claim.scene)
    inverse = old.inverse(new.stage)
    parts.equal(old, *([name, inverse[name]] for name in claim.old.variables))
    parts.equal(old, *([second, ["conj", first]] for first, second in claim.pairs))


@state.register
def _last_multiplier(claim: LastMultiplier, parts: Parts) -> None:
    space = parts.space(claim.scene)
    density = space.tex(claim.density)
    rates = [["d", name, ["D", name]] for name in claim.scene.variables]
    parts.equal(space, [["+", ["D", density], ["*", density, ["+", *rates]]], 0])
    state(claim.relations, parts)
    matrix = _matrix(claim.relations, parts)
    on = parts.space(claim.relations.scene)
    diagonal = [on.element(row[k]) for k, row in enumerate(matrix)]
    parts.equal(on, [["+", *diagonal], 0])
    parts.notes.append("a trace of zero means that the measure on the set is preserved")


@state.register
def _constant_root(claim: ConstantRoot, parts: Parts) -> None:
    space = parts.space(claim.scene)
    guess = parts.bench.found(("constant", claim.id), lambda bench: None)
    if guess is None:
        raise CertificateError("no constant root was found")
    terms = [
        ["*", space.element(space.stage.ring.number(factor)), space.tex(tex)]
        for factor, tex in zip(guess, claim.basis, strict=True)
        if factor
    ]
    space.let(claim.unknown, ["+", *terms] if len(terms) > 1 else terms[0])
    parts.equal(space, space.sides(_printed(claim)))
    parts.notes.append("the root is a combination of constants of the motion")


@state.register
def _solved_exponents(claim: SolvedExponents, parts: Parts) -> None:
    space = parts.space(claim.scene)
    stage = space.stage
    (_, p), (_, q) = stage.powers.items()
    coefficient = ["d", claim.variable, ["D", space.tree(stage.texts.formula(claim.ansatz))]]
    (value,) = space.value(coefficient)
    c1, c2 = (space.element(element) for element in gradient(value, (p, q)))
    first, second = ["*", c1, p], ["*", c2, q]
    parts.equal(space, [coefficient, ["+", first, second]])
    both = [element for tree in (first, second) for element in space.value(tree)]
    rates = [stage.derivative(element) for element in both]
    wronskian = both[0] * rates[1] - both[1] * rates[0]
    parts.equal(
        space,
        [["+", ["*", first, ["D", coefficient]], ["-", ["*", ["D", first], coefficient]]],
         space.element(wronskian)],
    )  # fmt: skip
    parts.notes.append(
        "where the coefficient vanishes along a motion the last expression does, "
        "and gives one equation for the exponents; with it the first gives the other"
    )


@deny.register
def _no_unit(claim: Unit, parts: Parts) -> None:
    """A row that holds with the corrected unit, at a point where it fails with the printed one."""
    for row in _rows(claim, parts):
        space = parts.space(claim.scene)
        sides = space.sides(row)
        if any(not element.is_zero for element in space.difference(sides)):
            parts.differ(space, sides)
            return
    raise CertificateError("no row tells the units apart")


@state.register
def _unit(claim: Unit, parts: Parts) -> None:
    space = parts.space(claim.scene)
    parts.equal(space, *(space.sides(row) for row in _rows(claim, parts)))
    parts.notes.append("no other unit makes more rows hold: this is not part of the certificate")


def _rows(claim: Unit, parts: Parts) -> list[Printed]:
    """The rows that hold with the corrected unit."""
    stage = parts.mended.stage(claim.scene)
    return [row for row in claim.rows if equation(row, stage).is_zero]


@state.register
def _scaling(claim: Scaling, parts: Parts) -> None:
    scale(claim, parts)


@state.register
def _critical_set(claim: CriticalSet, parts: Parts) -> None:
    state_critical_set(claim, parts)


@state.register
def _equilibria(claim: Equilibria, parts: Parts) -> None:
    state_equilibria(claim, parts)


@deny.register
def _no_critical_set(claim: CriticalSet, parts: Parts) -> None:
    deny_critical_set(claim, parts)


# -- combinations ----------------------------------------------------------------


@state.register
def _first_integral(claim: FirstIntegral, parts: Parts) -> None:
    space = parts.space(claim.scene)
    constants = claim.constants(space.stage, space.stage.texts.formula(_printed(claim)))
    rates: list[list[Tree]] = [[["D", space.tree(constant)], 0] for constant in constants]
    if not claim.on:
        parts.equal(space, *rates)
        return
    moving = (k for k, sides in enumerate(rates) if not space.difference(sides)[0].is_zero)
    sides = rates[next(moving, 0)]
    bench = parts.bench.finder
    row = combination(bench, claim.scene, claim.id, claim.rate, claim.generators, claim.main)
    parts.follows(space, [sides], _equations(space, claim.on), [_found(row)])
    parts.differ(space, sides)


@state.register
def _invariant_relations(claim: InvariantRelations, parts: Parts) -> None:
    space = parts.space(claim.scene)
    given = _equations(space, claim.relations)
    targets = [[["D", minus(sides)], 0] for sides in given]
    parts.follows(space, targets, given, _matrix(claim, parts))


@state.register
def _equivalence(claim: Equivalence, parts: Parts) -> None:
    space = parts.space(claim.scene)
    factor = _factor(claim, parts)
    own, other = _equations(space, (_printed(claim), claim.to))
    tree = space.element(factor)
    inverse = space.element(factor.inverse())
    parts.equal(space, [minus(own), ["*", tree, minus(other)]], [["*", tree, inverse], 1])


@state.register
def _implication(claim: Implication, parts: Parts) -> None:
    space, bench = parts.space(claim.scene), parts.bench.finder
    formula = space.stage.texts.formula(_printed(claim))
    is_equation = isinstance(formula, Relation)
    own = space.sides(_printed(claim)) if is_equation else [space.tree(formula), 0]
    equations = [*_equations(space, claim.together), own]
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
    given = _equations(space, claim.given)
    parts.follows(space, equations, given, [_found(row) for row in rows], claim.root)


@state.register
def _double_zero(claim: DoubleZero, parts: Parts) -> None:
    space = parts.space(claim.scene)
    given = [minus(sides) for sides in _equations(space, claim.given)]
    pairs = combinations_with_replacement(given, 2)
    terms = [
        ["*", space.element(factor), first, second]
        for factor, (first, second) in zip(
            _found(claim.form(parts.bench.finder)), pairs, strict=True
        )
        if not factor.is_zero
    ]
    right = ["+", *terms] if len(terms) > 1 else terms[0]
    parts.equal(space, [space.tree(space.stage.texts.formula(_printed(claim))), right])
    parts.notes.append("where two functions vanish, so do their product and its gradient")


@deny.register
def _no_double_zero(claim: DoubleZero, parts: Parts) -> None:
    space = parts.space(claim.scene)
    tree = space.tree(space.stage.texts.formula(_printed(claim)))
    sides = [[tree, 0], *([["d", name, tree], 0] for name in claim.scene.variables)]
    given = _equations(space, claim.given)
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
    special = _equations(space, claim.special.relations)
    general = _equations(space, claim.general.relations)
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
    transition = [_found(row) for row in rows]
    parts.follows(space, general, special, transition)
    stage = space.stage
    matrix = [[stage.carry(e) for e in row] for row in _matrix(claim.general, parts)]
    direct = [[stage.carry(e) for e in row] for row in _matrix(claim.special, parts)]
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
    given = _equations(space, claim.special.relations)
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
        rows.append(_found(cofactors))
    parts.follows(space, equations, given, rows)


def _entry(letter: str, i: int, j: int) -> str:
    return f"{letter}_{{{i + 1}{j + 1}}}"


# -- ranks -----------------------------------------------------------------------


@state.register
def _dimension(claim: Dimension, parts: Parts) -> None:
    _rank(claim, parts, (), claim.dimension)
    parts.notes.append("the set is a manifold of this dimension near the point")


@state.register
def _independence(claim: Independence, parts: Parts) -> None:
    _rank(claim, parts, claim.functions, None)


def _rank(claim: Set, parts: Parts, functions: tuple[Printed, ...], dimension: int | None) -> None:
    space = parts.space(claim.scene)
    levels, trees = (
        [space.tree(members(space.stage.relation(printed))[0]) for printed in places]
        for places in (claim.levels, functions)
    )
    parts.rank(space, levels, trees, _equations(space, claim.equations), dimension)


# -- helpers ---------------------------------------------------------------------


def _printed(claim: Claim) -> Printed:
    if claim.printed is None:
        raise CertificateError("the claim is no single formula")
    return claim.printed


def _equations(space: SpaceWriter, places: tuple[Printed, ...]) -> list[list[Tree]]:
    return [space.sides(printed) for printed in places]


def _written(formula: Formula) -> Formula:
    """A sum without the terms that the author does not print."""
    if isinstance(formula, Sum):
        terms = tuple(term for term in formula.terms if not isinstance(term, Unwritten))
        return Sum(terms) if len(terms) > 1 else terms[0]
    return formula


def _factor(claim: Equivalence, parts: Parts) -> Element:
    """The left side of the printed equation over that of the other one."""
    own = _printed(claim)
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


def _itself(value: Found, stage: Stage) -> Found:
    return value


def _sides(printed: Printed, stage: Stage) -> list[Element]:
    return [equation(printed, stage)]


def _side(printed: Printed, stage: Stage) -> Element:
    return equation(printed, stage)


def _matrix(claim: InvariantRelations, parts: Parts) -> Matrix:
    matrix = claim.matrix(parts.bench.finder)
    if matrix is None:
        raise CertificateError("no cofactor matrix was found")
    return matrix


def _found(row: list[Element] | None) -> list[Element]:
    if row is None:
        raise CertificateError("no combination was found")
    return row
