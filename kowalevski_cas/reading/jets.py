"""What is claimed, and given, of functions that may be any (:mod:`.free_functions`)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import reduce

from kowalevski_cas.notation import Name, Partial, Relation, to_latex
from kowalevski_cas.paper.claims import Claim, FirstIntegral, Identity, Implication
from kowalevski_cas.paper.implied import HAMILTONIANS, LAGRANGIANS
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.free_functions import CONSIDER, is_of_case, names_of
from kowalevski_cas.reading.known import ASSUMPTION, DEFINITION, FUNCTION, Known, StatementRole
from kowalevski_cas.reading.phrases import reach_of_constants
from kowalevski_cas.reading.statements import SourceStatement, derived_names
from kowalevski_cas.reading.unprinted import unprinted

OF_FUNCTIONS = (Identity, Implication, FirstIntegral)
"""What is claimed where a function may be any: no dependence of several, and no set.

An equation may be given: where it holds, values and derivatives of functions are any that obey it.
"""


def refuse_of_functions(kind: type[Claim], claim: Mapping[str, object], scene: Scene) -> None:
    """Claim equations and integrals only where functions may be any.

    Raises ``ValueError`` for a claim of another kind, as of a set, or of an integral on one.
    """
    on_set = kind is not Implication and claim.get("given")
    if scene.jets and (kind not in OF_FUNCTIONS or on_set):
        raise ValueError(f"it is not judged where {scene.jets[0][0]} may be any function")


def special_function(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives one function as an example: what is judged holds for any.

    Where the equations of motion before have its partial derivatives, as those of a potential,
    this is supposed of what follows, to the end of its case.
    """
    first = item.members[0] if len(item.members) == 2 else None
    if not isinstance(first, Name) or item.derives or not is_of_case(item.before):
        return None
    name = first.name
    once = len(known.later.get(name, ())) == 1 and CONSIDER.search(item.before)
    if once and name not in known.functions:
        return None  # it is the only one that is considered
    every = known.functions.get(name, ())
    by = [{*one.by, *known.names.scalars(one.by)} for one in every if one.name == name]
    if by and not any({*known.varying(item.members[1].names())} <= one for one in by):
        return None
    if not (by or _is_of_law(name, item, known)):
        return None
    reach = "" if _begins_section(item, known) else reach_of_constants(item)
    why = f"one of the functions that {name} may be"
    return StatementRole(ASSUMPTION, why, f"{FUNCTION} {reach}".strip(), (name,))


def derivatives_of(
    special: SourceStatement, names: Collection[str], known: Known
) -> dict[str, SourceStatement]:
    """The derivatives of a function by its argument that some names are, where it is special."""
    (name,) = known.roles[special].names
    values = [value for value in special.members if value != Name(name)]
    found: dict[str, SourceStatement] = {}
    for by in (one.by[0] for one in known.functions.get(name, ()) if len(one.by) == 1):
        orders = {n: len(n) - len(name) for n in names if n.rstrip("'") == name != n}
        for derived, order in orders.items():
            value = reduce(Partial, [by] * order, values[0])
            tex = to_latex(Relation((Name(derived), value), ("=",)))
            id = f"{special.printed.display.id}-derivative-{order}"
            found[derived] = unprinted(known.paper, id, tex, special)
    return found


def _begins_section(item: SourceStatement, known: Known) -> bool:
    """Whether a section begins with the sentence of a statement: then it is about its case."""
    before = (one.sections[-1] for one in known.items if one.order < item.order)
    within = len(item.sections) > 1 and item.sections[-1] not in before
    return within and item.before == item.lead


def _is_of_law(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a law before a statement has partial derivatives of a function, and of no energy."""
    any_function = name in known.functions
    if (name in (*HAMILTONIANS, *LAGRANGIANS) and not any_function) or known.is_defined(name):
        return False
    rows = [row for law in known.laws for row in law.rows if row.order < item.order]
    return name in {one for row in rows for one in derived_names(row)}


def gives_derivative(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""What gives the derivative of a new function, as :math:`\beta'(x)=b(x)`."""
    first = item.members[0] if len(item.members) == 2 else None
    if not cue("define", item.before):
        return None
    if not isinstance(first, Name) or not first.name.endswith("'"):
        return None
    for one in known.functions.get(first.name, ()):
        new = known.seen.keys().isdisjoint(names_of((one,)))
        if new and names_of((one,)).isdisjoint(item.members[1].names()):
            why = f"gives the derivative of the function {one.name}"
            return StatementRole(DEFINITION, why, "", (first.name,))
    return None
