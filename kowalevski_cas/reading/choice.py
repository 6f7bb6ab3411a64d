"""Which of the claims that a statement may make it makes: the first that holds."""

from __future__ import annotations

from typing import NamedTuple

from kowalevski_cas.limits import ProcessDied, time_limit
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.reading.ladder import Rung
from kowalevski_cas.verify.statement import Statement

SECONDS = 2.0
"""For each claim that a statement may make."""

IDLE = "nothing moves on the set on which it seems to be claimed: it would say nothing"


class Choice(NamedTuple):
    """Which rung of a ladder is taken, if one is, and why none is."""

    place: int | None
    message: str = ""
    elsewhere: int | None = None
    """Which rung holds by what is supposed in other places, if no other one holds."""


def choose(found: list[Rung], on: Elaborations) -> Choice:
    """The first claim that holds, or the one with what is in force, where none does."""
    first: int | None = None
    message = ""
    only = found[0].idle is None and not found[0].is_stronger
    alone = len(found) == 1 and only  # there is nothing to choose from
    for place, rung in enumerate(found):
        if rung.elsewhere and first is None:
            break
        true, trouble = _trial(rung, on, alone)
        if true:
            return Choice(first, "", place) if rung.elsewhere else Choice(place)
        message = message or trouble
        if trouble or rung.elsewhere or rung.is_stronger:
            continue
        if first is None or (rung.in_force and not found[first].in_force):
            first = place
        elif not rung.given and not found[first].given and {*rung.on} > {*found[first].on}:
            first = place  # what is supposed there is not left aside where the claim fails
    return Choice(first, "" if first is not None else message)


def _trial(rung: Rung, on: Elaborations, alone: bool) -> tuple[bool, str]:
    """Whether a claim holds, or is the only one and has a meaning; else perhaps why it has none."""
    try:
        with time_limit(SECONDS):
            statement = Statement(rung.claim, on)
            if (alone and statement.goals) or statement.holds():
                idle = rung.idle is not None and Statement(rung.idle, on).holds()
                return not idle, IDLE if idle else ""
    except (NotationError, Meaningless, FormatError, ArithmeticError, RecursionError) as error:
        said = str(getattr(error, "message", error))
        for printed in rung.claim.places():
            said = said.removeprefix(f"{printed.display.id}: ")
        return False, said
    except (TimeoutError, ProcessDied):
        pass
    return False, ""
