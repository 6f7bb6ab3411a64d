r"""What authors print in passing: chains of equalities, values at the beginning, primes of functions."""

import random

import pytest

from kowalevski_cas import System
from kowalevski_cas.notation import NotationError
from tests.laws.test_prints import FEW, differ, field
from tests.reading.test_reading import verdicts
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

PRIMES = "The equations of motion are $$%s.$$ The function $%s$ is a first integral."


def canonical(chance):
    """Equations of Hamilton as chains, with what they mean, and with one wrong middle or end."""
    a, b, n = chance.randint(2, 5), chance.randint(2, 5), chance.choice([3, 4])
    H = rf"\frac{{{a}}}2p^2+{b}q^{n}"
    q = [r"\dot q", r"\frac{\partial H}{\partial p}", f"{a}p"]
    p = [r"\dot p", r"-\frac{\partial H}{\partial q}", f"-{b * n}q^{n - 1}"]
    at = chance.choice(["", "(q,p)"])
    q[1] += at
    p[1] += at
    wrong = [[*q], [*p]]
    wrong[chance.randrange(2)][2] += "+q"
    printed = [r",\ ".join("=".join(row) for row in rows) for rows in ([q, p], wrong)]
    return f"H{at}={H}", H, *printed


@pytest.mark.slow
@FEW
def test_a_chain_gives_a_rate_and_says_that_its_members_are_equal(seed):
    energy, H, true, wrong = canonical(random.Random(seed))
    system = System(rf"{energy},\ {true}")
    assert system.integral(H).verdict.green
    assert system.integral(H.replace("+", "-")).verdict == "refuted"
    with pytest.raises(ValueError, match="not seen to be equal"):
        System(rf"{energy},\ {wrong}")


@FEW
def test_a_chain_is_a_law_of_a_paper(seed):
    energy, H, true, wrong = canonical(random.Random(seed))
    text = f"Let $${energy}.$$ {PRIMES}"
    assert [v.green for v in verdicts(text % (true, H)).values()] == [True]
    assert not any(v.green or v == "refuted" for v in verdicts(text % (wrong, H)).values())


def test_members_that_only_give_new_names_are_passed_over():
    top = System(r"L=T-V=\frac12(\dot x^2+\dot y^2)-\frac k2(x^2+y^2)")
    assert top.integral(r"x\dot y-y\dot x").verdict.green
    assert top.integral(r"x\dot y+y\dot x").verdict == "refuted"
    with pytest.raises(ValueError, match="not seen to be equal"):
        System(r"L=T-V=\frac12\dot x^2-kx^2,\ V=2kx^2,\ T=\frac12\dot x^2")


def test_equal_constants_are_one():
    system = System(r"m_1\ddot x=-kx,\ m_2\ddot y=-ky,\ m_1=m_2=m")
    assert system.integral(r"x\dot y-y\dot x").verdict.green
    assert "m_1" not in system.scene.constants


@pytest.mark.parametrize("value", sampled(["x(0)=x_0", r"x(t_0)=a,\ \dot x(t_0)=\dot x_0"], 1))
def test_any_values_at_the_beginning_say_nothing(value):
    system = System(rf"\ddot x=-kx,\ {value}")
    assert system.integral(r"\dot x^2+kx^2").verdict.green
    text = PRIMES % (rf"\ddot x=-kx,\quad {value}", r"\dot x^2%skx^2")
    assert [v.green for v in verdicts(text % "+").values()] == [True]
    assert [*verdicts(text % "-").values()] == ["refuted"]


@pytest.mark.parametrize("value", ["x(0)=1", "x(0)=k", r"x(0)=x_0,\ x_0=2k"])
def test_values_that_say_something_are_refused(value):
    with pytest.raises(ValueError, match="a product, or x at this argument"):
        System(rf"\ddot x=-kx,\ {value}")


