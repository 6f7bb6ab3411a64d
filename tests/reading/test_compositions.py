r"""Maps given by tuples, and what is said of them as maps: compositions, inverses, derivatives."""

import pytest

from kowalevski_cas.reading import DEFINITION, LAW
from tests.reading.test_reading import reading, roles, verdicts

MAP = r"""Consider the map \[T:(u,v)\mapsto\Bigl(v,\,\frac{c+v}{u}\Bigr) .\]
Put $P(u,v)=(v,u)$ and $Q(u,v)=\bigl(u,(c+u)/v\bigr)$. """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"Q\circ Q=\mathrm{id}", True),
        (r"Q^2=\mathrm{id}", True),
        (r"T\circ T=\mathrm{id}", False),
        (r"T=Q\circ P", True),
        (r"T=P\circ Q", False),
        (r"T^{-1}(u,v)=\Bigl(\frac{c+u}{v},\,u\Bigr)", True),
        (r"T^{-1}(u,v)=\Bigl(\frac{c+v}{u},\,u\Bigr)", False),
        (r"\det DT=\frac{c+v}{u^2}", True),
        (r"\det DT=\frac{c+v}{u}", False),
        (r"DT=\begin{pmatrix}0&1\\-(c+v)/u^2&1/u\end{pmatrix}", True),
        (r"DT=\begin{pmatrix}0&1\\(c+v)/u^2&1/u\end{pmatrix}", False),
    ],
)
def test_what_is_said_of_maps(claim, green):
    found = verdicts(MAP + rf"Then \[{claim} .\]")
    assert [one.green for one in found.values()] == [green]


def test_the_inverse_of_a_reversible_map():
    text = MAP + r"The inverse is \[T^{-1}(u,v)=\Bigl(\frac{c+u}{v},\,u\Bigr),\] and "
    good = verdicts(text + r"\[P\circ T\circ P=T^{-1} .\]")
    bad = verdicts(text + r"\[P\circ T\circ Q=T^{-1} .\]")
    assert [one.green for one in good.values()] == [True, True]
    assert [one.green for one in bad.values()] == [True, False]


@pytest.mark.parametrize(
    ("function", "green"),
    [(r"\frac{(1+u)(1+v)(c+u+v)}{uv}", True), (r"\frac{(1+u)(1+v)(c+u-v)}{uv}", False)],
)
def test_a_function_of_images(function, green):
    text = MAP + rf"Let \[J(u,v)={function} .\] Then \[J\circ T=J .\]"
    found = [*verdicts(text).values()]
    assert found[-1].green is green


def test_a_map_by_an_arrow_is_a_law_and_others_are_definitions():
    found = roles(MAP)
    assert [*found.values()].count(LAW) == 2
    assert found["P(u,v)=(v,u)"] == DEFINITION


@pytest.mark.parametrize(("value", "green"), [("w", True), ("-w", False)])
def test_a_fixed_point_is_its_own_image(value, green):
    text = MAP + rf"Let $w>0$ and $c=w^2-w$. A fixed point is \[u=w,\qquad v={value} .\]"
    found = [*verdicts(text).values()]
    assert found and all(one.green for one in found) is green


def test_what_is_no_map_is_left_as_it_is():
    text = r"The motion is \[\dot x=y,\qquad \dot y=-x .\] The angle is $30^\circ$, and $F(x,y)=x^2+y^2$ is an integral."
    assert not any(law.images for law in reading(text).parts.laws)
    assert [one.green for one in verdicts(text).values()] == [True]
