r"""Brackets of any functions, lists of components, pairs, and matrices of which a rule gives entries.

What is meant is computed by SymPy.
"""

import random
from itertools import product

import pytest
from sympy import LeviCivita, Matrix, Symbol, diff

from kowalevski_cas import System
from tests.laws.test_prints import FEW, differ, vector

pytestmark = pytest.mark.usefixtures("uncorrected")


def so3(chance, sign):
    """Brackets of three components M, as they may be printed."""
    word = chance.choice([r"\mathbf M", r"\boldsymbol M", r"\boldsymbol{M}"])
    mark = {1: "", -1: "-"}
    by_functions = rf"{mark[sign]}{word}\cdot(\nabla F\times\nabla G)"
    return chance.choice(
        [
            rf"\{{M_i,M_j\}}={mark[sign]}\varepsilon_{{ijk}}M_k",
            rf"\{{F,G\}}={by_functions}",
            rf"\{{F,G\}}({word})={by_functions},\ {word}=(M_1,M_2,M_3)",
        ]
    )


@FEW
def test_a_law_for_any_function_is_one_for_each_coordinate(seed):
    chance = random.Random(seed)
    sign, turned = chance.choice([1, -1]), chance.choice([1, -1])
    M = vector("M")
    a, b, c = chance.sample(range(1, 9), 3)
    H, tex = a * M[0] ** 2 + b * M[1] ** 2 + c * M[2], f"H={a}M_1^2+{b}M_2^2+{c}M_3"
    f = chance.choice("fFgK")
    law = rf"\dot {f}=\{{{f},H\}}" if turned == 1 else rf"\dot{{{f}}}=\{{H,{f}\}}"
    meant = {
        f"M_{i + 1}": turned
        * sign
        * sum(LeviCivita(i, j, k) * M[k] * diff(H, M[j]) for j, k in product(range(3), repeat=2))
        for i in range(3)
    }
    system = System(rf"{so3(chance, sign)},\ {tex},\ {law}")
    assert not differ(system, meant, seed)
    assert system.casimir("M_1^2+M_2^2+M_3^2").verdict == "proved"
    assert system.casimir("M_1^2+M_2^2-M_3^2").verdict == "refuted"


@pytest.mark.parametrize("bracket", [r"\{p,q\}=1", r"\{q,p\}=1", r"\{q,p\}=-1", r"\{p,q\}=-1"])
def test_a_velocity_is_the_derivative_by_its_momentum_whichever_bracket_is_one(bracket):
    oscillator = System(rf"H=\frac12(p^2+q^2),\quad {bracket}")
    assert oscillator.identity(r"\dot q=p").verdict == "proved"
    assert oscillator.identity(r"\dot p=-q").verdict == "proved"
    assert oscillator.identity(r"\dot q=-p").verdict == "refuted"


@FEW
def test_components_may_be_listed_in_the_chain_that_gives_a_vector(seed):
    chance = random.Random(seed)
    factors = [Symbol(one) for one in "abc"]
    M = vector("M")
    rates = [one * m for one, m in zip(factors, M, strict=True)]
    meant = {f"M_{k + 1}": Matrix(M).cross(Matrix(rates))[k] for k in range(3)}
    names = chance.choice(["p,q,r", r"\omega_1,\omega_2,\omega_3"])
    tex = rf"\dot{{\mathbf M}}=\mathbf M\times\boldsymbol\omega,\ \boldsymbol\omega=({names})=(aM_1,bM_2,cM_3)"
    assert not differ(System(tex), meant, seed)
    assert differ(System(tex.replace("bM_2", "2bM_2")), meant, seed)


@pytest.mark.slow
def test_what_is_defined_for_the_pairs_of_a_sum_is_defined_for_each():
    tex = (
        r"\Gamma_k\dot x_k=\frac{\partial H}{\partial y_k},\ \Gamma_k\dot y_k=-\frac{\partial H}"
        r"{\partial x_k},\ k=1,\dots,3,\ H=\sum_{1\le j<k\le3}\Gamma_j\Gamma_k\ln r_{jk},\ "
        r"r_{jk}^2=(x_j-x_k)^2+(y_j-y_k)^2"
    )
    vortices = System(tex)
    assert vortices.integral(r"\sum_{k=1}^3\Gamma_kx_k").verdict.green
    assert vortices.integral(r"\sum_{k=1}^3x_k").verdict == "refuted"
    rate = r"\Gamma_1\frac{x_1-x_2}{r_{12}^2}+\Gamma_3\frac{x_3-x_2}{r_{23}^2}"
    assert vortices.identity(rf"\dot y_2={rate}").verdict.green
    assert vortices.identity(rf"\dot y_2=-({rate})").verdict == "refuted"