@FEW
def test_coefficients_have_the_symmetry_that_is_printed(seed):
    chance = random.Random(seed)
    n, sign = chance.choice([2, 3]), chance.choice(["-", ""])
    i, j = chance.choice(["ij", "kl", "ji"])
    values = ",".join(map(str, range(1, n + 1)))
    ranges = chance.choice([f"{i}={values}", f"{i},{j}={values}"])
    rows = rf"\dot x_{i}=\sum_{{{j}=1}}^{n}a_{{{i}{j}}}x_{j}"
    system = System(rf"{rows},\ a_{{{i}{j}}}={sign}a_{{{j}{i}}},\ {ranges}")
    squares = system.integral(r"\sum_i x_i^2").verdict
    assert squares.green if sign else squares == "refuted"
    energy = r"\frac{d}{dt}(x_1^2)=2x_1(a_{11}x_1+a_{12}x_2%s)" % ("+a_{13}x_3" if n > 2 else "")
    assert system.identity(energy).verdict.green
    assert system.identity("a_{21}=-a_{12}").verdict.green is bool(sign)


def test_an_index_that_runs_is_no_name():
    with pytest.raises(NotationError):
        System(r"\dot x_i=\sum_{j=1}^3a_{ij}x_j,\ i=1,2,3,\ a_{j1}=0")


@pytest.mark.slow
def test_an_index_has_the_values_of_that_of_a_sum_on_the_same_names():
    system = System(r"\dot\phi_i=\omega_i+\frac KD\sum_{j=1}^D\sin(\phi_j-\phi_i),\ D=3")
    assert len(system.scene.variables) == 3
    sums = r"\dot\phi_1+\dot\phi_2%s\dot\phi_3=\omega_1+\omega_2+\omega_3"
    assert system.identity(sums % "+").verdict.green
    assert system.identity(sums % "-").verdict == "refuted"


@pytest.mark.parametrize("n", [4, 5])
def test_a_chain_is_closed_as_far_back_as_its_rows_reach(n):
    printed = System(rf"\dot x_i=(x_{{i+1}}-x_{{i-2}})x_{{i-1}},\ x_{{i+{n}}}=x_i")
    meant = {}
    for k in range(n):
        one, two, back = ((k + m) % n + 1 for m in (1, -2, -1))
        meant[f"x_{k + 1}"] = f"(x_{one}-x_{two})*x_{back}"
    assert not differ(printed, {name: _sympy(force) for name, force in meant.items()}, 0)


def _sympy(text):
    from sympy import sympify

    return sympify(text)


def test_brackets_of_a_closed_chain_are_no_map():
    system = System(r"\{u_i,u_{i+1}\}=u_iu_{i+1},\ u_{i+3}=u_i,\ i=1,2,3,\ H=u_1+u_2+u_3")
    assert system.integral("u_1u_2u_3").verdict.green
    assert system.integral("u_1u_2").verdict == "refuted"


@pytest.mark.parametrize(
    ("V", "force"), sampled([("q^4", "4q^3"), (r"\cos q", r"-\sin q"), ("kq^2", "2kq")], 1)
)
def test_a_prime_derives_a_function_by_its_argument(V, force):
    primed, plain = System(rf"\ddot q=-V'(q),\ V(q)={V}"), System(rf"\ddot q=-({force})")
    rates = field(primed), field(plain)
    assert rates[0]["dotq"] == rates[1]["dotq"]
    assert primed.integral(r"\frac12\dot q^2+V(q)").verdict.green
    assert primed.integral(r"\frac12\dot q^2-V(q)").verdict == "refuted"
    assert primed.identity(r"\frac{d}{dt}V'(q)=V''(q)\dot q").verdict.green


def test_a_function_of_functions_has_exponentials_at_other_arguments():
    system = System(r"\dot q=\sigma(q)\sigma(2q),\ \sigma(x)=\frac1{1+e^{-x}}")
    assert system.identity(r"\dot q(1+e^{-q})(1+e^{-2q})=1").verdict.green
    assert system.identity(r"\dot q(1+e^{-q})(1+e^{2q})=1").verdict == "refuted"


