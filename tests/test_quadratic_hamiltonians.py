r"""Quadratic Hamiltonians on e(3) with an additional integral, of the list of T. Wolf.

Instances of families of https://lie.ac.brocku.ca/twolf/htdocs/ham/e3/over.html, by the names and
conditions of that page (facts only): its U are the momenta, its V the directions, and a letter with
two indices is the coefficient of a product. The families with D have their integral for (U, V)=0.
Each has an instance of which a condition is broken, which has no such integral.
"""

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.claims import FirstIntegral

pytestmark = pytest.mark.usefixtures("uncorrected")

BRACKET = r"\{U_i,U_j\}=\varepsilon_{ijk}U_k,\ \{U_i,V_j\}=\varepsilon_{ijk}V_k,\ \{V_i,V_j\}=0"
LEVEL = ("U_1V_1+U_2V_2+U_3V_3=0",)
KOWALEVSKI = "U_1^2+U_2^2+2U_3^2"
SECOND = r"3U_1^2+U_2^2+2U_3^2+4U_1V_1+3U_3V_3-\frac12V_2^2+\frac54V_3^2"
LINEAR = r"+U_1+U_2+U_3+\frac32V_1+\frac52V_2+2V_3"

FAMILIES = {
    # a11=a22, a33=2a11, 4a11 c33+b31^2+b32^2=0, b31(a33 m1-n3 b31)+b32(a33 m2-n3 b32)=0
    "Wolf, Efimovskaya S4": (KOWALEVSKI + "+2U_3V_1-V_3^2+3U_3+3V_1+5V_2", "-V_3^2", "-2V_3^2", 4, ()),
    "Wolf, Efimovskaya S4, both b": (
        KOWALEVSKI + "+2U_3V_1+4U_3V_2-5V_3^2+U_3+V_1+2V_2", "+2V_2", "-2V_2", 4, (),
    ),
    # a11=a22, a33=2a11, c11+c22=0
    "Chaplygin, Wolf, Efimovskaya D4": (
        KOWALEVSKI + "+3V_1^2-3V_2^2+4V_1V_2+5U_3+V_1+2V_2", "-3V_2^2", "-2V_2^2", 4, LEVEL,
    ),
    # a11=a22, a33=4a11, a11 c33+(b31/4)^2+(b32/4)^2=0
    "Chaplygin, Wolf, Efimovskaya D3": (
        "U_1^2+U_2^2+4U_3^2+4U_3V_1+8U_3V_2-5V_3^2+U_3+2V_1+3V_2", "-5V_3^2", "-4V_3^2", 3, LEVEL,
    ),
    # b11=b22=b33, a11 a22(c11-c22)+a33 a11(c33-c11)+a22 a33(c22-c33)=0
    "Clebsch": (
        "U_1^2+2U_2^2+3U_3^2+U_1V_1+U_2V_2+U_3V_3+4V_1^2+V_2^2", "+4V_1^2", "+3V_1^2", 2, (),
    ),
    # 4c33 a33^2(a11-a22)^2=b11^2(a11^2 a33-a11 a22^2-a11 a33^2+a22^2 a33), and so on
    "C111 D2 S1": (SECOND, r"+\frac54", r"+\frac34", 2, ()),
    "C111 D2 S1, with linear terms": (SECOND + LINEAR, "+2V_3", "+V_3", 2, ()),
}  # fmt: skip


FIRST = "Chaplygin, Wolf, Efimovskaya D3"
EACH = pytest.mark.parametrize(
    "name", [n if n == FIRST else pytest.param(n, marks=pytest.mark.slow) for n in FAMILIES]
)


def integrals(hamiltonian, degree, level):
    """The integrals that are found, and not made of the Hamiltonian and the Casimir functions."""
    system = System(rf"{BRACKET},\ H={hamiltonian}")
    claims = system.find_integrals(degree, on=level)
    assert all(claim.verdict.green for claim in claims)
    found = [claim for claim in claims if isinstance(claim.claim, FirstIntegral)]
    return system, found, 2 if level else 3


@EACH
def test_each_family_has_one_integral_more(name):
    hamiltonian, _, _, degree, level = FAMILIES[name]
    system, found, known = integrals(hamiltonian, degree, level)
    assert len(found) == known + 1
    if not level:
        functions = [str(claim.claim.own.tex) for claim in found]
        assert system.involution("H", *functions).verdict.green


@EACH
def test_without_its_conditions_there_is_none(name):
    hamiltonian, right, wrong, degree, level = FAMILIES[name]
    assert hamiltonian.count(right) == 1
    _, found, known = integrals(hamiltonian.replace(right, wrong), degree, level)
    assert len(found) == known
