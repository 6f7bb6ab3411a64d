"""Motions on which something is constant, or an integral has a value, and what holds along them."""

import pytest

from tests.reading.test_reading import reading, verdicts

CENTRAL = r"""The motion is $$\ddot r=r\dot\varphi^2-\frac{k}{r^2},\qquad r\ddot\varphi=-2\dot r\dot\varphi.$$ """
TOP = r"""Let $$L=\frac A2(\dot\theta^2+\dot\varphi^2\sin^2\theta)+\frac C2(\dot\psi+\dot\varphi\cos\theta)^2
-P\cos\theta.$$ The coordinates $\varphi$ and $\psi$ are cyclic, hence $n=\dot\psi+\dot\varphi\cos\theta$ is
constant. If $\theta=\theta_0$ is constant and $\sin\theta_0\ne0$, then $\dot\varphi=\Omega$ is constant, too, and
$$A\Omega^2\cos\theta_0-Cn\Omega+P=0.$$"""


@pytest.mark.parametrize(
    "words",
    [
        r"If $r=a$ is constant, then $\dot\varphi=\omega$ with",
        r"For $r=a=\mathrm{const}$ we have $\dot\varphi=\omega$ and",
        r"On a circular orbit with radius $r=a$ we have $\dot\varphi=\omega$ and",
        r"Если $r=a$ постоянно, то $\dot\varphi=\omega$ и",
    ],
)
def test_along_a_motion_that_keeps_a_coordinate(words):
    found = [*verdicts(rf"{CENTRAL} {words} $$\omega^2a^3=k.$$").values()]
    assert [one.green for one in found] == [True]
    for wrong in (r"\omega^2a^2=k", r"\omega^2a^3=2k", r"\omega a^3=k"):
        found = [*verdicts(rf"{CENTRAL} {words} $${wrong}.$$").values()]
        assert [one.value for one in found] == ["undecided"]


def test_a_regular_precession():
    *_, last = verdicts(TOP).values()
    assert last.green
    for true, wrong in [("+P", "-P"), (r"Cn\Omega", r"Cn\Omega^2"), (r"A\Omega", r"2A\Omega")]:
        *_, last = verdicts(TOP.replace(true, wrong)).values()
        assert last.value == "undecided"


@pytest.mark.parametrize("words", ["Hence", "Initially", "We put"])
def test_other_words_keep_nothing(words):
    text = rf"{CENTRAL} {words} $r=a$. Then $$\dot\varphi^2a^3=k.$$"
    assert "kept" not in [one.role.kind for one in reading(text).formulas]
    assert not any(one.green for one in verdicts(text).values())


ENERGY = (
    r"""The motion is $$\ddot x=-x.$$ The energy $h=\frac12\dot x^2+\frac12x^2$ is constant. """
)


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"With $h=\frac12a^2$ we get $$\dot x^2=a^2-x^2.$$", True),
        (r"With $h=\frac12a^2$ we get $$\dot x^2=2a^2-x^2.$$", False),
        (r"If $h=2a^2$ and $x>0$, then $\dot x^2\le4a^2$.", True),
        (r"If $h=2a^2$ and $x>0$, then $\dot x^2\le a^2$.", False),
        (r"Let $h=\frac12a^2$. Then $$\dot x^2=a^2-x^2.$$", True),
        (r"Let $h=\frac12a^2$. Then $$\dot x^2=a^2+x^2.$$", False),
    ],
)
def test_a_value_that_is_supposed_of_an_integral(words, green):
    assert [one.green for one in verdicts(ENERGY + words).values()] == [True, green]


def test_values_of_several_integrals():
    text = rf"""{CENTRAL} The integrals are
    $$c=r^2\dot\varphi,\qquad h=\frac12(\dot r^2+r^2\dot\varphi^2)-\frac kr.$$ With $c=0$ and $h=-\frac k{{2a}}$ one has
    $$\dot r^2=\frac{{2k}}r-\frac ka.$$"""
    *_, last = verdicts(text).values()
    assert last.green
    *_, last = verdicts(text.replace(r"-\frac ka", r"+\frac ka")).values()
    assert not last.green


WITH_ENERGY = r"""A particle moves by \[\ddot r-r\dot\varphi^2=-\frac{\mu}{r^2},\qquad r\ddot\varphi+2\dot r\dot\varphi=0 .\]
With $l=r^2\dot\varphi$ the energy is \[E=\tfrac12(\dot r^2+r^2\dot\varphi^2)-\frac\mu r .\] """


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("On a circular orbit of radius $r$", True),
        ("For circular orbits we have", True),
        ("On every circular orbit", True),
        ("Circular orbits are stable. In general", False),
        ("For all orbits, as on a circular orbit,", False),
        ("Not only on circular orbits", False),
    ],
)
def test_on_circular_orbits_the_radius_is_constant(words, green):
    found = [*verdicts(rf"{WITH_ENERGY}{words} \[E=-\frac{{\mu}}{{2r}} .\]").values()][-1:]
    assert [one.green for one in found] == [green]
    found = [*verdicts(rf"{WITH_ENERGY}{words} \[E=-\frac{{\mu}}{{r}} .\]").values()][-1:]
    assert [one.green for one in found] == [False]
