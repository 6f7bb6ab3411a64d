"""What stands in the place of angles and exponents has their values, and their derivatives."""

import cmath
import math
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    to_latex,
)
from kowalevski_cas.notation.functions import JACOBI, THIRD_KIND
from kowalevski_cas.paper.claims import FirstIntegral, Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.families import template
from tests.paper.small import decide, derivation
from tests.sample import sampled
from tests.test_dlmf import jacobi

CIRCULAR = {r"\sin", r"\cos", r"\tan", r"\cot"}
EXPONENTIAL = {r"\exp", r"\sinh", r"\cosh"}
MOTION = r"\dot x=\cos y+e^u,\quad\dot y=\sin x,\quad\dot u=v,\quad\dot v=e^u-x_0"


def scene_of(section, motion=MOTION, variables="x y u v", constants="x_0"):
    scene = Scene(variables=tuple(variables.split()), constants=tuple(constants.split()))
    return scene.moving(section.display("motion", motion))


@pytest.fixture(scope="module")
def on():
    section = Section("1", "")
    scene = scene_of(section)
    elaborations = Elaborations(derivation(section).texts(None, scene))

    def meeting(*formulas):
        return elaborations.meeting(formulas)(scene)

    return meeting


def value(formula, at, space=None):
    """The number that a formula is, where names have these values."""
    match formula:
        case Number(number):
            return number
        case Name(name) if name in at:
            return at[name]
        case Name(name):
            return value(space.step(name).formula, at, space)
    inner = [value(child, at, space) for child in formula.children()]
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
    halves = {
        r"\sin{\frac{x}{2}}": math.sin(x / 2), r"\cos{\frac{x}{2}}": math.cos(x / 2),
        r"\sin{\frac{y}{2}}": math.sin(y / 2), r"\cos{\frac{y}{2}}": math.cos(y / 2),
        r"\mathrm{e}^{u/4}": math.exp(u / 4),
    }  # fmt: skip
    return halves | {
        r"\sin{x}": math.sin(x), r"\cos{x}": math.cos(x), r"\sin{y}": math.sin(y),
        r"\cos{y}": math.cos(y), r"\mathrm{e}^{u/2}": math.exp(u / 2), "v": 3, "x_0": 2,
    }  # fmt: skip


multiples = st.sampled_from([Fraction(n, 2) for n in range(-6, 7) if n])
numbers = st.floats(-1.3, 1.3).filter(lambda x: abs(x) > 0.01)


def term(name, multiple):
    above, below = abs(multiple).as_integer_ratio()
    one = Name(name) if above == 1 else Product((Number(above), Name(name)))
    one = one if below == 1 else Quotient(one, Number(below))
    return one if multiple > 0 else Negative(one)


@given(st.sampled_from(sorted(CIRCULAR)), multiples, multiples, numbers, numbers)
def test_circular_functions_of_combinations(on, function, m, n, x, y):
    assume(abs(cmath.sin(m * x + n * y)) > 1e-3)
    argument = Sum((term("x", m), term("y", n)))
    expected = getattr(cmath, function[1:], lambda z: cmath.cos(z) / cmath.sin(z))(m * x + n * y)
    formula = Application(function, (argument,))
    space = on(formula)
    found = value(space.plain(formula), values(x, y, 0), space)
    assert abs(found - expected) <= 1e-6 * (1 + abs(expected)) ** 2


@given(st.sampled_from(sorted(EXPONENTIAL)), multiples, numbers)
def test_exponential_functions_of_multiples(on, function, m, u):
    formula = Application(function, (term("u", m),))
    space = on(formula)
    found = value(space.plain(formula), values(0, 0, u), space)
    assert math.isclose(found, getattr(math, function[1:])(m * u), rel_tol=1e-9, abs_tol=1e-9)


@given(st.sampled_from(sorted(CIRCULAR | EXPONENTIAL)), multiples, numbers, numbers, numbers)
def test_rates_are_those_of_calculus(on, function, m, x, y, u):
    name = "u" if function in EXPONENTIAL else "x"
    printed = Application(function, (term(name, m),))
    space = on(printed)
    formula = space.plain(printed)
    rate = space.finder.scalar(Derivative(formula, "dot"))
    at = values(x, y, u)
    moved = 1e-6
    dx, du = math.cos(y) + math.exp(u), 3
    ahead = value(formula, values(x + moved * dx, y, u + moved * du), space)
    behind = value(formula, values(x - moved * dx, y, u - moved * du), space)
    found = value(formula_in(rate), at)
    assert abs(found - (ahead - behind) / (2 * moved)) <= 1e-4 * (1 + abs(found)) ** 3


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        (r"\sin(v+1)", "its argument has to be made of variables and constants of the scene"),
        (r"\sin\sin v", "its argument has to be made of"),
        (r"v\ln v", "a logarithm, or an arc, is read with a constant factor only"),
        (r"v\arctan v", "with a constant factor only"),
        (r"v\arcsin v", "with a constant factor only"),
        (r"\operatorname{sn}v", "print k behind the argument, or declare it"),
        (r"\wp(v)", "print g_2, g_3 behind the argument, or declare it"),
        (r"\sin(v,x)", "print one argument, and no more"),
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
        _ = on().own_variables


