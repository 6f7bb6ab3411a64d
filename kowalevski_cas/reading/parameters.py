r"""Parameters of functions that are derived, as :math:`\ell` in :math:`U(r)=\ell^2/2r^2+V(r)`.

They are given by what moves, and are constant where the function is derived by its argument.
"""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Application, Derivative, Formula, Name, Partial
from kowalevski_cas.paper.jets import APPLIED, arguments
from kowalevski_cas.paper.names import head
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.statements import SourceStatement


def held_fixed(item: SourceStatement, known: Known) -> Iterator[SourceStatement]:
    """What gives the parameters of the functions that a statement derives partially.

    They are names for what moves in a function that is printed at its arguments, or the values of
    integrals. None of them, nor the function, is derived by the time.
    """
    nodes = [*item.formula.nodes()] if item.formula is not None else []
    rated = [node.argument for node in nodes if isinstance(node, Derivative)]
    moving = {name for one in rated for own in one.names() for name in known.below(own)}
    for node in nodes:
        if isinstance(node, Partial) and (function := _function(node.argument)):
            by = known.definition(function, item)
            for name in sorted(_parameters(function, by, known)) if by is not None else ():
                given = known.definition(name, item)
                if given is not None and name not in moving:
                    yield given


def _function(formula: Formula) -> str:
    """The name of a function, by itself or at its arguments."""
    match formula:
        case Name(name):
            return name
        case Application(function, _):
            return function
    return ""


def _parameters(function: str, by: SourceStatement, known: Known) -> set[str]:
    """The names in what gives a function that stand for what moves and are no arguments.

    What is given by the arguments alone, as a distance by its coordinates, is no parameter.
    """
    at = {name for one in by.printed.heads.names for name in head(one)[1]}
    at |= {*_arguments(function, by, known)}
    names = {name for member in by.members[1:] for name in member.names()} - at
    given = {n for n in names if known.is_defined(n) and known.varies(n) and not known.moves(n)}
    if at:
        given = {n for n in given if not {*filter(known.moves, known.below(n))} <= at}
    return given if at else given & known.levels


def _arguments(function: str, by: SourceStatement, known: Known) -> Iterator[str]:
    """The arguments at which a statement gives a function, which it is read without."""
    text = known.paper.source.text[by.typed.start : by.typed.end]
    for found in APPLIED.finditer(text):
        if found["name"] == function:
            yield from arguments(found["by"])
