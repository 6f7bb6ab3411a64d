"""What a formula mentions, and what is kept with it."""

from hypothesis import given

from kowalevski_cas.notation import Derivative, Name, Root, substitute
from kowalevski_cas.problem.mentions import mentions
from tests.notation.strategies import formulas


@given(formulas)
def test_a_formula_mentions_the_names_and_roots_in_it_once_from_left_to_right(formula):
    nodes, found = [*formula.nodes()], mentions(formula)
    places = [nodes.index(one) for one in found]
    assert places == sorted({*places})
    for kind in (Name, Root):
        assert {n for n in nodes if type(n) is kind} == {n for n in found if type(n) is kind}
    moving = sum(type(one) is Derivative for one in found)
    assert moving == any(type(one) is Derivative for one in nodes)


@given(formulas)
def test_what_is_found_once_for_a_formula_is_not_kept_for_another(formula):
    before = {one.name for one in mentions(formula) if type(one) is Name}
    renamed = substitute(formula, {name: Name(f"{name}'") for name in before})
    after = {one.name for one in mentions(renamed) if type(one) is Name}
    assert after == {f"{name}'" for name in before}
