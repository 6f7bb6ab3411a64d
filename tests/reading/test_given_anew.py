"""A function of the law that is given once more: nothing is claimed against what was given first."""

import pytest

from tests.reading.test_reading import reading, roles, verdicts
from tests.sample import sampled

CENTRAL = r"""The Lagrangian is \[ L=\frac m2(\dot r^2+r^2\dot\varphi^2)-V(r) , \] and
$\ell=mr^2\dot\varphi$ is an integral. Let $V(r)=-k/r$. Then
\[ m\ddot r=\frac{\ell^2}{mr^3}-\frac k{r^2} . \] """
ANEW = [
    r"Let now $V(r)=\frac12kr^2$.",
    r"Consider next \[ V(r)=\frac12kr^2 . \]",
    r"\section{The oscillator} For $V(r)=\frac12kr^2$ the orbits are closed.",
]


@pytest.mark.parametrize("words", sampled(ANEW, 2))
@pytest.mark.parametrize("force", [r"kr", r"\frac k{r^2}"])
def test_what_is_said_behind_it_is_not_judged(words, force):
    claim = rf"m\ddot r=\frac{{\ell^2}}{{mr^3}}-{force}"
    read = reading(rf"{CENTRAL} {words} Then \[ {claim} . \]")
    *_, anew, behind = read.formulas
    assert anew.claim is None and anew.role.kind == "given anew"
    assert behind.claim is None and "once more" in behind.message


def test_a_force_that_rests_on_a_free_function_may_be_given_later():
    text = (
        CENTRAL.partition("Let")[0]
        + r"""Let $F(r)=-V'(r)$ be the force. Then
\[ m\ddot r=\frac{\ell^2}{mr^3}+F(r) . \] Let the force be $F(r)=-\alpha r^3$. Then
\[ m\ddot r=\frac{\ell^2}{mr^3}+\alpha r^3 . \]"""
    )
    assert [one.green for one in verdicts(text).values()] == [True, True]


@pytest.mark.parametrize(
    ("words", "role"),
    [
        (r"Let again $V(r)=-k/r$.", "claim"),
        (r"Hence, with the above, we obtain $V(r)=\frac12kr^2$.", "claim"),
    ],
)
def test_the_same_formula_and_what_is_deduced_are_claims(words, role):
    found = roles(CENTRAL + words)
    assert [*found.values()][-1] == role
