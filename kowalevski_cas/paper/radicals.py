r"""Powers with fractions as exponents, :math:`x^{4/3}`, in a root of what they are powers of.

In the place of a variable or constant x with :math:`x^{4/3}` stands :math:`s=x^{1/6}`, of which
even powers are used only: so x is positive, and each positive x is one. It is a variable, and is
not zero. Where there are roots of odd order only, as :math:`\sqrt[3]{x}`, it is :math:`s=x^{1/3}`,
and each x but zero is one.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from math import lcm

from kowalevski_cas.notation import Formula, Name, Number, Power, Quotient, Radical, Root, times
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
        self.orders = {name: n for name, n in _orders(formulas).items() if name in names}
        if wrong := sorted(self.orders.keys() & {*under}):
            raise Meaningless(f"{wrong[0]} stands under functions, and under a root", wrong[0])

    def __contains__(self, name: str) -> bool:
        return name in self.orders

    def knows(self, formulas: Iterable[Formula], scene: Scene) -> bool:
        """Whether formulas bring in no other powers of what moves or is constant."""
        names = (*scene.variables, *scene.constants)
        needed = {name: n for name, n in _orders(formulas).items() if name in names}
        return all(self.orders.get(name, 1) % n == 0 for name, n in needed.items())

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


def _orders(formulas: Iterable[Formula]) -> Mapping[str, int]:
    """The names of which roots stand in formulas, and of which order the one in their place is.

    It is even where names are positive, of which square roots and powers with fractions stand
    there. Square roots alone need none in the place of a name.
    """
    found: dict[str, list[tuple[int, int]]] = {}
    for node in (node for formula in formulas for node in formula.nodes()):
        match node:
            case Power(Name(name), exponent) if (own := fraction(exponent)) is not None:
                found.setdefault(name, []).append((2 * own.denominator, own.denominator))
            case Radical() if (power := power_under(node)) and power[1].denominator > 1:
                name, own = power
                even = 1 + (node.order % 2 == 0)
                found.setdefault(name, []).append((even * own.denominator, node.order))
            case Root(Name(name)):
                found.setdefault(name, []).append((4, 2))
    high = {name: pairs for name, pairs in found.items() if any(q > 2 for _, q in pairs)}
    return {name: lcm(*(order for order, _ in pairs)) for name, pairs in high.items()}


def power_under(radical: Radical) -> tuple[str, Fraction] | None:
    r"""The name x and the exponent p/n of a root :math:`\sqrt[n]{x^p}`; ``None`` for other roots.

    An even root of an even power may be that of the opposite: it is none of these.
    """
    match radical.argument:
        case Name(name):
            return name, Fraction(1, radical.order)
        case Power(Name(name), Number(power)) if power % 2 or radical.order % 2:
            return name, Fraction(power, radical.order)
    return None
