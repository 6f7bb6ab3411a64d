"""Equations of motion of one's own: the scenes and claims that they build, and what is said of them."""

import os
import re
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from signal import SIGINT

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas import System
from kowalevski_cas.cli import main
from kowalevski_cas.notation import (
    NotationError,
    Number,
    Quotient,
    print_prose,
    read_prose,
    to_latex,
    to_plain,
)
from kowalevski_cas.paper.claims import DarbouxPolynomial, Degree, Reality
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session
from tests.laws.systems import SYSTEMS
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

ROOT = Path(__file__).parents[1]

LORENZ = r"""\begin{align}
  \dot x &= \sigma(y-x)\\ \dot y &= \rho x-y-xz\\ \dot z &= xy-bz
\end{align}"""

FILE = (
    "from kowalevski_cas import System\n"
    f'lorenz = System(r"""{LORENZ}""")\n'
    r"""
F = lorenz.define(r"F = x^2-2\sigma z")
special = lorenz.where(r"b=2\sigma")
special.darboux(F, cofactor=r"-2\sigma")
special.invariant("F=0")
lorenz.invariant("F=0", expect="refuted")
"""
)


@pytest.fixture
def lorenz():
    return System(LORENZ)


@pytest.fixture
def cli(capsys, tmp_path):
    """Run a command on a file with this content; the exit code, and all that is printed."""

    def cli(command, content, *arguments, name="lorenz.py"):
        file = tmp_path / name
        file.write_text(content, encoding="utf-8")
        code = main([command, str(file), *arguments])
        out, err = capsys.readouterr()
        assert "Traceback" not in out + err
        return code, out + err

    return cli


def test_what_has_a_derivative_moves_and_the_rest_is_constant(lorenz):
    assert lorenz.scene.variables == ("x", "y", "z")
    assert lorenz.scene.constants == (r"\sigma", r"\rho", "b")
    assert repr(lorenz) == "x, y, z move; σ, ρ, b are constant"


@pytest.mark.parametrize("textbook", SYSTEMS, ids=lambda system: system.name)
def test_a_system_is_the_scene_that_a_derivation_writes_out(textbook):
    found = System(r",\quad ".join(textbook.motion)).scene
    (scene,) = {
        claim.scene for claim in textbook.derivation().claims if not claim.scene.definitions
    }
    roots = set(scene.roots)
    assert set(found.variables) == set(scene.variables)
    assert set(found.constants) == set(scene.constants) | roots


def test_a_function_that_is_an_integral_on_special_parameters_only(lorenz):
    F = lorenz.define(r"F = x^2-2\sigma z")
    special = lorenz.where(r"b=2\sigma")
    assert special.darboux(F, cofactor=r"-2\sigma").verdict is Verdict.PROVED
    assert special.invariant(F).verdict is Verdict.PROVED
    assert lorenz.invariant(F).verdict is Verdict.REFUTED
    assert lorenz.darboux(F, cofactor=r"-2\sigma").counterexample is not None


@pytest.mark.parametrize(
    ("special", "said"),
    [([r"b=2\sigma"], "for b = 2σ, "), ([r"\rho=1", r"\sigma\ne0"], "for ρ = 1, σ ≠ 0, ")],
)
def test_what_is_claimed_for_special_constants_says_for_which(lorenz, special, said):
    F = lorenz.define(r"F=x^2-2\sigma z")
    for system, words in ((lorenz, ""), (lorenz.where(*special), said)):
        claims = [
            (system.darboux(F, cofactor="-2b"), "it is a Darboux polynomial with the cofactor −2b"),
            (system.invariant("F=0"), "no motion leaves the set where F = 0"),
            (system.integral("F"), "this is constant along every motion"),
            (system.implication("x=0", given="y=0"), "this holds wherever y = 0"),
            (system.find_integrals(1)[-1], "each polynomial first integral"),
        ]
        for stated, rest in claims:
            assert repr(stated).startswith(f"{stated.verdict}: {words}{rest}")


def test_a_constant_is_no_integral_and_the_reason_is_told():
    rotation = System(r"\dot x=y, \dot y=-x")
    set_only = "on this set the function is constant by the equations of the set alone"
    itself = "the function is constant by itself"
    for stated, words in (
        (rotation.integral("x^2+y^2", given=("x=0", "y=0")), set_only),
        (rotation.integral("x-x"), itself),
        (rotation.integral(r"\ln(x^2)-2\ln x"), itself),
    ):
        assert stated.verdict is Verdict.REFUTED
        assert stated.outcome.message == words


def test_only_what_is_claimed_later_is_said_to_be_shown(cli, tmp_path):
    content = r"""
from kowalevski_cas import System
lorenz = System(r"\dot x=\sigma(y-x), \dot y=\rho x-y-xz, \dot z=xy-bz")
lorenz.invariant("x=0", "y=0")
lorenz.where(r"b=1").darboux("x^2+y^2+z^2-2\rho z", cofactor="-2")
"""
    cli("report", content, "--output", str(tmp_path))
    page = (tmp_path / "lorenz.html").read_text(encoding="utf-8")
    assert "Consider:" in page and "To be shown" not in page
    assert "Supposed:" not in page and "The cofactor:" not in page  # the words of the claim say it


@pytest.mark.parametrize(
    "cofactor", [r"2\sigma", r"-\sigma", r"-2\rho", r"-2b", r"-2\sigma x", "0"]
)
def test_another_cofactor_is_refuted(lorenz, cofactor):
    special = lorenz.where(r"b=2\sigma")
    assert special.darboux(r"x^2-2\sigma z", cofactor).verdict is Verdict.REFUTED


def test_a_constant_is_no_darboux_polynomial(lorenz):
    assert lorenz.darboux(r"\sigma", "0").verdict is Verdict.REFUTED


def test_a_quotient_is_no_cofactor(lorenz):
    outcome = lorenz.darboux("x", r"\frac{\sigma(y-x)}{x}").outcome
    assert outcome.verdict is Verdict.ERROR
    assert "is no polynomial in the variables" in outcome.message


@pytest.mark.parametrize(
    ("field", "F", "message"),
    [
        (
            r"\dot x=y, \dot y=-e^x",
            "e^x",
            "degrees, volumes and numbers of solutions are not known",
        ),
        (r"\dot x=y, \dot y=x", "x=y", "a function is expected"),
    ],
)
def test_what_is_no_polynomial_is_no_darboux_polynomial(field, F, message):
    outcome = System(field).darboux(F, "y").outcome
    assert outcome.verdict is Verdict.ERROR and message in outcome.message


def test_what_a_statement_needs_is_named():
    top = System(r"A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq")
    energy = top.integral("Ap^2+Bq^2+Cr^2")
    assert energy.verdict is Verdict.CONDITIONAL
    assert repr(energy) == (
        "conditional: where A ≠ 0, B ≠ 0, C ≠ 0; this is constant along every motion; Ap² + Bq² + Cr²"
    )
    solid = top.where(r"A\ne0", r"B\ne0", r"C\ne0")
    assert solid.integral("Ap^2+Bq^2+Cr^2").verdict is Verdict.PROVED


