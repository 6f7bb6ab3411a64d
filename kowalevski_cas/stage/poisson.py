r"""Poisson brackets of the variables, as printed brackets of coordinates give them.

They are printed with indices: in :math:`\\{M_i,\\alpha_j\\}=-\\varepsilon_{ijk}\\alpha_k` the
indices i, j are free and k is summed over. Brackets that no place prints vanish.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.notation import Formula, Name, Negative, Number, substitute
from kowalevski_cas.paper.scene import BRACKET, EPSILON, head
from kowalevski_cas.stage.evaluate import StageError, scalar

if TYPE_CHECKING:
    from kowalevski_cas.stage.stage import Stage

Structure = dict[tuple[str, str], Element]
"""The bracket of each pair of variables; each pair stands there in one order."""

DIGITS = "123"


def printed_structure(stage: Stage) -> Structure:
    """The brackets of the variables; raises :class:`StageError` if they are not antisymmetric."""
    found: Structure = {}
    for defined in stage.scene.definitions:
        function, arguments = head(defined)
        if function == BRACKET:
            for (x, y), value in _instances(stage, defined, arguments):
                opposite = found.get((y, x), -value if x == y else None)
                if opposite is None:
                    found[x, y] = value
                elif not (opposite + value).is_zero:
                    raise StageError(f"the bracket of {x} and {y} is not antisymmetric")
    if not found:
        raise StageError(f"no Poisson bracket is declared on the scene “{stage.scene.name}”")
    return {pair: value for pair, value in found.items() if not value.is_zero}


def _instances(
    stage: Stage, defined: str, arguments: tuple[str, ...]
) -> Iterator[tuple[tuple[str, str], Element]]:
    """A printed bracket with all values of its indices, as brackets of variables."""
    formula = stage.definition(defined)
    stems = sorted({argument[:-1] for argument in arguments})
    for i, j in product(DIGITS, DIGITS):
        total = stage.ring.zero
        for k in DIGITS:
            values = {
                f"{stem}{letter}": Name(f"{stem}{digit}")
                for stem in stems
                for letter, digit in zip("ijk", (i, j, k), strict=True)
            }
            indexed = substitute(formula, {**values, EPSILON: _sign(i + j + k)})
            total = total + scalar(indexed, stage)
        pair = []
        for argument, digit in zip(arguments, (i, j), strict=True):
            name, factor = _variable(stage, argument[:-1] + digit)
            total = total / factor
            pair.append(name)
        yield (pair[0], pair[1]), total


def _variable(stage: Stage, coordinate: str) -> tuple[str, Element]:
    """The variable of which a coordinate is a multiple, and the factor."""
    value = scalar(Name(coordinate), stage)
    terms = value.terms().get(0, {})
    if len(terms) == 1 and value.parts.keys() == {0} and not value.denominator:
        ((exponents, factor),) = terms.items()
        if sum(exponents) == 1:
            return stage.generators[exponents.index(1)], stage.ring.number(factor)
    raise StageError(f"{coordinate} is no multiple of a variable", coordinate)


def _sign(indices: str) -> Formula:
    """The sign of a permutation of three indices, or 0."""
    if indices in "12312":
        return Number(1)
    return Negative(Number(1)) if indices in "32132" else Number(0)
