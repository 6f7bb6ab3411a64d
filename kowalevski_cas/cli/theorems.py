"""What the checker says, in the letters of a terminal."""

from __future__ import annotations

import re
from typing import Final

from kowalevski_cas.notation import Name, to_plain

_NAME: Final = re.compile(
    r"\\[A-Za-z]+(?:\{(?:[^{}]|\{[^{}]*\})*\})?(?:_(?:\{[^{}]*\}|\w))?|[A-Za-z]_(?:\{[^{}]*\}|\w)"
)
_SIGNS: Final = (
    (re.compile(r"\bsqrt\("), "√("),
    (re.compile(r"\bdot\("), "("),
    (re.compile(r" \* (?=\d)"), "·"),
    (re.compile(r" \* "), ""),
    (re.compile(r" / "), "/"),
    (re.compile(r" != "), " ≠ "),
    (re.compile(r"(?<![\w-])-(?=[ (\w√])"), "−"),
)
_RAISED: Final = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def readable(said: str) -> str:
    r"""The words of the checker, with formulas as the other commands show them.

    >>> readable(r"D(J_1 ^ 2) = -2 * \omega_3 * J_{12} - sqrt(x_1 * x_2) / 3, for x_1 != 0")
    'D(J₁²) = −2ω₃J₁₂ − √(x₁x₂)/3, for x₁ ≠ 0'
    """
    said = _NAME.sub(lambda name: to_plain(Name(name[0])), said)
    said = re.sub(r" \^ (\d+)", lambda power: power[1].translate(_RAISED), said)
    for sign, shown in _SIGNS:
        said = sign.sub(shown, said)
    return said
