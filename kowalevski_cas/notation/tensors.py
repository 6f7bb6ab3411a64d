r"""Kronecker's delta, the sign of a permutation, and the sums that are not printed beside it.

In a statement with :math:`\varepsilon_{ijk}` the indices of it have the values 1, 2, 3 where no
others are printed, and a term in which one of them stands twice is summed over it, as in
:math:`\dot M_i=\varepsilon_{ijk}M_j\gamma_k`; one that stands once is free. Brackets of coordinates
are left as they stand, :math:`\{M_i,M_j\}=\varepsilon_{ijk}M_k`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.tokens import BEGINNING, ENDING, Token, bars_around

Values = Mapping[str, int]
SPACE = range(1, 4)
"""The values of the indices of a permutation of three."""

_RANKS = {r"\delta": 2, r"\varepsilon": 3, r"\epsilon": 3}
_NAMES = frozenset({"letter", "number", "_", "{", "}"})
"""The kinds of tokens of names with indices, and of numbers."""
_BETWEEN = frozenset({"sign", "plusminus", "relation"})


class _Tensor(NamedTuple):
    """A tensor among tokens: its indices, and where it begins and ends."""

    indices: tuple[str, ...]
    first: int
    end: int

    def value(self, at: Values) -> int | None:
        """Kronecker's delta, or the sign of a permutation; nothing if an index is not known."""
        known = [int(index) if index.isdecimal() else at.get(index) for index in self.indices]
        numbers = [place for place in known if place is not None]
        if len(numbers) < len(known):
            return None
        if len(numbers) == 2:
            return int(numbers[0] == numbers[1])
        i, j, k = numbers
        return (j - i) * (k - i) * (k - j) // 2


def permuted(tokens: Sequence[Token]) -> set[str]:
    """The letters in the indices of signs of permutations."""
    return {index for t in _tensors(tokens) if len(t.indices) == 3 for index in t.indices} - {
        *"123"
    }


def has_tensors(tokens: Sequence[Token]) -> bool:
    """Whether a tensor stands among tokens."""
    return any(True for _ in _tensors(tokens))


def add_sums(tokens: list[Token], ranges: Mapping[str, Sequence[int]], tex: str) -> list[Token]:
    """A statement with the sums over indices that stand twice written out.

    Raises ``NotationError`` where it cannot be seen over what a term is summed.
    """
    letters = permuted(tokens)
    if not letters or any(token.kind == "sum" for token in tokens):
        return tokens
    if tokens[0].text == r"\{" and letters.isdisjoint(ranges):
        return tokens
    letters |= {letter for letter in _letters(tokens) if letter in ranges}
    found, free = list[Token](), list[set[str]]()
    for term in _terms(tokens):
        counts = Counter(letter for letter in _letters(term) if letter in letters)
        twice = [index for index, count in counts.items() if count > 1]
        _check_term(term, twice, counts, tex)
        free += [{*counts} - {*twice}]
        found += _summed(term, twice)
    every = set().union(*free)
    if any(index and index != every for index in free):
        message = "which indices are free here, and which are summed over? print the sums"
        raise NotationError(message, tex, tokens[0].start)
    return found


def repeated(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], str]]:
    """The terms with each index that stands in them twice, as a factor of theirs."""
    if any(token.kind == "sum" for token in tokens):
        return
    for term in _terms(tokens):
        places = [*zip(_letters(term), _depths(term, index=False), strict=True)]
        counts = Counter(letter for letter, _ in places if letter)
        inner = {letter for letter, depth in places if depth}
        yield from (
            (term, letter) for letter, n in counts.items() if n == 2 and letter not in inner
        )


def without_tensors(tokens: Sequence[Token], at: Values) -> tuple[int, list[Token]]:
    """The product of the tensors with known indices that are factors of a term, and the others."""
    depths = _depths(tokens)
    factor, kept, behind = 1, list[Token](), 0
    for tensor in _tensors(tokens):
        value = tensor.value(at)
        if value is not None and not depths[tensor.first]:
            factor *= value
            kept += tokens[behind : tensor.first]
            behind = tensor.end
    kept += tokens[behind:]
    start = tokens[0].start
    return factor, kept or [Token("number", "1", start, start)]


def without_idle_terms(tokens: Sequence[Token], at: Values) -> list[Token]:
    r"""The tokens with 0 for each term that has a factor :math:`1-\delta_{jk}` where j is k.

    Its other factors need no value there, as :math:`1/(x_j-x_k)` has none.
    """
    found: list[Token] = []
    for term in _terms(tokens):
        nothing = Token("number", "0", term[0].start, term[-1].end)
        found += [nothing] if _is_idle(term, at) else term
    return found


def _is_idle(term: Sequence[Token], at: Values) -> bool:
    r"""Whether a factor :math:`(1-\delta_{jk})` of a term vanishes: behind names and numbers only.

    It may be a factor of what stands above a line; it is no argument, no divisor and no base of a
    power.
    """
    for tensor in _tensors(term):
        before, around = term[: max(0, tensor.first - 3)], term[max(0, tensor.first - 3) :]
        behind = around[tensor.end - len(before) :]
        complement = [token.text for token in around[:3]] == ["(", "1", "-"]
        complement = complement and [token.text for token in behind[:1]] == [")"]
        outside, inside = _above_line(before)
        if len(inside) < len(before):
            rest = _to_line(behind[1:])
            complement = complement and {token.kind for token in rest} <= _NAMES
        factors = (*outside, *inside)
        by_itself = all(t.kind in _NAMES and t.text not in FUNCTIONS for t in factors)
        by_itself = by_itself and [token.kind for token in behind[1:2]] != ["^"]
        known = tensor.value(at) == 1 and len(tensor.indices) == 2
        if complement and by_itself and known and not {*at}.isdisjoint(tensor.indices):
            return True
    return False


