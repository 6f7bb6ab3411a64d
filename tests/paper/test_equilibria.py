"""The body has exactly four equilibria, unless a = b and c = 0."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.library import load
from kowalevski_cas.notation import Application, Formula, Negative, Number, to_latex
from kowalevski_cas.paper.claims import Equilibria, RestPoints
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import Denial, Roots
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.verify.counterexamples import counterexample
from kowalevski_cas.verify.outcome import Counterexample, PrintedPoint, Verdict
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.paper.small import Motion

pytestmark = pytest.mark.usefixtures("uncorrected")

DERIVATION = load("kharlamov2002")
[CLAIM] = [claim for claim in DERIVATION.claims if isinstance(claim, Equilibria)]

Vector = tuple[Fraction, ...]


@pytest.fixture(scope="module")
def session(certificates):
    return Session(DERIVATION, EXACT, True, certificates)


@pytest.fixture(scope="module")
def outcome(session):
    return session.decide(CLAIM)


def listed(found: Counterexample) -> list[tuple[Vector, Vector]]:
    """The fields at the states of rest that a counterexample lists."""

    def vector(tex: str) -> Vector:
        return tuple(
            Fraction(re.sub(r"\\frac\{(\d+)\}\{(\d+)\}", r"\1/\2", x).replace(" ", ""))
            for x in tex.removeprefix(r"\left").strip("()").removesuffix(r"\right").split(",")
        )

    values = {to_latex(name): to_latex(value) for name, value in found.point.values.items()}
    alpha = [vector(v) for name, v in values.items() if r"\alpha" in name]
    beta = [vector(v) for name, v in values.items() if r"\beta" in name]
    return list(zip(alpha, beta, strict=True))


def scalar_product(left: Vector, right: Vector) -> Fraction:
    return sum((x * y for x, y in zip(left, right, strict=True)), Fraction(0))


def is_equilibrium(alpha: Vector, beta: Vector) -> bool:
    """e1 x alpha + e2 x beta = 0, in components."""
    return (beta[2], -alpha[2], alpha[1] - beta[0]) == (0, 0, 0)


def constants(alpha: Vector, beta: Vector) -> tuple[Fraction, ...]:
    pairs = ((alpha, alpha), (beta, beta), (alpha, beta))
    return tuple(scalar_product(left, right) for left, right in pairs)


def test_there_are_four_unless_the_fields_are_orthogonal_and_equal(outcome) -> None:
    assert set(outcome.verdicts.values()) == {Verdict.CONDITIONAL} and set(outcome.verdicts) == set(
        EXACT
    )
    assert [to_latex(c.expression) for c in outcome.conditions] == ["(a^2 - b^2)^2 + 4c^2"]


def at_angle(found: Counterexample, t: Fraction) -> Counterexample:
    """A circle of solutions at tan φ/2 = t."""
    wave = {r"\cos": (1 - t * t) / (1 + t * t), r"\sin": 2 * t / (1 + t * t)}

    def value(formula: Formula) -> Formula:
        if isinstance(formula, Application):
            return fraction_formula(wave[formula.function])
        formula = formula.map_children(value)
        if isinstance(formula, Negative) and isinstance(formula.argument, Negative):
            return formula.argument.argument
        return formula

    values = {name: v.map_children(value) for name, v in found.point.values.items()}
    return found._replace(point=PrintedPoint(values))


def test_on_the_exceptional_locus_there_is_a_circle(outcome) -> None:
    [condition] = outcome.conditions
    found = condition.witness
    assert found is not None and (found.left, found.right) == ("infinitely many", Number(4))
    assert condition.words == "for $a^2=b^2$ and $c=0$ there are infinitely many"
    angles = [Fraction(0), Fraction(1), Fraction(-1), Fraction(1, 2), Fraction(7)]
    states = [state for t in angles for state in listed(at_angle(found, t))]
    assert len(set(states)) == len(angles)
    assert all(is_equilibrium(alpha, beta) for alpha, beta in states)
    [(a2, b2, c)] = {constants(alpha, beta) for alpha, beta in states}
    assert a2 == b2
    assert c == 0
    assert a2 * b2 - c**2 != 0


def denied(session, claim):
    statement = Statement(claim, session.on(claim))
    denial = statement.search()
    assert isinstance(denial, Denial)
    judge = Judge(finder_of)
    judge.denies(statement.goals[denial.goal], denial.evidence)
    return counterexample(statement, denial, judge.accepted)


@pytest.mark.slow
@pytest.mark.parametrize("count", [2, 3, 5, 8])
def test_another_number_is_refuted(session, count: int) -> None:
    found = denied(session, replace(CLAIM, count=count))
    assert found.right == Number(count) and found.left in (Number(4), Number(count + 1))


@pytest.mark.slow
@pytest.mark.parametrize("many", [1, pytest.param(None, marks=pytest.mark.slow)])
def test_each_mutant_is_refuted(session, many: int | None) -> None:
    mutants = list(CLAIM.neighbours(session.texts))[:many]
    assert mutants
    for neighbour in mutants:
        assert denied(session, neighbour.claim)


def test_the_eliminant_is_a_biquadratic(session) -> None:
    statement = Statement(CLAIM, session.on(CLAIM))
    (roots,) = session.decider.archive.evidence(statement, "equilibria")
    assert isinstance(roots, Roots) and len(roots.eliminant) == 4
    at = finder_of(statement.goals[0].space)
    coefficients = [at.scalar(coefficient) for coefficient in roots.eliminant]
    assert coefficients[1].is_zero and coefficients[3].is_zero
    a2, b2, c = (at.ring.generator(name) for name in "abc")
    a2, b2 = a2 * a2, b2 * b2
    assert (coefficients[2] + (a2 + b2) * at.ring.number(2)).is_zero
    assert (coefficients[0] - (a2 - b2) ** 2 - c * c * at.ring.number(4)).is_zero


@pytest.mark.parametrize(
    ("field", "fixed", "count", "verdict", "shown"),
    [
        (r"\dot x=y, \dot y=-x", ("y",), 0, "refuted", Number(1)),
        (r"\dot x=y, \dot y=-x", ("y",), 2, "refuted", Number(1)),
        (r"\dot x=0, \dot y=0", (), 1, "refuted", "infinitely many"),
    ],
)
def test_nothing_is_left_to_be_solved_for(field, fixed, count, verdict, shown):
    """At rest all is zero, or anything at all."""
    found = Motion(field, "x", "y").outcome(Equilibria, fixed=fixed, levels=(), count=count)
    assert found.verdict == verdict
    assert (found.counterexample and found.counterexample.left) == shown


@pytest.mark.parametrize(
    ("relations", "verdict"),
    [
        (r"x=0, y=0", "proved"),
        (r"z=0", "proved"),
        (r"x=0", "refuted"),
        (r"x=0, y=1", "refuted"),
        (r"x^2+1=0, z=0", "undecided"),  # there is no such point
    ],
)
def test_points_of_rest(relations, verdict):
    motion = Motion(r"\dot x=yz, \dot y=-xz, \dot z=0", "x", "y", "z")
    assert motion.verdict(RestPoints, relations=motion.all(relations)) == verdict


@pytest.mark.parametrize(("point", "verdict"), [("q=0", "proved"), ("q=1", "refuted")])
def test_velocities_vanish_at_rest(point, verdict):
    motion = Motion(r"\ddot q=-k^2q", "q", constants=("k",))
    assert motion.verdict(RestPoints, relations=motion.all(point)) == verdict


def test_each_sign_and_letter_of_a_point_of_rest_counts():
    motion = Motion(r"\dot x=y(x-1), \dot y=x-y", "x", "y")
    assert motion.verdict(RestPoints, relations=motion.all("x=1, y=1")) == "proved"
    for wrong in ("x=-1, y=1", "x=1, y=-1", "x=2, y=1", "x=1, y=2", "y=1, y=1"):
        assert motion.verdict(RestPoints, relations=motion.all(wrong)) == "refuted"
