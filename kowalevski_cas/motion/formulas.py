"""The closed form that a derivation offers, compiled to functions of numbers.

It is that of the first derivation in the library that offers one.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from flint import fmpq

from kowalevski_cas.library import LibraryError, available, load
from kowalevski_cas.motion.compile import Function, function
from kowalevski_cas.notation import Formula, Name, replace
from kowalevski_cas.paper.closed_form import ClosedForm, Member, Values
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations

INTEGRALS = ("H", "K", "a^2", "b^2", "c", "F_1", "F_2")
"""Names of the values of :func:`integrals`."""


@cache
def source() -> Derivation:
    """The derivation that offers the closed form; raises ``LibraryError`` if none does."""
    for name in available():
        derivation = load(name)
        if derivation.closed_form is not None:
            return derivation
    raise LibraryError("no derivation in the library offers motions in closed form")


@cache
def _closed_form() -> ClosedForm:
    offer = source().closed_form
    assert offer is not None
    return offer()


def equations() -> Function:
    """The right-hand sides of the nine equations, by the state."""
    return _compiled(_closed_form().equations)


def integrals() -> Function:
    """The values of :data:`INTEGRALS`, all constant on N⁴, by the state."""
    return _compiled(_closed_form().integrals)


def constants() -> Function:
    """The polynomials from which m and ℓ are found, by the state."""
    return _compiled(_closed_form().constants)


def phase_point() -> Function:
    """The state by what the motion code supplies."""
    return _compiled(_closed_form().phase_point)


def jacobi_rates() -> Function:
    """The rates of sn, cn, dn of n·t, by sn, cn, dn, n and the modulus k."""
    return _compiled(_closed_form().jacobi_rates)


def across() -> tuple[Function, Function, Function]:
    """The complex variables, the functions that vanish on N⁴, and the rates of these."""
    form = _closed_form()
    first, second, third = form.complex_variables, form.across, form.across_rates
    return _compiled(first), _compiled(second), _compiled(third)


def exactly(compiled: Function, state: list[Fraction]) -> list[Fraction]:
    """The values of compiled formulas, by FLINT's rational numbers."""
    values = compiled(*(fmpq(x.numerator, x.denominator) for x in state))
    return [Fraction(int(value.p), int(value.q)) for value in values]


@cache
def _compiled(values: Values) -> Function:
    """The values, read on their scene, as a function of numbers."""
    texts = source().texts(source().corrected(), values.scene)
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
    for place, child in enumerate(formula.children()):
        formula = replace(formula, (place,), _named(child, wanted, name))
    return formula
