"""Nothing is shown by what shows nothing: matrices without invariants, values that no point has,

logarithms of what is negative, roots of what is not real, corrections that repeat what is given.
"""

import random
from itertools import combinations

import pytest

from kowalevski_cas import System
from kowalevski_cas.notation import Relation
from kowalevski_cas.notation.sympy import to_sympy
from tests.laws.falsehoods import NAMES, Maker
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

FEW, MANY = 2, 25
MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]
ROTATION = r"\dot x=y,\quad \dot y=-x"


def system(field):
    made = System(field)
    made.seconds = 10
    return made


# -- Lax pairs ---------------------------------------------------------------------


def turned(choose, matrix):
    """A matrix of formulas in another basis of whole numbers."""
    a, b = choose.randint(-2, 2), choose.randint(-2, 2)
    P, inverse = [[1, a], [b, 1 + a * b]], [[1 + a * b, -a], [-b, 1]]
    return times(times(P, matrix), inverse)


def times(left, right):
    return [
        ["+".join(f"({row[k]})({right[k][j]})" for k in range(2)) for j in range(2)] for row in left
    ]


def lax(made, L, M):
    named = []
    for name, rows in (("L", L), ("M", M)):
        entries = r"\\".join("&".join(map(str, row)) for row in rows)
        named.append(made.define(rf"{{\bf {name}}}=\begin{{pmatrix}}{entries}\end{{pmatrix}}"))
    return made.lax(*named)


@pytest.mark.slow
@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_a_matrix_without_invariants_is_no_lax_pair(many):
    for seed in range(many):
        choose = random.Random(seed)
        k, a, b = (choose.randint(1, 3) for _ in range(3))
        still = [[0, 0], [0, 0]]
        for L, M in (
            (still, [["x", "y"], [k, a]]),
            ([[a, 0], [0, a]], [["x", "y"], [k, b]]),
            ([[a, 0], [0, -b]], [["x", 0], [0, "y"]]),
            ([[0, "x"], [0, 0]], [[f"-{k}", 0], [0, k]]),
        ):
            field = rf"\dot x={2 * k}x,\quad \dot y=-y"
            basis = (turned(random.Random(seed + 100), one) for one in (L, M))
            assert lax(system(field), *basis).verdict == "refuted", (L, M)


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_one_with_an_invariant_is(many):
    L, M = [["x", "y"], ["y", "-x"]], [[0, r"-\frac12"], [r"\frac12", 0]]
    for seed in range(many):
        basis = (turned(random.Random(seed), one) for one in (L, M))
        assert lax(system(ROTATION), *basis).verdict == "proved"


# -- values and logarithms ---------------------------------------------------------


def energies(many):
    """Functions of x² + y² that are positive, and a bound below which they have no value."""
    for seed in range(many):
        choose = random.Random(seed)
        a, b, c = (choose.randint(1, 4) for _ in range(3))
        yield rf"{a}(x^2+y^2)^2+{b}(x^2+y^2)+{c}", c


@pytest.mark.slow
@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_a_value_that_no_real_point_has_is_no_value(many):
    for energy, least in energies(many):
        for value in (least - 1, rf"\frac{{{least}}}{{2}}", -least, rf"-k^2-\frac1{least + 1}"):
            assert not system(ROTATION).integral(f"{energy}={value}").verdict.green, value
        assert system(ROTATION).integral(f"{energy}={least}+k^2").verdict.green


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_a_value_where_nothing_moves_is_none(many):
    for k in range(many):
        made = system(rf"\dot x=\frac{{1}}{{x-y-{k}}},\quad \dot y=\frac{{1}}{{x-y-{k}}}")
        assert not made.integral(f"x-y={k}").verdict.green
        assert made.integral(f"x-y={k + 1}").verdict.green


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(
    ("value", "green"),
    sampled([("2", False), (r"\frac{1}{2}", True), ("-1", True), ("-3", False)], 2),
)
def test_functions_have_the_values_that_they_take(value, green):
    made = system(r"\dot x=\sin y,\quad \dot y=0")
    assert made.integral(rf"\sin y={value}").verdict.green == green
    assert made.integral(f"y={value}").verdict.green


@pytest.mark.slow
@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_a_logarithm_of_what_is_nowhere_positive_is_no_integral(many):
    for energy, _ in energies(many):
        made = system(ROTATION)
        assert not made.integral(rf"\ln(-({energy}))").verdict.green
        assert not made.integral(rf"x^2+y^2+3\ln(-({energy}))-\ln({energy})").verdict.green
        assert made.integral(rf"\ln({energy})").verdict.green
        assert made.integral(rf"\ln|-({energy})|").verdict.green


# -- complex functions -------------------------------------------------------------


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_of_two_complex_roots_none_is_known_to_be_the_conjugate(many):
    made = system(rf"{ROTATION},\quad i^2=-1")
    for seed in range(many):
        choose = random.Random(seed)
        a, b = choose.randint(1, 3), choose.choice([-2, -1, 1, 2])
        z, bar = f"{a}x+({b})iy", f"{a}x-({b})iy"
        for sign in ("", "-"):
            stated = made.identity(rf"\overline{{\sqrt{{{z}}}}}={sign}\sqrt{{{bar}}}")
            assert not stated.verdict.green


@pytest.mark.slow
@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("many", MARKS)
def test_a_complex_equation_makes_no_partial_integral_of_what_vanishes_with_it(many):
    """Where z = x + iy vanishes x does: that it is constant there is nothing of the motion."""
    for seed in range(many):
        k = random.Random(seed).randint(1, 4)
        made = system(rf"\dot x={k}(x^2+y^2),\quad \dot y=x^2+y^2,\quad i^2=-1")
        for function in ("x", "y", f"x-{k}y", "x-iy"):
            for given in ("x+iy=0", "x-iy=0", ("x+iy=0", "x-iy=0")):
                assert not made.integral(function, given=given).verdict.green


# -- corrections -------------------------------------------------------------------


def wrong(maker):
    """Statements that are false, with equations that are given or stand beside them."""
    one, other = (maker.zero_at(point) for point in [maker.point()] * 2)
    rates = [rf"x\cdot({one.tex})", other.tex, rf"z\cdot({one.tex})"]
    made = system(", ".join(rf"\dot {n}={r}" for n, r in zip(NAMES, rates, strict=True)))
    yield made, made.invariant("x=0", f"{other.tex}=0")
    yield made, made.implication(f"{other.tex}=0", given=("x=0", "z=0"))


def is_multiple(element, other):
    """Whether one polynomial divides another; this is left to SymPy."""
    from sympy import reduced

    return element != 0 and other != 0 and reduced(element, [other])[1] == 0


def difference(relation, made):
    """Left minus right side, in SymPy."""
    left, right = (to_sympy(side, made) for side in relation.members)
    return (left - right).expand()


@pytest.mark.parametrize("many", MARKS)
def test_a_correction_repeats_nothing(many):
    for seed in range(many):
        for made, stated in wrong(Maker(seed)):
            correction = stated.outcome.correction
            if correction is None:
                continue
            symbols = made.symbols
            given = [
                difference(made.read(p.tex), symbols) for p in getattr(stated.claim, "given", ())
            ]
            own = [difference(f, symbols) for f in correction.formulas if isinstance(f, Relation)]
            for first, second in combinations([*given, *own], 2):
                assert not is_multiple(second, first), (stated, correction.formulas)
