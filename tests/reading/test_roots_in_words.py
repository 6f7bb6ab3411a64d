"""What words call the roots of an equation for a letter are these."""

import pytest

from tests.reading.test_reading import verdicts

MOTION = r"The motion is $$\dot x=y,\qquad\dot y=-x.$$ Put $s=x+y$, $p=xy$. "
MAP = r"""Consider the map $$x'=y,\qquad y'=-x+\frac{2ay}{1+y^2}.$$ Put
$$I=x^2y^2+x^2+y^2-2axy.$$ For a given $y$ the numbers $x$ and $y'$ are the roots of the same quadratic
equation $$(1+y^2)\xi^2-2ay\xi+y^2-I=0.$$"""


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("Then $x$ and $y$ are the roots of the equation $$z^2-sz+p=0.$$", True),
        ("Then $x$ and $y$ are the roots of the equation $$z^2+sz+p=0.$$", False),
        ("Then $x$, $y$ are the two roots of the quadratic polynomial $z^2-sz+2p=0$.", False),
        ("Then $x$ is a root of the equation $z^2-sz+p=0$.", True),
        ("Then $2x$ is a root of the equation $z^2-sz+p=0$.", False),
        ("Then $x$ and $2y$ are the roots of the equation $z^2-sz+p=0$.", False),
        ("Тогда $x$ и $y$ суть корни уравнения $$z^2-sz+p=0.$$", True),
        ("Тогда $x$ и $y$ суть корни уравнения $$z^2-sz-p=0.$$", False),
    ],
)
def test_roots_that_words_name(words, green):
    assert [one.green for one in verdicts(MOTION + words).values()] == [green]


def test_an_image_may_be_a_root():
    assert [*verdicts(MAP).values()][-1].green
    assert not [*verdicts(MAP.replace("-2ay", "-ay")).values()][-1].green
