r"""The ranges of indices in a paper: :math:`i=1,2,3` is said once, and holds for what follows.

Where nothing says it, an index has the values of the numbers that stand in its place elsewhere in
the paper, if these are the same for all letters that have it, and no range ends with a letter.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.notation.ranges import index_letters
from kowalevski_cas.reading.counted import PERIOD
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.tokens import tokens_of

Values = tuple[int, ...]

_USUAL = "ijk"
"""Letters that are indices where they stand in the place of numbers."""
_DOTS = r"\\[lc]?dots[bcio]?|\.\.\."
_RANGE = re.compile(
    r"(?<![A-Za-z\\])(?P<letters>[a-z](?:\s*,\s*[a-z])*)\s*=\s*(?P<first>\d)\s*,\s*"
    rf"(?:(?P<rest>\d(?:\s*,\s*\d)*)|(?:\d\s*,\s*)?(?:{_DOTS})\s*,\s*(?P<last>\d))"
    rf"(?!\d|\s*,\s*(?:[A-Za-z\d]|{_DOTS}))"
)
_UNKNOWN = re.compile(rf"(?:{_DOTS})\s*,\s*[A-Za-z]|\\(?:sum|prod)[^+=]*?\^\s*\{{?\s*[A-Za-z]")
"""A range, or a sum, that ends with a letter."""
_NUMBERED = re.compile(
    r"(?P<base>[A-Za-z]|\\[A-Za-z]+)\s*_\s*"
    r"(?:\{\s*(?P<braced>[A-Za-z\d])\s*\}|(?P<index>[A-Za-z\d]))"
)
"""A letter with one sign in its index: without braces it is one, whatever follows."""
_SUM = re.compile(r"\\sum\s*_\s*\{\s*([a-z])\s*=\s*1\s*\}\s*\^\s*\{?\s*(\d)")
_PAIR = re.compile(r"_\s*\{\s*([ijk])\s*,?\s*([ijk])\s*\}")
_COMPARED = re.compile(
    r"\\sum\s*(?:\\limits\s*)?_\s*\{\s*([a-z])\s*(?:\\neq?(?![A-Za-z])|[<>])\s*([a-z])\s*\}"
)
"""Two indices of a sum that are compared: they have the same values."""
_SHIFTED = re.compile(r"_\s*\{\s*([a-z])\s*[+-]")
_RUNNING = re.compile(
    r"\\(?:sum|prod)\s*(?:\\limits\s*)?_\s*(?:\{\s*)?([a-z])(?![A-Za-z\s]*=)|_\s*\{\s*([a-z])\s*[+-]\s*\d"
)
"""Letters that run: below the sign of a sum, or shifted."""
_CLOSED = re.compile(r"([A-Za-z])_\{\s*[a-z]\s*\+\s*(?P<number>\d)\s*\}\s*&?=\s*\1_")
_NUMBERS = {"two": 2, "three": 3, "four": 4, "five": 5, "двум": 2, "трем": 3, "трём": 3}
_PERIOD = re.compile(
    rf"{PERIOD}\$?\s*(?P<number>[2-9]|{'|'.join(_NUMBERS)}|[a-z])\b", re.IGNORECASE
)
"""Words that give indices a period."""
_BRACKET = re.compile(
    r"\\\{\s*(?:[A-Za-z]|\\[A-Za-z]+)_\{?([a-z])\}?\s*,\s*(?:\\,\s*)?"
    r"(?:[A-Za-z]|\\[A-Za-z]+)_\{?([a-z])\}?\s*\\\}\s*&?="
)
_TENSOR_INDEX = re.compile(r"\\(?:var)?(?:epsilon|delta)_\{\s*([a-z])\s*([a-z])\s*([a-z]?)\s*\}")
_INDEX = re.compile(r"_(?:\{[a-z\s]+\}|[a-z])")
_OF_FAMILY = re.compile(r"(?P<of>.+)_(?:(?P<letter>[a-z])|\{(?P<letters>[a-z]+)\})")
_TENSOR = re.compile(r"\\(?:var)?epsilon\s*_")


_ALONE = re.compile(rf"\s*\(?\s*{_RANGE.pattern}\s*\)?[\s.,;]*")

_CONDITION = re.compile(
    r"\s*\(?\s*(?P<one>[a-z])\s*(?P<sign>\\neq?(?![A-Za-z])|[<>])\s*(?P<other>[a-z])\s*\)?[\s.,;]*"
)
"""What is said of two indices alone."""
_BESIDE = 24
"""So many signs may stand between a formula and what is said of its indices: “for”, “where”."""

_ENDS = re.compile(r"[.;:?!]|\n\s*\n")
"""What ends a sentence, or the part of it to which a condition belongs."""


def is_range(formula: TypedFormula) -> bool:
    """Whether a formula says over what an index runs, and nothing else."""
    return _ALONE.fullmatch(formula.tex) is not None


def period_in(words: str, texts: Iterable[str], numbers: Mapping[str, int]) -> int:
    r"""By how much words, or an equation, say that indices may be changed; 0 if they do not.

    ``numbers`` are those for letters; without any, an equation may as well be claimed.

    >>> period_in("the indices are taken modulo three", [], {})
    3
    >>> period_in("periodic boundary conditions", [r"c_{k+4}=c_k"], {"n": 4})
    4
    """
    if (found := _PERIOD.search(words)) is None:
        closed = filter(None, map(_CLOSED.search, texts if numbers else ()))
        return next((int(one["number"]) for one in closed), 0)
    number = found["number"]
    known = {**_NUMBERS, **numbers}
    return int(number) if number.isdigit() else known.get(number, known.get(number.lower(), 0))


def with_ranges(
    formulas: Sequence[TypedFormula], text: str, period: int = 0, most: int = 0
) -> Iterator[str]:
    """The TeX of each formula of a text, with the ranges of its indices that stand elsewhere.

    If a letter says how many there are, it is read as ``most``: so far goes an index of which
    nothing is said. An index that is shifted, as in a chain, may leave its range: nobody says what
    stands there, unless indices have a period.
    """
    said = [_said(formula.tex) for formula in formulas]
    usual = _by_numbers([formula.tex for formula in formulas])
    running = (letter for one in formulas for pair in _RUNNING.findall(one.tex) for letter in pair)
    ranges = {values for ranges in said for values in ranges.values()}
    whole = ranges.pop() if len(ranges) == 1 else (*range(1, most + 1),)
    usual |= {letter: whole for letter in running if letter and most}
    pairs = {
        pair.groups()
        for formula in formulas
        for pattern in (_PAIR, _COMPARED)
        for pair in pattern.finditer(formula.tex)
    }
    shifts = () if period else (_SHIFTED.findall(formula.tex) for formula in formulas)
    shifted = {letter for found in shifts for letter in found}
    known: dict[str, Values] = {}
    for place, formula in enumerate(formulas):
        known |= said[place]
        later = {n: v for one in reversed(said[place:]) for n, v in one.items()}
        every = {**usual, **later, **known}
        for one, other in ((*pair[::step],) for pair in pairs for step in (1, -1)):
            if one in every:
                every.setdefault(other, every[one])
        own = {} if _TENSOR.search(formula.tex) else {n: every[n] for n in every.keys() - shifted}
        tex = with_usual_indices(formula.tex)
        letters = index_letters(tokens_of(formula.tex))
        if tex != formula.tex:  # other letters have the values, if they are the same for all
            values = {own[letter] for letter in letters & {*own}}
            letters = index_letters(tokens_of(tex))
            own = dict.fromkeys(letters, values.pop()) if len(values) == 1 else {}
        behind = [
            rf"\quad {letter}={','.join(map(str, own[letter]))}"
            for letter in sorted(letters & {*own} - {*said[place]})
        ]
        behind += _conditions_beside(formulas, place, text)
        yield tex + "".join(f",{one}" for one in behind)


def with_values(words: Vocabulary, texts: Iterable[str]) -> Vocabulary:
    r"""The names, and those with numbers in the place of indices of which texts give the values.

    So :math:`\mathbf r_1` is a vector, if :math:`\mathbf r_i` is one and :math:`i=1,2`.
    """
    values: dict[str, set[int]] = defaultdict(set)
    for letter, own in (pair for tex in texts for pair in _said(tex).items()):
        values[letter].update(own)

    def every(names: frozenset[str]) -> frozenset[str]:
        found = {*names}
        for name in names:
            match = _OF_FAMILY.fullmatch(name)
            letters = (match["letter"] or match["letters"]) if match else ""
            if match and {*letters} <= values.keys():
                for numbers in product(*(sorted(values[letter]) for letter in letters)):
                    index = "".join(map(str, numbers))
                    found.add(f"{match['of']}_{index if len(index) == 1 else f'{{{index}}}'}")
        return frozenset(found)

    return replace(
        words,
        scalars=every(words.scalars),
        vectors=every(words.vectors),
        matrices=every(words.matrices),
        moving=every(words.moving),
    )


def with_usual_indices(tex: str) -> str:
    r"""Brackets of coordinates for all i and j, whatever letters are printed for these.

    >>> with_usual_indices(r"\{q_j,p_k\}=\delta_{jk}, \{q_j,q_k\}=0")
    '\\{q_i,p_j\\}=\\delta_{ij}, \\{q_i,q_j\\}=0'
    """
    pairs = {pair.groups() for pair in _BRACKET.finditer(tex)}
    tensors = {index for found in _TENSOR_INDEX.findall(tex) for index in found}
    if len(pairs) != 1 or not tensors:
        return tex
    ((first, second),) = pairs
    third = tensors - {first, second}
    if first == second or len(third) > 1 or not {first, second} <= tensors:
        return tex
    usual = dict(zip((first, second, *third), _USUAL, strict=False))
    return _INDEX.sub(lambda found: re.sub("[a-z]", lambda i: usual.get(i[0], i[0]), found[0]), tex)


def _conditions_beside(formulas: Sequence[TypedFormula], place: int, text: str) -> Iterator[str]:
    """What its neighbours in the same sentence say of two indices of a formula."""
    formula, letters = formulas[place], index_letters(tokens_of(formulas[place].tex))
    for other in (*formulas[max(0, place - 1) : place], *formulas[place + 1 : place + 2]):
        first, second = sorted((formula, other), key=lambda one: one.start)
        between = text[first.end : second.start]
        words = " ".join(between.split())
        apart = len(words) > _BESIDE or _ENDS.search(first.tex.rstrip()[-1:] + between)
        said = _CONDITION.fullmatch(other.tex) if other.inline and not apart else None
        if said and {said["one"], said["other"]} <= letters:
            yield rf"\quad ({said['one']}{said['sign']} {said['other']})"


def _said(tex: str) -> dict[str, Values]:
    """The ranges of indices that a formula prints."""
    found: dict[str, Values] = {}
    for match in _RANGE.finditer(tex):
        last = int(match["last"] or re.findall(r"\d", match["rest"])[-1])
        values = tuple(range(int(match["first"]), last + 1))
        printed = [int(digit) for digit in re.findall(r"\d", match["rest"] or "")]
        if not printed or [values[0], *printed] == [*values]:
            found |= {letter.strip(): values for letter in match["letters"].split(",")}
    return found


def _by_numbers(texts: Sequence[str]) -> dict[str, Values]:
    """The values of indices that are not said, by the numbers in their place.

    What is said of one index, and the same everywhere, are numbers of all letters that have it; of
    some letters not all numbers may be printed.
    """
    if any(map(_UNKNOWN.search, texts)):
        return {}
    numbers: dict[str, set[int]] = defaultdict(set)
    letters: dict[str, set[str]] = defaultdict(set)
    for match in (match for tex in texts for match in _NUMBERED.finditer(tex)):
        base, index = match["base"], match["braced"] or match["index"]
        if index.isdecimal():
            numbers[base].add(int(index))
        elif index in _USUAL:
            letters[index].add(base)
    said: dict[str, set[Values]] = defaultdict(set)
    for letter, values in (pair for tex in texts for pair in _said(tex).items()):
        said[letter].add(values)
    for letter, every in said.items():
        for base in letters[letter] if len(every) == 1 else ():
            numbers[base].update(*every)
    sums = (match.groups() for tex in texts for match in _SUM.finditer(tex))
    found = {letter: (*range(1, int(last) + 1),) for letter, last in sums}
    for letter, bases in letters.items():
        every = {tuple(sorted(numbers[base])) for base in bases if numbers[base]}
        whole = {one for one in every if one == (*range(1, len(one) + 1),) and len(one) > 1}
        values = min(whole, default=())
        if len(whole) == 1 and all({*one} <= {*values} for one in every):
            found |= {letter: values}
    return found
