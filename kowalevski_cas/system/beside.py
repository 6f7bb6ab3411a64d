r"""What authors print of equations of motion in passing: an upright i, columns in italics."""

from __future__ import annotations

import re
from collections.abc import Collection

from kowalevski_cas.notation import split_display

_UPRIGHT = re.compile(
    r"(?P<joined>(?<=[A-Za-z]))?\\(?:(?:mathrm|operatorname|rm)\s*\{\s*i\s*\}"
    r"|(?:mathrm|operatorname)\s+i|rm\s+i(?![A-Za-z]))"
)


def with_upright_unit(tex: str) -> str:
    r"""A display that says what an upright i is: the imaginary unit, and no constant.

    >>> with_upright_unit(r"\dot z=\mathrm{i}kz")
    '\\dot z=ikz,\\quad i^2=-1'
    >>> with_upright_unit(r"\dot z=2\pi\mathrm iz, i^2=-1")
    '\\dot z=2\\pi iz, i^2=-1'
    """
    if not _UPRIGHT.search(tex):
        return tex
    said = "" if re.search(r"i\s*\^\s*\{?2\}?\s*=", tex) else r",\quad i^2=-1"
    return _UPRIGHT.sub(lambda unit: "i" if unit["joined"] is None else " i", tex) + said


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
