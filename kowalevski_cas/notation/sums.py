r"""Sums over indices: how far they reach, and over which values.

Below the sign stand :math:`j=1` or :math:`j,k=1`, with the last value above it, or :math:`j`,
:math:`j\ne i`, :math:`i<j`, :math:`1\le i<j\le 3`, where indices have the ranges that are printed
behind the statement.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise, product
from operator import ge, gt, le, lt, ne
from typing import NamedTuple

from kowalevski_cas.notation.tokens import BEGINNING, ENDING, Token, bars_around

Ranges = Mapping[str, range | tuple[int, ...]]
Values = Mapping[str, int]

_ORDER: dict[str, Callable[[int, int], bool]] = {
    "<": lt, ">": gt, r"\le": le, r"\ge": ge, r"\ne": ne,
}  # fmt: skip
_SIGNS = {*_ORDER, "="}
SIGNS = frozenset({"sum", "product"})
"""The kinds of the signs of sums and products over an index."""
_BEHIND = frozenset("sign plusminus relation comma stop gap cell row block".split())


class SumSign(NamedTuple):
    """The sign of a sum with what stands on it, its one term, and where that ends."""

    head: list[Token]
    body: list[Token]
    end: int

    @classmethod
    def at(cls, tokens: list[Token], first: int) -> SumSign:
        """The sum of which the sign stands at this place."""
        begin, depth = first + 1, 0
        while begin < len(tokens):
            scripted = tokens[begin].kind in "^_" or tokens[begin - 1].kind in "^_"
            if not depth and not scripted:
                break
            depth += _depths(tokens[begin])
            begin += 1
        end, bars = begin, bars_around(tokens)
        while end < len(tokens) and bars[end] >= bars[first]:
            if not depth and bars[end] == bars[first] and tokens[end].kind in _BEHIND:
                break
            depth += _depths(tokens[end])
            if depth < 0:
                break
            end += 1
        return cls(tokens[first:begin], tokens[begin:end], end)

    @property
    def _below(self) -> list[list[str]]:
        """What stands below the sign, between commas."""
        found: list[list[str]] = [[]]
        depth, below = 0, False
        for token in self.head[1:]:
            depth += _depths(token)
            if token.kind in "^_" and not depth:
                below = token.kind == "_"
            elif token.kind == "comma":
                found.append([])
            elif below and token.kind not in "{}":
                found[-1].append(token.text)
        return found

    @property
    def _above(self) -> list[str]:
        """What stands above the sign."""
        above = next((k for k, token in enumerate(self.head) if token.kind == "^"), len(self.head))
        return [
            token.text for token in self.head[above + 1 :] if token.kind in ("number", "letter")
        ]

    @property
    def is_plain(self) -> bool:
        r"""Whether it is as :math:`\sum_{i=1}^3`, and so are those in it."""
        inner = (
            SumSign.at(self.body, k) for k, token in enumerate(self.body) if token.kind in SIGNS
        )
        plain = len(self._below) == 1 and self._below[0][1:2] == ["="]
        return plain and all(part.is_plain for part in inner)

    @property
    def is_crowded(self) -> bool:
        r"""Whether an index of it stands right beside one of an inner sum, as in :math:`a_{ij}`."""
        inner = {
            letter
            for k, token in enumerate(self.body)
            if token.kind in SIGNS
            for letter in SumSign.at(self.body, k).letters
        }
        inner -= self.own
        pairs = [{one.text, other.text} for one, other in pairwise(self.body)]
        return any(pair & self.own and pair & inner for pair in pairs)

    @property
    def is_one_factor(self) -> bool:
        """Whether what stands behind the sign is one bracket, or one letter, with its scripts."""
        if not self.body or self.body[0].kind not in ("open", "letter"):
            return False
        at = self._behind(0)
        while at < len(self.body) and self.body[at].kind in "^_":
            at = self._behind(at + 1)
        return at == len(self.body)

    def _behind(self, at: int) -> int:
        """The place behind a token, or behind the group or the bracket that it opens."""
        depth = 0
        for k in range(at, len(self.body)):
            depth += _depths(self.body[k])
            if not depth:
                return k + 1
        return len(self.body)

    @property
    def letters(self) -> list[str]:
        """The letters below the sign."""
        below = (text for part in self._below for text in part)
        return [*dict.fromkeys(text for text in below if not (text.isdecimal() or text in _SIGNS))]

    @property
    def own(self) -> set[str]:
        """The letters that can be nothing but its indices."""
        return {part[0] for part in self._below if part and (len(part) == 1 or part[1] == "=")}

    def without_values(self) -> list[str]:
        """Its indices of which no values are printed; without any, the one letter that may be."""
        if len(self.head) == 1:
            pairs = pairwise(self.body)
            letters = {b.text for a, b in pairs if a.kind == "_" and b.kind == "letter"}
            return [*letters] if len(letters) == 1 else []
        return [name for name in self.letters if not self._domain(name, {}, {})]

    def terms(self, at: Values, ranges: Ranges) -> list[Values] | None:
        """The values of its indices, where others have values; ``None`` if they are not known."""
        names = [name for name in self.letters if name not in at]
        domains = [self._domain(name, at, ranges) for name in names]
        if not names or not all(domains) or not all(map(_is_chain, self._below)):
            return None
        every = (dict(zip(names, values, strict=True)) for values in product(*domains))
        return [values for values in every if self._holds({**at, **values})]

    def _domain(self, name: str, at: Values, ranges: Ranges) -> range | tuple[int, ...]:
        """The values of an index; none if they are not known."""
        parts = self._below
        if len(parts) > 1 and all(len(part) == 1 for part in parts[:-1]) and self._above:
            parts = [[part[0], *parts[-1][1:]] for part in parts]  # as in j,k=1
        for part in (part for part in parts if name in part):
            ends, between = [part[0], part[-1]], {*part[1::2]} <= {"<", r"\le"}
            if part[:2] == [name, "="]:
                ends, between = (
                    [str(at.get(text, text)) for text in (*part[2:], *self._above)],
                    True,
                )
            if between and len(ends) == 2 and all(map(str.isdecimal, ends)):
                return range(int(ends[0]), int(ends[1]) + 1)
            if "=" in part or self._above:
                return ()
        beside = (text for part in parts if name in part for text in part)
        return next((ranges[index] for index in (name, *beside) if ranges.get(index)), ())

    def _holds(self, at: Values) -> bool:
        """Whether what stands below the sign is so for these values."""
        return all(
            _ORDER[sign](*(at[text] if text in at else int(text) for text in (left, right)))
            for part in self._below
            for left, sign, right in zip(part[::2], part[1::2], part[2::2], strict=False)
            if sign in _ORDER
        )


def indexed_sums(tokens: list[Token], ranges: Ranges) -> list[Token]:
    r"""The tokens with an index below a sum without one, as in :math:`\sum x_i^2`.

    It is the only letter with a range that stands in an index behind the sign.
    """
    found = [*tokens]
    for k in range(len(tokens) - 1, -1, -1):
        if tokens[k].kind in SIGNS and tokens[k + 1 : k + 2] and tokens[k + 1].kind not in "^_":
            sign = SumSign.at(tokens, k)
            body = [*pairwise(sign.body)]
            letters = {b.text for a, b in body if a.kind == "_" and ranges.get(b.text)}
            if len(letters) == 1:
                start = tokens[k].end
                found[k + 1 : k + 1] = [
                    Token("_", "_", start, start), Token("letter", letters.pop(), start, start)
                ]  # fmt: skip
    return found


def outside_sums(tokens: list[Token]) -> Iterator[Token]:
    """The tokens that stand in no sum, or for no index of it."""
    first = next((k for k, token in enumerate(tokens) if token.kind in SIGNS), len(tokens))
    yield from tokens[:first]
    if first < len(tokens):
        found = SumSign.at(tokens, first)
        yield from (token for token in outside_sums(found.body) if token.text not in found.letters)
        yield from outside_sums(tokens[found.end :])


def _depths(token: Token) -> int:
    return (token.kind in BEGINNING) - (token.kind in ENDING)


def _is_chain(part: list[str]) -> bool:
    """Whether signs of order stand between letters and numbers."""
    between, beside = part[1::2], part[::2]
    return len(part) % 2 == 1 and {*between} <= _SIGNS and {*beside}.isdisjoint({*_SIGNS, "+", "-"})
