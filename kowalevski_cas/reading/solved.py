r"""What stands in a law and is given by what moves, as in :math:`M_i=I_i\Omega_i`.

Where the rates of one side are printed, and a factor of the other one stands in them that nothing
else gives, it is the other side by its other factors. So is a new factor of what is defined by what
moves, if rates of it are printed: w by :math:`\zeta=e^{-i\omega t}w`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Name, Product, to_latex
from kowalevski_cas.reading.changes import gives_factor
from kowalevski_cas.reading.known import DEFINITION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

_NEW = re.compile(
    r"\b(?:new|introduc|scal|dimensionless|substitut|let\b|put|set\b|units?\b|нов|введ|безразмерн|полож)",
    re.IGNORECASE,
)
"""Words for new variables, which are multiples of the old ones."""

SOLVED = "solved for a factor"
"""The kind of the role of an equation that gives a factor of its right side."""


def solved(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives a name in the equations of motion by a variable: it is a factor beside it."""
    name = _factor(item, known)
    if not name:
        return None
    return StatementRole(DEFINITION, f"gives {name} by what moves", SOLVED)


def solutions_for(item: SourceStatement, known: Known) -> Iterator[SourceStatement]:
    """The equation solved for the factor, which the paper does not print."""
    name = _factor(item, known)
    left, right = item.members
    assert isinstance(right, Product)
    rest = to_latex(Product(tuple(one for one in right.factors if one != Name(name))))
    id = re.sub(r"\W+", "-", f"solved-for-{name}-{item.order}")
    tex = rf"{name}=\frac{{{to_latex(left)}}}{{{rest}}}"
    yield unprinted(known.paper, id, tex, item, f"{item.printed.place} gives it")


def _factor(item: SourceStatement, known: Known) -> str:
    """The only factor on the right that stands in the law by which the left side moves."""
    match item.members:
        case (Name(moving), Product()) if known.moves(moving):
            names = item.members[1].names()
            rated = {name for one in known.paper.items for name in one.rates}
            free = not any(known.moves(name) or known.is_defined(name) for name in names)
            for law in known.laws if free and not _NEW.search(item.words) else ():
                if moving in law.variables and gives_factor(item, law, rated):
                    return (names & {*known.names.scalars(law.mentions)}).pop()
        case (Name(given), Product()) if known.is_defined(given) and known.varies(given):
            new = [one for one in new_factors(item) if _is_new(one, item, known)]
            rated = {name for one in known.items if one.order > item.order for name in one.rates}
            if len(new) == 1 and {*new} <= rated and not item.derives:
                return new[0]
    return ""


def _is_new(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a statement is the first one that has a name."""
    used = known.is_defined(name) or known.moves(name)
    return known.seen.get(name, item) is item and not used


def new_factors(item: SourceStatement) -> list[str]:
    """The names that are factors of the right side of an equation, and stand in it only so."""
    match item.members:
        case (Name(), Product(factors)):
            others = {name for one in factors if not isinstance(one, Name) for name in one.names()}
            return [one.name for one in factors if isinstance(one, Name) and one.name not in others]
    return []
