r"""The independent variable by another letter than t: with :math:`d/dx` alone, x is the time."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.reading.operators import (
    BY,
    DERIVATIVE,
    EQUALS,
    LABEL,
    LETTER,
    RATIO,
    RATIO_BY,
    by_of,
)
from kowalevski_cas.source.displays import TypedFormula

_TOKEN = re.compile(
    r"\\(?:begin|end|label|tag|text|mbox|operatorname\*?)\s*\{[^{}]*\}|\\[A-Za-z]+|\\.|.", re.DOTALL
)
_DOT = re.compile(r"\\d{1,4}ot(?![A-Za-z])")
_PRIME = re.compile(r"'|\\prime")
_BY_PRIME = re.compile(
    rf"\b(?:primes?|dash(?:es)?)\b[^.§]{{0,30}}?\b{DERIVATIVE}s?{BY}§"
    rf"|\b{DERIVATIVE}s?{BY}§[^.§]{{0,40}}?\b(?:primes?|dash(?:es)?)\b"
    r"|\bштрих\w*\b[^.§]{0,40}?\b(?:производн\w+|дифференцировани\w+)\s+по\s+(?:переменн\w+\s+)?§"
    r"|\b(?:производн\w+|дифференцировани\w+)\s+по\s+(?:переменн\w+\s+)?§[^.§]{0,40}?\bштрих\w*",
    re.IGNORECASE,
)
"""How words say by what a prime derives; a mark is the formula for it."""
_MARK = re.compile(
    rf"{LABEL}"
    r"(?:\{\s*\})?\s*(?:\^\s*\{?\s*\\prime\s*\}?|'|\\prime"
    r"|\\dot\s*(?:\{\s*(?:~|\\,|\\ )?\s*\}|\s))"
    rf"\s*{EQUALS}\s*{RATIO}[\s.,;]*"
)
"""What a prime, or a dot, is said to be: :math:`'=d/dx`."""
_OF = re.compile(
    rf"{LABEL}(?P<name>{LETTER})\s*(?:=\s*(?P=name)\s*)?\(\s*(?P<by>\\?[A-Za-z]+)\s*\)[\s.,;]*"
)
"""What is a function of something: :math:`u=u(x)`."""
_IS = re.compile(r"\s*(?P<by>\\[A-Za-z]+|[A-Za-z])\s*=")
_BY_TIME = re.compile(r"\}\s*\{\s*(?:d|\\mathrm\s*\{?\s*d\s*\}?)\s*t\s*(?:\^\s*\d\s*)?\}")
_VARIABLE = r"(?:(?:the|a|an|our|new|as)\s+)*(?:new\s+)?independent\s+variable"
_AS_VARIABLE = re.compile(
    rf"\b(?:tak\w+|choos\w+|us\w+|introduc\w+|regard\w+|consider\w+|with|pass\w*|go\w*|let)\s+"
    rf"(?:(?:the|to)\s+)?(?:\w+\s+){{0,3}}?(?:{_VARIABLE}\s+)?§\s+(?:as|for|be|to\s+be)\s+{_VARIABLE}"
    rf"|{_VARIABLE}\s+§"
    r"|\b(?:прин\w+|взяв|возьм[её]м|бер[её]м|выбер\w+)\s+§\s+(?:за|в\s+качестве)\s+(?:нов\w+\s+)?независим\w+\s+переменн\w+"
    r"|\bнезависим\w+\s+переменн\w+\s+§",
    re.IGNORECASE,
)
"""How words say that something is the independent variable from there on."""
_ALONE = re.compile(r"\s*(?P<by>\\[A-Za-z]+|[A-Za-z])[\s.,;]*")
TIME = "t"


def independent_variable(formulas: Sequence[TypedFormula], text: str) -> str:
    r"""The letter by which alone is derived in a paper, as x by :math:`\frac{d^2u}{dx^2}=u-x`.

    It is known where quotients of differentials, words on primes, or the arguments of what has
    primes name no other, and no dots are printed; another than t moves itself nowhere, and stands
    beside no t.
    """
    texts = [one.tex for one in formulas if not _MARK.fullmatch(one.tex)]
    if any(_DOT.search(tex) for tex in texts):
        return ""
    primed = any(map(_PRIME.search, texts))
    said = {*_said(formulas, text)} if primed else set()
    rows = [one for tex in texts for one in RATIO_BY.finditer(tex)]
    ratios = {by_of(one) for one in rows}
    if ratios and not said and not any(_is_moved(one, texts, primed) for one in rows):
        return ""
    letters = ratios | (said or (_arguments(texts) if primed else set()))
    if not letters and any(_PRIME.search(tex) and TIME in _TOKEN.findall(tex) for tex in texts):
        return TIME  # what has primes has the time
    if len(letters) != 1:
        return ""
    (letter,) = letters
    if letter == TIME:
        return TIME if said else ""
    timed = any(TIME in _TOKEN.findall(tex) for tex in texts)
    return "" if timed or any(_is_other(tex, letter) for tex in texts) else letter


_NUMERATOR = re.compile(r"(?:d|\\mathrm\s*\{?\s*d\s*\}?)(?:\s*\^\s*\d)?\s*(?P<name>\S.*?)\s*$")
_RAISED = re.compile(r"\s*(?:\}|\\right|\\[bB]igg?r?)?\s*\)\s*\^")


def _is_moved(ratio: re.Match[str], texts: Sequence[str], primed: bool) -> bool:
    """Whether a derivative may be one of what moves: no formula before gives what is derived.

    Where primes are printed it has some, and it is no square, as in the equation of Hamilton and
    Jacobi.
    """
    found = _NUMERATOR.search(ratio.string[: ratio.start()].rpartition("{")[2])
    name = found["name"] if found else ""
    if _RAISED.match(ratio.string, ratio.end()):
        return False
    if not name:  # of something in brackets
        return not primed
    before = texts[: texts.index(ratio.string)]
    gives = re.compile(
        rf"\s*(?:\\label\s*\{{[^{{}}]*\}}\s*)?{re.escape(name)}\s*(?:\([^()]*\)\s*)?&?="
    )
    given = any(map(gives.match, before))
    return not given and (not primed or any(_has_primes(tex, name) for tex in texts))


def with_time(formulas: Sequence[TypedFormula], letter: str) -> Iterator[TypedFormula]:
    """The formulas, with t for the letter of the independent variable."""
    for formula in formulas:
        mark = _MARK.fullmatch(formula.tex)
        tex = by_of(mark) if mark else formula.tex
        tex = _renamed(tex, letter) if letter not in ("", TIME) else tex
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def other_variable(formulas: Sequence[TypedFormula], text: str) -> tuple[str, int]:
    """The letter by which primes derive beside dots, as words say, and where; none if they do not.

    Where they say so of several letters it is none of them.
    """
    texts = [one.tex for one in formulas]
    timed = any(_DOT.search(tex) or _BY_TIME.search(tex) for tex in texts)
    said = [*_said_at(formulas, text)] if timed and any(map(_PRIME.search, texts)) else []
    letters = {letter for letter, _ in said}
    return said[0] if len(letters) == 1 and TIME not in letters else ("", 0)


def _said(formulas: Sequence[TypedFormula], text: str) -> Iterator[str]:
    """The letters by which primes derive, as words say."""
    yield from (letter for letter, _ in _said_at(formulas, text))


def _said_at(formulas: Sequence[TypedFormula], text: str) -> Iterator[tuple[str, int]]:
    """The letters by which primes derive, as words say, each with the place."""
    for place, one in enumerate(formulas):
        if (mark := _MARK.fullmatch(one.tex)) and _DOT.search(one.tex) is None:
            yield by_of(mark), one.start
        found = (_ALONE.fullmatch(one.tex) or _IS.match(one.tex)) if one.inline else None
        if found is None:
            continue
        before = formulas[place - 1].end if place else 0
        behind = formulas[place + 1].start if place + 1 < len(formulas) else len(text)
        around = f"{text[before : one.start]} § {text[one.end : min(behind, one.end + 160)]}"
        around = " ".join(re.sub(r"[$\\()~]", " ", around).split())
        alone = _ALONE.fullmatch(one.tex) is not None
        if (alone and _BY_PRIME.search(around)) or _AS_VARIABLE.search(around):
            yield found["by"], one.start


def _arguments(texts: Sequence[str]) -> set[str]:
    """What functions that have primes are said to be functions of."""
    given = [found for tex in texts if (found := _OF.fullmatch(tex))]
    names = {one["name"]: one["by"] for one in given}
    primed = {name for name in names if any(_has_primes(tex, name) for tex in texts)}
    return {names[name] for name in primed}


def _has_primes(tex: str, name: str) -> bool:
    return (
        re.search(rf"(?<![A-Za-z\\]){re.escape(name)}\s*(?:'|\^\s*\{{?\s*\\prime)", tex) is not None
    )


def _is_other(tex: str, letter: str) -> bool:
    """Whether a letter is derived itself, has an argument, or stands in an index."""
    own = re.escape(letter)
    rated = rf"(?<![A-Za-z\\]){own}\s*(?:'|\^\s*\{{?\s*\\prime|\()"
    below = rf"_\s*(?:{own}(?![A-Za-z])|\{{[^{{}}]*{own}(?![A-Za-z])[^{{}}]*\}})"
    partial = rf"\\partial\s*_?\s*\{{?\s*{own}(?![A-Za-z])|\\nabla(?![A-Za-z])"
    above = rf"(?<![A-Za-z\\])d(?:\s*\^\s*\d)?\s*{own}\s*(?:\}}\s*\{{|/)"
    return any(re.search(one, tex) is not None for one in (rated, below, partial, above))


def _renamed(tex: str, letter: str) -> str:
    """A formula with t in the place of a letter, but where that has an index."""
    pieces: list[str] = []
    for found in _TOKEN.finditer(tex):
        whole = found[0] == letter and not re.match(r"\s*_", tex[found.end() :])
        after_macro = pieces and re.fullmatch(r"\\[A-Za-z]+", pieces[-1])
        pieces.append((" " if after_macro else "") + TIME if whole else found[0])
    return "".join(pieces)
