"""Laws that a paper prints in part, components along the axes, and what a sentence says besides."""

import pytest

from kowalevski_cas.audit.audited import WRONG
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.reading import LAW
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, roles, verdicts

# -- what is printed of a law only in part -------------------------------------------------


SPACE = r"""A point has the Hamiltonian
\[ H=\tfrac12(p_x^2+p_y^2+p_z^2)-\frac kr-Fz,\qquad r=\sqrt{x^2+y^2+z^2} . \]"""


@pytest.mark.parametrize("dots", [r"\dots", r"\ldots", r"\cdots", "..."])
def test_dots_among_canonical_equations_stand_for_all_of_them(dots):
    text = rf"""{SPACE} The canonical equations
    \[ \frac{{dx}}{{dt}}=\frac{{\partial H}}{{\partial p_x}},\quad {dots},\quad
    \frac{{dp_z}}{{dt}}=-\frac{{\partial H}}{{\partial z}} \] give
    \[ \frac{{dp_z}}{{dt}}=F-\frac{{kz}}{{r^3}},\qquad \frac{{dp_y}}{{dt}}=-\frac{{ky}}{{r^2}} . \]"""
    found = [one.green for one in verdicts(text).values()]
    assert found == [True, False]
    assert [*roles(text).values()].count(LAW) == 2


def test_an_equation_of_motion_among_dots_is_no_law_by_itself():
    """Else what the dots stand for would be constant."""
    text = r"""The chain is \[ \dot x_1=x_2,\quad\dots,\quad \dot x_5=x_1 . \] Then $x_2$ is constant."""
    assert not verdicts(text)


def test_old_coordinates_that_new_ones_give_do_not_take_the_law_away():
    text = rf"""{SPACE} Put $\xi=r+z$, $\eta=r-z$. Then \[ z=\frac{{\xi-\eta}}2,\qquad
    x^2+y^2=\xi\eta,\qquad r=\frac{{\xi-\eta}}2 . \] The momentum $M=xp_y-yp_x$ is conserved."""
    assert [one.green for one in verdicts(text).values()] == [True, True, False, True]


# -- components along the axes -------------------------------------------------------------


AXES = r""" With $\mathbf L=\mathbf r\times\mathbf p$ the vector
\[ \mathbf A=\mathbf p\times\mathbf L-k\,\frac{\mathbf r}{r} \] would be constant without the field. Now"""


@pytest.mark.parametrize(
    ("rate", "green"),
    [(r"\dot A_z=-F(xp_x+yp_y)", True), (r"\dot A_z=F(xp_x+yp_y)", False),
     (r"\dot L_z=0", True), (r"\dot L_x=Fy", True), (r"\dot L_y=Fx", False)],
)  # fmt: skip
def test_a_vector_has_the_components_that_are_printed_of_it(rate, green):
    assert verdicts(SPACE + AXES + rf"\[ {rate} . \]")[rate].green is green


def test_components_that_no_equation_names_are_told():
    found = reading(SPACE + AXES + r"\[ \dot L_z=0 . \]").formulas
    told = {f.item.printed.tex for f in found if f.role.reason.startswith("its components")}
    assert told == {r"\mathbf{r}=(x,y,z)", r"\mathbf{p}=(p_x,p_y,p_z)"}


def test_a_vector_with_an_equation_of_motion_is_no_point_of_another_section():
    text = r"""\section{In a plane} \[ \dot x=y,\qquad \dot y=-x . \]
    \section{In space} A point moves by \[ \ddot{\mathbf r}=-\mathbf r . \]
    The vector $\mathbf r\times\dot{\mathbf r}$ is constant, and so is $\dot{\mathbf r}^2+\mathbf r^2$."""
    assert [one.green for one in verdicts(text).values()] == [True, True]


def test_a_vector_with_numbers_has_these_components():
    text = r"""The point moves by \[ \dot r_1=r_2,\qquad \dot r_2=-r_1,\qquad x=r_1+y. \]
    The square $\mathbf r\cdot\mathbf r$ is constant."""
    names = reading(text).parts.known[0].names
    assert names.vectors[r"\mathbf{r}"] == ("r_1", "r_2")


# -- what a sentence says besides ----------------------------------------------------------


def test_a_matrix_is_named_by_a_sentence_that_makes_an_exception_for_it():
    text = r"""\[ \dot x=(2-p)x+(p-1)y,\qquad \dot y=y-x . \] The matrix
    \[ K=\begin{pmatrix}2-p&p-1\\-1&1\end{pmatrix} \] is not symmetric unless $p=0$. Its determinant is
    $\det K=1$. Hence $\det K=2$."""
    assert [one.green for one in verdicts(text).values()] == [True, False]


@pytest.mark.parametrize(("factor", "green"), [("c", True), ("2c", False)])
def test_the_rate_behind_a_colon_is_claimed_of_what_is_not_conserved(factor, green):
    text = rf"""\[ \dot q=p,\qquad \dot p=-q-cp . \] Put $E=\tfrac12(p^2+q^2)$. It is not conserved:
    \[ \dot E=-{factor}p^2 . \]"""
    assert verdicts(text)[rf"\dot E=-{factor}p^2"].green is green


@pytest.mark.parametrize("words", ["For small angles we have", "If the angles are small, then"])
def test_what_holds_for_small_angles_is_not_false_because_it_is_approximate(words):
    text = rf"\[ \ddot\theta=-\sin\theta . \] {words} \[ \ddot\theta=-\theta . \]"
    assert Verdict.REFUTED not in verdicts(text).values()


def test_constants_that_differ_for_all_indices_are_supposed_and_nothing_is_missing():
    text = r"""\[ \dot x_1=a_1x_2,\qquad \dot x_2=-a_2x_1 . \] Let $a_i\ne a_j$ for $i\ne j$. The energy
    $H=a_2x_1^2+a_1x_2^2$ is conserved."""
    found = audit_reading(ReadingSession(reading(text), timeout=20))
    assert not [one for one in found.formulas if one.verdict in WRONG]


# -- another system by other letters -------------------------------------------------------


REAL = r"""\section{All} The equations are \[ \dot E=P,\qquad \dot P=ED,\qquad
\dot D=-\tfrac12(\bar EP+E\bar P) . \] The bar denotes the complex conjugate.
\section{Real ones} With $E=x$, $P=y$, $D=z$ \[ \dot x=y,\qquad \dot y=xz,\qquad \dot z=-xy . \]"""


@pytest.mark.parametrize(("factor", "green"), [("", True), ("2", False)])
def test_other_letters_for_what_moves_set_up_another_system(factor, green):
    text = REAL + rf"The integral is \[ c={factor}y^2+z^2 . \]"
    assert [one.green for one in verdicts(text).values()] == [green]
    assert [*roles(text).values()].count(LAW) == 6


def test_a_second_value_that_a_list_supposes_is_supposed():
    text = (
        REAL
        + r"The integrals are \[ h=\tfrac12x^2+z,\qquad c=y^2+z^2 . \] For $h=1$, $2c=3$ it is so."
    )
    assert roles(text)["2c=3"] == "assumption"


@pytest.mark.parametrize("formula", ["", r"\label{x}", ",", r"\quad", r"a\qquad(b=1,\ c=2)"])
def test_a_formula_without_a_statement_stands_for_nothing(formula):
    text = rf"\[ \dot x=y,\qquad \dot y=-x . \] Then \[ {formula} \] and $x^2+y^2$ is constant."
    assert [one.green for one in verdicts(text).values()] == [True]
