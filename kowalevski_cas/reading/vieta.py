r"""Names for all the roots of a polynomial, and what Vieta's relations say of them.

So :math:`a(z-u)(z-v)=az^2+bz+c` gives u and v: :math:`a(u+v)=-b`, :math:`auv=c`.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from itertools import combinations
from typing import NamedTuple

from kowalevski_cas.algebra.samples import Sample, Valueless, is_zero, precisely
from kowalevski_cas.notation import Application, Formula, Name, Negative, times, to_latex, total
from kowalevski_cas.notation.edits import substitute
from kowalevski_cas.paper.summation import without_sums
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.coefficients import Polynomial, coefficients, divided, negative
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted


class NamedRoots(NamedTuple):
    """All the roots of a polynomial by their names, where they are named."""

    item: SourceStatement
    names: tuple[str, ...]
    letter: str
    polynomial: Polynomial


def polynomial_of(
    formula: Formula, letter: str, names: Sequence[str], at: SourceStatement, paper: SourcePaper
) -> Polynomial:
    """The coefficients of a formula in a letter where roots have names; none if it has not any."""
    with suppress(ValueError, Meaningless):
        giving = _giving(at, names, paper)
        return _without_zeros(coefficients(with_definitions(formula, letter, giving), Name(letter)))
    return ()


def _giving(at: SourceStatement, names: Sequence[str], paper: SourcePaper) -> list[SourceStatement]:
    """The equations up to the sentence of a statement that have none of some names."""
    return [
        one
        for one in paper.items
        if one.sentence[0] <= at.sentence[0]
        and len(one.members) > 1
        and one.names.isdisjoint(names)
    ]


def letters_of(
    formula: Formula, names: Sequence[str], at: SourceStatement, paper: SourcePaper
) -> set[str]:
    """The names in a formula, and in what gives these and its functions by others."""
    giving = _giving(at, names, paper)
    found, waiting = set[str](), [formula]
    while waiting:
        new = set[str]()
        for node in waiting.pop().nodes():
            match node:
                case Name(name) | Application(name):
                    new |= {name}
        heads = [(Name(name), name) for name in new - found]
        waiting += [
            member
            for one in giving
            for head, name in heads
            if head in (one.members[0], one.members[-1])
            or any(_is_function(side, name) for side in one.members)
            for member in one.members
        ]
        found |= new
    return found


def _is_function(formula: Formula, name: str) -> bool:
    return isinstance(formula, Application) and formula.function == name


def relations(
    roots: NamedRoots, paper: SourcePaper, moving: Collection[str] = ()
) -> list[SourceStatement]:
    """What the sums of products of the roots are by the coefficients.

    The first one is not zero: all is divided by it, unless it moves.
    """
    polynomial = roots.polynomial
    if isinstance(polynomial[-1], Negative):
        polynomial = tuple(map(negative, polynomial))
    *lower, lead = polynomial
    moves = not lead.names().isdisjoint(moving)
    said = f"of the roots {', '.join(roots.names)}"
    found = []
    for count, coefficient in enumerate(reversed(lower), 1):
        products = total(times(*map(Name, some)) for some in combinations(roots.names, count))
        value = coefficient if count % 2 == 0 else negative(coefficient)
        left, right = (times(lead, products), value) if moves else (products, divided(value, lead))
        tex = f"{to_latex(left)}={to_latex(right)}"
        found.append(unprinted(paper, f"roots-{roots.item.order}-{count}", tex, roots.item, said))
    return found


def with_definitions(
    formula: Formula,
    letter: str,
    items: Sequence[SourceStatement],
    busy: frozenset[str] = frozenset(),
) -> Formula:
    """A formula with what gives its names, and its functions, where a letter stands in that."""
    given = None
    match formula := without_sums(formula):
        case Name(name) if name != letter and name not in busy:
            given = _given(name, letter, items)
        case Application(name, (argument,)) if name not in busy:
            own = _given(name, letter, items)
            given = substitute(own, {letter: argument}) if own is not None else None
        case _:
            name = ""
    if given is not None:
        inner = with_definitions(given, letter, items, busy | {name})
        if letter in inner.names():
            return inner
    return formula.map_children(lambda one: with_definitions(one, letter, items, busy))


def _given(name: str, letter: str, items: Sequence[SourceStatement]) -> Formula | None:
    r"""What gives a name, or a function of a letter: what is printed last with it on its left.

    Or before it at the end of a chain, as in :math:`\dot u^2=2h-u^2=P(u)`.
    """
    own = (Name(name), Application(name, (Name(letter),)))
    for one in reversed(items):
        first, *others = one.members
        if first in own and not one.derives:
            return others[0]
        if others[-1] in own and len(others) > 1:
            return one.members[-2]
    return None


def _without_zeros(polynomial: Polynomial) -> Polynomial:
    """The coefficients without those of the highest powers that are zero."""
    with suppress(Valueless, ArithmeticError), precisely():
        sample = Sample(1, {}, (), {}, "t")
        while polynomial and is_zero(sample.value(polynomial[-1])):
            polynomial = polynomial[:-1]
    return polynomial
