"""What stands in the place of angles and exponents has their values, and their derivatives."""

import cmath
import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Name,
    Negative,
    Number,
    Product,
    Sum,
    to_latex,
)
from kowalevski_cas.paper.claims import FirstIntegral, Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.transcendental import CIRCULAR, EXPONENTIAL
from tests.paper.small import decide, derivation
from tests.sample import sampled

MOTION = r"\dot x=\cos y+e^u,\quad\dot y=\sin x,\quad\dot u=v,\quad\dot v=e^u-x_0"


def scene_of(section, motion=MOTION, variables="x y u v", constants="x_0"):
    scene = Scene(variables=tuple(variables.split()), constants=tuple(constants.split()))
    return scene.moving(section.display("motion", motion))


@pytest.fixture(scope="module")
def on():
    section = Section("1", "")
    scene = scene_of(section)
    return Elaborations(derivation(section).texts(None, scene))(scene)


def value(formula, at):
    """The number that a formula is, where names have these values."""
    match formula:
        case Number(number):
            return number
        case Name(name):
            return at[name]
    inner = [value(child, at) for child in formula.children()]
    match type(formula).__name__:
        case "Sum":
            return sum(inner)
        case "Product":
            return math.prod(inner)
        case "Negative":
            return -inner[0]
        case "Quotient":
            return inner[0] / inner[1]
        case "Power":
            return inner[0] ** inner[1]
    raise AssertionError(formula)


def values(x, y, u):
    return {
        r"\sin{x}": math.sin(x), r"\cos{x}": math.cos(x), r"\sin{y}": math.sin(y),
        r"\cos{y}": math.cos(y), r"\mathrm{e}^{u/2}": math.exp(u / 2), "v": 3, "x_0": 2,
    }  # fmt: skip


multiples = st.integers(-3, 3).filter(bool)
numbers = st.floats(-1.3, 1.3).filter(lambda x: abs(x) > 0.01)


def term(name, multiple):
    one = Name(name) if abs(multiple) == 1 else Product((Number(abs(multiple)), Name(name)))
    return one if multiple > 0 else Negative(one)


@given(st.sampled_from(sorted(CIRCULAR)), multiples, multiples, numbers, numbers)
def test_circular_functions_of_combinations(on, function, m, n, x, y):
    assume(abs(cmath.sin(m * x + n * y)) > 1e-3)
    argument = Sum((term("x", m), term("y", n)))
    expected = getattr(cmath, function[1:], lambda z: cmath.cos(z) / cmath.sin(z))(m * x + n * y)
    found = value(on.plain(Application(function, (argument,))), values(x, y, 0))
    assert abs(found - expected) <= 1e-6 * (1 + abs(expected)) ** 2


@given(st.sampled_from(sorted(EXPONENTIAL)), multiples, numbers)
def test_exponential_functions_of_multiples(on, function, m, u):
    found = value(on.plain(Application(function, (term("u", m),))), values(0, 0, u))
    assert math.isclose(found, getattr(math, function[1:])(m * u), rel_tol=1e-9, abs_tol=1e-9)


@given(st.sampled_from(sorted(CIRCULAR | EXPONENTIAL)), multiples, numbers, numbers, numbers)
def test_rates_are_those_of_calculus(on, function, m, x, y, u):
    name = "u" if function in EXPONENTIAL else "x"
    formula = on.plain(Application(function, (term(name, m),)))
    rate = on.finder.scalar(Derivative(formula, "dot"))
    at = values(x, y, u)
    moved = 1e-6
    dx, du = math.cos(y) + math.exp(u), 3
    ahead = value(formula, values(x + moved * dx, y, u + moved * du))
    behind = value(formula, values(x - moved * dx, y, u - moved * du))
    from kowalevski_cas.algebra.present import formula_in

    found = value(formula_in(rate), at)
    assert abs(found - (ahead - behind) / (2 * moved)) <= 1e-4 * (1 + abs(found)) ** 3


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        ("x", "x stands under a sine, a cosine or an exponential, and by itself as well"),
        ("xv", "nothing is known of both at once"),
        (r"\sin v", "its argument has to be made of variables that stand under such functions"),
        (r"\sin\frac x2", "with whole coefficients"),
        (r"e^x", "is not known here"),
        (r"v\ln v", "a logarithm is read with a constant factor only"),
        (r"\arctan v", r"the function \arctan has no meaning here"),
    ],
)
def test_what_is_not_known_is_an_error_that_says_so(tex, message):
    section = Section("1", "")
    scene = scene_of(section)
    [outcome] = decide(section, FirstIntegral("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == "error"
    assert message in outcome.message


@pytest.mark.parametrize(
    "given_tex", sampled([r"\sin x=2", r"\cos x=\frac32", "e^u=-1", "e^u=0", r"\cosh u=0"], 2)
)
def test_nothing_follows_from_a_value_that_is_not_taken(given_tex):
    section = Section("1", "")
    scene = scene_of(section)
    given_place = section.display("given", given_tex)[1]
    claim = Implication(
        "c", scene, "", printed=section.display("d", "v=0")[1], given=(given_place,)
    )
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "undecided"


@pytest.mark.usefixtures("uncorrected")
def test_a_value_that_is_taken_refutes():
    section = Section("1", "")
    scene = scene_of(section)
    given_place = section.display("given", r"\sin x=\frac12")[1]
    true = Implication(
        "true", scene, "", printed=section.display("d", r"\cos^2x=\frac34")[1], given=(given_place,)
    )
    false = Implication(
        "false", scene, "", printed=section.display("e", r"\cos x=\frac34")[1], given=(given_place,)
    )
    assert [str(one.verdict) for one in decide(section, true, false)] == ["proved", "refuted"]


def test_what_a_derivative_by_an_angle_divides_by_is_remembered_where_it_cancels():
    section = Section("1", "")
    scene = scene_of(
        section, r"\dot x=-\frac{\partial}{\partial x}\frac{y\cos x}{y},\quad\dot y=0", "x y", ""
    )
    [outcome] = decide(
        section, Identity("c", scene, "", printed=section.display("d", r"\dot x=\sin x")[1])
    )
    assert (
        str(outcome.verdict) == "conditional" and to_latex(outcome.conditions[0].expression) == "y"
    )


def test_degrees_and_volumes_are_not_those_of_other_variables(on):
    with pytest.raises(ValueError, match="degrees, volumes and numbers of solutions are not known"):
        _ = on.own_variables


def test_an_angle_in_a_sine_and_in_an_exponential_is_refused():
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=\sin x+e^x", "x", "")
    claim = Identity("c", scene, "", printed=section.display("d", r"\dot x=\sin x+e^x")[1])
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "error"
