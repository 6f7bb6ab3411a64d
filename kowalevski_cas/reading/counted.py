r"""Numbers for letters that count: what is printed of :math:`N` bodies is read of three.

Where indices are shifted, as in a chain, there are four, for of three each is a neighbour of each,
or more where shifts by two are printed. A letter counts if a range, a sum or a list ends with it,
and nothing else is said of it. A smaller number is that of the paper where it is given with the
first range, or throughout; else it is that of a special case. What is then proved holds for this
number alone, and the audit says so; what fails for it fails.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.reading.text import Prose
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.tokens import tokens_of

SEVERAL = 3
"""How many bodies there are where a letter says how many."""

LARGEST = 5
"""No larger number that is said is put for a letter."""
LONGEST = 7
"""No chain is read as longer."""

_LETTER = r"(?P<letter>[A-Za-z])(?![A-Za-z_'(])"
_DOTS = r"(?:\\[lc]?dots[bcio]?(?![A-Za-z])|\.\.\.)"
_LE = r"(?:<|\\leq?(?:slant)?(?![A-Za-z]))"
_INDEX = r"[a-z](?:\s*,\s*[a-z])*"
_ENDS = [
    re.compile(pattern)
    for pattern in (
        rf"(?<![A-Za-z\\]){_INDEX}\s*=\s*\d\s*,\s*(?:\d\s*,\s*)*{_DOTS}\s*,\s*{_LETTER}",
        rf"\\(?:sum|prod)\s*(?:\\limits\s*)?_\s*\{{\s*{_INDEX}\s*=\s*\d\s*\}}\s*\^\s*"
        r"(?:(?P<letter>[A-Za-z])|\{\s*(?P<braced>[A-Za-z])(?![A-Za-z_'(]))",
        rf"\d\s*{_LE}\s*{_INDEX}(?:\s*{_LE}\s*[a-z])*\s*{_LE}\s*{_LETTER}",
        rf"(?P<base>[A-Za-z])\s*\}}?\s*_\s*\{{?\s*\d\s*\}}?[^=;]{{0,30}}?{_DOTS}[^=;]{{0,20}}?"
        r"(?P=base)\s*\}?\s*_\s*(?:(?P<letter>[A-Za-z])|\{\s*(?P<braced>[A-Za-z]))",
        r"(?P<base>[A-Za-z])_\{\s*[a-z]\s*\+\s*(?P<letter>[A-Za-z])\s*\}\s*&?=\s*(?P=base)_",
    )
]
"""Where a range, a sum, a list or a period ends with a letter."""
PERIOD = r"\b(?:ind(?:ex|ices)|индекс\w*)\b[^.;]{0,60}?\b(?:modulo|mod|по\s+модулю)[\s~]*"
_MODULO = re.compile(rf"{PERIOD}\$\s*{_LETTER}", re.IGNORECASE)
_RUNNING = re.compile(
    rf"(?:_\s*\{{\s*(?P<below>{_INDEX})\s*=\s*\d|(?<![A-Za-z\\])(?P<letters>{_INDEX})\s*=\s*\d\s*,\s*(?:\d|{_DOTS}))"
)
"""Letters that are indices: they run."""
_SHIFTED = re.compile(r"_\s*\{\s*([a-z])\s*[+-]\s*\d\s*\}")
_OFFSET = re.compile(r"_\s*\{\s*([a-z])\s*([+-])\s*(\d)\s*\}")
_SAID = r"(?<![A-Za-z\\]){}\s*(?P<sign>=|\\geq?(?:slant)?(?![A-Za-z])|>)\s*(?P<number>\d+)"
_ADDED = r"(?P<before>[_^{{(,=]\s*){}\s*(?P<sign>[+-])\s*(?P<number>\d)(?P<after>\s*[}}),]|\s*$)"
_MORE = r"""(?x)
    (?<![A-Za-z\\])(?:\\d?dot\s*\{{?|\\partial|d)\s*{0}(?![A-Za-z])     # it moves
    |(?<![A-Za-z\\]){0}\s*(?:_|'|\\to|\\gg|\\(?:long)?rightarrow)       # it has an index or a limit
    |^\s*{0}\s*&?=(?!\s*\d+[\s.,;]*$|\s*\d+\s*,)                        # it is defined
"""
"""What is said of a letter that does more than count."""
_AS_A_NUMBER = re.compile(
    r"[_^]\s*(?:[A-Za-z]|\{[^{}]*\})|\\frac\s*\{[^{}]*\\pi[^{}]*\}\s*(?:[A-Za-z]|\{[^{}]*\})"
)
"""Indices, exponents, and parts of a turn: what stands there is a number, whatever it counts."""
_PARITY = r"(?:odd|even|prime|неч[её]тн\w*|ч[её]тн\w*)"
_SOME = rf"(?:{_PARITY}[\s~]*\$\s*{{0}}\b|\$\s*{{0}}\s*\$[\s~]*(?:(?:is|be|are)[\s~]+)?{_PARITY}\b)"
"""Words that say for which numbers only something holds."""
_CASE = re.compile(
    r"\b(?:for|if|when|cases?|case\s+of|at|instance|example|при|если|для|когда|случа\w*)[\s~,(]*$",
    re.IGNORECASE,
)
"""How words end that speak of a special case."""
_THROUGHOUT = re.compile(
    r"\b(?:throughout|everywhere|always|restrict\w*|confine\w*|limit\s+ourselves|(?:in\s+)?this\s+(?:paper|note|article|work)"
    r"|всюду|везде|ограничимся|в\s+(?:этой|данной|настоящей)\s+(?:работ|стать|заметк)\w+)\b",
    re.IGNORECASE,
)
"""Words for what holds in a whole paper."""
_OF_ALL = re.compile(
    r"(?:\\d{1,4}ot(?![A-Za-z])|\\frac\s*\{\s*(?:d|\\mathrm\s*\{?\s*d)(?![A-Za-z]))[^=]*_\s*\{?\s*[a-z]"
)
"""A rate of what has a letter in its index."""
_SUMS = re.compile(r"\\(?:sum|prod)(?![A-Za-z])")
_USUAL = "N"
"""The letter that counts also where it is a factor by itself."""


def counts(formulas: Sequence[TypedFormula], text: str) -> dict[str, int]:
    """The letters that count in a paper, each with the number for which it is read."""
    texts = [formula.tex for formula in formulas]
    running = {
        letter.strip()
        for tex in texts
        for match in _RUNNING.finditer(tex)
        for letter in (match["below"] or match["letters"]).split(",")
    }
    found = dict.fromkeys(_MODULO.findall(text))
    found |= dict.fromkeys(letter for tex in texts for letter in _ended(tex))
    letters = [letter for letter in found if letter not in running]
    shifted = {letter for tex in texts for letter in _SHIFTED.findall(tex)} - {*letters}
    usual = _without_coincidence(texts) if shifted else SEVERAL
    numbers = {letter: _number(letter, formulas, text, usual) for letter in letters}
    return {letter: number for letter, number in numbers.items() if number}


def _without_coincidence(texts: Sequence[str]) -> int:
    r"""How long a chain is read: four, or so long that terms which differ do not coincide.

    So :math:`\sum u_iu_{i+2}` has terms of :math:`u_iu_{i+3}` in its rate, where neighbours are in
    the law; that and :math:`u_iu_{i+2}` are the same in a closed chain of five.
    """
    spans = {True: 1, False: 0}
    for tex in texts:
        offsets = [int(sign + number) for _, sign, number in _OFFSET.findall(tex)]
        span = max([*offsets, 0]) - min([*offsets, 0])
        moves = _OF_ALL.search(tex) is not None
        spans[moves] = max(spans[moves], max(map(abs, offsets), default=0) if moves else span)
    reach = spans[True] + spans[False]
    return SEVERAL + 1 if reach < SEVERAL else min(2 * reach + 1, LONGEST)


def _number(letter: str, formulas: Sequence[TypedFormula], text: str, usual: int) -> int:
    """The number for a letter; 0 if it may be something else.

    Of several numbers that it has in special cases it is the one that is printed most, if it is not
    smaller than the usual one.
    """
    texts = [formula.tex for formula in formulas]
    if any(_is_more(letter, tex) for tex in texts) or re.search(_SOME.format(letter), text):
        return 0
    said = [match for tex in texts for match in re.finditer(_SAID.format(letter), tex)]
    exact = Counter(int(match["number"]) for match in said if match["sign"] == "=")
    for small in [number for number in exact if number < usual]:
        if small == 1 or not _is_given(letter, small, formulas, text):
            del exact[small]
    least = [int(m["number"]) + (m["sign"] == ">") for m in said if m["sign"] != "="]
    number = exact.most_common(1)[0][0] if exact else max([usual, *least])
    return number if 1 < number <= max(LARGEST, usual) else 0


def _is_given(letter: str, number: int, formulas: Sequence[TypedFormula], text: str) -> bool:
    """Whether words give a letter a number for all that is said, and not for a special case.

    They do so before the first equations of motion, or sums, for all indices, or where none is.
    """
    general = [one for one in formulas if _OF_ALL.search(one.tex)]
    general = general or [one for one in formulas if _SUMS.search(one.tex)]
    if not general:
        return True
    prose = Prose(text, 0, formulas)
    first = prose.sentence(general[0].start)
    for one in formulas:
        if (match := re.search(_SAID.format(letter), one.tex)) and int(match["number"]) == number:
            start, end = prose.sentence(one.start)
            words = prose.between(start, one.start)
            here = prose.path(one.start)[-1] in prose.path(first[0])
            before = here and start < first[0] and not _CASE.search(words)
            if (start, end) == first or before or _THROUGHOUT.search(prose.between(start, end)):
                return True
    return False


def _ended(tex: str) -> Iterator[str]:
    """The letters with which ranges, sums and lists end in a formula."""
    for match in (match for end in _ENDS for match in end.finditer(tex)):
        yield match["letter"] or match["braced"]


def _is_more(letter: str, tex: str) -> bool:
    """Whether a letter is more than a number in a formula, or may be a quantity of its own."""
    if re.search(_MORE.format(letter), tex):
        return True
    if letter == _USUAL or not _has_others(letter, tex):
        return False
    outside = tex
    for end in _ENDS:
        outside = end.sub("", outside)
    outside = _AS_A_NUMBER.sub("", re.sub(_SAID.format(letter), "", outside))
    raised = re.search(
        rf"\^\s*(?:{letter}(?![A-Za-z])|\{{[^{{}}]*(?<![A-Za-z\\]){letter}(?![A-Za-z]))", tex
    )
    return not (_SUMS.search(tex) or raised) and stands_in(letter, outside)


def _has_others(letter: str, tex: str) -> bool:
    """Whether other letters stand in a formula."""
    return any(token.kind == "letter" and token.text != letter for token in tokens_of(tex))


def with_counts(
    formulas: Sequence[TypedFormula], numbers: Mapping[str, int]
) -> Iterator[TypedFormula]:
    """The formulas with these numbers for the letters that count, but where nothing else stands."""
    for formula in formulas:
        tex = formula.tex
        for letter, number in numbers.items():
            if _has_others(letter, tex):
                tex = _with_number(tex, letter, number)
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _with_number(tex: str, letter: str, number: int) -> str:
    r"""A formula with a number for a letter.

    >>> _with_number(r"x_{N+1}=2Nx_N", "N", 3)
    'x_{4}=2\\cdot 3x_3'
    """

    def added(match: re.Match[str]) -> str:
        more = int(match["number"]) * (1 if match["sign"] == "+" else -1)
        return f"{match['before']}{number + more}{match['after']}"

    tex = re.sub(_ADDED.format(letter), added, tex)
    tokens = tokens_of(tex)
    for k in reversed(range(len(tokens))):
        if tokens[k].text == letter and not _is_special(tokens[k + 1 : k + 3]):
            before, behind = [t.kind for t in tokens[max(0, k - 2) : k]], tokens[k + 1 : k + 2]
            argument = before[-1:] == ["frac"] or before == ["frac", "number"]
            left = r"\cdot " if before[-1:] == ["number"] and not argument else ""
            right = r"\cdot " if behind and behind[0].kind == "number" and not argument else ""
            shown = f"{{{number}}}" if argument else f"{left}{number}{right}"
            tex = f"{tex[: tokens[k].start]}{shown}{tex[tokens[k].end :]}"
    return tex


def _is_special(behind: Sequence[Token]) -> bool:
    """Whether what stands behind a letter that counts gives it a number: this is a special case."""
    return [token.text for token in behind[:1]] == ["="] and behind[-1].kind == "number"


def stands_in(letter: str, tex: str) -> bool:
    """Whether a letter stands in a formula."""
    return any(token.text == letter for token in tokens_of(tex))


def shown_numbers(numbers: Mapping[str, int]) -> str:
    """The letters that count with the numbers for which a paper is read."""
    return ", ".join(f"{letter}={number}" for letter, number in numbers.items())
