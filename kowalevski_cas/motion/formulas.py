"""The formulas that derivations offer, compiled to functions of numbers.

Formulas of a kind are those of the first derivation in the library that offers them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cache

from kowalevski_cas.algebra.flint import to_flint, to_fraction
from kowalevski_cas.library import LibraryError, available, load
from kowalevski_cas.motion.compile import Function, function
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.paper.closed_form import ClosedForm, Values
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed

INTEGRALS = ("H", "K", "a^2", "b^2", "c", "G", "F_1", "F_2")
"""Names of the integrals of a :class:`~kowalevski_cas.paper.closed_form.ClosedForm`."""


@cache
def source(kind: type = ClosedForm) -> Derivation:
    """The derivation that offers the formulas of a kind; raises ``LibraryError`` if none does."""
    for name in available():
        derivation = _loaded(name)
        for source in (derivation, *derivation.rests_on):
            if kind in source.offers:
                return source
    raise LibraryError(f"no derivation in the library offers motions: {kind.__name__}")


_loaded = cache(load)


@cache
def values_of_offer(name: str, kind: type = ClosedForm) -> Function:
    """The values that an offer of a kind has under this name, as a function of numbers."""
    return compile_values(getattr(source(kind).offers[kind](), name), kind)


def exactly(compiled: Function, state: Sequence[Fraction]) -> Sequence[Fraction]:
    """The values of compiled formulas, by FLINT's rational numbers."""
    return [to_fraction(value) for value in compiled(*map(to_flint, state))]


def compile_values(values: Values, kind: type = ClosedForm) -> Function:
    """Values, read on their scene, as a function of numbers."""
    derivation = source(kind)
    texts = derivation.texts(derivation.corrected(), values.scene)
    on = Elaborations(texts)(values.scene)
    named = [(texts.expression(tex), Name(tex)) for tex in values.supplied]
    elements = []
    for expression in values.expressions:
        if isinstance(expression, Printed):
            _, formula = texts.sides(expression)
        else:
            formula = texts.expression(expression)
        for part, name in named:
            formula = _with_name(formula, part, name)
        elements.append(on.finder.scalar(on.plain(formula)))
    return function(elements, values.arguments)


def _with_name(formula: Formula, wanted: Formula, name: Name) -> Formula:
    """The formula with a name in place of a subformula."""
    if formula == wanted:
        return name
    return formula.map_children(lambda child: _with_name(child, wanted, name))
