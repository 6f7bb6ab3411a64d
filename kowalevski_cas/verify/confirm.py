"""The second program: what the judge accepts the checker has to accept, or there is no verdict.

It has no part in how the judge thinks. It gets the text of a certificate and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from kowalevski_cas import UserError
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.paper.denominators import (
    Shape,
    factors_below,
    factors_of,
    granted_factors,
    shape_of,
)
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Along, Simple, simple
from kowalevski_cas.problem.space import Raised, Setting
from kowalevski_cas.problem.trees import decode
from kowalevski_cas.verify.conditions import may_vanish
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.statement import Statement, Verdicts

Divided = Iterable[tuple[Simple, Sequence[Element]]]


class Disagreement(UserError, ValueError):
    """The judge and the checker say two things of one statement; the message names both."""


def confirm(statement: Statement, verdicts: Verdicts, accepted: Accepted, text: str) -> None:
    """Have the checker accept a certificate with the conditions under which the judge did.

    Raises:
        Disagreement: it rejects the text, or has other conditions.
        TimeoutError: it has come to the end of the steps that it takes.
    """
    sign = "denied" if isinstance(verdicts, Denial) else "holds"
    theorems = _theorems(statement.claim.id, statement.digest, sign, text)
    if sign == "denied":
        return
    goals = [one for goal in statement.goals for one in simple(goal)]
    found = (
        _factors(accepted.divided),
        _factors(zip(goals, _divisors_by_goal(goals, theorems), strict=True)),
    )
    for space in {*found[0], *found[1]}:
        judge, other = (factors.get(space, set()) for factors in found)
        if judge != other:
            more, whose = (judge - other, "flint") if judge - other else (other - judge, "checker")
            raise Disagreement(
                f"the conditions of flint and of the checker differ: {whose} has "
                f"{len(more)} more on “{statement.legend[space].scene.name}”"
            )


def receive(outcome: Outcome) -> Outcome:
    """An outcome that comes from elsewhere; an error, if it is not accepted here."""
    try:
        need_certificates(outcome)
    except Disagreement as error:
        return outcome._replace(
            verdict=Verdict.ERROR, message=str(error), certificate="", conditions=(),
            counterexample=None, correction=None, alternatives=(),
        )  # fmt: skip
    return outcome


def need_certificates(outcome: Outcome) -> None:
    """Have the checker accept, here, what comes with an outcome from elsewhere.

    Raises :class:`Disagreement`: nothing that another process says is believed.
    """
    due = []
    if outcome.certified:
        sign = "denied" if outcome.verdict is Verdict.REFUTED else "holds"
        due.append((outcome.digest, sign, outcome.certificate))
    for one in filter(None, (outcome.correction, *outcome.alternatives)):
        due.append((one.digest, "holds", one.certificate))
    try:
        for digest, sign, text in due:
            _theorems(outcome.claim, digest, sign, text)
    except (Disagreement, TimeoutError) as error:
        said = f"{outcome.claim}: what another process says of it is not accepted here: {error}"
        raise Disagreement(said) from None


def _theorems(claim: str, digest: str, sign: str, text: str) -> list[checker.Theorem]:
    """What the checker says is proved by a certificate of a claim."""
    try:
        found = checker.check(text)
    except checker.Exhausted as error:
        raise TimeoutError(str(error)) from None
    except checker.Rejected as error:
        raise Disagreement(
            f"flint and the checker disagree: flint accepts the evidence, the checker says: {error}"
        ) from None
    if (found.claim, found.digest, found.sign) != (claim, digest, sign):
        raise Disagreement("the checker reads another statement in it")
    return found.theorems


def _divisors_by_goal(
    goals: Sequence[Simple], theorems: Iterable[checker.Theorem]
) -> Iterator[list[Element]]:
    """What the theorems suppose not to vanish, goal by goal, as what it is divided by."""
    parts = chain.from_iterable(one.parts or (one,) for one in theorems)
    for goal, theorem in zip(goals, parts, strict=True):
        if isinstance(goal, Along):  # where a side is not defined it says nothing
            yield []
            continue
        scalar = finder_of(goal.space).scalar
        yield [scalar(decode(tree)).inverse() for tree in theorem.divisors]


def _factors(divided: Divided) -> dict[Setting, set[Shape]]:
    """The irreducible factors that may not vanish, by the spaces in which they stand."""
    found: dict[Setting, set[Shape]] = {}
    for goal, elements in divided:
        if isinstance(goal, Along):
            continue
        at = finder_of(goal.space)
        granted = granted_factors(map(at.scalar, goal.space.nonzero)) | _of_powers(at)
        for divisor in may_vanish(goal, elements):
            for shape, factor in factors_of(divisor).items():
                if shape not in granted:
                    both = {shape, shape_of(_conjugate(factor, at))}
                    found.setdefault(goal.space, set()).update(both)
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