SYSTEM = r"\dot x=\cos y+e^u,\quad\dot y=\sin x,\quad\dot u=v,\quad\dot v=e^u-x_0"
IDENTITIES = [
    # angles by themselves and under functions, parts and sums of them, constants, the time
    (SYSTEM, r"\frac{d}{dt}\left(x\sin x\right)=(\sin x+x\cos x)\dot x"),
    (SYSTEM, r"\tg\frac x2=\frac{\sin x}{1+\cos x}"),
    (SYSTEM, r"1-\cos x=2\sin^2\frac x2"),
    (SYSTEM, r"\sin3x=3\sin x-4\sin^3x"),
    (SYSTEM, r"\frac{d}{dt}\sin\frac{x-y}{3}=\frac{\dot x-\dot y}{3}\cos\frac{x-y}{3}"),
    (SYSTEM, r"\frac{d}{dt}\sin(xy)=\cos(xy)(\dot xy+x\dot y)"),
    (SYSTEM, r"\frac{d}{dt}(e^{-x_0t}\cos x_0t)=-x_0e^{-x_0t}(\cos x_0t+\sin x_0t)"),
    (SYSTEM, r"\sin(x+x_0)=\sin x\cos x_0+\cos x\sin x_0"),
    (SYSTEM, r"\frac{\partial}{\partial x}\left(x\cos x\right)=\cos x-x\sin x"),
    (SYSTEM, r"\frac{d}{dt}\ch\frac u2=\frac v2\operatorname{sh}\frac u2"),
    (SYSTEM, r"\frac{d}{dt}\operatorname{sn}(x_0t,k)=x_0\operatorname{cn}(x_0t,k)\operatorname{dn}(x_0t,k)"),
    (SYSTEM, r"\frac{d}{dt}\operatorname{dc}(v,k)=(1-k^2)\operatorname{sc}(v,k)\operatorname{nc}(v,k)\dot v"),
]  # fmt: skip


def verdict_of(motion, tex):
    section = Section("1", "")
    scene = scene_of(section, motion, constants="x_0 k")
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    return str(outcome.verdict)


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("motion", "tex"), sampled(IDENTITIES, 4))
def test_identities_of_calculus(motion, tex):
    assert verdict_of(motion, tex) in ("proved", "conditional")


MUTANTS = [(r"\sin", r"\cos"), (r"\cos", r"\sin"), ("x", "y"), ("v", "u"), ("+", "-"), ("-", "+"),
           ("2", "3"), ("3", "2"), ("{cn}", "{sn}"), ("{sn}", "{cn}"), ("x_0", "x"), ("1", "2")]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("motion", "tex"), sampled(IDENTITIES, 1))
def test_a_mutant_is_never_proved(motion, tex):
    """But where it says the same: the sides are compared as numbers."""
    for old, new in MUTANTS:
        at = tex.rfind(old)
        mutant = tex[:at] + new + tex[at + len(old) :]
        if at > tex.index("=") and mutant != tex:
            assert verdict_of(motion, mutant) in ("refuted", "error"), mutant


@pytest.mark.parametrize(
    "given_tex",
    sampled(
        [r"x=\sin x", r"\sin x_0t=\frac12", r"x_0=1,", r"\operatorname{dn}(u,k)=-1", r"k=0"], 3
    ),
)
def test_of_values_that_hang_together_nothing_is_said(given_tex):
    """A sine and its angle, a frequency and a phase, three functions with one modulus."""
    section = Section("1", "")
    scene = scene_of(section, constants="x_0 k")
    given_place = section.display("given", given_tex)[1]
    tex = r"x\sin x\cos x_0t\operatorname{cn}(u,k)=0"
    claim = Implication("c", scene, "", printed=section.display("d", tex)[1], given=(given_place,))
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "error" and "is not known" in outcome.message


def test_a_name_that_stands_by_itself_keeps_its_values():
    """What is given of names that no function has in its argument is as good as ever."""
    section = Section("1", "")
    scene = scene_of(section, constants="x_0 k")
    given_place = section.display("given", "v=2")[1]
    claim = Implication(
        "c",
        scene,
        "",
        printed=section.display("d", r"v\sin x_0t=2\sin x_0t")[1],
        given=(given_place,),
    )
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "proved"


def test_the_letter_of_the_time_may_be_that_of_something_else():
    section = Section("1", "")
    scene = Scene(variables=("x",)).defining(section.display("t", r"t=\tan\frac{x}{2}"))
    claim = Identity("c", scene, "", printed=section.display("d", r"\sin x=\frac{2t}{1+t^2}")[1])
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "conditional"


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(
    "tex", sampled([r"\cos x=\sqrt{1-\sin^2x}", r"\sin x=\sqrt{1-\cos^2x}"], 1)
)
def test_a_printed_root_is_no_sine(tex):
    section = Section("1", "")
    scene = Scene(variables=("x",)).adjoining(tex[tex.index("=") + 1 :])
    claim = Identity("c", scene, "", printed=section.display("d", tex)[1])
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "refuted"


