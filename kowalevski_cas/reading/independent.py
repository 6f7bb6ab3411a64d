r"""The independent variable by another letter than t: with :math:`d/dx` alone, x is the time."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.reading.operators import (
    BY,
    DERIVATIVE,
    EQUALS,
    GAP,
    LABEL,
    LETTER,
    RATIO,
    RATIO_BY,
    TOTAL,
    by_of,
)
from kowalevski_cas.source.displays import TypedFormula

_TOKEN = re.compile(
    r"\\\\\s*\[[^\]]*\]|\\(?:begin|end|label|tag|text|mbox|operatorname\*?)\s*\{[^{}]*\}|\\[A-Za-z]+|\\.|.",
    re.DOTALL,
)
_DOT = re.compile(r"\\d{1,4}ot(?![A-Za-z])")
_PRIME = re.compile(r"'|\\prime")
_PRIME_ALONE = re.compile(r"[\s{}(^\\cdot]*(?:'|\\prime)[\s})]*")


def _by_mark(english: str, russian: str) -> re.Pattern[str]:
    """How words say by what a mark derives; a sign is the formula for it."""
    derives = rf"{DERIVATIVE}s?{BY}§"
    of = r"(?:переменн\w+\s+|параметру\s+|длине\s+дуги\s+)?"
    derived = rf"(?:производн\w+|дифференцировани\w+)\s+по\s+{of}§"
    return re.compile(
        rf"\b{english}\b[^.§]{{0,30}}?\b{derives}|\b{derives}[^.§]{{0,40}}?\b{english}\b"
        rf"|\b{russian}[^.§]{{0,40}}?\b{derived}|\b{derived}[^.§]{{0,40}}?\b{russian}",
        re.IGNORECASE,
    )


_BY_PRIME = _by_mark(r"(?:primes?|dash(?:es)?)", r"штрих\w*")
_BY_DOT = _by_mark(r"(?:over)?dots?", r"точк\w+")
_DOT_STANDS_FOR = re.compile(
    r"\b(?:over)?dots?\b(?:\s+\w+){0,2}?\s+(?:stands?\s+for|denotes?|means?|is|abbreviates?|for)\s+§"
    r"|\bточк\w+\s+(?:\w+\s+)?(?:означает|обозначает|обозначена?|[-—–]+|есть)\s+§",
    re.IGNORECASE,
)
"""How words say for what a dot stands, the quotient of differentials behind them."""
_PRIME_STANDS_FOR = re.compile(
    r"\b(?:primes?|dash(?:es)?)\b(?:\s+(?:\w+|·)){0,3}?\s+"
    r"(?:(?:stands?|standing|written)\s+for|denot(?:es?|ing)|means?|is|be|being|are|abbreviates?|for)"
    rf"\s+(?:the\s+|an?\s+)?(?:{DERIVATIVE}\s+)?§"
    r"|§\s+(?:is\s+|being\s+|will\s+be\s+)?(?:(?:denoted|written|abbreviated|indicated)\s+)?by\s+(?:an?\s+|the\s+)?"
    r"(?:primes?|dash(?:es)?)\b"
    r"|\bштрих\w*\b(?:\s+(?:\w+|·)){0,3}?\s+(?:означает|обозначает|обозначена?|обозначать|[-—–]+|есть)"
    r"\s+(?:\w*производн\w+\s+|оператор\w*\s+|дифференцировани\w+\s+)?§",
    re.IGNORECASE,
)
"""How words say for what a prime stands, the quotient of differentials at the mark §."""
_IS_RATE = re.compile(
    rf"{LABEL}(?P<name>{LETTER})\s*(?:'|\^\s*\{{?\s*\\prime\s*\}}?)\s*{EQUALS}\s*"
    rf"(?:\\[dt]?frac\s*\{{\s*{TOTAL}{GAP}(?P=name)\s*\}}\s*\{{\s*{TOTAL}{GAP}(?P<by>\\?[A-Za-z]+)\s*\}}"
    rf"|{TOTAL}{GAP}(?P=name)\s*/\s*{TOTAL}{GAP}(?P<below>\\[A-Za-z]+|[A-Za-z]))[\s.,;]*(?:$|=)"
)
"""What a prime is on a name: :math:`u'=du/d\varphi`."""
_AS_FUNCTION = re.compile(
    r"[\s,~]*(?:is\s+|be\s+|being\s+)?(?:(?:considered|regarded|viewed|thought\s+of|taken|treated|seen)\s+)?"
    r"as\s+an?\s+function\s+of(?:\s+the)?(?:\s+\w+){0,2}\s*"
    r"|[\s,~]*(?:(?:рассматрива|счита)\w+\s+)?как\s+функци\w+(?:\s+\w+){0,2}\s*",
    re.IGNORECASE,
)
"""The words between a name and that of which it is a function from there on."""
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
_NAMED = re.compile(rf"{LABEL}(?P<name>{LETTER})\s*(?:{EQUALS}.*)?$", re.DOTALL)
_RATIO_ALONE = re.compile(rf"\s*{RATIO}[\s.,;]*")
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


def with_time(
    formulas: Sequence[TypedFormula], letter: str, other: str = ""
) -> Iterator[TypedFormula]:
    """The formulas, with t for the letter of the independent variable.

    What says by what a prime derives, as by the ``other`` one, is that letter alone.
    """
    for formula in formulas:
        mark = _MARK.fullmatch(formula.tex) or _RATIO_ALONE.fullmatch(formula.tex)
        own = _IS_RATE.fullmatch(formula.tex) if other else None
        mark = own if own and by_of(own) == other else mark
        tex = by_of(mark) if mark and r"\partial" not in formula.tex else formula.tex
        tex = _renamed(tex, letter, TIME) if letter not in ("", TIME) else tex
        yield formula if tex == formula.tex else replace(formula, tex=tex)


_DOTTED_TIME = re.compile(r"\\d{1,4}ot\s*(?:\{\s*t\s*\}|t(?![A-Za-z]))")
_RATED_TIME = re.compile(rf"\{{\s*{TOTAL}(?:\s*\^\s*\{{?\s*2\s*\}}?)?\s*t\s*\}}\s*\{{\s*{TOTAL}")
_CLOCK = re.compile(rf"(?:{_DOTTED_TIME.pattern})\s*&?\s*=\s*&?\s*1(?![\d.])")
_LETTERS_OF_COORDINATES = (r"\Theta", r"\Upsilon", r"\Xi")


def with_coordinate_time(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    r"""The formulas, with another letter for t where that is a coordinate: it has a rate itself.

    As :math:`\dot t` of a geodesic, or :math:`dt/ds` where all is derived by s. The letter by which
    dots derive there, if quotients or words tell it, becomes t. By :math:`\dot t=1` they are one.
    """
    texts = [one.tex for one in formulas]
    letters = {token for tex in texts for token in _TOKEN.findall(tex)}
    coordinate = next((one for one in _LETTERS_OF_COORDINATES if one not in letters), "")
    dotted = any(map(_DOTTED_TIME.search, texts))
    rated = not any(map(_DOT.search, texts)) and any(map(_RATED_TIME.search, texts))
    parameter = _parameter(formulas, text) if dotted or rated else ""
    alone = not any(_BY_TIME.search(tex) for tex in texts)
    if not (dotted or (parameter and alone)) or any(map(_CLOCK.search, texts)) or not coordinate:
        yield from formulas
        return
    for formula in formulas:
        tex = _renamed(formula.tex, TIME, coordinate)
        tex = _renamed(tex, parameter, TIME) if parameter else tex
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _parameter(formulas: Sequence[TypedFormula], text: str) -> str:
    """The letter by which all is derived where t is a coordinate, as quotients or words tell it."""
    texts = [one.tex for one in formulas]
    ratios = {by_of(one) for tex in texts for one in RATIO_BY.finditer(tex)}
    letters = ({*_said_of_dots(formulas, text)} or ratios) - {TIME}
    moved = {one for one in letters if any(_is_other(t, one) or _has_dot(t, one) for t in texts)}
    return letters.pop() if len(letters) == 1 and not moved else ""


def with_time_of_dots(formulas: Iterable[TypedFormula], text: str) -> Iterator[TypedFormula]:
    r"""The formulas with derivatives by t for those by the letter by which dots derive.

    So words make :math:`\frac{d}{ds}` of a geodesic what a dot is. No t stands in the paper then.
    """
    formulas = [*formulas]
    texts = [one.tex for one in formulas]
    letter = "" if any(TIME in _TOKEN.findall(tex) for tex in texts) else _parameter(formulas, text)
    said = letter and letter in _said_of_dots(formulas, text) and any(map(_DOT.search, texts))
    for formula in formulas:
        tex = RATIO_BY.sub(lambda one: _by_time(one, letter), formula.tex) if said else formula.tex
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _by_time(ratio: re.Match[str], letter: str) -> str:
    """What follows the numerator of a derivative, by the time if it is one by a letter."""
    if by_of(ratio) != letter:
        return ratio[0]
    start, end = ratio.span("by" if ratio["by"] else "below")
    return f"{ratio[0][: start - ratio.start()]} {TIME}{ratio[0][end - ratio.start() :]}"


def _has_dot(tex: str, name: str) -> bool:
    own = re.escape(name)
    return re.search(rf"\\d{{1,4}}ot\s*(?:\{{\s*{own}\s*\}}|{own}(?![A-Za-z]))", tex) is not None


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
        elif by := _by_own_mark(formulas, place, text):
            yield by, one.start
        found = (_ALONE.fullmatch(one.tex) or _IS.match(one.tex)) if one.inline else None
        if found is None:
            continue
        around = _around(formulas, place, text)
        alone = _ALONE.fullmatch(one.tex) is not None
        if (alone and _BY_PRIME.search(around)) or _AS_VARIABLE.search(around):
            yield found["by"], one.start


def _by_own_mark(formulas: Sequence[TypedFormula], place: int, text: str) -> str:
    r"""By what primes derive as a quotient of differentials tells; empty if it does not.

    So does :math:`u'=du/d\varphi`, or that u, which has primes, is taken as a function of φ; what
    is given by φ alone may have other primes.
    """
    one, texts = formulas[place], [formula.tex for formula in formulas]
    if (ratio := _RATIO_ALONE.fullmatch(one.tex)) and r"\partial" not in one.tex:
        return by_of(ratio) if _PRIME_STANDS_FOR.search(_around(formulas, place, text)) else ""
    if found := _IS_RATE.match(one.tex):
        return by_of(found) if _runs_along(found["name"], by_of(found), texts) else ""
    name, by = _NAMED.match(formulas[place - 1].tex) if place else None, _ALONE.fullmatch(one.tex)
    between = text[formulas[place - 1].end : one.start].replace("$", "")
    if not (name and by and one.inline and _AS_FUNCTION.fullmatch(between)):
        return ""
    primed = any(_has_primes(tex, name["name"]) for tex in texts)
    return by["by"] if primed and _runs_along(name["name"], by["by"], texts) else ""


def _runs_along(name: str, by: str, texts: Sequence[str]) -> bool:
    """Whether something moves, or is given by another name than that by which it is derived."""
    gives = re.compile(rf"{LABEL}{re.escape(name)}\s*&?\s*{EQUALS}(?P<value>.*)", re.DOTALL)
    values = (found["value"] for tex in texts if (found := gives.match(tex)))
    return any(_has_dot(tex, name) for tex in texts) or any(
        by not in _TOKEN.findall(value) and "'" not in value for value in values
    )


def _said_of_dots(formulas: Sequence[TypedFormula], text: str) -> Iterator[str]:
    """The letters by which dots derive, as words or formulas say."""
    for place, one in enumerate(formulas):
        if (mark := _MARK.fullmatch(one.tex)) and _DOT.search(one.tex):
            yield by_of(mark)
        alone, ratio = _ALONE.fullmatch(one.tex), _RATIO_ALONE.fullmatch(one.tex)
        if alone and _BY_DOT.search(_around(formulas, place, text)):
            yield alone["by"]
        elif ratio and _DOT_STANDS_FOR.search(_around(formulas, place, text)):
            yield by_of(ratio)


def _around(formulas: Sequence[TypedFormula], place: int, text: str) -> str:
    """The words around a formula, which is a sign there, as is one in the line before it."""
    one = formulas[place]
    before = formulas[place - 1] if place else None
    behind = formulas[place + 1].start if place + 1 < len(formulas) else len(text)
    lead = text[before.end if before else 0 : one.start]
    if before is not None and before.inline:
        start = formulas[place - 2].end if place > 1 else 0
        sign = "prime" if _PRIME_ALONE.fullmatch(before.tex) else "·"
        lead = f"{text[start : before.start]} {sign} {lead}"
    around = f"{lead} § {text[one.end : min(behind, one.end + 160)]}"
    return " ".join(re.sub(r"[$\\()~]", " ", around).split())


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


def _renamed(tex: str, letter: str, other: str) -> str:
    """A formula with another letter in the place of one, but where that has an index."""
    pieces: list[str] = []
    for found in _TOKEN.finditer(tex):
        whole = found[0] == letter and not re.match(r"\s*_", tex[found.end() :])
        after_macro = pieces and re.fullmatch(r"\\[A-Za-z]+", pieces[-1])
        pieces.append((" " if after_macro else "") + other if whole else found[0])
    return "".join(pieces)
