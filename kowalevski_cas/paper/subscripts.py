r"""Derivatives that are printed in an index, as :math:`u_{xxx}+6uu_x-cu_x=0` for a wave."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

_INDEXED = re.compile(
    r"(?P<letter>\\[A-Za-z]+|[A-Za-z])_(?:\{(?P<low>(?P<by>[a-z])(?P=by)*)\}|(?P<one>[a-z]))"
    r"(?![A-Za-z]*_)"
)
_LETTER = re.compile(r"\\(?:begin|end|label)\s*\{[^}]*\}|\\[A-Za-z]+|[A-Za-z]")
_BY = re.compile(r"\\[A-Za-z]+|[A-Za-z]")
_BEHIND_COMMA = re.compile(
    r"(?P<letter>\\[A-Za-z]+|[A-Za-z])\s*_\{(?P<by>\s*,(?:\s*,?\s*(?:\\[A-Za-z]+|[A-Za-z]))+)\s*\}"
)
_SAYS_SO = re.compile(
    r"\{\}\s*_\{\s*,\s*(?P<by>\\[A-Za-z]+|[A-Za-z])\s*\}\s*=\s*\\frac\{d\}\{d\s*(?P=by)\s*\}"
)
_OTHER = re.compile(r"\\d*dot\b|'|\\prime|\\partial|\\frac\s*\{?\s*d\b|\bd[a-z]?\s*/\s*d")


def derived_in_index(texts: Iterable[str]) -> str:
    r"""The variable by which indices derive: the only one, of which nothing else is printed.

    >>> derived_in_index([r"u_{xxx}+6uu_x-cu_x=0"]), derived_in_index([r"u_{xx}=6u^2+x"])
    ('x', '')

    Of a partial differential equation there are two.

    >>> derived_in_index([r"u_t+6uu_x+u_{xxx}=0"]), derived_in_index([r"\ddot x=I_{xx}x"])
    ('', '')
    """
    texts = [*texts]
    if any(map(_OTHER.search, texts)):
        return ""
    found = [match for tex in texts for match in _INDEXED.finditer(tex)]
    several = {
        (match["letter"], match["by"]) for match in found if match["by"] and len(match["low"]) > 1
    }
    letters = {letter for letter, _ in several}
    by = {match["by"] or match["one"] for match in found if match["letter"] in letters}
    if len(by) != 1 or len(letters) != 1:
        return ""
    (name,) = by
    left = (letter for tex in texts for letter in _LETTER.findall(_INDEXED.sub("", tex)))
    return "" if name in left else name


def with_partials(tex: str, arguments: Mapping[str, str]) -> str:
    r"""A formula with partial derivatives for those of functions by their arguments in an index.

    >>> with_partials("w_s+w_{zzz}-6ww_z=0", {"w": "z,s"})[:50]
    '\\frac{\\partial w}{\\partial s}+\\frac{\\partial^3 w}{'
    >>> with_partials("w_1+w_k=0", {"w": "z,s"})
    'w_1+w_k=0'
    """

    def partial(match: re.Match[str]) -> str:
        by, low = arguments.get(match["letter"], "").split(","), match["low"] or match["one"]
        if not {*low} <= {*by}:
            return match[0]
        power = f"^{len(low)}" if len(low) > 1 else ""
        below = f"{low[0]}{power}"
        return rf"\frac{{\partial{power} {match['letter']}}}{{\partial {below}}}"

    return _INDEXED.sub(partial, tex)


def with_rates(tex: str) -> str:
    r"""A formula with quotients for derivatives behind a comma in an index.

    >>> with_rates(r"2\alpha_{,\tau,\tau}=x_{1,2}-q_{,t}, {}_{,t}=\frac{d}{dt}")
    '2\\frac{d^2\\alpha}{d\\tau^2}=x_{1,2}-\\frac{dq}{dt}, '
    """

    def quotient(match: re.Match[str]) -> str:
        by = _BY.findall(match["by"])
        if len({*by}) != 1:
            return match[0]
        power = f"^{len(by)}" if len(by) > 1 else ""
        return rf"\frac{{d{power}{match['letter']}}}{{d{by[0]}{power}}}"

    return _BEHIND_COMMA.sub(quotient, _SAYS_SO.sub("", tex))


def with_derivatives(tex: str, by: str) -> str:
    """A formula with primes for the derivatives by a variable, as long as it was."""

    def primed(match: re.Match[str]) -> str:
        low = match["low"] or match["one"]
        own = by and {*low} == {by}
        # filled up to the same length: errors point at places of the text as it was printed
        return f"{match['letter']}{chr(39) * len(low)}".ljust(len(match[0])) if own else match[0]

    return _INDEXED.sub(primed, tex)
