r"""Complex names with names for their real parts, as :math:`z=x+iy`: the parts move as z says."""

import random

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected", "here")


@FEW
def test_the_parts_of_a_linear_equation_move_by_real_ones(seed):
    """Of z' = (a+ib)z the parts have the rates ax-by and bx+ay; of the conjugate the other sign."""
    chance = random.Random(seed)
    a, b = chance.randint(-3, 3), chance.choice([-2, -1, 1, 3])
    z = chance.choice(["z", "w", r"\zeta", "z_1"])
    x, y = chance.choice([("x", "y"), ("u_1", "u_2"), (r"\xi", r"\eta")])
    names = chance.choice(
        [f"{z}={x}+i{y}", f"{x}+i{y}={z}", f"{z}={x}+{y}i", rf"{z}={x}+\mathrm iy".replace("y", y)]
    )
    barred = chance.random() < 0.5
    rate = rf"\frac{{d\bar {z}}}{{dt}}" if barred else rf"\dot {z}"
    right = rf"({a}{b:+}i)" + (rf"\bar {z}" if barred else z)
    law = System(rf"{rate}={right},\quad {names}")
    b = -b if barred else b
    assert law.identity(rf"\dot {x}={a}{x}{-b:+}{y}").verdict == "proved"
    assert law.identity(rf"\dot {y}={b}{x}{a:+}{y}").verdict == "proved"
    assert law.identity(rf"\dot {x}={a}{x}{b:+}{y}").verdict == "refuted"
    assert law.identity(rf"|{z}|^2={x}^2+{y}^2").verdict == "proved"
    assert law.identity(rf"{z}^2={x}^2+{y}^2").verdict == "refuted"


def test_parts_that_move_by_themselves_stay_variables():
    law = System(r"\dot x=-y,\quad\dot y=x,\quad z=x+iy")
    assert law.scene.variables == ("x", "y")
    assert law.identity(r"\dot z=iz").verdict == "proved"
    assert law.identity(r"\dot z=-iz").verdict == "refuted"


def test_parts_of_a_function_and_another_time():
    law = System(
        r"2u''-hu=0,\quad {}'=\frac{d}{d\tau},\quad x+iy=u^2,\quad u=u_1+iu_2,\quad dt=|u|^2d\tau"
    )
    assert law.scene.time == r"\tau"
    assert law.identity("x=u_1^2-u_2^2").verdict == "proved"
    assert law.identity("y=u_1u_2").verdict == "refuted"
    assert law.identity("t'=u_1^2+u_2^2").verdict.green
    assert law.integral("u_1u_2'-u_2u_1'").verdict.green
    assert law.integral("u_1u_2'+u_2u_1'").verdict == "refuted"
    with pytest.raises(ValueError, match="is a law"):
        System(r"x''=-x,\quad {}'=\frac{d}{d\tau}").where(r"dt=r\,d\tau")


def test_a_letter_i_that_is_no_unit_is_refused():
    with pytest.raises(ValueError, match="imaginary unit"):
        System(r"\dot x=ix,\quad \dot y=iy+x")
