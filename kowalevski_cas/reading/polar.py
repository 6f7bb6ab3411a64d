r"""Polar coordinates: those that words name, :math:`x=r\cos\theta, y=r\sin\theta`, and the radius.

The radius is not negative: a root of the sum of the squares that it gives is the radius itself.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import groupby

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Root,
    Sum,
    to_latex,
)
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import DEFINITION, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import is_printed, unprinted

_POLAR = re.compile(r"\bpolar\s+coordinates\b|\bполярн\w+\s+координат\w*", re.IGNORECASE)
_ROUND = re.compile(
    r"\b(?:polar|cylindrical|spherical)\b|\b(?:полярн|цилиндрическ|сферическ)\w+", re.IGNORECASE
)
"""Words for coordinates with a radius."""

_OTHERWISE = re.compile(
    r"\b(?:consider|measured|counted|another|example|normal\s+form|model|pole|focus|rotating)\b"
    r"|\b(?:about|around|cent(?:er|re)d|relative\s+to)\b(?!\s+(?:at\s+)?the\s+origin\b)"
    r"|\b(?:рассмотр|отсчит|пример|модел|полюс|фокус|вращающ)\w*|\bдруг(?:ую|ой|ая|ие)\b|\bс\s+центром\b",
    re.IGNORECASE,
)
"""Words for another system in such coordinates, or for an angle that is counted otherwise."""

_OTHER = {r"\sin": r"\cos", r"\cos": r"\sin"}

RADII = ("r", r"\rho", r"\varrho", "R")
ANGLES = (r"\theta", r"\vartheta", r"\phi", r"\varphi", r"\psi", r"\alpha")


def coordinates_in_words(law: Law, paper: SourcePaper) -> list[SourceStatement]:
    r"""What gives the coordinates of a plane by those that words call polar, before their rates.

    These are the rates of a radius and an angle in the section of the law, and nothing is printed
    that gives the old coordinates by them.
    """
    plane, here = _plane(law), law.first.section
    later = [one for one in paper.items if one.order > law.order and one.section is here]
    if not plane or any(one.members[:1] == (Name(x),) for one in later for x in plane):
        return []
    old = {*law.variables}
    for _, group in groupby(later, key=lambda one: one.sentence):
        sentence = [*group]
        rated = {name for one in sentence for name in one.rates} - old
        radius, angle = rated & {*RADII}, rated & {*ANGLES}
        words = sentence[0].words
        if (
            len(radius) == len(angle) == 1
            and rated == radius | angle
            and _POLAR.search(f"{' '.join(sentence[0].earlier[:1])} {words}")
        ):
            if _OTHERWISE.search(words) or cue("ideal case", words):
                return []
            (r,), (phi,) = radius, angle
            return [
                unprinted(paper, f"polar-{k}", rf"{x}={r}\{f} {phi}", sentence[0])
                for k, (x, f) in enumerate(zip(plane, ("cos", "sin"), strict=True), 1)
            ]
    return []


def _plane(law: Law) -> tuple[str, ...]:
    """The coordinates of a plane: all two that move by a law, or x and y; none if there is none."""
    if len(law.variables) == 2:
        return law.variables
    return ("x", "y") if {"x", "y"} <= {*law.variables} else ()


def radii(items: Iterable[SourceStatement], law: Law) -> set[str]:
    """The names that statements give as roots of sums of squares of what moves."""
    return {name for one in items if (name := radius_given(one, law))}


def radius_given(item: SourceStatement, law: Law) -> str:
    """The name that is given as the root of a sum of squares of what moves, or its square is."""
    name = length_given(item)
    moves = item.names - {name} <= {*law.variables} if name else False
    return name if moves else ""


def length_given(item: SourceStatement) -> str:
    r"""The name that is given as the root of a sum of squares of names, as :math:`r^2=x^2+y^2`."""
    match item.members:
        case (
            (Name(name), Root(Sum(terms)))
            | (Power(Name(name), Number(2)), Sum(terms))
            | (Sum(terms), Power(Name(name), Number(2)))
        ):
            squares = [one for one in terms if isinstance(one, Power) and _is_square(one)]
            return name if len({*map(to_latex, squares)}) == len(terms) else ""
    return ""


def _is_square(power: Power) -> bool:
    return isinstance(power.base, Name) and power.exponent == Number(2)


def radius(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives a radius by what moves, before it is a new variable itself."""
    for law in known.laws:
        name = radius_given(item, law.base) if law.base and item.order < law.order else ""
        if name in law.new:
            words = "gives it by what moves; later it is a variable itself"
            return StatementRole(DEFINITION, words, "", (name,))
    return None


def radius_of(
    law: Law, items: Sequence[SourceStatement], paper: SourcePaper
) -> SourceStatement | None:
    r"""That a root of squares of what is given is a new name, as :math:`\sqrt{x^2+y^2}=r`.

    ``None`` if it is no new name, or if neither words nor a definition before call it a radius.
    """
    assert law.base is not None
    first = law.change[0]
    given = {one.bare[0]: one.members[1] for one in law.change if len(one.members) == 2}
    before = [one for one in items if one.order < first.order]
    words = f"{' '.join(first.earlier[:1])} {first.words}"
    for name in law.new:
        of = [x for x, value in given.items() if Name(name) in _factors(value)]
        if not of or not (
            not is_printed(first) or _ROUND.search(words) or name in radii(before, law.base)
        ):
            continue
        if _is_round([[f for f in _factors(given[x]) if f != Name(name)] for x in of]):
            root = to_latex(Root(Sum(tuple(Power(Name(x), Number(2)) for x in of))))
            return unprinted(paper, f"radius-{first.order}", f"{root}={name}", first)
    return None


def _is_round(products: Sequence[Sequence[Formula]]) -> bool:
    """Whether squares of products of sines and cosines add up to 1, as on a sphere.

    One is that of an angle alone, and all others have its other function and are so without it.
    """
    if len(products) == 1:
        return not products[0]
    for alone in (one for one in products if len(one) == 1):
        match alone[0]:
            case Application(function, arguments) if function in _OTHER:
                other = Application(_OTHER[function], arguments)
                rest = [[*one] for one in products if one is not alone]
                if all(one.count(other) == 1 for one in rest):
                    return _is_round([[f for f in one if f != other] for one in rest])
    return False


def _factors(formula: Formula) -> tuple[Formula, ...]:
    return formula.factors if isinstance(formula, Product) else (formula,)
