"""What holds where accelerations vanish, as a drift or a terminal velocity: there something moves."""

import pytest

from tests.reading.test_reading import verdicts

DRIFT = r"The motion is $$\ddot x=-n\dot y+g,\qquad\ddot y=n\dot x.$$ "
FALL = r"The motion is $$m\ddot z=mg-b\dot z.$$ "


@pytest.mark.parametrize(
    "words",
    [
        r"The velocity of the drift is found from $\ddot x=\ddot y=0$,",
        r"If $\ddot x=0$ and $\ddot y=0$, then",
        r"При $\ddot x=\ddot y=0$ имеем",
    ],
)
def test_a_drift(words):
    found = verdicts(rf"{DRIFT} {words} $$\dot x=0,\qquad\dot y=\frac gn.$$")
    assert [one.green for one in found.values()] == [True, True]
    found = verdicts(rf"{DRIFT} {words} $$\dot x=0,\qquad\dot y=\frac{{2g}}n.$$")
    assert [one.value for one in found.values()][-1] == "undecided"


def test_a_terminal_velocity():
    text = rf"{FALL} The terminal velocity follows from $\ddot z=0$: $$\dot z=\frac{{mg}}b.$$"
    assert [one.green for one in verdicts(text).values()] == [True]
    false = text.replace("{mg}", "{2mg}")
    assert [one.value for one in verdicts(false).values()] == ["undecided"]


def test_accelerations_that_words_conclude_are_claimed():
    text = r"The motion is $$\ddot x=-x.$$ Hence $\ddot x=0$."
    assert [one.value for one in verdicts(text).values()] == ["refuted"]
