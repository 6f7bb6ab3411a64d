"""Where a claim holds: in a case that words name, on a surface, near a motion, with a force added."""

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION, LAW
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

from .test_reading import TOP, reading, roles, verdicts

APART = r"\section{Another} "
CASES = [
    (
        r"The case of Steklov is the one in which \begin{equation} b=-a. \end{equation}",
        ["In the case of Steklov", "Under the condition of Steklov", "In Steklov's case"],
    ),
    (
        r"Случаем Стеклова назовём тот, в котором \begin{equation} b=-a. \end{equation}",
        ["В случае Стеклова", "При условии Стеклова"],
    ),
]
"""What introduces a case, and words that name it again."""


@pytest.mark.parametrize(
    ("introduced", "named"), [(case, words) for case, every in CASES for words in every]
)
@pytest.mark.parametrize(("function", "holds"), sampled([("p^2+q^2", True), ("p^2-q^2", False)], 1))
def test_what_a_case_supposes_holds_where_words_name_it(introduced, named, function, holds):
    text = TOP + introduced + APART + rf"{named} the function ${function}$ is an integral."
    assert verdicts(text)[function].green is holds


@pytest.mark.parametrize(
    "words", sampled(["In the case of Brun", "In general", "In another case"], 1)
)
def test_another_case_is_not_supposed(words):
    text = TOP + CASES[0][0] + APART + rf"{words} the function $p^2+q^2$ is an integral."
    assert verdicts(text)["p^2+q^2"] is Verdict.UNDECIDED


LIST = (
    TOP
    + r"""\begin{enumerate}
\item[(i)] Let $a+b=0$. Then $p^2+q^2$ is an integral.
\item[(ii)] Let $b+c=0$. Then $q^2+r^2$ is an integral.
\end{enumerate}
"""
)


@pytest.mark.parametrize(
    ("case", "function"), sampled([("(i)", "2p^2+2q^2"), ("(ii)", "2q^2+2r^2")], 1)
)
@pytest.mark.parametrize("other", [False, True])
def test_the_item_of_a_list_is_a_case(case, function, other):
    wrong = {"2p^2+2q^2": "2q^2+2r^2", "2q^2+2r^2": "2p^2+2q^2"}[function]
    said = wrong if other else function
    found = verdicts(LIST + f"In the case {case} the function ${said}$ is an integral.")
    assert found[said].green is not other


@pytest.mark.parametrize("number", sampled(["first", "second"], 1))
def test_cases_of_a_theorem_are_counted_in_its_proof(number):
    text = TOP + (
        r"\begin{theorem} Let $a+b=0$. Then $p^2+q^2$ is an integral. If $b+c=0$, then $q^2+r^2$ is "
        r"an integral. \end{theorem}\begin{proof} In the first case $p\dot p+q\dot q=0$, and in the "
        r"second one $q\dot q+r\dot r=0$. \end{proof}"
    )
    assert verdicts(text)[r"p\dot p+q\dot q=0"].green
    swapped = text.replace("first case", f"{number} case")
    assert verdicts(swapped)[r"p\dot p+q\dot q=0"].green is (number == "first")


SPHERE = r"""\section{A point} With $\Lambda=ax^2+by^2-\dot x^2-\dot y^2$ the equations of motion are
\begin{equation}\ddot x=-ax+\Lambda x,\qquad \ddot y=-by+\Lambda y,\end{equation} %s
The energy \[ h=\dot x^2+\dot y^2+ax^2+by^2 \] is an integral."""


@pytest.mark.parametrize(
    ("words", "holds"),
    sampled(
        [("where $x^2+y^2=1$.", True), ("where $x^2-y^2=1$.", False), ("as is known.", False)], 1
    ),
)
def test_a_law_may_say_on_which_surface_it_moves(words, holds):
    found = [*verdicts(SPHERE % words).values()]
    assert found[0].green is holds


@pytest.mark.parametrize("words", ["On the surface $%s=1$ a point moves freely.", "%s"])
def test_a_letter_that_words_call_a_multiplier_is_one(words):
    surface = r"\frac{x^2}{a}+\frac{y^2}{b}"
    said = words % surface if "%s=" in words else ""
    text = (
        rf"\section{{A point}} {said} The equations of motion with the multiplier are "
        r"\[ \ddot x=-\frac{\sigma x}{a},\qquad \ddot y=-\frac{\sigma y}{b}. \] "
        r"The speed is constant, \[ v^2=\dot x^2+\dot y^2. \]"
    )
    assert any(one.green for one in verdicts(text).values()) is bool(said)


FORCED = r"""\section{A pendulum} The motion is $\ddot\theta=-k\sin\theta$, and the energy
\begin{equation} h=\tfrac12\dot\theta^2-k\cos\theta \end{equation} is an integral.
\section{Friction} %s \begin{equation} \ddot\theta=-b\dot\theta-k\sin\theta, \end{equation}
and then \begin{equation} \dot h=%s. \end{equation}"""