def test_a_constant_can_be_a_root():
    kepler = System(r"\dot x=u, \dot y=v, \dot u=-\frac{x}{r^3}, \dot v=-\frac{y}{r^3}")
    plane = kepler.where("r^2=x^2+y^2", r"r\ne0")
    assert plane.integral(r"\frac{1}{2}(u^2+v^2)-\frac{1}{r}").verdict is Verdict.PROVED
    assert plane.identity(r"\dot r=\frac{xu+yv}{r}").verdict is Verdict.PROVED
    assert plane.implication("xu+yv=0", given=["r^2=1", r"\dot r=0"]).verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("field", "moves", "integral"),
    sampled([
        (r"m\ddot x=-kx", "x moves; m, k are constant", r"m\dot x^2+kx^2"),
        (r"x'=y,\ y'=-0.5x", "x, y move", "x^2+2y^2"),
        (r"\dot x(t)=y(t),\ \dot y(t)=-x(t)", "x, y move", "x^2+y^2"),
        (r"\frac{dx}{dt}=cy,\ \frac{dy}{dt}=-cx", "x, y move; c is constant", "x^2+y^2"),
        (
            r"\dot q=\frac{\partial H}{\partial p},\ \dot p=-\frac{\partial H}{\partial q},\ H=p^2+gq^4",
            "q, p move; g is constant",
            "H",
        ),
        (r"\ddot x=-\frac{\partial U}{\partial x},\ U=cx^4", "x moves; c is constant", r"\dot x^2+2U"),
        (
            r"H(q,p)=\frac12p^2+q^4,\ \dot q=\frac{\partial H}{\partial p},\ \dot p=-\frac{\partial H}{\partial q}",
            "q, p move",
            "H",
        ),
        (
            r"T=\frac m2\dot q^2, V=kq^4, L=T-V, \frac{d}{dt}\frac{\partial L}{\partial\dot q}=\frac{\partial L}{\partial q}",
            "q moves; m, k are constant",
            "T+V",
        ),
        (r"\ddot\theta=-g\sin\theta", "θ moves; g is constant", r"\frac12\dot\theta^2-g\cos\theta"),
        (r"\dot x=p,\ \dot p=-e^x", "x, p move", r"\frac12p^2+e^x"),
        (r"\dot x=y,\ \dot y=-e^2x", "x, y move; e is constant", "y^2+e^2x^2"),
        (r"\dot x=v,\ \dot y=0", "x, y move; v is constant", "y"),
        (
            r"\dot{q}_1=p_1,\ \dot{q}_2=p_2,\ \dot{p}_1=-e^{q_1-q_2},\ \dot{p}_2=e^{q_1-q_2}",
            "q₁, q₂, p₁, p₂ move",
            r"\frac12(p_1^2+p_2^2)+e^{q_1-q_2}",
        ),
        (r"\ddot\theta=-k\sin\theta", "θ moves; k is constant", r"\dot\theta^2-2k\cos\theta"),
        (r"\dot x=y\sqrt{c^2+1},\ \dot y=-x\sqrt{c^2+1}", "x, y move; c is constant", "x^2+y^2"),
        (r"\dot x_1=x_2,\ \dot x_2=x_2-\sum_{i=1}^2x_i", "x₁, x₂ move", "x_1^2+x_2^2"),
        (
            r"\dot q_i=\frac{\partial H}{\partial p_i},\ \dot p_i=-\frac{\partial H}{\partial q_i},\ i=1,2,\ H=\frac12(p_1^2+p_2^2)+q_1^2q_2^2",
            "q₁, q₂, p₁, p₂ move",
            "H",
        ),
        (
            r"\dot q_i=\{q_i,H\},\ \dot p_i=\{p_i,H\},\ i=1,2,\quad H=\frac12(p_1^2+p_2^2)+q_1^2q_2^2,\quad \{q_i,p_j\}=\delta_{ij},\ i,j=1,2",
            "q₁, q₂, p₁, p₂ move",
            "H",
        ),
        (r"\frac{dx}{d\tau}=y,\ \frac{dy}{d\tau}=-x", "x, y move", "x^2+y^2"),
        (r"{\dot x}_1=x_2,\ {\dot x}_2=-x_1", "x₁, x₂ move", "x_1^2+x_2^2"),
        (r"\begin{cases} 2\dot x = y, & \dot z=0,\\ 2\dot y = -x \end{cases}", "x, z, y move", "x^2+y^2"),
        (
            r"\dot x=\frac{\partial\mathcal H}{\partial y},\ \dot y=-\frac{\partial\mathcal H}{\partial x},\ \mathcal{H}=x\hat{k}y",
            "x, y move; k̂ is constant",
            r"\mathcal H",
        ),
        (
            r"\begin{pmatrix}2&1\\1&1\end{pmatrix}\begin{pmatrix}\ddot x\\\ddot y\end{pmatrix}=-\begin{pmatrix}x\\y\end{pmatrix}",
            "x, y move",
            r"\dot x^2+\dot x\dot y+\frac12\dot y^2+\frac12(x^2+y^2)",
        ),
        (r"\frac{d}{dt}\begin{pmatrix}x\\y\end{pmatrix}=\begin{pmatrix}y\\-x\end{pmatrix}", "x, y move", "x^2+y^2"),
        (
            r"\ddot x=-\frac{\mu x}{(x^2+y^2)^{3/2}},\ \ddot y=-\frac{\mu y}{(x^2+y^2)^{3/2}}",
            "x, y move; μ is constant",
            r"\frac12(\dot x^2+\dot y^2)-\frac{\mu}{\sqrt{x^2+y^2}}",
        ),
        (
            r"\ddot x=-\frac{x}{r^3},\ \ddot y=-\frac{y}{r^3},\ r^2=x^2+y^2",
            "x, y move",
            r"\frac12(\dot x^2+\dot y^2)-\frac{1}{r}",
        ),
        (
            r"\ddot x_i=2g^2\sum_{j\ne i}\frac{1}{(x_i-x_j)^3},\quad i=1,2,3",
            "x₁, x₂, x₃ move; g is constant",
            r"\frac12\sum_{k=1}^3\dot x_k^2+\sum_{1\le i<j\le3}\frac{g^2}{(x_i-x_j)^2}",
        ),
        (
            r"\dot x_i=-x_i\sum_{j=1}^2a_{ij}x_j,\quad i=1,2,\quad a_{11}=a_{22}=0",
            "x₁, x₂ move; a₁₂, a₂₁ are constant",
            "a_{21}x_1-a_{12}x_2=c",
        ),
        (r"\dot x_i=x_i(x_{i+1}-x_{i-1}),\quad i=1,2,3,\quad x_{i+3}=x_i", "x₁, x₂, x₃ move", "x_1x_2x_3=c"),
        (r"2\ddot\alpha=e^{2\beta}, 2\ddot\beta=e^{2\beta}", "α, β move", r"\dot\beta^2-\frac12e^{2\beta}"),
        (r"\frac{\text{d}x}{\text{d}t}=y, \frac{\text{d}y}{\text{d}t}=-x", "x, y move", "x^2+y^2"),
    ], 5),
)  # fmt: skip
def test_equations_as_textbooks_print_them(field, moves, integral):
    system = System(field)
    assert repr(system) == moves
    assert system.integral(integral).verdict in (Verdict.PROVED, Verdict.CONDITIONAL)


def test_a_name_with_a_square_is_no_printed_root():
    """It may be either root, and the printed one is not negative."""
    plane = System(r"\dot x=ru, \dot u=cx").where("r^2=x^2+c^2")
    for equation in (r"\sqrt{x^2+c^2}=r", r"r\sqrt{x^2+c^2}=r^2", r"\sqrt{c^2+x^2}-r=0"):
        outcome = plane.identity(equation).outcome
        assert outcome.verdict is Verdict.ERROR
        assert "r may be" in outcome.message and "or its opposite: print r" in outcome.message
    assert plane.identity("r^2-c^2=x^2").verdict is Verdict.PROVED


