"""The same operations on polynomials without anything around them, as a program for others.

The growing work is done once with polynomials that keep a list of what is done to them. The
list is then written out for python-flint, Singular or PARI/GP, and timed there.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from operator import add, mul, neg, sub
from time import process_time
from typing import Any

from kowalevski_cas.algebra.flint import Arithmetic as Flint
from kowalevski_cas.algebra.polynomials import Coefficients, Map, Polynomials, Terms
from kowalevski_cas.tools import TOOLS
from study.growth.work import growth

Line = tuple[Any, ...]
"""What is done: its name, the number of the polynomial that it makes or asks about, and of what."""


class Recorded:
    """A polynomial of python-flint that lists what is done to it."""

    __slots__ = ("lines", "number", "value")

    def __init__(self, lines: list[Line], value: Any, name: str, *arguments: Any) -> None:
        self.lines, self.value, self.number = lines, value, len(lines)
        lines.append((name, self.number, *arguments))

    def __del__(self) -> None:
        self.lines.append(("forget", self.number))

    def _record(self, name: str, function: Callable[..., Any], *others: Recorded) -> Recorded:
        value = function(self.value, *(other.value for other in others))
        return Recorded(self.lines, value, name, self.number, *(o.number for o in others))

    def __add__(self, other: Recorded) -> Recorded:
        return self._record("add", add, other)

    def __sub__(self, other: Recorded) -> Recorded:
        return self._record("subtract", sub, other)

    def __mul__(self, other: Recorded) -> Recorded:
        return self._record("multiply", mul, other)

    def __neg__(self) -> Recorded:
        return self._record("negate", neg)

    def __bool__(self) -> bool:
        if not self.value:
            self.lines.append(("zero", self.number))
        return bool(self.value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Recorded) and bool(self.value == other.value)


class Recording(Polynomials):
    """The arithmetic of FLINT, with a list of all that is done."""

    name = "recording"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        self.plain = Flint(generators)
        self.lines: list[Line] = []
        self.zero, self.one = self._leaf(self.plain.zero), self._leaf(self.plain.one)

    def _leaf(self, value: Any) -> Recorded:
        return Recorded(self.lines, value, "define", self.plain.terms(value))

    def generator(self, index: int) -> Recorded:
        return self._leaf(self.plain.generator(index))

    def constant(self, value: int | Fraction) -> Recorded:
        return self._leaf(self.plain.constant(value))

    def derivative(self, polynomial: Recorded, index: int) -> Recorded:
        value = self.plain.derivative(polynomial.value, index)
        return Recorded(self.lines, value, "derive", polynomial.number, index)

    def substitution(self, values: Sequence[Recorded], target: Polynomials) -> Map:
        raise NotImplementedError("the growing work has no points")

    def is_monomial(self, polynomial: Recorded) -> bool:
        return self.plain.is_monomial(polynomial.value)

    def occurring_places(self, polynomial: Recorded) -> Collection[int]:
        return self.plain.occurring_places(polynomial.value)

    def terms(self, polynomial: Recorded) -> Terms:
        return self.plain.terms(polynomial.value)

    def from_terms(self, terms: Coefficients) -> Recorded:
        return self._leaf(self.plain.from_terms(terms))


@cache
def record_steps(claim: str, most: int, seconds: float) -> tuple[tuple[str, ...], list[Line]]:
    """The generators, and what is done up to the step that so many seconds reach."""
    work = growth(claim, Recording)
    arithmetic = work.at.ring.polynomials
    assert isinstance(arithmetic, Recording)
    work.at.rates  # noqa: B018 (they are derived before the clock starts)
    arithmetic.lines.append(("start",))
    start = process_time()
    for k in range(1, most + 1):
        if not work.step():
            break
        arithmetic.lines.append(("step", k))
        if process_time() - start > seconds:
            break
    return arithmetic.generators, list(arithmetic.lines)


# -- as a program --------------------------------------------------------------------


@dataclass(frozen=True)
class Language:
    """How a program says what is done to the polynomials ``p1``, ``p2``, …: a template a line."""

    call: Callable[[], Sequence[str]]
    suffix: str
    begin: str
    define: str
    derive: str
    forget: str
    zero: str
    start: str
    step: str
    end: str = "quit;"
    power: str = "^"
    number: str = "({p}/{q})"


LINE_BY_LINE = "import sys\nfor line in open(sys.argv[1]): exec(line)"
"""Python reads a program as the others do: a line, which it does, and then the next."""

LANGUAGES = {
    "python-flint": Language(
        call=lambda: (sys.executable, "-c", LINE_BY_LINE),
        suffix=".py",
        begin="from time import process_time\nfrom flint import *\n"
        "{names}, = fmpq_mpoly_ctx.get({strings}, Ordering.lex).gens()",
        define="p{n} = {text}",
        derive="p{a}.derivative({b})",
        forget="del p{n}",
        zero="if p{n}: print('fails')",
        start="clock = process_time()",
        step="print('step', {n}, process_time() - clock, flush=True)",
        end="",
        power="**",
        number="fmpq({p}, {q})",
    ),
    "singular": Language(
        call=lambda: (*TOOLS["singular"].call(), "--quiet", "--no-rc", "--no-warn"),
        suffix=".sing",
        begin='ring R = 0, ({names}), dp;\nsystem("--ticks-per-sec", 1000);',
        define="poly p{n} = {text};",
        derive="diff(p{a}, g{b})",
        forget="kill p{n};",
        zero='if (p{n} != 0) {{ "fails"; }}',
        start="int clock = timer;",
        step='"step {n} " + string(timer - clock) + "e-3";',
    ),
    "pari": Language(
        call=lambda: (*TOOLS["pari"].call(), "--quiet", "--fast", "--default", "parisize=2G"),
        suffix=".gp",
        begin="[{names}];",
        define="p{n} = {text};",
        derive="deriv(p{a}, g{b})",
        forget="kill(p{n});",
        zero='if(p{n} != 0, print("fails"));',
        start="clock = getabstime();",
        step='print("step {n} ", getabstime() - clock, "e-3");',
    ),
}
"""The programs to which the work is given."""

_MADE = {
    "add": "p{a} + p{b}",
    "subtract": "p{a} - p{b}",
    "multiply": "p{a}*p{b}",
    "negate": "-p{a}",
}


def program(language: Language, generators: Sequence[str], lines: Iterable[Line]) -> str:
    """The text of a program that does what is listed, and tells its time at each step.

    What comes from outside is defined before the clock starts.
    """
    names = [f"g{index}" for index in range(len(generators))]
    first = language.begin.format(names=", ".join(names), strings=names)
    given, rest = [first], []
    for name, *numbers in lines:
        if name == "define":
            text = polynomial(numbers[1], names, language)
            given.append(language.define.format(n=numbers[0], text=text))
            continue
        n, a, b = (*numbers, None, None, None)[:3]
        made = language.derive if name == "derive" else _MADE.get(name)
        if made is not None:
            rest.append(language.define.format(n=n, text=made.format(a=a, b=b)))
        else:
            rest.append(getattr(language, name).format(n=n))
    return "\n".join([*given, *rest, language.end, ""])


def polynomial(terms: Terms, names: Sequence[str], language: Language) -> str:
    """A polynomial in the words of a program."""
    summands = [f"0*{names[0]}"]  # a number is a polynomial too
    for exponents, value in terms.items():
        factors = [f"{n}{language.power}{e}" for n, e in zip(names, exponents, strict=True) if e]
        number = language.number.format(p=value.numerator, q=value.denominator)
        summands.append("*".join([number, *factors]))
    return " + ".join(summands)
