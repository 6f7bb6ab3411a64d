"""A scene in an arithmetic: evaluation, derivatives, conjugation, changes of variables."""

import random
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT, load
from kowalevski_cas.library import load as load_derivation
from kowalevski_cas.notation import (
    Conjugate,
    Derivative,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Sum,
    read,
    to_latex,
)
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.problem.space import Meaningless
from tests.paper.formulas import COMPLEX, REAL, formulas

DERIVATION = load_derivation("kharlamov2002")
SOURCES = {"eq9.i": "i^2=-1"}  # as corrected
TEXTS = DERIVATION.texts(SOURCES)
SCENES = {scene.name: scene for scene in DERIVATION.scenes()}
ON = Elaborations(TEXTS)
STAGES: dict = {}


class Stage:
    """A scene in an arithmetic: printed formulas are written out, and evaluated."""

    def __init__(self, setting, at):
        self.setting, self.at = setting, at
        self.ring, self.derivative, self.value = at.ring, at.derivative, at.value

    def __call__(self, formula):
        return self.at(self.setting.plain(formula))


def stage(name, arithmetic="flint"):
    if (name, arithmetic) not in STAGES:
        setting = ON(SCENES[name])
        STAGES[name, arithmetic] = Stage(setting, evaluation(setting, arithmetic))
    return STAGES[name, arithmetic]


def evaluation(setting, arithmetic):
    if arithmetic == "flint":
        return setting.finder
    return Evaluation(
        setting, load(arithmetic), others=lambda old: stage(old.scene.name, arithmetic).at
    ).adjoin_roots()


def scalar(formula, on, conjugated=False):
    """The value of a printed formula, or of its conjugate."""
    return on.at.scalar(on.setting.plain(formula), conjugated)


def evaluate(formula, on):
    return on(formula)


def same(a, b):
    return (a - b).is_zero


every_arithmetic = pytest.mark.parametrize("name", EXACT)
real, complex_ = formulas(REAL), formulas(COMPLEX)


@every_arithmetic
@given(real, real)
def test_evaluation_is_a_homomorphism(name, f, g):
    on = stage("Kowalevski case", name)
    a, b = scalar(f, on), scalar(g, on)
    assert same(scalar(Sum((f, g)), on), a + b)
    assert same(scalar(Product((f, g)), on), a * b)
    assert same(scalar(Negative(f), on), -a)
    assert same(scalar(Power(f, Number(3)), on), a * a * a)
    if not b.is_zero:
        assert same(scalar(Quotient(f, g), on) * b, a)


@given(real)
def test_what_is_printed_has_the_same_value(f):
    on = stage("Kowalevski case")
    assert same(scalar(read(to_latex(f), TEXTS.vocabulary), on), scalar(f, on))


@every_arithmetic
@given(real, real, st.integers(-3, 3))
def test_the_dot_is_a_derivation(name, f, g, n):
    on = stage("Kowalevski case", name)

    def dot(h):
        return scalar(Derivative(h, "dot"), on)

    a, b, k = scalar(f, on), scalar(g, on), on.ring.number(n)
    assert same(dot(Product((f, g))), dot(f) * b + a * dot(g))
    assert same(on.derivative(a + k * b), dot(f) + k * dot(g))
    assert dot(Number(5)).is_zero


@given(real)
def test_the_arithmetics_agree(f):
    terms = [scalar(Derivative(f, "dot"), stage("Kowalevski case", name)).terms() for name in EXACT]
    assert terms[0] == terms[1] == terms[2]


@every_arithmetic
@given(complex_)
def test_a_change_of_variables_commutes_with_the_derivative(name, f):
    new, old = stage("complex variables", name), stage("initial variables", name)
    differentiated_then_substituted = old.at.image(scalar(Derivative(f, "prime"), new))
    substituted_then_differentiated = scalar(Derivative(f, r"\tau"), old)
    assert same(differentiated_then_substituted, substituted_then_differentiated)
    # and tau = it: the derivative by t is i times the one by tau
    i = old.ring.generator("i")
    assert same(scalar(Derivative(f, "dot"), old), i * substituted_then_differentiated)


