r"""Ellipses between the first and the last of like terms: :math:`p_1+\dots+p_4` is a sum of four.

What stands on both sides of the dots is alike but for numbers in indices, and goes on from the one
to the other, as in :math:`m_1q_1+\dots+m_4q_4`, :math:`q_1<\dots<q_4` and :math:`p_1\cdots p_4`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.tokens import tokens_of

LONGEST = 12
"""How far an ellipsis goes at most."""

_SEPARATORS = frozenset({"comma", "sign", "relation", "times"})
_BEGINS = frozenset({"comma", "sign", "relation", "times", "open", "{", "gap", "cell", "row"})
_ENDS = frozenset(
    {"comma", "sign", "relation", "times", "close", "}", "gap", "cell", "row", "stop"}
)


def without_ellipses(formulas: Iterable[TypedFormula]) -> Iterator[TypedFormula]:
    """The formulas, with the terms for which an ellipsis stands."""
    for formula in formulas:
        tex = written_out(formula.tex)
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def written_out(tex: str) -> str:
    r"""A formula with the terms for which ellipses stand, where these are known.

    >>> written_out(r"p_1+\dots+p_4=P"), written_out(r"m_1q_1+m_2q_2+\dots+m_3q_3")
    ('p_1+p_{2}+p_{3}+p_4=P', 'm_1q_1+m_2q_2+m_3q_3')
    >>> written_out(r"x_1x_2\cdots x_4"), written_out(r"x_1+\dots+y_4")
    ('x_1x_2 x_{3} x_4', 'x_1+\\dots+y_4')
    """
    at = 0
    while at is not None:
        tokens = tokens_of(tex)
        dots = [k for k, token in enumerate(tokens) if token.kind == "dots"]
        if at >= len(dots):
            return tex
        new = _written_out(tex, tokens, dots[at])
        tex, at = (tex, at + 1) if new is None else (new, at)
    return tex


def _written_out(tex: str, tokens: Sequence[Token], dots: int) -> str | None:
    """A formula with the terms for an ellipsis; ``None`` if they are not known."""
    before, after = [*tokens[:dots]], [*tokens[dots + 1 :]]
    between, sign = " ", ""
    if before and before[-1].kind in _SEPARATORS:
        if not after or after[0].text != before[-1].text:
            return None
        sign, separator = before[-1].text, before.pop()
        between = tex[separator.start : separator.end]
        between += " " * between.startswith("\\")
        after.pop(0)
    for length in range(1, min(len(before), len(after)) + 1):
        first, last = before[-length:], after[:length]
        ends = _numbers(first, last)
        if ends is None:
            continue
        around = (before[-length - 1 : -length], after[length : length + 1])
        whole = all(
            not beside or beside[0].kind in kinds
            for beside, kinds in zip(around, (_BEGINS, _ENDS), strict=True)
        )
        alternating = any(one.kind == "sign" and one.text != sign for one in around[0])
        if (sign and (not whole or alternating)) or not 0 <= ends[1] - ends[0] <= LONGEST:
            return None
        term = tex[first[0].start : first[-1].end]
        places = [
            (one.start - first[0].start, one.end - first[0].start)
            for one, other in zip(first, last, strict=True)
            if one.text != other.text or _is_index(first, one)
            if one.text == str(ends[0])
        ]
        terms = [_at(term, places, value) for value in range(ends[0] + 1, ends[1])]
        if ends[0] < ends[1]:
            terms.append(tex[last[0].start : last[-1].end])
        head, rest = tex[: first[-1].end], tex[last[-1].end :]
        return head + "".join(between + one for one in terms) + rest
    return None


def _numbers(first: Sequence[Token], last: Sequence[Token]) -> tuple[int, int] | None:
    """From which number in the indices of a term an ellipsis goes to which."""
    if first[0].kind not in ("letter", "frac", "accent", "font") and first[0].text != "(":
        return None
    pairs = {
        (one.text, other.text) if one.kind == other.kind else None
        for one, other in zip(first, last, strict=True)
        if one.text != other.text
    }
    if len(pairs) > 1 or None in pairs or not any(one.kind == "_" for one in first):
        return None
    numbers = {one.text for one in first if _is_index(first, one)}
    if not pairs and len(numbers) == 1:
        pairs = {(number, number) for number in numbers}
    found = pairs.pop() if pairs else None
    if found is None or not all(map(str.isdecimal, found)):
        return None
    changed = [one for one, other in zip(first, last, strict=True) if one.text != other.text]
    return (int(found[0]), int(found[1])) if all(_is_index(first, t) for t in changed) else None


def _is_index(tokens: Sequence[Token], token: Token) -> bool:
    """Whether a number stands in an index by itself."""
    k = next(k for k, one in enumerate(tokens) if one is token)
    before = [one.kind for one in tokens[max(0, k - 2) : k]]
    return token.kind == "number" and (before[-1:] == ["_"] or before == ["_", "{"])


def _at(term: str, places: Sequence[tuple[int, int]], value: int) -> str:
    for start, end in reversed(places):
        inner = str(value) if term[start - 1 : start] == "{" else f"{{{value}}}"
        term = term[:start] + inner + term[end:]
    return term
