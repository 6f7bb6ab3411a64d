"""Poisson brackets of the textbooks: Jacobi, Casimir, involution, integrability; mutants fail."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

PROVED, REFUTED = Verdict.PROVED, Verdict.REFUTED

MOMENTA = r"\{x,y\}=z,\quad \{y,z\}=x,\quad \{z,x\}=y"
VOLTERRA = r"\{x,y\}=xy,\quad \{y,z\}=yz,\quad \{z,x\}=zx"
CANONICAL = r"\{x,u\}=1,\quad \{y,v\}=1"
TODA = r"\{a_1,b_1\}=-a_1,\quad \{a_1,b_2\}=a_1,\quad \{a_2,b_2\}=-a_2,\quad \{a_2,b_3\}=a_2"


def euler(bracket=MOMENTA):
    """The free body, with momenta x, y, z."""
    body = System(r"\dot x=(b-c)yz,\quad \dot y=(c-a)zx,\quad \dot z=(a-b)xy")
    body.define(bracket)
    return body, body.define(r"H=\frac{1}{2}(ax^2+by^2+cz^2)"), body.define("K=x^2+y^2+z^2")


def henon_heiles():
    """An integrable case of the potential of Hénon and Heiles."""
    system = System(r"\dot x=u,\quad \dot y=v,\quad \dot u=-2xy,\quad \dot v=-x^2-6y^2")
    system.define(CANONICAL)
    H = system.define(r"H=\frac{1}{2}(u^2+v^2)+x^2y+2y^3")
    return system, H, system.define("G=x^4+4x^2y^2-4u(uy-vx)")


def test_jacobi():
    assert euler()[0].jacobi().verdict is PROVED
    assert euler(VOLTERRA)[0].jacobi().verdict is PROVED
    assert euler(MOMENTA.replace("=y", "=x+y"))[0].jacobi().verdict is REFUTED
    plane = System(r"\dot x=y, \dot y=-x")
    for other in (r"\{x,x\}=1", r"\{y,x\}=z", r"\{y,x\}=-2z"):
        outcome = euler(rf"{MOMENTA},\quad {other}")[0].jacobi().outcome
        assert outcome.verdict == "error" and "is not antisymmetric" in outcome.message
    assert "no Poisson bracket" in euler("A=x")[0].jacobi().outcome.message
    outcome = euler(rf"{MOMENTA},\quad \{{x,a\}}=1")[0].jacobi().outcome
    assert outcome.verdict == "error" and "a is no variable" in outcome.message
    plane.define(r"\{x,y\}=x^2")
    assert "of two variables" in plane.jacobi().outcome.message


@pytest.mark.parametrize(
    "mutant", sampled(["x^2+y^2-z^2", "x^2+y^2+2z^2", "x^3+y^2+z^2", "x+y+z", "a"], 1)
)
def test_casimir_functions(mutant):
    body, H, K = euler()
    assert body.casimir(K).verdict is PROVED
    assert body.casimir(H).verdict is REFUTED
    assert body.casimir(mutant).verdict is REFUTED
    assert body.casimir("x^2+y^2+z^2=1").verdict is PROVED
    assert body.casimir("x^2+y^2+z^2=-1").verdict is REFUTED  # no real point has this value
    assert "not an equation" in body.casimir("a=1").outcome.message


@pytest.mark.parametrize("mutant", sampled(["G=x^4+4x^2y^2+4u(uy-vx)", "G=x^4+4x^2y-4u(uy-vx)"], 1))
def test_involution(mutant):
    system, H, G = henon_heiles()
    assert system.involution(H, G).verdict is PROVED
    assert system.involution(H, G, "x").verdict is REFUTED
    assert system.involution(H, mutant.removeprefix("G=")).verdict is REFUTED
    assert "two functions at least" in system.involution(H).outcome.message


@pytest.mark.slow
def test_integrability_in_the_sense_of_liouville():
    body, H, K = euler()
    assert body.integrable(H, casimirs=[K]).verdict is PROVED
    assert body.integrable(K, casimirs=[H]).verdict is REFUTED  # no Hamiltonian, no Casimir
    assert body.integrable(H, casimirs=["K^2-K"]).verdict is PROVED
    assert "3 variables" in body.integrable(H, K).outcome.message
    assert "the Hamiltonian: there is none" in body.integrable(casimirs=[H]).outcome.message
    system, H, G = henon_heiles()
    assert system.integrable(H, G).verdict is PROVED
    assert system.integrable(H, "H^2").verdict is REFUTED


def test_a_bracket_of_lower_rank_needs_more_casimir_functions():
    still = System(r"\dot x=0,\quad \dot y=0")
    still.define(r"\{x,y\}=0")
    assert still.integrable("x").verdict is REFUTED
    assert still.involution("x", "y").verdict is PROVED


def test_the_toda_chain_is_integrable_and_has_a_lax_pair():
    toda = System(
        r"\dot a_1=a_1(b_2-b_1),\ \dot a_2=a_2(b_3-b_2),\ "
        r"\dot b_1=2a_1^2,\ \dot b_2=2(a_2^2-a_1^2),\ \dot b_3=-2a_2^2"
    )
    toda.define(TODA)
    H = toda.define(r"H=\frac{1}{2}(b_1^2+b_2^2+b_3^2)+a_1^2+a_2^2")
    K = toda.define(r"I=b_1b_2b_3-a_1^2b_3-a_2^2b_1")
    assert toda.integrable(H, K, casimirs=["b_1+b_2+b_3"]).verdict is PROVED
    rows = r"{{\bf {}}}=\begin{{pmatrix}} {} \end{{pmatrix}}"
    L = toda.define(rows.format("L", r"b_1&a_1&0\\ a_1&b_2&a_2\\ 0&a_2&b_3"))
    M = toda.define(rows.format("M", r"0&-a_1&0\\ a_1&0&-a_2\\ 0&a_2&0"))
    found = {toda.lax(L, M).verdict, toda.lax(M, L).verdict}
    assert found == {PROVED, REFUTED}
