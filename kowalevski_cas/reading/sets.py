"""The sets of which a paper speaks: which of its equations define one together.

What a comma joins is one set; “or” begins another one, and so does “and” between lists, or
where a name would have two values. Where the words are of planes each is one, and where they are
of points those with the same left side are. Upper signs go together, and lower ones.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise, product

from kowalevski_cas.notation import Formula, Number, Relation
from kowalevski_cas.notation.layout import EITHER_SIGN
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.statements import SourceStatement

SetOfEquations = tuple[SourceStatement, ...]

_OR = re.compile(r"\b(?:or|или|либо)\b")
_AND = re.compile(r"\b(?:and|as\s+well\s+as|и|а\s+также)\b|\\&")
_SEVERAL = re.compile(
    r"\bequilibria\b|\b(?:positions|states|points)\b|\b(?:положения|состояния|точки)\b",
    re.IGNORECASE,
)
"""Words for several equilibria."""
_POINTS = re.compile(r"points|точ", re.IGNORECASE)
_JOINED = re.compile(r"(?:[\s,;~]|\b(?:and|or|as\s+well\s+as|и|или|либо|а\s+также)\b)*")


def sets_of(equations: Iterable[SourceStatement], text: str) -> list[SetOfEquations]:
    """The sets that some equations of a source with this text define, in its order."""
    return [one for run in _runs(equations) for one in _by_signs(run, text)]


def _runs(equations: Iterable[SourceStatement]) -> Iterator[list[SourceStatement]]:
    """The equations of each display, and those that stand side by side in a sentence."""
    run: list[SourceStatement] = []
    for one in sorted(equations, key=lambda one: one.order):
        if run and not (one.typed is run[-1].typed or _beside(run[-1], one)):
            yield run
            run = []
        run.append(one)
    if run:
        yield run


def _beside(one: SourceStatement, other: SourceStatement) -> bool:
    """Whether nothing but a comma, or an “and”, stands between two formulas of a line."""
    inline = one.typed.inline and other.typed.inline and one.sentence == other.sentence
    near = inline and other.order == one.order + 1
    return near and _JOINED.fullmatch(other.lead) is not None


def has_set_beside(item: SourceStatement, known: Known) -> bool:
    """Whether what vanishes stands beside an inline statement, and is no rate."""
    mates = [one for one in known.items if one.typed.inline and one.sentence == item.sentence]
    run = next((run for run in _runs(mates) if item in run), [])
    others = (one for one in run if one is not item and not one.derives)
    return item.typed.inline and any(Number(0) in one.members for one in others)


def _by_signs(run: Sequence[SourceStatement], text: str) -> Iterator[SetOfEquations]:
    r"""The sets of a run, in which upper signs of :math:`\\pm` go together, and lower ones."""
    pairs = [pair for pair in pairwise(run) if _are_of_signs(*pair)]
    if not pairs:
        yield from _apart(run, text)
        return
    upper, lower = ({*signs} for signs in zip(*pairs, strict=True))
    for signed, others in ((upper, lower), (lower, upper)):
        for part in _apart([one for one in run if one not in others], text):
            if signed is upper or signed & {*part}:
                yield tuple(sorted(part, key=lambda one: one not in signed))


def _are_of_signs(one: SourceStatement, other: SourceStatement) -> bool:
    """Whether two statements are one formula with either sign, not with two values of an index."""
    signed = EITHER_SIGN.search(one.typed.tex)
    return one.span == other.span and signed is not None


def _apart(run: Sequence[SourceStatement], text: str) -> Iterator[SetOfEquations]:
    """The sets of a run of equations."""
    lists: list[list[SourceStatement]] = [[run[0]]]
    joined: list[str] = []
    for before, one in pairwise(run):
        words = text[before.span[1] : one.span[0]]
        if _OR.search(words) or _AND.search(words):
            joined.append("or" if _OR.search(words) else "and")
            lists.append([])
        elif not one.derives and any(_have_values(one, other) for other in lists[-1]):
            joined.append("or")
            lists.append([])
        lists[-1].append(one)
    several = run[0].typed.inline and _are_several(cue("places", run[0].before), run)
    if several and all(len(part) == 1 for part in lists[1:]):
        yield from ((one,) for one in run)
        return
    found: list[list[SourceStatement]] = [lists[0]]
    for word, part in zip(joined, lists[1:], strict=True):
        if word == "or" or several or _differ(found[-1], part) or _are_values(found[-1], part):
            found.append(part)
        else:
            found[-1] = [*found[-1], *part]
    yield from map(tuple, found)


def _have_values(one: SourceStatement, other: SourceStatement) -> bool:
    """Whether two equations give one thing its value, so that they are of two sets."""
    valued = all(isinstance(each.members[-1], Number) for each in (one, other))
    shared = {*one.bare} & {*other.bare} if valued else {_left(one)} & {_left(other)}
    return bool(shared)


def _are_several(places: str, run: Sequence[SourceStatement]) -> bool:
    """Whether each equation is one of the places that words name; a point has coordinates."""
    one_point = _POINTS.match(places) and len({*map(_left, run)}) == len(run)
    return bool(places) and not one_point


def _differ(one: Sequence[SourceStatement], other: Sequence[SourceStatement]) -> bool:
    """Whether two lists are of two sets: each has several equations, or both give one thing."""
    if len(one) > 1 and len(other) > 1:
        return True
    return any(_have_values(*two) for two in product(one, other))


def _are_values(one: Sequence[SourceStatement], other: Sequence[SourceStatement]) -> bool:
    r"""Whether words list equilibria, of which two equations of one letter give several.

    So it is in “equilibria are :math:`\theta=0` and :math:`\cos\theta=c`”.
    """
    if len(one) > 1 or len(other) > 1 or one[0].derives or other[0].derives:
        return False
    letters = {frozenset(_left(each[0]).names()) for each in (one, other)}
    return bool(_SEVERAL.search(one[0].before)) and len(letters) == 1 and len(letters.pop()) == 1


def _left(item: SourceStatement) -> Formula:
    assert isinstance(item.formula, Relation)
    return item.formula.members[0]