numbers = st.integers(1, 60)


@settings(max_examples=settings.default.max_examples // 2)
@given(numbers, numbers, st.integers(-4, 4), numbers, st.booleans())
def test_roots_of_numbers_depend_on_each_other_as_they_do(m, n, a, b, true):
    product = sympy.sqrt(m) * sympy.sqrt(n)
    if true:  # as the program of a school would write it
        a, root = product.as_coeff_Mul()
        b = root**2
    system = System(r"\dot x=1")
    F = system.define(rf"F=\sqrt{{{m}}}\sqrt{{\frac{{{n}}}{{4}}}}-\frac{{{a}}}{{2}}\sqrt{{{b}}}")
    equal = product == a * sympy.sqrt(b)
    wanted = Verdict.PROVED if equal else Verdict.REFUTED
    assert system.identity(f"{F.name}=0").verdict is wanted


R, P = r"\mathbf{r}", r"\mathbf{p}"
SPACE = {R: ("x", "y", "z"), P: ("u", "v", "w")}


@pytest.mark.parametrize(
    ("field", "integral"),
    sampled([
        (r"\ddot{\mathbf r}=-\frac{\mu\mathbf r}{|\mathbf r|^3}", r"\frac12\dot{\mathbf r}^2-\frac{\mu}{|\mathbf r|}"),
        (
            r"\ddot{\mathbf r}=-\frac{\mu}{r^3}\mathbf r,\quad r=|\mathbf r|",
            r"\dot{\mathbf r}\times(\mathbf r\times\dot{\mathbf r})-\frac{\mu}{r}\mathbf r",
        ),
        (r"m\ddot{\mathbf r}=-\nabla U,\quad U=\frac k2\mathbf r^2", r"\frac m2\dot{\mathbf r}^2+U"),
        (r"m\ddot{\mathbf r}=\dot{\mathbf r}\times\mathbf p-\nabla U(\mathbf r),\ U(\mathbf r)=\mathbf r^2", r"\frac m2\dot{\mathbf r}^2+U"),
        (
            r"\dot{\mathbf r}=\frac{\partial H}{\partial\mathbf p},\ \dot{\mathbf p}=-\frac{\partial H}{\partial\mathbf r},\ H(\mathbf r,\mathbf p)=\frac12\mathbf p^2+(\mathbf r^2)^2",
            "H",
        ),
        (
            r"\frac{d}{dt}\frac{\partial L}{\partial\dot{\mathbf r}}=\frac{\partial L}{\partial\mathbf r},\ L(\mathbf r,\dot{\mathbf r})=\frac m2\dot{\mathbf r}^2-\frac k4(\mathbf r^2)^2",
            r"\mathbf r\times\frac{\partial L}{\partial\dot{\mathbf r}}",
        ),
        (r"\dot{\mathbf r}=\mathbf r\times\mathbf p,\ \dot{\mathbf p}=0", r"\langle\mathbf r,\mathbf p\rangle"),
        (
            r"\mathbf I\dot{\mathbf r}=\mathbf I\mathbf r\times\mathbf r,\ \mathbf I=\operatorname{diag}(a,b,c)",
            r"(\mathbf I\mathbf r)^2",
        ),
        (
            r"\mathbf A\ddot{\mathbf r}=-\mathbf r,\ \mathbf A=\begin{pmatrix}2&1&0\\1&1&0\\0&0&1\end{pmatrix}",
            r"\dot{\mathbf r}\cdot\mathbf A\dot{\mathbf r}+\mathbf r^2",
        ),
    ], 4),
)  # fmt: skip
def test_equations_of_vectors_as_textbooks_print_them(field, integral):
    system = System(field, vectors=SPACE)
    assert system.integral(integral).verdict in (Verdict.PROVED, Verdict.CONDITIONAL)


def test_linear_equations_are_solved_for_the_rates():
    system = System(r"a\dot x+b\dot y=x,\quad c\dot x+d\dot y=y")
    assert repr(system) == "x, y move; a, b, c, d are constant"
    solved = system.identity(r"(ad-bc)\dot x=d\cdot x-by")
    assert [to_latex(one) for one in solved.conditions] == ["ad - bc"]


def test_a_sum_is_differentiated_term_by_term():
    system = System(r"\frac{d}{dt}(x+y)=x,\quad \frac{d}{dt}(x-y)=y")
    assert repr(system) == "x, y move"
    assert system.integral("x^2-2xy-y^2").verdict is Verdict.PROVED
    assert system.integral("x^2+y^2").verdict is Verdict.REFUTED


@given(st.text(alphabet=" ,&%$\t\n").map(str) | st.sampled_from([r"\quad", "{}", "\\\\"]))
def test_what_prints_nothing_is_refused(blank):
    with pytest.raises(ValueError):
        System(blank)
    system = System(r"\dot x=y, \dot y=-x")
    for ask in (system.define, system.where, system.find_closure, system.conditions):
        with pytest.raises(ValueError):
            ask(blank)
    for claim in (system.integral, system.identity, system.invariant):
        with suppress(ValueError):
            assert claim(blank).verdict is Verdict.ERROR


def test_a_condition_is_printed_without_a_minus_before_most_terms():
    two = System(
        r"\ddot{\mathbf r}=\frac{\mathbf p-\mathbf r}{|\mathbf p-\mathbf r|^3},\quad \ddot{\mathbf p}=-\ddot{\mathbf r}",
        vectors={R: ("x", "y"), P: ("u", "v")},
    )
    claim = two.integral(r"\dot{\mathbf r}+\dot{\mathbf p}")
    assert repr(claim).startswith("conditional: where x² − 2xu + y² − 2yv + u² + v² ≠ 0; ")


def test_matrices_depend_on_a_parameter():
    circle = System(r"\dot q=p,\ \dot p=-\omega^2q")
    L = circle.define(
        r"L(\lambda)=\begin{pmatrix}p&\omega q+\lambda\\\omega q-\lambda&-p\end{pmatrix}"
    )
    M = circle.define(r"M=\frac{1}{2}\begin{pmatrix}0&\omega\\-\omega&0\end{pmatrix}")
    assert circle.lax(L, M).verdict is Verdict.PROVED
    assert circle.lax(M, L).verdict is Verdict.REFUTED
    curve = circle.define(r"P(\mu)=\det(L(\lambda)-\mu)")
    for constant in (curve, r"P(1)", r"\det L(2)", r"\operatorname{tr}L(\lambda)^2"):
        assert circle.integral(constant).verdict is Verdict.PROVED
    assert circle.integral(r"\det(L(\lambda)-\omega q)").verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("field", "moves", "identity"),
    [
        (r"\ddot x=6x^2+t", "x, t move", r"\frac{d}{dt}\left(\frac12\dot x^2-2x^3\right)=t\dot x"),
        (r"x''=6x^2+t", "x, t move", r"(x'^2-4x^3)'=2tx'"),
        (r"\frac{dx}{ds}=sx", "x, s move", r"\frac{d}{ds}x^2=2sx^2"),
        (
            r"\dot q=\frac{\partial H}{\partial p}, \dot p=-\frac{\partial H}{\partial q}, H(q,p,t)=\frac12p^2-2q^3-tq",
            "q, p, t move",
            r"\frac{dH}{dt}=\frac{\partial H}{\partial t}",
        ),
        (r"\dot t=1, \dot x=tx", "t, x move", r"\dot x=tx"),
    ],
)
def test_the_time_moves_where_it_stands_in_the_equations(field, moves, identity):
    system = System(field)
    assert repr(system) == moves
    assert system.identity(identity).verdict is Verdict.PROVED
    assert system.integral("x" if "x" in moves else "H").verdict is Verdict.REFUTED


