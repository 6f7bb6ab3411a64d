"""What papers use and do not print: lengths of vectors, canonical brackets, the imaginary unit."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import pairwise

from kowalevski_cas.notation import Name, PoissonBracket, Vector
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.implied import canonical_pairs, conjugate_pairs
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.paper.unit_matrices import unit_matrices
from kowalevski_cas.reading.brackets import brackets_by_functions
from kowalevski_cas.reading.brackets_of_momenta import brackets_by_momenta
from kowalevski_cas.reading.canonical import momenta
from kowalevski_cas.reading.changes import CONJUGATE
from kowalevski_cas.reading.distances import distances
from kowalevski_cas.reading.inertia import tensors_of_inertia
from kowalevski_cas.reading.kinematics import is_free
from kowalevski_cas.reading.known import CONVENTION, UNIT_MATRIX, Known, StatementRole
from kowalevski_cas.reading.levels import levels_apart
from kowalevski_cas.reading.named_values import values_in_words
from kowalevski_cas.reading.names import AXES
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import is_printed, unprinted

SPACE = 3
_BASIS = re.compile(r"e_\{?([123]|[xyz])\}?")
_INERTIA = re.compile(r"\binerti|\bинерци", re.IGNORECASE)
_IDENTITY = re.compile(r"\b(?:unit|identity)\b|\bединичн|\bтождествен", re.IGNORECASE)
_CANONICAL = re.compile(r"\bcanonical|\bканоническ", re.IGNORECASE)


IMPLIED = "an equation of motion that is implied"
POLAR = "polar coordinates, as words call them"
ANY_MOTION = "no equation says how it moves: what is judged holds for any motion"


def enter_conventions(parts: Parts) -> None:
    """Give names their usual meaning in the parts of a paper where nothing says what they are."""
    for place, known in enumerate(parts.known):
        for item in known.items if place else ():
            parts.cite(item)  # the matrices of elements before it may stand there
        for law in known.laws:
            for item in law.change:
                if not is_printed(item):
                    parts.places[item] = place
                    gives = item.bare[:1]
                    why = CONJUGATE if item.printed.display.source == CONJUGATE else POLAR
                    parts.enter(item, StatementRole(CONVENTION, why, "change", gives))
            if law.radius is not None:
                parts.places[law.radius] = place
                parts.enter(law.radius, StatementRole(CONVENTION, "a radius is not negative"))
            why = ANY_MOTION if is_free(law) else IMPLIED
            for item in law.items:
                if item not in parts.paper.items and item not in parts.said.rows:
                    parts.places[item] = place
                    parts.enter(item, StatementRole(CONVENTION, why))
        for item, role in conventions(known, f"-{place + 1}" if place else ""):
            parts.places[item] = place
            parts.enter(item, role)


def conventions(known: Known, suffix: str = "") -> Iterator[tuple[SourceStatement, StatementRole]]:
    r"""What names without a definition stand for, as :math:`L=|\mathbf L|`, :math:`i^2=-1`.

    The ids of what is said have a suffix.
    """
    paper = known.paper
    names = frozenset().union(*(item.names for item in known.items))
    scalars = sorted((paper.words.scalars & names) - known.times)
    for vector in sorted(known.names.vectors):
        letter = symbol(vector).without_type.name
        if letter in scalars and not known.is_defined(letter) and not known.moves(letter):
            if known.is_length(letter):
                role = StatementRole(
                    CONVENTION, "the length of the vector with this letter", "", (letter,)
                )
                name = re.sub(r"\W+", "-", letter).strip("-")
                tex = f"{letter}=|{vector}|"
                yield unprinted(paper, f"length-of-{name}{suffix}", tex), role
    for vector in sorted(known.names.vectors):
        number = _BASIS.fullmatch(symbol(vector).without_type.name)
        free = not known.is_defined(vector) and not known.moves(vector)
        if number is not None and free and len(known.names.vectors[vector]) == SPACE:
            axes = zip("123", AXES, strict=True)
            entries = ",".join(str(int(number[1] in axis)) for axis in axes)
            item = unprinted(paper, f"basis-{number[1]}{suffix}", f"{vector}=({entries})")
            yield item, StatementRole(CONVENTION, "a vector of the basis", "basis", (vector,))
    yield from _along_axes(known, suffix)
    yield from _matrices_of_elements(known, suffix)
    yield from tensors_of_inertia(known, suffix)
    yield from distances(known, suffix)
    yield from _components(known, suffix)
    yield from levels_apart(known, suffix)
    yield from _other_variable(known, suffix)
    yield from values_in_words(known)
    yield from brackets_by_functions(known, suffix)
    yield from brackets_by_momenta(known, suffix)
    for q, p in _conjugate(known):
        tex = rf"\{{{q},{p}\}}=1"
        item = unprinted(paper, re.sub(r"\W+", "-", f"bracket-of-{q}-{p}{suffix}"), tex)
        why = "the canonical bracket, as the equations of motion are those of Hamilton"
        yield item, StatementRole(CONVENTION, why, "", item.printed.heads.names)
    yield from _unit_matrices([*scalars, *sorted(paper.words.matrices & names)], known, suffix)
    yield from momenta(known, suffix)
    if "i" in scalars and not known.units and not known.moves("i"):
        yield (
            unprinted(paper, f"unit{suffix}", "i^2=-1"),
            StatementRole(CONVENTION, "the imaginary unit", "unit"),
        )


_TIMES = (r"\tau", "s", r"\xi", r"\eta")


def _other_variable(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    r"""What moves as another time, by which primes derive: :math:`d\tau=\dot\nu\,dt` for ν."""
    letter, start = known.paper.primed_by
    names = known.paper.words.scalars | known.times
    time = next((one for one in _TIMES if one not in names), "")
    before = [one for one in known.items if one.typed.start <= start]
    if not (letter and time and before and known.varies(letter)):
        return
    tex = rf"d{time}=\dot{{{letter}}}\,dt"
    name = re.sub(r"\W+", "-", f"by-{letter}{suffix}")
    why = f"primes derive by {letter}, as words say"
    yield unprinted(known.paper, name, tex, before[-1]), StatementRole(CONVENTION, why, "clock")


_UNIT = re.compile(
    r"[\s,~]*(?:be|is|denotes?|[-—–]+)?\s*(?:the\s+|a\s+)?(?:unit\s+vector|орт)\s+"
    r"(?:(?:of|along|in\s+the\s+direction\s+of)\s+the(?:\s+positive)?(?:\s+axis\s+of)?|оси)[\s~]*$",
    re.IGNORECASE,
)
"""The words between a vector and the coordinate along the axis of which it is a unit vector."""


def _along_axes(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The vectors that words call unit vectors of the axes of coordinates.

    The coordinates are the components of a vector that moves.
    """
    for one, axis in pairwise(known.items):
        vector = one.formula.name if isinstance(one.formula, Name) else ""
        coordinate = axis.formula.name if isinstance(axis.formula, Name) else ""
        parts = known.names.vectors.get(vector, ())
        if one.sentence != axis.sentence or not parts or not _UNIT.fullmatch(axis.lead):
            continue
        points = [own for own in known.names.vectors.values() if coordinate in own]
        said = known.is_defined(vector) or known.moves(vector)
        if said or not known.moves(coordinate) or len(points) != 1 != len(parts):
            continue
        entries = ",".join(str(int(part == coordinate)) for part in points[0])
        if len(points[0]) == len(parts):
            name = re.sub(r"\W+", "-", f"along-{vector}{suffix}")
            item = unprinted(known.paper, name, f"{vector}=({entries})", one)
            yield item, StatementRole(CONVENTION, "words call it a unit vector", "", (vector,))