PI = [
    (r"\sin(\pi-x)=\sin x", "proved"),
    (r"\cos\left(\frac{\pi}{3}+x\right)=\frac12\cos x-\frac{\sqrt3}{2}\sin x", "proved"),
    (r"\cos\left(\frac{\pi}{3}+x\right)=\frac12\cos x+\frac{\sqrt3}{2}\sin x", "refuted"),
    (r"\sin(x+\pi)=\sin x", "refuted"),
    (r"\sin\frac{\pi}{5}=\frac12", "error"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(PI, 3))
def test_values_at_parts_of_pi(tex, verdict):
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=1", "x", r"\pi")
    scene = scene.adjoining(r"\sqrt{3}") if "sqrt" in tex else scene
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


@pytest.mark.usefixtures("uncorrected")
def test_a_pi_that_moves_is_no_number():
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=1,\quad\dot\pi=x", r"x \pi", "")
    claim = Identity("c", scene, "", printed=section.display("d", r"\sin(\pi-x)=\sin x")[1])
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "refuted"


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("unit", "sign", "verdict"), [("i^2=-1", "+", "proved"), ("i^2=-1", "-", "refuted"), ("i^2=1", "+", "error")])  # fmt: skip
def test_the_exponential_of_what_is_imaginary(unit, sign, verdict):
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=1", "x", "").with_unit(section.display("i", unit)[1])
    tex = rf"e^{{ix}}=\cos x{sign}i\sin x"
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


def test_of_what_is_complex_no_function_is_read():
    section = Section("1", "")
    motion = section.display("motion", r"\dot x_1=x_2,\quad\dot x_2=x_1")
    scene = Scene(variables=("x_1", "x_2"), conjugates=(("x_1", "x_2"),)).moving(motion)
    claim = Identity("c", scene, "", printed=section.display("d", r"\sin^2x_1+\cos^2x_1=1")[1])
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "error"


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(
    ("tex", "verdict"),
    sampled(
        [
            (r"\operatorname{sn}(x,k)=\operatorname{sn}(x,-k)", "undecided"),  # true, and not seen
            (r"\operatorname{sn}(x,k)=\operatorname{sn}(x,k^2)", "undecided"),  # false
            (r"\operatorname{am}(x,0)=x", "error"),
            (r"\operatorname{am}(2x,k)=2\operatorname{am}(x,k)", "error"),
            (r"\zeta(2x,g_2,g_3)=2\zeta(x,g_2,g_3)", "error"),
        ],
        1,
    ),
)
def test_with_two_moduli_nothing_is_refuted_and_what_is_not_known_is_refused(tex, verdict):
    assert verdict_at(tex) == verdict


def verdict_at(tex):
    """The verdict on an identity of functions of x and y, a modulus and two invariants."""
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=1,\quad\dot y=x", "x y", "k g_2 g_3")
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    return str(outcome.verdict)


