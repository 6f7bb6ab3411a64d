"""Equilibria that words list: each is one, also where it is one for some constants only."""

import pytest

from tests.reading.test_reading import reading, verdicts

HOOP = r"The bead obeys \[\ddot\psi=(w^2\cos\psi-g/a)\sin\psi.\] "
LISTS = [
    r"Equilibria are $\psi=0$ and, for $w^2>g/a$, $\cos\psi={}$.",
    r"The positions of equilibrium are $\sin\psi=0$ and $\cos\psi={}$.",
    r"Положения равновесия суть $\psi=0$ и, при $w^2>g/a$, $\cos\psi={}$.",
]


@pytest.mark.parametrize("words", LISTS)
def test_each_of_them_is_claimed_by_itself(words):
    right, wrong = r"g/(aw^2)", r"g/(2aw^2)"
    assert verdicts(HOOP + words.replace("{}", right))[rf"\cos\psi={right}"].green
    found = verdicts(HOOP + words.replace("{}", wrong))
    assert not found.pop(rf"\cos\psi={wrong}").green
    assert all(one.green for one in found.values())


@pytest.mark.parametrize(
    "words",
    [
        r"Equilibria are $\psi=0$ and, for $w^2>g/a$, no longer $\cos\psi=g/(2aw^2)$.",
        r"The integral is $\psi$ and, for $w=0$, $\psi$ is not.",
    ],
)
def test_what_is_denied_behind_a_case_is_not_claimed(words):
    (*_, last) = reading(HOOP + words).formulas
    assert last.claim is None


def test_one_equilibrium_may_be_given_by_two_equations():
    text = r"""The bead obeys \[\ddot\psi=(1+\cos\psi)\cos\psi.\]
    There is the equilibrium $\sin\psi=0$ and $\cos\psi=-1$."""
    assert all(one.green for one in verdicts(text).values())


LORENZ = r"""The motion is \[ \dot x=s(y-x),\qquad\dot y=rx-y-xz,\qquad\dot z=xy-bz . \]
For $r<1$ the origin is the only equilibrium. If $r>1$, there are two more, \[ x=y=\pm\sqrt{b(r-1)},\qquad z=r%s . \]"""


@pytest.mark.parametrize(("last", "green"), [("-1", True), ("", False)])
def test_there_are_more_of_what_the_sentence_before_has(last, green):
    assert verdicts(LORENZ % last)[r"x=y=\pm\sqrt{b(r-1)}"].green == green


def test_more_integrals_are_no_points_of_rest():
    found = verdicts(
        LORENZ.partition("two more")[0] + r"two more integrals, \[ x=y,\qquad z=r . \]"
    )
    assert not any(one.green for one in found.values())
