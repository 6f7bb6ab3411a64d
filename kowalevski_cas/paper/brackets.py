r"""Poisson brackets of functions, by printed brackets of coordinates.

They are printed for two variables, as :math:`\{q,p\}=1`, or with indices: in
:math:`\{M_i,\alpha_j\}=-\varepsilon_{ijk}\alpha_k` the indices i, j are free and k is summed over.
Brackets that no place prints vanish.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    PoissonBracket,
    Product,
    Quotient,
    Sum,
    Vector,
    substitute,
    total,
)
from kowalevski_cas.notation.symbol import rate_name
from kowalevski_cas.paper.logarithms import has_logarithm
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.names import BRACKET, DELTA, EPSILON, head, is_indexed
from kowalevski_cas.problem.space import Meaningless

DIGITS = "123"
_INDEXED = re.compile(r"_(?:[ijk]|\{[ijk]+\})$")
Parts = tuple[bool, tuple[Formula, ...]]
"""Whether something is a vector, and its components."""


class Brackets:
    """The bracket of a scene; calling it gives the bracket of two functions.

    ``structure`` holds the bracket of each pair of variables, in one order. Raises
    :class:`Meaningless` if the printed brackets are not antisymmetric, if two places print
    different ones, or if there is none.
    """

    def __init__(self, setting: Meaning) -> None:
        self.setting = setting
        finder = setting.finder
        self.structure: dict[tuple[str, str], Formula] = {}
        values: dict[tuple[str, str], Element] = {}
        declared = [n for n in setting.scene.definitions if head(n)[0] == BRACKET]
        if not declared:
            said = f"no Poisson bracket is declared on “{setting.scene.name}”"
            raise Meaningless(rf"{said}: define it by those of the variables, as \{{q,p\}}=1")
        for name in declared:
            for (x, y), formula in self._instances(name):
                value = finder.scalar(formula)
                for pair, signed in (((x, y), value), ((y, x), -value)):
                    if not (values.setdefault(pair, signed) - signed).is_zero:
                        raise Meaningless(
                            f"the bracket of {x} and {y} is not antisymmetric, or has two values"
                        )
                if (y, x) not in self.structure:
                    self.structure[x, y] = formula
        # a bracket that cancels to zero over a denominator is kept: where that vanishes nothing is
        # known of it
        nothing = {
            p for p, bracket in values.items() if bracket.is_zero and not bracket.denominator
        }
        self.structure = {p: f for p, f in self.structure.items() if p not in nothing}

    def __call__(self, left: Parts, right: Parts) -> Formula:
        """The bracket of two functions, or of a vector and a function, component by component."""
        if left[0] and right[0]:
            raise Meaningless("the Poisson bracket of two vectors is no vector")
        rows = [self._bracket(f, g) for f, g in product(left[1], right[1])]
        return Vector(tuple(rows)) if left[0] or right[0] else rows[0]

    def _bracket(self, f: Formula, g: Formula) -> Formula:
        scene = self.setting.scene
        variables = {*scene.variables} - {name for name, _, _ in scene.jets}
        match f, g:
            # a jet is a variable of the space, but a function of the coordinates: Leibniz gives its
            # bracket
            case Name(x), Name(y) if {x, y} <= variables:
                if (y, x) in self.structure:
                    return Negative(self.structure[y, x])
                return self.structure.get((x, y), Number(0))
        terms = []
        for (x, y), value in self.structure.items():
            first = Product((self._partial(f, x), self._partial(g, y)))
            second = Product((self._partial(f, y), self._partial(g, x)))
            terms.append(Product((value, Sum((first, Negative(second))))))
        return total(terms)

    def _partial(self, f: Formula, by: str) -> Formula:
        """A partial derivative, also of a function with logarithms."""
        return (
            self.setting.plain(Partial(f, by)) if has_logarithm(f) else self.setting.partial(f, by)
        )

    def _instances(self, name: str) -> Iterator[tuple[tuple[str, str], Formula]]:
        """A printed bracket with all values of its indices, as brackets of variables."""
        setting = self.setting
        formula, arguments = setting.definition(name), head(name)[1]
        if any(isinstance(node, PoissonBracket) for node in formula.nodes()):
            raise Meaningless(f"the bracket of {' and '.join(arguments)} is given by brackets")
        if not any(map(is_indexed, arguments)):
            moving = setting.scene.variables
            coordinates = {*moving, *map(rate_name, moving)}
            if others := {*arguments} - coordinates - {*setting.scene.definitions}:
                raise Meaningless(f"{min(others)} is no variable, and has no Poisson bracket")
            first, second = (n if n in coordinates else self._same(n) for n in arguments)
            yield (first, second), setting.plain(formula)
            return
        known = {*setting.scene.names()}
        indexed = (n[:-1] for n in formula.names() if n.endswith(("_i", "_j", "_k")))
        stems = sorted(
            {argument[:-1] for argument in arguments}
            | {stem for stem in indexed if {f"{stem}{digit}" for digit in DIGITS} <= known}
        )
        summed = {EPSILON, *(f"{stem}k" for stem in stems)}
        terms = formula.terms if isinstance(formula, Sum) else (formula,)
        for i, j in product(DIGITS, DIGITS):
            found: Formula = total(
                self._with_indices(term, stems, i + j + k)
                for term in terms
                # a term without the index k is no sum over it: it counts once
                for k in (DIGITS if summed & term.names() else DIGITS[0])
            )
            pair = []
            for argument, digit in zip(arguments, (i, j), strict=True):
                variable, factor = self._variable(argument[:-1] + digit)
                found = found if factor == Number(1) else Quotient(found, factor)
                pair.append(variable)
            yield (pair[0], pair[1]), found

    def _with_indices(self, formula: Formula, stems: list[str], indices: str) -> Formula:
        values: dict[str, Formula] = {
            f"{stem}{letter}": Name(f"{stem}{digit}")
            for stem in stems
            for letter, digit in zip("ijk", indices, strict=True)
        }
        values |= {EPSILON: _sign(indices), DELTA: Number(int(indices[0] == indices[1]))}
        if unknown := {n for n in formula.names() - {*values} if _INDEXED.search(n)}:
            raise Meaningless(f"nothing says for what {min(unknown)} stands in the bracket")
        return self.setting.plain(substitute(formula, values))

    def _same(self, coordinate: str) -> str:
        """The variable that a coordinate is, as the one behind the last of a closed chain."""
        variable, factor = self._variable(coordinate)
        if factor != Number(1):
            raise Meaningless(f"{coordinate} is no variable, and has no Poisson bracket")
        return variable

    def _variable(self, coordinate: str) -> tuple[str, Formula]:
        """The variable of which a coordinate is a multiple, and the factor."""
        value = self.setting.finder.scalar(Name(coordinate))
        terms = value.terms().get(0, {})
        if len(terms) == 1 and value.parts.keys() == {0} and not value.denominator:
            ((exponents, factor),) = terms.items()
            if sum(exponents) == 1 and factor.denominator == 1 and factor > 0:
                return self.setting.finder.names[exponents.index(1)], Number(factor.numerator)
        raise Meaningless(f"{coordinate} is no multiple of a variable", coordinate)


def _sign(indices: str) -> Formula:
    """The sign of a permutation of three indices, or 0."""
    # the even permutations of 123 are what stands in 12312, the odd ones what stands in 32132
    if indices in "12312":
        return Number(1)
    return Negative(Number(1)) if indices in "32132" else Number(0)
