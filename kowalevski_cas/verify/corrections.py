"""The nearest true statement: one edit away from what is printed, or a factor away.

A correction is a proposal. It stands in for the print elsewhere only if the derivation accepts it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import takewhile
from typing import TYPE_CHECKING, TypeGuard

from kowalevski_cas.algebra.points import NoPoint
from kowalevski_cas.notation import Edit, Formula, Negative, NotationError, edits
from kowalevski_cas.notation.edits import changes_subject
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.elaborate import finder_of
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.goals import Follows, Goal
from kowalevski_cas.problem.space import Equation, Meaningless
from kowalevski_cas.verify.outcome import as_recorded
from kowalevski_cas.verify.relations import relations
from kowalevski_cas.verify.statement import Statement
from kowalevski_cas.verify.vacuous import says_something, unlike

if TYPE_CHECKING:
    from kowalevski_cas.algebra.tower import Element
    from kowalevski_cas.problem.sampled import Sampled
    from kowalevski_cas.search.on_hypotheses import HypothesisPoints

DECIDED = 400
"""How many candidates are decided in full, for claims that are more than identities."""


def recorded_correction(
    claim: Claim, on: Elaborations, recorded: str, elsewhere: str = ""
) -> tuple[Neighbour, Statement] | None:
    """The neighbour of a claim that a record has as its correction, and what it says.

    It is that of another formula, if a place ``elsewhere`` is recorded. ``None`` if no neighbour
    is recorded so, or it says nothing.
    """
    with suppress(NotationError, Meaningless):
        near = _at(elsewhere, claim, on, recorded) if elsewhere else _own(claim, on, recorded)
        for neighbour in near:
            return neighbour, statement_of(neighbour, on)
    return None


def _own(claim: Claim, on: Elaborations, recorded: str) -> Iterator[Neighbour]:
    """The neighbours of a claim that are recorded so."""
    printed, wanted = claim.formulas(on.texts), None
    if claim.printed is not None:
        with suppress(NotationError):  # it may be several formulas, or words
            wanted = on.texts.expression(recorded)
    for neighbour in claim.neighbours(on.texts, wanted):
        formulas = formulas_printed_by(neighbour)
        same = formulas != printed and wanted in formulas[:1]
        if same or as_recorded(formulas, neighbour.words, printed) == recorded:
            yield neighbour


def _at(elsewhere: str, claim: Claim, on: Elaborations, recorded: str) -> Iterator[Neighbour]:
    """A claim under the recorded edit of another formula, or the relation that it supposes."""
    wanted, texts = on.texts.expression(recorded), on.texts
    for place in claim.reads():
        if place.place == elsewhere:
            for edit in edits(texts.statement(place), texts.vocabulary, wanted=wanted):
                if edit.formula == wanted:
                    yield claim.edited(texts, place, edit)
    for relation in relations(Statement(claim, on)):
        if relation.formula == wanted:
            yield relation.neighbour(claim, texts)


def statement_of(neighbour: Neighbour, on: Elaborations) -> Statement:
    """What a neighbour says; raises ``NotationError`` or ``Meaningless`` if it says nothing."""
    return Statement(neighbour.claim, on.under(neighbour.texts))


def corrections(
    printed: Statement, goes_on: Callable[[], bool] = lambda: True
) -> Iterator[tuple[Neighbour, Statement]]:
    """The neighbours of what is refuted that are true and say something, the likeliest first.

    No other one is looked at as soon as the search does not go on.
    """
    near = printed.claim.neighbours(printed.on.texts)
    meant = [
        neighbour
        for neighbour in near
        if neighbour.edit is None or not changes_subject(neighbour.edit)
    ]
    wanted = takewhile(lambda _: goes_on(), sorted(meant, key=_likelihood))
    for neighbour in true_ones(wanted, printed.on):
        statement = statement_of(neighbour, printed.on)
        if says_something(neighbour, statement, printed):
            yield neighbour, statement


def _likelihood(neighbour: Neighbour) -> tuple[bool, ...]:
    return (False,) * 3 if neighbour.edit is None else unlikeliness(neighbour.edit)


def unlikeliness(edit: Edit) -> tuple[bool, ...]:
    """What sorts edits: names that are not alike are seldom taken for each other.

    What is defined is seldom wrong. A formula seldom begins with a minus: of two signs, the second
    is changed.
    """
    begins = isinstance(edit.replacement, Negative) and not any(edit.path[-1:])
    return unlike(edit), edit.path[:1] == (0,), begins


def true_ones(neighbours: Iterable[Neighbour], on: Elaborations) -> Iterator[Neighbour]:
    """The neighbours that are true.

    Their identities are screened at points modulo primes; what passes is decided in full, with
    FLINT.
    """
    for neighbour in _screen_neighbours(neighbours, on):
        try:
            if statement_of(neighbour, on).holds():
                yield neighbour
        except (NotationError, Meaningless, ZeroDivisionError):
            continue


def formulas_printed_by(neighbour: Neighbour) -> tuple[Formula, ...]:
    """The formulas that a corrected statement prints."""
    return neighbour.claim.formulas(neighbour.texts)


def _screen_neighbours(neighbours: Iterable[Neighbour], on: Elaborations) -> Iterator[Neighbour]:
    """The neighbours that pass the screen, on the settings of what is printed if these suffice."""
    on = on.with_beside(on.met)
    stages: dict[object, Sampled | None] = {}
    points: dict[object, HypothesisPoints] = {}
    decided = 0
    for neighbour in neighbours:
        verdict = passes(neighbour, on, stages)
        if verdict is None and fails_at_points(neighbour, on, points):
            continue
        if verdict is None:
            decided += 1
            verdict = decided <= DECIDED
        if verdict:
            yield neighbour


def passes(
    neighbour: Neighbour, on: Elaborations, stages: dict[object, Sampled | None]
) -> bool | None:
    """Whether all identities hold at points; ``None`` if there are other goals, or no points.

    Given equations that give names by others are put in; where they say more no point is tried.
    ``stages`` are the settings that were evaluated there already.
    """
    # a recorded correction is only looked up
    from kowalevski_cas.problem.sampled import Sampled, solved_equations

    try:
        claim = neighbour.claim
        goals = list(claim.goals(claim.settings(on.under(neighbour.texts))))
        identities = [goal for goal in goals if _is_identity(goal)]
        told = 0
        for goal in identities:
            key = goal.space, goal.given
            if key not in stages:
                exact = finder_of(goal.space)
                solved = solved_equations(goal.given, exact)
                stages[key] = None if solved is None else Sampled(exact, solved)
            if (at := stages[key]) is None:
                continue
            told += 1
            # One by one: most candidates fail at the first.
            equations = (equation for conclusion in goal.conclusions for equation in conclusion)
            if not all(
                d.is_zero for equation in equations for d in _differences(at, goal, equation)
            ):
                return False
    except (NotationError, Meaningless, ZeroDivisionError):
        return False
    except NoPoint:  # as modulo a prime where a printed root of a number has no residue
        return None
    return True if told == len(goals) else None


def _differences(at: Sampled, goal: Follows, equation: Equation) -> Sequence[Element]:
    """What has to vanish for an equation; where names are given it is derived before that."""
    if not goal.given:
        return at.differences((equation,))
    return [at.carry(one) for one in at.exact.differences((equation,))]


def fails_at_points(
    neighbour: Neighbour, on: Elaborations, points: dict[object, HypothesisPoints]
) -> bool:
    """Whether a goal fails at real points of its hypotheses, of which these are known."""
    from kowalevski_cas.search.on_hypotheses import HypothesisPoints

    with suppress(NotationError, Meaningless, ZeroDivisionError):
        claim = neighbour.claim
        for goal in claim.goals(claim.settings(on.under(neighbour.texts))):
            if type(goal) is Follows:
                key = goal.space, goal.given
                if key not in points:
                    points[key] = HypothesisPoints(goal, finder_of)
                if points[key].refute(goal, finder_of(goal.space)):
                    return True
    return False


def _is_identity(goal: Goal) -> TypeGuard[Follows]:
    """Whether equations are said to hold, perhaps where given ones do."""
    return type(goal) is Follows and len(goal.conclusions) == 1