@FEW
def test_a_rule_gives_the_entries_of_skew_matrices(seed):
    chance = random.Random(seed)
    size, letter = chance.choice([3, 4]), chance.choice(["a", r"\lambda", "J"])
    rule, more = chance.choice(
        [
            (
                rf"M_{{ij}}=({letter}_i+{letter}_j)\Omega_{{ij}}",
                rf"M_{{ji}}=-M_{{ij}},\ i,j=1,\ldots,{size}",
            ),
            (
                r"M=D\Omega+\Omega D",
                rf"D=\operatorname{{diag}}({','.join(f'{letter}_{k + 1}' for k in range(size))}),\ "
                rf"\Omega=(\Omega_{{ij}})\in\mathfrak{{so}}({size})",
            ),
        ]
    )
    turned = chance.choice([r"[M,\Omega]", r"[\Omega,M]"])
    body = System(rf"\dot M={turned},\ {rule},\ {more}")
    assert {*body.scene.variables} == {
        f"M_{{{a}{b}}}" for a in range(1, size + 1) for b in range(a + 1, size + 1)
    }

    def entry(name, a, b):
        low, high = sorted((a, b))
        return f"{'+' if a < b else '-'}{name}_{{{low}{high}}}" if a != b else ""

    a, b = 1, 2
    others = range(3, size + 1)
    terms = [
        f"({entry('M', a, k)})({entry(r'Omega', k, b)})-({entry('Omega', a, k)})({entry('M', k, b)})"
        for k in others
    ]
    right = "+".join(f"({one})" for one in terms).replace("Omega", r"\Omega")
    sign, other = ("", "-") if turned == r"[M,\Omega]" else ("-", "")
    assert body.identity(rf"\dot M_{{12}}={sign}({right})").verdict.green
    assert body.identity(rf"\dot M_{{12}}={other}({right})").verdict == "refuted"
    assert body.integral(r"\operatorname{tr}(M\Omega)").verdict.green
    assert body.integral(r"\operatorname{tr}\Omega^2").verdict == "refuted"


def test_an_index_may_be_said_twice_to_have_the_same_values():
    chain = r"\dot a_k=a_k(a_{k+1}-a_{k-1}),\ k\in\mathbb Z/4\mathbb Z,\ k=1,\ldots,"
    assert System(f"{chain}4").integral(r"\prod_{k=1}^4a_k").verdict == "proved"
    with pytest.raises(ValueError, match="a second range of k"):
        System(f"{chain}3")


def test_the_distance_of_two_points_is_one_root_whichever_is_named_first():
    bodies = System(
        r"\ddot{\mathbf r}_1=\frac{\mathbf r_2-\mathbf r_1}{|\mathbf r_2-\mathbf r_1|^3},\ "
        r"\ddot{\mathbf r}_2=\frac{\mathbf r_1-\mathbf r_2}{|\mathbf r_1-\mathbf r_2|^3},\ "
        r"\mathbf r_1=(x_1,y_1),\ \mathbf r_2=(x_2,y_2)"
    )
    assert len(bodies.scene.roots) == 1
    assert bodies.identity(r"|\mathbf r_1-\mathbf r_2|=|\mathbf r_2-\mathbf r_1|").verdict.green
    energy = r"\frac12(\dot{\mathbf r}_1^2+\dot{\mathbf r}_2^2)"
    assert bodies.integral(rf"{energy}-\frac1{{|\mathbf r_1-\mathbf r_2|}}").verdict.green
    assert bodies.integral(rf"{energy}+\frac1{{|\mathbf r_1-\mathbf r_2|}}").verdict == "refuted"


@pytest.mark.slow
@pytest.mark.parametrize(("sign", "other"), [("+", "-"), ("-", "+")])
def test_the_relation_of_hess_is_invariant(sign, other):
    top = System(
        r"A\dot p=(B-C)qr-z_0g,\ B\dot q=(C-A)rp+z_0f-x_0h,\ C\dot r=(A-B)pq+x_0g,\ "
        r"\dot f=rg-qh,\ \dot g=ph-rf,\ \dot h=qf-pg"
    ).where(rf"x_0\sqrt{{A(B-C)}}{sign}z_0\sqrt{{C(A-B)}}=0")
    assert top.invariant("Ax_0p+Cz_0r=0").verdict.green
    assert top.invariant("Ax_0p-Cz_0r=0").verdict == "refuted"


SPHERE = [r"\mathbf r^2=\ell^2", r"(\mathbf r,\mathbf r)=\ell^2", r"x^2+y^2+z^2=\ell^2"]


@pytest.mark.parametrize("sphere", SPHERE)
def test_a_pendulum_on_a_sphere_moves_by_the_components_that_are_named(sphere):
    pendulum = System(
        rf"\ddot{{\mathbf r}}=-g\mathbf e+\lambda\mathbf r,\ {sphere},\ \mathbf r=(x,y,z),\ \mathbf e=(0,0,1)"
    )
    assert pendulum.integral(r"\frac12\dot{\mathbf r}^2+gz").verdict.green
    assert pendulum.integral(r"x\dot y-y\dot x").verdict.green
    assert pendulum.integral(r"\frac12\dot{\mathbf r}^2-gz").verdict == "refuted"


@pytest.mark.parametrize(
    ("tex", "verdict"), [(r"\gamma", "green"), (r"\gamma^2", "green"), (r"\omega^2", "refuted")]
)
def test_the_letter_of_a_vector_is_its_length_in_claims(tex, verdict):
    top = System(
        r"\dot{\mathbf M}=\mathbf M\times\boldsymbol\omega+\boldsymbol\gamma\times\mathbf r,\ "
        r"\dot{\boldsymbol\gamma}=\boldsymbol\gamma\times\boldsymbol\omega,\ \mathbf M=(Ap,Bq,Cr),\ "
        r"\boldsymbol\omega=(p,q,r),\ \mathbf r=(x_0,y_0,z_0)"
    )
    claim = top.integral(tex)
    assert claim.verdict.green if verdict == "green" else claim.verdict == verdict


@pytest.mark.parametrize("curve", [r"\det(L-\mu)", r"\det(\mu-L)", r"\det(L-\lambda\mathbb I)"])
def test_a_spectral_curve_needs_no_name(curve):
    chain = (
        r"\dot L=[B,L],\ L=\begin{pmatrix}b_1&a\\a&b_2\end{pmatrix},\ "
        r"B=\begin{pmatrix}0&a\\-a&0\end{pmatrix}"
    )
    assert System(chain).integral(curve).verdict == "proved"
    assert System(chain).integral(curve.replace("L", "B")).verdict == "refuted"
