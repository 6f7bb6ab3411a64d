"""Letters in plain type that are vectors or matrices, and the traces of their powers."""

import pytest

from kowalevski_cas.reading import DEFINITION
from tests.reading.test_matrices_of_elements import TURN
from tests.reading.test_reading import roles, verdicts


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"Rf=(1,-\tfrac12)^T", True),
        (r"Rf=(1,\tfrac12)^T", False),
        (r"RRf=-\tfrac14f", True),
        (r"RRf=\tfrac14f", False),
        (r"(f,f)=5", True),
        (r"(f,f)=4", False),
    ],
)
def test_a_letter_that_is_a_list_of_numbers_is_a_vector(claim, green):
    text = TURN + rf"With $f=(1,2)^T$ we have \[{claim} .\]"
    assert [one.green for one in verdicts(text).values()] == [green]
    assert roles(text)["f=(1,2)^T"] == DEFINITION


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\dot N=[R,N]", True),
        (r"\dot N=[N,R]", False),
        (r"\operatorname{tr}N=2(x^2+y^2)+\tfrac12c^2", True),
        (r"\operatorname{tr}N=2(x^2+y^2)-\tfrac12c^2", False),
        (r"\operatorname{tr}W^+W^-=\operatorname{tr}N", True),
        (r"\operatorname{tr}W^+W^-=\operatorname{tr}W^+\operatorname{tr}W^-", False),
    ],
)
def test_what_is_made_of_matrices_is_one(claim, green):
    text = (
        TURN
        + rf"As $\operatorname{{tr}}S=x-x$, put $W^\pm=S\pm cR$ and $N=W^+W^-$. Then \[{claim} .\]"
    )
    assert [one.green for one in verdicts(text).values()] == [True, green]


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"G_1=0,\qquad G_2=x^2+y^2", True),
        (r"G_1=0,\qquad G_2=2x^2+2y^2", False),
        (r"\dot G_2=0", True),
        (r"T_1+x=3+x,\qquad T_2=-x", True),
        (r"T_1+x=2+x,\qquad T_2=x", False),
    ],
)
def test_the_traces_of_powers_are_read_for_each_exponent(claim, green):
    text = TURN + (
        r"Let $A=\mathrm{diag}(1,2)$ and \[G_k=\frac1k\operatorname{tr}S^k,\qquad T_k=\operatorname{tr}(AS^{k-1}),\qquad k=1,2.\] "
        rf"Then \[{claim} .\]"
    )
    found = [one.green for one in verdicts(text).values()]
    assert found and all(found) == green


def test_a_letter_that_is_used_as_a_number_is_one():
    text = (
        r"The motion is \[\dot x=y,\qquad \dot y=-x.\] At $c=(x,y)$ we have \[c\,x=c^2+\dot y .\]"
    )
    assert not any(one.green for one in verdicts(text).values())
