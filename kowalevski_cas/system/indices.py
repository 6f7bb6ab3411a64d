r"""Sums that are printed without the values of their indices, as :math:`\sum_{i<j}m_im_j`.

A number of bodies may have a letter, :math:`n=3`, and a closed chain says how long it is.

An index has the values with which the names stand in the equations of motion. Where these are
printed with the sign of a permutation, an index that stands twice is summed over here too, as in
:math:`M_i\gamma_i`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import groupby, product

from kowalevski_cas.notation import Formula, Name, NotationError, Number, Vocabulary, split_display
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.ranges import without_ranges
from kowalevski_cas.notation.sums import SIGNS, SumSign, outside_sums
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tensors import permuted, repeated
from kowalevski_cas.notation.tokens import Token


def has_permutation(tex: str) -> bool:
    r"""Whether the sign of a permutation of three indices stands in a display.

    >>> has_permutation(r"\dot M_i=\varepsilon_{ijk}M_j\gamma_k")
    True
    """
    return bool(permuted(scan(tex)))


_COUNT = re.compile(r"(?P<letter>[A-Za-z])\s*=\s*(?P<number>[1-9]\d?)")
_CHAIN = re.compile(
    r"(?P<head>(?:\\[A-Za-z]+|[A-Za-z])\s*_)\s*\{\s*(?P<index>[a-z])\s*\+\s*(?P<length>\d+)\s*\}"
    r"\s*=\s*(?P=head)\s*\{?\s*(?P=index)\s*\}?"
)


def counts(tex: str) -> dict[str, str]:
    r"""The letters that say how far sums or indices run, with their numbers.

    >>> counts(r"H=\sum_{j=1}^np_j^2, n=3"), counts(r"\dot x=nx, n=3")
    ({'n': '3'}, {})
    """
    given = (_COUNT.fullmatch(tex[start:end].strip(" .;")) for start, end in split_display(tex))
    numbers = {count["letter"]: count["number"] for count in given if count}
    tokens = scan(tex) if numbers else []
    ends = {tokens[k + 2].text for k, token in enumerate(tokens[:-2]) if token.kind == "dots"}
    for k in (k for k, token in enumerate(tokens) if token.kind in SIGNS):
        ends |= {token.text for token in SumSign.at(tokens, k).head}
    return {letter: number for letter, number in numbers.items() if letter in ends}


def with_counts(tex: str, numbers: Mapping[str, str]) -> str:
    r"""A formula with numbers for these letters, also where something is added to them.

    >>> with_counts(r"H=\sum_{j=1}^np_j^2, n=3, q_{n+1}=q_1", {"n": "3"})
    'H=\\sum_{j=1}^3p_j^2, , q_{4}=q_1'
    """
    for letter, number in numbers.items():
        for start, end in reversed(split_display(tex)):
            if (count := _COUNT.fullmatch(tex[start:end].strip())) and count["letter"] == letter:
                tex = tex[:start] + tex[end:]
        for token in reversed([token for token in scan(tex) if token.text == letter]):
            more = re.compile(r"\s*([-+])\s*(\d+)(?=\s*\})").match(tex, token.end)
            total = int(number) + int(more[1] + more[2]) if more else int(number)
            tex = f"{tex[: token.start]}{total}{tex[more.end() if more else token.end :]}"
    return tex


def with_length(tex: str) -> str:
    r"""A display with the values of an index that only a closed chain gives.

    >>> with_length(r"\dot u_i=u_{i+1}, u_{i+4}=u_i")
    '\\dot u_i=u_{i+1}, u_{i+4}=u_i,\\quad i=1,2,3,4'
    """
    parts = (_CHAIN.fullmatch(tex[start:end].strip(" .;")) for start, end in split_display(tex))
    chains = {(one["index"], int(one["length"])) for one in parts if one}
    heads = {one["head"] for one in _CHAIN.finditer(tex)}
    for index, length in sorted(chains):
        for head, k in product(heads, range(2, length)):
            # what stands two places before is what stands behind
            before = rf"({re.escape(head)}\s*\{{\s*{index}\s*)-\s*{k}(?=\s*\}})"
            tex = re.sub(before, rf"\g<1>+{length - k}", tex)
        if not re.search(rf"(?<![\w\\]){index}\s*(?:=|,[^=]*=|\\in(?![A-Za-z]))(?!=)", tex):
            tex += rf",\quad {index}={','.join(map(str, range(1, length + 1)))}"
    return tex


_SHIFTED = re.compile(r"(?P<head>\\[A-Za-z]+|[A-Za-z])\s*_\s*\{\s*[a-z]\s*[-+]\s*\d+\s*\}")


def chain_ends(tex: str, given: Mapping[str, Formula]) -> set[str]:
    r"""The names that only close a chain, or end it: by ``given`` they are other links, or numbers.

    They stand for what a shifted index such as :math:`i+1` names, and are no links of their own.

    >>> from kowalevski_cas.notation import Relation
    >>> x_0, x_1, x_2, m_1 = map(Name, ("x_0", "x_1", "x_2", "m_1"))
    >>> given = {"x_0": Relation((x_0, x_2), ("=",)), "m_1": Relation((m_1, Number(1)), ("=",))}
    >>> chain_ends(r"\dot x_i=m_i(x_{i+1}-x_{i-1})", given)
    {'x_0'}
    """
    links = {one["head"] for one in _SHIFTED.finditer(tex)}
    return {
        name
        for name, formula in given.items()
        if symbol(name).head in links
        and all(isinstance(member, Name | Number) for member in formula.children())
    }


_OF_PAIR = re.compile(
    r"(?:\\[A-Za-z]+|[A-Za-z])\s*_\s*\{\s*(?P<j>[a-z])\s*(?P<k>[a-z])\s*\}"
    r"(?:\s*\^\s*(?:2|\{\s*2\s*\}))?\s*&?\s*="
)
_SYMMETRIC = re.compile(
    r"(?P<head>(?:\\[A-Za-z]+|[A-Za-z])\s*_)\s*\{\s*(?P<i>[a-z])\s*(?P<j>[a-z])\s*\}\s*=\s*"
    r"(?P<sign>-?)\s*(?P=head)\s*\{\s*(?P=j)\s*(?P=i)\s*\}"
)


def with_symmetry(tex: str) -> str:
    r"""A display with the coefficients that a symmetry gives by the others.

    >>> with_symmetry(r"\dot x_i=\sum_{j=1}^2a_{ij}x_j, i=1,2, a_{ij}=-a_{ji}")
    '\\dot x_i=\\sum_{j=1}^2a_{ij}x_j, i=1,2, a_{11}=0,\\quad a_{21}=-a_{12},\\quad a_{22}=0'
    """
    places = [(start, end) for start, end in {*split_display(tex)}]
    if not any(_SYMMETRIC.fullmatch(tex[start:end].strip()) for start, end in places):
        return tex
    tokens, ranges = without_ranges(scan(tex), tex)
    values = {**_printed_values(tokens), **{one: [*known] for one, known in ranges.items()}}
    for start, end in sorted(places, reverse=True):
        one = _SYMMETRIC.fullmatch(tex[start:end].strip())
        if one is None:
            continue
        known = values.get(one["i"]) or values.get(one["j"])
        if not known or values.get(one["j"], known) != known:
            raise NotationError(f"print {one['i']},{one['j']}=1,2,3 behind", tex, start)
        rows = [
            f"{one['head']}{{{b}{a}}}={one['sign'] or '+'}{one['head']}{{{a}{b}}}" if a < b
            else f"{one['head']}{{{a}{a}}}=0"
            for b in known for a in known if a < b or (a == b and one["sign"])
        ]  # fmt: skip
        tex = tex[:start] + r",\quad ".join(rows) + tex[end:]
    return tex


def with_range_of_names(tex: str) -> str:
    r"""A display with the values of an index that a sum prints, or that stands on the same names.

    >>> with_range_of_names(r"\dot x_i=\sum_{j=1}^3\sin(x_j-x_i)")
    '\\dot x_i=\\sum_{j=1}^3\\sin(x_j-x_i),\\quad i=1,2,3'
    """
    try:
        tokens, ranges = without_ranges(scan(tex), tex)
        values = _printed_values(tokens)
    except NotationError:
        return tex  # who reads it says so
    of = dict[str, set[str]]()
    for head, index in Cursor(tex, tokens, Vocabulary()).letters():
        of.setdefault(index[1:], set()).add(head)
    free = {token.text for token in outside_sums(tokens)}
    for index in sorted(of):
        if re.fullmatch("[i-n]", index) and index not in ranges and index in free:
            beside = [j for j in values if index == j or of[index] & of.get(j, set())]
            listed = {(*values[j],) for j in beside}
            if len(listed) == 1 and len(known := min(listed)) > 1:
                tex += rf",\quad {index}={','.join(map(str, known))}"
    return tex


def with_pairs(tex: str) -> str:
    r"""A display with what is defined for the pairs of which a sum is taken, for each of these.

    >>> with_pairs(r"H=\sum_{j<k}r_{jk}, r_{jk}^2=x_j+x_k, k=1,2,3")
    'H=\\sum_{j<k}r_{jk}, r_{12}^2=x_1+x_2,\\quad r_{13}^2=x_1+x_3,\\quad r_{23}^2=x_2+x_3, k=1,2,3'
    """
    try:
        tokens, ranges = without_ranges(scan(tex), tex)
    except NotationError:
        return tex  # who reads it says so
    signs = [SumSign.at(tokens, k) for k, token in enumerate(tokens) if token.kind in SIGNS]
    pairs = {(*sign.letters,): sign.terms({}, ranges) for sign in signs if len(sign.letters) == 2}
    for start, end in sorted({*split_display(tex)}, reverse=True):
        head = _OF_PAIR.match(tex[start:end].lstrip())
        letters = (head["j"], head["k"]) if head else ()
        terms = pairs.get(letters)
        if not terms or ranges.keys() >= {*letters}:
            continue
        own = [t for t in tokens if start <= t.start and t.end <= end and t.text in letters]
        rows = []
        for values in terms:
            row = tex[start:end]
            for token in reversed(own):
                at = token.start - start
                row = row[:at] + str(values[token.text]) + row[at + len(token.text) :]
            rows.append(row.strip())
        tex = tex[:start] + r",\quad ".join(rows) + tex[end:]
    return tex


def with_ranges(tex: str, names: Collection[str], convention: bool) -> str:
    r"""A formula with the values of the indices that its sums are printed without.

    With the ``convention``, sums over indices that stand twice in a term are printed too.

    >>> with_ranges(r"\sum_{i<j}x_ix_j", ["x_1", "x_2", "x_3"], False)
    '\\sum_{i<j}x_ix_j,\\quad i,j=1,2,3'
    >>> with_ranges("x_iy_i+z", ["x_1", "x_2", "y_1", "y_2", "z"], True)
    '\\sum_{i=1}^{2}x_iy_i+z'
    """
    try:
        tokens, ranges = without_ranges(scan(tex), tex)
        letters = [letter for letter in _letters(tokens) if letter not in ranges]
        sums = _printed_values(tokens)
        values = {one: _values(one, tex, tokens, names) or sums.get(one, []) for one in letters}
        known = {letter: found for letter, found in values.items() if len(found) > 1}
        pairs = repeated(tokens) if convention else ()
        found = [(term, _values(index, tex, term, names), index) for term, index in pairs]
    except NotationError:
        return tex  # who reads it says so
    for term, numbers, index in reversed(found):
        if numbers and numbers == [*range(1, len(numbers) + 1)]:
            sign, at = rf"\sum_{{{index}=1}}^{{{len(numbers)}}}", term[0].start
            tex = tex[:at] + sign + tex[at:]
    by = groupby(sorted(known, key=lambda one: (known[one], one)), key=lambda one: known[one])
    more = (f"{','.join(letters)}={','.join(map(str, numbers))}" for numbers, letters in by)
    return r",\quad ".join((tex, *more))


def _letters(tokens: list[Token]) -> Iterator[str]:
    """The indices of sums of which no values are printed."""
    for k, token in enumerate(tokens):
        if token.kind in SIGNS:
            yield from SumSign.at(tokens, k).without_values()


def _printed_values(tokens: list[Token]) -> dict[str, list[int]]:
    """The values that indices have in the sums which print them, and so those compared with them.

    None, if a sum has others for an index of the same name.
    """
    signs = [SumSign.at(tokens, k) for k, token in enumerate(tokens) if token.kind in SIGNS]
    found: dict[str, set[tuple[int, ...]]] = {}
    for sign in signs:
        for at in [sign.terms({}, {})] if sign.is_plain else []:
            for letter in sign.letters:
                listed = tuple(sorted({values[letter] for values in at or ()}))
                found.setdefault(letter, set()).add(listed)
    known = {one: [*min(lists)] for one, lists in found.items() if len(lists) == 1}
    for sign in signs:
        beside = [one for one in sign.letters if one in known]
        if len(beside) == 1 and not sign.is_plain:
            known = {**dict.fromkeys(sign.letters, known[beside[0]]), **known}
    return known


def _values(letter: str, tex: str, tokens: Iterable[Token], names: Collection[str]) -> list[int]:
    """The numbers that an index stands for: all names with it have the same ones."""
    used = {
        head
        for head, index in Cursor(tex, [*tokens], Vocabulary()).letters()
        if index == f"_{letter}"
    }
    found = {
        head: sorted(
            int(symbol(name).index)
            for name in names
            if symbol(name).head == head and symbol(name).index.isdecimal()
        )
        for head in used
    }
    first, *others = [*found.values()] or [[]]
    return first if all(other == first for other in others) else []
