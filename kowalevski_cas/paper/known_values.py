r"""Values of functions that a scene prints at constants: :math:`\operatorname{sn}(K,k)=1`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction

from kowalevski_cas.notation import Application, Formula, Number, Power, to_latex
from kowalevski_cas.notation.functions import MEANING
from kowalevski_cas.paper.arguments import Combination, Monomial, multiple, names_in, product_of
from kowalevski_cas.paper.families import Kind, PrintedValue, kind_of
from kowalevski_cas.problem.space import Meaningless

Place = tuple[Kind, Monomial]
"""A family, and a constant."""


class KnownValues:
    """The values of generators at multiples of constants.

    ``argument`` writes out that of a function. Raises :class:`Meaningless` for a value at a sum.
    """

    def __init__(
        self,
        printed: Iterable[tuple[Application, Formula]],
        argument: Callable[[Application], Combination],
    ) -> None:
        self.values: dict[Place, dict[Fraction, dict[str, Formula]]] = {}
        for angle, value in printed:
            if len(terms := [*argument(angle).items()]) != 1:
                raise Meaningless(f"{to_latex(angle)} is taken at no multiple of a constant")
            [(monomial, factor)] = terms
            at = self.values.setdefault((kind_of(angle), monomial), {}).setdefault(factor, {})
            at[MEANING[angle.function]] = value

    def __contains__(self, place: Place) -> bool:
        return place in self.values

    def names(self) -> Iterator[str]:
        """The names at which values are known, and those in the moduli."""
        for kind, monomial in self.values:
            yield from names_in(monomial)
            yield from (name for parameter in kind.parameters for name in parameter.names())

    def multiple(self, place: Place, factor: Fraction) -> tuple[PrintedValue, int]:
        """The values of which those at a multiple of a constant are made, and how often."""
        (kind, monomial), values = place, self.values[place]
        parts = [value for value in values if (factor / value).denominator == 1]
        # the largest of those that are printed takes the fewest addition theorems
        nearest = max(parts, key=abs, default=factor)
        argument = _times(nearest, monomial)
        if values.get(nearest, {}).keys() != kind.family.rates.keys():
            raise Meaningless(f"print all values at {to_latex(argument)}")
        return PrintedValue(argument, values[nearest]), int(factor / nearest)

    def equations(
        self, at: Callable[[Kind, Sequence[tuple[PrintedValue, int]]], dict[str, Formula]]
    ) -> Iterator[tuple[Formula, Formula]]:
        """What the values obey: the relations of the functions, and their addition theorems.

        ``at`` gives the values of a family at a multiple.
        """
        for place, values in self.values.items():
            kind, monomial = place
            for factor, own in values.items():
                _ = self.multiple(place, factor)
                for letter, tex in kind.family.squares.items():
                    yield Power(own[letter], Number(2)), kind.formula(tex, own)
                for part in values:
                    if part != factor and (factor / part).denominator == 1:
                        there = PrintedValue(_times(part, monomial), values[part])
                        made = at(kind, [(there, int(factor / part))])
                        yield from ((own[letter], made[letter]) for letter in own)


def _times(factor: Fraction, monomial: Monomial) -> Formula:
    return multiple(product_of(monomial, factor.denominator), factor.numerator)
