r"""Values at the beginning of motions, :math:`x(0)=x_0`, that stand beside equations of motion."""

from __future__ import annotations

import re
from collections.abc import Collection

from kowalevski_cas.notation import split_display
from kowalevski_cas.paper.chains import NAME, RATE, names_in, without

_TIME = r"(?:[A-Za-z]_\{?[0A-Za-z]\}?|0)"
_START = rf"\(\s*{_TIME}\s*\)"
_INITIAL = re.compile(
    rf"(?P<left>{RATE}|{NAME})\s*{_START}\s*=\s*(?P<value>{RATE}|{NAME})", re.ASCII
)
_AT_START = re.compile(
    rf"\s*(?P<left>{RATE}|{NAME})(?P<behind>\s*\(\s*(?P<time>{_TIME})\s*\)"
    rf"|\s*(?:\\[bB]igg?r?\s*)?[|]\s*_\{{\s*t\s*=\s*(?P<at>{_TIME})\s*\}})\s*=",
    re.ASCII,
)
"""What moves, at the time at which it begins to, on the left of its value."""
_ANY = re.compile(rf"(?P<left>{RATE}|{NAME})(?P<behind>\s*\(\s*t\s*\))", re.ASCII)
"""A name at the time t."""


def at_the_beginning(tex: str, moving: Collection[str]) -> tuple[str, dict[int, str]]:
    r"""A display with initial values without their time, and where these statements begin.

    It is as long as before. What moves may not stand in the values.

    >>> at_the_beginning(r"x(0)=0, \dot x(t_0)=v", {"x"})
    ('x   =0, \\dot x     =v', {0: '0', 8: 't_0'})
    """
    times = dict[int, str]()
    for start, end in dict.fromkeys(split_display(tex)):
        statement, value, time = _without_time(tex[start:end], moving)
        if time and names_in(value).isdisjoint(moving):
            tex = tex[:start] + statement + tex[end:]
            times[start] = time
    return tex, times


def at_any_time(tex: str, moving: Collection[str]) -> str:
    r"""A display in which what moves stands without its time; it is as long as before.

    >>> at_any_time(r"x(t) = x_0 + f(t)", {"x"})
    'x    = x_0 + f(t)'
    """
    for found in _ANY.finditer(tex):
        if names_in(found["left"]) <= {*moving}:
            start, end = found.span("behind")
            tex = tex[:start] + " " * (end - start) + tex[end:]
    return tex


def _without_time(statement: str, moving: Collection[str]) -> tuple[str, str, str]:
    """A statement of initial values without their time, the value, and this time."""
    at, time = 0, ""
    while (found := _AT_START.match(statement, at)) and names_in(found["left"]) <= {*moving}:
        start, end = found.span("behind")
        statement = statement[:start] + " " * (end - start) + statement[end:]
        at, time = found.end(), found["time"] or found["at"]
    return statement, statement[at:], time


def without_initial_values(tex: str, moving: Collection[str]) -> str:
    r"""A display without the names of initial values, which may be any; it is as long as before.

    >>> without_initial_values(r"\ddot x=-x, x(t_0)=x_0", {"x"})
    '\\ddot x=-x,           '
    """
    found = [
        (start, end, match)
        for start, end in {*split_display(tex)}
        if (match := _INITIAL.fullmatch(tex[start:end].strip(" .;~\n")))
        and names_in(match["left"]) <= {*moving}
    ]
    rest = without(tex, [(start, end) for start, end, _ in found])
    free = [one for one in found if names_in(one[2]["value"]).isdisjoint(names_in(rest))]
    for start, end, _ in free:
        tex = tex[:start] + " " * (end - start) + tex[end:]
    return tex


def names_under_dots(tex: str) -> set[str]:
    r"""The names of which rates are printed by dots.

    >>> sorted(names_under_dots(r"\ddot x=-x+\dot{y}_1"))
    ['x', 'y_1']
    """
    return {name for rate in re.findall(RATE, tex) for name in names_in(rate)}
