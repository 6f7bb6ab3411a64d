"""Which points are critical for (2L^2-H)^2-K on the reduced phase space."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import load
from kowalevski_cas.notation import Name, edits, to_latex
from kowalevski_cas.paper.claims import CriticalSet
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import Denial, Entailment, Proof
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.sample import sampled

DERIVATION = load("kharlamov2002")
[CLAIM] = [claim for claim in DERIVATION.claims if isinstance(claim, CriticalSet)]
ON_ZERO_LEVEL = replace(CLAIM, zero_level=True)

Point = tuple[Fraction, ...]


@pytest.fixture(scope="module")
def session(certificates, record):
    return Session(DERIVATION, EXACT, True, certificates, record=record)


@pytest.fixture(scope="module")
def outcome(session):
    return session.decide(CLAIM)


def point(values) -> Point:
    values = {to_latex(name): _fraction(to_latex(value)) for name, value in values.items()}
    names = (*(rf"\omega_{k}" for k in (1, 2, 3)), *(rf"\alpha_{k}" for k in (1, 2, 3)))
    return tuple(values[name] for name in names)


def _fraction(tex: str) -> Fraction:
    return Fraction(tex.replace(r"\frac{", "").replace("}{", "/").replace("}", ""))


def function(x: Point) -> Fraction:
    w1, w2, w3, a1, a2, a3 = x
    area = a1 * w1 + a2 * w2 + a3 * w3 / 2
    energy = w1**2 + w2**2 + w3**2 / 2 - a1
    kowalevski = (w1**2 - w2**2 + a1) ** 2 + (2 * w1 * w2 + a2) ** 2
    return (2 * area**2 - energy) ** 2 - kowalevski


def equations(x: Point) -> tuple[Fraction, Fraction]:
    """The left sides of (18) and (19)."""
    w1, w2, w3, a1, a2, a3 = x
    first = (a1**2 + a2**2) * w3 - 2 * (a1 * w1 + a2 * w2) * a3
    return first, 2 * a1 * a2 * (w1**2 - w2**2 + a1) - (a1**2 - a2**2) * (2 * w1 * w2 + a2)


def derivative(x: Point, direction: Point) -> Fraction:
    """The derivative of the function, exactly: its degree on a line is at most 8."""
    nodes = [Fraction(k) for k in range(-4, 5) if k]
    total = Fraction(0)
    for node in nodes:
        weight = Fraction(1) / node
        for other in nodes:
            if other != node:
                weight *= other / (other - node)
        step = tuple(a + node * b for a, b in zip(x, direction, strict=True))
        total += weight * (function(step) - function(x))
    return total


def along_the_sphere(x: Point) -> list[Fraction]:
    a1, a2, a3 = x[3:]
    zero, one = Fraction(0), Fraction(1)
    free = [tuple(one if k == j else zero for k in range(6)) for j in range(3)]
    turns = [(-a2, a1, zero), (-a3, zero, a1), (zero, -a3, a2)]
    return [derivative(x, d) for d in (*free, *((zero, zero, zero, *turn) for turn in turns))]


def on_the_sphere(x: Point) -> bool:
    return sum(a * a for a in x[3:]) == 1


def test_not_all_critical_points_lie_on_the_set(outcome) -> None:
    """The word “exactly” is refuted: a body that starts at rest, its axis level, is critical."""
    assert set(outcome.verdicts.values()) == {Verdict.REFUTED} and set(outcome.verdicts) == set(
        EXACT
    )
    x = point(outcome.counterexample.point.values)
    assert on_the_sphere(x)
    assert x[3] ** 2 + x[4] ** 2 != 0
    assert along_the_sphere(x) == [0] * 6
    assert any(equations(x))
    assert function(x) != 0


def test_on_the_zero_level_the_set_is_exactly_that_off_the_poles(outcome) -> None:
    correction = outcome.correction
    assert correction.verdict is Verdict.CONDITIONAL
    assert "at which the function vanishes" in correction.words
    [condition] = correction.conditions
    assert to_latex(condition.expression) == r"\alpha_1^2 + \alpha_2^2"
    x = point(condition.witness.point.values)
    assert on_the_sphere(x)
    assert (x[3], x[4]) == (0, 0)
    assert equations(x) == (0, 0)
    assert any(along_the_sphere(x))


def test_the_correction_comes_first(session) -> None:
    neighbour = next(CLAIM.neighbours(session.texts))
    assert neighbour.claim.zero_level and not CLAIM.zero_level


def statement(session, claim, texts=None):
    on = session.on(claim)
    return Statement(claim, on if texts is None else on.under(texts))


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            "change the sign of $K$",
            "change the sign of $H$",
            "omit $2$ in $2L^2$",
            "for $2$ read $3$",
            "insert $2$ before $K$",
        ],
        1,
    ),
)
@pytest.mark.parametrize("claim", [CLAIM, ON_ZERO_LEVEL], ids=["any level", "zero level"])
def test_another_function_moves_on_the_set(session, claim, words) -> None:
    texts = session.on(claim).texts
    [edit, *_] = [
        e for e in edits(texts.statement(claim.printed), texts.vocabulary) if e.words == words
    ]
    one = statement(session, claim, texts.with_edit(claim.printed, edit))
    denial = one.search()
    assert isinstance(denial, Denial)
    Judge(finder_of).denies(one.goals[denial.goal], denial.evidence)
    if denial.goal == 0:
        x = point({Name(name): value for name, value in denial.evidence.point.values.items()})
        assert on_the_sphere(x)
        assert equations(x) == (0, 0)
        assert x[3] ** 2 + x[4] ** 2 != 0


def test_wrong_steps_prove_nothing(session) -> None:
    one = statement(session, ON_ZERO_LEVEL)
    shown = session.decider.archive.evidence(one, "corrected/critical-set")
    converse = shown[1]
    assert isinstance(converse, Entailment) and converse.proof.cases
    Judge(finder_of).holds(one.goals[1], converse)
    proof = converse.proof
    (step,), (rest,) = proof.product, proof.cases
    for wrong in (
        proof._replace(product=rest.product),
        proof._replace(cases=(rest._replace(product=(step,)),)),
        proof._replace(cases=(rest._replace(power=1),)),
        proof._replace(cases=(Proof(),)),
        proof._replace(cases=rest.cases),
        Proof(proof.rows),
        rest,
        Proof(),
    ):
        with pytest.raises(Unproved):
            Judge(finder_of).holds(one.goals[1], converse._replace(proof=wrong))
