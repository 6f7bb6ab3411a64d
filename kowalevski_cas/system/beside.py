r"""What authors print of equations of motion in passing: initial values, columns in italics."""

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
    r"""A display without the names of initial values, which may be any.

    >>> without_initial_values(r"\ddot x=-x, x(t_0)=x_0, \dot x(t_0)=\dot x_0", {"x"})
    '\\ddot x=-x, , '
    """
    found = [
        (start, end, match)
        for start, end in {*split_display(tex)}
        if (match := _INITIAL.fullmatch(tex[start:end].strip(" .;~\n")))
        and names_in(match["left"]) <= {*moving}
    ]
    rest = without(tex, [(start, end) for start, end, _ in found])
    free = [one for one in found if names_in(one[2]["value"]).isdisjoint(names_in(rest))]
    return without(tex, [(start, end) for start, end, _ in free])


_UPRIGHT = re.compile(r"\\(?:mathrm|operatorname|rm)\s*(?:\{\s*i\s*\}|i(?![A-Za-z]))")


def with_upright_unit(tex: str) -> str:
    r"""A display that says what an upright i is: the imaginary unit, and no constant.

    >>> with_upright_unit(r"\dot z=\mathrm{i}kz")
    '\\dot z=ikz,\\quad i^2=-1'
    """
    if not _UPRIGHT.search(tex):
        return tex
    said = "" if re.search(r"i\s*\^\s*\{?2\}?\s*=", tex) else r",\quad i^2=-1"
    return _UPRIGHT.sub("i", tex) + said


_COLUMN = re.compile(
    r"\\d?dot\s*(?:\{\s*(?P<braced>[A-Za-z])\s*\}|\s(?P<name>[A-Za-z]))\s*&?\s*=(?P<force>.*)",
    re.DOTALL,
)


def columns(tex: str) -> dict[str, tuple[str, ...]]:
    r"""The vectors that are printed in italics beside their components, with these.

    They are those of which the rate is a gradient, perhaps times a matrix.

    >>> columns(r"\dot q=J\nabla H, H=q_1^2+q_2^2"), columns(r"\dot q=-\nabla V")
    ({'q': ('q_1', 'q_2')}, {})
    """
    found = dict[str, tuple[str, ...]]()
    for start, end in {*split_display(tex)} if r"\nabla" in tex else ():
        column = _COLUMN.match(tex[start:end].strip())
        if column is not None and r"\nabla" in column["force"]:
            name = column["braced"] or column["name"]
            index = rf"(?<![A-Za-z\\]){name}\s*_\s*\{{?\s*(\d)"
            numbers = sorted({int(number) for number in re.findall(index, tex)})
            if numbers and numbers == [*range(1, len(numbers) + 1)]:
                found[name] = tuple(f"{name}_{number}" for number in numbers)
    return found


def with_columns_in_bold(tex: str, names: Collection[str]) -> str:
    r"""A formula with these names in bold; a function of them is one of their components.

    >>> with_columns_in_bold(r"\dot q=J\nabla H(q)", ["q"])
    '\\dot {\\mathbf{q}}=J\\nabla H'
    """
    for name in names:
        tex = re.sub(rf"(?<![A-Za-z\\])([A-Z])\s*\(\s*{name}\s*\)", r"\1", tex)
        bare = rf"(?<![A-Za-z\\{{]){name}(?![A-Za-z])(?!\s*_)|\{{\s*{name}\s*\}}(?!\s*_)"
        tex = re.sub(bare, rf"{{\\mathbf{{{name}}}}}", tex)
    return tex
