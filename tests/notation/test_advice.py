"""What is typed as in Python, or in Unicode, is refused with what to print instead."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.notation import NotationError

PRINTED = [
    ("x**2+y", "x**2", "x^2"),
    ("y+x**10", "x**10", "x^{10}"),
    ("xy**-1", "y**-1", "y^{-1}"),
    ("(x+y)**2", "**2", "^2"),
    ("x**(1/2)", "x**(1/2)", "x^{1/2}"),
    ("x²", "x²", "x^2"),
    ("2x³y", "x³", "x^3"),
    ("x⁻¹", "x⁻¹", "x^{-1}"),
    ("x^-1", "x^-1", "x^{-1}"),
    ("x^(2)", "x^(2)", "x^2"),
    ("½x", "½", r"\frac12"),
    ("x==y", "==", "="),
    ("x<=y", "<=", r"\le "),
    ("x>=y", ">=", r"\ge "),
    ("x!=y", "!=", r"\ne "),
    ("sin(x)", "sin", r"\sin"),
    ("np.cos(x)", "np.cos", r"\cos"),
    ("log(x)", "log", r"\ln"),
    ("2exp(x)", "exp", r"\exp"),
    ("sigma(y-x)", "sigma", r"\sigma"),
    ("d/dt(x)", "d/dt", r"\frac{d}{dt}"),
]

WORDS = [
    ("2*x", "*", r"nothing, or \cdot,"),
    ("x * y", "*", r"nothing, or \cdot,"),
    ("sqrt(x)", "sqrt", r"\sqrt{…}"),
    ("math.sqrt(x)", "math.sqrt", r"\sqrt{…}"),
    ("√x", "√", r"\sqrt{…}"),
    ("abs(x)", "abs", "|…|"),
    ("Rational(1,2)x", "Rational", r"\frac{…}{…}"),
    ("Eq(x,y)", "Eq", "… = …"),
    ("Derivative(x,t)", "Derivative", r"\dot x, or \frac{dx}{dt},"),
    ("diff(x,t)", "diff", r"\dot x, or \frac{dx}{dt},"),
    ("x.diff(t)", ".diff", r"\dot x, or \frac{dx}{dt},"),
]


@pytest.fixture(scope="module")
def system():
    return System(r"\dot x=\sigma y,\quad \dot y=-x")


def refused(system, tex):
    with pytest.raises(NotationError) as caught:
        system.read(tex)
    return str(caught.value)


@pytest.mark.parametrize(("tex", "typed", "printed"), PRINTED + WORDS)
def test_a_refusal_says_what_to_print(system, tex, typed, printed):
    assert refused(system, tex).splitlines()[0].endswith(f"; print {printed.strip()} for {typed}")


@pytest.mark.parametrize(("tex", "typed", "printed"), PRINTED)
def test_what_is_advised_can_be_read(system, tex, typed, printed):
    system.read(tex.replace(typed, printed))


@pytest.mark.parametrize("field", [r"\dot x=sqrt(x)", r"\dot x=sin(x)", r"\dot x==y", r"\dot x=y²"])
def test_equations_of_motion_are_refused_like_that_too(field):
    with pytest.raises(NotationError, match="; print "):
        System(field)


@pytest.mark.parametrize("tex", ["w", "x+", r"\frac{x", "f(x)", "x_10", "x.y"])
def test_other_refusals_give_no_advice(system, tex):
    assert "print " not in refused(system, tex)


def test_the_nearest_names_are_told_where_no_other_word_is_known(system):
    assert "did you mean" in refused(system, "s")
    assert "did you mean" not in refused(system, "sigma")
