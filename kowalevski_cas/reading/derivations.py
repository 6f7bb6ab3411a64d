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
_OF_LAW = re.compile(
    r"[\s~]*(?:(?:of|for|on)[\s~]+(?:the|this|our|these)[\s~]+(?:system|equations?|flow)\b(?![\s~]+(?:of|for|with)\b)"
    r"|(?:of|given\s+by|defined\s+by)[\s~]+\(?\\(?:eq)?ref|(?:этой\s+)?системы\b(?![\s~]+(?!и\b|где\b)[^\W\d])|\W*$|[,.;:]"
    r"|acts\b|and\b|и\b)",
    re.IGNORECASE,
)
"""How words go on behind a field that is the one of the law."""
_AROUND = 80

OTHER = "a vector field acts here, and no words say that it is the one of the equations of motion"


def with_derivations(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    r"""The formulas, with derivatives by the time where a vector field acts that has a letter.

    Words have to say that the letter is the field of the law, as “we denote by X the vector field
    of this system”; where another field acts a formula cannot be read.
    """
    letters: dict[str, bool] = {}
    for letter, of_law in (found for one in formulas if (found := _field(one, text))):
        letters[letter] = letters.get(letter, True) and of_law
    defined = {letter for letter in letters if any(_defines(one.tex, letter) for one in formulas)}
    for formula in formulas:
        tex, trouble = formula.tex, formula.trouble
        for letter, of_law in letters.items():
            changed = _derived(tex, letter)
            if changed != tex and (letter in defined or not of_law):
                trouble = trouble or OTHER
            tex = changed
        yield formula if tex == formula.tex else replace(formula, tex=tex, trouble=trouble)


def _defines(tex: str, letter: str) -> bool:
    """Whether a formula says what field a letter is."""
    return re.match(rf"\s*{re.escape(letter)}\s*:?=", tex) is not None


def _field(formula: TypedFormula, text: str) -> tuple[str, bool] | None:
    """The letter of a vector field, if words beside a formula say that it is one; of the law?"""
    found = _ONE_LETTER.fullmatch(formula.tex) if formula.inline else None
    if found is None:
        return None
    before = " ".join(text[max(0, formula.start - _AROUND) : formula.start].rstrip("$( \\").split())
    behind = " ".join(text[formula.end : formula.end + _AROUND].lstrip("$) \\").split())
    said, behind_it = _BEFORE.search(before), _BEHIND.match(behind)
    if behind_it is not None:
        return found["letter"], _OF_LAW.match(behind, behind_it.end()) is not None
    return (found["letter"], _OF_LAW.match(behind) is not None) if said else None


def _derived(tex: str, letter: str) -> str:
    """A formula in which what a field acts on is derived by the time."""
    whole = "A-Za-z" if re.fullmatch(r"\\[A-Za-z]+", letter) else ""
    start = rf"(?<![A-Za-z\\_^{{]){re.escape(letter)}(?![_^{whole}])\s*"
    tex = re.sub(rf"{start}(?P<opening>(?:\\left\s*)?\()", r"\\frac{d}{dt}\g<opening>", tex)
    return re.sub(rf"{start}(?P<of>{_NAME})", r"\\frac{d}{dt}(\g<of>)", tex)
