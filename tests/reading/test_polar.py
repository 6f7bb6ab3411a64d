"""Polar coordinates: printed or named by words, with a radius that is given before or not."""

from itertools import product

import pytest

from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

FORCES = {
    "of the radius": (
        r"\[ \ddot x=-\frac{kx}{r^3},\qquad\ddot y=-\frac{ky}{r^3}, \] where $r=\sqrt{x^2+y^2}$. ",
        r"\ddot r-r\dot\theta^2=-\frac k{r^2}", r"r\ddot\theta+2\dot r\dot\theta=0",
    ),
    "of its square": (
        r"\[ \ddot x=-\frac{kx}{r^3},\qquad\ddot y=-\frac{ky}{r^3},\qquad r^2=x^2+y^2 . \] ",
        r"\ddot r-r\dot\theta^2=-\frac k{r^2}", r"r\ddot\theta+2\dot r\dot\theta=0",
    ),
    "of a root": (
        r"\[ \ddot x=-\frac{kx}{(x^2+y^2)^{3/2}},\qquad\ddot y=-\frac{ky}{(x^2+y^2)^{3/2}} . \] ",
        r"\ddot r-r\dot\theta^2=-\frac k{r^2}", r"r\ddot\theta+2\dot r\dot\theta=0",
    ),
    "of first order": (
        r"\[ \dot x=kx-y-x(x^2+y^2),\qquad\dot y=x+ky-y(x^2+y^2) . \] ",
        r"\dot r=kr-r^3", r"\dot\theta=1",
    ),
}  # fmt: skip
COORDINATES = [
    r"In polar coordinates $x=r\cos\theta$, $y=r\sin\theta$ they become",
    r"In polar coordinates the equations become",
    r"Passing to polar coordinates $(r,\theta)$ we find",
    r"Let us introduce polar coordinates. Then",
    r"В полярных координатах получаем",
]
CASES = [*product(FORCES, COORDINATES)]


@pytest.mark.parametrize("force, coordinates", sampled(CASES, 6))
def test_equations_of_motion_become_those_of_polar_coordinates(force, coordinates):
    law, radial, angular = FORCES[force]
    text = rf"The equations of motion are {law}{coordinates} \[ {radial},\qquad {angular} . \]"
    found = [*verdicts(text).values()]
    assert len(found) == 2 and all(one.green for one in found)


@pytest.mark.parametrize("force, coordinates", sampled(CASES, 6))
def test_a_misprint_in_polar_coordinates_is_not_green(force, coordinates):
    law, radial, angular = FORCES[force]
    wrong = radial.replace("=-", "=", 1).replace("=k", "=2k", 1)
    text = rf"The equations of motion are {law}{coordinates} \[ {wrong},\qquad {angular} . \]"
    first, second = verdicts(text).values()
    assert not first.green and second.green
    if r"\cos" not in coordinates:  # the angle may be counted otherwise
        assert first.value == "undecided"


def test_spheres_have_a_radius():
    law = r"\[ \ddot x=-\frac x{\sqrt{x^2+y^2+z^2}},\quad\ddot y=-\frac y{\sqrt{x^2+y^2+z^2}},\quad\ddot z=-\frac z{\sqrt{x^2+y^2+z^2}} . \] "
    put = r"In spherical coordinates $x=r\sin\theta\cos\varphi$, $y=r\sin\theta\sin\varphi$, $z=r\cos\theta$ we find "
    right = r"\[ \ddot r-r\dot\theta^2-r\sin^2\theta\,\dot\varphi^2=-1 . \]"
    assert [one.green for one in verdicts(law + put + right).values()] == [True]
    wrong = right.replace("=-1", "=1")
    assert not any(one.green for one in verdicts(law + put + wrong).values())


@pytest.mark.parametrize(
    "words",
    [
        "As another example consider, in polar coordinates,",
        "The unperturbed problem is in polar coordinates",
        r"In polar coordinates, with the angle measured from the vertical,",
    ],
)
def test_another_system_in_polar_coordinates_is_not_the_same(words):
    law, radial, angular = FORCES["of first order"]
    wrong = radial.replace("=", "=2")
    found = reading(rf"Let {law}{words} \[ {wrong},\qquad {angular} . \]")
    claims = [one for one in found.formulas if one.claim is not None]
    assert not claims


def test_a_root_without_words_for_a_radius_has_either_sign():
    law = r"\[ \dot x=y+\sqrt{x^2+y^2},\qquad\dot y=-x . \] "
    put = r"With $x=\rho\cos\theta$, $y=\rho\sin\theta$ we find \[ \dot\rho=\rho\cos\theta . \]"
    assert not any(one.green for one in verdicts(law + put).values())
    said = put.replace("With", "With polar coordinates")
    assert [one.green for one in verdicts(law + said).values()] == [True]