def _above_line(tokens: Sequence[Token]) -> tuple[Sequence[Token], Sequence[Token]]:
    """Tokens before a fraction that is not closed, and those above its line; if there is one."""
    place = next((k for k, token in enumerate(tokens) if token.kind == "frac"), None)
    if place is None or [token.kind for token in tokens[place + 1 : place + 2]] != ["{"]:
        return (), tokens
    above = tokens[place + 2 :]
    return (tokens[:place], above) if not any(t.kind == "}" for t in above) else ((), tokens)


def _to_line(tokens: Sequence[Token]) -> Sequence[Token]:
    """The tokens that stand above a line yet, at whose end a group is closed."""
    depth = 0
    for k, token in enumerate(tokens):
        depth += (token.kind == "{") - (token.kind == "}")
        if depth < 0:
            return tokens[:k]
    return tokens


def put_tensors(tokens: Sequence[Token], at: Values) -> Iterator[Token]:
    """The tokens with numbers for the tensors of which all indices are known."""
    behind = 0
    for tensor in _tensors(tokens):
        value = tensor.value(at)
        if value is None or {*at}.isdisjoint(tensor.indices):
            continue
        yield from tokens[behind : tensor.first]
        start, behind = tokens[tensor.first].start, tensor.end
        end = tokens[behind - 1].end
        if tensor.first and tokens[tensor.first - 1].kind == "number":
            yield Token("times", r"\cdot", start, start)
        shown = [("open", "("), ("sign", "-"), ("number", "1"), ("close", ")")]
        shown = shown if value < 0 else [("number", str(value))]
        yield from (Token(kind, text, start, end) for kind, text in shown)
    yield from tokens[behind:]


def _summed(term: list[Token], indices: Sequence[str]) -> Iterator[Token]:
    """A term behind the signs of sums over some indices."""
    start = term[0].start
    for letter in indices:
        below = [("sum", r"\sum"), ("_", "_"), ("{", "{"), ("letter", letter), ("}", "}")]
        yield from (Token(kind, text, start, start) for kind, text in below)
    yield from term


def _check_term(
    term: Sequence[Token], twice: Collection[str], counts: Mapping[str, int], tex: str
) -> None:
    """Refuse a term of which it cannot be seen over what it is summed."""
    places = [*zip(_letters(term), _depths(term, index=False), strict=True)]
    factors = {letter for letter, depth in places if not depth}
    if wrong := [index for index in twice if counts[index] > 2 or index not in factors]:
        message = rf"over what is summed here? print \sum_{{{wrong[0]}=1}}^{{3}}"
        raise NotationError(message, tex, term[0].start)


def _terms(tokens: Sequence[Token]) -> Iterator[list[Token]]:
    """The terms, and what stands between them."""
    term: list[Token] = []
    for token, depth in zip(tokens, _depths(tokens), strict=True):
        if token.kind in _BETWEEN and not depth:
            yield from [term] if term else []
            yield [token]
            term = []
        else:
            term.append(token)
    yield from [term] if term else []


def _tensors(tokens: Sequence[Token]) -> Iterator[_Tensor]:
    """The tensors among tokens."""
    for first, token in enumerate(tokens):
        rank = _RANKS.get(token.text, 0)
        if rank and [token.kind for token in tokens[first + 1 : first + 3]] == ["_", "{"]:
            end = next(k for k in range(first, len(tokens)) if tokens[k].kind == "}") + 1
            index = [token for token in tokens[first + 3 : end - 1] if token.kind != "comma"]
            texts = [
                t
                for token in index
                for t in (token.text if token.kind == "number" else [token.text])
            ]
            if len(texts) == rank and {token.kind for token in index} <= {"letter", "number"}:
                yield _Tensor(tuple(texts), first, end)


def _letters(tokens: Sequence[Token]) -> list[str]:
    """For each token the letter that it is in an index, or nothing."""
    found, depth, before = list[str](), 0, ""
    for token in tokens:
        depth += token.kind == "{" and (depth > 0 or before == "_")
        within = token.kind == "letter" and (depth > 0 or before == "_")
        found.append(token.text if within else "")
        depth -= token.kind == "}" and depth > 0
        before = token.kind
    return found


def _depths(tokens: Sequence[Token], index: bool = True) -> list[int]:
    """The number of brackets around each token, perhaps without those of indices and accents."""
    found, opened = list[int](), list[bool]()
    before = ""
    for token, bars in zip(tokens, bars_around(tokens), strict=True):
        if token.kind in ENDING and opened:
            opened.pop()
        found.append(sum(opened) + bars)
        if token.kind in BEGINNING:
            opened.append(index or before not in ("_", "accent"))
        before = token.kind
    return found
