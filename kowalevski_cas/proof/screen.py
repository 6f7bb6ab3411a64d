"""Screening: a claim is put to points, which refute or make it probable, and never prove."""

from __future__ import annotations

from kowalevski_cas.arithmetic.points import Answer, NoPoint, Points
from kowalevski_cas.claims import Claim, Finding
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.notation import Formula
from kowalevski_cas.proof.outcome import Counterexample, Point, Value, Verdict


def screen(claim: Claim, bench: Bench, points: Points) -> Finding:
    """What an arithmetic of points says about a claim.

    ``probable`` with a bound on the chance that this is wrong, ``enclosed`` with a
    radius, ``refuted`` with a point; ``undecided``, with the reason, where the claim
    says what cannot be seen at points or where no point was found.
    """
    answers: list[Answer] = []
    try:
        questions = list(claim.questions(bench))
    except NoPoint as error:
        return Finding(Verdict.UNDECIDED, message=str(error))
    for question in questions:
        answer = points.answer(question)
        if answer.holds is False:
            read = bench.texts.expression
            values: dict[Formula, Value] = {read(n): v for n, v in answer.point.items() if n}
            found = Counterexample(Point(values), answer.left, answer.right, answer.words)
            return Finding(Verdict.REFUTED, counterexample=found, message=answer.words)
        answers.append(answer)
    reasons = [claim.beyond_points, *(answer.words for answer in answers if answer.holds is None)]
    if reasons := [reason for reason in reasons if reason]:
        return Finding(Verdict.UNDECIDED, message="; ".join(reasons))
    if not answers:
        return Finding(Verdict.UNDECIDED, message="nothing in this claim can be asked at points")
    radii = [answer.radius for answer in answers if answer.radius is not None]
    bounds = [answer.bound for answer in answers if answer.bound is not None]
    words = answers[-1].words
    if radii:
        return Finding(Verdict.ENCLOSED, message=words, radius=max(radii))
    return Finding(Verdict.PROBABLE, message=words, chance=max(bounds, default=None))