@pytest.mark.parametrize(
    "words", sampled(["Let now a force act along the way. Then", "We have", "If $b>0$,"], 1)
)
@pytest.mark.parametrize(("rate", "holds"), [(r"-b\dot\theta^2", True), (r"-b\dot\theta", False)])
def test_what_is_named_keeps_its_meaning_where_a_force_is_added(words, rate, holds):
    text = FORCED % (words, rate)
    found = verdicts(text)[rf"\dot h={rate}"]
    assert found.green if holds else not found.green


@pytest.mark.parametrize(
    "words",
    [
        r"It is the integral of the energy, and it looks like a motion in the potential",
        r"The first integral is known, but we need only the function",
    ],
)
def test_what_another_clause_calls_an_integral_is_not_the_formula(words):
    text = TOP + rf"{words} \begin{{equation}} W=p^2+q. \end{{equation}}"
    found = roles(text)
    assert (
        found["W=p^2+q."] == DEFINITION if "W=p^2+q." in found else found["W=p^2+q"] == DEFINITION
    )


def test_special_values_of_what_a_law_has_in_general_are_supposed_in_their_section():
    text = (
        r"\section{A} The equations of motion are \begin{equation} \dot{\mathbf M}=\mathbf M\times"
        r"\boldsymbol\omega+\mathbf e\times\mathbf M,\quad \dot{\boldsymbol\omega}=\mathbf M\times"
        r"\boldsymbol\omega. \end{equation} \section{B} Let now "
        r"\begin{equation} \mathbf e=(0,0,1). \end{equation}"
    )
    (found,) = (f for f in reading(text).formulas if "(0,0,1)" in f.item.printed.tex)
    assert found.role.name == ASSUMPTION


def test_a_momentum_of_which_something_is_denied_is_named():
    text = (
        r"\section{A} The motion is \[ \ddot x=-x+y,\ \ddot y=x-y^2. \] The momentum $p=\dot x$ is not "
        r"constant; it obeys \[ \dot p=-x+y. \] "
    )
    found = {f.item.printed.tex.strip(" .,"): f.role.name for f in reading(text).formulas}
    assert found["p=\\dot x"] == DEFINITION
    assert found[r"\dot p=-x+y"] == CLAIM
    assert [*found.values()].count(LAW) == 2


@pytest.mark.parametrize(("mass", "holds"), sampled([(3, True), (2, False)], 1))
def test_what_is_supposed_of_a_name_is_supposed_of_what_it_stands_for(mass, holds):
    text = (
        r"\section{A} The motion is \[ \dot x=(M-3m)xy,\ \dot y=-x. \] We write $\mu=M/m$. "
        rf"Let $\mu={mass}$. Then \[ \dot x=0. \]"
    )
    assert verdicts(text)[r"\dot x=0"].green is holds


@pytest.mark.slow
def test_what_a_clause_with_if_supposes_of_a_vector_is_supposed():
    text = (
        r"\section{A} The motion is \[ \dot{\mathbf M}=\mathbf M\times\mathbf p,\quad "
        r"\dot{\mathbf p}=\mathbf p\times\mathbf M. \] "
        r"If the vector is along an axis, e.g. $\mathbf p=(1,0,0)$, then $\dot M_1=%s$."
    )
    assert verdicts(text % "0")[r"\dot M_1=0"].green
    assert not verdicts(text % "M_2")[r"\dot M_1=M_2"].green


ROSES = r"\begin{equation}\ddot x=-x-2xy,\qquad \ddot y=-y-x^2-ky^2.\end{equation} "
FIRST = r"If $k=1$, then \begin{equation} F=\dot x\dot y+xy+xy^2+\frac13x^3 \end{equation} is a first integral."
ENERGY = r"The function $E=\frac12(\dot x^2+\dot y^2+x^2+y^2)+x^2y+\frac k3y^3$ is an integral."


@pytest.mark.parametrize(
    ("stated", "words", "row", "supposed"),
    sampled(
        [
            (FIRST, "Put $u=x+y$. Then", r"\ddot u=-u-u^2", True),
            (FIRST, "Put $u=x+y$. Then", r"\ddot u=-u+u^2", False),
            (FIRST, "Put $u=x+y$. For any $k$ we have", r"\ddot u=-u-u^2", False),
            (FIRST, "Put $u=x+y$. For general $k$ we have", r"\ddot u=-u-u^2", False),
            (FIRST, "Put $u=x+y$. Whatever the constants are,", r"\ddot u=-u-u^2", False),
            (FIRST, "Put $u=x+y$. Whatever the initial values are,", r"\ddot u=-u-u^2", True),
            (ENERGY + " " + FIRST, "Put $u=x+y$. Then", r"\ddot u=-u-u^2", False),
            (FIRST + " If $k=6$, there is another one.", "Put $u=x+y$. Then", r"\ddot u=-u-u^2", False),
        ],
        2,
    ),
)  # fmt: skip
def test_the_only_case_of_a_theorem_is_that_of_its_proof(stated, words, row, supposed):
    text = rf"{ROSES}\begin{{theorem}} {stated} \end{{theorem}}"
    text += rf"\begin{{proof}} {words} \begin{{equation}} {row}. \end{{equation}} \end{{proof}}"
    assert verdicts(text)[row].green is supposed
