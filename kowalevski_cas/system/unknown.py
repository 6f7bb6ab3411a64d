r"""Functions that nothing gives: :math:`V(r)`, :math:`f(t)`, :math:`\nabla U`, :math:`dU/dx`.

Each of their derivatives is a name of its own, :math:`V'` for :math:`V'(r)` and :math:`U_{12}` for
:math:`\partial^2U/\partial x\partial y` (:mod:`kowalevski_cas.paper.jets`).
"""

from __future__ import annotations

import re
from collections.abc import Collection

from kowalevski_cas.notation import Vocabulary, split_display
from kowalevski_cas.notation.cursor import Cursor, is_known
from kowalevski_cas.notation.functions import FUNCTIONS, LETTERS
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.chains import NAME
from kowalevski_cas.paper.constraints import MULTIPLIERS
from kowalevski_cas.paper.jets import APPLIED, Unknown, arguments
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.system.partials import derivatives_of_functions, gradients, moving_names

TIMES, PRIME = ("t", r"\tau"), "'"


_SAID = re.compile(rf"(?P<name>{NAME})\s*=\s*(?P=name)\s*\((?P<by>{NAME}(?:\s*,\s*{NAME})*)\)")


def unknown_functions(tex: str) -> list[Unknown]:
    r"""The functions of which a display says nothing but their arguments.

    >>> unknown_functions(r"\ddot r=-V'(r)+\frac{c^2}{r^3}, \dot x(t)=y(t), \dot y(t)=-x(t)")
    [Unknown(name='V', by=('r',), order=1)]
    >>> unknown_functions(r"\ddot x=-\partial U/\partial x, \ddot y=-\partial U/\partial y")
    [Unknown(name='U', by=('x', 'y'), order=1)]
    >>> unknown_functions(r"\ddot x=-kx, k=k(t)")
    [Unknown(name='k', by=('t',), order=0)]
    """
    display = Display("field", tex, "")
    known = {
        head(name)[0]
        for place in display
        for name in place.heads.names
        if _bare(place.tex).startswith(_bare(head(name)[0]))
    }
    moving = moving_names(tex)
    said = {one for one in said_functions(tex) if symbol(one).letter not in MULTIPLIERS}
    given = known - said | FUNCTIONS | LETTERS.keys() | moving
    applied, derived = _applications(tex), _orders(tex, moving)
    functions = []
    for name in dict.fromkeys((*applied, *derived)):
        matches, orders = applied.get(name, []), derived.get(name, {})
        if name in given or not is_known(symbol(name).letter):
            continue
        lists = {tuple(arguments(match["by"])) for match in matches}
        everywhere = len(re.findall(rf"(?<![A-Za-z\\]){re.escape(name)}(?![A-Za-z_])", tex))
        if len(lists) > 1 or (not orders and name not in said and everywhere != len(matches)):
            continue
        by = min(lists) if lists else tuple(orders)
        if orders or all(_is_argument(one, name, tex) for one in by):
            most = max([len(match["primes"]) for match in matches] + [*orders.values()])
            functions.append(Unknown(name, by, most))
    return functions


def _bare(tex: str) -> str:
    """What is printed without blanks and braces, which a letter may have about it or not."""
    return re.sub(r"[\s{}]", "", tex)


_DOTTED = re.compile(
    rf"\\(?P<dots>d{{0,3}})ot\s*(?:\{{\s*(?P<braced>{NAME})\s*\}}|\s(?P<name>{NAME}))\s*\(\s*t\s*\)"
)


