r"""What an energy, a Hamiltonian or a Lagrangian says of the rates in an equation behind it.

Words let the equation follow from it: an energy that is constant has no rate, of :math:`H` the
rates are those of Hamilton, and of :math:`L` there is the equation of Lagrange.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import pairwise, permutations

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Product,
    Relation,
    ScalarProduct,
    Sum,
)
from kowalevski_cas.notation.symbol import rate_name
from kowalevski_cas.paper.implied import HAMILTONIANS, LAGRANGIANS, conjugate_pairs
from kowalevski_cas.reading.free_formulas import single_functions
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.premises import written_out
from kowalevski_cas.reading.statements import SourceStatement

_BY_HAMILTON = re.compile(
    r"\bHamilton(?:['’]s|ian)?\s+(?:canonical\s+)?equations|\bcanonical\s+equations"
    r"|\bequations\s+of\s+Hamilton|\bуравнени\w+\s+Гамильтона|\bканоническ\w+\s+уравнени\w+",
    re.IGNORECASE,
)
_BY_LAGRANGE = re.compile(
    r"\b(?:Euler\W+)?Lagrange(?:['’]s)?\s+equations?|\bequations?\s+of\s+(?:Euler\s+and\s+)?Lagrange"
    r"|\bequations?\s+of\s+motion|\bуравнени\w+\s+(?:Эйлера\W+)?Лагранжа|\bуравнени\w+\s+движения",
    re.IGNORECASE,
)


def says_rates(item: SourceStatement) -> bool:
    """Whether words say that an equation is that of a Hamiltonian, or of a Lagrangian."""
    return bool(_BY_HAMILTON.search(item.before) or _BY_LAGRANGE.search(item.before))


def rates_behind(
    item: SourceStatement,
    before: Sequence[SourceStatement],
    formulas: Mapping[SourceStatement, Formula],
    known: Known,
) -> Iterator[Formula]:
    """What is known of the rates, or the momenta, in an equation by what stands before it."""
    given = {name for one in before for name in one.bare}
    yield from _momenta(formulas[item], given)
    rated = [node for node in formulas[item].nodes() if isinstance(node, Derivative)]
    if not rated or any(node.mark not in ("dot", "t") for node in rated):
        return
    named = {name: one for one in before for name in one.bare}
    yield from _energies([formulas[one] for one in before])
    for one in before:
        if known.roles[one].kind == "integral" and one.bare:
            yield _equal(Derivative(formulas[one].children()[-1], "dot"), Number(0))
    energy = next((name for name in HAMILTONIANS if name in named), "")
    if energy and _BY_HAMILTON.search(item.before):
        names = formulas[named[energy]].names() - {energy}
        functions = single_functions(known.paper)
        yield from _hamilton(energy, [*names, *{functions[one] for one in names & {*functions}}])
    action = next((name for name in LAGRANGIANS if name in named), "")
    if action and _BY_LAGRANGE.search(item.before):
        twice = dict.fromkeys(inner for node in rated for inner in node.argument.nodes())
        for rate in (one for one in twice if isinstance(one, Derivative)):
            if isinstance(rate.argument, Name):
                yield _lagrange(action, rate.argument.name)


def _momenta(formula: Formula, given: Collection[str]) -> Iterator[Formula]:
    r"""The momenta that nothing gives, in :math:`H=p\dot q-L` of a Lagrangian that is given."""
    sums = (node for one in written_out(formula) for node in one.nodes() if isinstance(node, Sum))
    for terms in map(_terms, sums):
        for action in (name for name in LAGRANGIANS if Negative(Name(name)) in terms):
            products = (one for one in terms if isinstance(one, Product | ScalarProduct))
            for pair in (pair for one in products for pair in permutations(one.children())):
                match pair:
                    case Name(p), Derivative(Name(q), "dot") if action in given and p not in given:
                        yield _equal(Name(p), Partial(Name(action), rate_name(q)))


def _terms(formula: Formula) -> list[Formula]:
    """The terms of a sum, and of the sums in it."""
    if not isinstance(formula, Sum):
        return [formula]
    return [term for one in formula.terms for term in _terms(one)]


def _energies(before: Sequence[Formula]) -> Iterator[Formula]:
    """How the energy of a Lagrangian changes: by less its partial derivative by the time.

    It is printed as the sum of the velocities times the momenta, less the Lagrangian.
    """
    for one in before:
        members = one.members if isinstance(one, Relation) else ()
        for energy, legendre in pairwise(members):
            nodes = {*legendre.nodes()}
            for action in LAGRANGIANS:
                less = isinstance(legendre, Sum) and Negative(Name(action)) in legendre.terms
                momenta = (p.argument for p in nodes if isinstance(p, Partial))
                if less and Name(action) in momenta and isinstance(energy, Name):
                    yield _equal(Derivative(energy, "dot"), Negative(Partial(Name(action), "t")))


def _hamilton(energy: str, names: Sequence[str]) -> Iterator[Formula]:
    """The equations of Hamilton; none if it is not seen which coordinate belongs to a momentum."""
    try:
        pairs = conjugate_pairs(sorted(names))
    except ValueError:
        return
    for q, p in pairs:
        yield _equal(Derivative(Name(q), "dot"), Partial(Name(energy), p))
        yield _equal(Derivative(Name(p), "dot"), Negative(Partial(Name(energy), q)))


def _lagrange(action: str, coordinate: str) -> Formula:
    momentum = Partial(Name(action), rate_name(coordinate))
    rest = Negative(Partial(Name(action), coordinate))
    return _equal(Sum((Derivative(momentum, "dot"), rest)), Number(0))


def _equal(left: Formula, right: Formula) -> Formula:
    return Relation((left, right), ("=",))