def old_in_new(name, on):
    """The change (9), inverted by hand."""
    half, i = on.ring.number(Fraction(1, 2)), on.ring.generator("i")
    v = {n: on.value(n) for n in COMPLEX}
    x, y, z, w = ((v[f"{n}_1"], v[f"{n}_2"]) for n in "xyzw")
    quarter = half * half
    return {
        r"\omega_1": half * (w[0] + w[1]),
        r"\omega_2": half * (w[0] - w[1]) / i,
        r"\omega_3": v[r"\omega_3"],
        r"\alpha_1": quarter * (x[0] + x[1] + y[0] + y[1]),
        r"\beta_2": quarter * (y[0] + y[1] - x[0] - x[1]),
        r"\alpha_2": quarter * (x[0] - x[1] + y[0] - y[1]) / i,
        r"\beta_1": quarter * (x[0] - x[1] - y[0] + y[1]) / i,
        r"\alpha_3": half * (z[0] + z[1]),
        r"\beta_3": half * (z[0] - z[1]) / i,
    }[name]


@pytest.mark.parametrize("name", REAL)
def test_the_old_variables_are_known_through_the_new_ones(name):
    old, again = stage("initial variables"), stage("complex variables, all constants")
    printed = {"x_1": r"(\alpha_1-\beta_2)+i(\alpha_2+\beta_1)", "w_2": r"\omega_1-i\omega_2"}
    for new, tex in printed.items():
        assert same(scalar(TEXTS.expression(tex), again), again.value(new))
        assert same(scalar(TEXTS.expression(tex), old), scalar(TEXTS.expression(new), old))
    assert same(scalar(TEXTS.expression(name), again), old_in_new(name, again))


@given(complex_, complex_)
def test_conjugation_is_an_involution_and_commutes_with_everything(f, g):
    on = stage("complex variables, all constants")
    bar = Conjugate
    assert same(scalar(bar(bar(f)), on), scalar(f, on))
    assert same(scalar(bar(Sum((f, g))), on), scalar(bar(f), on) + scalar(bar(g), on))
    assert same(scalar(bar(Product((f, g))), on), scalar(bar(f), on) * scalar(bar(g), on))
    # tau is imaginary on real motions: conjugation changes the sign of the prime
    assert same(scalar(bar(Derivative(f, "prime")), on), -scalar(Derivative(bar(f), "prime"), on))


@given(complex_)
def test_conjugation_commutes_with_the_change(f):
    new, old = stage("complex variables"), stage("initial variables")
    assert same(old.at.image(scalar(f, new, True)), scalar(f, old, True))


@given(complex_)
def test_real_and_imaginary_parts(f):
    on = stage("complex variables, all constants")
    i = on.ring.generator("i")
    re, im = (
        scalar(read(rf"\mathop{{\rm {op}}}\nolimits ({to_latex(f)})", TEXTS.vocabulary), on)
        for op in ("Re", "Im")
    )
    assert same(re + i * im, scalar(f, on))
    assert same(re - i * im, scalar(f, on, True))


def value(tex, scene="Kowalevski case"):
    return evaluate(TEXTS.expression(tex), stage(scene))


@pytest.mark.parametrize(
    "tex",
    [
        r"({\bs\alpha}\times{\bs\beta},{\bs\alpha})",
        r"({\bs\alpha}\times{\bs\beta},{\bs\omega})+({\bs\beta}\times{\bs\alpha},{\bs\omega})",
        r"({\bs\alpha}\times{\bs\beta},{\bs\alpha}\times{\bs\beta})-({\bs\alpha},{\bs\alpha})({\bs\beta},{\bs\beta})+({\bs\alpha},{\bs\beta})^2",
        r"({\bs\alpha}\times({\bs\beta}\times{\bs\omega}),{\bs\omega})-({\bs\alpha},{\bs\omega})({\bs\beta},{\bs\omega})+({\bs\alpha},{\bs\beta})({\bs\omega},{\bs\omega})",
        r"({\bs\alpha},{\bs\beta})-\alpha_1\beta_1-\alpha_2\beta_2-\alpha_3\beta_3",
    ],
)
def test_identities_of_vectors(tex):
    assert value(tex).is_zero


def test_vectors_move_by_components():
    rates = value(r"\dot{\bs\alpha}")
    assert [same(a, value(rf"\dot\alpha_{k}")) for k, a in enumerate(rates, 1)] == [True] * 3
    assert all(
        same(a, b) for a, b in zip(value(r"{\bs\alpha}\times{\bs\omega}"), rates, strict=True)
    )


