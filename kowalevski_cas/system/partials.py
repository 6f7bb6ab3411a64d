r"""Derivatives of functions by what moves, as :math:`\frac{dU}{dx}` beside :math:`\ddot x`.

They stand beside rates, and are no rates themselves: U is a function of x.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from kowalevski_cas.notation.layout import statements
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tokens import Token

TIMES = frozenset({"t", r"\tau"})
NABLA, GRAD, D, PARTIAL = r"\nabla", r"\mathrm{grad}", "d", r"\partial"

BY_RATE = "accent"
"""By what a Lagrangian is derived."""


class DerivativeOfFunction(NamedTuple):
    """A derivative with the name of the function, by what it is derived, and how often."""

    function: str
    by: str
    order: int


def moving_names(tex: str) -> frozenset[str]:
    r"""The names that stand under dots, or are derived by the time.

    >>> sorted(moving_names(r"\ddot{\mathbf r}=0, \frac{dx_1}{dt}=y, dy/dt=x, \frac{dU}{dx}=1"))
    ['\\mathbf{r}', 'x_1', 'y']
    """
    found = set[str]()
    for statement in statements(tex):
        tokens = statement.tokens
        for k, token in enumerate(tokens):
            if token.kind == "accent":
                found.add(_name(tokens, k + 1 + (tokens[k + 1].kind == "{"))[0])
        found |= {one.function for one, _ in _quotients(tokens) if one.by in TIMES}
    return frozenset(found - {""})


def derivatives_of_functions(tex: str, moving: Collection[str]) -> Iterator[DerivativeOfFunction]:
    r"""The derivatives by what moves, of what does not, and is not derived by rates as well.

    >>> [*derivatives_of_functions(r"\ddot x=-\partial V(x,y)/\partial x", {"x"})]
    [DerivativeOfFunction(function='V', by='x', order=1)]
    """
    found = [one for statement in statements(tex) for one, _ in _quotients(statement.tokens)]
    by_rates = {one.function for one in found if one.by == BY_RATE}
    for one in found:
        if one.by in moving and one.function not in moving and one.function not in by_rates:
            yield one


def gradients(tex: str, moving: Collection[str]) -> Iterator[DerivativeOfFunction]:
    r"""The gradients by the only vector that moves, as :math:`\nabla U`."""
    vectors = [name for name in moving if symbol(name).is_bold]
    tokens = scan(tex)
    for k, token in enumerate(tokens[:-1]):
        if token.text in (NABLA, GRAD) and len(vectors) == 1:
            if function := _name(tokens, k + 1)[0]:
                yield DerivativeOfFunction(function, vectors[0], 1)


def with_partials(tex: str, moving: Collection[str]) -> str:
    r"""A display with :math:`\partial` for d in such derivatives, and :math:`\nabla` for grad.

    >>> with_partials(r"\ddot x=-\frac{dU}{dx}", {"x"})
    '\\ddot x=-\\frac{\\partial U}{\\partial x}'
    """
    tokens = scan(tex)
    changed = {t: NABLA for t in tokens if t.text == GRAD}
    for one, ds in _quotients(tokens):
        indexed = {name for name in moving if symbol(name).head == symbol(one.by).head}
        if indexed and one.by not in TIMES and one.function not in moving:
            changed |= {d: PARTIAL for d in ds if d.text == D}
    for token in sorted(changed, key=lambda t: -t.start):
        tex = f"{tex[: token.start]}{changed[token]} {tex[token.end :]}"
    return tex


def _quotients(
    tokens: Sequence[Token],
) -> Iterator[tuple[DerivativeOfFunction, tuple[Token, Token]]]:
    """The quotients of differentials of names, with their signs of differentials."""
    for k, token in enumerate(tokens):
        if token.kind == "frac":
            above = _differential(tokens, k + 1 + (tokens[k + 1].kind == "{"))
        elif token.text in (D, PARTIAL) and token.kind == "letter":
            above = _differential(tokens, k)
        else:
            continue
        if above is None:
            continue
        function, order, end = above
        end = _behind_arguments(tokens, end)
        between = [t.kind for t in tokens[end : end + 2]]
        if between == ["}", "{"] and token.kind == "frac":
            below = _differential(tokens, end + 2)
        elif between[:1] == ["slash"] and token.kind != "frac":
            below = _differential(tokens, end + 1)
        else:
            continue
        first = k + 1 + (tokens[k + 1].kind == "{") if token.kind == "frac" else k
        second = end + (2 if token.kind == "frac" else 1)
        if tokens[first].text != tokens[second].text:
            continue
        if below is not None or tokens[second + 1].kind == BY_RATE:
            by = BY_RATE if below is None else below[0]
            yield DerivativeOfFunction(function, by, order), (tokens[first], tokens[second])


def _differential(tokens: Sequence[Token], k: int) -> tuple[str, int, int] | None:
    """The name behind a d or a ∂, the order of the derivative, and where it ends."""
    if k + 1 >= len(tokens) or tokens[k].text not in (D, PARTIAL):
        return None
    order, k = _power(tokens, k + 1)
    name, end = _name(tokens, k)
    behind, end = _power(tokens, end)
    return (name, max(order, behind), end) if name else None


def _power(tokens: Sequence[Token], k: int) -> tuple[int, int]:
    """The power that is printed here, 1 if there is none, and where it ends."""
    kinds = [token.kind for token in tokens[k : k + 4]]
    braced = kinds[1:2] == ["{"]
    if kinds[:1] != ["^"] or kinds[1 + braced : 2 + braced] != ["number"]:
        return 1, k
    return int(tokens[k + 1 + braced].text), k + 2 + 2 * braced


def _name(tokens: Sequence[Token], k: int) -> tuple[str, int]:
    """The name that begins here, and where it ends; empty if none does."""
    if k >= len(tokens) or tokens[k].kind != "letter":
        return "", k
    letter, k = tokens[k].text, k + 1
    under = k + (k < len(tokens) and tokens[k].kind == "}")  # as in {\dot{\bf r}}_1
    if [token.kind for token in tokens[under : under + 1]] != ["_"]:
        return letter, k
    k = under + 1
    if tokens[k].kind != "{":
        return symbol(f"{letter}_{{{tokens[k].text}}}").name, k + 1
    end = next(n for n in range(k, len(tokens)) if tokens[n].kind == "}")
    low = "".join(token.text for token in tokens[k + 1 : end])
    return symbol(f"{letter}_{{{low}}}").name, end + 1


def _behind_arguments(tokens: Sequence[Token], k: int) -> int:
    """Where the arguments in brackets end that are printed here."""
    if k < len(tokens) and tokens[k].text == "(":
        while tokens[k].kind != "close":
            k += 1
        return k + 1
    return k
