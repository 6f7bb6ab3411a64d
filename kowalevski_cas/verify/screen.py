"""Screening: goals are put to points, which refute or make probable, and never prove."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kowalevski_cas.algebra.points import Answer, NoPoint, Points, Question
from kowalevski_cas.algebra.programs import Program
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.paper.independence import decides
from kowalevski_cas.problem.differentials import differentials, functions_for_differentials
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Found
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import (
    Along,
    Count,
    Exists,
    Fails,
    Follows,
    Kernel,
    Rank,
    Simple,
)  # fmt: skip
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.problem.space import Meaningless, Setting
from kowalevski_cas.search.follows import alternatives
from kowalevski_cas.verify.outcome import Counterexample, PrintedPoint, Screened, Value, Verdict
from kowalevski_cas.verify.statement import Statement, Verdicts

Stages = dict[Setting, Sampled]
"""Settings in programs, each made once for a run."""


def screen(
    statement: Statement, evidence: Callable[[], Verdicts | None], points: Points, stages: Stages
) -> Screened:
    """What an arithmetic of points says about a statement.

    ``probable`` with a bound on the chance that this is wrong, ``enclosed`` with a radius,
    ``refuted`` with a point; ``undecided``, with the reason, where the statement says what cannot
    be seen at points or where no point was found.
    """
    answers: list[Answer] = []
    unseen: list[str] = []
    try:
        for question in questions(statement, evidence, unseen, stages):
            answer = points.answer(question)
            if answer.holds is False:
                if not all(map(decides, statement.claimed)):
                    return Screened(Verdict.UNDECIDED, "a point does not refute it")
                return _is_refuted(answer)
            answers.append(answer)
    except (NoPoint, Meaningless) as error:
        return Screened(Verdict.UNDECIDED, str(error))
    reasons = [*unseen, *(answer.words for answer in answers if answer.holds is None)]
    if reasons := [reason for reason in reasons if reason]:
        return Screened(Verdict.UNDECIDED, "; ".join(dict.fromkeys(reasons)))
    if not answers:
        return Screened(Verdict.UNDECIDED, "nothing in this claim can be asked at points")
    radii = [answer.radius for answer in answers if answer.radius is not None]
    bounds = [answer.bound for answer in answers if answer.bound is not None]
    words = answers[-1].words
    if radii:
        return Screened(Verdict.ENCLOSED, words, radius=max(radii))
    return Screened(Verdict.PROBABLE, words, chance=max(bounds, default=None))


def _is_refuted(answer: Answer) -> Screened:
    values: dict[object, Value] = {Name(n): v for n, v in answer.point.items() if n}
    words = f"{answer.words}: {answer.left} and {answer.right}"
    found = Counterexample(PrintedPoint(values), answer.left, answer.right, words)  # type: ignore[arg-type] # numbers, no formulas
    return Screened(Verdict.REFUTED, answer.words, found)


def questions(
    statement: Statement, evidence: Callable[[], Verdicts | None], unseen: list[str], stages: Stages
) -> Iterator[Question]:
    """What can be asked at points; what cannot is entered as ``unseen``.

    What exists has to be found first.
    """

    def at(setting: Setting) -> Sampled:
        if setting not in stages:
            stages[setting] = Sampled(finder_of(setting))
        return stages[setting]

    for place, goal in enumerate(statement.goals):
        if isinstance(goal, Along):
            unseen.append("that two solutions are equal cannot be seen at points")
        elif isinstance(goal, Exists):
            verdicts = evidence()
            found = verdicts[place] if isinstance(verdicts, tuple) else None
            if not isinstance(found, Found):
                unseen.append("what exists cannot be seen at points")
                continue
            for inner in goal.goals:
                bound = _bind(inner, found, at(inner.space))
                yield from _questions(inner, bound, unseen)
        else:
            yield from _questions(goal, at(goal.space), unseen)


def _bind(goal: Simple, found: Found, at: Sampled) -> Evaluation:
    values: dict[str, Element] = {}
    for name, formula in found.values.items():
        if any(name in formula.names() for formula in goal.formulas()):
            values[name] = at.scalar(formula)
    bound = at.binding(values)
    assert isinstance(bound, Sampled)
    # what is remembered there was evaluated while the names were not bound
    bound._memory = {}
    return bound


def _questions(goal: Simple, at: Evaluation, unseen: list[str]) -> Iterator[Question]:
    match goal:
        case Follows(given=(_, *_)) if goal.space.powers:
            unseen.append("what follows for symbolic exponents cannot be seen at points")
        case Fails(conclusions=()):
            pass
        case Follows(conclusions=()):
            unseen.append("that there is no point cannot be seen at points")
        case Kernel():
            unseen.append("that there are no more polynomials cannot be seen at points")
        case Count():
            unseen.append("how many solutions are real cannot be seen at points")
        case Follows() | Rank():
            yield _question(goal, at)


def _question(goal: Follows | Rank, at: Evaluation) -> Question:
    assert isinstance(at, Sampled)
    given = _programs(at.differences(goal.given))
    match goal:
        case Rank():
            rows = [
                _programs(row) for row in differentials(functions_for_differentials(goal, at), at)
            ]
            return Question(at.programs, given=given, rows=rows, rank=goal.rank)
        case Fails():
            return Question(at.programs, given=given, somewhere=_programs(alternatives(goal, at)))
    return Question(at.programs, given=given, residuals=_programs(alternatives(goal, at)))


def _programs(elements: list[Element]) -> list[Program]:
    return [element for element in elements if isinstance(element, Program)]
