r"""That printed equations of motion are those of the Lagrangian, or the Hamiltonian, beside them.

Where both are printed, neither is taken on trust: each equation of Lagrange, or of Hamilton, is
claimed along the printed motion; equations of the second order without momenta are claimed along
that of the Hamiltonian. Where a row has a constant that the energy has not, more acts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from kowalevski_cas.notation import Derivative, Formula, Name
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.paper.implied import (
    HAMILTONIANS,
    LAGRANGIANS,
    conjugate_pairs,
    hamilton,
    lagrange,
)
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.in_words import InWords
from kowalevski_cas.reading.known import DEFINITION, Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.laws import is_of_second_order
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.rows import is_of_motion
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import gives_lagrangian, is_of_momenta, is_printed, unprinted

SAYS = "the equations of motion are those of this function"
OF_ENERGY = "energy"
"""How these claims are called."""
SOURCE = "the Lagrangian, or the Hamiltonian"


def claims_of_energies(parts: Parts) -> Iterator[InWords]:
    """That the law of a part is that of the energy which its words call so, row by row."""
    for place, known in enumerate(parts.known):
        laws = [law for law in known.laws if not (law.change or law.images or law.together)]
        if len(laws) != 1 or known.laws != laws or known.restated or known.clocks:
            continue
        for item in known.items:
            said = cue("hamiltonian", item.words) or is_of_momenta(item, known.paper)
            said = said or (gives_lagrangian(item) and _is_of_sentence(laws[0], item))
            if said and _gives_energy(item, known):
                yield from _claims(item, laws[0], known, parts, place)


def _is_of_sentence(law: Law, item: SourceStatement) -> bool:
    """Whether all rows of a law stand behind a statement in its sentence."""
    return all(row.sentence == item.sentence and row.order > item.order for row in law.rows)


def _gives_energy(item: SourceStatement, known: Known) -> bool:
    """Whether a display, or words right before, give one of these by its usual letter."""
    letters = (*LAGRANGIANS, *HAMILTONIANS)
    first = item.members[0] if item.members else None
    return (
        known.roles[item].name == DEFINITION
        and isinstance(first, Name)
        and first.name in letters
        and not (item.typed.inline and not cue("hamiltonian", item.lead))
    )


def _claims(
    item: SourceStatement, law: Law, known: Known, parts: Parts, place: int
) -> Iterator[InWords]:
    """The claims that a law is that of one energy."""
    if not all(map(is_printed, law.rows)) or _has_more(item, law, known):
        return
    rows = [*_rows(item, law)]
    span = (item.typed.start, item.typed.end)
    if canonical := _canonical(item, law, known, parts, place):
        for row in law.rows:
            printed: dict[str, object] = {"printed": row.printed}
            yield InWords(
                span, Identity, (row,), printed, OF_ENERGY, SAYS, item, canonical, Doubt.ALWAYS
            )
    for number, tex in enumerate(rows, 1):
        last = max(law.rows, key=lambda row: row.order)
        beside = max(last, item, key=lambda one: one.order)
        found = unprinted(known.paper, f"of-energy-{item.order}-{number}", tex, beside, SOURCE)
        parts.places[found] = place
        values: dict[str, object] = {"printed": found.printed}
        yield InWords(span, Identity, (found,), values, OF_ENERGY, SAYS, item)


def _rows(item: SourceStatement, law: Law) -> Sequence[str]:
    """The equations of Lagrange or Hamilton for what moves; none if that is not all of it."""
    name = item.bare[0]
    members = [member for row in law.rows for member in row.members]
    orders = {
        x: max(_order(member, x) for member in members) for row in law.rows for x in row.rates
    }
    first = {*orders.values()} == {1}
    if name in LAGRANGIANS:
        whole = {*orders} == {*law.variables} >= {*item.rates} and {*orders.values()} == {2}
        return [lagrange(name, x) for x in law.variables] if whole else []
    with suppress(ValueError):
        pairs = conjugate_pairs(law.variables) if first else []
        if {x for pair in pairs for x in pair} == {*law.variables}:
            return [*hamilton(name, pairs)]
    return []


def _order(formula: Formula, name: str) -> int:
    """The highest order of a derivative of what has a name in it."""
    below = max((_order(child, name) for child in formula.children()), default=0)
    return below + (isinstance(formula, Derivative) and name in formula.names())


def _canonical(
    item: SourceStatement, law: Law, known: Known, parts: Parts, place: int
) -> Law | None:
    """The law of a Hamiltonian for which that of its coordinates is of the second order."""
    name = item.bare[0]
    if not all(map(is_of_motion, law.rows)):
        return None
    if name not in HAMILTONIANS or not is_of_second_order(law):
        return None
    with suppress(ValueError):
        pairs = conjugate_pairs(sorted(item.names))
        if {q for q, _ in pairs} != {*law.variables} or any(known.is_defined(p) for _, p in pairs):
            return None
        rows = tuple(
            unprinted(known.paper, f"canonical-{item.order}-{number}", tex, item, SOURCE)
            for number, tex in enumerate(hamilton(name, pairs), 1)
        )
        parts.places |= dict.fromkeys(rows, place)
        return Law(rows, law.names)
    return None


def _has_more(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether words tell another force, or a row has a constant that the energy has not."""
    own = {inner for name in item.names for inner in known.below(name)}
    functions = known.paper.functions_by_name
    own |= {jet for jet, of in functions.items() if own & {one.name for one in of}}
    acting = {inner for name in law.mentions for inner in known.below(name)}
    end = max(one.typed.end for one in (*law.rows, item))
    words = known.paper.prose.between(item.section.start, end)
    told = any(cue(name, words) for name in ("force", "rolling", "multiplier", "constraint"))
    return told or bool({one for one in acting if not known.moves(one)} - own)
