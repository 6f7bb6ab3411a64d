r"""Where no prime derives, a bold letter with one is another vector, as in a frame that turns."""

import pytest

from tests.reading.test_reading import roles, verdicts

TABLE = r"""A table turns with $\dot\beta=\nu$, so that
\[\mathbf u=Q\,\mathbf u',\qquad Q=\begin{pmatrix}\cos\beta&-\sin\beta&0\\ \sin\beta&\cos\beta&0\\ 0&0&1\end{pmatrix}.\]
In the coordinates $\mathbf u'=(a',b',c')$ of the table the square of the velocity is """


@pytest.mark.parametrize(
    ("claimed", "true"),
    [
        (r"(\dot{a'}-\nu b')^2+(\dot{b'}+\nu a')^2+\dot{c'}^2", True),
        (r"\dot{a'}^2+\dot{b'}^2+\dot{c'}^2+2\nu(a'\dot{b'}-b'\dot{a'})+\nu^2(a'^2+b'^2)", True),
        (r"(\dot{a'}+\nu b')^2+(\dot{b'}+\nu a')^2+\dot{c'}^2", False),
        (r"(\dot{a'}-\nu b')^2+(\dot{b'}+\nu a')^2", False),
    ],
)
def test_the_velocity_in_a_frame_that_turns(claimed, true):
    found = verdicts(TABLE + rf"\[\dot{{\mathbf u}}^2={claimed} .\]")
    assert [one.green for one in found.values()] == [true]


def test_a_prime_that_derives_makes_no_other_vector():
    found = roles(r"The equation of motion is \[\mathbf u'=\mathbf a\times\mathbf u\]")
    assert found == {r"\mathbf u'=\mathbf a\times\mathbf u": "law"}


def test_a_string_has_no_other_vector():
    text = (
        r"The string obeys \[\ddot{\mathbf r}=a\mathbf r''.\] With $\dot{\mathbf r}'$ we have "
        r"\[\mathbf r'\cdot\dot{\mathbf r}=0.\]"
    )
    assert not {"proved", "refuted"} & {one.value for one in verdicts(text).values()}
