r"""A vector that moves by an equation of its own, and its coordinates where this is written out."""

import pytest

from tests.reading.test_reading import verdicts

FIELD = r"""The motion of a charge in the field $\mathbf B=(0,0,B)$ is governed by
\[m\ddot{\mathbf r}=\frac ec\,\dot{\mathbf r}\times\mathbf B .\] """
ROWS = r"\[\ddot x=\omega\dot y,\qquad\ddot y=-\omega\dot x,\qquad\ddot z=0 .\]"


@pytest.mark.parametrize(
    "words", ["In components, with $\\omega=eB/mc$,", "With $\\omega=eB/mc$ this is"]
)
def test_its_coordinates_are_the_usual_ones(words):
    assert [one.green for one in verdicts(FIELD + words + ROWS).values()] == [True] * 3
    wrong = verdicts(FIELD + words + ROWS.replace("-", ""))
    assert [one.green for one in wrong.values()] == [True, False, True]


@pytest.mark.parametrize(
    ("rows", "greens"),
    [
        (r"$\dot x=yz$, $\dot y=-xz$, $\dot z=xy$", [True, True, True]),
        (r"$\dot x=yz$, $\dot y=-2xz$, $\dot z=xy$", [True, False, True]),
    ],
)
def test_a_sentence_may_write_out_what_it_gives(rows, greens):
    text = r"""Nambu's equations $\dot{\mathbf x}=\nabla F\times\nabla G$ with $F=\frac12(x^2+y^2)$,
    $G=\frac12(z^2-x^2)$ give """
    assert [one.green for one in verdicts(f"{text}{rows}.").values()] == greens


def test_another_system_has_letters_of_its_own():
    text = (
        FIELD
        + r"Now consider another system, \[\ddot x=-x,\qquad\ddot y=-y .\] It has the integral $x\dot y-y\dot x$."
    )
    assert [one.green for one in verdicts(text).values()] == [True]


SCALED = r"""The equations are \[\dot{\mathbf M}=\mathbf M\times\mathbf w+\mathbf g\times\mathbf r,\qquad
\dot{\mathbf g}=\mathbf g\times\mathbf w,\] where $\mathbf M=(Aw_1,Aw_2,Aw_3)$. They have the integrals """


@pytest.mark.parametrize("square", [r"(\mathbf g,\mathbf g)", r"\mathbf g^2"])
def test_an_integral_may_be_printed_with_a_number_for_its_value(square):
    text = rf"{SCALED}$F=(\mathbf M,\mathbf g)$ and $G={square}=1$."
    assert [one.green for one in verdicts(text).values()] == [True, True]
    assert not all(one.green for one in verdicts(text.replace(square, r"\mathbf M^2")).values())
