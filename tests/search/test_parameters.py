"""Values of constants for which polynomials divide their derivatives: all cases."""

from dataclasses import replace

import pytest

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.parameters import DarbouxAnsatz, cofactor_monomials
from tests.laws.systems import EULER, HENON_HEILES, KEPLER, LORENZ, LOTKA_VOLTERRA, identity


def space_of(system, *constants):
    more = replace(system, statements=(identity("1=1"),), constants=(*system.constants, *constants))
    derivation = more.derivation()
    return Elaborations(derivation.texts())(derivation.scenes()[0])


def found(system, tex, unknown=""):
    """The cases: the equations that constants obey, and the cofactor."""
    size = len(cofactor_monomials(space_of(system).finder))
    letters = [rf"\kappa_{k}" for k in range(size)]
    space = space_of(system, *unknown, *letters)
    ansatz = DarbouxAnsatz(space.finder, space.finder.scalar(space.formula(tex)), letters)
    shown = {}
    for case in ansatz.cases():
        equations = frozenset(
            "=".join(to_latex(formula_in(side)) for side in sides) for sides in case.equations
        )
        shown[equations] = to_latex(formula_in(case.cofactor))
    return shown


@pytest.mark.parametrize(
    ("system", "tex", "unknown", "expected"),
    [
        (LORENZ, r"x^2-2\sigma z", "", {(r"b=2\sigma",): r"-2\sigma", (r"\sigma=0",): "0"}),
        (
            LORENZ,
            "x^2+Az",
            "A",
            {(r"A=-2\sigma", r"b=2\sigma"): r"-2\sigma", ("A=0", r"\sigma=0"): "0"},
        ),
        (LORENZ, "y^2+z^2", "", {("b=1", r"\rho=0"): "-2"}),
        (HENON_HEILES, "x^2+Ay^2+B", "AB", {}),
        (LOTKA_VOLTERRA, "x", "", {(): "-yb + a"}),
        (EULER, "p", "", {("C=B",): "0"}),
    ],
)
def test_all_cases(system, tex, unknown, expected):
    assert found(system, tex, unknown) == {frozenset(k): v for k, v in expected.items()}


def test_the_quadratic_darboux_polynomials_of_lorenz():
    cases = found(LORENZ, "Ax^2+By^2+Cz^2+Dz+Exy+G", "ABCDEG")
    assert sorted(cases.values()) == ["-2", "-2", r"-2\sigma", "0"]
    special = {one for case in cases for one in case if not any(c in one for c in "ABCDEG")}
    assert special == {r"b=2\sigma", "b=1", r"\sigma=1", r"\sigma=0", r"\rho=0"}


def test_a_field_with_roots_is_refused():
    with pytest.raises(Meaningless, match="roots or quotients"):
        found(KEPLER, "x")
