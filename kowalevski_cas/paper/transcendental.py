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

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from math import lcm
from types import MappingProxyType
from typing import NamedTuple

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Sum,
    substitute,
    to_latex,
    total,
)
from kowalevski_cas.notation.functions import FAMILY_OF, MEANING, Family
from kowalevski_cas.paper.arguments import (
    Combination,
    Monomial,
    combination,
    is_arithmetic,
    multiple,
    names_in,
    single_name,
)
from kowalevski_cas.paper.families import (
    By,
    Generators,
    Imaginary,
    Kind,
    PrintedValue,
    applications,
    complementary,
    kind_of,
    real_part,
    split_arguments,
    template,
)
from kowalevski_cas.paper.known_values import KnownValues
from kowalevski_cas.paper.phases import Phases
from kowalevski_cas.problem.space import Adjoined, Meaningless

PI = r"\pi"


class Derived(NamedTuple):
    """A generator by others, as the theorem on its family says it."""

    formula: Formula
    family: Family
    by: By


class Transcendental:
    """The functions in some formulas, of which the names are known to be ``variables`` or not.

    ``free`` are names that stand by themselves as well, outside of functions; the ``time`` is none
    of the variables, and ``radicals`` are roots, with the names on which they rest; of what is
    complex, with its ``conjugates``, a function stands at real products only. Calling it writes a
    function out in generators.
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
        radicals: Mapping[str, frozenset[str]] = MappingProxyType({}),
        conjugates: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        self.radicals, self.conjugates = radicals, conjugates
        self.free, self.time, self.expanded = frozenset(free), time, expanded
        self.phases: dict[Kind, Phases] = {}
        self.known = KnownValues(printed, self._argument)
        self.variables, self.constants = (*variables, *([time] if time else [])), tuple(constants)
        read = [
            application
            for application in self._applications(formulas)
            if self._is_read(application)
        ]
        arguments: dict[Kind, dict[Formula, Combination]] = {}
        for one in read:
            argument, _ = split_arguments(one)
            whole = self.expanded(argument)
            printed_as = whole if isinstance(argument, Name) else argument
            arguments.setdefault(kind_of(one), {})[printed_as] = combination(whole)
        self.phases = {
            kind: Phases(of, self._is_phase(kind), self._is_value(kind))
            for kind, of in arguments.items()
        }
        self._rotated: dict[Formula, None] = {}
        found: dict[tuple[Kind, Monomial], int] = {}
        integrals = set[tuple[Kind, Monomial]]()
        for application in read:
            kind = kind_of(application)
            for monomial, factor in self._argument(application).items():
                if monomial and (kind, monomial) not in self.known:
                    own, real, over = self._real(kind, monomial) or (kind, monomial, 1)
                    self._rotated |= dict.fromkeys(own.parameters if real != monomial else ())
                    # addition theorems give whole multiples only: both θ/2 and θ/3 are such of θ/6
                    over *= factor.denominator
                    found[own, real] = lcm(found.get((own, real), 1), over)
                    if MEANING[application.function] in kind.family.integrals:
                        integrals.add((own, real))
        self.groups = tuple(Generators(*key, n, key in integrals) for key, n in found.items())
        self.derived: dict[str, Derived] = {}

    def _is_read(self, application: Application) -> bool:
        """Whether a function stands at names that are known, with a modulus that is constant."""
        argument = combination(self.expanded(split_arguments(application)[0]))
        below = {
            n
            for parameter in kind_of(application).parameters
            for n in self.expanded(parameter).names()
        }
        return (
            all(map(is_arithmetic, (formula for monomial in argument for formula, _ in monomial)))
            and {*self.variables, *self.constants}.issuperset(
                name for monomial in argument for name in self._names_in(monomial)
            )
            and below.issubset(self.constants)  # by what moves these functions are not derived
        )

    def _names_in(self, monomial: Monomial) -> Iterator[str]:
        r"""The names in a product, without those that are real together, as :math:`z\bar z`."""
        exponents = dict(monomial)
        for formula, exponent in monomial:
            other = self.conjugates.get(formula.name) if isinstance(formula, Name) else None
            if other is None or exponents.get(Name(other)) != exponent:
                yield from formula.names()

    def _is_value(self, kind: Kind) -> Callable[[Monomial], bool]:
        """Whether the functions at a term are known."""

        def is_value(term: Monomial) -> bool:
            return (kind, term) in self.known or (single_name(term) == PI and PI in self.constants)

        return is_value

    def _is_phase(self, kind: Kind) -> Callable[[frozenset[Monomial]], bool]:
        """Whether one of some terms moves, and it is no angle."""

        def is_phase(terms: frozenset[Monomial]) -> bool:
            names = {name for term in terms for name in names_in(term)}
            if () in terms or not names.isdisjoint({PI, "i"} & {*self.constants}):
                return False
            moving = [term for term in terms if not {*self.constants}.issuperset(names_in(term))]
            return len(moving) == 1 and not (kind.family.covers and single_name(moving[0]))

        return is_phase

    @property
    def equations(self) -> Iterator[tuple[Formula, Formula]]:
        """What values that are printed have to obey, and complementary moduli."""
        yield from self.known.equations(self._at)
        for modulus in self._rotated:
            square = Power(complementary(modulus), Number(2))
            yield square, Sum((Number(1), Negative(Power(modulus, Number(2)))))

    def _real(self, kind: Kind, monomial: Monomial) -> tuple[Kind, Monomial, int] | None:
        """What an imaginary argument is i times; ``None`` where i, or k', is not printed."""
        found = real_part(kind, monomial) if "i" in self.constants else None
        below = {
            name
            for parameter in (found[0].parameters if found else ())
            for name in parameter.names()
        }
        return found if below.issubset(self.constants) else None

    def _applications(self, formulas: Iterable[Formula]) -> Iterator[Application]:
        """The functions in formulas and in their rates; for degenerate ones what they are."""
        for application in dict.fromkeys(
            application for f in formulas for application in applications(f)
        ):
            other = self._degenerate(application)
            if other is None:
                yield application
                argument, kind = split_arguments(application)[0], kind_of(application)
                other = total(kind.rates(kind.names(argument), 1, argument).values())
            yield from applications(other)

    def _degenerate(self, application: Application) -> Formula | None:
        """What a function is for a special modulus; ``None`` for any other one."""
        kind = kind_of(application)
        numbers = (combination(self.expanded(parameter)) for parameter in kind.parameters)
        special = tuple(sum(terms.values()) for terms in numbers if not any(terms))
        values = kind.family.degenerate.get(special)  # type: ignore[arg-type] # 1 is Fraction(1)
        if values is None:
            return None
        tex, argument = MEANING[application.function], {"x": split_arguments(application)[0]}
        if not template(tex).names() <= values.keys():
            raise Meaningless(f"{to_latex(application)} is not known for this modulus")
        by = {letter: substitute(template(tex), argument) for letter, tex in values.items()}
        return kind.formula(tex, by)

    def _argument(self, application: Application) -> Combination:
        """The argument of a function, in which no name is a defined one."""
        argument, kind = split_arguments(application)[0], kind_of(application)
        whole = combination(self.expanded(argument))
        return self.phases[kind](whole) if kind in self.phases else whole

    @cached_property
    def names_replaced(self) -> frozenset[str]:
        """The names in whose place generators stand."""
        alone = {single_name(group.monomial) for group in self.groups}
        used = {
            n
            for g in self.groups
            if single_name(g.monomial) is None or g.kind.family.is_explicit
            for n in self.names_under(g)
        }
        return frozenset(name for name in alone - used - self.free - self.radicals.keys() if name)

    @cached_property
    def dependent(self) -> frozenset[str]:
        """The generators, and the names in them, that do not take all values by themselves."""
        found = set[str]()
        for group in self.groups:
            name = single_name(group.monomial)
            # sin x takes all its values and so does eˣ, but not both at one x
            beside = sum(single_name(other.monomial) == name for other in self.groups)
            if name not in self.names_replaced or beside > 1 or not group.kind.family.covers:
                below = (n for parameter in group.kind.parameters for n in parameter.names())
                found.update(group.names.values(), self.names_under(group), below)
        return frozenset(found.union(self.known.names()))

    @cached_property
    def functions_beside(self) -> dict[str, str]:
        """The generators at names that stand by themselves as well, with these names."""
        groups = ((group, single_name(group.monomial)) for group in self.groups)
        return {
            generator: name
            for group, name in groups
            if name and name not in self.names_replaced
            for generator in group.names.values()
        }

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
        used = any(self.time in self.names_under(group) for group in self.groups)
        return bool(self.time) and (used or self.time in self.free)

    def products(self, moving: bool) -> Iterator[str]:
        """The generators at products and roots that move, or at those that are constant."""
        for group in self.groups:
            alone = single_name(group.monomial)
            if (alone is None or alone in self.radicals) and self.moves(group) == moving:
                yield from group.moving

    def moves(self, group: Generators) -> bool:
        """Whether an argument has a name that is no constant."""
        return not {*self.constants}.issuperset(self.names_under(group))

    def names_under(self, group: Generators) -> frozenset[str]:
        """The names of which an argument is made, and the roots in it."""
        found = frozenset(self.expanded(group.argument).names())
        return found.union(*(self.radicals.get(name, ()) for name in found))

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
        beside = {self.time, *(n for group in self.groups for n in self.names_under(group))}
        if not self.free.issuperset(beside & {*free}):
            return False
        known = {(g.kind, g.monomial): g.over for g in self.groups}
        integrals = {(g.kind, g.monomial) for g in self.groups if g.integrals}
        for application in self._applications(formulas):
            kind = kind_of(application)
            for monomial, factor in self._argument(application).items():
                if (kind, monomial) in self.known:
                    continue
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
        if not formula.arguments[1:] and not {*self.constants}.issuperset(kind.family.parameters):
            what = f"print {', '.join(kind.family.parameters)} behind the argument, or declare it"
            raise Meaningless(f"{to_latex(formula)}: {what}", formula.function)
        argument = self._argument(formula).items()
        multiples = [self._multiple(kind, *term, formula) for term in argument]
        tex, values = MEANING[formula.function], self._at(kind, multiples)
        if not template(tex).names() <= {*values, *kind.family.parameters}:
            raise Meaningless(f"of {to_latex(formula)} no addition theorem is known")
        return kind.formula(tex, values)

    def _multiple(
        self, kind: Kind, monomial: Monomial, factor: Fraction, formula: Application
    ) -> tuple[Generators | Imaginary | PrintedValue, int]:
        """Generators at a part of a term in an argument, and how often it is taken."""
        if (kind, monomial) in self.known:
            return self.known.multiple((kind, monomial), factor)
        group = self._group(kind, monomial)
        if group is None or (factor * group.over).denominator > 1:
            raise Meaningless(
                f"{to_latex(formula)} is not known here: its argument has to be made of "
                "variables and constants of the scene, with whole coefficients or fractions"
            )
        return group, int(factor * group.over)

    def _group(self, kind: Kind, monomial: Monomial) -> Generators | Imaginary | None:
        """The generators of a family at a product of names."""
        own, real, over = self._real(kind, monomial) or (kind, monomial, 0)
        found = next((g for g in self.groups if (g.kind, g.monomial) == (own, real)), None)
        if found is None or not over:
            return found
        return Imaginary(kind, found, found.over // over)

    def _values(self, group: Generators | Imaginary | PrintedValue) -> dict[str, Formula]:
        """The generators at an argument; those at a part of π are known."""
        if isinstance(group, Imaginary):
            values = group.values(self._values(group.real))
            return self._derive(group.kind, group.argument, values, By.IMAGINARY)
        if not isinstance(group, Generators):
            return group.values
        angles = group.kind.family.angles
        if not angles or not self._is_pi(group):
            return group.values
        if group.over not in angles:
            raise Meaningless(f"the values at {to_latex(group.argument)} are not known", PI)
        return {letter: template(tex) for letter, tex in angles[group.over].items()}

    def _is_pi(self, group: Generators) -> bool:
        """Whether an argument is a part of π, which moves nowhere."""
        return single_name(group.monomial) == PI and PI in self.constants

    def _at(
        self, kind: Kind, multiples: Sequence[tuple[Generators | Imaginary | PrintedValue, int]]
    ) -> dict[str, Formula]:
        """The generators of a family at a sum of multiples of arguments."""
        if not multiples and kind.family.zero:
            return {letter: template(tex) for letter, tex in kind.family.zero.items()}
        *before, (group, count) = multiples
        if not before and count == 1:
            return self._values(group)
        if not kind.family.sum:
            raise Meaningless(f"no addition theorem is known at {to_latex(group.argument)}")
        argument = total(multiple(group.argument, n) for group, n in multiples)
        added, rest = count > 0, count - 1 if count > 0 else count + 1
        right = self._values(group) if added else kind.opposite(self._values(group))
        if not before and not rest:
            return self._derive(kind, argument, right, By.OPPOSITE)
        left = self._at(kind, [*before, (group, rest)] if rest else before)
        # at two equal arguments the addition theorem of ℘ divides by zero
        if kind.family.double and not before and abs(rest) == 1:
            return self._derive(kind, argument, kind.double(left), By.DOUBLE)
        by = By.SUM if added else By.DIFFERENCE
        return self._derive(kind, argument, kind.sum(left, right), by)

    def _derive(
        self, kind: Kind, argument: Formula, values: Mapping[str, Formula], by: By
    ) -> dict[str, Formula]:
        """The generators at an argument, by names that stand for their values."""
        names, family = kind.names(argument), kind.family
        self.derived |= {name: Derived(values[g], family, by) for g, name in names.items()}
        return {letter: Name(name) for letter, name in names.items()}
