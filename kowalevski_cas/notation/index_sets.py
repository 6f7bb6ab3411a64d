r"""Sets of the values of an index, as :math:`i\in\{1,2,3\}`.

Names with an index :math:`i\in\mathbf Z/3\mathbf Z` are those of a closed chain, and so are those
with :math:`i=1,2,3\pmod3`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.notation.words import without_names

_INTEGERS = (r"\mathbf{Z}", r"\mathbb{Z}")
_MODULI = (r"\pmod", r"\bmod", r"\mod")
_REALS = frozenset({r"\mathbf{R}", r"\mathbb{R}"})


def without_sets(tokens: Sequence[Token], tex: str) -> list[Token]:
    r"""The tokens with the values of indices for the sets in which they are.

    For :math:`i\in\mathbf Z/3\mathbf Z` it stands behind all that the names with this index are
    a closed chain, :math:`x_{i+3}=x_i`.

    Raises ``NotationError`` if it is not said how many there are.
    """
    found, chains = list[Token](), list[Token]()
    behind = 0
    tokens, counted = _without_moduli(tokens, tex)
    for index, period in counted:
        chains += _closed_chains(tokens, index, period)
    for k, token in enumerate(tokens):
        if _is_real(tokens, k) and (kept := without_names([*found, *tokens[behind:k]])):
            found, behind = kept, k + 2
        elif token.text == r"\in" and k and tokens[k - 1].kind == "letter":
            values, end, period = _set_at(tokens, k + 1, tex)
            if values:
                found += [*tokens[behind:k], Token("relation", "=", token.start, token.end)]
                found += values
                chains += _closed_chains(tokens, tokens[k - 1], period)
                behind = end
    return [*found, *tokens[behind:], *chains]


def _without_moduli(
    tokens: Sequence[Token], tex: str
) -> tuple[list[Token], list[tuple[Token, int]]]:
    r"""The tokens without :math:`\pmod3` behind the values of an index, and the index with 3."""
    found, counted = list[Token](), list[tuple[Token, int]]()
    at = 0
    while at < len(tokens):
        opened = tokens[at].text == "(" and tokens[at + 1 : at + 2] != []
        sign = tokens[at + opened]
        if sign.text not in _MODULI:
            found.append(tokens[at])
            at += 1
            continue
        rest = [one for one in tokens[at + opened + 1 : at + opened + 4] if one.kind not in "{}"]
        index, values = _values_before(found)
        period = int(rest[0].text) if rest and rest[0].text.isdecimal() else 0
        if index is None or not period or values not in (f"1{period}", f"0{period - 1}"):
            raise NotationError(r"print the values before, as in i=1,2,3\pmod3", tex, sign.start)
        counted.append((index, period))
        at = tokens.index(rest[0]) + 1
        while at < len(tokens) and tokens[at].kind == "}":
            at += 1
        at += opened
    return found, counted


def _values_before(tokens: Sequence[Token]) -> tuple[Token | None, str]:
    """The index of which values stand at the end of some tokens, with the first and the last."""
    values = list[str]()
    for before, token in reversed([*pairwise(tokens)]):
        if token.text == "=":
            is_index = before.kind == "letter" and bool(values)
            return (before, values[-1] + values[0]) if is_index else (None, "")
        if token.kind == "number":
            values.append(token.text)
        elif token.kind not in ("comma", "dots"):
            break
    return None, ""


def _is_real(tokens: Sequence[Token], k: int) -> bool:
    r"""Whether it is said here that names are real numbers, :math:`a,b\in\mathbf R`, as all are."""
    texts = [token.text for token in tokens[k : k + 3]]
    real = len(texts) > 1 and texts[0] == r"\in" and texts[1] in _REALS
    return real and texts[2:] not in (["^"], ["_"])


def _set_at(tokens: Sequence[Token], at: int, tex: str) -> tuple[list[Token], int, int]:
    """The values of a set that is printed here, where it ends, and its period; none of others."""
    texts = [token.text for token in tokens[at : at + 5]]
    if texts[:1] == [r"\{"]:
        end = next((k for k in range(at, len(tokens)) if tokens[k].text == r"\}"), at)
        return [*tokens[at + 1 : end]], end + 1, 0
    if texts[:1] and texts[0] in _INTEGERS and texts[1:2] in (["/"], ["_"]):
        length = 3 + (texts[1] == "/" and texts[3:4] == texts[:1])
        start = tokens[at].start
        if tokens[at + 2].kind != "number":
            raise NotationError(r"print how many, as in i\in\mathbf Z/3\mathbf Z", tex, start)
        if (period := int(texts[2])) > 1:
            numbers = (Token("number", str(k), start, start) for k in range(1, period + 1))
            values = [t for n in numbers for t in (n, Token("comma", ",", start, start))]
            return values[:-1], at + length, period
    return [], at, 0


def _closed_chains(tokens: Sequence[Token], index: Token, period: int) -> Iterator[Token]:
    """That the names with an index are those of closed chains, behind a comma."""
    if not period:
        return
    at, behind = index.start, index.end
    for name in _names_at(tokens, index.text):
        shifted = [name, "_", "{", index.text, "+", str(period), "}"]
        yield Token("comma", ",", at, at)
        for text in (*shifted, "=", name, "_", index.text):
            kinds = {"+": "sign", "=": "relation", str(period): "number"}
            kind = text if text in "_{}" else kinds.get(text, "letter")
            yield Token(kind, text, behind if kind == "number" else at, behind)


def _names_at(tokens: Sequence[Token], index: str) -> list[str]:
    """The letters that have an index, by itself or with a number added."""
    found: dict[str, None] = {}
    letter = ""
    for k, (token, next) in enumerate(pairwise(tokens)):
        letter = token.text if token.kind == "letter" else letter
        group = [one.text for one in tokens[k + 1 : k + 4]]
        alone = next.text == index or (group[:2] == ["{", index] and group[2:] in (["+"], ["-"]))
        if token.kind == "_" and alone:
            found[letter] = None
    return [*found]