def test_several_functions_are_defined_at_once():
    free = System(r"\ddot q_i=0,\ i=1,2,3")
    assert free.define(r"p_i=2\dot q_i,\ i=1,2").name == "p_1"
    assert free.integral("p_2").verdict is free.integral("p_1p_2").verdict is Verdict.PROVED
    with pytest.raises(NotationError, match="p_3 is not declared here"):
        free.read("p_3")


def test_the_modulus_of_what_is_complex_is_real():
    top = System(
        r"2\dot p=qr,\ 2\dot q=-pr-c\gamma_3,\ \dot r=c\gamma_2,\ i^2=-1,"
        r"\dot\gamma_1=r\gamma_2-q\gamma_3,\ \dot\gamma_2=p\gamma_3-r\gamma_1,\ \dot\gamma_3=q\gamma_1-p\gamma_2"
    )
    assert top.scene.constants == ("c",)
    w = top.define(r"w=p+iq")
    for true in (r"|w|^2=p^2+q^2", r"w\bar w=|w|^2", r"|w^2|^2=(p^2+q^2)^2", r"|ip|^2=p^2"):
        assert top.identity(true).verdict is Verdict.PROVED
    for false in (r"|w|^2=w^2", r"\bar w=w", r"|ip|^2=-p^2"):
        assert top.identity(false).verdict is Verdict.REFUTED
    assert top.integral(r"|w^2+c(\gamma_1+i\gamma_2)|^2").verdict is Verdict.PROVED
    assert "i = i" not in repr(top.integral(w))
    with pytest.raises(ValueError, match="is a conjugate, and all is real"):
        System(r"\dot z=\bar z")


@pytest.mark.parametrize("unit", sampled(["", ", i^2=-1"], 1))
def test_what_moves_by_the_imaginary_unit_is_complex(unit):
    """Three waves: their amplitudes have conjugates, and :math:`a^2-b^2` is constant for real i."""
    waves = System(rf"i\dot a=\bar bc, i\dot b=\bar ac, i\dot c=ab{unit}")
    for true in (r"|a|^2-|b|^2", r"a\bar a+c\bar c", r"\operatorname{Re}(ab\bar c)"):
        assert waves.integral(true).verdict is Verdict.PROVED
    for false in ("a", "a^2-b^2", r"\operatorname{Im}(ab\bar c)"):
        assert waves.integral(false).verdict is Verdict.REFUTED
    assert waves.integral("a^2-b^2").outcome.correction is None  # that i^2=1 would be one
    with pytest.raises(ValueError, match="a root stands in the equations of motion"):
        waves.find_integrals(2)


@pytest.mark.parametrize("number", sampled([2, 3, 5, 6, 7], 2))
def test_roots_of_numbers_are_refuted_too(number):
    """Modulo half of all primes there is no root of the number, and no point to try."""
    root, twice = rf"\sqrt{number}", rf"\sqrt{{{4 * number}}}"
    system = System(rf"\dot x={root}y,\ \dot y={twice}x")
    assert system.identity(f"{twice}=-2{root}").verdict is Verdict.REFUTED
    assert system.integral("x^2-y^2").verdict is Verdict.REFUTED


def test_components_of_what_moves_move():
    M = r"\mathbf{M}"
    body = System(
        rf"\dot{M}={M}\times\frac{{\partial H}}{{\partial{M}}},\quad H=aM_1^2+bM_2^2+cM_3^2",
        vectors={M: ("M_1", "M_2", "M_3")},
    )
    assert body.scene.constants == ("a", "b", "c")
    assert body.integral("H").verdict is Verdict.PROVED


def test_vectors_are_given_by_components():
    omega, gamma = r"\boldsymbol{\omega}", r"\boldsymbol{\gamma}"
    body = System(
        rf"\dot{omega}={omega}\times{gamma},\quad \dot{gamma}={gamma}\times{omega}",
        vectors={omega: ("p", "q", "r"), gamma: (r"\gamma_1", r"\gamma_2", r"\gamma_3")},
    )
    assert body.scene.variables == ("p", "q", "r", r"\gamma_1", r"\gamma_2", r"\gamma_3")
    assert body.integral(rf"{gamma}\cdot{gamma}").verdict is Verdict.PROVED


BODY = r"\dot{\mathbf M}=\mathbf M\times\boldsymbol\omega,\ "


@pytest.mark.parametrize(
    ("field", "moves", "integral"),
    [
        (BODY + r"\boldsymbol\omega=(aM_1,bM_2,cM_3)", "M₁, M₂, M₃ move", r"\omega_1M_1+\omega_2M_2+\omega_3M_3=2h"),
        (BODY + r"\omega_1=aM_1, \omega_2=bM_2, \omega_3=cM_3", "M₁, M₂, M₃ move", r"\boldsymbol\omega\cdot\mathbf M"),
        (BODY + r"\mathbf M=(u,v,w), \boldsymbol\omega=(u,v,2w)", "u, v, w move", r"u^2+v^2"),
        (r"\ddot{\mathbf r}=-\frac{k\mathbf r}{|\mathbf r|^3},\ \mathbf r=(x,y)", "x, y move", r"x\dot y-y\dot x=\ell"),
        (r"\dot{\mathbf x}={\bf Ax},\ {\bf A}=\begin{pmatrix}0&1\\-1&0\end{pmatrix},\ \mathbf x=(x,y)", "x, y move", r"\mathbf x^2=r^2"),
        (r"\ddot{\vec r}=-\vec r, H=r_1^2+r_2^2", "r₁, r₂ move", r"\dot{\vec r}^2+H=2E"),
        (r"\ddot{\bf r}=0, k=({\bf r}\times\dot{\bf r})\cdot{\bf a}", "r₁, r₂, r₃ move", r"{\bf L}={\bf r}\times\dot{\bf r}"),
    ],
)  # fmt: skip
def test_vectors_have_the_components_that_are_printed(field, moves, integral):
    system = System(field)
    assert repr(system).partition(";")[0] == moves
    assert system.integral(integral).verdict in (Verdict.PROVED, Verdict.CONDITIONAL)


@pytest.mark.parametrize("claim", ["identity", "integral", "invariant"])
@pytest.mark.parametrize(
    "formula",
    sampled([
        r"\mathbf r={}", r"{}=\mathbf r", r"\mathbf r+{}=0", r"(\mathbf r,{})=0", r"\mathbf r\times{}=0",
        r"|\mathbf r+2{}|=x", r"3{}-y\mathbf r=0",
    ], 3),
)  # fmt: skip
@pytest.mark.parametrize("other", sampled(["(1,x)", r"\mathbf s", "(1,x,y,z)"], 1))
def test_vectors_of_different_sizes_mean_nothing_together(claim, formula, other):
    system = System(r"\dot{\mathbf r}=0,\ \dot{\mathbf s}=0,\ \mathbf r=(x,y,z),\ \mathbf s=(u,v)")
    outcome = getattr(system, claim)(formula.format(other)).outcome
    assert outcome.verdict is Verdict.ERROR and "components" in outcome.message


