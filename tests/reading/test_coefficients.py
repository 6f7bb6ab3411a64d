"""The coefficients of a formula in a letter."""

import pytest

from kowalevski_cas.notation import Name, Vocabulary, read, to_latex
from kowalevski_cas.reading.coefficients import coefficients

WORDS = Vocabulary(frozenset({"a", "b", "c", "x", "z"}))


@pytest.mark.parametrize(
    ("formula", "found"),
    [
        ("a+bz+cz^2", ["a", "b", "c"]),
        ("(z-a)(z-b)", ["ab", "-a - b", "1"]),
        ("2(z+1)^2-3z", ["2", "1", "2"]),
        (r"\frac{a}{z-b}+\frac{c}{z-b}", ["a + c"]),
        (r"1+\frac{x^2}{z+a}", ["a + x^2", "1"]),
        (r"\frac{z^2-4}{2}", ["-2", "0", r"\frac{1}{2}"]),
        ("a-b", ["a - b"]),
    ],
)
def test_they_stand_over_the_smallest_common_denominator(formula, found):
    own = coefficients(read(formula, WORDS), Name("z"))
    assert [to_latex(one) for one in own] == found


@pytest.mark.parametrize(
    "formula", [r"\sqrt{z}", r"\frac{a}{\sqrt{z}}", "a^z", r"\frac{1}{1+\frac{a}{z}}"]
)
def test_what_is_no_quotient_of_polynomials_has_none(formula):
    with pytest.raises(ValueError, match=r"polynomials|fraction"):
        coefficients(read(formula, WORDS), Name("z"))
