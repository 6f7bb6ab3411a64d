r"""Brackets of any two functions, as :math:`\{f,g\}=\sum_i(f_{q_i}g_{p_i}-f_{p_i}g_{q_i})`.

They say what the brackets of the variables are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    PoissonBracket,
    Product,
    Sum,
    times,
    to_latex,
    total,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.known import CONVENTION, DEFINITION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

OF_FUNCTIONS = "bracket of functions"
"""The kind of a definition of the bracket of any two functions."""

Pairs = dict[tuple[str, str], list[Formula]]


def bracket_of_functions(item: SourceStatement, known: Known) -> StatementRole | None:
    """The bracket of two letters that stand for any functions, by their partial derivatives."""
    pairs = _pairs(item)
    if pairs is None or not all(known.moves(name) for pair in pairs for name in pair):
        return None
    return StatementRole(DEFINITION, "the bracket of any two functions", OF_FUNCTIONS)


def brackets_by_functions(
    known: Known, suffix: str
) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The brackets of variables that the bracket of any two functions gives."""
    for item in known.items:
        role = known.roles.get(item)
        if role is None or role.kind != OF_FUNCTIONS:
            continue
        for number, ((x, y), terms) in enumerate((_pairs(item) or {}).items(), 1):
            tex = rf"\{{{x},{y}\}}={to_latex(total(terms))}"
            place = f"{item.printed.place} gives it"
            found = unprinted(known.paper, f"bracket-{number}{suffix}", tex, item, place)
            names = found.printed.heads.names
            yield found, StatementRole(CONVENTION, place, "", names)
        return


def any_function(item: SourceStatement, known: Known) -> str:
    r"""The letter that stands for any function in :math:`\dot f=\{f,H\}`; empty if there is none.

    Nothing defines it or moves it, and in every member it is derived, or a side of a bracket.
    """
    inner = [m.argument if isinstance(m, Negative) else m for m in item.members]
    brackets = [one for one in inner if isinstance(one, PoissonBracket)]
    sides = [{s.name for s in one.children() if isinstance(s, Name)} for one in brackets]
    found = {n for n in set[str]().union(*sides) if not (known.varies(n) or known.is_defined(n))}
    if len(found) != 1 or len(inner) < 2 or all(law.images for law in known.laws):
        return ""
    (name,) = found
    linear = all(sum(name in s.names() for s in one.children()) == 1 for one in brackets)
    others = [one for one in inner if one not in brackets]
    rates = [one for one in others if one != Number(0)]
    derived = all(isinstance(one, Derivative) and one.argument == Name(name) for one in rates)
    return name if linear and derived and all(name in side for side in sides) else ""


def refuse_idle_brackets(item: SourceStatement, known: Known) -> None:
    """Raise ``ValueError`` where nothing that moves stands on a side of a bracket.

    It vanishes, and that says nothing of letters which may have been meant to move.
    """
    letters = {symbol(name).letter for law in known.laws for name in law.variables}
    for node in item.formula.nodes() if item.formula is not None and letters else ():
        for side in node.children() if isinstance(node, PoissonBracket) else ():
            names = side.names()
            if names and not any(known.varies(n) or symbol(n).letter in letters for n in names):
                shown = to_latex(side)
                raise ValueError(f"nothing says that ${shown}$ moves: brackets of constants vanish")


def _pairs(item: SourceStatement) -> Pairs | None:
    """The coefficients of the products of derivatives, by what is derived by; one of each two."""
    match item.members:
        case (PoissonBracket(Name(f), Name(g)), right) if f != g:
            found: Pairs = {}
            for term in right.terms if isinstance(right, Sum) else (right,):
                if not _enter(term, f, g, found):
                    return None
            if any(_negated(found, y, x) != total(own) for (x, y), own in found.items()):
                return None
            return {(x, y): own for (x, y), own in found.items() if x < y}
    return None


def _negated(found: Pairs, x: str, y: str) -> Formula:
    """The opposite of a coefficient, as it is printed."""
    return total(
        [t.argument if isinstance(t, Negative) else Negative(t) for t in found.get((x, y), [])]
    )


def _times(factors: Iterable[Formula], term: Formula) -> Formula:
    """A term with more factors, of which none is a product."""
    if isinstance(term, Negative):
        return Negative(_times(factors, term.argument))
    return Product((*factors, *(term.factors if isinstance(term, Product) else (term,))))


def _enter(term: Formula, f: str, g: str, found: Pairs) -> bool:
    """Enter a term; whether it is a multiple of a derivative of each of the two functions."""
    sign, inner = False, term
    while isinstance(inner, Negative):
        sign, inner = not sign, inner.argument
    if isinstance(inner, Sum):
        return all(_enter(Negative(t) if sign else t, f, g, found) for t in inner.terms)
    factors = inner.factors if isinstance(inner, Product) else (inner,)
    for place, one in enumerate(factors):
        if isinstance(one, Sum) and {f, g} & one.names():  # a factor before all terms
            rest = (*factors[:place], *factors[place + 1 :])
            terms = [_times(rest, Negative(t) if sign else t) for t in one.terms]
            return all(_enter(t, f, g, found) for t in terms)
    by = {
        one.argument.name: one.by
        for one in factors
        if isinstance(one, Partial) and isinstance(one.argument, Name)
    }
    others = [one for one in factors if not isinstance(one, Partial)]
    if by.keys() != {f, g} or len(others) != len(factors) - 2:
        return False
    whole = times(*others) if others else Number(1)
    found.setdefault((by[f], by[g]), []).append(Negative(whole) if sign else whole)
    return not {f, g} & whole.names()
