"""The tree by itself: what is found of a formula and kept with it is no part of it."""

import pickle

from hypothesis import given

from kowalevski_cas.notation import once
from tests.notation.strategies import formulas


@once
def itself(formula):
    return formula


@given(formulas)
def test_what_is_kept_with_a_formula_does_not_go_to_another_process(formula):
    before = pickle.dumps(formula)
    assert itself(formula) is formula and pickle.dumps(formula) == before
    assert pickle.loads(before) == formula
