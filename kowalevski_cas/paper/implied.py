r"""What a Hamiltonian, a Lagrangian or canonical equations imply, and papers do not print.

Of :math:`H=\frac12p^2+U` beside the brackets of the coordinates the equations of motion are
:math:`\dot x=\{x,H\}`, or :math:`\{H,x\}` if :math:`\{p,q\}=1` is printed; without brackets those
of Hamilton, where each momentum tells its coordinate: :math:`p_i` that of :math:`q_i`,
:math:`p_\varphi` that of :math:`\varphi`. Of :math:`L` they are those of Lagrange. Where equations
of Hamilton are printed, the canonical bracket goes with them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Negative,
    Partial,
    PoissonBracket,
    Relation,
)
from kowalevski_cas.notation.symbol import rate_name, symbol

HAMILTONIANS, LAGRANGIANS = ("H", r"\mathcal{H}"), ("L", r"\mathcal{L}")
_SPACE = ["1", "2", "3"]
_PERMUTATIONS = (r"\varepsilon", r"\epsilon")
_COORDINATES = ("q", "x", r"\theta", r"\varphi", r"\phi", "r")


def implied_equations(formulas: Sequence[Formula]) -> list[str]:
    """The equations of motion, and the brackets, that are not printed beside some formulas.

    Raises ``ValueError`` if it cannot be seen which coordinate belongs to a momentum.
    """
    if pairs := canonical_pairs(formulas):
        return [] if [*_coordinates(formulas)] else canonical_brackets(pairs)
    if any(map(_is_rate, formulas)):
        with suppress(ValueError):
            return canonical_brackets(conjugate_pairs(_by_brackets(formulas)))
        return []
    heads = {name for formula in formulas for name in _heads(formula)}
    energy = next((name for name in HAMILTONIANS if name in heads), "")
    if coordinates := [*_coordinates(formulas)] if energy else []:
        turned = any(map(_is_turned, formulas))
        sides = ((energy, x) if turned else (x, energy) for x in coordinates)
        return [
            rf"{rate_name(x)}=\{{{a},{b}\}}" for x, (a, b) in zip(coordinates, sides, strict=True)
        ]
    rated = dict.fromkeys(name for formula in formulas for name in _rated(formula))
    action = next((name for name in LAGRANGIANS if name in heads), "")
    if action and rated:
        return [lagrange(action, x) for x in rated]
    if energy and not rated:
        names = dict.fromkeys(name for formula in formulas for name in sorted(formula.names()))
        pairs = conjugate_pairs([name for name in names if name not in heads])
        return [*hamilton(energy, pairs), *canonical_brackets(pairs)]
    return []


def hamilton(energy: str, pairs: Iterable[tuple[str, str]]) -> Iterator[str]:
    """The canonical equations of an energy."""
    for q, p in pairs:
        yield rf"{rate_name(q)}=\frac{{\partial {energy}}}{{\partial {p}}}"
        yield rf"{rate_name(p)}=-\frac{{\partial {energy}}}{{\partial {q}}}"


def lagrange(action: str, coordinate: str, potential: str = "") -> str:
    """The equation of Lagrange for a coordinate; of a kinetic energy, with its ``potential``."""
    momentum = rf"\frac{{\partial {action}}}{{\partial {rate_name(coordinate)}}}"
    force = rf"-\frac{{\partial {potential}}}{{\partial {coordinate}}}" if potential else ""
    slope = rf"\frac{{\partial {action}}}{{\partial {coordinate}}}"
    return rf"\frac{{d}}{{dt}}{momentum}={slope}{force}"


def canonical_brackets(pairs: Iterable[tuple[str, str]]) -> list[str]:
    """The brackets of coordinates with their momenta."""
    return [rf"\{{{q},{p}\}}=1" for q, p in pairs if not symbol(q).font]


def canonical_pairs(formulas: Iterable[Formula]) -> list[tuple[str, str]]:
    """The coordinates with their momenta, by equations of Hamilton; none if others stand beside."""
    rows = [*filter(_is_rate, formulas)]
    by = {(x, y): sign for row in rows for x, y, sign in _gradient(row)}
    pairs = [(q, p) for (q, p), sign in by.items() if sign > 0 and by.get((p, q)) == -1]
    return pairs if 2 * len(pairs) == len(rows) else []


def conjugate_pairs(names: Sequence[str]) -> list[tuple[str, str]]:
    """The coordinates with their momenta among names.

    Raises ``ValueError`` if there are no momenta, or if one has no coordinate.
    """
    momenta = [name for name in names if symbol(name).letter in ("p", "P")]
    pairs = [(_coordinate(name, names), name) for name in momenta]
    if not pairs or any(not q for q, _ in pairs) or len(dict(pairs)) < len(pairs):
        said = ", ".join(p for q, p in pairs if not q) or ", ".join(names)
        raise ValueError(
            rf"what moves, and how? of {said} it is not known which coordinates and momenta belong "
            r"together: print \{q,p\}=1 for each pair, or the equations"
        )
    return pairs


def _coordinate(momentum: str, names: Sequence[str]) -> str:
    """The coordinate of a momentum, by its index, or by its letter; empty if it is not known."""
    parts = symbol(momentum)
    index = parts.index
    letters = ("Q",) if parts.letter == "P" else _COORDINATES
    same = [replace(parts, letter=letter).name for letter in letters]
    printed = [name for name in same if name in names]
    if index and not index.isdecimal():
        return index if index in names or not printed else printed[0]
    if printed:
        return printed[0] if printed[0] == same[0] or len(printed) == 1 else ""
    return same[0] if index else ""


def momenta_at_rest(formulas: Iterable[Formula], moving: Collection[str]) -> list[str]:
    """The momenta of what moves that stand in a Hamiltonian, and have no equation of motion."""
    energies = [one for one in formulas if {*_heads(one)} & {*HAMILTONIANS}]
    names = sorted(name for name in set[str]().union(*(one.names() for one in energies)))
    momenta = [name for name in names if symbol(name).letter in ("p", "P") and name not in moving]
    known = [*moving, *names]
    return [name for name in momenta if _coordinate(name, known) in moving]


def _heads(formula: Formula) -> Iterator[str]:
    """The names that a formula has alone on a side."""
    for member in formula.members if isinstance(formula, Relation) else ():
        if isinstance(member, Name):
            yield member.name
        elif isinstance(member, Application):
            yield member.function


def _is_turned(formula: Formula) -> bool:
    r"""Whether the bracket of a momentum with its coordinate is printed, :math:`\{p,q\}=1`.

    Then the equations of motion are :math:`\dot x=\{H,x\}`.
    """
    match formula:
        case Relation((PoissonBracket(Name(x), Name(y)), value), _):
            pair = (y, x) if isinstance(value, Negative) else (x, y)
            return (
                symbol(pair[0]).letter in ("p", "P") and _coordinate(pair[0], pair[1:]) == pair[1]
            )
    return False


def _coordinates(formulas: Sequence[Formula]) -> Iterator[str]:
    """The coordinates of which brackets are printed, without those beyond the end of a chain."""
    found: dict[str, None] = {}
    same: dict[str, str] = {}
    names = set[str]().union(*(formula.names() for formula in formulas))
    vectors = {*_vectors(formulas)}
    for formula in formulas:
        match formula:
            case Relation((PoissonBracket(Name(x), Name(y)), _), _):
                each = [point for name in (x, y) for point in _indexed(name, names, vectors)]
                found.update(dict.fromkeys(each))
            case Relation((Name(x), Name(y)), _):
                same[x] = y
    yield from (name for name in found if same.get(name) not in found)


def _vectors(formulas: Iterable[Formula]) -> Iterator[str]:
    r"""The letters of vectors, as in :math:`\{M_i,\gamma_j\}=\varepsilon_{ijk}\gamma_k`."""
    for formula in formulas:
        match formula:
            case Relation((PoissonBracket(Name(x), Name(y)), value), _):
                if any(symbol(name).letter in _PERMUTATIONS for name in value.names()):
                    yield from (symbol(name).head for name in (x, y))


def _indexed(name: str, names: Iterable[str], vectors: Collection[str]) -> list[str]:
    """A coordinate, for each value of its index that is printed; of three if none is.

    A component of a vector has three.
    """
    parts = symbol(name)
    if parts.index not in ("i", "j"):
        return [name]
    if parts.head in vectors:
        return [replace(parts, index=value).name for value in _SPACE]
    others = (symbol(one) for one in names)
    printed = {one.index for one in others if one.head == parts.head and one.index.isdecimal()}
    values = sorted(printed, key=int) or _SPACE
    return [replace(parts, index=value).name for value in values]


def _is_rate(formula: Formula) -> bool:
    """Whether it is an equation with a rate that is no definition of a name."""
    if not isinstance(formula, Relation) or isinstance(formula.members[0], Name | Application):
        return False
    return any(isinstance(node, Derivative) for node in formula.nodes())


def _by_brackets(formulas: Sequence[Formula]) -> list[str]:
    """What moves by its bracket with a function, if all does, and no bracket is printed."""
    rows = [formula for formula in formulas if _is_rate(formula)]
    moving = [name for row in rows for name in _bracketed(row)]
    return moving if len(moving) == len(rows) and not [*_coordinates(formulas)] else []


def _bracketed(row: Formula) -> Iterator[str]:
    """What moves by its bracket with something."""
    match row:
        case Relation((Derivative(Name(x)), PoissonBracket(Name(y), _)), _) if x == y:
            yield x


def _rated(formula: Formula) -> Iterator[str]:
    """The names that are derived by the time."""
    for node in formula.nodes():
        if isinstance(node, Derivative) and isinstance(node.argument, Name):
            yield node.argument.name


def _gradient(row: Formula) -> Iterator[tuple[str, str, int]]:
    """What moves by a row, by what the energy is derived there, and the sign."""
    match row:
        case Relation((Derivative(Name(x)), Partial(Name(), y)), _):
            yield x, y, 1
        case Relation((Derivative(Name(x)), Negative(Partial(Name(), y))), _):
            yield x, y, -1
