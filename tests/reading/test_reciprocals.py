import pytest

from kowalevski_cas.reading.reciprocals import with_reciprocals
from kowalevski_cas.source.displays import find_formulas

BEFORE = [*find_formulas("Let $u=1/r$.")]


@pytest.mark.parametrize(
    ("tex", "result"),
    [
        (r"F(1/u)", r"F(r)"),
        (r"-\frac m{u^2}\,F\!\left(\frac1u\right)", r"-\frac m{u^2}\,F\left(r\right)"),
        (r"F\,(1/w)", r"F\,(1/w)"),
    ],
)
def test_a_function_at_a_reciprocal_that_has_a_name(tex, result):
    assert with_reciprocals(tex, BEFORE) == result
