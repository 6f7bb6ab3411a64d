"""Keys of names and of their derivatives: each has a value of its own at a sample."""

from __future__ import annotations

from kowalevski_cas.notation import (
    Conjugate,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Sum,
    to_latex,
)
from kowalevski_cas.notation.symbol import name_of_rate, symbol

Key = tuple[str, ...]
"""A name with the variables by which it is derived; or a function with the value at which it is."""

PARTIAL = r"\partial"
TIME = "t"


def variable_of(mark: str, primed: str) -> str:
    """The variable by which a mark derives, where a prime derives by ``primed``."""
    return {"dot": TIME, "prime": primed}.get(mark, mark)


def key_of(node: Formula, primed: str) -> Key | None:
    """The key of a name, of a derivative of one, or of what is printed like one; or none."""
    match node:
        case Name(name):
            return (name,)
        case Conjugate(Name(name)):  # or a mean: nothing is known of it but what is printed
            return (to_latex(node),)
        case Derivative(inner, mark):
            below = key_of(inner, primed)
            return below and (*below, variable_of(mark, primed))
        case Partial(Name(name), by):
            return (PARTIAL, name, by)
        case Partial(Partial() as inner, by):
            below = key_of(inner, primed)
            return below and (*below, by)
        case Power(Name(name), exponent) if _is_index(exponent):
            return (name, "^", to_latex(exponent))
    return None


def rate_of(name: str, by: str) -> Formula:
    """The derivative of a name, or of a velocity, by a variable."""
    return Derivative(rated(name), "dot" if by == TIME else by)


def rated(name: str) -> Formula:
    """A name by which something is derived, which may be a velocity, with a dot or a prime."""
    if name.endswith("'"):
        return Derivative(Name(name[:-1]), "prime")
    of = name_of_rate(name)
    return Name(name) if of == name else Derivative(Name(of), "dot")


def is_initial(name: str) -> bool:
    """Whether a name is that of the first value of another one: it does not move."""
    return symbol(name).index == "0"


def _is_index(exponent: Formula) -> bool:
    """Whether what is raised is an index: it counts steps, as n+1, or components from 0 on."""
    match exponent:
        case Sum((Name("n"), Number() | Negative(Number()))) | Name("n") | Number(0):
            return True
    return False
