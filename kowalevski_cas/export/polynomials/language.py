"""The few words that a program needs for computing with polynomials."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from fractions import Fraction


class Language(ABC):
    """The words; sums, products and powers are written as usual."""

    def holds(self, words: str, text: str, divisors: str) -> str:
        """Say the words if the expression vanishes wherever the divisors do not."""
        return f'holds("{words}", {text}, {divisors});'

    @abstractmethod
    def frame(self, generators: Sequence[str], body: str) -> str:
        """The whole file."""

    @abstractmethod
    def comment(self, words: str) -> str:
        """Words for a reader."""

    def number(self, value: Fraction) -> str:
        """A rational number."""
        return f"({value})"

    @abstractmethod
    def define(self, name: str, text: str) -> str:
        """A name for an expression, in which roots are reduced by their squares."""

    @abstractmethod
    def relation(self, root: str, square: str) -> str:
        """From here on this expression is the square of that generator."""

    @abstractmethod
    def divisors(self, name: str, pairs: Sequence[tuple[str, str]]) -> str:
        """A name for pairs: a generator, and the expression whose inverse it is."""

    def derivative(self, text: str, generator: str) -> str:
        """The partial derivative of an expression."""
        return f"diff({text}, {generator})"

    @abstractmethod
    def substitution(self, name: str, images: Mapping[str, str], generators: Sequence[str]) -> str:
        """A name for the map that takes generators to expressions, all at once."""
