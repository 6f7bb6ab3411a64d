"""Integrals and last multipliers that are products of powers of Darboux polynomials."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import to_plain
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.polynomial_fields import PolynomialField
from kowalevski_cas.search.cofactor_relations import exponential_factors, relations
from kowalevski_cas.search.darboux import darboux_polynomials
from study.published import PUBLISHED
from tests.sample import sampled

KNOWN = {
    "Lotka and Volterra": {("integral", ("−n/b", "−a/b"), "(xm + yb)/b"), ("multiplier", ("−1", "−1"), "0")},
    "Riccati's second equation": {("integral", ("−2", "1"), "0"), ("multiplier", ("−3", "0"), "0")},
    "Lorenz with b = 2s": {("multiplier", ("(−3s − 1)/(2s)",), "0")},
    "Darboux and Halphen": {("multiplier", ("−1", "−1", "−1"), "0")},
    "May and Leonard": set(),
    "Lorenz in general": set(),
}  # fmt: skip


def shown(element):
    return to_plain(formula_in(element))


EXPONENTIAL = {
    r"\dot x=x^2,\quad \dot y=y(1+x)": {("1/x", "−1")},
    r"\dot x=x^3,\quad \dot y=y": {("1/x", "−x"), ("1/x²", "−2")},
    r"\dot x=x(a+y),\quad \dot y=y^2": {("1/y", "−1")},
    r"\dot x=y,\quad \dot y=-3xy-x^3": {("x/(x² + y)", "1")},
    r"\dot x=x(y-1),\quad \dot y=y(1-x)": set(),
}
"""Fields, and the exponents G/P of their exponential factors with their derivatives."""


@pytest.mark.parametrize("motion", EXPONENTIAL)
def test_exponential_factors_are_found_once(motion):
    system = System(motion)
    derivation = Derivation("exponential", "", "", "", (system.section,))
    at = Elaborations(derivation.texts(None, system.scene))(system.scene).finder
    known = [one for one in darboux_polynomials(at, 2) if not one.cofactor.is_zero]
    found = [*exponential_factors(PolynomialField(at), known, 2)]
    assert all((at.derivative(one.exponent) - one.cofactor).is_zero for one in found)
    quotients = [one for one in found if not one.is_polynomial]
    assert {(shown(one.exponent), shown(one.cofactor)) for one in quotients} == EXPONENTIAL[motion]
    assert len(quotients) == len(EXPONENTIAL[motion])


@pytest.mark.parametrize("name", sampled(KNOWN, 3))
def test_relations_hold_and_are_those_that_are_known(name):
    published = next(p for p in PUBLISHED if p.name == name and p.question == "darboux")
    system = published.system()
    derivation = Derivation("published", name, "", "", (system.section,))
    at = Elaborations(derivation.texts(None, system.scene))(system.scene).finder
    known = [one for one in darboux_polynomials(at, 2) if not one.cofactor.is_zero]
    found = set()
    field = PolynomialField(at)
    for relation in relations(field, known, [*exponential_factors(field, known, 2)]):
        total = at.derivative(relation.exponential)
        for exponent, one in zip(relation.exponents, known, strict=True):
            assert at.derivative(exponent).is_zero
            total = total + exponent * one.cofactor
        for variable in at.setting.variables if relation.multiplier else ():
            total = total + at.partial(at.rates[variable], variable)
        assert total.is_zero
        kind = "multiplier" if relation.multiplier else "integral"
        found.add((kind, tuple(map(shown, relation.exponents)), shown(relation.exponential)))
    assert found == KNOWN[name]
