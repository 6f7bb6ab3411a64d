r"""A rate with either sign of a root, as :math:`\dot x=\pm\sqrt{h-x^2}`, has one of the two."""

from itertools import product

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

LAWS = (
    (r"Let \[\dot x=y,\qquad\dot y=-x.\] ", "x^2+y^2", "F-x^2", "F-y^2"),
    (
        r"The equations are \[\dot x=y,\quad\dot y=x-x^3.\] ",
        r"\frac12y^2-\frac12x^2+\frac14x^4", r"2F+x^2-\frac12x^4", r"2F+x^2+\frac12x^4",
    ),
)  # fmt: skip
"""Equations, an integral, the square of the first rate by it, and what is not."""
WORDS = (
    "With $F=T$ we have $X$.", r"Let $F=T$. Then \[X.\]", "По интегралу $F=T$ находим $X$.",
)  # fmt: skip


@pytest.mark.parametrize(
    ("law", "words", "rate"), sampled(product(LAWS, WORDS, (r"\dot x", r"\frac{dx}{dt}")), 3)
)
def test_one_sign_of_a_root_holds(law, words, rate):
    equations, integral, true, false = law
    for square, green in ((true, True), (false, False)):
        tex = rf"{rate}=\pm\sqrt{{{square}}}"
        found = verdicts(equations + words.replace("T", integral).replace("X", tex))
        assert found.pop(tex).green == green


def test_without_the_other_sign_a_root_has_one():
    text = LAWS[0][0] + r"With $F=x^2+y^2$ we have $\dot x=\sqrt{F-x^2}$."
    assert not verdicts(text)[r"\dot x=\sqrt{F-x^2}"].green


@pytest.mark.parametrize("tex", [r"\dot x=\pm xy", r"\dot x=\pm2xy"])
def test_a_term_has_one_of_two_signs(tex):
    law = r"Let \[\dot x=yz,\qquad\dot y=-2xz,\qquad\dot z=xy.\] "
    found = verdicts(law + f"On the surface $x^2=z^2$ we have ${tex}$.")[tex]
    assert found is not Verdict.REFUTED and not found.green
