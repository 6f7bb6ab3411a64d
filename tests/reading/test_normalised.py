r"""A coordinate t beside dots that derive by another variable, and the normalisation of that."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

METRIC = r"""Geodesics derive from the Lagrangian \[ L=\frac12\left[-\Bigl(1-\frac{2M}{r}\Bigr)\dot t^2
+\frac{\dot r^2}{1-2M/r}+r^2\dot\varphi^2\right], \] where the dot stands for $d/d\tau$. We have
the first integrals \[ \Bigl(1-\frac{2M}{r}\Bigr)\dot t=E,\qquad r^2\dot\varphi=h . \] """
RADIAL = r"\[ \dot r^2=E^2-\Bigl(1-\frac{2M}{r}\Bigr)\Bigl(1+\frac{h^2}{r^2}\Bigr) . \]"


@pytest.mark.parametrize(("factor", "green"), [(r"\Bigl(1-\frac{2M}{r}\Bigr)", True), ("", False)])
def test_t_is_a_coordinate_where_it_has_a_dot(factor, green):
    text = METRIC + rf"Hence \[ \frac{{d\varphi}}{{dt}}=\frac{{h}}{{Er^2}}{factor} . \]"
    assert [one.green for one in verdicts(text).values()] == [True, True, green]


@pytest.mark.parametrize(("factor", "green"), [("-2", True), ("-", False)])
def test_t_is_a_coordinate_where_all_is_derived_by_another_letter(factor, green):
    text = r"""The geodesics obey \[ \frac{d^2t}{ds^2}=-\frac2x\frac{dt}{ds}\frac{dx}{ds},\qquad
\frac{d^2x}{ds^2}=-x\left(\frac{dt}{ds}\right)^2 . \] An integral is \[ x^2\frac{dt}{ds} . \] Then """
    text += rf"\[ \frac{{d}}{{ds}}\left(x\frac{{dt}}{{ds}}\right)={factor}\frac{{dx}}{{ds}}\frac{{dt}}{{ds}}"
    text += r"+\frac{dx}{ds}\frac{dt}{ds} . \]"
    assert [one.green for one in verdicts(text).values()] == [True, green]


def test_the_time_may_be_printed_as_what_moves():
    text = r"Consider \[ \dot x=y,\quad \dot y=-x+\sin\omega t,\quad \dot t=1 . \] "
    found = verdicts(text + r"Then $\ddot x=-x+\sin\omega t$.")
    assert [*found.values()] == [Verdict.PROVED]


@pytest.mark.parametrize(
    "words",
    [
        "The normalisation of the four-velocity amounts to $2L=-1$.",
        "With the normalization $2L=-1$ everything becomes simple.",
        "Massive particles have $2L=-1$.",
        r"The normalisation is \[ -\Bigl(1-\frac{2M}{r}\Bigr)\dot t^2+\frac{\dot r^2}{1-2M/r}+r^2\dot\varphi^2=-1 . \]",
    ],
)
def test_words_suppose_a_normalisation(words):
    found = verdicts(METRIC + words + " Inserting the integrals we find " + RADIAL)
    assert [one.green for one in found.values()] == [True] * 3


@pytest.mark.parametrize(("value", "verdict"), [("-1", True), ("0", False)])
def test_light_has_another_normalisation(value, verdict):
    text = METRIC + rf"Light rays have $2L={value}$, hence " + RADIAL
    assert [one.green for one in verdicts(text).values()] == [True, True, verdict]


def test_it_holds_in_later_sections_but_for_light():
    equation = r"\[ \ddot r=%s\frac{h^2}{r^3}-\frac{3Mh^2}{r^4} . \] "
    text = METRIC + r"The normalisation is $2L=-1$. \section{Orbits} Then "
    text += equation % r"-\frac{M}{r^2}+"
    text += r"\section{Light} For photons, however, " + equation % ""
    *_, massive, light = verdicts(text).values()
    assert massive.green and light is Verdict.UNDECIDED


def test_nothing_is_refuted_where_none_is_printed():
    found = verdicts(METRIC + "As the proper time is the parameter, " + RADIAL)
    assert [*found.values()][-1] is Verdict.UNDECIDED


SURFACE = r"""Geodesics of the metric with $E=1$ and $G=f(u)^2$ obey \[ \ddot u=f(u)f'(u)\dot v^2,\qquad
\ddot v+\frac{2f'(u)}{f(u)}\dot u\dot v=0 . \] The quantity \[ c=f(u)^2\dot v \] is constant. """


@pytest.mark.parametrize(
    "words",
    [
        "Since the parameter is the arc length, we have besides",
        "As the geodesic is parametrised by its arc length, one has",
        "The parameter of the curve is its arc length, hence",
        "Поскольку параметр есть длина дуги, имеем",
    ],
)
def test_curves_by_their_length_have_unit_tangents(words):
    given = rf"{words} \[ \dot u^2+f(u)^2\dot v^2=1, \] and therefore "
    for law, green in ((r"\frac{c^2}{f(u)^2}", True), (r"\frac{c^2}{f(u)}", False)):
        text = SURFACE + given + rf"\[ \dot u^2+{law}=1 . \]"
        *_, found = verdicts(text).values()
        assert found.green == green and found is not Verdict.REFUTED


def test_the_profile_by_its_length_has_a_unit_tangent():
    text = (
        r"The curve $(f,g)$ is parametrised by its arc length, \[ f'(u)^2+g'(u)^2=1 . \] " + SURFACE
    )
    assert r"f' ^2+g' ^2=1" not in verdicts(text)
    for slope, green in ((r"g'(u)^2", True), (r"g'(u)", False)):
        claim = rf"Hence \[ \ddot u^2=f(u)^2\dot v^4\left(1-{slope}\right) . \]"
        assert [*verdicts(text + claim).values()][-1].green == green


@pytest.mark.parametrize(
    "text",
    [
        r"Since the parameter is the arc length, we find \[ f(u)\ddot v=1 . \]",
        r"Since the parameter is the arc length, we have \[ \dot u^2+f(u)^2\dot v^2=1, \] "
        r"and the elimination of $\dot v$ leads to \[ \dot u^2+\frac{c^2}{f(u)}=1 . \]",
    ],
)
def test_what_else_is_said_of_such_curves_is_claimed(text):
    *_, found = verdicts(SURFACE + text).values()
    assert not found.green
