"""What moves and is a rate says how that moves of which it is one, also among words."""

import pytest

from tests.reading.test_reading import verdicts

RICCATI = r"The Riccati equation is \[ \dot y=y^2+t . \] "
SPIN = r"The spin obeys \[ \dot r=-kr . \] "
FIELD = (
    r"The velocity obeys \[ \dot{\mathbf v}=\mathbf v\times\mathbf B \] with constant $\mathbf B$. "
)


@pytest.mark.parametrize(
    ("text", "greens"),
    [
        (RICCATI + r"Put $y=-\dot u/u$. Then $\ddot u+tu=0$.", [True]),
        (RICCATI + r"Put $y=-\dot u/u$. Then $\ddot u-tu=0$.", [False]),
        (RICCATI + r"The substitution $y=-\frac{\dot u}{u}$ gives \[ \ddot u=-tu . \]", [True]),
        (SPIN + r"For the angle $r=\dot\psi$ we have $\ddot\psi=-k\dot\psi$.", [True]),
        (SPIN + r"For the angle $r=\dot\psi$ we have $\ddot\psi=k\dot\psi$.", [False]),
        (SPIN + r"Let $r=\dot\psi$. Then $r+k\psi$ is constant.", [True]),
        (SPIN + r"Let $r=\dot\psi$. Then $r-k\psi$ is constant.", [False]),
        (
            FIELD + r"Here $\mathbf v=\dot{\mathbf r}$. Then $\mathbf v+\mathbf B\times\mathbf r$ "
            r"is conserved.",
            [True],
        ),
    ],
)
def test_it_is_an_equation_of_motion(text, greens):
    assert [one.green for one in verdicts(text).values()] == greens


@pytest.mark.parametrize(("value", "green"), [("-1/t", True), ("1/t", False)])
def test_a_coordinate_alone_solves_what_was_proved_for_it(value, green):
    law = r"The system \[ \dot q=p,\qquad \dot p=2q^3+tq+1 \] implies $\ddot q=2q^3+tq+1$. "
    found = verdicts(law + rf"A solution is $q={value}$.")
    assert [one.green for one in found.values()] == [True, green]


def test_it_solves_nothing_where_that_was_false():
    law = r"The system \[ \dot q=p,\qquad \dot p=2q^3+tq-1 \] implies $\ddot q=2q^3+tq+1$. "
    assert not any(one.green for one in verdicts(law + r"A solution is $q=-1/t$.").values())


@pytest.mark.parametrize(("claim", "green"), [(r"\ddot q=a", True), (r"\ddot q=-a", False)])
def test_a_letter_that_is_a_rate_is_a_constant(claim, green):
    text = r"The equations of motion are \[ \dot q=p,\qquad\dot p=a . \] Then \[ %s . \]"
    assert [one.green for one in verdicts(text % claim).values()] == [green]