def test_what_is_under_dots_with_the_time_is_a_given_function():
    driven = System(r"\ddot\theta=\frac{g+\ddot h(t)}r\sin\theta")
    energy = (
        r"\frac{d}{dt}\left(\frac r2\dot\theta^2%sg\cos\theta\right)=\ddot h(t)\dot\theta\sin\theta"
    )
    assert driven.identity(energy % "+").verdict.green
    assert driven.identity(energy % "-").verdict == "refuted"
    assert {*System(r"\dot x(t)=y(t),\ \dot y(t)=-x(t)").scene.variables} == {"x", "y"}


@pytest.mark.parametrize("J", sampled(["a&b", "0&x_1"], 1))
def test_a_column_may_be_printed_in_italics(J):
    a, b = J.split("&")
    matrix = rf"\begin{{pmatrix}}{a}&{b}\\-{b}&0\end{{pmatrix}}"
    system = System(rf"\dot x={matrix}\nabla H(x),\ H(x)=x_1^4+\log x_2")
    assert system.identity(rf"\dot x_1=4\cdot {a}x_1^3+\frac{{{b}}}{{x_2}}").verdict.green
    assert system.identity(rf"\dot x_2=4\cdot {b}x_1^3").verdict == "refuted"


@pytest.mark.slow
def test_an_upright_i_is_the_imaginary_unit():
    system = System(r"\ddot\xi+2\mathrm i\Omega\dot\xi+\omega^2\xi=0")
    assert system.integral(r"|\dot\xi|^2+\omega^2|\xi|^2").verdict.green
    assert system.integral(r"|\dot\xi|^2-\omega^2|\xi|^2").verdict == "refuted"
    assert system.integral(r"\dot\xi^2+\omega^2\xi^2").verdict == "refuted"


def test_a_momentum_without_an_equation_is_no_constant():
    for law in (r"\dot q=p", r"\dot q=\frac{\partial H}{\partial p}"):
        with pytest.raises(ValueError, match="p stands in the Hamiltonian, and nothing moves it"):
            System(rf"H=\frac12p^2+q^4,\ {law}")


@pytest.mark.slow
def test_an_inequality_may_stand_beside_equations():
    assert System(r"\ddot x=-\sqrt{k^2}x,\ k\ge0").integral(r"\dot x^2+kx^2").verdict.green
    assert System(r"\ddot x=-\sqrt{k^2}x,\ k<0").integral(r"\dot x^2+kx^2").verdict == "refuted"
    assert not System(r"\ddot x=-kx,\ k>1,\ k<0").integral(r"\dot x^2+kx^2").verdict.green


@pytest.mark.parametrize("name", ["sign", "sgn", "sin", "tg", "sh"])
def test_a_function_may_be_in_the_type_of_words(name):
    words, upright = (System(rf"\ddot x=-\{one}{{{name}}}(x)") for one in ("textrm", "mathrm"))
    assert field(words) == field(upright)
    with pytest.raises(NotationError, match="the words “sign”"):
        System(r"\ddot x=-\text{sign} x")


def test_a_number_of_centres_may_stand_beside_their_sum():
    force = r"\ddot {0}=-\sum_{{i=1}}^N\frac{{\gamma_i({0}-{0}_i)}}{{D_i^3}}"
    rows = (
        rf"{force.format('x')},\ {force.format('y')},\ D_i=\sqrt{{(x-x_i)^2+(y-y_i)^2+d^2}},\ N=2"
    )
    scene = System(rows).scene
    assert {"x_1", "x_2", "y_1", "y_2", r"\gamma_1", r"\gamma_2", "d"} == {*scene.constants}
    assert {"D_1", "D_2"} <= {*scene.definitions}
