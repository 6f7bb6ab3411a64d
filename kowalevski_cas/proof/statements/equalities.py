"""Claims that expressions are equal, in the parts of a certificate."""

from __future__ import annotations

from itertools import pairwise

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.claims import (
    ChangedEquation,
    Coefficient,
    ConstantRoot,
    Degree,
    Identity,
    InvertibleChange,
    LastMultiplier,
    Reality,
    SolvedExponents,
    Unit,
)
from kowalevski_cas.claims.formulas import equation, members
from kowalevski_cas.notation import Constant, Formula, Relation, Sum, Unwritten
from kowalevski_cas.proof.parts import Parts
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.statements.kinds import (
    deny,
    matrix_of,
    printed_of,
    state,
)
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.paper.texts import Printed


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
    formula = space.stage.texts.formula(printed_of(claim))
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


def _written(formula: Formula) -> Formula:
    """A sum without the terms that the author does not print."""
    if isinstance(formula, Sum):
        terms = tuple(term for term in formula.terms if not isinstance(term, Unwritten))
        return Sum(terms) if len(terms) > 1 else terms[0]
    return formula


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
    matrix = matrix_of(claim.relations, parts)
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
    parts.equal(space, space.sides(printed_of(claim)))
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
