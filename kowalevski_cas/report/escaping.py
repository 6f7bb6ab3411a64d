"""Plain text as LaTeX, where some letters mean something else."""

from __future__ import annotations

import re
from typing import Final

from kowalevski_cas.notation.macros import TYPED

_SPECIAL: Final = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#",
    "%": r"\%", "_": r"\_", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}",
    "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}",
    "–": "--", "—": "---", "…": r"\dots{}", "“": "``", "”": "''", "‘": "`", "’": "'",
    "§": r"\S{}", "\u00a0": "~", "\u202f": r"\,", "\u2009": r"\,",
}  # fmt: skip
_RAISED: Final = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺ⁿ", "0123456789-+n", strict=True))
_LOWERED: Final = dict(zip("₀₁₂₃₄₅₆₇₈₉₋₊ₙᵢⱼₖ", "0123456789-+nijk", strict=True))
_SIGNS: Final = {
    **{letter: f"^{digit}" for letter, digit in _RAISED.items()},
    **{letter: f"_{digit}" for letter, digit in _LOWERED.items()},
} | {
    letter: f"{macro} " if macro[0] == "\\" else macro for letter, macro in TYPED.items()
} | {
    "″": "''", "∞": r"\infty ", "√": r"\surd ", "°": r"^\circ ", "½": r"\tfrac12 ",
    "¼": r"\tfrac14 ", "⇒": r"\Rightarrow ", "⇔": r"\Leftrightarrow ", "∧": r"\land ",
    "∨": r"\lor ", "∪": r"\cup ", "∩": r"\cap ", "⊂": r"\subset ", "∅": r"\emptyset ",
    "∇": r"\nabla ", "ℝ": r"\mathbf{R}", "ℂ": r"\mathbf{C}", "ℚ": r"\mathbf{Q}",
    "ℤ": r"\mathbf{Z}", "✓": r"\checkmark ", "✗": r"\times ",
}  # fmt: skip
_MATH: Final = "\0"
"""Where mathematics begins and ends, until all is put together; no text has this letter."""
_SCRIPTS: Final = re.compile(r"((?>_\S\^\S|[_^]\S|'))(?=[_^'])")
"""What a letter has below and above it, before one more: TeX takes one of each."""


def escape_latex(text: str) -> str:
    r"""Plain text as LaTeX; a dollar is a dollar.

    >>> escape_latex("50% & the_rest, ω₁ ≠ 0")
    '50\\% \\& the\\_rest, $\\omega _1$ $\\ne $ 0'
    """
    text = re.sub(r'"([^"\n]*)"', "“\\1”", text)
    parts = "".join(map(_letter, text)).replace(_MATH + _MATH, "").split(_MATH)
    parts[1::2] = ["$" + _SCRIPTS.sub(r"\1{}", part) + "$" for part in parts[1::2]]
    return "".join(parts)


def _letter(letter: str) -> str:
    if letter in _SPECIAL:
        return _SPECIAL[letter]
    if letter in _SIGNS:
        return f"{_MATH}{_SIGNS[letter]}{_MATH}"
    if letter.isascii() or "À" <= letter <= "ſ":
        return letter if letter.isprintable() or letter in "\n\t" else ""
    return f"[U+{ord(letter):04X}]"


def ascii_only(text: str) -> str:
    """A text for the properties of a PDF, where LaTeX means nothing."""
    return re.sub(r"[^ -~]|[\\\\{}$&#%_^~]", "", text)
