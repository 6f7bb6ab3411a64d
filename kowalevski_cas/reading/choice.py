"""Which of the claims that a statement may make it makes: the first that holds."""

from __future__ import annotations

from contextlib import suppress
from hashlib import sha256
from typing import NamedTuple

from kowalevski_cas.limits import ProcessDied, time_limit
from kowalevski_cas.notation import Formula, NotationError, Number, Relation
from kowalevski_cas.paper.claims import Neighbour
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.reading.rung import Rung
from kowalevski_cas.verify.corrections import fails_at_points
from kowalevski_cas.verify.statement import Statement

SECONDS = 2.0
"""For each claim that a statement may make."""

AT_POINTS = SECONDS / 4
"""For the search of a real point where a claim fails that is not decided in time."""

IDLE = "nothing moves on the set on which it seems to be claimed: it would say nothing"


OVERDUE = "whether it holds by something else that is said was not decided in time"


UNMOVED = "nothing moves by the equations of motion as they were read: it would say nothing"


class Choice(NamedTuple):
    """Which rung of a ladder is taken, if one is, and why none is."""

    place: int | None
    message: str = ""
    elsewhere: int | None = None
    """Which rung holds by what is supposed in other places, if no other one holds."""


Choices = dict[str, Choice]
"""The choices that were made before, by all that they rest on."""


def choose_once(found: list[Rung], on: Elaborations, choices: Choices | None) -> tuple[Choice, str]:
    """The choice between claims, as it was made before if it was, and what it rests on."""
    if choices is None:
        return choose(found, on), ""
    resting_on = _basis(found, on)
    return choices.get(resting_on) or choose(found, on), resting_on


def _basis(found: list[Rung], on: Elaborations) -> str:
    """All on which a choice rests: what the claims state, and the formulas that they read."""
    claims = [claim for rung in found for claim in (rung.claim, rung.idle) if claim is not None]
    places = frozenset().union(*(claim.reads() for claim in claims))
    said = [f"{type(claim).__name__} {vars(claim)}" for claim in claims]
    read = sorted(f"{place.place} {_as_read(place, on.texts)}" for place in places)
    ways = [
        f"{rung.in_force} {rung.is_stronger} {rung.elsewhere} "
        f"{[one.printed for one in rung.on]} {[one.printed for one in rung.given]}"
        for rung in found
    ]
    return sha256("\n".join((*said, *read, *ways)).encode()).hexdigest()


def _as_read(place: Printed, texts: Texts) -> Formula | str:
    """The formula at a place, or the words for what cannot be read there."""
    try:
        return texts.as_printed(place)
    except NotationError as error:
        return str(error)


def choose(found: list[Rung], on: Elaborations) -> Choice:
    """The first claim that holds, or the one with what is in force, where none does."""
    first: int | None = None
    message, overdue = "", set[int]()
    only = found[0].idle is None and not found[0].is_stronger
    alone = len(found) == 1 and only  # there is nothing to choose from
    for place, rung in enumerate(found):
        if rung.elsewhere and first is None:
            break
        true, trouble = _trial(rung, on, alone)
        if true:
            return Choice(first, "", place) if rung.elsewhere else Choice(place)
        overdue |= {place} if trouble == OVERDUE else set()
        trouble = "" if trouble == OVERDUE else trouble
        message = message or trouble
        if trouble or rung.elsewhere or rung.is_stronger:
            continue
        if first is None or (rung.in_force and not found[first].in_force):
            first = place
        elif not rung.given and not found[first].given and {*rung.on} > {*found[first].on}:
            first = place  # what is supposed there is not left aside where the claim fails
    if message in (IDLE, UNMOVED):
        return Choice(None, message)
    if first is not None:
        message = OVERDUE if overdue - {first} else ""
    return Choice(first, message)


def _trial(rung: Rung, on: Elaborations, alone: bool) -> tuple[bool, str]:
    """Whether a claim holds, or is the only one and has a meaning; else perhaps why it has none."""
    try:
        with time_limit(SECONDS):
            statement = Statement(rung.claim, on)
            if (alone and statement.goals) or statement.holds():
                if _is_unmoved(rung, on):
                    return False, UNMOVED
                idle = rung.idle is not None and Statement(rung.idle, on).holds()
                return not idle, IDLE if idle else ""
    except (NotationError, Meaningless, FormatError, ArithmeticError, RecursionError) as error:
        said = str(getattr(error, "message", error))
        for printed in rung.claim.places():
            said = said.removeprefix(f"{printed.display.id}: ")
        return False, said
    except (TimeoutError, ProcessDied):
        return False, "" if _fails_at_points(rung, on) else OVERDUE
    return False, ""


def may_hold(rung: Rung, on: Elaborations) -> bool:
    """Whether a claim holds, or is not decided in time and fails nowhere where it was tried."""
    true, trouble = _trial(rung, on, alone=False)
    return true or trouble == OVERDUE


def _fails_at_points(rung: Rung, on: Elaborations) -> bool:
    """Whether a claim fails at a real point where its hypotheses hold: then it is not the one."""
    with suppress(TimeoutError), time_limit(AT_POINTS):
        return fails_at_points(Neighbour("", rung.claim, on.texts), on, {})
    return False


def _is_unmoved(rung: Rung, on: Elaborations) -> bool:
    """Whether all rates of a law vanish, and not all of its rows are printed with a zero."""
    field = rung.claim.scene.field
    rows = [on.texts.formula(place) for place in field] if isinstance(field, tuple) else []
    if all(isinstance(row, Relation) and Number(0) in row.members for row in rows):
        return False
    return all(rate.is_zero for rate in on(rung.claim.scene).finder.rates.values())