@pytest.mark.slow
def test_a_zero_stands_for_a_vector():
    oscillator = System(r"\ddot{\mathbf r}=-\mathbf r,\ \mathbf r=(x,y,z)")
    assert oscillator.invariant(r"\mathbf r\times\dot{\mathbf r}=0").verdict is Verdict.PROVED
    assert oscillator.invariant(r"\mathbf r=0").verdict is Verdict.REFUTED
    assert oscillator.implication("z=0", given=[r"\mathbf r=0"]).verdict is Verdict.PROVED
    assert oscillator.identity(r"\mathbf r\times\dot{\mathbf r}=0").verdict is Verdict.REFUTED


@given(
    st.permutations([r"2\alpha", r"3\beta", r"5\gamma"]), st.lists(st.booleans(), min_size=4, max_size=4),
    st.sampled_from([0, 7]), st.sampled_from(["{}={}", "2({})=2({})"]),
)  # fmt: skip
def test_a_linear_relation_of_constants_is_solved(terms, left, number, sign):
    """Whatever side its terms stand on."""
    sides = [
        "".join(
            f"{'+' if on else '-'}{term}"
            for term, own in zip(terms, left, strict=False)
            if own is on
        )
        for on in (True, False)
    ]
    relation = sign.format(sides[0] or 0, f"{sides[1]}{'+' if left[3] else '-'}{number}")
    system = System(r"\dot x=(2\alpha+3\beta+5\gamma)x").where(relation)
    assert len(system.scene.constants) == 2
    growth = system.identity(rf"\dot x={7 if left[3] else -7}x")
    assert growth.verdict is (Verdict.PROVED if number else Verdict.REFUTED)


def test_what_is_supposed_to_differ_is_not_divided_by_in_vain():
    top = System(r"\dot x=\frac{y}{a-b}, \dot y=-x, a\ne b")
    assert top.integral("x^2(a-b)+y^2").verdict is Verdict.PROVED
    assert top.where(r"a\ne2").integral(r"\frac{x^2(a-b)+y^2}{2-a}").verdict is Verdict.PROVED


LEVELS = ("h", "2h", "h^2", "1", "0", r"\frac{h-k}{2}", r"\rho", r"\mathrm{const}")


@pytest.mark.parametrize("level", LEVELS)
def test_the_value_of_an_integral_is_a_name_or_a_number(level):
    circle = System(r"\dot x=\rho y, \dot y=-\rho x")
    assert circle.integral(f"x^2+y^2={level}").verdict is Verdict.PROVED
    assert circle.integral(f"2T=x^2-y^2={level}").verdict is Verdict.REFUTED


@pytest.mark.parametrize("side", ["x", "hx", r"\dot x", "x^2+y^2+h", "2x^2+2y^2"])
def test_what_moves_is_no_value_of_an_integral(side):
    circle = System(r"\dot x=\rho y, \dot y=-\rho x")
    verdict = circle.integral(f"x^2+y^2={side}").verdict
    assert verdict in (Verdict.REFUTED, Verdict.ERROR)


@pytest.mark.parametrize(
    ("field", "message"),
    [
        (r"\dot x=y, x=2", "x=2: x moves by an equation of its own: leave this one out"),
        (
            r"\dot x=y, x+y=2z",
            r"x\+y=2z is no equation of motion, and defines no name: .* what is supposed is",
        ),
        (r"E=p^2+q^2", "has no equation of motion: print one with a derivative, or H=…"),
        (r"H=x^2+y^2", "it is not known which coordinates and momenta belong together"),
        (
            r"\dot q_i=p_i, \dot p_i=-q_1",
            "q_i stands beside names with numbers: print i=1,2,3 behind",
        ),
        (r"\dot x=\varepsilon_{123}x", "is a name here: write a vector product, or the terms"),
        (r"\dot x=y', \dot y=x", "y' stands beside dots, and a prime is a derivative too"),
        (
            r"\dot a_n=a_n(b_{n+1}-b_n), \dot b_n=a_n",
            r"b_\{n\+1\} has an index that runs: print n=1",
        ),
        (r"\frac{dx}{ds}=y, \frac{dy}{dt}=x", "derivatives by s and by t: print one independent"),
        (r"\dot x=y, \dot y=-x, \dot x=-y", r"3 equations for 2 unknowns \(x, y\): leave one out"),
        (
            r"\frac{d}{dt}\frac{\partial L}{\partial\dot q}=\frac{\partial L}{\partial q}",
            "L is differentiated, and nothing defines it: add L=…",
        ),
        (r"\dot u=\partial u/\partial x, \dot x=1", "u is differentiated, and nothing defines it"),
        (r"\dot x=k(s)x", r"a product, or k at this argument\?"),
        (r"\ddot q=-V_q, V=q^4", r"V_q is a name here: print .partial V/.partial q, or rename it"),
        (r"\dot x=x-\bar x", "x} is a conjugate, and all is real: rename it"),
        (r"\dot q=p, \dot p=-\frac{dp}{dq}", "derivatives by t and by q: print one independent"),
        (
            r"\dot q=p, \dot p=-V'(2q), V(q)=q^4",
            r"by what is V derived\? print .partial V/.partial x",
        ),
        (r"\dot x=1, \dot x=2", r"2 equations for 1 unknown \(x\)"),
        (r"\dot x=F, F=x=1", "F=x=1 gives F twice: leave one side out"),
        (r"\dot{\mathbf{x}}=y", r"give its components: print \\mathbf\{x\}=\(x,y,z\) beside it"),
    ],
)
def test_what_is_no_system_is_refused(field, message):
    with pytest.raises(ValueError, match=message):
        System(field)


def test_one_hypothesis_needs_no_brackets():
    circle = System(r"\dot x=y, \dot y=-x, \dot z=xz")
    assert circle.implication("x^2z=0", given="z=0").verdict is Verdict.PROVED
    assert circle.integral("x^2+y^2+zy", given="z=0").verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("field", "false", "said"),
    [
        (r"\dot q=p, \dot p=-e^{2q}", r"p^2+2e^{2q}", "the derivative of p² + 2 exp(2q) along"),
        (r"\dot\theta=p, \dot p=-\sin\theta", r"p^2-\sin^2\theta", "of p² − sin(θ)² along the"),
        (r"\dot x=e^x+y, \dot y=x", r"\dot x=ye^x", ""),
    ],
)
def test_a_counterexample_is_told_in_the_functions_that_are_printed(field, false, said):
    system = System(field)
    claim = system.identity(false) if r"\dot" in false else system.integral(false)
    against = claim.outcome.counterexample
    words = print_prose(read_prose(against.words, vocabulary((system.scene,))), str, to_plain)
    assert said in words and "$" not in words
    values = {to_plain(name): value for name, value in against.point.values.items()}
    assert not any("/2)" in name for name in values)
    assert all(isinstance(v, Number | Quotient) for name, v in values.items() if "exp" in name)


E3 = r"""\dot{\mathbf M}=\{\mathbf M,H\},\ H=\frac12(M_1^2+2M_2^2+3M_3^2),\
\{M_i,M_j\}=\varepsilon_{ijk}M_k"""


