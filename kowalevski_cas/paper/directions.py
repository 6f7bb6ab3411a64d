"""The derivatives of functions by the names in their arguments, and by parameters."""

from __future__ import annotations

from fractions import Fraction

from kowalevski_cas.notation import Formula, Name, Number, Partial, times, total
from kowalevski_cas.paper.arguments import by_name, combination, multiple, names_in, product_of
from kowalevski_cas.paper.transcendental import Transcendental
from kowalevski_cas.problem.space import Meaningless


def directions(functions: Transcendental, name: str) -> dict[str, Formula]:
    """The derivatives by a name of all generators that have it in their arguments."""
    found: dict[str, Formula] = {}
    for group in functions.groups:
        if name in functions.names_under(group):
            by = _slope(functions, functions.expanded(product_of(group.monomial)), name)
            found |= {name: times(by, rate) for name, rate in group.rates().items()}
        parameters = zip(group.kind.family.parameters, group.kind.parameters, strict=True)
        for parameter, value in parameters:
            if value == Name(name):
                for one, rate in group.rates_by(parameter).items():
                    found[one] = total([found[one], rate]) if one in found else rate
    return found


def without_direction(functions: Transcendental, name: str) -> frozenset[str]:
    """The generators that have a name in a parameter by which nothing derives them.

    Raises :class:`Meaningless` if values at constants are printed that hang together with it.
    """
    if name in functions.known.names():
        raise Meaningless(f"by {name} nothing is derived where values are printed at it", name)
    found = set[str]()
    for group in functions.groups:
        below = {
            n for parameter in group.kind.parameters for n in functions.expanded(parameter).names()
        }
        if name in below.union(*(functions.radicals.get(n, ()) for n in below)):
            known = group.kind.family.by if group.kind.parameters == (Name(name),) else ()
            found.update(() if known else group.names.values())
    return frozenset(found)


def _slope(functions: Transcendental, argument: Formula, name: str) -> Formula:
    """The derivative of an argument by a name, which may stand under a root in it."""
    roots = [radical for radical in argument.names() if name in functions.radicals.get(radical, ())]
    slopes = {name: Number(1), **{root: Partial(Name(root), name) for root in sorted(roots)}}
    return total(
        _times(factor, times(by_name(term, radical), slope))
        for term, factor in combination(argument).items()
        for radical, slope in slopes.items()
        if radical in names_in(term)
    )


def _times(factor: Fraction, formula: Formula) -> Formula:
    return multiple(product_of(((formula, 1),), factor.denominator), factor.numerator)