def _matrices_of_elements(
    known: Known, suffix: str
) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The matrices of which the elements are defined, all of them, and nothing else is said."""
    for letter in sorted(known.paper.words.matrices):
        if known.is_defined(letter) or known.moves(letter) or letter in known.later:
            continue
        element = re.compile(rf"{re.escape(letter)}_\{{(\d)(\d)\}}")
        found = [one for one in map(element.fullmatch, sorted(known.definitions)) if one]
        size = max((int(one[1]) for one in found), default=0)
        if size > 1 and len(found) == size**2:
            rows = [
                "&".join(f"{letter}_{{{j}{k}}}" for k in range(1, size + 1))
                for j in range(1, size + 1)
            ]
            table = r"\\".join(rows)
            tex = rf"{letter}=\begin{{pmatrix}}{table}\end{{pmatrix}}"
            role = StatementRole(CONVENTION, "the matrix of its elements", "", (letter,))
            yield unprinted(known.paper, f"matrix-{letter}{suffix}", tex), role


def _components(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The components along the axes of vectors that move, where no equation names them."""
    printed = set[str]()
    for item in known.items:
        match item.members:
            case (Name(name), Vector()):
                printed.add(name)
    for vector, parts in sorted(known.names.vectors.items()):
        along = {symbol(part).index or part for part in parts} <= {*AXES}
        free = vector not in printed and not known.is_defined(vector)
        if along and free and any(map(known.moves, parts)):
            name = re.sub(r"\W+", "-", symbol(vector).without_type.name).strip("-")
            role = StatementRole(CONVENTION, "its components along the axes", "vector")
            tex = f"{vector}=({','.join(parts)})"
            yield unprinted(known.paper, f"components-of-{name}{suffix}", tex), role


