r"""Complex names with the names of their real parts: :math:`z=x+iy`, :math:`x+iy=u^2`.

The letter i is the imaginary unit there. Where the parts do not move by equations of their own,
they are what z says: :math:`x=\frac{z+\bar z}{2}`, :math:`y=\frac{z-\bar z}{2i}`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import split_display

_NAME = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{[^{}]*\}))?"
_PARTS = rf"(?P<x>{_NAME})\s*\+\s*(?:i\s*(?P<y>{_NAME})|(?P<y2>{_NAME})\s*i(?![A-Za-z]))"
_SIDES = (
    re.compile(rf"(?P<z>.*[^\s=])\s*=\s*{_PARTS}", re.DOTALL),
    re.compile(rf"{_PARTS}\s*=\s*(?P<z>[^\s=].*)", re.DOTALL),
)


def with_real_parts(tex: str) -> str:
    r"""A display in which the real parts of complex names are given by these.

    >>> with_real_parts(r"i\dot z=z, z=x+iy")
    'i\\dot z=z, x=\\frac{z+\\overline{z}}{2},\\quad y=\\frac{z-\\overline{z}}{2i},\\quad i^2=-1'
    """
    found = [*_found(tex)]
    for start, end, z, x, y in reversed(found):
        if any(_moves(name, tex) for name in (x, y)):
            continue
        bar = rf"\overline{{{z}}}"
        rows = rf"{x}=\frac{{{z}+{bar}}}{{2}},\quad {y}=\frac{{{z}-{bar}}}{{2i}}"
        tex = tex[:start] + rows + tex[end:]
    said = not found or re.search(r"i\s*\^\s*\{?2\}?\s*=", tex)
    return tex if said else rf"{tex},\quad i^2=-1"


def _found(tex: str) -> Iterator[tuple[int, int, str, str, str]]:
    """The statements that name real parts, in their order: z, x and y."""
    for start, end in sorted({*split_display(tex)}) if re.search(r"\bi|i\b|\di", tex) else ():
        for sides in _SIDES:
            if one := sides.fullmatch(tex[start:end].strip(" .;")):
                yield start, end, one["z"], one["x"], one["y"] or one["y2"]
                break


def _moves(name: str, tex: str) -> bool:
    """Whether the rate or the image of a name is printed."""
    name = re.escape(name)
    rate = rf"\\d?dot\s*\{{?\s*{name}|d(?:\^\{{?\d\}}?)?\s*{name}\s*[}}/]|{name}'"
    return re.search(rf"(?:{rate})(?![A-Za-z_])", tex) is not None
