r"""Distances of points that only words name: :math:`r_{12}` is that of the first and the second.

Where words call letters with two indices distances, they are so of what moves with one index each:
of vectors, of coordinates :math:`x_i,y_i`, or of the only coordinate. The letters of distances
without a word are no constants. That :math:`r_{21}=r_{12}` is seen where both are given.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from kowalevski_cas.notation import Formula, Modulus, Negative, Number, Power, Sum
from kowalevski_cas.notation.symbol import Symbol, symbol
from kowalevski_cas.reading.known import CONVENTION, NOTATION, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

TWIN = "twin"
"""The kind of what gives a distance that is given already, from the other end."""
_WORDS = re.compile(r"\bdistances?\b|\bseparations?\b|\bрасстояни", re.IGNORECASE)
_LETTERS = ("r", "l", "d", "R", r"\rho", r"\ell", r"\Delta")
"""The letters of distances."""
_AXES = ("x", "y", "z")
_POINTS = ("r", "x", "q", "z", "R", r"\rho")
"""The letters of points, the first before the others."""


def twin(name: str, item: SourceStatement, known: Known) -> StatementRole | None:
    r"""What gives :math:`r_{21}` as its display has given :math:`r_{12}` before."""
    given = known.definitions.get(_twin(name), ()) if name != _twin(name) else ()
    for one in given:
        values = ([*map(_even, each.members[1:])] for each in (one, item))
        if one.typed is item.typed and next(values) == next(values):
            return StatementRole(NOTATION, f"the same as {plain(_twin(name))}", TWIN, (name,))
    return None


def _twin(name: str) -> str:
    """The distance back: with the two numbers of an index in the other order."""
    parts = symbol(name)
    return replace(parts, index=parts.index[::-1]).name if parts.index.isdecimal() else name


def _even(formula: Formula) -> Formula:
    """A formula in which differences below a modulus, or an even power, have one order."""
    match formula:
        case Modulus(Sum(terms)):
            return Modulus(_in_order(terms))
        case Power(Sum(terms), Number(power)) if power % 2 == 0:
            return Power(_in_order(terms), Number(power))
    return formula.map_children(_even)


def _in_order(terms: Iterable[Formula]) -> Formula:
    opposite = [one.argument if isinstance(one, Negative) else Negative(one) for one in terms]
    return Sum((*min(sorted(terms, key=repr), sorted(opposite, key=repr), key=repr),))


def distances(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """What gives the distances in laws of which words speak; of others it is told that none is."""
    mentioned = {name for law in known.laws for name in law.mentions}
    pairs = {
        name: parts
        for name, parts in ((name, symbol(name)) for name in sorted(mentioned))
        if re.fullmatch(r"(\d)(?!\1)\d", parts.index)
        and not (known.is_defined(name) or known.moves(name) or name in known.later)
    }
    for one in known.items:
        if known.roles[one].kind == TWIN:
            (name,) = known.roles[one].names
            role = StatementRole(CONVENTION, f"the same as {plain(_twin(name))}", "", (name,))
            yield _unprinted(name, _twin(name), known, suffix), role
    for name, parts in pairs.items():
        tex, back = _given(parts, known), _twin(name)
        if not tex:
            continue
        if _WORDS.search(" ".join(_said(parts, known))):
            first = name < back or back not in pairs
            role = StatementRole(CONVENTION, "a distance, as words call it", "", (name,))
            yield _unprinted(name, tex if first else back, known, suffix), role
        elif parts.letter in _LETTERS and not _is_supposed(name, known):
            known.lost[name] = f"${name}$ may be a distance: print what it is"


def _unprinted(name: str, tex: str, known: Known, suffix: str) -> SourceStatement:
    id = re.sub(r"\W+", "-", f"distance-{name}{suffix}")
    return unprinted(known.paper, id, f"{name}={tex}")


def _said(parts: Symbol, known: Known) -> Iterator[str]:
    """The words of the sentences that print a letter with two indices by itself."""
    for one in known.items:
        if one.formula is not None and not one.members and len(one.names) == 1:
            own = symbol(next(iter(one.names)))
            if own.letter == parts.letter and len(own.index.replace(",", "")) == 2:
                yield one.words


def _is_supposed(name: str, known: Known) -> bool:
    """Whether something is supposed of a name."""
    return any(name in one.names for one in known.assumptions)


def _given(parts: Symbol, known: Known) -> str:
    """The distance of what moves with one index each; empty if it is not known what does."""
    one, other = (*parts.index,)

    def moving(letter: Symbol) -> bool:
        return all(known.moves(replace(letter, index=index).name) for index in (one, other))

    bodies = [symbol(name) for name in known.names.vectors if symbol(name).index == one]
    bodies = [body for body in bodies if moving(body)]
    own = [body for body in bodies if body.without_type.letter == parts.letter] or [
        body for letter in _POINTS for body in bodies if body.without_type.letter == letter
    ]
    if own:
        return "|{}-{}|".format(*(replace(own[0], index=index).name for index in (one, other)))
    axes = [axis for axis in _AXES if moving(symbol(f"{axis}_1"))]
    if len(axes) > 1:
        squares = "+".join(f"({axis}_{one}-{axis}_{other})^2" for axis in axes)
        return rf"\sqrt{{{squares}}}"
    single = next((letter for letter in _POINTS if moving(symbol(f"{letter}_1"))), "")
    return f"|{single}_{one}-{single}_{other}|" if single and not bodies else ""