def test_the_printed_equations_of_the_complex_variables():
    on = stage("complex variables")
    for row in (
        r"2z'_1-x_1w_2+y_2w_1",
        r"2w'_1+w_1\omega_3+z_1",
        r"x_1'+x_1\omega_3-z_1w_1",
        r"2\omega_3'-y_2+y_1",
    ):
        assert scalar(TEXTS.expression(row), on).is_zero


@pytest.mark.parametrize(
    ("tex", "scene", "message"),
    [
        ("x_1", "Kowalevski case", "x_1 has no meaning on the scene “Kowalevski case”"),
        (r"\frac{1}{\alpha_1-\alpha_1}", "Kowalevski case", r"division by \alpha_1 - \alpha_1, which vanishes identically"),
        (r"(\alpha_1-\alpha_1)^{-1}", "Kowalevski case", r"division by \alpha_1 - \alpha_1, which vanishes identically"),
        (r"\sqrt{\alpha_1}", "Kowalevski case", r"no root of \alpha_1 is declared here"),
        (r"\sqrt{x_1}", "complex variables with the root", "no root of x_1 is declared here"),
        (r"\alpha_1'", "Kowalevski case", "no derivative is printed as “prime” on “Kowalevski case”"),
        (r"\alpha_1^{\alpha_2}", "Kowalevski case", r"the power \alpha_1^\alpha_2 is not declared"),
        (r"1+\dots", "Kowalevski case", r"\ldots has no value of its own"),
    ],
)  # fmt: skip
def test_what_has_no_meaning_says_so(tex, scene, message):
    with pytest.raises(Meaningless) as raised:
        value(tex, scene)
    assert str(raised.value).replace("{", "").replace("}", "") == message.replace("{", "").replace(
        "}", ""
    )


def test_the_name_to_blame_is_told():
    with pytest.raises(Meaningless) as raised:
        value("x_1")
    assert raised.value.name == "x_1"


def test_relations_of_the_scene_hold():
    on = stage("complex variables with the root")
    assert scalar(TEXTS.expression(r"(\sqrt{x_1x_2})^2-x_1x_2"), on).is_zero
    assert scalar(TEXTS.expression("z_1^2+x_1y_2-c_1"), on).is_zero
    assert scalar(TEXTS.expression("(z_1^2+x_1y_2)'"), on).is_zero


def test_what_is_set_to_zero_is_zero():
    assert value(r"\beta_1", "one field").is_zero
    assert all(b.is_zero for b in value(r"{\bs\beta}", "one field"))
    assert same(value(r"\xi_1", "one field"), value(r"\alpha_1", "one field"))


SCREENED = ["Kowalevski case", "complex variables", "complex variables with the root", "one field"]


@pytest.mark.parametrize("scene", SCREENED)
def test_programs_have_the_values_of_exact_elements(scene):
    on = stage(scene)
    programs = Sampled(on.at)
    choose = random.Random(1)
    names = list(on.setting.variables)
    mark = "dot" if on.setting.scene.time == "t" else "prime"
    for _ in range(10):
        a, b, c = (read(choose.choice(names), TEXTS.vocabulary) for _ in range(3))
        f = Sum((Product((a, b)), Negative(Quotient(c, Sum((a, Number(1)))))))
        by, then = choose.choice(names), choose.choice(names)
        rate, partial = Derivative(f, mark), Partial(Partial(Partial(f, by), then), by)
        mixed = Partial(Derivative(Partial(f, by), mark), by)
        for formula in (f, rate, Derivative(rate, mark), Partial(rate, by), partial, mixed):
            expected = programs.carry(scalar(formula, on))
            value = programs.scalar(on.setting.plain(formula))
            assert (value - expected).is_zero
            assert not (value - expected - programs.ring.one).is_zero


def test_an_image_takes_the_values_that_it_is_given():
    on = stage("Kowalevski case")
    image = {name: on.ring.number(Fraction(k, 2)) for k, name in enumerate(REAL)}
    at = Evaluation(on.setting, on.at.polynomials, on.ring, image)
    value = at.scalar(on.setting.plain(TEXTS.expression(r"\omega_2\alpha_1")))
    assert same(value, on.ring.number(Fraction(3, 4)))
