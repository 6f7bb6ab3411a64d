r"""Random points modulo a prime on the set that some equations define.

One generator is solved for in each equation, all others are random. An equation
in one unknown becomes a polynomial when the unknown is a variable T, and T a root of
it. Where two equations share their unknowns, one is solved as a linear equation
with coefficients that are rational functions of T, and the other one gives T.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import permutations
from random import Random
from typing import Any

from flint import nmod, nmod_poly
from flint.utils.flint_exceptions import DomainError

from kowalevski_cas.algebra.points import NoPoint
from kowalevski_cas.algebra.programs import Op, Program, steps
from kowalevski_cas.algebra.series import Series
from kowalevski_cas.algebra.valuation import Valuation

Residues = dict[str, nmod]
Plan = tuple[tuple[tuple[Program, ...], tuple[str, ...]], ...]
"""Systems of equations with their unknowns, in the order in which they are solved."""

LARGEST_SYSTEM = 2
"""How many equations that share their unknowns are solved together."""


class NoRoot(ArithmeticError):
    """A root does not exist modulo the prime at this point; another point may do."""


def square_root(value: nmod) -> nmod:
    """One of the square roots of a residue; raises :class:`NoRoot` if there is none."""
    try:
        return value.sqrt()
    except DomainError:
        raise NoRoot from None


class Rational:
    """A rational function of T modulo a prime."""

    __slots__ = ("above", "below")

    def __init__(self, above: nmod_poly, below: nmod_poly) -> None:
        common = above.gcd(below)
        self.above = above // common
        self.below = below // common

    def __add__(self, other: Rational | nmod) -> Rational:
        if isinstance(other, Series):
            return NotImplemented
        if isinstance(other, Rational):
            above = self.above * other.below + other.above * self.below
            return Rational(above, self.below * other.below)
        return Rational(self.above + other * self.below, self.below)

    __radd__ = __add__

    def __mul__(self, other: Rational | nmod | int) -> Rational:
        if isinstance(other, Series):
            return NotImplemented
        if isinstance(other, Rational):
            return Rational(self.above * other.above, self.below * other.below)
        return Rational(self.above * other, self.below)

    __rmul__ = __mul__

    def __rtruediv__(self, other: int) -> Rational:
        if not self.above:
            raise ZeroDivisionError("division by zero")
        return Rational(self.below * other, self.above)


def satisfy(
    equations: Sequence[Program],
    values: Mapping[str, nmod],
    signs: Mapping[str, int],
    prime: int,
    random: Random,
) -> Residues:
    """The values, with those of some generators changed so that the equations hold.

    ``signs`` chooses among the two roots of each radicand. Raises :class:`NoPoint` if
    no order of solving is known, :class:`NoRoot` if an unknown has no value here.
    """
    found = dict(values)
    variable = nmod_poly([0, 1], prime), nmod_poly([1], prime)
    for system, unknowns in plan(tuple(equations)):
        *linear, last = unknowns
        curve: dict[str, Any] = {**found, last: Rational(*variable)}
        for equation, name in zip(system, linear, strict=False):
            curve[name] = _linear(equation, name, curve, signs, prime)
        root = _root(valuation(curve, signs, prime)(system[-1]), found[last], random)
        found[last] = root
        for name in linear:
            found[name] = _at(curve[name], root)
    return found


def valuation(values: Mapping[str, Any], signs: Mapping[str, int], prime: int) -> Valuation:
    """The valuation at a point modulo a prime, with the roots of these signs."""

    def number(value: Fraction) -> nmod:
        return nmod(value.numerator, prime) / nmod(value.denominator, prime)

    return Valuation(number, values, lambda name, square: signs[name] * square_root(square))


def _linear(
    equation: Program, name: str, curve: Mapping[str, Any], signs: Mapping[str, int], prime: int
) -> Rational:
    """The solution of an equation that is linear in one unknown, as a function of T."""
    # what is linear in the unknown is known by two of its values
    at_zero, at_one = (
        valuation({**curve, name: nmod(value, prime)}, signs, prime)(equation) for value in (0, 1)
    )
    solution: Rational = -1 * at_zero * (1 / (at_one + -1 * at_zero))
    return solution


def _root(function: Any, value: nmod, random: Random) -> nmod:
    """A random root of a function; any value will do for an equation that holds already."""
    if not isinstance(function, Rational):
        if function != 0:
            raise NoPoint("an equation does not contain its unknown")
        return value
    if not function.above:
        return value
    roots = [root for root, _ in function.above.roots()]
    if not roots:
        raise NoRoot
    return random.choice(roots)


def _at(function: Any, root: nmod) -> nmod:
    assert isinstance(function, Rational)
    return function.above(root) / function.below(root)


@lru_cache(maxsize=32)
def plan(equations: tuple[Program, ...]) -> Plan:
    """An order in which the equations can be solved; raises :class:`NoPoint` if there is none."""
    inside = {equation: _names(equation) for equation in equations}
    found = _plan(equations, inside)
    if found is None:
        raise NoPoint("the equations of the set are too entangled to be solved at random points")
    return found


def _plan(
    equations: tuple[Program, ...], inside: Mapping[Program, tuple[set[str], set[str]]]
) -> Plan | None:
    """What is solved last has unknowns that no other equation contains."""
    if not equations:
        return ()
    for size in range(1, min(LARGEST_SYSTEM, len(equations)) + 1):
        for system in permutations(equations, size):
            rest = tuple(e for e in equations if e not in system)
            elsewhere = set().union(*(set().union(*inside[e]) for e in rest))
            for unknowns in _unknowns(system, inside, elsewhere):
                before = _plan(rest, inside)
                if before is not None:
                    return (*before, (system, unknowns))
    return None


def _unknowns(
    system: tuple[Program, ...],
    inside: Mapping[Program, tuple[set[str], set[str]]],
    elsewhere: set[str],
) -> Iterator[tuple[str, ...]]:
    """Names to solve a system for: none of them under a root, or in another equation."""
    under_roots = set().union(*(inside[e][1] for e in system))
    free = [n for n in sorted(set().union(*(inside[e][0] for e in system)))
            if n not in under_roots and n not in elsewhere]  # fmt: skip
    for unknowns in permutations(free, len(system)):
        if unknowns[-1] not in inside[system[-1]][0]:
            continue
        if all(_is_linear(e, name) for e, name in zip(system, unknowns[:-1], strict=False)):
            yield unknowns


def _is_linear(equation: Program, name: str) -> bool:
    """Whether a program is of the first degree in a generator, by following its steps."""
    degrees: dict[Program, int] = {}
    for step in steps([equation]):
        below = [degrees[arg] for arg in step.args]
        match step.op:
            case Op.GENERATOR:
                degrees[step] = int(step.data == name)
            case Op.PRODUCT:
                degrees[step] = sum(below)
            case Op.POWER:
                degrees[step] = below[0] * int(str(step.data))
            case Op.INVERSE | Op.ROOT | Op.ALONG:
                degrees[step] = 2 * below[0]  # not of the first degree, if it occurs at all
            case _:
                degrees[step] = max(below, default=0)
    return degrees[equation] == 1


def _names(program: Program) -> tuple[set[str], set[str]]:
    """The generators in a program, and those under its roots."""
    found = steps([program])
    names = {str(step.data) for step in found if step.op is Op.GENERATOR}
    radicands = [step.args[0] for step in found if step.op is Op.ROOT]
    under = {str(step.data) for step in steps(radicands) if step.op is Op.GENERATOR}
    return names, under
