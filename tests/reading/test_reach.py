"""How far a sine reaches: to an angle that moves, or over a bracket with the time."""

import pytest

from kowalevski_cas.reading.reach import with_reach
from kowalevski_cas.source.displays import TypedFormula
from tests.reading.test_reading import verdicts


def dotted(tex, moving):
    (found,) = with_reach([TypedFormula(tex, 0, len(tex), "$")], moving)
    return found.tex


@pytest.mark.parametrize(
    "printed, read",
    [
        (r"\sin\theta(a-b)", r"\sin\theta\cdot(a-b)"),
        (r"\cos^2\theta\left(a\cos\theta-(b)\right)c", r"\cos^2\theta\cdot\left(a\cos\theta-(b)\right)c"),
        (r"\sin\omega(t-t_0)+1", r"\sin(\omega(t-t_0))+1"),
        (r"\cos2k\left(x-ct\right)", r"\cos(2k\left(x-ct\right))"),
        (r"\sin a(b-c)", r"\sin a(b-c)"),
        (r"\sin\theta(t)", r"\sin\theta(t)"),
        (r"\sin\omega(t", r"\sin\omega(t"),
    ],
)  # fmt: skip
def test_reach(printed, read):
    assert dotted(printed, {r"\theta"}) == read


GEODESICS = r"""The geodesics obey \[ \frac{d^2u}{ds^2}=\sin u\cos u\left(\frac{dv}{ds}\right)^2,\qquad
\frac{d}{ds}\left(\sin^2u\frac{dv}{ds}\right)=0 . \] """


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_a_quotient_of_differentials_is_a_factor_and_no_differential_form(sign, green):
    form = rf"\left(\frac{{du}}{{ds}}\right)^2{sign}\sin^2u\left(\frac{{dv}}{{ds}}\right)^2"
    found = verdicts(GEODESICS + rf"Hence ${form}$ is constant.")
    assert [one.green for one in found.values()] == [green]
