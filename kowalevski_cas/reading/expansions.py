r"""Expansions and limits: what is equal but for terms that nobody prints, at samples.

The sides of :math:`E=mc^2+\frac12mv^2+\dots`, or of :math:`\sin x\approx x`, differ by less than
each printed term where some letter is small, or large: which one is not asked of the words.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import log2
from typing import NamedTuple

from flint import acb

from kowalevski_cas.algebra.samples import Valueless
from kowalevski_cas.notation import (
    Formula,
    Negative,
    Product,
    Quotient,
    Relation,
    Sum,
    Unwritten,
    times,
)
from kowalevski_cas.notation.formula import EQUALITIES
from kowalevski_cas.reading.premises import leaves_out

ABOUT = frozenset({r"\approx", r"\simeq"})
"""The signs between what is approximately equal."""

SMALL = ((2.0**-7, 2.0**-8), (2.0**7, 2.0**8))
"""The factors by which a letter becomes small, or large."""

_SAME = 2.0**-56
"""What differs by less, and is of its size, is the same; integrals are no better."""

_CLEARLY = 0.5
"""By how much one order is higher than another one."""


class Expansion(NamedTuple):
    """What is expanded, and the terms that are printed of it."""

    whole: Formula
    terms: tuple[Formula, ...]


def expansions_of(formula: Formula) -> list[Expansion]:
    """The expansions in a chain, each of what stands last before it and leaves nothing out."""
    found = list[Expansion]()
    if not isinstance(formula, Relation):
        return found
    whole = formula.members[0]
    for sign, member in zip(formula.signs, formula.members[1:], strict=True):
        terms = tuple(_terms(member))
        dotted = any(isinstance(term, Unwritten) for term in terms)
        terms = tuple(term for term in terms if not isinstance(term, Unwritten))
        if sign not in ABOUT | EQUALITIES or any(map(leaves_out, (whole, *terms))):
            break
        if (sign in ABOUT or dotted) and terms:
            found.append(Expansion(whole, terms))
        elif found:
            break
        else:
            whole = member
    return found


def _terms(formula: Formula) -> Iterator[Formula]:
    """The terms of a member, where the factors of a sum are those of its terms; dots are one."""
    match formula:
        case Sum(terms):
            for term in terms:
                yield from _terms(term)
        case Negative(inner):
            yield from (
                one if isinstance(one, Unwritten) else Negative(one) for one in _terms(inner)
            )
        case Product(factors):
            for each in product(*([*_terms(factor)] for factor in factors)):
                dots = any(isinstance(one, Unwritten) for one in each)
                yield Unwritten() if dots else times(*each)
        case Quotient(above, below):
            for one in _terms(above):
                yield one if isinstance(one, Unwritten) else Quotient(one, below)
        case _:
            yield formula


def order_of(values: Sequence[acb]) -> float:
    """With which power of a small letter something vanishes, or of 1/x, of its values at two."""
    first, second = (abs(complex(value)) for value in values)
    if not first or not second:
        raise Valueless("no order")
    return log2(first / second)


def holds(whole: Sequence[acb], terms: Sequence[Sequence[acb]]) -> bool:
    """Whether what is expanded differs by less from the sum of its terms than by any of them.

    All are given by their values at two factors.
    """
    rest = [one - sum(each) for one, each in zip(whole, zip(*terms, strict=True), strict=True)]
    size = max(abs(complex(value)) for values in (whole, *terms) for value in values)
    if all(abs(complex(one)) <= _SAME * size for one in rest):
        return True
    return order_of(rest) > max(map(order_of, terms)) + _CLEARLY


def by_likelihood(names: set[str], terms: Sequence[Formula]) -> list[str]:
    """The letters that may be small, or large, those in the terms first."""
    own = {name for term in terms for name in term.names()}
    return sorted(names, key=lambda name: (name not in own, name))
