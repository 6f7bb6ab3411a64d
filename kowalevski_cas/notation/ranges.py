r"""Ranges of an index: :math:`\dot q_i=p_i,\; i=1,2` is a statement for each value.

What is printed of such letters alone, as :math:`(i\ne j)`, says for which values.

A range stands behind the statements, also in brackets, and holds for those in which its letter is
an index; of two such letters, :math:`\delta_{ij}` is Kronecker's delta. Sums are over indices of
their own, which have ranges in the limits of the sum, or behind: of :math:`\sum_{j\ne i}`, that of
the other one. One that does not end with
a number, as :math:`i=1,\ldots,n`, says that the letter is an index, and no more: what is printed
for it is read as it stands.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import product
from operator import ge, gt, le, lt, ne

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.functions import OF_A_MATRIX
from kowalevski_cas.notation.index_sets import without_sets
from kowalevski_cas.notation.sums import SIGNS, Ranges, SumSign, Values, indexed_sums, outside_sums
from kowalevski_cas.notation.tensors import (
    SPACE,
    add_sums,
    has_tensors,
    permuted,
    put_tensors,
    without_idle_terms,
    without_tensors,
)
from kowalevski_cas.notation.tokens import Token

_KINDS = {
    "letter": "l", "number": "n", "comma": ",", "dots": "d", "sign": "s", "stop": ".",
    "gap": " ", "cell": " ", "row": " ", "block": " ",
}  # fmt: skip
_VALUE = "(?:n?l(?:sn)?|n|d)"
_RANGE = re.compile(
    rf"""(?:(?P<open>\()|(?<![^ ,]))(?P<letters>l(?:,l)*)
    [ ]?=[ ]?(?P<values>{_VALUE}(?:,{_VALUE})+)(?(open)\))(?=[ ,.]|$)""".replace("\n    ", "")
)

_COMPARED: dict[str, Callable[[int, int], bool]] = {
    r"\ne": ne, "<": lt, ">": gt, r"\le": le, r"\ge": ge,
}  # fmt: skip
Condition = tuple[str, Callable[[int, int], bool], str]
"""Two indices, and how their values compare."""

_PERIOD = re.compile(r"(.+)_\{?(\w)(?:\+(\d+)\}=\1_\{?\2\}?|\}?=\1_\{\2\+(\d+)\})")
""":math:`x_{i+3}=x_i`, which is said of the values before the first one, too."""


def without_ranges(tokens: list[Token], tex: str) -> tuple[list[Token], Ranges]:
    """The tokens without the ranges of indices that are printed among them, and these ranges."""
    tokens = without_sets(tokens, tex)
    signs = "".join(_sign(token) for token in tokens)
    found: dict[str, range | tuple[int, ...]] = {}
    kept, end = list[Token](), 0
    for match in _RANGE.finditer(signs):
        letters = [t for t in tokens[slice(*match.span("letters"))] if t.kind == "letter"]
        if not all(_is_index(tokens, letter.text) for letter in letters):
            continue
        values = _values(tokens[slice(*match.span("values"))])
        for letter in letters:
            if [*found.setdefault(letter.text, values)] != [*values]:
                message = f"a second range of {letter.text}: name one of the indices otherwise"
                raise NotationError(message, tex, letter.start)
        first = tokens[match.start()]
        kept += [*tokens[end : match.start()], Token("comma", ",", first.start, first.start)]
        end = match.end()
    return kept + tokens[end:], found


def index_conditions(tokens: Sequence[Token], ranges: Ranges) -> list[Condition]:
    r"""What a statement says of indices with ranges; nothing, if it says anything else.

    >>> from kowalevski_cas.notation.lexer import scan
    >>> values = range(1, 4)
    >>> [(i, j) for i, _, j in index_conditions(scan(r"(i\ne j)"), {"i": values, "j": values})]
    [('i', 'j')]
    """
    if len(tokens) > 2 and (tokens[0].text, tokens[-1].text) == ("(", ")"):
        tokens = tokens[1:-1]
    texts = [token.text for token in tokens]
    letters, signs = texts[::2], texts[1::2]
    if len(letters) != len(signs) + 1 or len(letters) < 2:
        return []
    if not all(ranges.get(one) for one in letters) or not {*signs} <= _COMPARED.keys():
        return []
    return [
        (one, _COMPARED[sign], other)
        for one, sign, other in zip(letters, signs, letters[1:], strict=False)
    ]


def each_value(
    tokens: list[Token], ranges: Ranges, tex: str, conditions: Sequence[Condition] = ()
) -> Iterator[list[Token]]:
    """A statement for all values of the indices in it; itself, if it has none.

    Values for which the ``conditions`` on two of them do not hold are left out.
    """
    tokens = add_sums(indexed_sums(tokens, ranges), ranges, tex)
    if not (tokens[0].text == r"\{" and permuted(tokens).isdisjoint(ranges)):
        ranges = {**dict.fromkeys(sorted(permuted(tokens)), SPACE), **ranges}
    index_ranges = {n: v for n, v in ranges.items() if v and _is_index(outside_sums(tokens), n)}
    if index_ranges and (period := _PERIOD.fullmatch("".join(token.text for token in tokens))):
        length = int(period[3] or period[4])
        index_ranges = {n: range(max(0, v[0] - length), v[-1] + 1) for n, v in index_ranges.items()}
    for values in product(*index_ranges.values()):
        at = dict(zip(index_ranges, values, strict=True))
        if all(holds(at[i], at[j]) for i, holds, j in conditions if i in at and j in at):
            yield _substitute(tokens, at, ranges, tex)


def index_letters(tokens: Sequence[Token]) -> set[str]:
    r"""The letters that stand in indices, but for those of sums as :math:`\sum_{i=1}^3`."""
    found = {token.text for token in letters_in_indices(tokens)}
    bound = set[str]()
    for k, token in enumerate(tokens):
        if token.kind in SIGNS and (sign := SumSign.at([*tokens], k)).is_plain:
            bound |= sign.own
    free = {t.text for t in outside_sums([*tokens])}
    return found - (bound - free)


def letters_in_indices(tokens: Iterable[Token]) -> list[Token]:
    """The letters that stand in indices, and under the signs of sums."""
    return [t for t, within in _index_flags(tokens) if within and t.kind == "letter"]


def _sign(token: Token) -> str:
    if token.text in ("(", ")", "="):
        return token.text
    return _KINDS.get(token.kind, "x")


def _values(tokens: list[Token]) -> range | tuple[int, ...]:
    """The values of an index; none, if they are no numbers."""
    parts = [token for token in tokens if token.kind != "comma"]
    dots = [token.kind for token in parts].count("dots")
    if any(token.kind not in ("number", "dots") or "." in token.text.strip(".") for token in parts):
        return ()
    values = tuple(int(token.text) for token in parts if token.kind == "number")
    if not dots:
        return values
    every = range(values[0], values[-1] + 1)
    ends = dots == 1 and parts[-2].kind == "dots" and values[:-1] == (*every[: len(values) - 1],)
    return every if ends else ()


def _is_index(tokens: Iterable[Token], letter: str) -> bool:
    """Whether a letter stands in an index."""
    return any(within and token.text == letter for token, within in _index_flags(tokens))


def _index_flags(tokens: Iterable[Token]) -> Iterator[tuple[Token, bool]]:
    """Each token, and whether it stands in an index."""
    depth, before = 0, ""
    for token in tokens:
        depth += token.kind == "{" and (depth > 0 or before == "_")
        yield token, depth > 0 or before == "_"
        depth -= token.kind == "}" and depth > 0
        before = token.kind


def _substitute(
    tokens: list[Token], at: Mapping[str, int], ranges: Ranges, tex: str
) -> list[Token]:
    """The tokens with values in the place of indices, and sums in indices added up."""
    first = next((k for k, token in enumerate(tokens) if token.kind in SIGNS), None)
    if first is None:
        return _substitute_values(tokens, at, tex) if at else tokens
    sum_ = SumSign.at(tokens, first)
    before, behind = tokens[:first], tokens[sum_.end :]
    dot = Token("times", r"\cdot", tokens[first].start, tokens[first].start)
    expanded = [*_expand_sum(sum_, at, ranges, tex)]
    multiplied = expanded[0].kind == "open" and _ends_with_name(before)
    return [
        *_substitute_values(before, at, tex),
        *([dot] if multiplied else []),
        *expanded,
        *_substitute(behind, at, ranges, tex),
    ]


def _expand_sum(sum_: SumSign, at: Mapping[str, int], ranges: Ranges, tex: str) -> Iterator[Token]:
    """A sum by its terms, if its index stands beside others, or its limits are no numbers."""
    outer = {name: value for name, value in at.items() if name not in sum_.own}
    terms = sum_.terms(outer, ranges)
    mixed = not sum_.is_plain or any(_is_index(sum_.body, name) for name in outer)
    mixed |= has_tensors(sum_.body) or sum_.is_crowded
    if sum_.head[0].kind == "product":
        yield from _expand_product(sum_, terms, outer, ranges, tex)
        return
    if terms is None or not mixed:
        yield from _substitute_values(sum_.head, outer, tex)
        yield from _substitute(sum_.body, outer, ranges, tex)
        return
    start = sum_.head[0].start
    signed = [without_tensors(sum_.body, {**outer, **values}) for values in terms]
    summed = [pair for pair in zip(terms, signed, strict=True) if pair[1][0]]
    yield Token("open", "(", start, start)
    for number, (values, (factor, body)) in enumerate(summed):
        sign = "-" if factor < 0 else "+"
        yield from [Token("sign", sign, start, start)] if number or factor < 0 else []
        yield from _substitute(body, {**outer, **values}, ranges, tex)
    yield from [] if summed else [Token("number", "0", start, start)]
    end = sum_.body[-1].end if sum_.body else start
    yield Token("close", ")", end, end)


def _ends_with_name(tokens: list[Token]) -> bool:
    """Whether a letter stands last, perhaps with scripts, of which a bracket seems the argument."""
    if not tokens or tokens[-1].kind != "}":
        return bool(tokens) and tokens[-1].kind in ("letter", "prime", "number")
    depth = 0
    for k in range(len(tokens) - 1, -1, -1):
        depth += (tokens[k].kind == "}") - (tokens[k].kind == "{")
        if not depth:
            return k > 0 and tokens[k - 1].kind in "^_"
    return False


def _expand_product(
    sign: SumSign, terms: list[Values] | None, at: Values, ranges: Ranges, tex: str
) -> Iterator[Token]:
    """A product over indices by its factors; raises ``NotationError`` if it is not clear."""
    start = sign.head[0].start
    if terms is None:
        raise NotationError(r"print where the product ends, as in \prod_{i=1}^{3}", tex, start)
    if not sign.is_one_factor:
        raise NotationError(r"how far does \prod reach? set brackets", tex, start)
    yield Token("open", "(", start, start)
    for number, values in enumerate(terms):
        yield from [Token("times", r"\cdot", start, start)] if number else []
        yield from _substitute(sign.body, {**at, **values}, ranges, tex)
    yield from [] if terms else [Token("number", "1", start, start)]
    yield Token("close", ")", start, start)


def _substitute_values(tokens: list[Token], at: Mapping[str, int], tex: str) -> list[Token]:
    """The tokens of what has no sums with values in the place of indices."""
    found: list[Token] = []
    tokens = [*put_tensors(without_idle_terms(tokens, at), at)]
    for k, token in enumerate(tokens):
        before = [t.kind for t in tokens[max(0, k - 2) : k]]
        if token.kind != "letter" or token.text not in at:
            found.append(token)
            continue
        if (before[-1:] == ["^"] or before == ["^", "{"]) and not _is_power(tokens, k):
            raise NotationError("is this a power or an index? write it out", tex, token.start)
        number = Token("number", str(at[token.text]), token.start, token.end)
        group = before[-1:] == ["_"] and at[token.text] > 9
        braces = [Token(kind, kind, token.start, token.end) for kind in "{}"] if group else []
        found += [*braces[:1], number, *braces[1:]]
    return [*_add_numbers(found, tokens, tex)]


def _is_power(tokens: list[Token], place: int) -> bool:
    r"""Whether what is raised at a place is the exponent of a bracket, or of what has a trace.

    Of another letter it may be an index: those of a sum over the components :math:`x^k`, too.
    """
    raised = max(k for k in range(place) if tokens[k].kind == "^")
    traced = any(token.text in OF_A_MATRIX for token in tokens[:raised])
    base = tokens[raised - 1]
    capital = base.kind == "letter" and base.text[-1:].isupper()
    return base.kind in ("close", "number") or (traced and capital)


def _add_numbers(found: list[Token], tokens: list[Token], tex: str) -> Iterator[Token]:
    """The tokens with one number for each sum of numbers in an index, as in ``q_{1+1}``."""
    printed = {token.start for token in tokens if token.kind == "number"}
    waiting: list[Token] = []
    for k, (token, within) in enumerate(_index_flags(found)):
        if (within or _is_in_exponent(found, k)) and token.kind in ("number", "sign"):
            waiting.append(token)
            continue
        yield from _sum(waiting, printed, tex)
        waiting = []
        yield token
    yield from _sum(waiting, printed, tex)


def _is_in_exponent(tokens: list[Token], place: int) -> bool:
    """Whether a token stands in an exponent that is a sum of numbers."""
    start = next((k for k in range(place, 0, -1) if tokens[k].kind == "{"), 0)
    end = next((k for k in range(place, len(tokens)) if tokens[k].kind == "}"), 0)
    inner = {token.kind for token in tokens[start + 1 : end]}
    return start > 0 and tokens[start - 1].kind == "^" and inner == {"number", "sign"}


def _sum(tokens: list[Token], printed: set[int], tex: str) -> Iterator[Token]:
    """A row of numbers and signs in an index, as one number if there are signs."""
    numbers = [token for token in tokens if token.kind == "number"]
    put = [token.start not in printed for token in numbers]
    if not any(put) or (
        len(numbers) == len(tokens)
        and all(put)
        and all(len(number.text) == 1 for number in numbers)
    ):
        yield from tokens
        return
    total = -1
    if [t.kind for t in tokens] == ["number", "sign"] * (len(numbers) - 1) + ["number"]:
        signs = [1, *(-1 if token.text == "-" else 1 for token in tokens[1::2])]
        total = sum(sign * int(number.text) for sign, number in zip(signs, numbers, strict=True))
    if total < 0:
        message = "a product, or several indices? write the statements out"
        raise NotationError(message, tex, tokens[0].start)
    yield Token("number", str(total), tokens[0].start, tokens[-1].end)
