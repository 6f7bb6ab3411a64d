"""Names with signs: in their indices, or raised on them, and pairs of names with either sign."""

import pytest

from kowalevski_cas.notation.layout import statements
from kowalevski_cas.reading import CLAIM, LAW
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, roles, verdicts

SPIRAL = r"""The two waves obey
\begin{align}
\dot u_+&=w\,u_-,\\
\dot u_-&=-w\,u_+,\\
\dot w&=u_+u_- .
\end{align}
"""


def test_signs_are_indices_and_the_rows_of_a_display_are_one_law():
    found = reading(SPIRAL)
    assert [f.role.name for f in found.formulas] == [LAW] * 3
    assert [law.variables for law in found.parts.laws] == [("u_+", "u_-", "w")]


def test_what_is_said_of_names_with_signs_is_judged():
    claims = r"Put $N=u_+^2+u_-^2$ and $D=u_+^2-u_-^2$. Then $\dot N=0$, and $\dot D=4w u_+u_-$, and $\dot D=2w u_+u_-$."
    found = verdicts(SPIRAL + claims)
    assert found[r"\dot N=0"] is found[r"\dot D=4w u_+u_-"] is Verdict.PROVED
    assert found[r"\dot D=2w u_+u_-"] is Verdict.REFUTED


def test_a_raised_sign_makes_another_name_of_a_letter():
    text = r"The motion is \[\dot q=p,\qquad \dot p=-k^2q.\] Put $a^\pm=p\pm ikq$ with $i^2=-1$. "
    found = verdicts(
        text + r"Then $\dot a^+=ik\,a^+$, and $\dot a^-=ik\,a^-$, and $a^+a^-=p^2+k^2q^2$."
    )
    assert found[r"\dot a^+=ik\,a^+"].green and found["a^+a^-=p^2+k^2q^2"].green
    assert not found[r"\dot a^-=ik\,a^-"].green


@pytest.mark.parametrize(
    ("tex", "read"),
    [
        (r"\lambda_{1,2}=a\pm b", [r"\lambda _ { 1 } = a + b", r"\lambda _ { 2 } = a - b"]),
        (r"m_{j,k}=n", [r"m _ { j , k } = n"]),
        (r"a^\pm=b\mp c", ["a^+ = b - c", "a^- = b + c"]),
        (r"x^-1=2", ["x ^ - 1 = 2"]),
        (r"e^-t=1", ["e ^ - t = 1"]),
    ],
)
def test_a_sign_is_a_part_of_a_name_only_where_it_raises_nothing_else(tex, read):
    assert [" ".join(token.text for token in one.tokens) for one in statements(tex)] == read


def test_the_first_of_two_names_has_the_upper_sign():
    text = r"The motion is \[\dot x=y,\qquad \dot y=cx-2by.\] Put $r_{1,2}=-b\pm\sqrt{b^2+c}$. "
    found = verdicts(text + r"Then $r_1+r_2=-2b$, and $r_1r_2=-c$, and $r_1-r_2=2b$.")
    assert found["r_1+r_2=-2b"].green and found["r_1r_2=-c"].green
    assert not found["r_1-r_2=2b"].green


def test_one_entry_with_two_indices_is_no_pair():
    assert (
        roles(r"The motion is \[\dot x=m_{1,2}\,x.\] Then $\dot x=m_{1,2}x$.").popitem()[1] == CLAIM
    )


def test_a_function_may_have_digits_behind_its_power():
    text = r"The motion is \[\dot s=c\cos s .\] "
    found = verdicts(text + r"Then $\sin^23s+\cos^23s=1$, and $\sin^23s=9\sin^2s$.")
    assert found[r"\sin^23s+\cos^23s=1"].green
    assert not found[r"\sin^23s=9\sin^2s"].green


ROTATING = r"""The motion is
\[ \dot{\mathbf q}^{\mathcal R} = \mathbf k\times\mathbf q^{\mathcal R},\qquad \dot{\mathbf k} = 0 . \]
"""


def test_the_name_of_a_frame_makes_another_name_of_a_vector():
    claims = r"With $\mathbf q^{\mathcal P}=2\mathbf q^{\mathcal R}$ we have \[ \dot{\mathbf q}^{\mathcal P} = 2\mathbf k\times\mathbf q^{\mathcal R} . \] Moreover, \[ \dot{\mathbf q}^{\mathcal P} = \mathbf k\times\mathbf q^{\mathcal R} . \]"
    *_, right, wrong = verdicts(ROTATING + claims).values()
    assert right.green and wrong is Verdict.REFUTED
