r"""Vector fields as operators: :math:`\mathcal X f` is the derivative of f along the motion."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.source.displays import TypedFormula

_LETTER = r"(?:\\math(?:cal|scr|bf|rm|frak|bb|sf)\s*(?:\{\s*[A-Za-z]\s*\}|\s[A-Za-z])|\\?[A-Za-z]+)"
_ONE_LETTER = re.compile(rf"\s*(?P<letter>{_LETTER}(?:_(?:\w|\{{\w+\}}))?)[\s.,;]*")
_FIELD = r"(?:(?:corresponding|associated|whole)\s+)?(?:vector\s+field|derivation)"
_BEFORE = re.compile(
    rf"\b{_FIELD}[\s~]*$|\b(?:векторное\s+поле|дифференцирование)[\s~]*$", re.IGNORECASE
)
"""How words end behind which stands the letter of a field."""
_BEHIND = re.compile(
    rf"[\s~]*(?:be|for|denotes?|is|the)?[\s~]*(?:the|a)[\s~]+{_FIELD}\b"
    r"|[\s~]*(?:[-—–]+[\s~]*)?(?:векторное\s+поле|дифференцирование)\b",
    re.IGNORECASE,
)
"""How words begin that say of the letter before them that it is a field."""
_NAME = (
    r"(?:\\(?!left|[bB]ig|[dt]?frac|cdot|partial|q?quad|to|in|sum)[A-Za-z]+|[A-Za-z])"
    r"(?:_(?:\w|\{[^{}]*\}))?"
)
"""A function on which a field acts."""
_AROUND = 60


def with_derivations(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    r"""The formulas, with derivatives by the time where a vector field acts that has a letter.

    Words have to say that the letter is a field, as “we denote by X the vector field of (1)”.
    """
    letters = {letter for one in formulas if (letter := _field(one, text))}
    for formula in formulas:
        tex = formula.tex
        for letter in letters:
            tex = _derived(tex, letter)
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _field(formula: TypedFormula, text: str) -> str:
    """The letter of a vector field, if words beside a formula say that it is one."""
    found = _ONE_LETTER.fullmatch(formula.tex) if formula.inline else None
    if found is None:
        return ""
    before = " ".join(text[max(0, formula.start - _AROUND) : formula.start].rstrip("$( \\").split())
    behind = " ".join(text[formula.end : formula.end + _AROUND].lstrip("$) \\").split())
    said = _BEFORE.search(before) or _BEHIND.match(behind)
    return found["letter"] if said else ""


def _derived(tex: str, letter: str) -> str:
    """A formula in which what a field acts on is derived by the time."""
    whole = "A-Za-z" if re.fullmatch(r"\\[A-Za-z]+", letter) else ""
    start = rf"(?<![A-Za-z\\_^{{]){re.escape(letter)}(?![_^{whole}])\s*"
    tex = re.sub(rf"{start}(?P<opening>(?:\\left\s*)?\()", r"\\frac{d}{dt}\g<opening>", tex)
    return re.sub(rf"{start}(?P<of>{_NAME})", r"\\frac{d}{dt}(\g<of>)", tex)
