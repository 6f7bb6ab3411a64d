r"""Maps of complex variables: :math:`z_{n+1}=e^{i\alpha}z_n` has conjugates, and so have papers.

What is true of them is written down by real parts; a map that took z for a real number would say
that z is its conjugate.
"""

import random

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW
from tests.reading.test_reading import verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")

FACTORS = [
    "i",
    "-i",
    r"e^{i\alpha}",
    r"e^{-2i\alpha}",
    r"\frac{3+4i}5",
    r"e^{i(\alpha+\beta|%s|^2)}",
]


def letters(chance):
    """A variable with its image."""
    letter = chance.choice(["z", "w", r"\zeta"])
    n = chance.choice(["n", "k", ""])
    return (f"{letter}_{n}", f"{letter}_{{{n}+1}}") if n else (letter, f"{letter}'")


def rotation(chance, factor):
    z, image = letters(chance)
    factor = factor.replace("%s", z)
    rows = [f"{image}={factor}{z}", "i^2=-1"]
    return z, System(",\\ ".join(rows), map=True)


@FEW
@pytest.mark.parametrize("factor", FACTORS)
def test_a_rotation_of_the_plane_keeps_the_circles(factor, seed):
    z, law = rotation(random.Random(seed), factor)
    assert law.integral(f"|{z}|^2").verdict == "proved"
    assert law.integral(rf"({z}\overline{{{z}}})^2").verdict == "proved"
    assert law.invariant(f"{z}=0").verdict == "proved"
    assert (
        law.identity(rf"\operatorname{{Re}}{z}=\frac{{{z}+\overline{{{z}}}}}2").verdict == "proved"
    )
    for false in (f"{z}", f"{z}^2", rf"\operatorname{{Re}}{z}", rf"{z}^2\overline{{{z}}}"):
        assert law.integral(false).verdict == "refuted", false
    for false in (rf"{z}=\overline{{{z}}}", rf"\operatorname{{Im}}{z}=0", rf"|{z}|^2={z}^2"):
        assert law.identity(false).verdict == "refuted", false


@FEW
def test_what_is_longer_is_no_rotation(seed):
    z, law = rotation(random.Random(seed), "2i")
    assert law.integral(f"|{z}|^2").verdict == "refuted"
    assert law.identity(rf"{z}=\overline{{{z}}}").verdict == "refuted"


def test_what_is_real_beside_it_stays_real():
    law = System(r"z_{n+1}=iz_n,\ r_{n+1}=2r_n,\ i^2=-1")
    assert law.identity(r"r_n=\overline{r_n}").verdict == "proved"
    assert law.identity(r"z_n=\overline{z_n}").verdict == "refuted"


def test_real_parts_are_those_of_what_is_mapped():
    law = System(r"z'=e^{i(\alpha+\beta|z|^2)}z,\ z=x+iy", map=True)
    assert law.integral("x^2+y^2").verdict == "proved"
    assert law.integral("x^2-y^2").verdict == "refuted"
    assert law.identity("y=0").verdict == "refuted"


def test_the_image_of_the_conjugate_follows():
    with pytest.raises(ValueError, match="follows"):
        System(r"z_{n+1}=iz_n,\ z^*_{n+1}=2z^*_n,\ i^2=-1")


@pytest.mark.parametrize("factor", ["i", r"e^{i\alpha}"])
@pytest.mark.parametrize(
    ("claim", "is_true"),
    [(r"z_n=\bar z_n", False), (r"|z_{n+1}|^2=|z_n|^2", True), (r"z_n+\bar z_n=0", False)],
)
def test_maps_of_papers_have_conjugates(factor, claim, is_true):
    text = rf"Consider the map $$z_{{n+1}}={factor}z_n,$$ where $i^2=-1$. Then we have $${claim}.$$"
    (verdict,) = verdicts(text).values()
    assert verdict.green == is_true


@pytest.mark.parametrize(
    "factor", [r"e^{z\bar z}", r"\cos(z\bar z)", r"\cos(|z|^2)", r"\sin(2|z|^2)"]
)
def test_functions_stand_at_the_length_of_a_complex_variable(factor):
    law = System(rf"i\dot z={factor}z,\ i^2=-1")
    assert law.integral(r"|z|^2").verdict == "proved"
    assert law.identity(rf"\frac{{d}}{{dt}}z^2=-2i{factor}z^2").verdict == "proved"
    assert law.identity(rf"\frac{{d}}{{dt}}z^2=2i{factor}z^2").verdict == "refuted"
    assert law.integral("z^2").verdict == "refuted"
    grows = System(rf"i\dot z={factor}z+iz,\ i^2=-1")
    assert grows.integral(r"|z|^2").verdict == "refuted"
    assert grows.identity(r"\frac{d}{dt}\sin|z|^2=2|z|^2\cos|z|^2").verdict == "proved"


def test_where_an_argument_vanishes_its_functions_are_known():
    law = System(r"\dot x=\sin(xy),\ \dot y=x\sin(xy)+1")
    assert law.invariant("x=0").verdict.green
    assert law.invariant("y=0").verdict == "refuted"
    assert System(r"\dot x=\cos(xy),\ \dot y=1").invariant("x=0").verdict == "refuted"
    assert System(r"\dot x=\cos(xy)-1,\ \dot y=1").invariant("x=0").verdict.green


@pytest.mark.parametrize(
    ("claim", "is_true"), [("|x_n|+|y_n|", True), ("|x_n|-|y_n|", False), ("|x_n|", False)]
)
def test_maps_keep_absolute_values(claim, is_true):
    law = System(r"x_{n+1}=-y_n,\ y_{n+1}=x_n")
    assert law.integral(claim).verdict == ("proved" if is_true else "refuted")


def test_the_map_of_lozi_contracts_areas():
    law = System(r"x_{n+1}=1-a|x_n|+y_n,\ y_{n+1}=bx_n")
    assert law.measure().verdict == "refuted"
    assert law.where("b=1").measure().verdict.green
    assert law.identity("x_{n+1}-y_n=1-a|x_n|").verdict == "proved"
    assert law.identity("x_{n+1}-y_n=1-ax_n").verdict == "refuted"


def test_no_complex_number_is_the_largest():
    law = System(r"i\dot z=z,\ r=|z|^2,\ i^2=-1")
    assert law.identity(r"\max(r,-1)=\max(-1,r)").verdict == "proved"
    for claim in (r"\max(z,\bar z)=z", r"\max(iz,1)=\max(1,iz)"):
        assert law.identity(claim).verdict == "error", claim


@pytest.mark.parametrize("bar", [r"\bar z_n", r"\overline{z_n}", r"\overline z_n"])
def test_a_bar_in_a_map_with_steps_is_a_conjugate(bar):
    law = System(rf"z_{{n+1}}=i{bar},\ i^2=-1")
    assert law.integral("|z_n|^2").verdict == "proved"
    assert law.integral(r"z_n^2").verdict == "refuted"
    assert law.identity(rf"z_n={bar}").verdict == "refuted"
