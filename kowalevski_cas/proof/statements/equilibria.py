"""States of rest in a certificate: they are the roots of one equation, and these are real."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise, product

from kowalevski_cas.arithmetic.numbers import Substitution, rational, square_root
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.present import fraction_formula, polynomial_formula
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims import Equilibria
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.claims.real_roots import form_of
from kowalevski_cas.claims.rest import Rest
from kowalevski_cas.notation import Formula, Name, Number, Power
from kowalevski_cas.proof.parts import Equation, Parts
from kowalevski_cas.proof.roots import Roots
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.statements.kinds import state
from kowalevski_cas.proof.trees import CertificateError, Tree, decode, encode
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.stage import Stage, scalar

LARGEST = 16
"""Up to which whole numbers are tried as values at a state of rest."""


@state.register
def state_equilibria(claim: Equilibria, parts: Parts) -> None:
    """Each state of rest gives a root of an equation, each root a state; all roots are real."""
    bench = parts.bench.finder
    found = bench.found(("roots", claim.id), lambda finder: None)
    if found is None:
        raise CertificateError("no equation for the states of rest was found")
    names = [n for n in "srnpquvwxyz" if n not in {*claim.scene.names()}]
    form, turn = names[:2]
    spaces = [
        parts.space(replace(claim.scene, constants=(*claim.scene.constants, *more)))
        for more in ((form,), (turn,))
    ]
    _States(claim, Roots.read(found), parts, parts.space(claim.scene), *spaces, form, turn).write()
    parts.notes.append(
        "a polynomial with leading coefficient 1 and even degree is positive far out and has a "
        "root between two places where its signs differ; a sum of squares that is not zero is "
        "positive"
    )


@dataclass
class _States:
    """The parts about states of rest.

    ``near`` is the space of the claim, where the form is defined; on ``far`` the
    ``form`` is a constant, and on ``turning`` a square root ``turn`` is one.
    """

    claim: Equilibria
    roots: Roots
    parts: Parts
    near: SpaceWriter
    far: SpaceWriter
    turning: SpaceWriter
    form: str
    turn: str

    def write(self) -> None:
        """All parts."""
        rest = Rest(self.far.stage, self.claim.fixed)
        self.rest = rest
        system = self.claim.system(rest, self.far.stage.texts)
        if system is None:
            raise CertificateError("the parameters are not independent")
        self.system = system
        self.levels = [self.near.sides(printed) for printed in self.claim.levels]
        own = self.far.stage.ring.generator(self.form)
        values = [scalar(formula, self.far.stage) for formula in system.values]
        self.into = system.into(values, own)
        found = self.roots.eliminant
        self.equation = self._tree(found.equation)
        self.solved: list[Equation] = [
            [["*", self._tree(below), name], self._tree(above)]
            for name, below, above in zip(
                rest.free, found.denominators, found.numerators, strict=True
            )
        ]
        self.linear: list[Equation] = [
            [name, self.far.element(rest.solution[name])]
            for name in self.claim.scene.variables
            if name not in (*rest.free, *self.claim.fixed)
        ]
        self._to_roots()
        self._from_roots()
        self._signs()
        self._turning_points()

    def _tree(self, terms: Terms) -> Tree:
        """A polynomial in the form and the parameters."""
        return self.far.element(self.into(self.system.element(terms)))

    # -- states and roots ----------------------------------------------------------

    def _to_roots(self) -> None:
        """Every state of rest is given by its form, which is a root."""
        form = self.far.element(form_of(self.roots.eliminant, self.system.unknowns))
        self.near.abbreviate(self.form, form)
        fixed = self.claim.fixed
        given: list[Equation] = [
            *([name, 0] for name in fixed),
            *([["D", name], 0] for name in fixed),
            *self.levels,
        ]
        stage = self.near.stage
        image = {g: stage.ring.generator(g) for g in stage.generators}
        image[self.form] = scalar(decode(form, self.near.mark), stage)
        carry = Substitution(self.far.stage.ring, image, stage.ring)
        targets = [[self.equation, 0], *self.solved, *self.linear]
        elements = [carry(e) for sides in targets for e in self.far.difference(sides)]
        known = [e for sides in given for e in self.near.difference(sides)]
        solved = tuple(n for n in self.claim.scene.variables if n not in (*self.rest.free, *fixed))
        main = [(*self.claim.scene.constants, *solved), fixed]
        rows = [_combined(element, known, main) for element in elements]
        self.parts.follows(self.near, targets, given, rows, at=self._state(stage))

    def _from_roots(self) -> None:
        """Every root gives a state of rest, and is its form."""
        fixed, names = self.claim.fixed, self.claim.scene.variables
        form = self.far.element(form_of(self.roots.eliminant, self.system.unknowns))
        given: list[Equation] = [
            *([name, 0] for name in fixed),
            *self.linear,
            *self.solved,
            [self.equation, 0],
        ]
        targets: list[Equation] = [
            *([["D", name], 0] for name in names),
            *self.levels,
            [form, self.form],
        ]
        known = [e for sides in given for e in self.far.difference(sides)]
        solved = tuple(n for n in names if n not in (*self.rest.free, *fixed))
        main = [(*fixed, *solved, *self.rest.free), (self.form,)]
        elements = [e for sides in targets for e in self.far.difference(sides)]
        rows = [_combined(element, known, main) for element in elements]
        self.far.nonzero += self._conditions()
        self.parts.follows(self.far, targets, given, rows, at=self._state(self.far.stage))

    def _state(self, stage: Stage) -> AtPoint:
        """A state of rest in whole numbers, with its parameters."""
        rest, scene = Rest(stage, self.claim.fixed), stage.scene
        formulas = [self._parameter(formula) for formula in self.system.values]
        for values in product(range(LARGEST, 0, -1), repeat=len(rest.free)):
            point = dict.fromkeys(scene.constants, Fraction(0))
            point |= dict(zip(rest.free, map(Fraction, values), strict=True))
            numbers = {n: self.far.stage.ring.number(v) for n, v in point.items()}
            at = rest.at(self.far.stage.ring, numbers)
            point |= {
                n: rational(at(stage.ring.generator(n))) or Fraction(0) for n in scene.variables
            }
            levels = [
                rational(at(scalar(left, stage))) for left in self.claim.sides(stage.texts, 0)
            ]
            for (name, squared), level in zip(formulas, levels, strict=True):
                root = square_root(level) if squared and level is not None else level
                point[name] = Fraction(0) if root is None else root
            if self.form in scene.constants:
                weights = zip(self.roots.eliminant.form, rest.free, strict=True)
                point[self.form] = sum((c * point[n] for c, n in weights), Fraction(0))
            found = AtPoint(stage, {name: (value, Fraction(0)) for name, value in point.items()})
            if self._fits(found, levels):
                return found
        raise CertificateError("no state of rest in whole numbers was found")

    def _fits(self, at: AtPoint, levels: Sequence[Fraction | None]) -> bool:
        """Whether the parameters belong to the levels, and no factor vanishes."""
        values = [rational(at(scalar(formula, at.stage))) for formula in self.system.values]
        if values != list(levels):
            return False
        numbers = [at.numbers.number(value or 0) for value in values]
        into = self.system.into(numbers, at.numbers.zero)
        return not any(into(self.system.element(s.factor)).is_zero for s in self.roots.signs)

    @staticmethod
    def _parameter(formula: Formula) -> tuple[str, bool]:
        """The constant that a printed value names, and whether the value is its square."""
        match formula:
            case Name(name):
                return name, False
            case Power(Name(name), Number(2)):
                return name, True
        raise CertificateError("the value of an integral is no constant and no square of one")

    # -- signs -----------------------------------------------------------------------

    def _conditions(self) -> list[Tree]:
        """The factors that must not vanish, as sums of squares where that is possible."""
        return [self._factor(k) for k in range(len(self.roots.signs))]

    def _factor(self, index: int) -> Tree:
        """A factor in the parameters as they are printed."""
        sign = self.roots.signs[index]
        if not sign.in_parameters:
            return self._tree(sign.factor)
        squares = [
            _times(number, ["^", self._tree(base), 2]) for number, base in sign.in_parameters
        ]
        return ["+", *squares] if len(squares) > 1 else squares[0]

    def _signs(self) -> None:
        """Factors that are sums of squares of the variables, where the levels are."""
        stage = self.near.stage
        names: list[Formula] = [Name(n) for n in stage.ring.polynomials.generators]
        for k, sign in enumerate(self.roots.signs):
            if sign.in_parameters or not sign.in_variables:
                continue
            squares = [
                _times(number, ["^", encode(polynomial_formula(base, names)), 2])
                for number, base in sign.in_variables
            ]
            sides = [self._factor(k), ["+", *squares]]
            known = [e for level in self.levels for e in self.near.difference(level)]
            rows = [
                _combined(element, known, [self.claim.scene.constants])
                for element in self.near.difference(sides)
            ]
            at = self._state(stage)
            self.parts.follows(self.near, [sides], self.levels, rows, at=at)

    def _turning_points(self) -> None:
        """The equation at the zeros of its derivative: its values have alternating signs."""
        polynomials = self.system.ring.polynomials
        equation = self.roots.eliminant.equation
        degree = max(powers[0] for powers in equation)
        slope = {(k - 1, *rest): k * value for (k, *rest), value in equation.items() if k}
        square: Terms | None = None
        points: list[tuple[Tree, Terms]] = []
        for factor, _ in polynomials.from_terms(slope).factor()[1]:
            rows = _by_first(polynomials.terms(factor))
            leading = rows.pop(max(rows))
            if rows and ([*rows] != [0] or square is not None or max(map(sum, leading))):
                raise CertificateError("the zeros of the derivative are no single square root")
            if rows:
                (number,) = leading.values()
                square = {(0, *e): -value / number for e, value in rows[0].items()}
            else:
                points.append((0, _by_first(equation)[0]))
        if square is not None:
            ends = ["-", self.turn], self.turn
            points = [(ends[0], self._even(equation, square)), *points]
            points.append((ends[1], self._even(equation, square)))
        signs = []
        targets: list[Equation] = []
        for tree, value in points:
            number, factored = self._factored(value)
            signs.append(number > 0)
            targets.append([_put(self.equation, self.form, tree), factored])
        alternate = all(a != b for a, b in pairwise([True, *signs, True]))
        if degree % 2 or len(points) != degree - 1 or not alternate:
            raise CertificateError("the signs at the zeros of the derivative do not alternate")
        space = self.turning
        space.nonzero += self._conditions()
        given: list[Equation] = []
        if square is not None:
            given = [[["^", self.turn, 2], self._tree(square)]]
        known = [e for sides in given for e in space.difference(sides)]
        elements = [e for sides in targets for e in space.difference(sides)]
        rows_found = [_combined(element, known, [(self.turn,)]) for element in elements]
        self.parts.follows(space, targets, given, rows_found)

    def _even(self, equation: Terms, square: Terms) -> Terms:
        """The value of an equation in even powers where the square of the form has this value."""
        polynomials = self.system.ring.polynomials
        total = polynomials.zero
        for power, row in _by_first(equation).items():
            if power % 2:
                raise CertificateError("the equation has odd powers")
            value = polynomials.from_terms({(0, *e): c for e, c in row.items()})
            total = total + value * polynomials.from_terms(square) ** (power // 2)
        return {e[1:]: value for e, value in polynomials.terms(total).items()}

    def _factored(self, value: Terms) -> tuple[Fraction, Tree]:
        """A value as a number times factors that are sums of squares, and the number."""
        polynomials = self.system.ring.polynomials
        content, factors = polynomials.from_terms({(0, *e): v for e, v in value.items()}).factor()
        number, trees = Fraction(int(content.p), int(content.q)), []
        for factor, exponent in factors:
            known = [polynomials.from_terms(sign.factor) for sign in self.roots.signs]
            if factor not in known:
                raise CertificateError("a value of the equation has a factor without a sign")
            trees += [self._factor(known.index(factor))] * int(exponent)
        return number, _times(number, *trees)


def _times(number: Fraction, *trees: Tree) -> Tree:
    """The tree of a product with a rational number."""
    factors = [*([encode(fraction_formula(number))] if number != 1 or not trees else []), *trees]
    return ["*", *factors] if len(factors) > 1 else factors[0]


def _by_first(terms: Terms) -> dict[int, Terms]:
    """The coefficients of the powers of the first variable."""
    rows: dict[int, Terms] = {}
    for (power, *rest), value in terms.items():
        rows.setdefault(power, {})[tuple(rest)] = value
    return rows


def _put(tree: Tree, name: str, value: Tree) -> Tree:
    """The tree with a value for a name."""
    if tree == name:
        return value
    return [tree[0], *(_put(t, name, value) for t in tree[1:])] if isinstance(tree, list) else tree


def _combined(
    element: Element, known: Sequence[Element], main: Sequence[tuple[str, ...]]
) -> list[Element]:
    """The element as a combination of others."""
    if element.is_zero:
        return [element] * len(known)
    row = cofactors(element, known, main)
    if row is None:
        raise CertificateError("no combination was found")
    return row
