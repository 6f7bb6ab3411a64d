"""The three models of one motion: they mean the same states."""

import numpy as np
import pytest

from kowalevski_cas.motion import load
from kowalevski_cas.motion.formulas import integrals
from kowalevski_cas.motion.methods.integrators import integrate
from kowalevski_cas.motion.models import nine, separated
from tests.motion.regions import EVERY_REGIME, SEPARATING, motion
from tests.motion.test_closed import ORIGINS, relative

T = np.linspace(-4, 4, 9)
REGULAR = {words: region for words, region in SEPARATING.items() if "goes" not in words}


@pytest.mark.parametrize("region", [*EVERY_REGIME, *REGULAR.values()])
def test_the_separated_equations_give_the_states_of_the_closed_form(region):
    moved = motion(*region, origins=ORIGINS, signs=(-1, 1))
    model = separated(moved)
    values = integrate("DOP853", model.start, T, 1e-13, model.rates)
    assert relative(model.states(values), load("closed")(moved, T)) < 1e-11


def test_the_nine_equations_are_the_largest_model():
    moved = motion("0.8", "0.9", origins=ORIGINS)
    model = nine(moved)
    values = integrate("DOP853", model.start, T, 1e-13, model.rates)
    assert relative(model.states(values), load("closed")(moved, T)) < 1e-11


def test_an_error_in_the_separated_equations_is_one_of_phase_only():
    moved = motion("-0.3", "0.5", origins=ORIGINS)
    t, model = np.linspace(0, 60, 7), separated(moved)
    states = model.states(integrate("DOP853", model.start, t, 1e-4, model.rates))
    assert relative(states, load("closed")(moved, t)) > 1e-4
    h, k, *_, first, second = integrals()(*states.T)
    assert np.max(np.abs(h - float(moved.parameters.h))) < 1e-13
    assert np.max(np.abs(k - float(moved.parameters.k))) < 1e-13
    assert np.max(np.abs(first)) < 1e-13 and np.max(np.abs(second)) < 1e-13


def test_an_exponential_has_no_such_model():
    with pytest.raises(ValueError, match="both pairs of roots coincide"):
        separated(motion("-0.5", "0"))