def test_brackets_with_indices_stand_beside_the_equations_of_motion():
    top = System(E3)
    assert top.scene.variables == ("M_1", "M_2", "M_3") and not top.scene.constants
    assert top.integrable("H", casimirs=r"\mathbf M^2").verdict is Verdict.PROVED


def test_a_definition_is_not_mended_into_that_of_another_name():
    top = System(E3)
    top.define("K=M_1^2+M_2^2+M_3^2")
    claim = top.involution("H", top.define("K_2=M_1^2+M_2^2+5M_2M_3"))
    assert claim.verdict is Verdict.REFUTED and claim.outcome.correction is None
    assert claim.outcome.counterexample.words.startswith("a bracket is $")


def test_a_cofactor_may_be_a_number(lorenz):
    assert lorenz.where("b=1", r"\rho=0").darboux("y^2+z^2", -2).verdict is Verdict.PROVED
    with pytest.raises(TypeError, match="cofactor is to be a statement"):
        lorenz.states(DarbouxPolynomial, "darboux", "", printed="x", cofactor=2)


def test_attributes_are_names_or_formulas_as_the_kind_declares_them():
    circle = System(r"\dot x=y,\quad \dot y=-x")
    claim = circle.states(Degree, "degree", "", variable="x", degree=1)
    assert claim.verdict is Verdict.PROVED
    claim = circle.states(Reality, "reality", "", real=("x", "xy"), imaginary=())
    assert claim.verdict is Verdict.PROVED
    with pytest.raises(TypeError, match="variable is to be a string, not 3"):
        circle.states(Degree, "degree", "", variable=3, degree=1)


@pytest.mark.parametrize(
    "claim", [System.invariant, System.involution, System.integrable], ids=lambda f: f.__name__
)
def test_a_claim_of_nothing_is_an_error(lorenz, claim):
    assert claim(lorenz).verdict is Verdict.ERROR


@pytest.mark.parametrize("degree", [-1, 2.5, "2"])
def test_a_degree_is_a_natural_number(lorenz, degree):
    with pytest.raises(ValueError, match="a natural number is expected"):
        lorenz.find_integrals(degree)


def test_a_name_that_nothing_gives_a_value_is_an_error(lorenz):
    outcome = lorenz.integral("x^2+w^2").outcome
    assert outcome.verdict is Verdict.ERROR and "w is not declared here" in outcome.message
    assert lorenz.where(r"b=\kappa").scene.constants == (r"\sigma", r"\rho", r"\kappa")
    with pytest.raises(NotationError, match="w is not declared here"):
        lorenz.define("F=x+w")
    with pytest.raises(ValueError, match=r"x=1 gives no constant: solve it for one of"):
        lorenz.where("x=1")
    with pytest.raises(
        ValueError, match=r"k=2 gives no constant.*declare a further one by `having`"
    ):
        lorenz.where("k=2")
    with pytest.raises(ValueError, match=r"2 = 3 gives no constant"):
        lorenz.where("b=2=3")
    with pytest.raises(ValueError, match=r"F=x=y gives F twice: leave one side out"):
        lorenz.define("F=x=y")
    with pytest.raises(ValueError, match=r"“x, y”: one formula is expected"):
        lorenz.integral("x, y")
    with pytest.raises(ValueError, match=r"expect “wrong”: a verdict is one of proved, "):
        lorenz.integral("x", expect="wrong")


MATRIX = r"{\bf A}=\begin{pmatrix}x&y\\y&z\end{pmatrix}"


def test_a_function_of_another_system_is_none_of_this_one(lorenz):
    special = lorenz.where("b=1")
    F, G, A = lorenz.define("F=x"), special.define("F=y"), lorenz.define(MATRIX)
    assert lorenz.identity("F=x").verdict is special.identity("F=y").verdict is Verdict.PROVED
    for wrong in (
        lambda: lorenz.integral(G), lambda: special.integral(F), lambda: special.invariant(F),
        lambda: special.implication("x=0", given=[F]), lambda: special.lax(A, A),
        lambda: special.involution("x", F), lambda: special.define(F), lambda: special.where(F),
    ):  # fmt: skip
        with pytest.raises(ValueError, match="is defined elsewhere: define it on this system"):
            wrong()


# -- SymPy --------------------------------------------------------------------------


def test_expressions_of_sympy_are_as_good_as_latex():
    from sympy import Eq, symbols

    x, y, z, s, rate = symbols("x1 y z sigma rate")
    lorenz = System({x: s * (y - x), y: rate * x - y - x * z, z: x * y - 2 * s * z})
    assert lorenz.scene.variables == ("x_1", "y", "z")
    assert lorenz.scene.constants == (r"\sigma", r"\mathrm{rate}")
    claim = lorenz.darboux(x**2 - 2 * s * z, cofactor=-2 * s)
    assert claim.verdict is Verdict.PROVED
    assert claim.sympy() == [x**2 - 2 * s * z, -2 * s]
    F = lorenz.define(r"F=\frac{x_1^2}{2\sigma}-z")
    assert F.sympy().rhs == x**2 / (2 * s) - z
    assert (
        lorenz.identity(Eq((x + y) ** 2 / 2, x**2 / 2 + x * y + y**2 / 2)).verdict is Verdict.PROVED
    )
    with pytest.raises(TypeError, match=r"is no sum, product, whole power or square root"):
        lorenz.integral(x**y)
    with pytest.raises(TypeError, match=r"None is no formula, in LaTeX or of SymPy"):
        lorenz.integral(None)
    with pytest.raises(TypeError, match=r"\['x=0'\] is no formula, in LaTeX or of SymPy"):
        lorenz.invariant(["x=0"])
    with pytest.raises(TypeError, match=r"by the variables of SymPy, and not 3"):
        System(3)


NAMES = ("x", "x1", "x_1", "alpha", r"\alpha", "y", "foo", "2", "x y", "x+y", "}", "", "d", "bar x")
ASSUMED = ({}, {"real": True}, {"positive": True}, {"integer": True}, {"commutative": False})


@given(
    *[st.tuples(st.sampled_from(NAMES), st.sampled_from(ASSUMED), st.booleans()) for _ in "ab"],
    st.sampled_from((sympy.Add, sympy.Mul)),
)
def test_symbols_that_differ_are_never_the_same(one, other, joined):
    """They are refused, or nothing false is proved of them."""
    a, b = (
        (sympy.Dummy if dummy else sympy.Symbol)(name, **assumed)
        for name, assumed, dummy in (one, other)
    )
    for left, right in ((a, b), (a * b, b * a), (joined(a, 1), joined(b, 1))):
        if left != right:
            with suppress(ValueError):
                system = System({a: b, b: a} if a != b else {a: a})
                equation = sympy.Eq(left, right, evaluate=False)
                assert not system.identity(equation).verdict.green


@pytest.mark.parametrize(
    "field", [{"x": r"y, \dot z=1", "y": "-x"}, {"x": "1", r"y}=1, \dot{z": "2"}, {"x": "y=1"}]
)
def test_a_variable_has_one_right_side(field):
    with suppress(ValueError):
        assert System(field).identity(r"\dot x=\dot x").verdict is Verdict.ERROR


@pytest.mark.parametrize("relation", [sympy.Ne(*sympy.symbols("x y")), sympy.true])
def test_what_is_no_equation_of_sympy_is_refused(relation):
    with pytest.raises(TypeError, match=r"is no equation: write Eq\(…, evaluate=False\)"):
        System({sympy.Symbol("x"): 1}).identity(relation)


