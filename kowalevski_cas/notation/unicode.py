r"""Names and signs in Unicode, for the printers that do not write TeX."""

from __future__ import annotations

import re
import unicodedata
from functools import cache
from typing import NamedTuple

from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.macros import GREEK
from kowalevski_cas.notation.symbol import symbol

SIGNS = {
    "=": "=", r"\equiv": "≡", r"\ne": "≠", "<": "<", ">": ">", r"\le": "≤", r"\ge": "≥",
    r"\to": "→", r"\in": "∈", r"\approx": "≈", r"\ll": "≪", r"\gg": "≫", r"\sim": "∼",
    r"\simeq": "≃", r"\propto": "∝", r"\perp": "⟂", r"\parallel": "∥",
}  # fmt: skip
"""The signs of relations, also of those that only words state."""

_LETTERS = GREEK | {
    r"\pm": "±", r"\infty": "∞", r"\perp": "⟂", r"\parallel": "∥", "'": "′"
}  # fmt: skip

_STYLES = {
    r"\mathbf": "BOLD", r"\boldsymbol": "BOLD", r"\mathcal": "SCRIPT", r"\mathscr": "SCRIPT",
    r"\mathfrak": "FRAKTUR", r"\mathbb": "DOUBLE-STRUCK", r"\mathsf": "SANS-SERIF",
}  # fmt: skip

_PIECE_OF = re.compile(r"\\[A-Za-z]+|[^_]")
_PIECE = re.compile(r"\\[A-Za-z]+(?:\{([^{}]*)\})?|.")


class Glyphs(NamedTuple):
    r"""What a name is printed with: a letter in Unicode, and the signs that stand on it.

    A word in upright letters is a letter of several characters.
    """

    letter: str
    font: str
    accents: tuple[str, ...]
    """Macros, the outermost first."""
    raised: str
    indices: tuple[str, ...]
    primes: str


@cache
def glyphs(name: str) -> Glyphs:
    r"""What a name is printed with.

    >>> glyphs(r"\boldsymbol{\omega}_{12}")
    Glyphs(letter='ω', font='\\boldsymbol', accents=(), raised='', indices=('1', '2'), primes='')
    """
    parts = symbol(name)
    letter, font = _letter(parts.letter), parts.font
    if "{" in parts.letter:
        letter, font = _value(parts.letter), r"\mathrm"
    elif not font and parts.letter[:1] == "\\" and parts.letter not in _LETTERS:
        font = r"\mathrm"  # a macro of its own, as \sin, is an upright word
    raised = parts.raised.removeprefix("^")
    if raised[:1] == "{":
        of = symbol(raised[1:-1])
        raised = styled_letter(of.letter, of.font)
    primes = "′" * len(parts.primes)
    return Glyphs(letter, font, parts.accents, raised, _index(parts.index), primes)


def _value(tex: str) -> str:
    r"""The name of a value in a line: that of ``\sin{\theta_1}``, of ``\mathrm{sn}{(u,k)}``."""
    word, _, inner = tex.partition("{")
    if "}{" in inner:
        word, _, inner = inner.partition("}{")
        return word + _line(inner[:-1])
    if word in FUNCTIONS:
        return f"{word[1:]} {_line(inner[:-1])}"
    return _line(re.sub(r"\\mathrm\{(\w+)\}", r"\1", tex).replace("^{", "^").removesuffix("}"))


def _line(tex: str) -> str:
    return "".join(map(_letter, _PIECE_OF.findall(tex)))


def _letter(tex: str) -> str:
    return _LETTERS.get(tex, tex.removeprefix("\\")).replace("'", "′")


def _index(tex: str) -> tuple[str, ...]:
    return tuple(
        found[1] or _letter(found[0]) for found in _PIECE.finditer(tex) if found[0].strip(" _")
    )


def styled_letter(letter: str, font: str) -> str:
    r"""The letter in the type of a macro, where Unicode has it.

    >>> styled_letter("R", r"\mathbb"), styled_letter("ω", r"\boldsymbol")
    ('ℝ', '𝛚')
    """
    if font not in _STYLES or len(letter) > 1:
        return letter
    name = re.sub(r"^(LATIN|GREEK) (SMALL|CAPITAL) LETTER ", r"\2 ", unicodedata.name(letter))
    for place in (f"MATHEMATICAL {_STYLES[font]} {name}", f"{_STYLES[font]} {name}"):
        try:
            return unicodedata.lookup(place)
        except KeyError:
            continue
    return letter
