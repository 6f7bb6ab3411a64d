"""What a reader is told of a proof: steps with formulas, counterexamples with what their values are."""

import re

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.notation import to_plain
from kowalevski_cas.verify.run import Session

CLAIMS = (
    "U1-prime", "eq4.1", "eq7", "J3", "M4-dimension", "eq9.i", "eq9", "eq10.5", "eq14", "eq15", "Q1-prime",
    "eq16.invariance",
    "real-form.1", "equilibria", "eq22", "critical-set", "redundant-integral", "kowalevski-variable",
    "eq13.conjugate",
)  # fmt: skip


@pytest.fixture(scope="module")
def told(derivation, certificates, record):
    """The outcomes by claim, with their steps."""
    found = Session(
        derivation, EXACT[:1], explain=True, certificates=certificates, record=record
    ).run(CLAIMS)
    return {outcome.claim: outcome for outcome in found.outcomes}


@pytest.fixture
def steps(told):
    def steps(claim):
        return [(step.words, [*map(to_plain, step.formulas)]) for step in told[claim].steps]

    return steps


@pytest.mark.slow
def test_a_first_integral(steps):
    assert steps("eq4.1") == [
        ("The derivative along the vector field vanishes identically.", []),
        ("the differential does not vanish, so the function is not constant.", []),
    ]


def test_a_derivative_is_by_the_time_of_its_scene(steps):
    ((words, formulas),) = steps("eq10.5")
    assert words == "The derivative along the vector field:"
    assert formulas[0] == "dz₁/dτ = (x₁w₂ − y₂w₁)/2"


def test_a_derivative_is_shown_in_factors_as_the_paper_prints_it(steps):
    ((_, formulas),) = steps("U1-prime")
    assert formulas == ["dU₁/dτ = c₁(x₁ + w₁²)(x₁x₂ω₃ − x₁w₂z₂ − x₂w₁z₁)/x₁²"]


def test_an_equation_that_follows_is_a_combination_of_what_is_given(steps):
    generated, combined, *_, point = steps("J3")
    assert generated[1][0].startswith("d/dt[(ω₁² + ω₂²)ω₃ + 2(ω₁α₃ + ω₂β₃)] = ")
    assert combined[0] == "The difference of the two sides is a combination of the hypotheses:"
    assert combined[1][0].endswith(" = −(α₂ + β₁)J₁ + (α₁ − β₂)J₂")
    assert point[0].startswith("the differential is independent")


def test_both_directions_of_an_equivalence_stand_together(steps):
    ((words, formulas),) = steps("real-form.1")
    assert words == "The difference of the two sides is a combination of the hypotheses:"
    assert len(formulas) == 2 and formulas[0].endswith("= √(x₁x₂)F₁")


def test_invariant_relations_show_the_cofactors(steps):
    ((words, formulas),) = steps("eq7")
    assert words == "The derivatives are linear combinations of the relations:"
    assert formulas == ["J̇₁ = ω₃J₂", "J̇₂ = −ω₃J₁"]
    ((_, formulas),) = steps("eq15")
    assert formulas[0] == "dF₁/dτ = (1/[2√(x₁x₂)])F₂"


def test_what_is_too_long_is_counted(steps):
    _, (words, formulas) = steps("eq16.invariance")
    assert words.endswith("whose coefficients have 152 terms") and not formulas


def test_sides_that_are_equal_identically_are_said_to_be_so(steps):
    assert steps("eq13.conjugate") == [("Written out, this is an identity.", [])]
    assert steps("Q1-prime") == [("Written out, each of the equations is an identity.", [])]


def test_cases_eliminants_and_constant_roots(steps):
    assert "case by case" in steps("redundant-integral")[0][0]
    ((words, formulas),) = steps("equilibria")
    assert words.startswith("The solutions are given by the roots of one equation")
    assert formulas[1] == "s⁴ − 2(a² + b²)s² + (a⁴ − 2a²b² + b⁴ + 4c²) = 0"
    assert steps("kowalevski-variable")[0] == ("The root that the program found:", ["s = (1/2)√k"])


def test_a_dimension_is_that_at_a_point_and_a_combination_for_all_others(told):
    step, everywhere = told["M4-dimension"].steps
    assert everywhere.words.startswith("The differentials are independent at every point")
    assert step.point is not None and len(step.point.values) == 9
    assert "near this point the common level is a manifold of dimension 4" in step.words


def test_a_counterexample_says_what_its_values_are(told):
    assert told["eq14"].counterexample.words == ""
    assert told["critical-set"].counterexample.words.startswith(
        "the left side of (19), $2\\alpha_1"
    )
    assert told["critical-set"].counterexample.words.endswith(
        "= 0$, is $1$, not $0$, though this is a critical point on "
        r"$(\boldsymbol{\alpha}, \boldsymbol{\alpha}) = 1$"
    )
    (condition,) = told["eq16.invariance"].conditions
    assert re.search(r"along the motion is \$-?[1-9]\d*\$, not \$0\$$", condition.witness.words)


def test_an_equation_that_is_not_the_one_claimed_is_named(told):
    assert told["eq9.i"].counterexample.words.startswith(
        r"the left side of $2\frac{\dot{z}_1}{i} ="
    )
    assert told["eq14"].counterexample.words == ""


def test_a_correction_that_is_accepted_is_named_by_what_rests_on_it(told):
    assert told["eq9.i"].correction.accepted and not told["eq14"].correction.accepted
    assert told["eq9.i"].corrected == () and told["J3"].corrected == ()
    assert told["eq9"].corrected == told["eq14"].corrected == ("eq9.i",)
