"""The few words that a program needs for computing with polynomials."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import ClassVar


class Language(ABC):
    """The words, with braces for what stands in them; sums, products and powers are as usual."""

    comment: ClassVar[str]
    """Words for a reader."""
    holds: ClassVar[str] = 'holds("{}", {}, {});'
    """Say the words if the expression vanishes wherever the divisors do not."""
    define: ClassVar[str]
    """A name for an expression, in which roots are reduced by their squares."""
    relation: ClassVar[str]
    """From here on a generator is a root, and this expression its square."""
    divisors: ClassVar[str]
    """A name for a list of pairs."""
    pair: ClassVar[str] = "[{}, {}]"
    """A generator, and the expression whose inverse it is."""
    derivative: ClassVar[str] = "diff({}, {})"
    """The partial derivative of an expression by a generator."""

    @abstractmethod
    def frame(self, generators: Sequence[str], body: str) -> str:
        """The whole file."""

    def number(self, value: Fraction) -> str:
        """A rational number."""
        return f"({value})"

    @abstractmethod
    def substitution(self, name: str, images: Mapping[str, str], generators: Sequence[str]) -> str:
        """A name for the map that takes generators to expressions, all at once."""
