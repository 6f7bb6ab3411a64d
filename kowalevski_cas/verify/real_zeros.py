"""Where a sum of squares vanishes: there each of them does, if they are real."""

from __future__ import annotations

from kowalevski_cas.notation import Formula, Negative, Number, Power, Product, Relation, Sum
from kowalevski_cas.problem.evaluate import Evaluation


def real_zeros(expression: Formula, at: Evaluation) -> tuple[Formula, ...]:
    """The equations that hold together exactly where a sum of squares vanishes.

    None, unless it is a sum of even powers, with positive factors, of what is real: it is its own
    conjugate, and has no root but the unit i, for that may be one of a negative number.
    """
    bases = [_base(term) for term in expression.terms] if isinstance(expression, Sum) else []
    found = [base for base in bases if base is not None and _is_real(base, at)]
    return tuple(map(_vanishes, found)) if len(found) == len(bases) else ()


def _base(term: Formula) -> Formula | None:
    """What an even power with a positive factor is a power of."""
    match term:
        case Product((Number(value), power)) if value > 0:
            return _base(power)
        case Power(base, Number(exponent)) if exponent > 0 and exponent % 2 == 0:
            return base
    return None


def _is_real(base: Formula, at: Evaluation) -> bool:
    value, roots = at.scalar(base), at.ring.roots
    unit = {1 << roots.index("i")} if "i" in roots else set()
    return value.parts.keys() <= {0} | unit and (value - at.scalar(base, True)).is_zero


def _vanishes(base: Formula) -> Formula:
    """That an expression is zero; that its terms are equal, if it is a difference."""
    match base:
        case Sum((left, Negative(right))):
            return Relation((left, right), ("=",))
    return Relation((base, Number(0)), ("=",))
