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
