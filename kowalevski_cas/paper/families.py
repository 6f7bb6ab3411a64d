r"""Functions of a family at one argument, in generators with names: :math:`\sin\theta`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum
from functools import cache
from typing import NamedTuple

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Quotient,
    Summation,
    Vocabulary,
    once,
    read,
    substitute,
    times,
    to_latex,
)
from kowalevski_cas.notation.functions import (
    AT_AMPLITUDE,
    FAMILY_OF,
    FUNCTIONS,
    ROTATED,
    Family,
    canonical,
)
from kowalevski_cas.paper.arguments import Monomial, product_of
from kowalevski_cas.paper.summation import expand_sum, without_sums
from kowalevski_cas.problem.space import Adjoined, Meaningless

ONE, PRIME = Number(1), "'"


class By(Enum):
    """By which theorem the generators at an argument are known."""

    SUM = "u+v"
    DIFFERENCE = "u-v"
    OPPOSITE = "-v"
    DOUBLE = "2v"
    IMAGINARY = "iv"


class Kind(NamedTuple):
    """A family, with what stands behind the argument."""

    family: Family
    parameters: tuple[Formula, ...]

    def formula(self, tex: str, values: Mapping[str, Formula]) -> Formula:
        """A formula of the family in other names."""
        bound = dict(zip(self.family.parameters, self.parameters, strict=True))
        return substitute(template(tex), {**bound, **values})

    def names(self, argument: Formula, integrals: bool = False) -> dict[str, str]:
        """The names of the generators at an argument, perhaps with those of their integrals."""
        if self.family.argument > 1:
            return {"e": rf"\mathrm{{e}}^{{{_over(argument, self.family.argument)}}}"}
        whole = [*self.parameters]
        whole.insert(self.family.place, argument)
        tex = ",".join(map(to_latex, whole))
        bare = not self.parameters and not self.family.is_explicit
        inside = tex if bare and isinstance(argument, Name | Quotient) else f"({tex})"
        words = {
            letter: canonical(name.split()[0]) for name, letter in self.family.functions.items()
        }
        printed = {g: name.replace("(x)", inside) for g, name in self.family.printed.items()}
        letters = [*self.family.rates, *(self.family.integrals if integrals else ())]
        return {g: printed.get(g) or f"{words[g]}{{{inside}}}" for g in letters}

    def rates(
        self, names: Mapping[str, str], over: int = 1, argument: Formula = ONE
    ) -> dict[str, Formula]:
        """The derivatives of generators with some names by what their argument is, ``over`` it."""
        below = Number(over * self.family.argument)
        values = {letter: Name(name) for letter, name in names.items()} | {"x": argument}
        found = {}
        for letter in names:
            rate = self.formula({**self.family.rates, **self.family.integrals}[letter], values)
            found[names[letter]] = rate if below == ONE else Quotient(rate, below)
        return found

    def rates_by(
        self, parameter: str, names: Mapping[str, str], argument: Formula
    ) -> dict[str, Formula]:
        """The derivatives of generators with some names by a parameter, where they are known."""
        values = {letter: Name(name) for letter, name in names.items()} | {"x": argument}
        known = self.family.by.get(parameter, {}).items()
        return {names[letter]: self.formula(tex, values) for letter, tex in known}

    def opposite(self, values: Mapping[str, Formula]) -> dict[str, Formula]:
        """The generators at the opposite argument."""
        changed = {letter: self.formula(tex, values) for letter, tex in self.family.minus.items()}
        return {**values, **changed}

    def sum(self, left: Mapping[str, Formula], right: Mapping[str, Formula]) -> dict[str, Formula]:
        """The generators at the sum of two arguments."""
        values = {**left, **{f"{letter}_1": value for letter, value in right.items()}}
        return {letter: self.formula(tex, values) for letter, tex in self.family.sum.items()}

    def double(self, values: Mapping[str, Formula]) -> dict[str, Formula]:
        """The generators at twice an argument."""
        if not self.family.double:
            return self.sum(values, values)
        return {letter: self.formula(tex, values) for letter, tex in self.family.double.items()}


def _over(argument: Formula, number: int) -> str:
    """An argument over a number, on one line if it is a name."""
    match argument:
        case Name(name):
            return f"{name}/{number}"
        case Quotient(Name(name), Number(below)):
            return f"{name}/{below * number}"
    return to_latex(Quotient(argument, Number(number)))


class Imaginary(NamedTuple):
    """The generators of a family at i times an argument, by those of the other one at it."""

    kind: Kind
    real: Generators
    over: int

    @property
    def argument(self) -> Formula:
        """Where they are taken."""
        return times(Name("i"), product_of(self.real.monomial, self.over))

    def values(self, real: Mapping[str, Formula]) -> dict[str, Formula]:
        """Their values by those of the others, by the formulas of Euler and Jacobi."""
        formulas = self.kind.family.imaginary.items()
        return {letter: self.kind.formula(tex, real) for letter, tex in formulas}


class PrintedValue(NamedTuple):
    """The generators of a family at a constant where their values are printed."""

    argument: Formula
    values: dict[str, Formula]


def real_part(kind: Kind, monomial: Monomial) -> tuple[Kind, Monomial, int] | None:
    """What an imaginary argument is i times, with the family of which functions stand there.

    They are taken at the argument over a number as well. ``None`` for any other argument.
    """
    if (Name("i"), 1) not in monomial or kind.family not in ROTATED:
        return None
    rest = tuple(part for part in monomial if part[0] != Name("i"))
    return rotated(kind), rest, kind.family.argument


def rotated(kind: Kind) -> Kind:
    """The family of which functions stand at a real argument, for an imaginary one."""
    return Kind(ROTATED[kind.family], tuple(map(complementary, kind.parameters)))


def complementary(modulus: Formula) -> Name:
    """The complementary modulus: k' for k, and k for k'.

    Raises :class:`Meaningless` for a modulus that is no name.
    """
    match modulus:
        case Name(name):
            return Name(name.removesuffix(PRIME) if name.endswith(PRIME) else name + PRIME)
    raise Meaningless(f"print the functions of the complementary modulus of {to_latex(modulus)}")


@cache
def template(tex: str) -> Formula:
    """A formula of the table of functions."""
    letters = (*"acdeiknpqrstwxz", *(f"{letter}_1" for letter in "cderst"), "g_2", "g_3")
    return read(tex, Vocabulary(frozenset(letters), functions=FUNCTIONS))


class Generators(NamedTuple):
    """The generators of a family at a product of names, over a whole number."""

    kind: Kind
    monomial: Monomial
    over: int
    integrals: bool = False
    """Whether those are among them that are integrals of the others."""

    @property
    def argument(self) -> Formula:
        """Where they are taken."""
        return product_of(self.monomial, self.over)

    @property
    def names(self) -> dict[str, str]:
        """Their names, by their letters in the family."""
        return self.kind.names(self.argument, self.integrals)

    @property
    def values(self) -> dict[str, Formula]:
        """Their names as formulas."""
        return {letter: Name(name) for letter, name in self.names.items()}

    @property
    def moving(self) -> tuple[str, ...]:
        """Those that are no roots."""
        return tuple(
            n for letter, n in self.names.items() if letter not in self.kind.family.squares
        )

    def roots(self) -> Iterator[Adjoined]:
        """Those that are roots of others."""
        for letter, tex in self.kind.family.squares.items():
            yield Adjoined(self.names[letter], self.kind.formula(tex, self.values))

    def rates(self) -> dict[str, Formula]:
        """Their derivatives by the product of names."""
        return self.kind.rates(self.names, self.over, self.argument)

    def rates_by(self, parameter: str) -> dict[str, Formula]:
        """Their derivatives by a parameter, where these are known."""
        return self.kind.rates_by(parameter, self.names, self.argument)


def split_arguments(formula: Application) -> tuple[Formula, list[Formula]]:
    """The argument of a function of a family, and the parameters that are printed with it."""
    parameters = [*formula.arguments]
    argument = parameters.pop(FAMILY_OF[formula.function].place if parameters[1:] else 0)
    return argument, parameters


def kind_of(formula: Application) -> Kind:
    """The family of a function, with its parameters: if none is printed, the usual letters.

    Raises :class:`Meaningless` if only some are printed, or too many.
    """
    family, (_, parameters) = FAMILY_OF[formula.function], split_arguments(formula)
    if parameters and len(parameters) != len(family.parameters):
        what = f"one argument, and {', '.join(family.parameters) or 'no more'}"
        raise Meaningless(f"{to_latex(formula)}: print {what}", formula.function)
    return Kind(family, tuple(parameters) or tuple(map(Name, family.parameters)))


@once
def applications(formula: Formula) -> tuple[Application, ...]:
    """The functions of known families in a formula."""
    nodes = without_sums(formula).nodes()
    found = (n for n in nodes if isinstance(n, Application) and not of_amplitude(n))
    return tuple(
        dict.fromkeys(application for application in found if application.function in FAMILY_OF)
    )


def of_amplitude(formula: Formula) -> bool:
    """Whether it is an incomplete integral at an amplitude: only its derivative is known."""
    match formula:
        case Application(function, (Application(r"\mathrm{am}"), *parameters)):
            return function in AT_AMPLITUDE and bool(parameters)
    return False


@once
def outside(formula: Formula) -> frozenset[str]:
    """The names that stand outside of functions, and are not only derived by the time."""
    match formula:
        case Name(name):
            return frozenset([name])
        case Application(function) if function in FAMILY_OF:
            return frozenset[str]().union(*map(outside, split_arguments(formula)[1]))
        case Summation(_, Number(), Number()):
            return outside(expand_sum(formula))
        case Derivative(Name()):
            return frozenset()
        case Derivative(argument):
            return outside(argument)
    return frozenset[str]().union(*map(outside, formula.children()))
