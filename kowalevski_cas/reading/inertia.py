"""Tensors of inertia of which a paper prints no elements: symmetric matrices of constants."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from kowalevski_cas.notation import Derivative, Formula, Name, Product
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.known import CONVENTION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

INERTIA = "inertia"
"""The kind of these conventions."""
SPACE = 3
_BODY = re.compile(
    r"\b(?:inertia|rigid|bod(?:y|ies)|tops?|gyro\w*|Euler|инерци|тв[её]рд|тел[аоу]|волч|гиро)",
    re.IGNORECASE,
)
_UNIT = re.compile(
    r"\b(?:unit|identity)\s+(?:matrix|tensor|operator)|\b(?:scalar|spherical)\b|\bединичн|\bскалярн\w+\s+момент|\bшаров",
    re.IGNORECASE,
)


def tensors_of_inertia(
    known: Known, suffix: str
) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """What matrices are that stand before what moves, of a body, and that nothing defines."""
    paper = known.paper
    words = paper.prose.text
    if not _BODY.search(words) or _UNIT.search(words):
        return
    names = frozenset().union(*(one.names for one in known.items))
    for name in sorted(paper.words.matrices & names):
        letter = symbol(name).without_type.name
        elements = {f"{letter}_{{{j}{k}}}" for j in range(1, 4) for k in range(1, 4)}
        said = known.is_defined(name) or known.moves(name) or name in known.later
        if said or elements & names or not _acts(name, known):
            continue
        rows = (
            "&".join(f"{letter}_{{{min(j, k)}{max(j, k)}}}" for k in range(1, SPACE + 1))
            for j in range(1, SPACE + 1)
        )
        table = r"\\".join(rows)
        id = re.sub(r"\W+", "-", f"tensor-of-inertia-{name}{suffix}")
        role = StatementRole(
            CONVENTION, "a tensor of inertia, which is symmetric", INERTIA, (name,)
        )
        yield unprinted(paper, id, rf"{name}=\begin{{pmatrix}}{table}\end{{pmatrix}}"), role


def _acts(name: str, known: Known) -> bool:
    """Whether a matrix stands right before a vector of space, or its rate, wherever it stands."""
    products = (
        node.factors
        for one in known.items
        if one.formula is not None
        for node in one.formula.nodes()
        if isinstance(node, Product) and Name(name) in node.factors
    )
    found = [pair[1] for factors in products for pair in pairwise(factors) if pair[0] == Name(name)]
    return bool(found) and all(_is_vector(one, known) for one in found)


def _is_vector(formula: Formula, known: Known) -> bool:
    while isinstance(formula, Derivative):
        formula = formula.argument
    return isinstance(formula, Name) and len(known.names.vectors.get(formula.name, ())) == SPACE
