r"""Values of the derivatives of functions, as :math:`V''(0)`."""

import pytest

from tests.reading.test_reading import verdicts

BEAD = r"""The bead moves by \[ \ddot\theta=n^2\sin\theta\cos\theta-m\sin\theta . \]
The potential is \[ F(\theta)=-\tfrac12n^2\sin^2\theta-m\cos\theta . \] """


@pytest.mark.parametrize(
    ("printed", "true"),
    [
        ("F'(0)=0", True),
        ("F''(0)=m-n^2", True),
        ("F''(0)=m+n^2", False),
        (r"F''(\pi)=-m-n^2", True),
        (r"F''(\pi)=m-n^2", False),
        (r"F'(\frac\pi2)+n=m+n", True),
        (r"F'(-\frac\pi2)+n=m+n", False),
    ],
)
def test_a_derivative_at_an_angle(printed, true):
    (found,) = verdicts(rf"{BEAD} We have \[ {printed} . \]").values()
    assert found.green is true


@pytest.mark.parametrize(
    ("printed", "true"),
    [
        ("f'(0)=1", True),
        ("f''(0)=2", True),
        ("f''(0)=1", False),
        ("f''(1)=(2-4a+a^2)e^{-a}", True),
        ("f''(1)=(2+4a+a^2)e^{-a}", False),
        ("f(1)=e^{-a}+1", True),
    ],
)
def test_a_function_of_its_own_argument(printed, true):
    text = r"The equation is \[ \ddot x=-x . \] Let $f(s)=s^2e^{-as}+s$. Then "
    assert verdicts(rf"{text} \[ {printed} . \]")[printed].green is true


def test_a_letter_in_an_index_is_no_function():
    text = r"""The equations are \[ \dot x=y,\qquad \dot y=-x . \] With $J=x^2+y^2$ let
    \[ V_J(s)=s^2+\frac{J}{s} . \] Then \[ V_J''(1)=2+2J,\qquad \dot J=0 . \]"""
    assert [one.green for one in verdicts(text).values()] == [True, True]
