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

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property
from math import lcm
from typing import NamedTuple

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Number,
    Power,
    substitute,
    times,
    to_latex,
    total,
)
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

PI = r"\pi"


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
        printed: Iterable[tuple[Application, Formula]] = (),
    ) -> None:
        self.printed = dict(printed)
        self.free, self.time, self.expanded = frozenset(free), time, expanded
        self.variables, self.constants = (*variables, *([time] if time else [])), tuple(constants)
        known = {*self.variables, *constants}
        found: dict[tuple[Kind, Monomial], int] = {}
        integrals = set[tuple[Kind, Monomial]]()
        for application in self._applications(formulas):
            kind, argument = kind_of(application), self._argument(application)
            if not known.issuperset(n for monomial in argument for n in names_in(monomial)):
                continue
            if not all(is_arithmetic(formula) for monomial in argument for formula, _ in monomial):
                continue
            below = (name for one in kind.parameters for name in expanded(one).names())
            if not {*constants}.issuperset(below):
                continue  # what moves is no modulus: by it these functions are not derived
            for monomial, factor in argument.items():
                if monomial:
                    own, real, over = self._real(kind, monomial) or (kind, monomial, 1)
                    over *= factor.denominator
                    found[own, real] = lcm(found.get((own, real), 1), over)
                    if MEANING[application.function] in kind.family.integrals:
                        integrals.add((own, real))
        self.groups = tuple(Generators(*key, n, key in integrals) for key, n in found.items())
        self.derived: dict[str, Derived] = {}

    def _real(self, kind: Kind, monomial: Monomial) -> tuple[Kind, Monomial, int] | None:
        """What an imaginary argument is i times; ``None`` where i is no unit."""
        return real_part(kind, monomial) if "i" in self.constants else None

    def _applications(self, formulas: Iterable[Formula]) -> Iterator[Application]:
        """The functions in formulas; in the place of degenerate ones those that they are."""
        for application in dict.fromkeys(one for f in formulas for one in applications(f)):
            other = self._degenerate(application)
            yield from [application] if other is None else applications(other)

    def _degenerate(self, application: Application) -> Formula | None:
        """What a function is for a special modulus; ``None`` for any other one."""
        kind = kind_of(application)
        numbers = (combination(self.expanded(one)) for one in kind.parameters)
        special = tuple(sum(terms.values()) for terms in numbers if not any(terms))
        values = kind.family.degenerate.get(special)  # type: ignore[arg-type] # 1 is Fraction(1)
        if values is None:
            return None
        tex, argument = MEANING[application.function], {"x": application.arguments[0]}
        if not template(tex).names() <= values.keys():
            raise Meaningless(f"{to_latex(application)} is not known for this modulus")
        by = {letter: substitute(template(tex), argument) for letter, tex in values.items()}
        return kind.formula(tex, by)

    def _argument(self, application: Application) -> Combination:
        """The argument of a function, in which no name is a defined one."""
        return combination(self.expanded(application.arguments[0]))

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
        integrals = {(g.kind, g.monomial) for g in self.groups if g.integrals}
        for application in self._applications(formulas):
            kind = kind_of(application)
            for monomial, factor in self._argument(application).items():
                own, real, over = self._real(kind, monomial) or (kind, monomial, 1)
                if monomial and (own, real) not in known:
                    return False
                if monomial and known[own, real] % (over * factor.denominator):
                    return False
                integral = MEANING[application.function] in kind.family.integrals
                if integral and (own, real) not in integrals:
                    return False
        return True

    # -- values ------------------------------------------------------------------

    def __call__(self, formula: Application) -> Formula | None:
        """What a function means here; ``None`` for a function of no family.

        Raises :class:`Meaningless` for an argument at which it is not known.
        """
        if formula.function not in FAMILY_OF:
            return None
        if (other := self._degenerate(formula)) is not None:
            return other
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
        tex, values = MEANING[formula.function], self._at(kind, multiples)
        if not template(tex).names() <= {*values, *kind.family.parameters}:
            raise Meaningless(f"of {to_latex(formula)} no addition theorem is known")
        return kind.formula(tex, values)

    def _group(self, kind: Kind, monomial: Monomial) -> Generators | Imaginary | None:
        """The generators of a family at a product of names."""
        own, real, over = self._real(kind, monomial) or (kind, monomial, 0)
        found = next((g for g in self.groups if (g.kind, g.monomial) == (own, real)), None)
        if found is None or not over:
            return found
        return Imaginary(kind, found, found.over // over)

    def _values(self, group: Generators | Imaginary) -> dict[str, Formula]:
        """The generators at an argument; some are known at a part of π, or where it is printed."""
        angles = group.kind.family.angles
        if isinstance(group, Generators) and (values := self._printed(group)):
            if group.over > 1 or values.keys() != group.kind.family.rates.keys():
                raise Meaningless(f"print all values at {to_latex(group.argument)}")
            return values
        if isinstance(group, Imaginary) or not angles or not self._is_pi(group):
            return group.values
        if group.over not in angles:
            raise Meaningless(f"the values at {to_latex(group.argument)} are not known", PI)
        return {letter: template(tex) for letter, tex in angles[group.over].items()}

    def _printed(self, group: Generators) -> dict[str, Formula]:
        """The values of generators that the scene prints at a constant."""
        return {
            MEANING[one.function]: value
            for one, value in self.printed.items()
            if kind_of(one) == group.kind and self._argument(one).keys() == {group.monomial}
        }

    @property
    def known_squares(self) -> Iterator[tuple[Formula, Formula]]:
        """The squares of printed values, and what they have to be."""
        for group in self.groups:
            values = self._printed(group)
            for letter, tex in group.kind.family.squares.items() if values else ():
                yield Power(values[letter], Number(2)), group.kind.formula(tex, values)

    def _is_pi(self, group: Generators) -> bool:
        """Whether an argument is a part of π, which moves nowhere."""
        return single_name(group.monomial) == PI and PI in self.constants

    def _at(
        self, kind: Kind, multiples: list[tuple[Generators | Imaginary, int]]
    ) -> dict[str, Formula]:
        """The generators of a family at a sum of multiples of arguments."""
        if not multiples and kind.family.zero:
            return {letter: template(tex) for letter, tex in kind.family.zero.items()}
        *before, (group, count) = multiples
        if not before and count == 1:
            return self._values(group)
        if not kind.family.sum:
            raise Meaningless(f"no addition theorem is known at {to_latex(group.argument)}")
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
