r"""The functions at the arguments that stand on a scene, in generators that obey equations.

Of :math:`\sin\theta` a sine and a cosine stand in the place of the angle: a variable, and a root of
:math:`1-\sin^2\theta`. In the place of a variable x with :math:`e^x` stands :math:`e^{x/2}`, which
is not zero, and of which even powers are used only. So every value that a point gives is the value
at an angle, and at a number x; what is proved or refuted is so for the functions themselves.

An argument may be :math:`\omega t`, :math:`\theta/2` or a constant as well, and a variable may
stand by itself beside its sine. The generators are then no free variables: what is proved of them
holds for the functions, and so does it that an equation fails, for no equation holds between
:math:`\theta` and its sine. But of values where other equations are given nothing is known.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from functools import cached_property
from math import lcm
from typing import NamedTuple

from kowalevski_cas.notation import Application, Formula, Name, Number, Root, times, to_latex, total
from kowalevski_cas.notation.functions import FAMILY_OF, MEANING, Family
from kowalevski_cas.paper.arguments import (
    Combination,
    Monomial,
    by_name,
    combination,
    is_arithmetic,
    multiple,
    names_in,
    single_name,
)
from kowalevski_cas.paper.families import (
    Generators,
    Imaginary,
    Kind,
    applications,
    kind_of,
    real_part,
    template,
)
from kowalevski_cas.problem.space import Adjoined, Meaningless

ONE, PI = Number(1), r"\pi"


class Derived(NamedTuple):
    """A generator by others: ``by`` says at what sum, as :func:`addition.theorem` takes it."""

    formula: Formula
    by: tuple[Family, bool, bool]


class Transcendental:
    """The functions in some formulas, of which the names are known to be ``variables`` or not.

    ``free`` are names that stand by themselves as well, outside of functions; the ``time`` is none
    of the variables. Calling it writes a function out in generators.
    """

    def __init__(
        self,
        formulas: Iterable[Formula],
        free: Iterable[str],
        variables: Sequence[str],
        constants: Sequence[str],
        time: str,
        expanded: Callable[[Formula], Formula],
        adjoined: Iterable[str] = (),
    ) -> None:
        self.adjoined = frozenset(adjoined)
        self.free, self.time, self._expanded = frozenset(free), time, expanded
        self.variables, self.constants = (*variables, *([time] if time else [])), tuple(constants)
        known = {*self.variables, *constants}
        found: dict[tuple[Kind, Monomial], int] = {}
        for application in dict.fromkeys(one for f in formulas for one in applications(f)):
            kind, argument = kind_of(application), self._argument(application)
            if not known.issuperset(n for monomial in argument for n in names_in(monomial)):
                continue
            if not all(is_arithmetic(formula) for monomial in argument for formula, _ in monomial):
                continue
            below = (name for one in kind.parameters for name in expanded(one).names())
            if not {*constants}.issuperset(below) or any(map(self._degenerates, kind.parameters)):
                continue  # what moves is no modulus: by it these functions are not derived
            for monomial, factor in argument.items():
                if monomial:
                    own, real, over = self._real(kind, monomial) or (kind, monomial, 1)
                    over *= factor.denominator
                    found[own, real] = lcm(found.get((own, real), 1), over)
        self.groups = tuple(Generators(*key, over) for key, over in found.items())
        self.derived: dict[str, Derived] = {}

    def _real(self, kind: Kind, monomial: Monomial) -> tuple[Kind, Monomial, int] | None:
        """What an imaginary argument is i times; ``None`` where i is no unit."""
        return real_part(kind, monomial) if "i" in self.constants else None

    def _degenerates(self, modulus: Formula) -> bool:
        """Whether a modulus is 0, 1 or -1, with which the functions obey more equations."""
        numbers = combination(self._expanded(modulus))
        return not numbers or (numbers.keys() == {()} and abs(numbers[()]) == 1)

    def _argument(self, application: Application) -> Combination:
        """The argument of a function, in which no name is a defined one."""
        return combination(self._expanded(application.arguments[0]))

    @cached_property
    def names_replaced(self) -> frozenset[str]:
        """The names in whose place generators stand."""
        alone = {single_name(group.monomial) for group in self.groups}
        used = {
            n for g in self.groups if single_name(g.monomial) is None for n in g.argument.names()
        }
        return frozenset(name for name in alone - used - self.free if name)

    @cached_property
    def dependent(self) -> frozenset[str]:
        """The generators, and the names in them, that do not take all values by themselves."""
        found = set[str]()
        for group in self.groups:
            name = single_name(group.monomial)
            beside = sum(single_name(other.monomial) == name for other in self.groups)
            if name not in self.names_replaced or beside > 1 or not group.kind.family.covers:
                below = (n for one in group.kind.parameters for n in one.names())
                found.update(group.names.values(), group.argument.names(), below)
        return frozenset(found)

    def independent(self, names: Container[str], is_square: Callable[[Formula], bool]) -> bool:
        """Whether the generators in some names are known to obey no equations but their own.

        It is not of functions with two moduli, nor with one that may be 0 or 1, where they are
        others, nor of arguments that may have to do with one another.
        """
        groups = [g for g in self.groups if any(name in names for name in g.names.values())]
        kinds = {group.kind for group in groups if group.kind.parameters}
        if any(self._may_degenerate(one) for kind in kinds for one in kind.parameters):
            return False
        return len(kinds) < 2 and (len(groups) < 2 or self._unrelated(groups, is_square))

    def _unrelated(self, groups: list[Generators], is_square: Callable[[Formula], bool]) -> bool:
        """Whether no argument is a sum of multiples of the others; products of names are none.

        Roots may be each other's multiples, and that of a square is none. Over a sum stand terms
        that may cancel.
        """
        parts = [part for group in groups for part in group.monomial]
        odd = [(f, e) for f, e in parts if self._is_root(f) or not isinstance(f, Name)]
        inner = {one for f, _ in odd for one in f.nodes() if one == f or self._is_root(one)}
        if len(inner) > 1 or len({exponent for _, exponent in odd}) > 1:
            return False
        if any(map(self._is_root, inner)):
            return all(e * e == 1 for _, e in odd) and not any(map(is_square, inner))
        return len(odd) < 2

    def _is_root(self, formula: Formula) -> bool:
        """Whether a formula is a root, as printed or by its name."""
        return isinstance(formula, Root) or getattr(formula, "name", "") in self.adjoined

    def _may_degenerate(self, modulus: Formula) -> bool:
        """Whether a modulus is 0, 1 or -1, or has a root in it that may be."""
        terms = combination(self._expanded(modulus))
        if not any(terms):
            return sum(terms.values()) in (0, 1, -1)
        return not self._expanded(modulus).names().isdisjoint(self.adjoined)

    def __contains__(self, name: str) -> bool:
        return name in self.names_replaced

    def instead(self, name: str) -> tuple[str, ...]:
        """The names in the place of one, or the name with its functions."""
        found = () if name in self.names_replaced else (name,)
        groups = (g for g in self.groups if single_name(g.monomial) == name)
        return (*found, *(n for g in groups for n in g.moving))

    @property
    def depends_on_time(self) -> bool:
        """Whether the time stands in a formula."""
        used = any(self.time in group.argument.names() for group in self.groups)
        return bool(self.time) and (used or self.time in self.free)

    def products(self, moving: bool) -> Iterator[str]:
        """The generators at products that move, or at those that are constant."""
        for group in self.groups:
            if single_name(group.monomial) is None and self.moves(group) == moving:
                yield from group.moving

    def moves(self, group: Generators) -> bool:
        """Whether an argument has a name that is no constant."""
        return not {*self.constants}.issuperset(group.argument.names())

    @cached_property
    def roots(self) -> dict[str, Adjoined]:
        """The generators that are roots of others."""
        return {root.name: root for group in self.groups for root in group.roots()}

    @property
    def numbers(self) -> Iterator[str]:
        """The roots of numbers in the values at parts of π."""
        for group in self.groups:
            if group.kind.family.angles and self._is_pi(group):
                yield from {3: (r"\sqrt{3}",), 4: (r"\sqrt{2}",), 6: (r"\sqrt{3}",)}.get(
                    group.over, ()
                )

    @property
    def nonzero(self) -> Iterator[Formula]:
        """The generators that vanish nowhere."""
        for group in self.groups:
            yield from (group.values[letter] for letter in group.kind.family.nonzero)

    @cached_property
    def together(self) -> tuple[tuple[str, ...], ...]:
        """The generators at each argument."""
        return tuple(tuple(group.names.values()) for group in self.groups)

    def knows(self, formulas: Iterable[Formula], free: Iterable[str]) -> bool:
        """Whether formulas with such names outside of functions bring in nothing new."""
        beside = {self.time, *(n for group in self.groups for n in group.argument.names())}
        if not self.free.issuperset(beside & {*free}):
            return False
        known = {(g.kind, g.monomial): g.over for g in self.groups}
        for application in dict.fromkeys(one for f in formulas for one in applications(f)):
            kind = kind_of(application)
            for monomial, factor in self._argument(application).items():
                own, real, over = self._real(kind, monomial) or (kind, monomial, 1)
                if monomial and known.get((own, real), 0) % (over * factor.denominator):
                    return False
                if monomial and (own, real) not in known:
                    return False
        return True

    # -- values ------------------------------------------------------------------

    def __call__(self, formula: Application) -> Formula | None:
        """What a function means here; ``None`` for a function of no family.

        Raises :class:`Meaningless` for an argument at which it is not known.
        """
        if formula.function not in FAMILY_OF:
            return None
        kind = kind_of(formula)
        multiples: list[tuple[Generators | Imaginary, int]] = []
        for monomial, factor in self._argument(formula).items():
            group = self._group(kind, monomial)
            if group is None or (factor * group.over).denominator > 1:
                raise Meaningless(
                    f"{to_latex(formula)} is not known here: its argument has to be made of "
                    "variables and constants of the scene, with whole coefficients or fractions"
                )
            multiples.append((group, int(factor * group.over)))
        return kind.formula(MEANING[formula.function], self._at(kind, multiples))

    def _group(self, kind: Kind, monomial: Monomial) -> Generators | Imaginary | None:
        """The generators of a family at a product of names."""
        own, real, over = self._real(kind, monomial) or (kind, monomial, 0)
        found = next((g for g in self.groups if (g.kind, g.monomial) == (own, real)), None)
        if found is None or not over:
            return found
        return Imaginary(kind, found, found.over // over)

    def _values(self, group: Generators | Imaginary) -> dict[str, Formula]:
        """The generators at an argument; at a part of π they are known."""
        angles = group.kind.family.angles
        if isinstance(group, Imaginary) or not angles or not self._is_pi(group):
            return group.values
        if group.over not in angles:
            raise Meaningless(f"the values at {to_latex(group.argument)} are not known", PI)
        return {letter: template(tex) for letter, tex in angles[group.over].items()}

    def _is_pi(self, group: Generators) -> bool:
        """Whether an argument is a part of π, which moves nowhere."""
        return single_name(group.monomial) == PI and PI in self.constants

    def _at(
        self, kind: Kind, multiples: list[tuple[Generators | Imaginary, int]]
    ) -> dict[str, Formula]:
        """The generators of a family at a sum of multiples of arguments."""
        if not multiples:
            return {letter: template(tex) for letter, tex in kind.family.zero.items()}
        *before, (group, count) = multiples
        if not before and count == 1:
            return self._values(group)
        names = kind.names(total(multiple(group.argument, n) for group, n in multiples))
        if not {*names.values()} <= self.derived.keys():
            added, rest = count > 0, count - 1 if count > 0 else count + 1
            alone = not before and not rest
            right = self._values(group) if added else kind.opposite(self._values(group))
            if not alone:
                left = self._at(kind, [*before, (group, rest)] if rest else before)
                right = kind.sum(left, right)
            by = (kind.family, added, alone)
            self.derived |= {names[g]: Derived(right[g], by) for g in names}
        return {letter: Name(name) for letter, name in names.items()}

    # -- derivatives -------------------------------------------------------------

    def directions(self, name: str) -> dict[str, Formula]:
        """The derivatives by a name of all generators that have it in their arguments."""
        found: dict[str, Formula] = {}
        for group in self.groups:
            if name in group.argument.names():
                by = by_name(group.monomial, name)
                found |= {one: times(by, rate) for one, rate in group.rates().items()}
        return found
