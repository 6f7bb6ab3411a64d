r"""Words behind formulas: :math:`a,b\text{ constant}`, and :math:`m\text{ the mass of the body}`.

What is said to be constant is that. Words that describe names, and suppose nothing, say no more
than a comma does; the names that they stand behind are no formula.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation.tokens import BEGINNING, ENDING, Token

CONSTANT = re.compile(r"(?:(?:is|are|being|all|both|an?|some|given|arbitrary|\s)*\s)?constants?")
DESCRIPTION = re.compile(
    r"""(?:(?:is|are|being|denotes?|means)\s)?(?:the|an?)\s
    (?!.*\b(?:or|if|not?|when|where|for|only|unless|except|equal|same|unit|(?:non-?)?zero|real|
    positive|(?:non-?)?negative|integers?|even|odd|small|large|orthogonal|normal|symmetric|at|on|
    as|solutions?|integrals?|functions?)\b)
    [a-z][a-z -]*""",
    re.VERBOSE,
)
_BREAKS = frozenset({"comma", "gap", "row", "cell", "block"})
_OF_NAMES = frozenset({"letter", "number", "_", "{", "}", "prime", "accent"})


def without_names(tokens: list[Token]) -> list[Token]:
    """The tokens without the names that stand last among them, between breaks."""
    kept = len(tokens)
    for first, last in _parts(tokens):
        if any(token.kind not in _OF_NAMES for token in tokens[first:last]):
            break
        kept = first
    return tokens[:kept]


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