def test_a_notebook_shows_what_is_said(lorenz):
    F = lorenz.define(r"F=x^2-2\sigma z")
    assert F._repr_latex_() == r"$F = x^2 - 2\sigma z$"
    assert r"\dot{x} = \sigma(y - x)" in lorenz._repr_latex_()
    assert lorenz.integral(F)._repr_html_().startswith("<p><b>refuted</b>: this is constant")
    assert re.search(r"; not at x = \S+, y = ", repr(lorenz.integral(F)))
    special = lorenz.where(r"b=2\sigma")
    assert repr(special) == "x, y, z move; σ, ρ are constant; b = 2σ"
    assert special._repr_html_().count("<math>") == 3 + 5 + 1


# -- files --------------------------------------------------------------------------


def test_a_file_is_verified_recorded_and_certified(cli, tmp_path):
    code, out = cli("verify", FILE)
    assert code == 0
    assert "x, y, z move; σ, ρ, b are constant" in out
    assert "3 claims: 2 proved, 1 refuted" in out and "as expected" in out
    assert cli("record", FILE)[0] == 0
    assert (tmp_path / "lorenz.evidence" / "record.json").is_file()
    code, out = cli("check", FILE)
    assert code == 0 and "CERTIFIED 3 of 3" in out
    code, out = cli("verify", FILE)
    assert code == 0 and "as recorded" in out


def test_what_is_otherwise_than_expected_is_a_difference(cli):
    code, out = cli("verify", FILE.replace(', expect="refuted"', ""))
    assert code == 1
    assert "DIFFERENT FROM WHAT IS EXPECTED" in out
    assert "invariant-F.2: expected that it is true, found refuted" in out
    code, out = cli("verify", FILE.replace('"F=0")', '"F=0", expect="refuted")'))
    assert code == 1 and "invariant-F: expected refuted, found proved" in out


@pytest.mark.parametrize("expected", ["", "refuted", "proved"])
@pytest.mark.parametrize("function", sampled(["F=0", "G=0"], 1))
def test_a_record_hides_no_contradiction_to_what_is_expected(cli, function, expected):
    """F vanishes on an invariant set, and G does not."""
    verdict = "proved" if function == "F=0" else "refuted"
    file = f"""
from kowalevski_cas import System
circle = System(r"\\dot x=y, \\dot y=-x")
circle.define("F=x^2+y^2-1"), circle.define("G=x-y")
circle.invariant("{function}", expect="{expected}")
"""
    assert cli("record", file)[0] == 0
    code, out = cli("verify", file)
    contradicted = expected not in ("", verdict)
    assert code == contradicted
    said = f"recorded against the file, which expects {expected}, found {verdict}"
    assert (said in out) == contradicted and ("as recorded" in out) != contradicted


@pytest.mark.parametrize("form", sampled(["pretty", "github", "junit"], 1))
def test_what_is_false_is_no_misprint_and_what_is_expected_not_recorded(cli, form):
    content = FILE.replace(', expect="refuted"', "")
    code, out = cli("verify", content, "--format", form)
    assert code == 1 and "expected" in out and "recorded" not in out and "misprint" not in out
    assert cli("record", FILE)[0] == 0
    code, out = cli("verify", content.replace('"F=0"', '"F=x"'), "--format", form)
    assert code == 1 and "recorded" in out and "expected" not in out and "misprint" not in out


def test_a_claim_that_cannot_be_read_hides_no_other(cli):
    code, out = cli("verify", FILE + 'lorenz.integral("w")\n')
    assert code == 2 and "2 proved" in out
    assert f"lorenz.py:{FILE.count(chr(10)) + 1}: integral-w: w is not declared here" in out


def test_a_command_has_its_own_limit_of_time(cli, monkeypatch):
    """What a file says is for the verdicts that are asked for in it."""
    monkeypatch.undo()
    code, out = cli("verify", FILE.replace("F = ", "lorenz.seconds = 1e-6\nF = ", 1))
    assert code == 0 and "timeout" not in out


def test_systems_of_a_file_are_told_apart_by_their_names(cli):
    two = """
from kowalevski_cas import System
first = System(r"\\dot x=y, \\dot y=-x"{})
second = System(r"\\dot x=y, \\dot y=x"{})
first.integral("x^2+y^2")
second.integral("x^2+y^2", expect="refuted")
"""
    code, out = cli("verify", two.format("", ""))
    assert (
        code == 2 and "two sections or systems are called 1: give one another name, System(" in out
    )
    code, out = cli("verify", two.format(', "circle"', ', "saddle"'), "-v")
    assert code == 0 and "circle-integral-x-2-y-2" in out and "saddle. x, y move" in out


def test_a_claim_is_decided_whatever_its_system_is_called(cli):
    """What is false does not vanish with the name of its system."""
    file = """
from kowalevski_cas import System
for name, sign in (("first", "-"), ("second", "+")):
    system = System(r"\\dot x=y, \\dot y=-x", name)
    system.integral(f"x^2{sign}y^2")
system = System(r"\\dot x=y, \\dot y=-x", "third")
del system
"""
    code, out = cli("verify", file)
    assert code == 1 and "first-integral-x-2-y-2: expected that it is true, found refuted" in out


def test_a_derivation_and_a_system_have_one_vocabulary(lorenz):
    lorenz.invariant("x=0", "y=0")
    run = Session(Derivation("lorenz", "", "", "", (lorenz.section,)), ["flint"]).run()
    assert [outcome.verdict for outcome in run.outcomes] == [Verdict.PROVED]


@pytest.mark.slow
def test_what_is_proved_of_any_system_has_a_certificate(cli):
    """Names of roots, matrices, velocities of vectors and moduli stand in certificates too."""
    lines = ["from kowalevski_cas import System"]
    for number, (field, integral) in enumerate(
        [
            (
                r"\ddot{\mathbf r}=-\frac{\mu}{r^3}\mathbf r,\ r=|\mathbf r|",
                r"\mathbf r\times\dot{\mathbf r}",
            ),
            (r"\dot x=\sqrt{\frac km}y,\ \dot y=-\sqrt{\frac km}x", r"\sqrt{x^2+y^2}"),
            (
                r"\begin{pmatrix}2&1\\1&1\end{pmatrix}\begin{pmatrix}\dot q_1\\\dot q_2\end{pmatrix}=\begin{pmatrix}0\\q_1\end{pmatrix}",
                "2q_1+q_2",
            ),
            (r"\dot p_{r_0}=0,\ \mathcal{H}=p_{r_0}^2", r"\mathcal{H}"),
            (r"\dot x=xy,\ \dot y=-y,\ i^2=-1", r"y+\ln x"),
        ]
    ):
        given = "{r'\\mathbf{r}': ('x', 'y', 'z')}"
        lines += [
            f"s{number} = System(r'{field}', 's{number}', {given})",
            f"s{number}.integral(r'{integral}')",
        ]
    file = "\n".join(lines)
    assert cli("record", file)[0] == 0
    code, out = cli("check", file)
    assert code == 0 and "CERTIFIED 5 of 5" in out


