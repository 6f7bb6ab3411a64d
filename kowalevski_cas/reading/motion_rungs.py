"""What a statement may claim of a motion: solutions, and what holds along one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import product

from kowalevski_cas.paper.claims import DoubleZero, Identity, RelationsOfMotion, Solution
from kowalevski_cas.reading.beginnings import (
    UNREAD,
    at_start,
    beginning_of,
    gives_velocity,
    is_of_all,
    is_of_state,
    names_of_values,
    where_it_begins,
)
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.kept import constancy
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.nearby import near
from kowalevski_cas.reading.numerals import ORDINALS
from kowalevski_cas.reading.orders import orders_of
from kowalevski_cas.reading.rung import Rung, RungMaker, places
from kowalevski_cas.reading.sets import SetOfEquations
from kowalevski_cas.reading.solutions import ALL, PrintedSolution, lacking, levels_in, solution_of
from kowalevski_cas.reading.statements import SourceStatement


def solutions(at: RungMaker) -> Iterator[Rung]:
    """That a function of the time, with those beside it, solves its equations of motion.

    What the law does not move solves the equations of its rate that are claimed: they are
    claimed once more.
    """
    beside = _beside(at.item, at.known)
    moves = any(map(at.known.moves, at.item.bare))
    law = at.stage.law(at.item, beside) if moves else None
    found, law = _solution(at, at.item, beside, law)
    moves = law is not None
    levels = levels_in(found, at.item, at.known)
    found = found._replace(rows=tuple(dict.fromkeys((*found.rows, *levels.values()))))
    every = [found, *(_solved(at, one, beside) for one in beside if one is not at.item)]
    fixed = {name for one in every for name in levels_in(one, at.item, at.known)}
    lack = lacking(every, law, at.known, fixed)
    begun = _beginnings(at, law, found.given)
    of_all = ALL.search(at.item.before) or (not any(begun) and _is_said_of_all(at.item))
    if lack and of_all:
        raise ValueError(f"for all solutions {lack} more constants are needed")
    names = (law or at.known.laws[-1]).names
    still = Law((), names, change=found.given, levels=frozenset(levels))
    says = "this solves its equation of motion"
    for assumptions, values in product(at.ways(), begun):
        on_law = [at.stage.scene([row], assumptions).scene for row in found.rows]
        claimed = () if moves else zip(found.rows, on_law, strict=True)
        rung = at.rung(
            Solution, says, assumptions, (), (*found.given, *found.rows, *values), still,
            printed=at.item.printed, equations=places(found.rows),
            resting=tuple(
                Identity(at.id, scene, "", printed=row.printed) for row, scene in claimed
            ),
            beginning=places(values), start=places([*at_start(values, at.known)]),
        )  # fmt: skip
        yield replace(rung, on=(*rung.on, *values))


def _beside(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """The solutions of a sentence that are one with a statement: of none is a name given twice."""
    found: list[list[SourceStatement]] = [[]]
    for one in known.of_sentence(item.sentence):
        if one in known.roles and known.roles[one].kind == "solution":
            given = {name for other in found[-1] for name in other.bare[:1]}
            if given & {*one.bare[:1]}:
                found.append([])
            found[-1].append(one)
    return next((own for own in found if item in own), [])


def _solved(
    at: RungMaker, item: SourceStatement, beside: Sequence[SourceStatement]
) -> PrintedSolution:
    """The solution that a statement gives, of its own equations of motion."""
    law = at.stage.law(item, beside) if any(map(at.known.moves, item.bare)) else None
    return _solution(at, item, beside, law)[0]


def _solution(
    at: RungMaker, item: SourceStatement, beside: Sequence[SourceStatement], law: Law | None
) -> tuple[PrintedSolution, Law | None]:
    """The solution that a statement gives, of the law, or of what is claimed for its rates alone.

    So :math:`q=-1/t` solves an equation of the second order that follows from the law, where the
    momentum is not given.
    """
    try:
        return solution_of(item, beside, law, at.known), law
    except ValueError:
        if law is None:
            raise
        with suppress(ValueError):
            return solution_of(item, beside, None, at.known), None
        raise


def _beginnings(
    at: RungMaker, law: Law | None, given: Sequence[SourceStatement]
) -> list[SetOfEquations]:
    """What is said of the beginning of a solution, or nothing if it is the general one.

    Raises ``ValueError`` where words say more of it than can be read.
    """
    if law is None:
        return [()]
    begins = beginning_of(at.item, law, at.known)
    if begins.is_unread:
        raise ValueError(UNREAD)
    solved = {name for one in given for name in one.bare}
    values = tuple(one for one in begins.values if {*names_of_values(one)} <= solved)
    if any(one.begins not in ("", "0") for one in values):
        raise ValueError("of a solution only what it is where t=0 is judged")
    return [values, ()] if values and is_of_all(at.item) else [values]


def of_motion(at: RungMaker) -> Iterator[Rung]:
    """An equation along a motion: no motion leaves the set where it holds.

    It is so of what gives a velocity by the place, and of what has a constant of which nothing
    is said but that it is one; where the motion begins the equation has to hold.
    """
    item, known = at.item, at.known
    law = at.stage.law(item, [item]) if known.varying(item.names) else None
    if law is None or law.images or "t" in item.names or item in known.paper.approximate:
        return
    begins = beginning_of(item, law, known)
    if begins.is_unread or not is_of_state(item, law, known):
        return
    if not begins.values and not gives_velocity(item, known):
        return
    if any(item.names & one.names - {*law.variables} for one in known.sets(item)):
        return  # its constants have values there
    if constancy(item, known):
        return  # it is deduced of the motions that keep this, and no set is chosen by it
    if not begins.values and _is_deduced_of_all(item, known):
        return
    says = "no motion leaves the set where both sides are equal"
    first = [*where_it_begins(item, begins.values, known)]
    for assumptions in at.suppositions():
        scenes = [(at.stage.scene([one], assumptions).scene, one) for one in first]
        rung = at.rung(
            RelationsOfMotion, says, assumptions, relations=places([item]),
            beginning=tuple(
                Identity(at.id, scene, "", printed=one.printed) for scene, one in scenes
            ),
        )  # fmt: skip
        yield replace(rung, on=(*rung.on, *begins.values), is_stronger=True)


_SOME = re.compile(
    r"\b(?:motions?|solutions?|orbits?|trajector\w+|curves?|loops?|waves?|pulses?|solitons?|starts?|rest"
    r"|released|thrown|falls?|launch\w+|движени\w+|решени\w+|траектори\w+|орбит\w*|крив\w+)\b",
    re.IGNORECASE,
)
"""Words for some motions."""


def _speaks_of_some(words: str) -> bool:
    """Whether words speak of a motion, or call it special: not of the equations alone."""
    return bool(_SOME.search(words) or cue("special motion", words))


_TENDS = re.compile(r"\\(?:to|rightarrow)(?![A-Za-z])")
"""The sign of what a motion tends to, which says of which motion something is said."""
_BY_INTEGRATION = re.compile(r"\bintegrat\w+|\bintegrals?\b|\bинтегр\w+", re.IGNORECASE)


def _is_said_of_all(item: SourceStatement) -> bool:
    """Whether words deduce a solution from the equations, and speak of no beginning, nor of one."""
    words = f"{item.earlier[0] if item.earlier else ''} {item.words}"
    begun = cue("initially", words) or _speaks_of_some(words)
    return not begun and bool(_DEDUCES.match(item.before))


_DEDUCES = re.compile(
    r"\W*(?:then|hence|therefore|thus|consequently|тогда|отсюда|следовательно|поэтому)\b",
    re.IGNORECASE,
)


_SATISFY = re.compile(
    r"\W*(?:(?:then|hence|thus|therefore),?\s+)?(?:the|every|all|each|any)?\s*"
    r"(?:solution|motion|orbit|trajector(?:y|ie)|curve)s?\s+(?:then\s+)?(?:satisf(?:y|ies)|obeys?|fulfils?)\b",
    re.IGNORECASE,
)
"""How a sentence begins that says something of all motions, and names none of them."""


def _is_deduced_of_all(item: SourceStatement, known: Known) -> bool:
    """Whether words deduce an equation without a constant of its own, and of no one motion."""
    if known.untied(item.names - {*item.rates}):
        return False
    if _SATISFY.match(item.before):
        return True
    if _speaks_of_some(item.words):
        return False
    before = (one for one in known.items if one.order < item.order)
    if any(_TENDS.search(one.typed.tex) for one in before if one.paragraph == item.paragraph):
        return False
    return bool(cue("deduced", item.before) or _BY_INTEGRATION.search(item.before))


def along_solution(at: RungMaker) -> Iterator[Rung]:
    """An equation with the constants of a solution, where the solution before it is put in."""
    before = [
        one
        for one, role in at.known.roles.items()
        if role.kind == "solution" and one.order < at.item.order
        and one.section is at.item.section and one.bare
    ]  # fmt: skip
    solution = [one for one in before if one.sentence == before[-1].sentence]
    law = at.stage.law(solution[0], solution) if solution else None
    own = {name for one in solution for name in one.names - {*one.bare[:1], "t"}}
    if law is None or not (own - law.mentions) & at.item.names:
        return
    along = Law((), law.names, change=tuple(solution))
    says = "both sides are equal along the solution before"
    for assumptions in at.suppositions():
        rung = at.rung(Identity, says, assumptions, (), (at.item, *solution), along)
        yield replace(rung, on=(*rung.on, *solution), given=tuple(solution))


def to_some_order(at: RungMaker) -> Iterator[Rung]:
    """That an equation is right up to small quantities near the point, or set, before it."""
    given = near(at.item, at.known)
    if not (at.item.derives and given):
        return
    orders = orders_of(at.item, given, at.known)
    if orders is None:
        raise ValueError("to which order it holds is not known")
    says = (
        f"up to small quantities of the {ORDINALS[len(orders.all)][0]} order both sides are equal"
    )
    rung = at.rung(DoubleZero, says, at.supposed, given, given=places(given), orders=orders.all)
    # it is said of what is near, and so it is not idle
    yield replace(rung, idle=None, is_stronger=orders.is_stronger)
