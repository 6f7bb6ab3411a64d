r"""That printed equations of motion are those of the Lagrangian, or the Hamiltonian, beside them.

Where both are printed, neither is taken on trust: each equation of Lagrange, or of Hamilton, is
claimed along the printed motion; equations of the second order without momenta are claimed along
that of the Hamiltonian. Where a row has a constant that the energy has not, more acts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress

from kowalevski_cas.notation import Application, Derivative, Name
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.paper.claims import Claim, FirstIntegral, Identity
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
from kowalevski_cas.reading.momenta_of_energies import is_lagrangian
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.polar import ANGLES
from kowalevski_cas.reading.rows import is_of_motion
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.two_energies import (
    has_squares_of_rates,
    is_named,
    potential_energy,
    two_energies,
)
from kowalevski_cas.reading.unprinted import (
    gives_lagrangian,
    is_of_momenta,
    is_printed,
    tells_more,
    unprinted,
)

SAYS = "the equations of motion are those of this function"
OF_ENERGY = "energy"
"""How these claims are called."""
SOURCE = "the Lagrangian, or the Hamiltonian"


def claims_of_energies(parts: Parts) -> Iterator[InWords]:
    """That the law of a part is that of the energy which its words call so, row by row."""
    for place, known in enumerate(parts.known):
        # in new variables it is the same
        laws = [law for law in known.laws if not (law.change or law.together)]
        if len(laws) != 1 or laws[0].images or known.restated or known.clocks:
            continue
        for item in known.items:
            if _is_of_special_case(item, laws[0], known):
                continue
            said = cue("hamiltonian", item.words) or is_of_momenta(item, known.paper)
            said = said or (gives_lagrangian(item) and _is_of_sentence(laws[0], item))
            # the letter alone may be that of something else
            doubt = Doubt.UNLESS_MENDED if said else Doubt.ALWAYS
            said = said or _is_deduced(laws[0], item)
            if said and _gives_energy(item, laws[0], known):
                yield from _claims(item, laws[0], known, parts, place, doubt)
        if (pair := two_energies(known.items)) is not None:
            yield from _of_two(*pair, laws[0], parts)
        elif (potential := potential_energy(known.items)) is not None:
            yield from _of_potential(potential, laws[0], parts)
        if all(map(_is_acceleration, laws[0].rows)):
            yield from _of_total(laws[0], known)
        yield from _of_momenta(laws[0], known, parts)


_SPECIAL = re.compile(
    r"\b(?:if|when|for|with|without|on|in|at|units?|times?|measured|counted|backwards?|conventions?"
    r"|dimensionless|scal\w+|cho(?:ose|os\w+)|instead|opposite|revers\w+|coordinates|frame|limit|small|near"
    r"|linear\w*|approximat\w*|suppos\w+|let|put|setting|set|tak\w+|now"
    r"|при|если|когда|для|без|в|на|единиц\w*|врем\w+|пусть|положим|вблизи)\b|§",
    re.IGNORECASE,
)
"""Words that may tell of another case, time or frame than that of an energy before them."""


def _is_of_special_case(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether words between an energy and equations behind it may set up a special case."""
    if law.first.order < item.order:
        return False
    same = law.first.sentence == item.sentence
    begin = item.typed.end if same else item.sentence[1]
    between = known.paper.prose.between(begin, law.first.typed.start)
    return bool(_SPECIAL.search(between))


def _is_of_sentence(law: Law, item: SourceStatement) -> bool:
    """Whether all rows of a law stand behind a statement in its sentence."""
    return all(row.sentence == item.sentence and row.order > item.order for row in law.rows)


_EQUATIONS = re.compile(
    r"\b(?:Hamilton|canonical|Lagrange|Euler)\S*\s+(?:\w+\s+)?equations?\b|\bequations?\s+of\s+motion\b"
    r"|\b(?:leads?\s+to|gives?|yields?)[\s~:]*$"
    r"|\bуравнени\w+\s+(?:движения|Гамильтона|Лагранжа)\b",
    re.IGNORECASE,
)
"""Words for equations that an energy has."""


