r"""Values at the beginning of motions, :math:`x(0)=x_0`, that stand beside equations of motion."""

from __future__ import annotations

import re
from collections.abc import Collection

from kowalevski_cas.notation import split_display
from kowalevski_cas.paper.chains import NAME, RATE, names_in, without

_START = r"\(\s*(?:[A-Za-z]_\{?[0A-Za-z]\}?|0)\s*\)"
_INITIAL = re.compile(
    rf"(?P<left>{RATE}|{NAME})\s*{_START}\s*=\s*(?P<value>{RATE}|{NAME})", re.ASCII
)


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
