r"""What a quadrature says: that the square of the velocity is what stands below it."""

import pytest

from kowalevski_cas.reading.quadratures import without_quadrature
from tests.reading.test_reading import verdicts

DUFFING = r"""Consider the equation \[\ddot x=-kx-\beta x^3 .\] Multiplying by $\dot x$ and integrating we get
\[\dot x^2=2h-kx^2-\tfrac12\beta x^4 .\] Hence """


@pytest.mark.parametrize(
    "quadrature",
    [
        r"t-t_0=\int\frac{dx}{\sqrt{2h-kx^2-B x^4}}",
        r"t=\pm\int\frac{dx}{\sqrt{2h-kx^2-B x^4}}+\mathrm{const}",
        r"t=\int_0^x\frac{\mathrm{d}u}{\sqrt{2h-ku^2-B u^4}}",
        r"\int_{x_0}^x\frac{d\xi}{\sqrt{4h-2k\xi^2-2B \xi^4}}=\pm\frac{1}{\sqrt2}(t-t_0)",
        r"t=\int_0^x\frac{dx'}{\sqrt{2h-kx'^2-Bx'^4}}",
        r"t=\int\frac{x\,dx}{\sqrt{x^2(2h-kx^2-B x^4)}}",
        r"t+c=\sqrt2\int\limits_0^x\frac{dx}{\sqrt{4h-2kx^2-2Bx^4}}",
    ],
)
def test_a_quadrature_by_the_time_gives_the_square_of_the_velocity(quadrature):
    true, false = (quadrature.replace("B", b) for b in (r"\tfrac12\beta ", r"\beta "))
    assert [one.green for one in verdicts(rf"{DUFFING}\[{true} .\]").values()] == [True, True]
    assert [one.green for one in verdicts(rf"{DUFFING}\[{false} .\]").values()] == [True, False]


@pytest.mark.parametrize(
    "other",
    [
        r"T=2\int_{-a}^a\frac{dx}{\sqrt{2h-x^2}}",
        r"W=\int\frac{dx}{\sqrt{2h-x^2}}",
        r"t=\int_0^1\frac{dx}{\sqrt{2h-x^2}}",
        r"t=\int\sqrt{2h-x^2}\,dx",
        r"t=\int\frac{dx}{\sqrt{2h-x^2}}+\int\frac{dy}{\sqrt y}",
        r"t=\int\frac{dx}{\sqrt{2h-x^2}",
        r"t=\int",
        r"\int_0^x=t",
    ],
)
def test_between_constants_of_other_names_and_torn_it_stays(other):
    assert without_quadrature(other, {"t"}) == other


CENTRAL = r"""The Lagrangian is \[ L=\frac m2(\dot r^2+r^2\dot\varphi^2)-V(r) , \] with the integrals
$\ell=mr^2\dot\varphi$ and \[ E=\frac m2\dot r^2+\frac{\ell^2}{2mr^2}+V(r) . \] Hence """


@pytest.mark.parametrize(
    "quadratures",
    [
        r"""t-t_0=\int_{r_0}^r\frac{dr}{\sqrt{\frac2m\left(E-V(r)-\frac{\ell^2}{Amr^2}\right)}},\qquad
\varphi-\varphi_0=\int_{r_0}^r\frac{\ell\,dr}{r^B\sqrt{2m\left(E-V(r)-\frac{\ell^2}{2mr^2}\right)}}""",
        r"""t-t_0=\int^r\frac{1}{\sqrt{\frac2m\left(E-V(r)-\frac{\ell^2}{Amr^2}\right)}}\,dr,\quad
\varphi=\varphi_0-\int^r\frac{\ell}{r^B}\frac{dr}{\sqrt{2m\left(E-V(r)-\frac{\ell^2}{2mr^2}\right)}}""",
    ],
)
def test_several_in_a_display_may_be_by_an_angle(quadratures):
    true = quadratures.replace("A", "2").replace("B", "{2}")
    false = quadratures.replace("A", "").replace("B", "{1}")
    for text, green in ((true, True), (false, False)):
        *_, by_time, by_angle = verdicts(rf"{CENTRAL}\[{text} .\]").values()
        assert by_time.green is by_angle.green is green
