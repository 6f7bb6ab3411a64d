"""Formula to one line of Unicode, for a terminal."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Sequence
from functools import cache

from kowalevski_cas.notation.decorations import ACCENTS, RATES, raised_sign
from kowalevski_cas.notation.formula import (
    Conjugate,
    CrossProduct,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Quotient,
    Radical,
    Root,
)
from kowalevski_cas.notation.printer import Printer
from kowalevski_cas.notation.unicode import glyphs, styled_letter

_LOW = str.maketrans("0123456789+-aehijklmnoprstuvxβγρφχ", "₀₁₂₃₄₅₆₇₈₉₊₋ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ")
_HIGH = str.maketrans("0123456789+−in", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁱⁿ")
_MARKS = {macro: accent.plain for macro, accent in (ACCENTS | RATES).items()}
_DOT, _BAR = "\u0307", "\u0304"


class PlainText(Printer):
    """Fractions have a slash, and brackets where it would reach too far."""

    minus, times, cross, prime, partial_d = "−", "·", "×", "′", "∂"
    dots, const, braces = "…", "const", ("{", "}")
    word_form, fraction_form, sum_form = "{}", "{}/{}", "∑_({}={})^({}) "

    def name(self, formula: Name) -> str:
        return _name_under(formula.name)

    def side_by_side(self, parts: Iterable[str]) -> str:
        """The parts side by side; words, and roots without brackets, need a space."""
        joined = before = ""
        for part in parts:
            words = before and part[:1].isalpha() and (_word(before) or _word(part[:2]))
            open_root = before[:1] == "√" and before[-1] != ")"
            joined += (" " if words or open_root else "") + part
            before = part
        return joined

    def factor(self, formula: Formula) -> str:
        return self.enclose(formula) if _has_slash(formula) else super().factor(formula)

    def quotient(self, formula: Quotient) -> str:
        above = formula.numerator
        apart = _has_slash(above) or isinstance(above, CrossProduct)
        text = self.enclose(above) if apart else self.term(above)
        return self.fraction(text, self.factor(formula.denominator))

    def superscript(self, base: str, exponent: str) -> str:
        high = exponent.translate(_HIGH)
        if not set(exponent) & set(high):
            return base + high
        return f"{base}^{exponent}" if len(exponent) == 1 else f"{base}^({exponent})"

    def root(self, formula: Root) -> str:
        text = self(formula.argument)
        simple = isinstance(formula.argument, Name | Number)
        return f"√{text}" if simple else f"√({text})"

    def radical(self, formula: Radical) -> str:
        return str(formula.order).translate(_HIGH) + self.root(Root(formula.argument))

    def conjugate(self, formula: Conjugate) -> str:
        if isinstance(formula.argument, Name):
            return _name_under(formula.argument.name, _BAR)
        return f"conj({self(formula.argument)})"

    def with_dots(self, argument: Formula, order: int) -> str:
        if isinstance(argument, Name):
            return _name_under(argument.name, _DOT * order)
        return self.enclose(argument) + "˙" * order

    def rows(self, rows: Sequence[Sequence[str]]) -> str:
        return f"({', '.join(f'({text})' for text in map(', '.join, rows))})"


@cache
def _name_under(name: str, marks: str = "") -> str:
    """A letter under marks, with its index."""
    parts = glyphs(name)
    letter = styled_letter(parts.letter, parts.font)
    index = "".join(parts.indices)
    low = index.translate(_LOW)
    if set(index) & set(low):
        low = f"_{index}" if len(index) == 1 else f"_({index})"
    above = "".join(_MARKS[accent] for accent in reversed(parts.accents)) + marks
    above = above.replace(2 * _DOT, _MARKS[r"\ddot"])
    raised = raised_sign(parts.raised).plain if parts.raised else ""
    return unicodedata.normalize("NFC", letter + above) + low + raised + parts.primes


def _word(text: str) -> bool:
    """Whether a factor is a word, or a power of one."""
    letters = text.rstrip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁱⁿ")
    return len(letters) > 1 and letters.isalpha()


def _has_slash(formula: Formula) -> bool:
    """Whether a slash stands in the formula outside all brackets, and is no exponent."""
    written = isinstance(formula, Derivative) and formula.mark not in ("dot", "prime")
    return written or isinstance(formula, Quotient | Partial)


_PRINTER = PlainText()


def to_plain(formula: Formula) -> str:
    r"""The formula as one line of text.

    >>> to_plain(Quotient(Name(r"\omega_1"), Root(Name("x"))))
    'ω₁/√x'
    """
    return _PRINTER(formula)
