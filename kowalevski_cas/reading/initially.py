r"""What a text says of the beginning of motions, :math:`x(0)=a`, or “initially :math:`x=a`”."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import Derivative, Formula, Name, NotationError, Relation
from kowalevski_cas.paper.chains import NAME, names_in
from kowalevski_cas.paper.initial_values import at_any_time, at_the_beginning, names_under_dots
from kowalevski_cas.reading.cues import cue, last_cue
from kowalevski_cas.source.displays import TypedFormula

_D = r"(?:d|\\mathrm\s*(?:\{\s*d\s*\}|\s+d))"
_RATIO = re.compile(rf"frac\s*\{{\s*{_D}(?:\^2)?\s*({NAME})\s*\}}\s*\{{\s*{_D}\s*t")
_START_OF_TIME = re.compile(r"\s*t\s*=\s*(?P<time>0|t_0|t_\{0\})[\s.,;]*")


def moving_names(formulas: Sequence[TypedFormula]) -> frozenset[str]:
    """The names of which rates are printed."""
    texts = [formula.tex for formula in formulas]
    found = set[str]().union(*map(names_under_dots, texts))
    return frozenset(found.union(*(names_in(one) for tex in texts for one in _RATIO.findall(tex))))


def with_initial_values(
    formulas: Sequence[TypedFormula], moving: Collection[str]
) -> tuple[list[TypedFormula], Mapping[int, Mapping[int, str]]]:
    """The formulas, with initial values without their time, and where these stand in each.

    Beside them x(t) is no function that has values for arguments only.
    """
    found, places = [], dict[int, dict[int, str]]()
    for formula in formulas:
        tex, times = formula.tex, dict[int, str]()
        with suppress(NotationError):  # who reads it says so
            tex, times = at_the_beginning(tex, moving)
        found.append(replace(formula, tex=tex) if times else formula)
        places[formula.start] = times
    if any(places.values()):
        found = [replace(formula, tex=at_any_time(formula.tex, moving)) for formula in found]
    return found, places


_STAYS = re.compile(
    r"\b(?:stays?|remains?|leaves?|never|always|for\s+ever)\b|\b(?:оста[её]тся|всегда|никогда)\b",
    re.IGNORECASE,
)
"""Words for what lasts: what they are said of is a set, and no beginning."""
_OVER = re.compile(
    r"\b(?:then|therefore|hence|thus|so|consequently|whence"
    r"|тогда|следовательно|отсюда|поэтому|значит)\b",
    re.IGNORECASE,
)
"""Words behind which it is said what follows from the beginning."""


def start_of_time(tex: str) -> str:
    """The time in a formula that says when a motion begins, as 0 in t=0; empty in any other."""
    found = _START_OF_TIME.fullmatch(tex)
    return found["time"] if found else ""


def time_of_value(
    formula: Formula | None, moving: Collection[str], around: tuple[str, str], beside: Sequence[str]
) -> str:
    """When a value of what moves, or of its rate, is taken, if words say that a motion begins so.

    Empty if they do not. The formulas ``beside`` are those of its sentence: one of them may name
    the time.
    """
    if not (isinstance(formula, Relation) and formula.is_equality):
        return ""
    first, *values = formula.members
    inner = first.argument if isinstance(first, Derivative) else first
    names = {name for value in values for name in value.names()}
    if not isinstance(inner, Name) or inner.name not in moving or names & {*moving, "t"}:
        return ""
    before, words = around[0], " ".join(around)
    if _STAYS.search(words) or cue("invariant", words):
        return ""
    over = max((found.start() for found in _OVER.finditer(before)), default=-1)
    if last_cue("initially", before) > over:
        return "0"
    return next(filter(None, map(start_of_time, beside)), "") if over < 0 else ""
