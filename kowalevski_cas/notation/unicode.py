r"""Names and signs in Unicode, for the printers that do not write TeX."""

from __future__ import annotations

import re
import unicodedata
from functools import cache
from typing import NamedTuple

from kowalevski_cas.notation.errors import letter_and_index
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.macros import GREEK

SIGNS = {
    "=": "=", r"\equiv": "≡", r"\ne": "≠", "<": "<", ">": ">", r"\le": "≤", r"\ge": "≥",
    r"\to": "→", r"\in": "∈", r"\approx": "≈", r"\ll": "≪", r"\gg": "≫", r"\sim": "∼",
    r"\simeq": "≃", r"\propto": "∝", r"\perp": "⟂", r"\parallel": "∥",
}  # fmt: skip
"""The signs of relations, also of those that only words state."""

_LETTERS = GREEK | {r"\pm": "±", r"\infty": "∞", "'": "′"}

_STYLES = {
    r"\mathbf": "BOLD", r"\boldsymbol": "BOLD", r"\mathcal": "SCRIPT", r"\mathscr": "SCRIPT",
    r"\mathfrak": "FRAKTUR", r"\mathbb": "DOUBLE-STRUCK", r"\mathsf": "SANS-SERIF",
}  # fmt: skip

_PIECE_OF = re.compile(r"\\[A-Za-z]+|[^_]")
_PIECE = re.compile(r"\\[A-Za-z]+(?:\{([^{}]*)\})?|.")


class Symbol(NamedTuple):
    r"""The parts of a name: its letter in Unicode, the macro that stands on it, its indices.

    A word in upright letters is a letter of several characters.
    """

    letter: str
    font: str
    indices: tuple[str, ...]


@cache
def symbol(name: str) -> Symbol:
    r"""The parts of a name.

    >>> symbol(r"\boldsymbol{\omega}_{12}")
    Symbol(letter='ω', font='\\boldsymbol', indices=('1', '2'))
    """
    letter, index = letter_and_index(name)
    font, brace, inner = letter.partition("{")
    if not brace:
        # A macro of its own, as \sin, is an upright word.
        upright = letter[0] == "\\" and letter not in _LETTERS
        return Symbol(_letter(letter), r"\mathrm" if upright else "", _index(index))
    if "}{" in inner:  # the name of a value, as \mathrm{sn}{(u,k)}
        word, _, value = inner[:-1].partition("}{")
        return Symbol(word + "".join(map(_letter, _PIECE_OF.findall(value))), r"\mathrm", ())
    if font in FUNCTIONS or "^" in inner:  # the name of a value, as \sin{\theta_1}
        value = "".join(map(_letter, _PIECE_OF.findall(inner[:-1].replace("}^{", "^"))))
        word = f"{font[1:]} {value}" if font in FUNCTIONS else value
        return Symbol(word, r"\mathrm", _index(index))
    return Symbol(_letter(inner[:-1]), font, _index(index))


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