def _is_deduced(law: Law, item: SourceStatement) -> bool:
    """Whether words deduce a law from what stands before it in its paragraph, as a Hamiltonian.

    So do those that call it the equations of motion.
    """
    behind = item.order < law.first.order and law.first.paragraph == item.paragraph
    named = item.bare[:1] and item.bare[0] in (*HAMILTONIANS, *LAGRANGIANS)
    words = f"{law.first.before} "
    deduced = any(cue(name, words) for name in ("deduced", "then")) or _EQUATIONS.search(words)
    return bool(named and behind and deduced)


_CALLED = re.compile(
    r"[\s,~]*(?:be|is|denotes?|[-—–]+)\s+(?:(?:the|our|its|an?)\s+)?(?:\w+\s+)?"
    r"(?:hamilton|lagrang|функци\w+\s+(?:гамильтон|лагранж)|гамильтониан|лагранжиан)",
    re.IGNORECASE,
)
"""How words begin that call what is printed before them so."""


def _gives_energy(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether a display, or words right beside, give one of these by its usual letter."""
    letters = (*LAGRANGIANS, *HAMILTONIANS)
    first = item.members[0] if item.members else None
    return (
        known.roles[item].name == DEFINITION
        and isinstance(first, Name)
        and first.name in letters
        and bool(
            not item.typed.inline
            or cue("hamiltonian", item.lead)
            or _CALLED.match(item.tail)
            or _is_deduced(law, item)
        )
    )


def _claims(
    item: SourceStatement, law: Law, known: Known, parts: Parts, place: int, doubt: Doubt
) -> Iterator[InWords]:
    """The claims that a law is that of one energy."""
    if not all(map(is_printed, law.rows)) or _have_more((item,), law, known):
        return
    rows = [*_rows(item, law)]
    span = (item.typed.start, item.typed.end)
    if canonical := _canonical(item, law, known, parts, place):
        for row in law.rows:
            printed: dict[str, object] = {"printed": row.printed}
            yield InWords(
                span, Identity, (row,), printed, OF_ENERGY, SAYS, item, canonical, Doubt.ALWAYS
            )
    elif not rows and _is_of_this_law(item, law, known):
        integral: dict[str, object] = {"printed": item.printed}
        says = "this is constant along every motion"
        yield InWords(
            span, FirstIntegral, (item,), integral, OF_ENERGY, says, item, law, Doubt.ALWAYS
        )
    yield from _each(rows, item, law, parts, doubt)


def _is_of_this_law(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether a Hamiltonian is printed in the letters of a law, and words speak of no other one."""
    name, words = item.bare[0], f"{item.words} {law.first.words}"
    other = cue("another system", words) or cue("another case", words)
    below = {inner for name in item.names for inner in known.below(name)} - {name, *item.bare}
    letters = {*known.names.scalars(law.mentions)} | known.definitions.keys()
    return name in HAMILTONIANS and "t" not in below and below <= letters and not other


def _each(
    rows: Sequence[str],
    item: SourceStatement,
    law: Law,
    parts: Parts,
    doubt: Doubt = Doubt.UNLESS_MENDED,
) -> Iterator[InWords]:
    """The claims of the equations of an energy."""
    span = (item.typed.start, item.typed.end)
    for number, tex in enumerate(rows, 1):
        last = max(law.rows, key=lambda row: row.order)
        beside = max(last, item, key=lambda one: one.order)
        found = unprinted(parts.paper, f"of-energy-{item.order}-{number}", tex, beside, SOURCE)
        parts.places[found] = parts.places[item]
        values: dict[str, object] = {"printed": found.printed}
        yield InWords(span, Identity, (found,), values, OF_ENERGY, SAYS, item, doubt=doubt)


_TOTAL = re.compile(
    r"(?<!kinetic\s)(?<!potential\s)\benergy(?:\s+(?:of|per)\s+(?:\w+\s+){1,3}?)?[\s~]*(?:(?:is|be|reads?|integral)[\s~]*)*$",
    re.IGNORECASE,
)
_BE_TOTAL = re.compile(
    r"[\s,~]*(?:be|is|denotes?)\s+(?:its|the|our)\s+(?:\w+\s+)?energy\b", re.IGNORECASE
)
"""Words before, or behind, what they call the energy."""


def _of_total(law: Law, known: Known) -> Iterator[InWords]:
    """That what words call the energy is constant, where each row gives an acceleration by places.

    A definition says what it is; that it is the energy of this law is claimed by these words.
    """
    for item in known.items:
        named = (_TOTAL.search(item.lead) or _BE_TOTAL.match(item.tail)) and item.bare[:1]
        if not named or known.roles[item].name != DEFINITION or not has_squares_of_rates(item):
            continue
        below = {inner for name in item.names for inner in known.below(name)}
        acting = {inner for name in law.mentions for inner in known.below(name)}
        rated = known.names.scalars(item.rates)
        mine = {*rated} <= {*law.variables} and "t" not in below | acting
        if not mine or _have_more((item,), law, known):
            continue
        span, says = (item.typed.start, item.typed.end), "this is constant along every motion"
        value: dict[str, object] = {"printed": item.printed}
        yield InWords(span, FirstIntegral, (item,), value, OF_ENERGY, says, item, law, Doubt.ALWAYS)


def _of_momenta(law: Law, known: Known, parts: Parts) -> Iterator[InWords]:
    r"""That a Hamiltonian is the one of its law, where momenta in it are given by velocities.

    Behind a Lagrangian it is :math:`\sum\dot x\,\partial L/\partial\dot x-L`; else it is constant.
    """
    lagrangians = [one for one in known.items if is_lagrangian(one, known)]
    for item in known.items:
        called = cue("hamiltonian", item.lead) or _CALLED.match(item.tail)
        named = item.bare[:1] and item.bare[0] in HAMILTONIANS
        if not (called and named) or known.roles[item].name != DEFINITION or item.derives:
            continue
        given = any(map(known.has_velocities, item.names - {*item.bare}))
        below = {inner for name in item.names for inner in known.below(name)}
        before = [one for one in lagrangians if one.order < item.order]
        defining = [one for name in law.mentions for one in known.definitions.get(name, ())]
        more = _have_more((item, *before, *defining), law, known)
        if not given or "t" in below or len(before) > 1 or more:
            continue
        kind: type[Claim] = Identity if before else FirstIntegral
        own = _of_lagrangian(item, before[0], parts) if before else item
        says = _LEGENDRE if before else "this is constant along every motion"
        doubt = Doubt.UNLESS_MENDED if before else Doubt.ALWAYS
        if not before and not all(map(_is_acceleration, law.rows)):
            continue
        span, value = (item.typed.start, item.typed.end), dict[str, object](printed=own.printed)
        yield InWords(span, kind, (own,), value, OF_ENERGY, says, item, law, doubt)


_LEGENDRE = "this is the Hamiltonian of the Lagrangian"


def _of_lagrangian(
    item: SourceStatement, lagrangian: SourceStatement, parts: Parts
) -> SourceStatement:
    """The equation of the Hamiltonian of a Lagrangian, which the paper does not print."""
    letter = lagrangian.bare[0]
    moving = parts.of(item).names.scalars(lagrangian.rates)
    terms = (
        rf"\dot{{{x}}}\frac{{\partial {letter}}}{{\partial \dot{{{x}}}}}"
        for x in dict.fromkeys(moving)
    )
    tex = f"{item.bare[0]}={'+'.join(terms)}-{letter}"
    found = unprinted(parts.paper, f"of-lagrangian-{item.order}", tex, item, "the Lagrangian")
    parts.places[found] = parts.places[item]
    return found


def _of_two(
    kinetic: SourceStatement, potential: SourceStatement, law: Law, parts: Parts
) -> Iterator[InWords]:
    """The claims that a law is that of a kinetic energy and a potential one."""
    names = (kinetic.bare[0], potential.bare[0])
    behind = all(row.order > kinetic.order for row in law.rows) and all(map(is_printed, law.rows))
    if (
        behind
        and _is_whole(kinetic, law)
        and not _have_more((kinetic, potential), law, parts.of(kinetic))
    ):
        rows = [lagrange(names[0], x, names[1]) for x in law.variables]
        doubt = Doubt.UNLESS_MENDED if is_named(potential) else Doubt.ALWAYS
        yield from _each(rows, kinetic, law, parts, doubt)


def _of_potential(potential: SourceStatement, law: Law, parts: Parts) -> Iterator[InWords]:
    r"""The claims that accelerations are those of a potential: :math:`m\ddot x=-U_x`.

    The mass is the letter m, if it stands in the law or the potential; each row has its own
    acceleration, and no velocity.
    """
    known, mass = parts.of(potential), "m"
    below = {inner for name in potential.names for inner in known.below(name)}
    acting = {inner for name in law.mentions for inner in known.below(name)}
    more = {name for name in acting - below if not (known.moves(name) or known.is_defined(name))}
    angles = {*ANGLES} & {*law.variables} or any(map(_has_sines, (potential, *law.rows)))
    if more - {mass} or angles or not all(map(_is_acceleration, law.rows)):
        return
    words = known.paper.prose.between(potential.section.start, law.first.typed.end)
    if law.first.order < potential.order or tells_more(words) or known.bound:
        return
    factor = mass if mass in law.mentions | below else ""
    rows = [
        rf"{factor}\ddot{{{x}}}=-\frac{{\partial {potential.bare[0]}}}{{\partial {x}}}"
        for x in law.variables
    ]
    yield from _each(rows, potential, law, parts, Doubt.ALWAYS)


def _is_acceleration(row: SourceStatement) -> bool:
    """Whether an equation gives one acceleration by places."""
    right = [*row.members[1].nodes()] if len(row.members) == 2 else []
    return [*row.rates.values()] == [2] and not any(isinstance(one, Derivative) for one in right)


def _has_sines(item: SourceStatement) -> bool:
    """Whether functions as the sine stand in a statement: what moves may be an angle."""
    nodes = item.formula.nodes() if item.formula is not None else ()
    return any(isinstance(one, Application) and one.function in FUNCTIONS for one in nodes)


def _is_whole(item: SourceStatement, law: Law) -> bool:
    """Whether a law is of the second order, and moves all of which an energy has rates."""
    orders = law.orders
    return {*orders} == {*law.variables} >= {*item.rates} and {*orders.values()} == {2}


def _rows(item: SourceStatement, law: Law) -> Sequence[str]:
    """The equations of Lagrange or Hamilton for what moves; none if that is not all of it."""
    name = item.bare[0]
    first = {*law.orders.values()} == {1}
    if name in LAGRANGIANS:
        return [lagrange(name, x) for x in law.variables] if _is_whole(item, law) else []
    with suppress(ValueError):
        pairs = conjugate_pairs(law.variables) if first else []
        if {x for pair in pairs for x in pair} == {*law.variables}:
            return [*hamilton(name, pairs)]
    return []


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


def _have_more(energies: Sequence[SourceStatement], law: Law, known: Known) -> bool:
    """Whether words tell another force, or a row has a constant that the energies have not."""
    own = {inner for item in energies for name in item.names for inner in known.below(name)}
    functions = known.functions
    own |= {jet for jet, of in functions.items() if own & {one.name for one in of}}
    acting = {inner for name in law.mentions for inner in known.below(name)}
    end = max(one.typed.end for one in (*law.rows, *energies))
    words = known.paper.prose.between(energies[0].section.start, end)
    told = tells_more(words) or bool(cue("multiplier", words))
    return told or bool({one for one in acting if not known.moves(one)} - own)
