r"""Matrix equations of motion, :math:`\dot L=[B,L]`, by the rates of the entries of L.

The entries of both sides are equations for the rates of the names in L, and there may be more of
them than names. Those names have the rates that solve all of them, for each value of a spectral
parameter; where there are none, or several, the equation is refused.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Constant, Derivative, Formula, Name, Relation, to_latex
from kowalevski_cas.notation.symbol import rate_name, symbol
from kowalevski_cas.paper.applied import SPECTRAL
from kowalevski_cas.paper.claims.forms import entries
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import as_matrices
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Equation

DERIVED = 4
"""How often the equations are derived by the spectral parameter, for more of them."""


def matrix_equations(formulas: Mapping[Printed, Formula]) -> list[Printed]:
    """The equations with the rate of a matrix that is defined by its entries."""
    matrices = {name for place in formulas if place.heads.matrix for name in place.heads.names}
    return [
        place
        for place, formula in formulas.items()
        if any(
            isinstance(node, Derivative) and node.argument in {*map(Name, matrices)}
            for node in formula.nodes()
        )
    ]


def equations_of_entries(formulas: Mapping[Printed, Formula], time: str) -> Iterator[str]:
    """The rates of the names in matrices by the equations of these; of constants there is none.

    Raises ``ValueError`` if no rates obey all of them, or several do.
    """
    laws = matrix_equations(formulas)
    if not laws:
        return
    others = (place for place in formulas if place not in laws and place.heads.names)
    defining = [place for place in others if not [*_constants(formulas[place])]]
    defined = {name for place in defining for name in place.heads.names}
    nodes = (node for place in laws for node in formulas[place].nodes())
    derived = {node.argument for node in nodes if isinstance(node, Derivative)}
    printed = (formulas[p] for p in defining if derived & {*map(Name, p.heads.names)})
    names = dict.fromkeys(
        n.name for formula in printed for n in formula.nodes() if isinstance(n, Name)
    )
    fixed = {name for formula in formulas.values() for name in _constants(formula)}
    unknown = [n for n in names if n not in defined | fixed and symbol(n).letter not in SPECTRAL]
    rates = [*map(rate_name, unknown)]
    every = {name for formula in formulas.values() for name in formula.names()}
    every |= {n for place in formulas for other in place.display for n in other.heads.names}
    still = tuple(sorted(every.difference(unknown, defined)))
    scene = Scene("the matrices", variables=(*unknown, *rates), constants=still, time=time)
    space = _elaborated(scene.defining(*defining))
    if letters := _letters(formulas, defining, unknown):
        equal = dict(_equal(letters, space))
        scene = replace(scene, constants=tuple(sorted({*still, *letters} - {*equal})))
        scene = scene.defining(*(p for p in defining if not {*p.heads.names} & {*letters}))
        space = _elaborated(replace(scene, definitions={**scene.definitions, **equal}))
    at, ring = space.finder, space.finder.ring
    moving = {name: ring.generator(rate) for name, rate in zip(unknown, rates, strict=True)}
    pairs = [pair for place in laws for pair in _equations(formulas[place], space)]
    vanishing = at.moving(moving, ()).differences(pairs)
    more = [*_derivatives(vanishing, [n for n in still if n in SPECTRAL], space)]
    found = solve_linear([*vanishing, *more], rates)
    for name, rate, value in zip(unknown, rates, found, strict=True):
        if value is None:
            raise ValueError(
                f"the matrix equation does not determine the rate of {name}: print what is "
                rf"constant in the matrix, as {name}=\mathrm{{const}}"
            )
        if not value.is_zero:
            yield f"{rate}={to_latex(formula_in(value))}"


def _elaborated(scene: Scene) -> Elaboration:
    return Elaborations(Texts(vocabulary((scene,))))(scene)


def _letters(
    formulas: Mapping[Printed, Formula], defining: Iterable[Printed], unknown: Iterable[str]
) -> list[str]:
    """The names that stand for expressions of constants: rates are printed in these letters."""
    waiting, moving = [place for place in defining if not place.heads.matrix], {*unknown}
    while found := [place for place in waiting if moving & formulas[place].names()]:
        moving |= {name for place in found for name in place.heads.names}
        waiting = [place for place in waiting if place not in found]
    return sorted(name for place in waiting for name in place.heads.names)


def _equal(letters: Sequence[str], space: Elaboration) -> Iterator[tuple[str, Printed]]:
    r"""What says of names which others they are equal to, as :math:`c_{21}=c_{12}`."""
    first: dict[str, Element] = {}
    for name in letters:
        value = space.finder.scalar(space.plain(Name(name)))
        equal = next((other for other, one in first.items() if (value - one).is_zero), None)
        if equal is None:
            first[name] = value
        else:
            yield name, Display(f"{name}-{equal}", f"{name}={equal}", "")[1]


def _constants(formula: Formula) -> Iterator[str]:
    """The name that is said to be constant."""
    match formula:
        case Relation((Name(name), Constant()), ("=",)):
            yield name


def _equations(formula: Formula, space: Elaboration) -> Iterator[Equation]:
    """The equations between the entries of both sides."""
    assert isinstance(formula, Relation)
    return entries(as_matrices(formula.members, space, are_equal=True))


def _derivatives(
    functions: Sequence[Element], parameters: Iterable[str], space: Elaboration
) -> Iterator[Element]:
    """The derivatives of functions by a parameter on which the rates do not depend."""
    for name in parameters:
        found = functions
        for _ in range(DERIVED):
            found = [space.finder.partial(power, name) for power in found]
            yield from found


def solve_linear(functions: Iterable[Element], rates: Sequence[str]) -> list[Element | None]:
    """The rates for which all functions vanish; ``None`` for one that they do not determine.

    Raises ``ValueError`` if there are none.
    """
    rows = [_parts(function, rates) for function in functions]
    pivots: list[list[Element] | None] = []
    for column in range(len(rates)):
        candidates = [row for row in rows if not row[column].is_zero]
        pivot = min(candidates, key=lambda row: len(row[column].terms().get(0, ())), default=None)
        if pivot is None:
            pivots.append(None)
            continue
        rows = [row for row in rows if row is not pivot]
        inverse = pivot[column].inverse()
        own = [entry * inverse for entry in pivot]
        rows = [_minus(row, own, column) for row in rows]
        pivots = [None if row is None else _minus(row, own, column) for row in pivots]
        pivots.append(own)
    if any(not row[-1].is_zero for row in rows):
        raise ValueError(
            "no rates obey the matrix equation in all entries: compare the signs and the entries "
            "of both matrices"
        )
    return [None if row is None else -row[-1] for row in pivots]


def _parts(function: Element, rates: Sequence[str]) -> list[Element]:
    """The factors of rates in a function that is linear in them, and the rest."""
    factors = [along(function, {rate: function.ring.one}) for rate in rates]
    rest = function
    for factor, rate in zip(factors, rates, strict=True):
        rest = rest - factor * function.ring.generator(rate)
    return [*factors, rest]


def _minus(row: list[Element], pivot: Sequence[Element], column: int) -> list[Element]:
    """A row without what a pivot has in a column."""
    factor = row[column]
    if factor.is_zero:
        return row
    return [a - factor * b for a, b in zip(row, pivot, strict=True)]