def _unit_matrices(
    names: Iterable[str], known: Known, suffix: str
) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The unit matrices among names; of what may be one, or something else, nothing is said."""
    supposed = {name for one in known.assumptions for name in known.roles[one].names}
    for name in names:
        said = known.is_defined(name) or known.moves(name) or name in known.later
        if said or name in supposed or _is_introduced(name, known):
            continue
        try:
            for tex in _unit_matrix(name, known):
                id = re.sub(r"\W+", "-", f"unit-matrix-{name}{suffix}")
                role = StatementRole(CONVENTION, "the unit matrix", UNIT_MATRIX, (name,))
                yield unprinted(known.paper, id, tex), role
        except ValueError as error:
            known.lost[name] = str(error)


def _is_introduced(name: str, known: Known) -> bool:
    """Whether words that print a name by itself say that it is another thing."""
    alone = [item for item in known.items if item.formula == Name(name)]
    return bool(alone) and not any(_IDENTITY.search(item.words) for item in alone)


def _unit_matrix(name: str, known: Known) -> Iterator[str]:
    """What defines a name as the unit matrix, if it is one.

    Raises ``ValueError`` if it may be something else, as a tensor of inertia of which words speak.
    """
    formulas = [item.formula for item in known.items if item.formula is not None]
    vectors = [len(parts) for parts in known.names.vectors.values()]
    for tex in unit_matrices(formulas, [name], known.paper.words, vectors):
        if symbol(name).without_type.name == "I" and _INERTIA.search(known.paper.prose.text):
            raise ValueError("I may be the inertia, or the unit matrix: print E or 1 for this")
        yield tex


def _conjugate(known: Known) -> list[tuple[str, str]]:
    """The coordinates with their momenta of equations of Hamilton, if a bracket is not printed."""
    printed = any(name.startswith(BRACKET) for name in known.definitions)
    formulas = (item.formula for item in known.items if item.formula is not None)
    if printed or not any(isinstance(n, PoissonBracket) for one in formulas for n in one.nodes()):
        return []
    laws = (*known.laws, *known.restated)
    found = (
        canonical_pairs([r.formula for r in law.rows if r.formula is not None]) for law in laws
    )
    return next(filter(None, found), []) or _named_so(known)


def _named_so(known: Known) -> list[tuple[str, str]]:
    """All variables of the law as coordinates and momenta by their letters, if words say so."""
    words = known.paper.prose.between(known.paper.prose.start, len(known.paper.prose.text))
    if not (known.laws and _CANONICAL.search(words)):
        return []
    with suppress(ValueError):
        variables = known.laws[0].variables
        pairs = conjugate_pairs(variables)
        return pairs if {name for pair in pairs for name in pair} == {*variables} else []
    return []
