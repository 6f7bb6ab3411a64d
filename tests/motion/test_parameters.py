"""The constants of a motion: exact signs, sharp values, and words for what cannot be."""

import re
from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, Parameters
from kowalevski_cas.motion.parameters import ball, exact, precision

numbers = st.fractions(-5, 5, max_denominator=100)


@given(numbers, numbers, st.fractions(0, 5, max_denominator=100), st.sampled_from([1, -1]))
def test_signs_of_linear_expressions_in_a_root_are_those_of_their_values(x, y, square, sign):
    parameters = Parameters(Fraction(1), Fraction(0), Fraction(1), square, sign * (square > 0))
    with precision(400):
        value = parameters.value(x, y)
        assert parameters.sign(x, y) == (0 if value.contains(0) else (value > 0) - (value < 0))


@given(st.integers(1, 60))
def test_a_difference_that_nearly_cancels_keeps_all_its_digits(digits):
    # √2 less a fraction that agrees with it to so many digits.
    with precision(400):
        near = Fraction(
            int((ball(Fraction(2)).sqrt() * 10**digits).floor().unique_fmpz()), 10**digits
        )
    parameters = Parameters(Fraction(1), Fraction(0), Fraction(1), Fraction(2), 1)
    with precision(64):
        assert parameters.value(Fraction(1), -near).rel_accuracy_bits() > 55


@given(numbers.filter(bool), numbers)
def test_the_energy_and_ell_determine_each_other(m, ell):
    parameters = Parameters.of(1, "0.4", m, ell)
    again = Parameters.at_energy(1, "0.4", m, parameters.h)
    assert again in (parameters, replace(parameters, ell_sign=-parameters.ell_sign))
    assert again.ell_sign >= 0


@pytest.mark.parametrize(
    "values, words",
    [
        ((1, 1, 1, 1), "equal, and then r = 0"),
        ((1, 2, 1, 1), "in the wrong order"),
        ((1, -2, 1, 1), "b = -2 is negative"),
        ((1, "0.5", 0, 1), "m = 0: the roots (ℓ±1)/2m are at infinity"),
    ],
)
def test_constants_that_do_not_separate_are_refused(values, words):
    with pytest.raises(Inadmissible, match=re.escape(words)):
        Parameters.of(*values)


@pytest.mark.parametrize("m, h, bound", [(1, -10, "h ≥ -1.25"), (-1, 10, "h ≥ -0.25 and ≤ 1.75")])
def test_an_energy_without_ell_is_refused_with_its_bound(m, h, bound):
    with pytest.raises(Inadmissible, match=f"is negative; {bound} would do"):
        Parameters.at_energy(1, "0.5", m, h)


@pytest.mark.parametrize("word", ["", "x", "nan", "inf", "1e99999", "1/0", "9" * 2000])
def test_what_is_no_number_is_refused(word):
    with pytest.raises(ValueError, match=r"not a finite number|too large|1000 characters"):
        exact(word)
