"""Printed names: of what they are made, and what one name can be."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from kowalevski_cas.notation.functions import FAMILY_OF
from kowalevski_cas.notation.symbol import symbol


def is_bold(name: str) -> bool:
    """Whether a name is printed in bold, that is, denotes a vector or a matrix."""
    return symbol(head(name)[0]).is_bold


def is_capital(name: str) -> bool:
    """Whether a name is a bold capital, that is, may denote a matrix."""
    parts = symbol(head(name)[0])
    return parts.font == r"\mathbf" and parts.letter.isupper()


Images = tuple[tuple[str, str], ...]
"""The variables of a map with the names of their images."""

BRACKET, EPSILON, DELTA = r"\{", r"\varepsilon_{ijk}", r"\delta_{ij}"
"""The Poisson bracket as a function, the sign of a permutation, and Kronecker's delta."""


def is_indexed(name: str) -> bool:
    """Whether a coordinate in a printed bracket has an index that stands for each of 1, 2, 3."""
    return name.endswith(("_i", "_j"))


def summation_indices(arguments: Iterable[str]) -> set[str]:
    r"""What is summed over k in a bracket of these coordinates, if they are indexed.

    >>> sorted(summation_indices(("M_i", "p_j")))
    ['M_k', '\\varepsilon_{ijk}', 'p_k']
    """
    found = {f"{argument[:-1]}k" for argument in arguments if is_indexed(argument)}
    return {EPSILON, *found} if found else found


@cache
def head(name: str) -> tuple[str, tuple[str, ...]]:
    r"""The function and its arguments in a head like ``\varphi(s)``; a bare name has none.

    >>> head("f(s)"), head("H"), head(r"\{M_i,M_j\}")[1]
    (('f', ('s',)), ('H', ()), ('M_i', 'M_j'))
    """
    if name.startswith(BRACKET):
        return BRACKET, tuple(name[2:-2].split(","))
    function, _, arguments = name.partition("(")
    return function, tuple(arguments.removesuffix(")").split(",")) if arguments else ()


def primitive(function: str) -> tuple[str, int]:
    r"""The function of which another one is a derivative by its argument, and which derivative.

    >>> primitive("V''"), primitive("V"), primitive(r"\wp'")
    (('V', 2), ('V', 0), ("\\wp'", 0))
    """
    base = function if function in FAMILY_OF else function.rstrip("'")
    return base, len(function) - len(base)


FREE = (
    {"a variable", "a root"},  # a coordinate, by an equation for its square
    {"a constant", "a root"},
    {"a variable", "a component"},
    {"a constant", "a component"},
    {"a root", "a component"},
    {"defined", "a component"},
)
"""What a name may be at the same time."""


def check_names(owner: str, given: Iterable[tuple[str, str]]) -> None:
    """Refuse a name that is given twice, each time with what it is; raises ``ValueError``."""
    known: dict[str, str] = {}
    for kind, name in given:
        if name in known and {kind, known[name]} not in FREE:
            raise ValueError(
                f"{owner}: {name} has a meaning already, {known[name]}: "
                f"it cannot be {kind} as well; choose another name, or leave one out"
            )
        known[name] = kind
