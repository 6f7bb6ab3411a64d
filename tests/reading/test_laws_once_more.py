"""A law that is printed once more in more variables, and what moves where it has arguments."""

import pytest

from kowalevski_cas.reading import CLAIM, DEFINITION, LAW
from tests.reading.test_reading import reading, roles, verdicts

SECOND = r"""The equation for $u=u(t)$ is $$\ddot u=2u^3+tu+a .$$ """
FIRST = r"""Put $c=a+\tfrac12$. Following others we take
$$H(u,v,t)=\tfrac12v^2-(u^2+\tfrac12t)v-cu ,$$ so that the equations of motion are
$$\dot u=v-u^2-\tfrac12t,\qquad \dot v=2uv+c .$$ """


def test_a_law_in_more_variables_takes_the_place_of_the_first():
    text = SECOND + FIRST + r"Hence $$\ddot u=2uv+c-2u(v-u^2-\tfrac12t)-\tfrac12=2u^3+tu+a$$"
    found = reading(text + r" and $$\dot H=-\tfrac12v.$$")
    assert [one.role.name for one in found.formulas].count(LAW) == 3
    assert [one.green for one in verdicts(text + r" and $$\dot H=-\tfrac12v.$$").values()] == [
        True
    ] * 2
    wrong = text.replace("=2u^3+tu+a$$", "=2u^3-tu+a$$") + r" and $$\dot H=\tfrac12v.$$"
    assert [one.green for one in verdicts(wrong).values()] == [False] * 2


@pytest.mark.parametrize(
    "rows",
    [
        r"\dot u=v+u^2-\tfrac12t,\qquad \dot v=2uv+c",
        r"\dot u=v-u^2,\qquad \dot v=2uv+c",
        r"\dot u=v-u^2-\tfrac12t,\qquad \dot v=2uv-c",
        r"\dot u=v-u^2-\tfrac12t,\qquad \dot v=uv+c",
    ],
)
def test_a_false_system_gives_no_first_equation(rows):
    true = r"\dot u=v-u^2-\tfrac12t,\qquad \dot v=2uv+c"
    text = SECOND + FIRST.replace(true, rows) + r"Hence $$\ddot u=2u^3+tu+a.$$"
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(
    "words",
    [
        r"For $v=\dot u+u^2$ we find $$\dot u=v-u^2,\qquad \dot v=2uv+tu+c .$$",
        r"Substitution gives $$\dot u=v,\qquad \dot v=3u^3+tu+a.$$",
    ],
)
def test_what_no_words_call_equations_of_motion_takes_no_place(words):
    found = reading(SECOND + words)
    assert found.parts.laws[0].variables == ("u",)
    assert found.formulas[-1].role.name == CLAIM or len(found.parts.laws) > 1


def test_that_a_name_depends_on_the_time_is_notation():
    assert [*roles(SECOND).values()] == ["notation", LAW]
    assert [*roles(r"The motion is $$\ddot x=-x.$$ Then $y=x(t)$.").values()] == [LAW, DEFINITION]


AT_ARGUMENTS = r"""The equations of motion are $$\dot q=p,\qquad \dot p=-q .$$
Let $$H(q,p)={}.$$ Of $H(a,b)$ we shall speak later. Then $$\dot H=0.$$"""


@pytest.mark.parametrize(
    ("body", "green"), [(r"\tfrac12(q^2+p^2)", True), (r"\tfrac12(q^2-p^2)", False)]
)
def test_a_function_of_all_that_moves_is_also_its_value_along_the_motion(body, green):
    found = verdicts(AT_ARGUMENTS.replace("{}", body))
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize(
    "claim",
    [r"H(a,b)=H", r"H(p,q)=\tfrac12(p^2-2q^2)", r"H(2q,p)=H", r"H(q+p,p)=H", r"q(2t)=q", r"q(a)=q"],
)
def test_at_other_arguments_it_is_not_that_value(claim):
    text = AT_ARGUMENTS.replace("{}", r"\tfrac12(q^2+2p^2)").replace(r"\dot H=0", claim)
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(
    ("claim", "green"), [(r"\dot x+t", True), (r"\dot x-t", False), ("x+t", False)]
)
def test_a_relation_between_rates_and_the_time_is_no_solution(claim, green):
    text = r"""The equations of motion are $$\dot x=y-t,\qquad \dot y=-x.$$ Hence $$y={}.$$"""
    found = verdicts(text.replace("{}", claim))
    assert any(one.green for one in found.values()) is green


@pytest.mark.parametrize(
    "rows",
    [
        r"\dot x=v,\qquad \dot v=-x+b",
        r"\dot x=v,\qquad \dot v=-x-cv",
        r"\dot x=v,\qquad \dot v=x",
        r"\dot x=v+x,\qquad \dot v=-x",
        r"\dot x=v-t,\qquad \dot v=-x",
        r"\dot x=2v,\qquad \dot v=-x",
        r"\dot x=v,\qquad \dot v=-x^3",
        r"\dot x=v,\qquad \dot v=-x+w,\qquad \dot w=0",
    ],
)
def test_where_the_first_law_does_not_follow_nothing_is_said_of_either(rows):
    text = rf"A bead moves by $$\ddot x=-x.$$ The equations of motion of a charged bead are $${rows}.$$"
    claims = r"For the first bead $$\frac{d}{dt}(\dot x^2+x^2)=0,$$ and for the other $$\ddot x=\dot v.$$"
    assert not any(one.green for one in verdicts(f"{text} {claims}").values())
    same = text.replace(rows, r"\dot x=v,\qquad \dot v=-x")
    assert [one.green for one in verdicts(f"{same} {claims}").values()] == [True, True]


FIELDS = r"""\section{Homogeneous} The equations of motion are $$\ddot x=a\dot y,\qquad \ddot y=-a\dot x.$$
\section{Crossed} Let there be another field $E$. The equations of motion take the form
$$\ddot x=a\dot y,\qquad \ddot y=-a\dot x+E.$$ Hence $$\frac{d}{dt}(\dot x^2+\dot y^2)={}.$$"""


def test_equations_of_motion_that_take_a_form_with_new_letters_are_another_law():
    assert verdicts(FIELDS.replace("{}", r"2E\dot y")).popitem()[1].green
    for wrong in ("0", r"E\dot y", r"2E\dot x"):
        assert not verdicts(FIELDS.replace("{}", wrong)).popitem()[1].green
    claimed = FIELDS.replace("The equations of motion take", "Substituting we see that they take")
    assert len(reading(claimed).parts.laws) == 1


AMPLITUDES = r"""The field and the matter obey
\[\dot E=P,\qquad \dot P=EN,\qquad \dot N=-EP ,\] with the constant $K=\tfrac12E^2+N$.
For the second mode we write $u,v,w$ instead of $E,P,N$. The system \eqref{one} is then
\begin{equation}\label{two}\dot u=v,\qquad \dot v=uw,\qquad \dot w=-uv .\end{equation}
"""


@pytest.mark.parametrize("behind", ["", r" With $K=k$ there is the motion $u=2k$, $w=k$."])
def test_what_is_given_later_moves_nothing_in_a_law_before(behind):
    claim = r"It has the integral $\tfrac12u^2+w$."
    assert next(iter(verdicts(AMPLITUDES + claim + behind).values())).green
    wrong = r"It has the integral $\tfrac12u^2-w$."
    assert not next(iter(verdicts(AMPLITUDES + wrong + behind).values())).green
