"""A unit matrix that nobody defines: what is true of it is proved, and of a number it is not meant."""

import random

import pytest
from sympy import Matrix, eye, latex, symbols

from kowalevski_cas import System
from tests.laws.test_matrix_equations import tex_of
from tests.laws.test_prints import FEW
from tests.reading.test_reading import verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")

x, y, k, m = symbols("x y k mu")
LETTERS = ["E", "I", r"\mathbb I", r"\mathbb{E}"]


def matrices(chance):
    """A matrix of two variables, one of constants, and a letter for the unit matrix beside them."""
    size = chance.choice([2, 3])
    entries = [x, y, -x, 2 * y, x + y, 0, 1]
    letter = chance.choice([*LETTERS, f"E_{size}", f"I_{size}"])
    return Matrix(size, size, lambda i, j: chance.choice(entries)), letter


def statements(L, E):
    """True and false statements with multiples of the unit matrix."""
    size = L.rows
    one = eye(size)
    yield rf"(L-k{E})(L+k{E})=L^2-k^2{E}", True
    yield rf"(L+{E}k)^2=L^2+2kL+k^2{E}", True
    yield rf"L+k{E}={tex_of(L + k * one)}", True
    yield rf"\operatorname{{tr}}(L-k{E})={latex((L - k * one).trace())}", True
    yield rf"\det(L-k{E})={latex((L - k * one).det().expand())}", True
    yield rf"{E}={tex_of(one)}+L-L", True
    yield rf"(L-k{E})(L+k{E})=L^2-k{E}", False
    yield rf"\operatorname{{tr}}(L-k{E})={latex((L - k * one).trace() + k)}", False
    yield rf"{E}=2{tex_of(one)}+L-L", False


@pytest.mark.slow
@FEW
def test_multiples_of_the_unit_matrix_are_added_to_matrices(seed):
    chance = random.Random(seed)
    L, E = matrices(chance)
    law = rf"\dot x=y,\ \dot y=-k^2x,\ L={tex_of(L)}"
    told = chance.random() < 0.5
    system = System(rf"{law},\ A=L-k{E}") if told else System(law)
    assert {*system.scene.constants} == {"k"}
    for tex, true in statements(L, E):
        verdict = system.identity(tex).verdict
        assert verdict.green if true else verdict == "refuted", (law, tex)


@pytest.mark.slow
@FEW
def test_so_they_are_in_papers(seed):
    chance = random.Random(seed)
    L, E = matrices(chance)
    printed = [(tex, true) for tex, true in statements(L, E) if not tex.startswith(E)]  # it defines
    rows = "".join(rf"We have $${tex}.$$ " for tex, _ in printed)
    text = (
        r"The equations of motion are $$\dot x=y,\quad \dot y=-k^2x.$$ Let us denote "
        rf"$$L={tex_of(L)}.$$ {rows}"
    )
    found = verdicts(text)
    for tex, true in printed:
        assert tex in found, (tex, found)
        assert found[tex].green == true, (tex, found)


def test_an_energy_is_no_unit_matrix():
    law = r"\dot x=y,\ \dot y=-Ex,\ L=\begin{pmatrix}x&y\\y&-x\end{pmatrix}"
    system = System(law)
    assert system.scene.constants == ("E",)
    assert system.identity(r"\det(L-E)=E^2-x^2-y^2").verdict == "proved"
    for tex in (r"L^2=(x^2+y^2)E", r"(L-xE)^2=L^2-2xL+x^2E"):
        with pytest.raises(ValueError, match="is a number in the equations of motion"):
            system.identity(tex)


@pytest.mark.parametrize(
    ("law", "message"),
    [
        (r"\dot L=[L+E,A],\ A=\begin{pmatrix}0&y\\-y&0\end{pmatrix}", "may be a number"),
        (r"\dot L=[L,A+kE],\ A=\begin{pmatrix}0&E\\-E&0\end{pmatrix}", "may be a number"),
        (r"\dot L=[L,A+kE],\ A=\begin{pmatrix}0&y\\-y&0\end{pmatrix},\ B=\begin{pmatrix}x&y&1\\0&1&0\\1&0&0\end{pmatrix}", "size"),
    ],
)  # fmt: skip
def test_what_may_be_either_is_refused(law, message):
    with pytest.raises(ValueError, match=message):
        System(rf"{law},\ L=\begin{{pmatrix}}x&y\\y&-x\end{{pmatrix}}")


def test_a_tensor_of_inertia_is_no_unit_matrix():
    text = (
        r"The equations of motion of a body with the inertia $I$ are "
        r"$$\dot x=y,\quad \dot y=-x.$$ Let us denote $$L=\begin{pmatrix}x&y\\y&-x\end{pmatrix}.$$ We have $$L^2=(x^2+y^2)I.$$ "
    )
    assert not verdicts(text)
    assert verdicts(text.replace(" of a body with the inertia $I$", ""))[r"L^2=(x^2+y^2)I"].green


@pytest.mark.slow
@FEW
def test_an_orthogonal_matrix_times_its_transposed_is_one(seed):
    chance = random.Random(seed)
    one = chance.choice(["E", "I", "1", r"\mathbf 1", r"\mathbb{I}"])
    first, second = chance.choice([("R", "R^T"), (r"R^{\mathsf T}", "R"), ("R", r"R^{\top}")])
    system = System(r"\dot R=RW,\ R=\begin{pmatrix}a&b\\c&d\end{pmatrix},\ W=\begin{pmatrix}0&w\\-w&0\end{pmatrix},\ w=\mathrm{const}")  # fmt: skip
    equation = f"{first}{second}={one}"
    assert system.invariant(equation).verdict == "proved"
    assert system.implication(r"(\det R)^2=1", equation).verdict == "proved"
    assert system.implication(r"\det R=2", equation).verdict == "refuted"
    assert system.implication(equation, "a=d=1,\\ b=c=0".split(",\\ ")).verdict == "proved"
    assert system.implication(equation, ["a=d=1"]).verdict == "refuted"
    assert system.identity(equation).verdict == "refuted"
    assert system.identity(equation.replace(f"={one}", "=2")).verdict == "error"