def test_a_display_is_taken_from_its_source(cli, tmp_path):
    (tmp_path / "paper.tex").write_text(
        r"\newcommand{\half}{\tfrac12}\begin{document}"
        r"\begin{equation}\label{eq:13} \dot x=y,\ \dot y=-x \end{equation}"
        r"\begin{equation}\label{eq:14} E=\half(x^2+y^2) \end{equation}"
        r"\begin{equation}\label{eq:16} \dot x=1 \end{equation}\end{document}"
    )
    file = """
from kowalevski_cas import System, display
circle = System(display("paper.tex", label="eq:13"))
E = circle.define(display("paper.tex", label="{}"))
circle.integral(E)
"""
    code, out = cli("verify", file.format("eq:14"))
    assert code == 0, out
    unit = 'circle.implication(display("paper.tex", label="eq:16"), ["y=1"])'
    code, out = cli("verify", file.format("eq:14") + unit)
    assert code == 0, out
    of_file = ["--derivation", str(tmp_path / "lorenz.py")]
    assert main(["audit", str(tmp_path / "paper.tex"), *of_file]) == 0  # y=1 need not be printed
    code, out = cli("verify", file.format("eq:15"))
    assert code == 2 and "lorenz.py:4: " in out and "no displays with the label eq:15" in out


@pytest.mark.parametrize(
    "term", [r"\frac{x-x}{y}", r"\frac{1-1}{y}", r"\frac{y^2}{y}-y", r"(\frac{1}{y})^0-1"]
)
def test_what_a_vanishing_term_divides_by_is_a_condition(term):
    free = System(r"\dot x=y, \dot y=0")
    for claim in (free.integral(f"y+{term}"), free.identity(f"y+{term}=y")):
        assert claim.verdict is Verdict.CONDITIONAL
        assert [to_latex(one) for one in claim.conditions] == ["y"]


# -- questions ----------------------------------------------------------------------


def test_integrals_are_found_and_claimed():
    top = System(r"\dot x=yz,\quad \dot y=-2zx,\quad \dot z=xy")
    *found, none_else = top.find_integrals(degree=2)
    assert len(found) == 2
    assert {one.verdict for one in (*found, none_else)} == {Verdict.PROVED}
    assert [one.claim for one in (*found, none_else)] == top.section.claims


def test_darboux_polynomials_are_found_and_claimed(lorenz):
    assert {one.verdict for one in lorenz.where("b=1").find_darboux(degree=1)} <= {Verdict.PROVED}
    found = lorenz.where(r"b=2\sigma").find_darboux(degree=2)
    assert [repr(one.formulas[0]) for one in found] and found[0].verdict is Verdict.PROVED


def test_each_answer_has_its_time(capsys, monkeypatch):
    monkeypatch.undo()
    chain = System(r"\dot x=yz+x^2,\ \dot y=zx-y^2,\ \dot z=xy,\ \dot u=x-u^3,\ \dot v=u")
    chain.seconds = 0.01
    found = chain.find_integrals(degree=12)
    assert "it took more than 0.01 s" in capsys.readouterr().err
    assert [one.claim for one in found] == chain.section.claims
    chain.seconds = 1e-3
    assert chain.integral("(x+2y+3z+5u+7v)^{12}").verdict is Verdict.TIMEOUT


def test_that_there_is_no_darboux_polynomial_with_a_cofactor(lorenz):
    (none,) = lorenz.find_darboux(degree=3, cofactor=r"-2\sigma")
    assert none.verdict is Verdict.PROVED and "is zero" in none.claim.words
    special = lorenz.where(r"b=2\sigma")
    found, complete = special.find_darboux(degree=3, cofactor=r"-2\sigma")
    assert found.verdict is complete.verdict is Verdict.PROVED
    assert "a combination of these" in complete.claim.words
    with pytest.raises(ValueError, match="find integrals"):
        lorenz.find_darboux(degree=2, cofactor="0")


def test_degrees_and_orders_are_not_negative(lorenz):
    with pytest.raises(ValueError, match="degree=-1"):
        lorenz.find_integrals(-1)
    with pytest.raises(ValueError, match="order=-2"):
        lorenz.find_closure("x", order=-2)


def test_that_there_is_no_integral_is_an_answer(lorenz):
    (none,) = lorenz.find_integrals(degree=2)
    assert none.verdict is Verdict.PROVED and none.formulas == ()


def test_an_invariant_set_is_found_from_a_function():
    special = System(LORENZ).where(r"b=2\sigma")
    assert {one.verdict for one in special.find_closure(r"x^2-2\sigma z", order=2)} == {
        Verdict.PROVED
    }


def test_the_constants_for_which_a_polynomial_divides_its_derivative(lorenz):
    F = lorenz.define(r"F=x^2-2\sigma z")
    found = lorenz.conditions(F)
    assert {one.verdict for one in found} == {Verdict.PROVED}
    assert any("proved: F' = KF with K = −2σ where b = 2σ; " in repr(one) for one in found)


def test_balances_and_their_exponents_are_claims(lorenz):
    top = System(r"A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq")
    for system, exponents in ((lorenz, "−1, 2, 4"), (top, "−1, 2, 2")):
        weights, balance, *_ = system.find_exponents()
        assert {weights.verdict, balance.verdict} <= {Verdict.PROVED, Verdict.CONDITIONAL}
        assert f"exponents {exponents}" in repr(balance)


def test_a_file_that_claims_nothing_can_be_asked(cli):
    file = FILE.partition("F = ")[0] + 'special = lorenz.where("b=1")\n'
    code, out = cli("verify", file)
    assert code == 6 and "makes no claims" in out


def test_a_question_is_asked_of_a_file(tmp_path, capsys):
    file = tmp_path / "lorenz.py"
    file.write_text(FILE)
    scene = r"the system where b=2\sigma"
    assert main(["find", "integrals", str(file), "--scene", scene, "--degree", "1"]) == 0
    assert "proved" in capsys.readouterr().out


# -- each save ----------------------------------------------------------------------


@pytest.mark.slow
def test_each_save_is_verified_until_an_interruption(tmp_path):
    (tmp_path / "lorenz.py").write_text(
        "from kowalevski_cas import System, display\n"
        r'circle = System(r"\dot x=y, \dot y=-x")' + "\n"
        'circle.integral(display("paper.tex", "eq:1"))\n'
    )
    paper = tmp_path / "paper.tex"
    text = r"\begin{equation}\label{eq:1} x^2SIGNy^2 \end{equation}"
    paper.write_text(text.replace("SIGN", "-"))
    watching = subprocess.Popen(
        [sys.executable, "-m", "kowalevski_cas", "verify", "--watch", "lorenz.py"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert "waiting for a file to be saved" in watching.stderr.readline()
    paper.write_text(text.replace("SIGN", "+"))
    assert "waiting for a file to be saved" in watching.stderr.readline()
    watching.send_signal(SIGINT)
    out, err = watching.communicate()
    assert (watching.returncode, err) == (0, "")
    assert re.findall(r"1 claim: 1 (\w+)", out) == ["refuted", "proved"]


FACTORS = st.sampled_from(["1-kx^2", "k-3xy", "x+y", "ky-x^2+2", "xy-k"])


@given(st.lists(FACTORS, min_size=1, max_size=2, unique=True))
def test_a_condition_is_named_as_its_denominator_is_printed(factors):
    system = System(r"\dot x=y, \dot y=-kx")
    below = "".join(f"({factor})" for factor in factors)
    outcome = system.identity(rf"\frac{{{below}}}{{{below}}}=1").outcome
    named = {to_latex(one.expression).replace(" ", "") for one in outcome.conditions}
    assert outcome.verdict is Verdict.CONDITIONAL and named == {*factors}
