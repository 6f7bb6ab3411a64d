r"""Functions of the law that words give once more: :math:`V(r)=-k/r`, and later another V.

They give another law, by which nothing is judged, and claim nothing against what was given first.
"""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas.notation import Application, Name
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import OTHER, Known, StatementRole
from kowalevski_cas.reading.phrases import plain, supposing
from kowalevski_cas.reading.statements import SourceStatement

GIVEN_ANEW = "given anew"
"""The kind of what gives a function of the law once more."""


def given_anew(item: SourceStatement, known: Known) -> StatementRole | None:
    """A function of one variable that stands in the law, or rests on it, has another formula."""
    said = supposing(item)
    if not said or len(item.members) != 2 or item.derives or cue("deduced", item.before):
        return None
    match item.members:
        case (Name(name) | Application(function=name), right):
            pass
        case _:
            return None
    found = known.definitions.get(name, [])
    own = {*known.varying(right.names())}
    free = {name, *known.functions}
    alike = all({*known.varying(one.names - free)} <= own and not one.derives for one in found)
    if not found or len(own) != 1 or not alike or any(right in one.members for one in found):
        return None
    names = own.union(*(one.names for one in found))
    rests = {name, *known.varying(names)} | _functions(found)
    rests |= {one.name for inner in names for one in known.functions.get(inner, ())}
    mentioned = {one for law in known.laws for one in law.mentions}
    of_laws = mentioned.union(*map(known.below, mentioned))
    defining = [one for inner in of_laws for one in known.definitions.get(inner, ())]
    of_laws |= _functions([*defining, *(row for law in known.laws for row in law.rows)])
    if of_laws.isdisjoint(rests - own):
        return None
    return StatementRole(OTHER, f"“{said}” gives {plain(name)} once more", GIVEN_ANEW, (name,))


def _functions(items: Iterable[SourceStatement]) -> set[str]:
    """The functions that are printed with arguments."""
    nodes = (node for item in items if item.formula is not None for node in item.formula.nodes())
    return {node.function for node in nodes if isinstance(node, Application)}
