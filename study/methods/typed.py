"""Formulas as people type them into SymPy with ``sqrt`` and ``I``, and simplified.

The space of a statement is evaluated in SymPy's expressions instead of polynomials: a root of
an expression is ``sqrt``; a variable whose square the paper prints, as
:math:`z_1^2+x_1y_2=c_1`, stays a symbol and the constant is replaced. Derivatives
are SymPy's own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

import sympy

from kowalevski_cas.algebra import EXACT, load
from kowalevski_cas.algebra.derivation import Field, along
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Problem
from kowalevski_cas.problem.space import Adjoined, Setting, generators
from study.labelled import Labelled, residuals
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.paper import exact
from study.process import limit_memory
from study.step import Measured

MEBIBYTES = 4096
"""The memory that a statement may take."""

CALLS: Mapping[str, Callable[[Any], bool | None]] = {
    "simplify": lambda e: bool(sympy.simplify(e) == 0),
    "expand": lambda e: bool(sympy.expand(e) == 0),
    "cancel": lambda e: bool(sympy.cancel(e) == 0),
    "ratsimp": lambda e: bool(sympy.ratsimp(e) == 0),
    "equals": lambda e: e.equals(0),
}
"""Whether an expression is zero, in the words of SymPy; ``equals`` may not know."""


class ByHand(Method):
    """One of the calls with which people ask SymPy whether something is zero."""

    def __init__(self, call: str, share: int | None = None) -> None:
        super().__init__(f"SymPy {call}", share)
        self.call = call

    def prepare(self, one: Labelled) -> Problem:
        CALLS[self.call](sympy.sqrt(sympy.Symbol("x")))  # its modules are loaded beforehand
        return one.statement.problem

    def answer(self, prepared: Problem) -> Measured:
        limit_memory(MEBIBYTES)  # of the process of this statement
        try:
            return decide(self.call, prepared)
        except MemoryError:
            return {"verdict": "timeout", "reason": f"{MEBIBYTES} MiB"}


def decide(call: str, problem: Problem) -> Measured:
    """Whether a call of SymPy finds that a problem of identities is true."""
    for residual in residuals(problem, cache(TypedEvaluation)):
        assert isinstance(residual, Expression)
        zero = CALLS[call](residual.value)
        if zero is None:
            return {"verdict": NONE, "reason": "it does not know"}
        if not zero:
            return {"verdict": REJECTED}
    return {"verdict": ACCEPTED}


class Expression(Element):
    """An expression of SymPy as an element of a ring."""

    __slots__ = ("value",)

    ring: Expressions  # type: ignore[assignment] # an expression lives in a ring of its own

    def __init__(self, ring: Expressions, value: Any) -> None:
        self.ring, self.value = ring, value

    @property
    def is_zero(self) -> bool:
        """Whether nothing is left after expansion; a residual is put to other methods."""
        return bool(sympy.expand(self.value) == 0)

    def _expression(self, value: Any) -> Expression:
        return Expression(self.ring, value)

    def __add__(self, other: Element) -> Expression:
        return self._expression(self.value + _value(other))

    def __sub__(self, other: Element) -> Expression:
        return self._expression(self.value - _value(other))

    def __neg__(self) -> Expression:
        return self._expression(-self.value)

    def __mul__(self, other: Element) -> Expression:
        return self._expression(self.value * _value(other))

    def __pow__(self, exponent: int) -> Expression:
        return self._expression(self.value**exponent)

    def inverse(self) -> Expression:
        return self._expression(1 / self.value)


def _value(element: Element) -> Any:
    assert isinstance(element, Expression)
    return element.value


@along.register
def _(element: Expression, field: Field) -> Expression:
    symbols = element.ring.symbols
    moving = [(symbols[name], _value(rate)) for name, rate in field.items() if name in symbols]
    terms = (sympy.diff(element.value, symbol) * rate for symbol, rate in moving)
    return Expression(element.ring, sum(terms, sympy.Integer(0)))


class Expressions:
    """What makes expressions; ``symbols`` are those that were typed, by name."""

    def __init__(self, names: Iterable[str]) -> None:
        self.symbols = {name: sympy.Symbol(name) for name in names}
        self.roots: tuple[str, ...] = ()
        self.zero, self.one = self.number(0), self.number(1)

    def number(self, value: int | Fraction) -> Expression:
        """A rational number."""
        return Expression(self, sympy.Rational(value.numerator, value.denominator))

    def generator(self, name: str) -> Expression:
        """A symbol."""
        return Expression(self, self.symbols[name])

    def adjoin(self, name: str, radicand: Expression) -> Expression:
        """What is typed for a root: the square root of the radicand."""
        return Expression(self, sympy.sqrt(radicand.value))


class TypedEvaluation(Evaluation):
    """A space, typed into SymPy."""

    def __init__(self, setting: Setting) -> None:
        replaced = _substitution(setting)
        names = [*(n for n in generators(setting) if n not in replaced.values()), *replaced]
        ring = Expressions(names)
        values = {name: ring.generator(name) for name in names}
        super().__init__(setting, load("sympy"), ring, values, TypedEvaluation)  # type: ignore[arg-type]
        for name, constant in replaced.items():
            step = setting.step(name)
            assert isinstance(step, Adjoined) and step.printed is not None
            left, right = step.printed
            other = left if right == Name(constant) else right
            self._values[constant, False] = self.scalar(other)

    def root(self, argument: Formula, conjugated: bool = False) -> Element:
        value = self.scalar(argument, conjugated)
        assert isinstance(value, Expression)
        return value.ring.adjoin("", value)

    def image(
        self, element: Element, value_of: Callable[[str], Element] | None = None
    ) -> Expression:
        assert isinstance(element, Expression)
        of = value_of or (lambda name: self.scalar(Name(name)))
        used = element.value.free_symbols
        images = {s: _value(of(n)) for n, s in element.ring.symbols.items() if s in used}
        return Expression(self.ring, element.value.xreplace(images))  # type: ignore[arg-type]

    def _rate_of_generator(self, name: str, rates: Field) -> Element:
        return rates[name]

    # Whether the space makes sense is no question to the call that is measured.

    def _check_root(self, name: str, rates: Field) -> None:
        """Nothing: an exact arithmetic has seen that a root moves as its square does."""

    @cached_property
    def time_sign(self) -> int:
        """What an exact arithmetic says."""
        return exact(EXACT[0])(self.setting).time_sign


def _substitution(setting: Setting) -> dict[str, str]:
    """Variables that are roots, with the constant that is replaced instead: a constant, once."""
    found: dict[str, str] = {}
    for name in setting.roots:
        step = setting.step(name)
        sides = step.printed or () if isinstance(step, Adjoined) else ()
        for side in sides:
            if isinstance(side, Name) and side.name in setting.constants:
                if side.name not in found.values():
                    found[name] = side.name
    return found
