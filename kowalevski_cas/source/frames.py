r"""Frames around formulas, as ``\boxed`` and ``\fbox``: what stands in one is read without it."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.source.mouth import Mouth
from kowalevski_cas.source.tex import TypedToken

_OF_FORMULAS = frozenset({r"\boxed", r"\Aboxed"})
_COLOURS = {r"\colorbox": 1, r"\fcolorbox": 2}
_OF_WORDS = frozenset(rf"\{name}" for name in "fbox framebox shadowbox doublebox ovalbox".split())
FRAMES = _OF_FORMULAS | _OF_WORDS | _COLOURS.keys()
_RELATIONS = frozenset({"=", "<", ">", "&", r"\le", r"\ge", r"\leq", r"\geq", r"\ne", r"\neq"})
_DOLLARS = frozenset({"$", r"\(", r"\)"})


def framed(frame: TypedToken, mouth: Mouth, mathematics: bool) -> list[TypedToken]:
    """What stands for a frame, which comes next, and what is in it.

    In a formula an expression is a group, and words are words.
    """
    for _ in range(_COLOURS.get(frame.text, 0)):
        mouth.argument()
    for _ in range(2 if frame.text == r"\framebox" else 0):
        mouth.optional_argument("[", "]")
    inside = mouth.argument()
    if frame.text not in _OF_FORMULAS:
        inside = [*_without_dollars(frame, inside)] if mathematics else inside
        return inside
    whole = any(one.text in _RELATIONS for one in inside)
    return inside if whole else _group(frame, inside)


def _without_dollars(frame: TypedToken, inside: list[TypedToken]) -> Iterator[TypedToken]:
    """A text with formulas as a formula with texts."""
    words: list[TypedToken] = []
    in_formula = False
    for token in (*inside, frame._replace(text="$")):
        if token.text not in _DOLLARS:
            words.append(token)
            continue
        if in_formula or not words:
            yield from words
        else:
            yield frame._replace(text=r"\text", literal=False)
            yield from _group(frame, words)
        words, in_formula = [], not in_formula


def _group(frame: TypedToken, inside: list[TypedToken]) -> list[TypedToken]:
    """A group of what is in a frame."""
    opening, closing = (frame._replace(text=brace, literal=False) for brace in "{}")
    return [opening, *inside, closing]
