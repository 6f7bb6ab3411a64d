r"""Words behind formulas: :math:`a,b\text{ constant}`, and :math:`m\text{ the mass of the body}`.

What is said to be constant is that. Words that describe names, and suppose nothing, say no more
than a comma does; the names that they stand behind are no formula.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation.tokens import BEGINNING, ENDING, Token

CONSTANT = re.compile(r"(?:(?:is|are|being|all|both|an?|some|given|arbitrary|\s)*\s)?constants?")
_SUPPOSING = r"""(?!.*\b(?:or|if|not?|when|where|for|only|unless|except|equal|same|unit|
    (?:non-?)?zero|real|positive|(?:non-?)?negative|integers?|even|odd|small|large|orthogonal|normal|symmetric|at|
    on|as|solutions?|integrals?|functions?)\b)"""
DESCRIPTION = re.compile(
    rf"""(?:(?:is|are|being|denotes?|means)\s)?(?:the|an?)\s{_SUPPOSING}[a-z][a-z -]*
    |\({_SUPPOSING}[a-z][a-z -]*\)""",
    re.VERBOSE,
)
_PRODUCTS = {"[": re.compile("the (?:vector|cross) product")} | dict.fromkeys(
    ("(", r"\langle"), re.compile("the (?:scalar|inner|dot) product")
)
"""The brackets of products, with the words that say so of them, as of :math:`[\\cdot,\\cdot]`."""
_BREAKS = frozenset({"comma", "gap", "row", "cell", "block"})
_OF_NAMES = frozenset({"letter", "number", "_", "{", "}", "prime", "accent"})


def without_names(tokens: list[Token], words: str = "") -> list[Token]:
    """The tokens without the names, or the brackets of a product, that the words describe."""
    kept = len(tokens)
    for first, last in _parts(tokens):
        if _is_product(tokens[first:last], words):
            return tokens[:first]
        if any(token.kind not in _OF_NAMES for token in tokens[first:last]):
            break
        kept = first
    return tokens[:kept]


def _is_product(tokens: list[Token], words: str) -> bool:
    r"""Whether words say of :math:`[\cdot,\cdot]`, and the like, what it is anyway."""
    kinds = [token.kind for token in tokens]
    empty = kinds == ["open", "times", "comma", "times", "close"]
    return empty and bool(_PRODUCTS.get(tokens[0].text, CONSTANT).fullmatch(words))


def with_constants(tokens: list[Token], start: int, end: int) -> list[Token]:
    """The tokens with “= const” behind each name that stands last, or behind the last formula."""
    const = [Token("relation", "=", start, end), Token("const", "const", start, end)]
    found = [*tokens, *const]
    for first, last in [*_parts(tokens)][1:]:
        if any(token.kind not in _OF_NAMES for token in tokens[first:last]):
            break
        found[last:last] = const
    return found


def _parts(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where the formulas between breaks begin and end, from the last one on."""
    last, depth = len(tokens), 0
    for k in range(len(tokens) - 1, -1, -1):
        depth += (tokens[k].kind in ENDING) - (tokens[k].kind in BEGINNING)
        if tokens[k].kind in _BREAKS and not depth:
            if k + 1 < last:
                yield k + 1, last
            last = k
    if last:
        yield 0, last