def with_rates_of_functions(tex: str) -> str:
    r"""A display with primes for dots over functions of the time that no equation gives.

    They are printed with the time everywhere, where something else that moves is not.

    >>> with_rates_of_functions(r"\ddot x=-(g+\ddot h(t))\sin x")
    "\\ddot x=-(g+h''(t))\\sin x"
    >>> with_rates_of_functions(r"\dot x(t)=y(t), \dot y(t)=-x(t)")
    '\\dot x(t)=y(t), \\dot y(t)=-x(t)'
    """
    dotted = {one["braced"] or one["name"] for one in _DOTTED.finditer(tex)}
    bare = re.sub(rf"(?:{_DOTTED.pattern})|{NAME}\s*\(\s*t\s*\)", " ", tex)
    if not dotted or not moving_names(bare):
        return tex
    for name in sorted(dotted):
        known = rf"(?<![A-Za-z\\]){re.escape(name)}(?![A-Za-z_])"
        given = any(
            re.match(rf"\s*(?:\\d{{0,3}}ot\s*)?\{{?\s*{known}", tex[start:end])
            for start, end in split_display(tex)
        )
        if not given and not re.search(known, bare):
            own, plain = rf"(?:\{{\s*{known}\s*\}}|\s{known})", name.replace("\\", r"\\")
            for dots in ("d", "dd", "ddd"):
                rate = rf"\\{dots}ot\s*{own}\s*\(\s*t\s*\)"
                tex = re.sub(rate, f"{plain}{PRIME * len(dots)}(t)", tex)
    return tex


def said_functions(tex: str) -> list[str]:
    r"""The names of which it is said what they are functions of, as in :math:`k=k(t)`."""
    parts = (_SAID.fullmatch(tex[start:end].strip(" .;")) for start, end in split_display(tex))
    return [said["name"].replace(" ", "") for said in parts if said]


def without_said_functions(tex: str) -> str:
    r"""A display without such statements, of which nothing but the argument is known.

    >>> without_said_functions(r"\ddot x=-kx, k=k(t)")
    '\\ddot x=-kx, '
    """
    for start, end in reversed(split_display(tex)):
        if _SAID.fullmatch(tex[start:end].strip(" .;")):
            tex = tex[:start] + tex[end:]
    return tex


def check_said(names: Collection[str], constants: Collection[str]) -> None:
    """Refuse a constant that is said to be a function, and is no multiplier of a constraint."""
    for name in names:
        if name in constants:
            raise ValueError(f"{name} is said to be a function: print it with its argument")


def _applications(tex: str) -> dict[str, list[re.Match[str]]]:
    """Where names stand before arguments in brackets."""
    applied: dict[str, list[re.Match[str]]] = {}
    for match in APPLIED.finditer(tex):
        applied.setdefault(match["name"].replace(" ", ""), []).append(match)
    return applied


def _orders(tex: str, moving: Collection[str]) -> dict[str, dict[str, int]]:
    """The names that are derived by what moves, with how often they are by each of these."""
    derived: dict[str, dict[str, int]] = {}
    for name, by, order in (*derivatives_of_functions(tex, moving), *gradients(tex, moving)):
        orders = derived.setdefault(name, {})
        orders[by] = max(order, orders.get(by, 0))
    return derived


def _is_argument(by: str, function: str, tex: str) -> bool:
    """Whether a name may be an argument: a time, a coordinate, or what stands in the display."""
    return by in TIMES or _has_momentum(by, tex) or _stands_elsewhere(by, function, tex)


def _has_momentum(by: str, tex: str) -> bool:
    """Whether the momentum of a coordinate stands in a display: p beside q, or with its index."""
    index = by.partition("_")[2] or by
    momenta = [f"p_{index}", f"p_{{{index}}}", *(["p"] if "_" not in by else [])]
    return any(re.search(rf"(?<![A-Za-z\\]){re.escape(p)}(?![A-Za-z_])", tex) for p in momenta)


def _stands_elsewhere(by: str, function: str, tex: str) -> bool:
    """Whether an argument is a name of the display."""
    rest = APPLIED.sub(lambda match: "" if match["name"] == function else match[0], tex)
    names = (letter + index for letter, index in Cursor(rest, scan(rest), Vocabulary()).letters())
    known = {part for name in names for part in (name, symbol(name).without_type.name)}
    return by in known or any(symbol(one).index == by for one in known)
