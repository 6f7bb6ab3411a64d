r"""Functions at the reciprocal of a name that is one itself: with :math:`u=1/r`, F(1/u) is F(r)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.paper.chains import NAME
from kowalevski_cas.source.displays import TypedFormula

_RECIPROCAL = (
    rf"(?:1\s*/\s*(?P<below>{NAME})|(?P<raised>{NAME})\s*\^\s*\{{\s*-\s*1\s*\}}"
    rf"|\\[dt]?frac\s*(?:1|\{{\s*1\s*\}})\s*(?:\{{\s*(?P<braced>{NAME})\s*\}}|(?P<bare>{NAME})))"
)
_GIVEN = re.compile(
    rf"(?<![\w\\}}^/+-])(?P<name>{NAME})\s*&?=\s*{_RECIPROCAL}\s*(?=[,.;&]|$|\\(?:q?quad|\\|text))"
)
_APPLIED = re.compile(
    rf"(?<![A-Za-z\\])(?P<of>{NAME}'*)(?:\s|\\[!,;:])*(?P<left>(?:\\left\s*)?\()\s*{_RECIPROCAL}"
    rf"\s*(?P<right>(?:\\right\s*)?\))"
)


def with_reciprocals(tex: str, before: Sequence[TypedFormula]) -> str:
    """A formula with functions at the names that are reciprocals by what is printed before.

    Nothing is said of a name that is given twice.
    """
    pairs: dict[str, set[str]] = {}
    for found in (found for one in before for found in _GIVEN.finditer(one.tex.strip())):
        name, other = _key(found["name"]), _below(found)
        pairs.setdefault(name, set()).add(other)
        pairs.setdefault(other, set()).add(name)

    def at_name(found: re.Match[str]) -> str:
        others = pairs.get(_below(found), set())
        if len(others) != 1:
            return found[0]
        return f"{found['of']}{found['left']}{next(iter(others))}{found['right']}"

    return _APPLIED.sub(at_name, tex)


def _below(found: re.Match[str]) -> str:
    return _key(found["below"] or found["raised"] or found["braced"] or found["bare"])


def _key(name: str) -> str:
    return name.replace(" ", "")
