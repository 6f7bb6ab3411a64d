"""Sums over an index, written out term by term; the index may stand in names as well."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

from kowalevski_cas.notation import Formula, Name, Number, Partial, Summation, to_latex, total
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.problem.space import Meaningless

_INDEX = re.compile(r"\\[A-Za-z]+|\d+|.")


def expand_sum(formula: Summation) -> Formula:
    """The terms of a sum; raises :class:`Meaningless` if its limits are no numbers."""
    match formula.first, formula.last:
        case Number(first), Number(last):
            terms = [_at(formula.body, formula.index, k) for k in range(first, last + 1)]
            return total(terms)
    shown = to_latex(formula)
    raise Meaningless(f"print both limits as numbers, for all terms to be known: {shown}")


def without_sums(formula: Formula) -> Formula:
    """A formula with its sums written out, but for those whose limits are no numbers."""
    match formula:
        case Summation(_, Number(), Number()):
            return without_sums(expand_sum(formula))
    return formula.map_children(without_sums)


def _at(formula: Formula, index: str, value: int) -> Formula:
    """The term of a sum for a value of its index, which stands in names too."""
    if isinstance(formula, Summation) and formula.index == index:  # there it is another one
        return replace(
            formula, first=_at(formula.first, index, value), last=_at(formula.last, index, value)
        )
    if isinstance(formula, Partial):
        by = _at(Name(formula.by), index, value)
        if not isinstance(by, Name):
            raise Meaningless(f"a derivative by the index of a sum: {to_latex(formula)}")
        return replace(formula, argument=_at(formula.argument, index, value), by=by.name)
    if not isinstance(formula, Name):
        return formula.map_children(lambda child: _at(child, index, value))
    if formula.name == index:
        return Number(value)
    name = symbol(formula.name)
    parts = _INDEX.findall(name.index)
    if index not in parts:
        return formula
    before = (number for number, other in pairwise(parts) if other == index and number.isdecimal())
    crowded = re.search(r"[^-+,]{2}", "".join(p[:1] for p in parts))
    if any(int(number) > 1 for number in before) or (
        crowded and (value > 9 or {*"+-"} & {*parts})  # 2i may be two indices, or a product
    ):
        raise Meaningless(f"what is the index of {to_latex(formula)}? write the terms out")
    low = "".join(str(value) if part == index else part for part in parts)
    if re.fullmatch(r"\d+(?:[+-]\d+)+", low):  # as in q_{i+1}
        low = str(sum(map(int, re.findall(r"[+-]?\d+", low))))
    return Name(replace(name, index=low).name)
