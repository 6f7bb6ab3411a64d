"""A potential in the equations of motion, and what it is in the cases of a paper."""

from itertools import product

import pytest

from kowalevski_cas.reading import ASSUMPTION
from tests.reading.test_restated import reading, verdicts
from tests.sample import sampled

GREEN = {"PROVED", "CONDITIONAL", "CONFIRMED"}
LETTERS = [("U", "x", "y", "z"), ("V", r"\alpha", r"\beta", r"\gamma"), ("W", "n_1", "n_2", "n_3")]
"""The potential and the components of the vertical."""
SAID = ["(@x,@y,@z)", ""]
"""Whether it is said on what it depends."""

BODY = r"""The body is in the field of the potential $@U{SAID}$:
\begin{gather}A\dot p=@y\frac{\partial @U}{\partial @z}-@z\frac{\partial @U}{\partial @y},\qquad
B\dot q=@z\frac{\partial @U}{\partial @x}-@x\frac{\partial @U}{\partial @z},\\
\dot @x=-@zq,\qquad \dot @y=@zp,\qquad \dot @z=@xq-@yp.\end{gather}
"""


def in_letters(text, letters, said=""):
    text = text.replace("{SAID}", said)
    for print_, own in zip(("@U", "@x", "@y", "@z"), letters, strict=True):
        text = text.replace(print_, f"{{{own}}}")
    return text


def judged(text, letters, said=""):
    return [*verdicts(in_letters(BODY + text, letters, said)).values()]


TRUE = [
    r"""a) $@U=a@x+b@y$. The integral is linear: \begin{equation}K=Aap+Bbq.\end{equation}

    b) $@U=c@z^2/2$. Here \begin{equation}Ap^2-c@y^2,\qquad Bq^2-c@x^2\end{equation} are constant.""",
    r"(i) $@U=a@x$. Then $p$ is an integral. \begin{equation}\dot p=0.\end{equation}",
    r"In the case $@U=a@x+b@y$ the function \begin{equation}K=Aap+Bbq\end{equation} is an integral.",
    r"For $@U=c@z$ the function \begin{equation}E=Ap^2+Bq^2+2c@z\end{equation} is an integral.",
    r"""а) $@U=c@z$. Интеграл таков: \begin{equation}E=Ap^2+Bq^2+2c@z.\end{equation}

    б) $@U=-c@z$. Интеграл таков: \begin{equation}F=Ap^2+Bq^2-2c@z.\end{equation}""",
]
FALSE = [
    r"""The integral is \begin{equation}K=Aap+Bbq.\end{equation}

    a) $@U=a@x+b@y$. Nothing more is known.""",
    r"""The integral is \begin{equation}K=Aap+Bbq.\end{equation}

    In the case $@U=a@x+b@y$ there are others.""",
    r"""a) $@U=a@x+b@y$. Nothing is known.

    b) $@U=c@z$. The integral is \begin{equation}K=Aap+Bbq.\end{equation}""",
    r"a) $@U=a@x+b@y$. The integral is \begin{equation}K=Aap-Bbq.\end{equation}",
    r"""a) $@U=a@x+b@y$. This is the first case.

    In general, too, \begin{equation}K=Aap+Bbq\end{equation} is an integral.""",
    r"""In the case $@U=a@x+b@y$ more is known.
    \section{All potentials} The function \begin{equation}K=Aap+Bbq\end{equation} is an integral.""",
    r"""For $@U=a@x+b@y$ more is known.

    The function \begin{equation}K=Aap+Bbq\end{equation} is an integral of all such bodies.""",
    r"""b) $@U=c@z$. The integral is \begin{equation}E=Ap^2+Bq^2-2c@z.\end{equation}""",
    r"""b) $@U=c@z$. The integral is \begin{equation}M=Ap@x+Bq@y.\end{equation}""",
    r"""(i) $@U=c@z^2/2$. Here \begin{equation}Ap^2+c@y^2,\qquad Bq^2+c@x^2\end{equation} are constant.""",
]


@pytest.mark.parametrize(("text", "letters", "said"), sampled(product(TRUE, LETTERS, SAID), 6))
def test_what_holds_in_a_case(text, letters, said):
    assert {*judged(text, letters, said)} <= GREEN


@pytest.mark.parametrize(("text", "letters", "said"), sampled(product(FALSE, LETTERS, SAID), 10))
def test_what_holds_in_another_case_or_in_none(text, letters, said):
    assert not GREEN & {*judged(text, letters, said)}


def test_a_special_potential_is_supposed():
    text = in_letters(
        BODY + r"a) $@U=a@x$. Then \begin{equation}\dot p=0.\end{equation}", LETTERS[0]
    )
    found = {one.item.printed.tex.strip(): one for one in reading(text).formulas}
    assert found["{U}=a{x}"].role.name == ASSUMPTION
    assert [one.printed.tex for one in found[r"\dot p=0"].on] == ["{U}=a{x}"]
