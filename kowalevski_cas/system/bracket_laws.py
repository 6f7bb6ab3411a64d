r"""Laws that are printed for any function: :math:`\dot f=\{f,H\}`, and brackets by gradients.

They are written out for the coordinates: :math:`\dot M_1=\{M_1,H\}`, and for
:math:`\{F,G\}=-\mathbf M\cdot(\nabla F\times\nabla G)` the brackets of the components of M.
"""

from __future__ import annotations

import re
from itertools import combinations

from kowalevski_cas.notation import split_display
from kowalevski_cas.paper.chains import NAME

_BOLD = r"\\(?:mathbf|boldsymbol|bm|vec)\s*(?:\{\s*\\?[A-Za-z]+\s*\}|\\?[A-Za-z]+)"
_OF_FUNCTIONS = re.compile(
    rf"\\\{{\s*(?P<F>[A-Za-z])\s*,\s*(?P<G>[A-Za-z])\s*\\\}}\s*(?:\(\s*(?P<by>{_BOLD})\s*\))?"
    r"\s*&?\s*=(?P<right>.*)",
    re.DOTALL,
)
_LAW = re.compile(
    r"\\dot\s*(?:\{\s*(?P<braced>[A-Za-z])\s*\}|\s(?P<bare>[A-Za-z]))\s*&?\s*=\s*"
    r"\\\{\s*(?P<first>\\?[A-Za-z]+)\s*,\s*(?P<second>\\?[A-Za-z]+)\s*\\\}"
)
_BRACKET = re.compile(rf"\\\{{\s*(?P<x>{NAME})\s*,\s*(?P<y>{NAME})\s*\\\}}\s*&?\s*=")


def with_laws_of_brackets(tex: str) -> str:
    r"""Equations of motion with brackets and laws for the coordinates, not for any function.

    >>> with_laws_of_brackets(r"\{x,y\}=z, H=x^2, \dot F=\{F,H\}")
    '\\{x,y\\}=z, H=x^2, \\dot{x}=\\{x,H\\},\\quad \\dot{y}=\\{y,H\\}'
    """
    return _with_law(_with_brackets(tex))


def _statements(tex: str) -> list[tuple[int, int]]:
    """Where the statements stand, the last one first."""
    return sorted({*split_display(tex)}, reverse=True) if r"\{" in tex else []


def _stands(name: str, tex: str) -> bool:
    return re.search(rf"(?<![A-Za-z\\]){name}(?![A-Za-z])", tex) is not None


def _with_brackets(tex: str) -> str:
    for start, end in _statements(tex):
        found = _OF_FUNCTIONS.fullmatch(tex[start:end].strip(" .;"))
        if found is None or any(rf"\nabla {found[f]}" not in found["right"] for f in "FG"):
            continue
        vector = found["by"] or min(re.findall(_BOLD, found["right"]), default="")
        names = _components(vector, tex)
        unit = [f"({','.join(str(int(j == k)) for j in range(3))})" for k in range(3)]
        rows = []
        for j, k in combinations(range(len(names)), 2):
            right = found["right"].replace(rf"\nabla {found['F']}", unit[j])
            right = right.replace(rf"\nabla {found['G']}", unit[k])
            rows.append(rf"\{{{names[j]},{names[k]}\}}={right}")
        if rows:
            tex = tex[:start] + r",\quad ".join(rows) + tex[end:]
    return tex


def _components(vector: str, tex: str) -> list[str]:
    """The names of the three components of a vector: those that are listed, or with numbers."""
    listed = re.search(rf"{re.escape(vector)}\s*=\s*\(([^()]*)\)", tex)
    if listed:
        names = [one.strip() for one in listed[1].split(",")]
        return names if len(names) == 3 and all(re.fullmatch(NAME, n) for n in names) else []
    letter = re.sub(r"\\(?:mathbf|boldsymbol|bm|vec)|[\s{}]", "", vector)
    return [f"{letter}_{k}" for k in (1, 2, 3)] if letter else []


def _with_law(tex: str) -> str:
    for start, end in _statements(tex):
        law = _LAW.fullmatch(tex[start:end].strip(" .;"))
        if law is None:
            continue
        any_, sides = law["braced"] or law["bare"], [law["first"], law["second"]]
        rest = tex[:start] + "," + tex[end:]
        if sides.count(any_) == 1 and not _stands(any_, rest):
            rows = []
            for x in _coordinates(rest):
                first, second = (x if one == any_ else one for one in sides)
                rows.append(rf"\dot{{{x}}}=\{{{first},{second}\}}")
            tex = tex[:start] + r",\quad ".join(rows) + tex[end:] if rows else tex
    return tex


def _coordinates(tex: str) -> list[str]:
    """The names of which brackets are printed, an index i or j with its three values."""
    found = dict.fromkeys(name for one in _BRACKET.finditer(tex) for name in one.group("x", "y"))
    names = list[str]()
    for name in found:
        index = re.fullmatch(r"(.+)_\{?[ij]\}?", name)
        names += [f"{index[1]}_{k}" for k in (1, 2, 3)] if index else [name]
    return [*dict.fromkeys(names)]
