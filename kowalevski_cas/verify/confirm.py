"""The second program: what the judge accepts the checker has to accept, or there is no verdict.

It has no part in how the judge thinks. It gets the text of a certificate and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from kowalevski_cas import UserError
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.paper.denominators import Shape, factors_below, shape_of
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.goals import Simple, simple
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
    found = _factors(accepted.divided), _factors(zip(goals, _divided(goals, theorems), strict=True))
    for setting in {*found[0], *found[1]}:
        judge, other = (factors.get(setting, set()) for factors in found)
        if judge != other:
            more, whose = (judge - other, "flint") if judge - other else (other - judge, "checker")
            raise Disagreement(
                f"the conditions of flint and of the checker differ: {whose} has "
                f"{len(more)} more on “{setting.scene.name}”"
            )


def receive(outcome: Outcome) -> Outcome:
    """An outcome that comes from elsewhere; an error, if it is not accepted here."""
    try:
        need_certificates(outcome)
    except Disagreement as error:
        return outcome._replace(
            verdict=Verdict.ERROR, message=str(error), certificate="", conditions=(),
            counterexample=None, correction=None,
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
    if outcome.correction is not None:
        due.append((outcome.correction.digest, "holds", outcome.correction.certificate))
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


def _divided(
    goals: Sequence[Simple], theorems: Iterable[checker.Theorem]
) -> Iterator[list[Element]]:
    """What the theorems suppose not to vanish, goal by goal, as what it is divided by."""
    parts = chain.from_iterable(one.parts or (one,) for one in theorems)
    for goal, theorem in zip(goals, parts, strict=True):
        assert isinstance(goal.space, Elaboration)
        scalar = goal.space.finder.scalar
        yield [scalar(decode(tree)).inverse() for tree in theorem.divisors]


def _factors(divided: Divided) -> dict[Elaboration, set[Shape]]:
    """The irreducible factors that may not vanish, by the settings in which they stand."""
    found: dict[Elaboration, set[Shape]] = {}
    for goal, elements in divided:
        setting = goal.space
        assert isinstance(setting, Elaboration)
        powers = _of_powers(setting)
        for index in may_vanish(goal, elements, setting):
            for shape, factor in setting.divisors.left(index).factors.items():
                both = {shape, shape_of(_conjugate(factor, setting))}
                found.setdefault(setting, set()).update(both - powers)
    return found


def _of_powers(setting: Elaboration) -> set[Shape]:
    """Bases of powers and the powers themselves, which are positive wherever they are defined."""
    scalar = setting.finder.scalar
    powers = [setting.raised(name) for name in setting.powers]
    elements = [scalar(f) for step in powers for f in (step.base, Name(step.name))]
    return {shape for element in elements for shape in factors_below(element.inverse())}


def _conjugate(element: Element, setting: Elaboration) -> Element:
    """What vanishes at a real point wherever the element does."""
    at = setting.finder
    if not setting.conjugates:
        return element
    return at.image(element, lambda name: at.scalar(Name(name), True))
