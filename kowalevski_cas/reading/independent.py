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
_PARTIAL = re.compile(r"\\partial(?![A-Za-z])|\\(?:Delta|nabla)(?![A-Za-z])")
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
    ratios = {by_of(one) for tex in texts for one in RATIO_BY.finditer(tex)}
    primed = any(map(_PRIME.search, texts))
    said = {*_said(formulas, text)} if primed else set()
    letters = ratios | (said or (_arguments(texts) if primed else set()))
    if not letters and any(_PRIME.search(tex) and TIME in _TOKEN.findall(tex) for tex in texts):
        return TIME  # what has primes has the time
    if len(letters) != 1:
        return ""
    (letter,) = letters
    if letter == TIME:
        return TIME if said else ""
    timed = any(TIME in _TOKEN.findall(tex) for tex in texts)
    partial = any(map(_PARTIAL.search, texts))
    return "" if timed or partial or any(_is_other(tex, letter) for tex in texts) else letter


def with_time(formulas: Sequence[TypedFormula], letter: str) -> Iterator[TypedFormula]:
    """The formulas, with t for the letter of the independent variable."""
    for formula in formulas:
        mark = _MARK.fullmatch(formula.tex)
        tex = by_of(mark) if mark else formula.tex
        tex = _renamed(tex, letter) if letter not in ("", TIME) else tex
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _said(formulas: Sequence[TypedFormula], text: str) -> Iterator[str]:
    """The letters by which primes derive, as words say."""
    for place, one in enumerate(formulas):
        if (mark := _MARK.fullmatch(one.tex)) and _DOT.search(one.tex) is None:
            yield by_of(mark)
        found = _ALONE.fullmatch(one.tex) if one.inline else None
        if found is None:
            continue
        before = formulas[place - 1].end if place else 0
        behind = formulas[place + 1].start if place + 1 < len(formulas) else len(text)
        around = f"{text[before : one.start]} § {text[one.end : min(behind, one.end + 80)]}"
        if _BY_PRIME.search(" ".join(re.sub(r"[$\\()~]", " ", around).split())):
            yield found["by"]


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
    above = rf"(?<![A-Za-z\\])d(?:\s*\^\s*\d)?\s*{own}\s*(?:\}}\s*\{{|/)"
    return any(re.search(one, tex) is not None for one in (rated, below, above))


def _renamed(tex: str, letter: str) -> str:
    """A formula with t in the place of a letter, but where that has an index."""
    pieces: list[str] = []
    for found in _TOKEN.finditer(tex):
        whole = found[0] == letter and not re.match(r"\s*_", tex[found.end() :])
        after_macro = pieces and re.fullmatch(r"\\[A-Za-z]+", pieces[-1])
        pieces.append((" " if after_macro else "") + TIME if whole else found[0])
    return "".join(pieces)
