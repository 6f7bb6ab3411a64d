"""Matrix equations of motion: the entries move as SymPy finds, or the print is refused."""

import random

import pytest
from sympy import Matrix, Symbol, expand, latex

from kowalevski_cas import System
from tests.laws.test_prints import FEW, differ
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

x, y, z, w, a = (Symbol(letter) for letter in "xyzwa")


def tex_of(matrix):
    rows = [" & ".join(latex(entry) for entry in matrix.row(k)) for k in range(matrix.rows)]
    kind = "pmatrix"
    return rf"\begin{{{kind}}}{(chr(92) * 2).join(rows)}\end{{{kind}}}"


@FEW
def test_the_entries_move_by_the_commutator(seed):
    chance = random.Random(seed)
    L, B = chance.choice([("L", "A"), ("X", "N"), (r"\mathbf L", r"\mathbf B"), ("L", "M")])
    full = chance.random() < 0.5
    first = Matrix([[x, y], [z, w]]) if full else Matrix([[x, y], [y, -x]])
    entry = lambda: chance.choice([x, 2 * y, a, x * y, -1, a * x])  # noqa: E731
    second = Matrix(2, 2, lambda i, j: entry())
    if not full:
        second = Matrix([[0, second[0]], [-second[0], 0]])
    form, value = chance.choice(
        [
            ("[{L},{B}]", first * second - second * first),
            ("[{B},{L}]", second * first - first * second),
            ("{L}{B}-{B}{L}", first * second - second * first),
            ("-[{L},{B}]", second * first - first * second),
            ("[{L}^2,{B}]", first**2 * second - second * first**2),
        ]
    )
    left = chance.choice([rf"\dot{{{L}}}", rf"\frac{{d{L}}}{{dt}}", rf"\frac{{d}}{{dt}}{L}"])
    law = f"{left}={form.format(L=L, B=B)}"
    parts = [law, f"{L}={tex_of(first)}", f"{B}={tex_of(second)}"]
    chance.shuffle(parts)
    tex = ",\\quad ".join(parts)
    places = {x: (0, 0), y: (0, 1)} | ({z: (1, 0), w: (1, 1)} if full else {})
    meant = {str(one): expand(value[place]) for one, place in places.items()}
    moving = {name: rate for name, rate in meant.items() if rate != 0}
    if not moving:
        with pytest.raises(ValueError, match="no equation of motion"):
            System(tex)
        return
    system = System(tex)
    assert not differ(system, moving, seed), system
    assert system.identity(law).verdict == "proved"
    assert system.identity(f"{law}+{L}").verdict == "refuted"
    for power in (1, 2, 3) if full else (2,):
        trace = system.integral(rf"\operatorname{{tr}}{L}^{power}")
        assert trace.verdict == "proved", (system, power)
    turned = next(iter(moving))
    assert system.integral(f"{turned}^3+7{turned}").verdict == "refuted"


@FEW
def test_what_no_rates_obey_is_refused(seed):
    """A symmetric matrix does not stay so by a commutator with what is not skew."""
    chance = random.Random(seed)
    first = Matrix([[x, y], [y, w]])
    wrong = chance.choice([1, a, x, y])
    second = Matrix([[0, y], [-y + wrong, 0]])
    tex = rf"\dot L=[L,A],\ L={tex_of(first)},\ A={tex_of(second)}"
    with pytest.raises(ValueError, match="no rates obey"):
        System(tex)


SPECTRAL = (
    r"\dot L(\lambda)=[L(\lambda),A(\lambda)],\ "
    r"L(\lambda)=\begin{pmatrix}p&\lambda-q\\\lambda^2+q\lambda+q^2&-p\end{pmatrix},\ "
    r"A(\lambda)=\begin{pmatrix}0&1\\\lambda+2q&0\end{pmatrix}"
)


@pytest.mark.parametrize("print_", sampled([SPECTRAL, SPECTRAL.replace(r"(\lambda)", "")], 1))
def test_of_a_spectral_parameter_the_rates_are_free(print_):
    system = System(print_)
    assert system.scene.variables == ("p", "q") and system.scene.constants == (r"\lambda",)
    assert system.integral(r"\det L").verdict == system.integral("p^2-q^3").verdict == "proved"
    assert system.integral("p^2+q^3").verdict == "refuted"
    curve = system.define(r"P(\nu)=\det(L-\nu)")
    assert system.integral(curve).verdict == "proved"


def test_a_matrix_is_taken_at_its_own_parameter_only():
    system = System(SPECTRAL)
    assert system.integral(r"\det L(\lambda)").verdict == "proved"
    for other in (r"\det L(2)", r"\det L(-\lambda)"):
        with pytest.raises(ValueError, match="at another argument"):
            system.integral(other)
    with pytest.raises(ValueError, match="no rates obey"):
        System(SPECTRAL.replace("+2q", "+q"))


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        (r"\dot X=[X^2,N]", "entries of the matrices"),
        (
            r"\dot L=[L,A],\ L=\begin{pmatrix}p&kq\\kq&-p\end{pmatrix},\ "
            r"A=\begin{pmatrix}0&k\\-k&0\end{pmatrix}",
            "print what is constant",
        ),
    ],
)
def test_what_does_not_determine_the_rates_is_refused(tex, message):
    with pytest.raises(ValueError, match=message):
        System(tex)


def test_what_is_said_to_be_constant_is():
    system = System(
        r"\dot L=[L,A],\ L=\begin{pmatrix}p&kq\\kq&-p\end{pmatrix},\ "
        r"A=\begin{pmatrix}0&k\\-k&0\end{pmatrix},\ k=\mathrm{const}"
    )
    assert system.scene.constants == ("k",)
    assert system.integral("p^2+k^2q^2").verdict == "proved"
    assert system.integral("p^2-k^2q^2").verdict == "refuted"


@pytest.mark.slow
@FEW
def test_rows_and_columns_are_exchanged_in_a_transposed_matrix(seed):
    chance = random.Random(seed)
    R = Matrix(2, 2, lambda i, j: chance.choice([x, 2 * y, z, a, x * y, 3]))
    S = Matrix([[x, y], [z, w]])
    mark = chance.choice(["T", "{T}", r"{\mathsf T}", r"{\top}", r"{\rm T}"])
    system = System(
        rf"\dot S=SR,\ S={tex_of(S)},\ R={tex_of(R)}"
    )  # fmt: skip
    for true in (
        rf"(SR)^{mark}=R^{mark}S^{mark}", rf"(S^{mark})^{mark}=S",
        rf"\frac{{d}}{{dt}}S^{mark}=R^{mark}S^{mark}", rf"\det R^{mark}=\det R",
    ):  # fmt: skip
        assert system.identity(true).verdict.green, true
    assert system.identity(rf"S^{mark}={tex_of(S.T)}").verdict == "proved"
    assert system.identity(rf"S^{mark}=S").verdict == "refuted"
    if S * R != (R.T * S.T):
        assert system.identity(rf"(SR)^{mark}=R^{mark}S^{mark}+S").verdict == "refuted"
