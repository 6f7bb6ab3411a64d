r"""Formulas with :math:`\pm` and :math:`\mp`: a claim for the upper signs, one for the lower."""

from __future__ import annotations

from typing import Any

SIGNS = ({r"\pm": "+", r"\mp": "-"}, {r"\pm": "-", r"\mp": "+"})
"""The upper signs, and the lower ones."""


def has_both_signs(value: Any) -> bool:
    """Whether a formula, or one of several, is printed with both signs."""
    if isinstance(value, tuple | list):
        return any(map(has_both_signs, value))
    return isinstance(value, str) and any(mark in value for mark in SIGNS[0])


def with_signs(value: Any, signs: dict[str, str]) -> Any:
    """Formulas with these signs in the place of both."""
    if isinstance(value, tuple | list):
        return tuple(with_signs(one, signs) for one in value)
    for mark, sign in signs.items() if isinstance(value, str) else ():
        value = value.replace(mark, sign)
    return value


def alternatives(equation: Any) -> tuple[str, ...]:
    r"""Two equations of which one holds at each point, as for :math:`x=\pm y`; else none.

    Where both sides have signs, as addition theorems, the equation holds for both.

    >>> alternatives(r"x=\pm y")
    ('x=+ y', 'x=- y')
    >>> alternatives(r"f(x\pm y)=x^2\pm y^2")
    ()
    """
    sides = equation.split("=") if isinstance(equation, str) else []
    if len(sides) != 2 or sum(map(has_both_signs, sides)) != 1:
        return ()
    return tuple(with_signs(equation, signs) for signs in SIGNS)
