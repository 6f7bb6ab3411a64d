r"""Letters with bars and other accents: a bar makes a new name where an equation gives it and nothing is complex, or a conjugate."""

import pytest

from kowalevski_cas.reading.bars import with_bars
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)

TURNING = r"We consider the equations \[\dot x=y,\qquad\dot y=-x.\] "
GIVEN = (
    r"In the new variables \[\bar x=x+y,\qquad\bar y=x-y\] we have $@$.",
    r"Put $\bar x=x+y$ and $\bar y=x-y$. Then \[@.\]",
    r"The letter $\bar x$ is used for a sum: $\bar x=x+y$, $\bar y=x-y$. Hence $@$.",
)


@pytest.mark.parametrize("words", GIVEN)
@pytest.mark.parametrize("tex", [r"\dot{\bar x}=-\bar y", r"\dot{\bar x}=\bar y"])
@pytest.mark.parametrize("mark", [r"\bar", r"\tilde", r"\overline"])
def test_what_has_a_new_name_is_judged_with_any_mark(words, tex, mark):
    found = verdicts(TURNING + words.replace("@", tex).replace(r"\bar", mark))
    assert [one.green for one in found.values()] == ["-" in tex]


def test_two_of_them_are_names_beside_complex_constants():
    law = r"Let $a$ be a complex parameter. We have \[ \dot q=p,\qquad \dot p=a . \] "
    new = r"Put \[ \bar q=q-p,\qquad \bar p=p,\qquad\bar a=-a . \] "
    assert verdicts(law + new + r"Then \[\dot{\bar q}=\bar p+\bar a.\]").popitem()[1].green
    assert not verdicts(law + new + r"Then \[\dot{\bar q}=\bar p-\bar a.\]").popitem()[1].green


def test_what_has_no_bar_is_judged_beside_it():
    found = verdicts(TURNING + GIVEN[0].replace("@", r"\dot x=y") + " $x^2+y^2$ is an integral.")
    assert found["x^2+y^2"].green


@pytest.mark.parametrize(("function", "green"), [(r"z\bar z", True), (r"z^2\bar z", False)])
def test_a_conjugate_is_one_still(function, green):
    text = rf"Let \[\dot z=iz.\] The function ${function}$ is an integral. For real $a$ let $\bar z=a$."
    assert verdicts(text)[function].green == green


@pytest.mark.parametrize("accent", [r"\bar", r"\tilde", r"\hat", r"\overline"])
@pytest.mark.parametrize("k", ["2", "", "3"])
def test_images_may_be_printed_with_an_accent(accent, k):
    image = accent + " "
    text = (
        rf"Consider the map \begin{{equation}}\label{{fix}}"
        rf"{image}x=y,\qquad {image}y=-x+\frac{{2ay}}{{1+y^2}}.\end{{equation}}"
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
