r"""Powers with fractions as exponents, :math:`x^{4/3}`, in a root of what they are powers of.

In the place of a variable or constant x with :math:`x^{4/3}` stands :math:`s=x^{1/6}`, of which
even powers are used only: so x is positive, and each positive x is one. It is a variable, and is
not zero.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from math import lcm

from kowalevski_cas.notation import Formula, Name, Number, Power, Quotient, Root, times
from kowalevski_cas.paper.exponents import fraction
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.space import EquationOfMotion, Meaningless


class Radicals:
    """The names of which fractional powers stand in some formulas, with the roots in their place.

    Of names ``under`` functions no powers are read.
    """

    def __init__(
        self, formulas: Iterable[Formula], names: Collection[str], under: Collection[str] = ()
    ) -> None:
        self.orders = {name: 2 * q for name, q in _denominators(formulas).items() if name in names}
        if wrong := sorted(self.orders.keys() & {*under}):
            raise Meaningless(f"{wrong[0]} stands under functions, and under a root", wrong[0])

    def __contains__(self, name: str) -> bool:
        return name in self.orders

    def knows(self, formulas: Iterable[Formula], scene: Scene) -> bool:
        """Whether formulas bring in no other powers of what moves or is constant."""
        names = (*scene.variables, *scene.constants)
        needed = {name: q for name, q in _denominators(formulas).items() if name in names}
        return all(self.orders.get(name, 1) % (2 * q) == 0 for name, q in needed.items())

    def root(self, name: str) -> str:
        """The name that stands in the place of another one, which may be itself."""
        return f"{name}^{{1/{self.orders[name]}}}" if name in self.orders else name

    def value(self, name: str) -> Formula:
        """What a name is by the root in its place."""
        return self.power(name, Fraction(1))

    def power(self, name: str, exponent: Fraction) -> Formula:
        """A power of a name."""
        whole = int(self.orders[name] * exponent)
        raised = Power(Name(self.root(name)), Number(abs(whole)))
        return raised if whole > 0 else Quotient(Number(1), raised)

    def slope(self, name: str) -> Formula:
        """The derivative of a name by the root in its place."""
        order = self.orders[name]
        return times(Number(order), Power(Name(self.root(name)), Number(order - 1)))

    def row(self, row: EquationOfMotion) -> EquationOfMotion:
        """An equation of motion for the root in the place of what moves by it."""
        found = [name for name in row.names if name in self]
        if not found:
            return row
        if len(row.names) > 1:
            raise Meaningless(f"print the equations of motion by components, for {found[0]}")
        factor = times(self.slope(found[0]), row.factor)
        return EquationOfMotion((self.root(found[0]),), factor, row.force)


def _denominators(formulas: Iterable[Formula]) -> Mapping[str, int]:
    """The names of which powers with fractions stand in formulas; their common denominators.

    Square roots are no such powers, but where others stand beside them.
    """
    found: dict[str, int] = {}
    for node in (node for formula in formulas for node in formula.nodes()):
        match node:
            case Power(Name(name), exponent) if (own := fraction(exponent)) is not None:
                found[name] = lcm(found.get(name, 1), own.denominator)
            case Root(Name(name)):
                found[name] = lcm(found.get(name, 1), 2)
    return {name: q for name, q in found.items() if q > 2}
