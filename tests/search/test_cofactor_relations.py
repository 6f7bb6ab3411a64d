"""Integrals and last multipliers that are products of powers of Darboux polynomials."""

import pytest

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import to_plain
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.polynomial_fields import PolynomialField
from kowalevski_cas.search.cofactor_relations import relations
from kowalevski_cas.search.darboux import darboux_polynomials
from tests.laws.published import PUBLISHED

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


@pytest.mark.parametrize("name", KNOWN)
def test_relations_hold_and_are_those_that_are_known(name):
    published = next(p for p in PUBLISHED if p.name == name and p.question == "darboux")
    system = published.system()
    derivation = Derivation("published", name, "", "", (system.section,))
    at = Elaborations(derivation.texts(None, system.scene))(system.scene).finder
    known = [one for one in darboux_polynomials(at, 2) if not one.cofactor.is_zero]
    found = set()
    for relation in relations(PolynomialField(at), known):
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
