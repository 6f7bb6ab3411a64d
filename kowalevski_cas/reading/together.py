r"""Names that equations give together, as u and v by :math:`r=u+v` and :math:`p^2+q^2=uv`.

They move: by the derivatives of these equations, where these determine their rates. What is said
of them holds where the equations hold.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from kowalevski_cas.notation import Name, PoissonBracket, to_latex
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

SAYS = "the equation that gives it with others"
_INTRODUCES = re.compile(
    r"\bintroduc\w+|\bdefin\w+\s+by|\bvariables?\b|\bcoordinates?\b|\bвв[её]д\w+|\bвводя\b"
    r"|\bопредел\w+|\bпеременн\w+|\bкоординат\w+",
    re.IGNORECASE,
)
"""Words by which names are introduced, and not given values."""


def find_together(law: Law, items: Sequence[SourceStatement], paper: SourcePaper) -> Iterator[Law]:
    """The law with the names that sentences behind it give by as many equations.

    The sentence, or one before it in the paragraph, names them.
    """
    later = [one for one in items if one.order > law.order]
    for _, group in groupby(later, key=lambda one: one.sentence):
        sentence = [*group]
        first = sentence[0]
        seen = {*law.mentions, *law.variables}.union(
            *(one.names for one in items if one.order < first.order and one.members)
        )
        giving = [one for one in sentence if _gives(one, law, seen)]
        new = sorted({name for one in giving for name in one.names - seen})
        named = {
            one.formula.name
            for one in items
            if isinstance(one.formula, Name) and one.paragraph == first.paragraph
            and one.order < giving[-1].order
        } if giving else set()  # fmt: skip
        said = giving and _INTRODUCES.search(giving[0].before) and cue("define", giving[0].before)
        if (
            said
            and len(new) == len(giving)
            and not all(_is_change(one, law) for one in giving)
            and (named.issuperset(new) or _are_coordinates(giving[-1], paper))
        ):
            rows = tuple(_row(one, paper) for one in giving)
            yield Law(rows, law.names, base=law, together=tuple(giving), new=tuple(new))


_COORDINATES = re.compile(
    r"\b(?:coordinates|variables)\b|\b(?:координат|переменн)\w*", re.IGNORECASE
)
_IN_THESE = re.compile(
    r"(?:\\(?:begin|end)\s*\{\w+\*?\}|\W)*"
    r"(?:in\s+these\s+(?:coordinates|variables)|в\s+этих\s+(?:координат|переменн)\w*)\b",
    re.IGNORECASE,
)


def _are_coordinates(item: SourceStatement, paper: SourcePaper) -> bool:
    """Whether the heading before a sentence, and the next sentence, speak of coordinates."""
    titled = _COORDINATES.search(item.section.title)
    return bool(titled and _IN_THESE.match(paper.prose.text, item.sentence[1]))


def _gives(item: SourceStatement, law: Law, seen: set[str]) -> bool:
    """Whether a statement says something of what moves and of new names, and gives none alone."""
    if len(item.members) != 2 or item.derives or item.formula is None:
        return False
    new, heads = item.names - seen, item.printed.heads
    alone = {*heads.names, *heads.squares, *heads.multiples, *item.bare}
    old = {*law.names.scalars(item.names)} & {*law.variables}
    brackets = any(isinstance(node, PoissonBracket) for node in item.formula.nodes())
    vectors = item.names & {*law.names.vectors}
    return bool(new and old) and not (new & alone or brackets or vectors)


def _is_change(item: SourceStatement, law: Law) -> bool:
    """Whether a statement gives a variable of a law by other names: so it is put in new ones."""
    moving = {*law.variables}
    match item.members:
        case (Name(name), right):
            return name in moving and {*law.names.scalars(right.names())}.isdisjoint(moving)
    return False


def _row(item: SourceStatement, paper: SourcePaper) -> SourceStatement:
    """The derivative of an equation."""
    left, right = (rf"\frac{{d}}{{dt}}\left({to_latex(one)}\right)" for one in item.members)
    id = f"derivative-of-{item.printed.display.id}{item.printed.number}"
    return unprinted(paper, id, f"{left}={right}", item, SAYS)