ELLIPTIC = [
    # where the modulus is 0 or 1 they are circular and hyperbolic
    (r"\operatorname{dn}(x,0)=1", "proved"),
    (r"\operatorname{sd}(2x,0)=2\sin x\cos x", "proved"),
    (r"\operatorname{dn}(x,1)=\operatorname{cn}(x,1)", "conditional"),
    (r"\operatorname{sn}(x,-1)=\tanh x", "conditional"),
    (r"\operatorname{sn}(x,0)=\cos x", "refuted"),
    (r"\operatorname{sn}(x,1)=\sinh x", "refuted"),
    # the modulus is that of which the letter is declared
    (r"\operatorname{sn}^2x+\operatorname{cn}^2(x,k)=1", "proved"),
    (r"\operatorname{sn}2x=\frac{2\operatorname{sn}x\operatorname{cn}x\operatorname{dn}x}{1-k^2\operatorname{sn}^4x}", "conditional"),
    (r"\operatorname{sn}2x=\frac{2\operatorname{sn}x\operatorname{cn}x\operatorname{dn}x}{1-k\operatorname{sn}^4x}", "refuted"),
    (r"\wp'(x)^2=4\wp^3(x)-g_2\wp(x)-g_3", "conditional"),
    # the amplitude, of which the derivative is known
    (r"\frac{d}{dt}\operatorname{am}(x,k)=\operatorname{dn}(x,k)", "proved"),
    (r"\frac{d^2}{dt^2}\operatorname{am}(x,k)=-k^2\operatorname{sn}(x,k)\operatorname{cn}(x,k)", "proved"),
    (r"\frac{d}{dt}\operatorname{am}(x,k)=\operatorname{cn}(x,k)", "refuted"),
    # the function of Weierstrass, with its derivative and its poles
    (r"\wp'(x,g_2,g_3)^2=4\wp^3(x,g_2,g_3)-g_2\wp(x,g_2,g_3)-g_3", "conditional"),
    (r"\frac{d^2}{dt^2}\wp(x,g_2,g_3)=6\wp^2(x,g_2,g_3)-\frac12g_2", "conditional"),
    (r"\frac{d}{dt}\frac{1}{\wp(x,g_2,g_3)}=-\frac{\wp'(x,g_2,g_3)}{\wp^2(x,g_2,g_3)}", "conditional"),
    (r"\wp(x+y)=-\wp(x)-\wp(y)+\frac14(\frac{\wp'(x)-\wp'(y)}{\wp(x)-\wp(y)})^2", "conditional"),
    (r"\wp(x-y)=-\wp(x)-\wp(y)+\frac14(\frac{\wp'(x)-\wp'(y)}{\wp(x)-\wp(y)})^2", "refuted"),
    (r"\wp(2x)=-2\wp(x)+(\frac{12\wp^2(x)-g_2}{4\wp'(x)})^2", "conditional"),
    (r"\wp(-2x)=-2\wp(x)-(\frac{12\wp^2(x)-g_2}{4\wp'(x)})^2", "refuted"),
    (r"\wp'(-x)=-\wp'(x)", "conditional"),
    (r"\wp'(-x)=\wp'(x)", "refuted"),
    (r"\frac{d^2}{dt^2}\wp(x,g_2,g_3)=6\wp^2(x,g_2,g_3)+\frac12g_2", "refuted"),
    (r"\wp'(x,g_2,g_3)^2=4\wp^3(x,g_2,g_3)-g_3\wp(x,g_2,g_3)-g_2", "refuted"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(ELLIPTIC, 6))
def test_elliptic_functions(tex, verdict):
    assert verdict_at(tex) == verdict


ARCS = [
    (r"\sqrt{1-x^2}", r"\arcsin x-y", "conditional"),
    (r"\sqrt{1-x^2}", r"\arccos x+y", "conditional"),
    (r"\sqrt{1-x^2}", r"\arccos x-y", "refuted"),
    (r"\sqrt{1+x^2}", r"\operatorname{arsinh}x-y", "conditional"),
    (r"\sqrt{1+x^2}", r"\operatorname{arcosh}x-y", "refuted"),
    (r"1-x^2", r"\operatorname{arcoth}x-y", "conditional"),
    (r"1-x^2", r"\operatorname{artanh}x-2y", "refuted"),
]


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("rate", "tex", "verdict"), sampled(ARCS, 3))
def test_arcs_are_known_by_their_derivatives(rate, tex, verdict):
    section = Section("1", "")
    scene = scene_of(section, rf"\dot x={rate},\quad\dot y=1", "x y", "")
    scene = scene.adjoining(rate) if "sqrt" in rate else scene
    [outcome] = decide(section, FirstIntegral("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


def complete(n, k, power):
    """An integral over a quarter of the circle by the trapezoidal rule, which is exact for these."""
    angles = [math.pi / 2 * (j + 0.5) / 200 for j in range(200)]
    roots = [
        (1 - (k * math.sin(a)) ** 2) ** (power / 2) / (1 - n * math.sin(a) ** 2) for a in angles
    ]
    return math.pi / 2 * sum(roots) / 200


@given(st.floats(-0.5, 0.6).filter(lambda n: abs(n) > 0.05), st.floats(0.1, 0.8))
def test_complete_integrals_move_as_the_table_says(n, k):
    assume(abs(n - k * k) > 0.05)

    def rate(tex):
        of = {r"\mathrm{K}": complete(0, k, -1), r"\mathrm{E}": complete(0, k, 1)}
        return value(written(template(tex), of), {"x": k, "n": n, "w": complete(n, k, -1)})

    def written(formula, of):
        if isinstance(formula, Application):
            return Number(of[formula.function])
        return formula.map_children(lambda one: written(one, of))

    step = 1e-5
    by_k = (complete(n, k + step, -1) - complete(n, k - step, -1)) / (2 * step)
    by_n = (complete(n + step, k, -1) - complete(n - step, k, -1)) / (2 * step)
    assert math.isclose(rate(THIRD_KIND.rates["w"]), by_k, rel_tol=1e-5)
    assert math.isclose(rate(THIRD_KIND.by["n"]["w"]), by_n, rel_tol=1e-5)


@given(st.floats(0.1, 1), st.sampled_from([0, 1]))
def test_degenerate_functions_have_the_values_of_the_series(x, modulus):
    """A power series and doublings, which know nothing of special moduli."""
    of = {r"\sin x": math.sin(x), r"\cos x": math.cos(x), "1": 1, r"\tanh x": math.tanh(x)}
    of[r"\frac{1}{\cosh x}"] = 1 / math.cosh(x)
    for letter, tex in JACOBI.degenerate[modulus,].items():
        assert abs(jacobi(x, modulus)[letter] - of[tex]) < 1e-9


def test_a_modulus_that_moves_is_refused():
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=1,\quad\dot k=1", "x k", "")
    tex = r"\frac{d}{dt}\operatorname{sn}(x,k)=\operatorname{cn}(x,k)\operatorname{dn}(x,k)"
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == "error"


PENDULUM = [
    (r"\dot x^2=\omega^2(1-x^2)(k^2-x^2)", "proved"),
    (r"\ddot x=-\omega^2x(1+k^2-2x^2)", "proved"),
    (r"\dot x=k\omega\operatorname{cn}(\omega t,k)\operatorname{dn}(\omega t,k)", "proved"),
    (r"\frac{d}{dt}(2k\omega\operatorname{cn}(\omega t,k))=-2\omega^2x\operatorname{dn}(\omega t,k)", "proved"),
    (r"\dot x^2=\omega^2(1+x^2)(k^2-x^2)", "refuted"),
    (r"\ddot x=-\omega^2x(1-k^2-2x^2)", "refuted"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(PENDULUM, 1))
def test_the_pendulum_of_a_textbook(tex, verdict):
    """Half its angle has the sine x, which is an elliptic function of the time."""
    section = Section("1", "")
    closed = section.display("closed", r"x=k\operatorname{sn}(\omega t,k)")
    scene = Scene(constants=("k", r"\omega")).defining(closed)
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


ARGUMENTS = [
    (r"\sqrt{\frac{g}{l}}t", r"\omega t", "undecided"),  # one of two roots, and the other
    (r"\sqrt{a}\sqrt{b}t", r"\sqrt{ab}t", "undecided"),
    (r"(a+1)t", "ct", "undecided"),  # the root of a square
    (r"\frac{t}{a+b}", r"\frac{2t}{2a+2b}", "undecided"),
    (r"\frac{a^2-b^2}{a-b}t", "at+bt", "undecided"),
    (r"\omega t", "at", "refuted"),
    (r"\sqrt{a}t", "at", "refuted"),
    (r"\frac{t}{a+b}", "at", "refuted"),
]


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("function", [r"\cos", r"\exp"])
@pytest.mark.parametrize(("left", "right", "verdict"), sampled(ARGUMENTS, 1))
def test_arguments_that_may_be_one_are_not_taken_for_two(function, left, right, verdict):
    section = Section("1", "")
    scene = Scene(constants=("a", "b", "g", "l"))
    scene = scene.solving(r"\omega", section.display("omega", r"\omega^2=\frac{g}{l}")[1])
    scene = scene.solving("c", section.display("c", "c^2=a^2+2a+1")[1])
    scene = scene.adjoining(*(one for one in (r"\sqrt{\frac{g}{l}}", r"\sqrt{a}", r"\sqrt{b}", r"\sqrt{ab}") if one in left + right))  # fmt: skip
    tex = f"{function}({left})={function}({right})"
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


AT_QUARTER = (
    r"\operatorname{sn}(K,k)=1,\quad\operatorname{cn}(K,k)=0,\quad\operatorname{dn}(K,k)=k'"
)
AT_HALF = r",\quad\operatorname{sn}(2K,k)=0,\quad\operatorname{cn}(2K,k)=-1,\quad\operatorname{dn}(2K,k)=1"
QUARTERS = [
    (AT_QUARTER, r"\operatorname{sn}(x+K,k)=\operatorname{cd}(x,k)", "conditional"),
    (AT_QUARTER, r"\operatorname{sn}(x+2K,k)=-\operatorname{sn}(x,k)", "conditional"),
    (AT_QUARTER, r"\operatorname{sn}(x+2K,k)=\operatorname{sn}(x,k)", "refuted"),
    (AT_QUARTER, r"\operatorname{sn}(\frac{K}{2},k)=1", "error"),  # of a half nothing is printed
    (AT_QUARTER + AT_HALF, r"\operatorname{sn}(x+3K,k)=-\operatorname{cd}(x,k)", "conditional"),
    (AT_HALF[6:], r"\operatorname{cn}(x+2K,k)=-\operatorname{cn}(x,k)", "proved"),
    (AT_HALF[6:], r"\operatorname{cn}(x-2K,k)=\operatorname{cn}(x,k)", "refuted"),
    (AT_HALF[6:], r"\operatorname{cn}(x+K,k)=0", "error"),
    (AT_QUARTER + AT_HALF.replace("-1", "1"), r"\operatorname{cn}(x,k)=0", "error"),
    (AT_QUARTER.replace("(K", "(x+K"), r"\operatorname{cn}(x,k)=0", "error"),
    (AT_QUARTER.replace("=1", "=2"), r"\operatorname{sn}(x+K,k)=\operatorname{cd}(x,k)", "error"),
    (
        AT_QUARTER.partition(r",\quad\operatorname{dn}")[0],
        r"\operatorname{sn}(x+K,k)=\operatorname{cd}(x,k)",
        "error",
    ),
    (AT_QUARTER.replace("(K", "(x"), r"\operatorname{sn}(x+K,k)=1", "error"),
]


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("values", "tex", "verdict"), sampled(QUARTERS, 1))
def test_values_that_are_printed_at_a_constant(values, tex, verdict):
    """All of one family there, which obey its relations; nothing is known of other arguments.

    Values at several multiples obey the addition theorem.
    """
    section = Section("1", "")
    moduli = section.display("moduli", "k^2+k'^2=1")
    scene = Scene(variables=("x",), constants=("k", "K")).solving("k'", moduli[1])
    scene = scene.taking(section.display("values", values))
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


PHASES = [
    (r"\frac{d}{dt}\operatorname{sn}(n(t-t_1),k)=n\operatorname{cn}(n(t-t_1),k)\operatorname{dn}(nt-nt_1,k)", "proved"),
    (r"\frac{d}{dt}\operatorname{sn}(n(t-t_1),k)=n\operatorname{cn}(n(t+t_1),k)\operatorname{dn}(n(t-t_1),k)", "refuted"),
    (r"\operatorname{sn}^2(n(t-t_1),k)+\operatorname{cn}^2(n(t_1-t),k)=1", "proved"),
    (r"\operatorname{sn}(n(t-t_1),k)=\operatorname{sn}(n(t_1-t),k)", "refuted"),
    (r"\operatorname{sn}(n(t-t_1),k)=\operatorname{sn}(nt,k)", "refuted"),
    (r"\cos(2nt-2t_1)=1-2\sin^2(nt-t_1)", "proved"),
    (r"\cos(2nt-2t_1)=1-2\sin^2(nt+t_1)", "refuted"),
    (r"\sin(nt-t_1)=\sin nt\cos t_1-\cos nt\sin t_1", "proved"),
    (r"\frac{d}{dt}\sin(\nu t-t_1)=n\cos(nt-t_1)", "proved"),
    (r"\frac{\partial}{\partial n}\sin(nt-t_1)=t\cos(nt-t_1)", "proved"),
    (r"\frac{\partial}{\partial n}\sin(nt-t_1)=n\cos(nt-t_1)", "refuted"),
]  # fmt: skip


SHIFTED = [
    (r"\sin(nt-t_1+\frac{\pi}{2})=\cos(nt-t_1)", "proved"),
    (r"\sin(nt-t_1+\frac{\pi}{2})=\cos(nt+t_1)", "refuted"),
    (r"\sin(nt-t_1+\pi)=\sin(nt-t_1)", "refuted"),
    (r"\sin(nt-t_1+\pi)=\cos nt\sin t_1-\sin nt\cos t_1", "proved"),
    (r"\sin(nt-t_1+\frac{\pi}{2})=\sin(t_1-nt+\frac{\pi}{2})", "proved"),
    (r"\frac{d}{dt}\sin(nt-t_1+\frac{\pi}{4})=n\cos(nt-t_1+\frac{\pi}{4})", "proved"),
    (r"\frac{d}{dt}\sin(nt-t_1+\frac{\pi}{4})=n\cos(nt-t_1-\frac{\pi}{4})", "refuted"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(SHIFTED, 3))
def test_functions_at_a_phase_and_a_part_of_pi(tex, verdict):
    section = Section("1", "")
    scene = Scene(constants=("n", "t_1", r"\pi")).adjoining(r"\sqrt{2}")
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(PHASES, 1))
def test_functions_at_a_phase(tex, verdict):
    """It is taken as a whole if the functions stand nowhere else; by its terms if they do."""
    section = Section("1", "")
    same = section.display("same", r"\nu=2n-n")
    scene = Scene(constants=("n", "t_1", "k")).defining(same)
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


ROTATED = [
    (r"\operatorname{sn}(ix,k)=i\operatorname{sc}(x,k')", "k^2+k'^2=1", "conditional"),
    (r"\operatorname{cn}(ix,k)=\operatorname{nc}(x,k')", "k^2+k'^2=1", "conditional"),
    (r"\operatorname{dn}(ix,k')=\operatorname{dc}(x,k)", "k^2+k'^2=1", "conditional"),
    (r"\operatorname{sn}(x+ix,k)=\operatorname{sn}(x-ix,k)", "k^2+k'^2=1", "undecided"),
    (r"\operatorname{sn}(ix,k)=-i\operatorname{sc}(x,k')", "k^2+k'^2=1", "undecided"),
    (r"\operatorname{sn}(ix,k)=i\operatorname{sc}(x,k')", "k'^2-k^2=1", "error"),
    (r"\operatorname{sn}(ix,k)=i\operatorname{sc}(x,k')", "k'^2=1-k", "error"),
    (r"\operatorname{sn}(ix,k^2)=i\operatorname{sc}(x,k')", "k^2+k'^2=1", "error"),
    (r"\cos(ix)=\cosh x", "k^2+k'^2=1", "proved"),
    (r"\cos(ix)=\sinh x", "k^2+k'^2=1", "refuted"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "moduli", "verdict"), sampled(ROTATED, 1))
def test_an_imaginary_argument_leads_to_the_complementary_modulus(tex, moduli, verdict):
    section = Section("1", "")
    scene = Scene(variables=("x",), constants=("k",)).with_unit(section.display("i", "i^2=-1")[1])
    scene = scene.solving("k'", section.display("moduli", moduli)[1])
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


ROOTS = [
    (r"\frac{d}{dt}\sin(ar)=a\cos(ar)\frac{x}{r}", "conditional"),
    (r"\frac{d}{dt}\sin(r)=\cos(r)\frac{x}{r}", "conditional"),
    (r"\frac{d}{dt}\sin(ar)=0", "refuted"),
    (r"\frac{d}{dt}\sin(r)=0", "refuted"),
    (r"\frac{d}{dt}\sin(qt)=q\cos(qt)", "proved"),
    (r"\frac{\partial}{\partial x}\sin(ar)=0", "refuted"),
    (r"\frac{\partial}{\partial x}\sin(ar)=a\cos(ar)\frac{x}{r}", "conditional"),
    (r"\frac{\partial}{\partial a}\sin(arx)=rx\cos(arx)", "proved"),
    (r"\frac{d}{dt}\operatorname{sn}(a,r)=0", "error"),
    (r"\frac{d}{dt}\operatorname{sn}(a,q)=0", "proved"),
    (r"\frac{d}{dt}\operatorname{sn}(t,p)=\operatorname{cn}(t,p)\operatorname{dn}(t,p)", "error"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(ROOTS, 4))
def test_a_root_of_what_moves_is_no_constant(tex, verdict):
    """Nor is a root of such a root; r and p move, and q does not."""
    section = Section("1", "")
    scene = Scene(variables=("x",), constants=("a",)).moving(section.display("m", r"\dot x=1")[1])
    for name, square in (("r", "1+x^2"), ("p", "r+1"), ("q", "a^2+1")):
        scene = scene.solving(name, section.display(name, f"{name}^2={square}")[1])
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


BY_DERIVATIVES = [
    (r"\frac{d}{dk}K(k)=\frac{E(k)-(1-k^2)K(k)}{k(1-k^2)}", "conditional"),
    (r"\frac{d}{dk}(E(k)-(1-k^2)K(k))=k\mathrm{K}(k)", "conditional"),
    (r"\frac{d}{dk}(k(1-k^2)\frac{d}{dk}K(k))=kK(k)", "conditional"),
    (r"\frac{d}{dk}E(k)=\frac{E(k)+K(k)}{k}", "refuted"),
    (r"\frac{d}{dk}(E(k)-(1-k^2)K(k))=kE(k)", "refuted"),
    (r"K(2k)=2K(k)", "error"),
    (r"\frac{d}{dk}K(k')=\frac{k(k^2K(k')-E(k'))}{k^2k'^2}", "conditional"),
    (r"\frac{d}{dk}K(k')=\frac{k(k^2K(k')+E(k'))}{k^2k'^2}", "refuted"),
    (r"\frac{d}{dk}(E(k)K(k')+E(k')K(k)-K(k)K(k'))=0", "conditional"),
    (r"\frac{d}{dk}(E(k)K(k')+E(k')K(k)+K(k)K(k'))=0", "undecided"),  # of two moduli nothing is
    (r"E(k)K(k')+E(k')K(k)=K(k)K(k')+\frac{\pi}{2}", "undecided"),  # true, and its limit is not known
    (r"E(k)=K(k)", "refuted"),
    (r"\frac{d}{dk}\Pi(n,k)=\frac{k}{n-k^2}(\Pi(n,k)-\frac{E(k)}{k'^2})", "conditional"),
    (r"\frac{d}{dk}\Pi(n,k)=\frac{k}{n-k^2}(\Pi(n,k)+\frac{E(k)}{k'^2})", "refuted"),
    (r"\frac{\partial}{\partial n}\Pi(n,k)=\frac{nE(k)+(k^2-n)K(k)+(n^2-k^2)\Pi(n,k)}{2n(k^2-n)(n-1)}", "conditional"),
    (r"\frac{\partial}{\partial n}\Pi(n,k)=\frac{nE(k)-(k^2-n)K(k)+(n^2-k^2)\Pi(n,k)}{2n(k^2-n)(n-1)}", "refuted"),
    (r"\frac{\partial}{\partial n}\Pi(n,n)=\frac{1}{1-n}(\Pi(n,n)-\frac{E(n)}{1-n^2})+\frac{E(n)+(n-1)K(n)}{2n(n-1)^2}", "conditional"),
    (r"\frac{\partial}{\partial n}\Pi(n,n)=\frac{E(n)+(n-1)K(n)}{2n(n-1)^2}", "undecided"),  # false, and not seen
    (r"\Pi(0,k)=K(k)", "proved"),
    (r"\Pi(0,k)=E(k)", "refuted"),
    (r"\Pi(n,k)=K(k)", "refuted"),
    (r"\Pi(g_2^2,k)=K(k)", "undecided"),
    (r"\Pi(k)=K(k)", "refuted"),  # n is declared
    (r"\Pi(2n,k)=\Pi(n,2k)", "error"),
    (r"\frac{d}{dk}\zeta(k)=-\wp(k)", "conditional"),
    (r"\frac{d}{dk}\sigma(k,g_2,g_3)=\sigma(k)\zeta(k)", "conditional"),
    (r"\frac{d^2}{dk^2}\zeta(k)=\wp'(k)", "refuted"),
    (r"\zeta(2k)=2\zeta(k)", "error"),
]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("tex", "verdict"), sampled(BY_DERIVATIVES, 5))
def test_integrals_are_known_by_their_derivatives(tex, verdict):
    """Those of Legendre by the modulus, those of Weierstrass by the argument."""
    section = Section("1", "")
    scene = Scene(constants=("g_2", "g_3", "n", r"\pi"), time="k")
    scene = scene.solving("k'", section.display("moduli", "k^2+k'^2=1")[1])
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == verdict


@pytest.mark.parametrize("letter", ["K", "E", r"\Pi", r"\zeta", r"\sigma"])
def test_a_letter_that_is_declared_names_no_function(letter):
    section = Section("1", "")
    scene = Scene(variables=("u", "v"), constants=(letter,))
    tex = rf"{letter}(u-v)={letter} u-{letter} v"
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", tex)[1]))
    assert str(outcome.verdict) == "proved"


MODULI = {"k": "k", "k'": "k", "m": "a"}
BEHIND = [rf"\operatorname{{{f}}}({x},{m})" for f in ("sn", "nd", "am") for x in ("x", "2x", "kx", "ax") for m in MODULI if (f, x) != ("am", "2x")]  # fmt: skip


@pytest.mark.parametrize("tex", sampled(BEHIND, 6))
def test_by_a_modulus_no_function_is_derived(tex):
    """Nor by that of which it is made; the generators are no constants then."""
    section = Section("1", "")
    scene = Scene(variables=("x",), constants=("k", "a"))
    scene = scene.solving("k'", section.display("moduli", "k^2+k'^2=1")[1])
    scene = scene.defining(section.display("m", "m=1+a")[1])
    name = MODULI[tex[:-1].rpartition(",")[2]]
    claim = rf"\frac{{\partial}}{{\partial {name}}}({tex}+{name})=1"
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", claim)[1]))
    assert str(outcome.verdict) == "error" and "print the derivative" in outcome.message


@pytest.mark.parametrize("name", ["k", "K"])
def test_nor_where_values_are_printed_by_what_they_hang_together_with(name):
    section = Section("1", "")
    scene = Scene(variables=("x",), constants=("k", "K")).taking(section.display("values", AT_HALF[6:]))  # fmt: skip
    claim = rf"\frac{{\partial}}{{\partial {name}}}\operatorname{{cn}}(2K,k)=0"
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", claim)[1]))
    assert str(outcome.verdict) == "error" and "nothing is derived" in outcome.message


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("part", "value"), sampled([("", "-1"), ("2", "1"), (r"\frac12", "i"), (r"\frac13", r"\frac{1+i\sqrt{3}}{2}"), (r"-\frac32", "i")], 3))  # fmt: skip
def test_the_exponential_of_parts_of_i_times_pi(part, value):
    section = Section("1", "")
    scene = Scene(variables=("x",), constants=(r"\pi",)).with_unit(section.display("i", "i^2=-1")[1])  # fmt: skip
    scene = scene.adjoining(r"\sqrt{3}")
    for sign, verdict in (("", "proved"), ("-", "refuted")):
        tex = rf"e^{{{part} i\pi}}={sign}({value})"
        claim = Identity(f"c{sign}", scene, "", printed=section.display(f"d{sign}", tex)[1])
        section.claims.clear()
        [outcome] = decide(section, claim)
        assert str(outcome.verdict) == verdict


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize("letter", ["K", "E", r"\Pi", r"\zeta", r"\sigma"])
def test_a_letter_that_is_defined_with_its_argument_names_no_function(letter):
    """As Π(θ), the potential energy."""
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=y,\quad\dot y=-x_0\sin x", "x y")
    scene = scene.defining(section.display("p", rf"{letter}(x)=-x_0\cos x")[1])
    claim = FirstIntegral(
        "c", scene, "", printed=section.display("d", rf"\frac12y^2+{letter}(x)")[1]
    )
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "proved"


@pytest.mark.parametrize(
    ("printed", "conditions"),
    [
        (r"\frac{d}{dt}\tanh x=y\operatorname{sech}^2x", [r"\cosh(x)"]),
        (r"\coth x\tanh x=1", [r"\cosh(x)", r"\sinh(x)"]),
        (r"\frac{2+\tanh x}{2+\tanh x}=1", [r"\cosh(x)", r"2 + \tanh(x)"]),
        (r"\tan(-x)=-\tan x", [r"\cos(x)"]),
    ],
)
def test_conditions_are_named_by_functions_as_they_are_printed(printed, conditions):
    section = Section("1", "")
    scene = scene_of(section, r"\dot x=y,\quad\dot y=0", "x y", "")
    claim = Identity("c", scene, "", printed=section.display("d", printed)[1])
    [outcome] = decide(section, claim)
    assert sorted(to_latex(one.expression) for one in outcome.conditions) == sorted(conditions)
