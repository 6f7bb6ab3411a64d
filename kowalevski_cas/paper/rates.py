"""How often names are derived in printed equations, and how that is printed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kowalevski_cas.notation import Derivative, Formula, Name, Partial, Relation
from kowalevski_cas.notation.symbol import name_of_rate, rate_name
from kowalevski_cas.problem.space import Meaningless

MOST = 4
"""How often a variable may be derived in equations of motion: four dots have names."""


def velocities(
    equations: Sequence[Formula],
    variables: Sequence[str],
    vectors: Mapping[str, tuple[str, ...]],
    given: Mapping[str, Formula],
) -> dict[str, str]:
    r"""The variables of which equations print higher derivatives, and those derivatives' names.

    What is ``given`` by a formula is derived as often as the names in this are. Of what moves by an
    equation for a lower derivative, higher ones are those of that: by :math:`\dot\nu=f(\nu)`
    the second derivative is none of its own.
    """
    found: dict[str, str] = {}
    least: dict[str, int] = {}
    for name, order in _explicit(equations):
        least[name] = min(order, least.get(name, order))
    for equation in equations:
        for name, order in orders(equation, given=given):
            order = min(order, least.get(name, order))
            for variable in vectors.get(name, (name,)):
                rate = variable
                if variable in variables and order > MOST:
                    raise Meaningless(f"{variable} is derived {order} times: at most four are read")
                for _ in range(order - 1 if variable in variables else 0):
                    # targets are assigned from left to right: the key is still the name before
                    found[rate] = rate = rate_name(rate)
    return found


def _explicit(equations: Sequence[Formula]) -> Iterator[tuple[str, int]]:
    """The names of which an equation gives a derivative alone, by none of it, with its order."""
    for equation in equations:
        match equation:
            case Relation((Derivative() as left, right)):
                inner: Formula = left
                order = 0
                while isinstance(inner, Derivative):
                    inner, order = inner.argument, order + 1
                rates = (node for node in right.nodes() if isinstance(node, Derivative))
                if isinstance(inner, Name) and inner.name not in {
                    n for r in rates for n in r.names()
                }:
                    yield inner.name, order


def orders(
    formula: Formula, above: int = 0, given: Mapping[str, Formula] | None = None
) -> Iterator[tuple[str, int]]:
    """The names in a formula, and how often they are derived by the time, there and above it."""
    if isinstance(formula, Name):
        yield formula.name, above
        if above and given and formula.name in given:
            rest = {name: one for name, one in given.items() if name != formula.name}
            yield from orders(given[formula.name], above, rest)
    elif isinstance(formula, Partial) and (name := name_of_rate(formula.by)) != formula.by:
        yield name, above + 1
    for child in formula.children():
        yield from orders(child, above + isinstance(formula, Derivative), given)


def marks(equations: Sequence[Formula]) -> set[str]:
    """How the derivatives in equations are printed: with dots, with primes, by a variable."""
    nodes = (node for formula in equations for node in formula.nodes())
    return {node.mark for node in nodes if isinstance(node, Derivative)}
