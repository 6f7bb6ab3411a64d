"""The second program: what the judge accepts the checker has to accept, or there is no verdict.

It has no part in how the judge thinks. It gets the text of a certificate and nothing else.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from math import inf
from time import monotonic
from typing import NamedTuple, TypeVar

from kowalevski_cas import UserError
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.limits import clock, run_end
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.paper.denominators import Shape, factors_below, factors_of, granted_factors
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.codec import read_problem
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Along, Goal, Simple, simple
from kowalevski_cas.problem.space import Raised, Setting
from kowalevski_cas.problem.trees import decode
from kowalevski_cas.processes import each
from kowalevski_cas.verify.conditions import may_vanish
from kowalevski_cas.verify.outcome import Divided, Outcome, Verdict

LEAST = 0.5
"""Seconds for the checker, however few the claim has left."""

LATE = "there is no time left for the checker"

LOOK = 5_000
"""Steps of the checker between two looks at the clock."""

LONG = 100_000
"""Entries of vectors whose elimination is worth other processes."""


Item = TypeVar("Item")
Result = TypeVar("Result")

_received = False


def received(work: Callable[[Item], Result]) -> Callable[[Item], Result]:
    """The work, with no certificate checked in it: what it says is received by whoever asks."""

    def unchecked(item: Item) -> Result:
        with _unchecked():  # whatever process it is done in
            return work(item)

    return unchecked


@contextmanager
def _unchecked() -> Iterator[None]:
    global _received
    before, _received = _received, True
    try:
        yield
    finally:
        _received = before


def is_received() -> bool:
    """Whether what is said in this process is received by another one."""
    return _received


class Disagreement(UserError, ValueError):
    """The judge and the checker say two things of one statement; the message names both."""


class Issued(NamedTuple):
    """A certificate with what the judge says it is: a claim, a digest, a sign, its divisors."""

    claim: str
    digest: str
    sign: str
    text: str
    divided: Divided


def divisors_by_goal(accepted: Accepted) -> Divided:
    """What the judge divides by, goal by goal, in the names of the problem."""
    return tuple(
        tuple(finder_of(goal.space).divisor_formulas(elements))
        for goal, elements in accepted.divided
    )


def receive(
    outcome: Outcome, timeout: float | None = None, known: Outcome | None = None, jobs: int = 1
) -> Outcome:
    """An outcome that comes from elsewhere, once the checker accepts here what comes with it.

    Else it is an error, or a timeout, if its seconds and those of the checker are too many. What
    is ``known`` of it is accepted already. The checker has so many ``jobs``.
    """
    start = clock()
    spent = sum([*outcome.seconds.values()][:1])
    left = min(inf if timeout is None else timeout - spent, run_end() - monotonic())
    until = start + max(left, LEAST)
    verdict, said = Verdict.ERROR, ""
    try:
        need_certificates(outcome, until, known, jobs)
    except TimeoutError as error:
        verdict, said = Verdict.TIMEOUT, str(error)
    except Disagreement as error:
        said = str(error)
    except Exception as error:
        said = f"{outcome.claim}: it cannot be checked ({type(error).__name__}: {error})"
    if outcome.seconds:
        first = next(iter(outcome.seconds))
        seconds = {**outcome.seconds, first: spent + clock() - start}
        outcome = outcome._replace(seconds=seconds)
    if not said:
        return outcome
    return outcome._replace(
        verdict=verdict, message=said, certificate="", divided=(), conditions=(),
        counterexample=None, correction=None, alternatives=(),
    )  # fmt: skip


def need_certificates(
    outcome: Outcome, until: float = inf, known: Outcome | None = None, jobs: int = 1
) -> None:
    """Have the checker accept, here, what comes with an outcome from elsewhere, but the ``known``.

    Raises:
        Disagreement: nothing that another process says is believed.
        TimeoutError: the checker takes longer.
    """
    accepted = {} if known is None else dict.fromkeys(_certificates_due(known))
    for issued in _certificates_due(outcome):
        if issued in accepted:
            continue
        try:
            confirm(issued, until=until, jobs=jobs)
        except Disagreement as error:
            said = f"{outcome.claim}: what another process says of it is not accepted here: {error}"
            raise Disagreement(said) from None


def _certificates_due(outcome: Outcome) -> Iterator[Issued]:
    """The certificates that have to come with an outcome."""
    if outcome.needs_certificate:
        sign = "denied" if outcome.verdict is Verdict.REFUTED else "holds"
        yield Issued(outcome.claim, outcome.digest, sign, outcome.certificate, outcome.divided)
    for proposal in filter(None, (outcome.correction, *outcome.alternatives)):
        yield Issued(
            outcome.claim, proposal.digest, "holds", proposal.certificate, proposal.divided
        )


class Watch(checker.Budget):
    """The steps for a certificate, given out few at a time, until some moment.

    Long work is shared by as many copies of this process as there are ``jobs``.
    """

    def __init__(self, until: float, jobs: int = 1) -> None:
        super().__init__()
        # nothing is left at first, so that the first step looks at the clock
        self.until, self.rest, self.left, self.jobs = until, self.left, 0, jobs

    def each(
        self, work: Callable[[checker.Block, checker.Spend], int], blocks: list[checker.Block]
    ) -> list[int]:
        """What work gives on each of the blocks, the largest of them first."""
        sizes = [sum(map(len, block)) for block in blocks]
        if self.jobs == 1 or sum(sizes) < LONG:
            return super().each(work, blocks)

        def count(k: int) -> tuple[int, int]:
            # what a copy of this process spends is not spent here: it is told, and spent again
            before = self.left + self.rest
            return work(blocks[k], self.spend), before - self.left - self.rest

        order = sorted(range(len(blocks)), key=lambda k: -sizes[k])
        results = [*each(count, iter(order), self.jobs)]  # of a list one process takes the last
        self.spend(sum(steps for _, steps in results))
        return [result for result, _ in results]

    def end(self) -> None:
        """Take more of the rest, if there is time."""
        if clock() > self.until:
            raise checker.Exhausted(LATE)
        more = min(self.rest, LOOK - self.left)
        self.left, self.rest = self.left + more, self.rest - more
        if self.left < 0:
            super().end()


def confirm(issued: Issued, goals: Sequence[Goal] = (), until: float = inf, jobs: int = 1) -> None:
    """Have the checker accept a certificate with the conditions under which the judge did.

    ``goals`` are those of the problem, if they are at hand.

    Raises:
        Disagreement: it rejects the text, or has other conditions.
        TimeoutError: it has come to the end of the steps, or of the time, that it may take.
    """
    try:
        found = checker.check(issued.text, Watch(until, jobs))
    except checker.Exhausted as error:
        raise TimeoutError(str(error)) from None
    except checker.Rejected as error:
        raise Disagreement(
            f"flint and the checker disagree: flint accepts the evidence, the checker says: {error}"
        ) from None
    if clock() > until:
        raise TimeoutError(LATE)
    if (found.claim, found.digest, found.sign) != (issued.claim, issued.digest, issued.sign):
        raise Disagreement("the checker reads another statement in it")
    theorems = [part for theorem in found.theorems for part in theorem.parts or (theorem,)]
    if issued.sign == "denied" or not any(
        [*issued.divided, *(theorem.divisors for theorem in theorems)]
    ):
        return
    goals = goals or read_problem(json.loads(issued.text)).goals
    every = [part for goal in goals for part in simple(goal)]
    divisors = [tuple(map(decode, theorem.divisors)) for theorem in theorems]
    # the two divide on ways of their own: only irreducible factors can be compared
    judge, other = _factors(every, issued.divided), _factors(every, divisors)
    if judge != other:
        more, whose = (judge - other, "flint") if judge - other else (other - judge, "checker")
        raise Disagreement(
            "the conditions of flint and of the checker differ: "
            f"{whose} has {len(more)} factors more in them"
        )


def _factors(
    goals: Sequence[Simple], divided: Sequence[Sequence[Formula]]
) -> set[tuple[Setting, Shape]]:
    """The irreducible factors that may not vanish, each with the space in which it stands."""
    found = set[tuple[Setting, Shape]]()
    for goal, divisors in zip(goals, divided, strict=True):
        if isinstance(goal, Along):  # where a side is not defined it says nothing
            continue
        at = finder_of(goal.space)
        granted = granted_factors(map(at.scalar, goal.space.nonzero)) | _of_powers(at)
        for divisor in may_vanish(goal, [at.scalar(formula).inverse() for formula in divisors]):
            for shape, factor in factors_of(divisor).items():
                if shape not in granted:
                    found |= {(goal.space, shape), (goal.space, Shape(_conjugate(factor, at)))}
    return found


def _of_powers(at: Evaluation) -> set[Shape]:
    """Bases of powers and the powers themselves, which are positive wherever they are defined."""
    steps = map(at.setting.step, at.setting.powers)
    powers = [step for step in steps if isinstance(step, Raised)]
    elements = [at.scalar(f) for step in powers for f in (step.base, Name(step.name))]
    return {shape for element in elements for shape in factors_below(element.inverse())}


def _conjugate(element: Element, at: Evaluation) -> Element:
    """What vanishes at a real point wherever the element does."""
    if not at.setting.conjugates:
        return element
    return at.image(element, lambda name: at.scalar(Name(name), True))
