"""Where brackets stand in what is printed, and signs of multiplication, whatever the format."""

from __future__ import annotations

from kowalevski_cas.notation.formula import (
    Application,
    Changed,
    Commutator,
    Conjugate,
    CrossProduct,
    Derivative,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Relation,
    ScalarProduct,
    Sum,
    Summation,
    Transposed,
    Vector,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.unicode import glyphs
from kowalevski_cas.notation.values import applies

# What stands in brackets behind a sign, and beside other factors.
SIGNED = (Sum, Negative, Relation)
COMPOUND = (*SIGNED, Product, CrossProduct, Summation)
# What carries a power without them.
_BASES = (
    Name, Number, Application, Vector, ScalarProduct, PoissonBracket, Conjugate, Modulus, Commutator
)  # fmt: skip


def is_applied(left: Formula, right: Formula) -> bool:
    """Whether a factor begins with a bracket that looks like the argument of the one before it."""
    inner, raised = bare(right), False
    while isinstance(inner, Power | Transposed) or (
        isinstance(inner, Derivative) and inner.mark == "prime"
    ):
        raised, inner = True, bare(inner.children()[0])
        if isinstance(inner, Name) and is_base(inner):
            return False
    opened = isinstance(inner, (*COMPOUND, Vector)) or (raised and not is_base(inner))
    return opened and applies(left, inner, raised)


def is_word(formula: Formula) -> bool:
    """Whether a factor is a name of several upright letters, or a power of one."""
    base = bare(formula.base if isinstance(formula, Power) else formula)
    if not isinstance(base, Name):
        return False
    parts = glyphs(base.name)
    return parts.font == r"\mathrm" and len(parts.letter) > 1


def is_unmarked(formula: Formula) -> bool:
    """Whether it is a name on which primes can stand: it has no star, and no primes of its own."""
    if not isinstance(formula, Name):
        return False
    parts = symbol(formula.name)
    return not (parts.raised or parts.primes)


def bare(formula: Formula) -> Formula:
    """The formula without a mark."""
    return formula.argument if isinstance(formula, Changed) else formula


def is_base(formula: Formula) -> bool:
    """Whether a formula carries a power without brackets; a star stands where the power would."""
    formula = bare(formula)
    if isinstance(formula, Name):
        return not symbol(formula.name).raised
    if isinstance(formula, Derivative) and formula.mark == "dot":
        return not isinstance(formula.argument, Name) or is_base(formula.argument)
    return isinstance(formula, _BASES)
