"""Formulas that would take too long to evaluate are not evaluated."""

from __future__ import annotations

from kowalevski_cas.notation import Formula, Number, Power, Product, Quotient

STEEPEST = 60
"""The highest degree of a formula in the names that it prints."""
LONGEST = 100
"""Digits of a number."""


def excess(formula: Formula) -> str:
    """Why a formula is not evaluated; empty if it is."""
    if _largest(formula) >= 10**LONGEST:
        return f"a number of more than {LONGEST} digits is not computed with"
    if degree(formula) > STEEPEST:
        return f"a formula of a degree above {STEEPEST} is not evaluated"
    return ""


def degree(formula: Formula) -> int:
    """A bound on the degree in the printed names, denominators counted as factors."""
    below = [degree(child) for child in formula.children()]
    if isinstance(formula, Power):
        exponent = _largest(formula.exponent)
        return max(1, below[0]) * max(1, exponent)
    if isinstance(formula, Product | Quotient):
        return sum(below)
    return max(below, default=0 if isinstance(formula, Number) else 1)


def _largest(formula: Formula) -> int:
    """The largest number in a formula."""
    return max((node.value for node in formula.nodes() if isinstance(node, Number)), default=0)
