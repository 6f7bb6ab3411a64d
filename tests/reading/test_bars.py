"""Letters with bars and other accents: images under maps, or complex conjugates."""

import pytest

from kowalevski_cas.reading.bars import with_bars
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)


@pytest.mark.parametrize("accent", [r"\bar", r"\tilde", r"\hat", r"\overline"])
@pytest.mark.parametrize("k", ["2", "", "3"])
def test_images_may_be_printed_with_an_accent(accent, k):
    image = accent + " "
    text = (
        rf"Consider the map \[{image}x=y,\qquad {image}y=-x+\frac{{2ay}}{{1+y^2}}.\]"
        rf" The function $I=x^2+y^2+x^2y^2-{k}axy$ is an integral."
    )
    (verdict,) = verdicts(text).values()
    assert (verdict in GREEN) is (k == "2")


def test_images_are_solved_for_where_equations_give_them_together():
    text = (
        r"Kahan's map is given by \[\frac{\tilde x-x}{h}=\frac{y+\tilde y}{2},\qquad"
        r" \frac{\tilde y-y}{h}=6x\tilde x-a .\] It is solved by"
        r" \[\tilde x=\frac{x+hy-\frac12ah^2}{1%s3h^2x}.\]"
    )
    assert [*verdicts(text % "-").values()][-1] in GREEN
    assert [*verdicts(text % "+").values()][-1] not in GREEN


def test_a_second_map_with_another_accent_is_another_one():
    text = (
        r"Consider the map \[\bar x=y,\qquad \bar y=-x+\frac{2ay}{1+y^2}.\] It has the integral"
        r" $x^2+y^2+x^2y^2-2axy$. Another map is \[\tilde x=y,\qquad \tilde y=-x.\]"
    )
    found = reading(text)
    assert [len(law.images) for law in found.parts.known[0].laws] == [2, 2]


@pytest.mark.parametrize(
    "text",
    [
        r"$x_2=\bar x_1$ are complex, $\bar x=y$",
        r"$z=x+iy$ and $\bar z=x-iy$",
        r"$\bar q=q$ is real",
        r"$|z|^2=z\bar z$",
        r"$\bar x_1=x_2$ and $e^{i\varphi}$",
    ],
)
def test_conjugates_stay_what_they_are(text):
    formulas = [TypedFormula(one, 0, len(one), "$") for one in text.split("$")[1::2]]
    assert [*with_bars(formulas, text)] == formulas
