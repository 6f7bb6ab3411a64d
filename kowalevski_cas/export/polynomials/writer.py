"""The lines of a program while they are written, and the names that it uses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction

from kowalevski_cas.export.polynomials.language import Language
from kowalevski_cas.proof import checker


@dataclass(frozen=True)
class Value:
    """A number of a space: how the program writes it, and what the checker says that it is.

    What it is decides which lines are written, never whether they hold.
    """

    text: str
    element: checker.Element

    def __add__(self, other: Value) -> Value:
        return Value(f"({self.text}+{other.text})", self.element + other.element)

    def __sub__(self, other: Value) -> Value:
        return Value(f"({self.text}-{other.text})", self.element - other.element)

    def __mul__(self, other: Value) -> Value:
        return Value(f"({self.text}*{other.text})", self.element * other.element)

    def __pow__(self, exponent: int) -> Value:
        return Value(f"({self.text}^{exponent})", self.element**exponent)


@dataclass
class Writer:
    """Lines in the words of a language, and the generators of the ring in which they are meant."""

    language: Language
    generators: list[str] = field(default_factory=list)
    _lines: list[str | Callable[[], str]] = field(default_factory=list)
    _names: set[str] = field(default_factory=set)
    _checks: int = 0

    @property
    def text(self) -> str:
        """The whole file."""
        lines = (line if isinstance(line, str) else line() for line in self._lines)
        return self.language.frame(self.generators, lines)

    def say(self, line: str) -> None:
        """Write a line."""
        self._lines.append(line)

    def fresh(self, wish: str) -> str:
        """A name that is not taken, as near to the wish as can be."""
        while wish in self._names:
            wish += "_"
        self._names.add(wish)
        return wish

    def named(self, value: Value, wish: str = "t") -> Value:
        """The value under a name of its own."""
        name = self.fresh(wish if wish != "t" else f"t{len(self._lines)}")
        self.say(self.language.define(name, value.text))
        return Value(name, value.element)

    def holds(self, words: str, text: str, divisors: str) -> None:
        """Ask whether an expression vanishes wherever the divisors do not."""
        self._checks += 1
        self.say(self.language.holds(f"{self._checks} {words}", text, divisors))

    def substitution(self, images: dict[str, str]) -> str:
        """The name of a map of generators to expressions; the other generators stay."""
        name = self.fresh(f"m{len(self._lines)}")
        # A language may have to name all generators, and they are not all known yet.
        language, generators = self.language, self.generators
        self._lines.append(lambda: language.substitution(name, images, generators))
        return name

    def polynomial(self, element: checker.Element, at: dict[str, str]) -> str:
        """A polynomial of the checker, generators by their names."""
        summands = []
        for monomial, value in sorted(element.terms.items(), reverse=True):
            powers = (
                (name, monomial >> shift & checker.MASK) for name, shift in element.space.at.items()
            )
            factors = [f"{at[name]}^{e}" if e > 1 else at[name] for name, e in powers if e]
            summands.append(
                "*".join([self.language.number(Fraction(value, element.below)), *factors])
            )
        return f"({'+'.join(summands)})" if summands else self.language.number(Fraction(0))
