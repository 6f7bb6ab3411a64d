"""Where several systems are printed in the same letters, words say which is meant."""

import pytest

from tests.reading.test_reading import verdicts

SYSTEMS = r"""The first system is \[ \dot x=y,\qquad\dot y=-x. \]
The second system is \[ \dot x=y,\qquad\dot y=x. \] """


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("The function $FUNCTION$ is an integral of the first system.", "x^2+y^2"),
        ("The function $FUNCTION$ is an integral of the second system.", "x^2-y^2"),
        ("For the first system $FUNCTION$ is an integral.", "x^2+y^2"),
        ("For the second one $FUNCTION$ is an integral of the system.", "x^2-y^2"),
        ("In the latter $FUNCTION$ is conserved.", "x^2-y^2"),
        ("The first of them has the integral $FUNCTION$.", "x^2+y^2"),
        ("Along the second flow $FUNCTION$ is constant; along the first $x$ is not.", "x^2-y^2"),
        ("In the first case $FUNCTION$ is constant.", ""),
        ("The function $FUNCTION$ is an integral of both systems.", ""),
        ("The function $FUNCTION$ is an integral of either of them.", ""),
        ("Each of the two systems has the integral $FUNCTION$.", ""),
    ],
)
def test_a_claim_is_of_the_system_that_its_words_name(words, green):
    for function in ("x^2+y^2", "x^2-y^2"):
        found = verdicts(SYSTEMS + words.replace("FUNCTION", function)).get(function)
        assert (found is not None and found.green) == (function == green)


def test_an_integral_has_a_number_too():
    found = verdicts(SYSTEMS + "The first integral $x^2-y^2$ of this system is constant.")
    assert found["x^2-y^2"].green


def test_systems_that_words_set_up_in_another_order():
    swapped = (
        SYSTEMS.replace("first", "THIRD").replace("second", "first").replace("THIRD", "second")
    )
    for function, true in (("x^2-y^2", True), ("x^2+y^2", False)):
        words = f"The function ${function}$ is an integral of the first system."
        found = verdicts(swapped + words).get(function)
        assert found is None or found.green == true


LABELLED = (
    r"""\begin{equation}\label{a}\dot x=y,\quad\dot y=-x\end{equation} and
    \begin{equation}\label{b}\dot x=y,\quad\dot y=x.\end{equation} """,
    r"""Consider \begin{equation}\label{a}\dot x=y,\quad\dot y=-x.\end{equation} Another system is
    \begin{equation}\label{b}\dot x=y,\quad\dot y=x.\end{equation} """,
)
OF_THESE = (
    (r"The function $FUNCTION$ is an integral of \eqref{a}.", "x^2+y^2"),
    (r"The function $FUNCTION$ is an integral of \eqref{b}.", "x^2-y^2"),
    (r"By \eqref{b} we see that $FUNCTION$ is constant.", "x^2-y^2"),
    (r"The next is true of \eqref{a} and \eqref{b}. $FUNCTION$ is an integral of \eqref{b}.", "x^2-y^2"),
    (r"The function $FUNCTION$ is an integral of \eqref{a} and \eqref{b}.", ""),
    (r"For \eqref{a} and \eqref{b} the function $FUNCTION$ is an integral.", ""),
    (r"The following holds for \eqref{a} and \eqref{b}. The function $FUNCTION$ is constant.", ""),
)  # fmt: skip


@pytest.mark.parametrize("systems", LABELLED)
@pytest.mark.parametrize(("words", "green"), OF_THESE)
def test_a_claim_is_of_the_system_that_is_cited(systems, words, green):
    for function in ("x^2+y^2", "x^2-y^2"):
        found = verdicts(systems + words.replace("FUNCTION", function)).get(function)
        assert (found is not None and found.green) == (function == green)


@pytest.mark.parametrize("systems", LABELLED)
def test_each_clause_cites_its_own_system(systems):
    words = r"For \eqref{a}, $\frac{d}{dt}(xy)=A$, whereas for \eqref{b} $\frac{d}{dt}(xy)=B$."
    for first, second in (("y^2-x^2", "x^2+y^2"), ("x^2+y^2", "y^2-x^2")):
        found = verdicts(systems + words.replace("A", first).replace("B", second))
        for value, true in ((first, "y^2-x^2"), (second, "x^2+y^2")):
            assert found[rf"\frac{{d}}{{dt}}(xy)={value}"].green == (value == true)


def test_an_equation_for_another_letter_belongs_to_the_same_system():
    law = r"Let \begin{equation}\ddot x=-x\end{equation} and \begin{equation}\ddot y=-y.\end{equation} "
    found = verdicts(law + r"The function $x\dot y-y\dot x$ is an integral.")
    assert found[r"x\dot y-y\dot x"].green


def test_each_clause_has_its_own_system():
    text = (
        SYSTEMS
        + "Along the first flow $FUNCTION$ is constant; along the second $x^2+y^2$ is constant too."
    )
    assert verdicts(text.replace("FUNCTION", "x^4+2x^2y^2+y^4"))["x^4+2x^2y^2+y^4"].green
    assert not verdicts(text.replace("FUNCTION", "x^4+2x^2y^2+y^4"))["x^2+y^2"].green


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("In the first, $x^2+y^2$ is constant, in the second, $x^2-y^2$ is constant.", True),
        ("In the first, $x^2-y^2$ is constant, in the second, $x^2+y^2$ is constant.", False),
        ("In the first $x^2+y^2$ is an integral. In the second $x^2-y^2$ is an integral.", True),
    ],
)
def test_an_ordinal_may_be_the_noun_itself(words, green):
    found = verdicts(SYSTEMS + words)
    assert found["x^2+y^2"].green == found["x^2-y^2"].green == green


def test_what_follows_behind_a_law_is_no_row_of_its_list():
    text = r"""Let $H=qp+q^2$. By $\dot q=\partial H/\partial p$, $\dot p=-\partial H/\partial q$ we get
    $\dot q=q$, $\dot p=-p-2q$. Then $q(p+q)$ is an integral."""
    found = verdicts(text)
    assert found[r"\dot p=-p-2q"].green and found["q(p+q)"].green
