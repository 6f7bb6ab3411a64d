"""Setting a formula: on one line, or as a display of aligned lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from kowalevski_cas.report.mathematics.breaking import Line, broken
from kowalevski_cas.report.mathematics.nodes import Node, joined, measured, split, trimmed
from kowalevski_cas.report.mathematics.reader import read


def plain(tex: str) -> str:
    r"""The same formula in today's LaTeX, on one line.

    >>> plain(r"{\bf e}_1 \times {\bs \alpha}")
    '\\mathbf{e}_1 \\times \\boldsymbol{\\alpha}'
    >>> plain(r"\mathop{\rm Re}\nolimits (x_2 z_1)")
    '\\operatorname{Re}(x_2z_1)'
    """
    return r"\quad ".join(map(joined, _statements(tex)))


def width(tex: str) -> float:
    """The estimated width of a formula set on one line in display style, in em."""
    return measured(read(tex))


def display(tex: str, room: float, *, lines: int | None = None) -> str:
    r"""The inside of a display: the formula broken into lines no wider than ``room`` em.

    A display of more than ``lines`` lines is shortened: dots stand for the middle.
    """
    return displays([tex], room, lines=lines)


def displays(formulas: Sequence[str], room: float, *, lines: int | None = None) -> str:
    """The inside of a display of several formulas, one under the other."""
    statements = [statement for tex in formulas for statement in _statements(tex)]
    room *= 0.97  # estimates are good to a few per cent
    if len(statements) == 1 and measured(statements[0]) <= room:
        return joined(statements[0])
    rows = _aligned(statements, room)
    if lines is not None and len(rows) > lines:
        left_out = len(rows) - lines + 1
        dots = Line("", rf"+ \cdots \quad\text{{({left_out} more lines)}}", 1)
        rows = [*rows[: lines - 2], dots, rows[-1]]
    if len(rows) == 1:
        return f"{rows[0].left} {rows[0].right}".strip()
    body = " \\\\\n".join(row.tex for row in rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _statements(tex: str) -> list[tuple[Node, ...]]:
    """The rows of a display; a row that begins with a sign continues the one above."""
    nodes = read(tex)
    if len(nodes) == 1 and nodes[0].rows and nodes[0].tex.startswith(r"\begin{array}"):
        rows: list[tuple[Node, ...]] = [
            trimmed([node for cell in row for node in (*cell, Node(r"\quad ", 1.0, "space"))])
            for row in nodes[0].rows
        ]
    else:
        rows = [tuple(node for node in row if node.kind != "cell") for row in split(nodes, "row")]
    statements: list[tuple[Node, ...]] = []
    for row in filter(None, map(trimmed, rows)):
        if statements and row[0].kind in {"bin", "rel"}:
            above = statements[-1]
            repeated = above[-1].tex == row[0].tex
            statements[-1] = (*(above[:-1] if repeated else above), *row)
        else:
            statements.append(row)
    return statements or [()]


def _aligned(statements: Sequence[tuple[Node, ...]], room: float) -> list[Line]:
    """The lines of all statements, aligned at their relations where each has a short left side."""
    heads = [_head(statement) for statement in statements]
    widths = [measured(s[:head]) for s, head in zip(statements, heads, strict=True)]
    if not all(0 < width <= 0.3 * room for width in widths):
        return [line for s in statements for line in broken(s, room, first=False)]
    rows: list[Line] = []
    for statement, head in zip(statements, heads, strict=True):
        first, *others = broken(statement[head:], room - max(widths), first=True)
        rows += [replace(first, left=joined(statement[:head])), *others]
    return rows


def _head(nodes: Sequence[Node]) -> int:
    """Where the first relation outside brackets stands; 0 if there is none."""
    depth = 0
    for place, node in enumerate(nodes):
        depth += {"open": 1, "close": -1}.get(node.kind, 0)
        if node.kind == "rel" and depth <= 0:
            return place
    return 0
