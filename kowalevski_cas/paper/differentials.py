r"""Equations of motion as ratios of differentials: :math:`dx/P=dy/Q=dz/R`.

One of them may be :math:`dt`, and so may be one of two, as in :math:`dt=r\,d\tau`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from kowalevski_cas.notation import Formula, Name, Number, Product, Quotient, Relation, to_latex

TIMES = ("t", r"\tau")
ONE = Number(1)


def differentials(formula: Formula) -> dict[str, Formula]:
    """By what the differential of each name is divided in a chain; empty for anything else."""
    members = formula.members if isinstance(formula, Relation) else ()
    found = dict(pair for member in members for pair in _ratio(member))
    return found if len(found) == len(members) > 1 else {}


def rates(formula: Formula, known: Collection[str] = (), by_primes: bool = False) -> Iterator[str]:
    """The equations of motion that a chain of differentials says, by t if it has no time.

    Rates may be printed ``by_primes``.
    """
    found = differentials(formula)
    time = next((name for name in (*known, *TIMES) if name in found), "t")
    scale = found.pop(time, ONE)
    for name, below in found.items():
        rate = below if scale == ONE else Quotient(below, scale)
        left = f"{name}'" if by_primes else rf"\frac{{d{name}}}{{d{time}}}"
        yield f"{left}={to_latex(rate)}"


def _ratio(member: Formula) -> Iterator[tuple[str, Formula]]:
    match member:
        case Quotient(Product((Name("d"), Name(name))), below):
            yield name, below
        case Product((Name("d"), Name(name))):
            yield name, ONE
        case Product((*factors, Name("d"), Name(name))):
            yield name, Quotient(ONE, Product((*factors,)) if factors[1:] else factors[0])
