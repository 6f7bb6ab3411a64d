"""The formulas that derivations offer, compiled to functions of numbers.

Formulas of a kind are those of the first derivation in the library that offers them.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

from kowalevski_cas.algebra.flint import to_flint, to_fraction
from kowalevski_cas.library import LibraryError, available, load
from kowalevski_cas.motion.compile import Function, function
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.paper.closed_form import (
    ClosedForm,
    CriticalSets,
    HyperellipticForm,
    LevelsOnM4,
    Member,
    Values,
)
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations

INTEGRALS = ("H", "K", "a^2", "b^2", "c", "G", "F_1", "F_2")
"""Names of the values of :func:`integrals`."""


@cache
def source(kind: type = ClosedForm) -> Derivation:
    """The derivation that offers the formulas of a kind; raises ``LibraryError`` if none does."""
    for name in available():
        derivation = _loaded(name)
        for one in (derivation, *derivation.rests_on):
            if kind in one.offers:
                return one
    raise LibraryError(f"no derivation in the library offers motions: {kind.__name__}")


_loaded = cache(load)


@cache
def _offered(kind: Any) -> Any:
    return source(kind).offers[kind]()


def equations() -> Function:
    """The right-hand sides of the nine equations, by the state."""
    return compiled(_offered(ClosedForm).equations)


def integrals() -> Function:
    """The values of :data:`INTEGRALS`, all constant on N⁴, by the state."""
    return compiled(_offered(ClosedForm).integrals)


def constants() -> Function:
    """The polynomials from which m and ℓ are found, by the state."""
    return compiled(_offered(ClosedForm).constants)


def phase_point() -> Function:
    """The state by what the motion code supplies."""
    return compiled(_offered(ClosedForm).phase_point)


def complex_variables() -> Function:
    """The complex variables and ω3, by the state and i."""
    return compiled(_offered(ClosedForm).complex_variables)


def across() -> tuple[Function, Function]:
    """The functions that vanish on N⁴, and their rates."""
    form = _offered(ClosedForm)
    return compiled(form.across), compiled(form.across_rates)


def critical_sets() -> tuple[Function, Function, Function]:
    """What vanishes on M⁴, on N⁴ and on O⁴, by the complex variables, and s for the last."""
    sets = _offered(CriticalSets)
    M4, N4, O4 = (compiled(values, CriticalSets) for values in (sets.M4, sets.N4, sets.O4))
    return M4, N4, O4


def critical_values() -> tuple[Function, Function]:
    """The values k, p²h − 2g on M⁴ by j, and k, 2g − p²h on N⁴ by m and r."""
    sets = _offered(CriticalSets)
    M4, N4 = (compiled(values, CriticalSets) for values in (sets.M4_values, sets.N4_values))
    return M4, N4


def polynomial_on_M4() -> Function:
    """The polynomial of ξ whose real roots count the tori of M⁴, by ξ, h, j, p and r."""
    return compiled(_offered(LevelsOnM4).polynomial, LevelsOnM4)


def hyperelliptic(values: str) -> Function:
    """These values of the :class:`~kowalevski_cas.paper.closed_form.HyperellipticForm`, on O⁴."""
    return compiled(getattr(_offered(HyperellipticForm), values), HyperellipticForm)


def exactly(compiled: Function, state: list[Fraction]) -> list[Fraction]:
    """The values of compiled formulas, by FLINT's rational numbers."""
    return [to_fraction(value) for value in compiled(*map(to_flint, state))]


@cache
def compiled(values: Values, kind: type = ClosedForm) -> Function:
    """The values, read on their scene, as a function of numbers."""
    derivation = source(kind)
    texts = derivation.texts(derivation.corrected(), values.scene)
    on = Elaborations(texts)(values.scene)
    named = [(texts.expression(tex), Name(tex)) for tex in values.supplied]
    elements = []
    for expression in values.expressions:
        if isinstance(expression, Member):
            formula = texts.relation(expression.printed).members[expression.place]
        else:
            formula = texts.expression(expression)
        for part, name in named:
            formula = _named(formula, part, name)
        elements.append(on.finder.scalar(on.plain(formula)))
    return function(elements, values.arguments)


def _named(formula: Formula, wanted: Formula, name: Name) -> Formula:
    """The formula with a name in place of a subformula."""
    if formula == wanted:
        return name
    return formula.mapped(lambda child: _named(child, wanted, name))
