"""Setting formulas: on one line, or as a display of aligned lines, in any format."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from kowalevski_cas.notation import Formula, Number
from kowalevski_cas.notation.printer import Printer
from kowalevski_cas.report.breaking import Line, break_lines
from kowalevski_cas.report.pieces import Piece, pieces, source_of, width_of

_GAP: Final = 1.5

SHORT: Final = 15.0
"""How wide a formula is at most, in em, within which a line is not broken."""


class Typesetter(ABC):
    """Sets displays in a format, with the printer of that format."""

    printer: Printer
    gap: str
    """What stands between two formulas on one line."""

    @abstractmethod
    def opening_bracket(self, bracket: str, tall: bool) -> str:
        """An opening bracket whose partner stands on another line."""

    @abstractmethod
    def closing_bracket(self, bracket: str, tall: bool) -> str:
        """A closing one, with the power on it."""

    @abstractmethod
    def line(self, left: str, right: str, indent: int, leads: bool) -> str:
        """A line; one that ``leads`` with a sign continues the one above."""

    @abstractmethod
    def lines(self, lines: Sequence[str]) -> str:
        """Several lines one under the other."""

    def inline(self, formula: Formula) -> str:
        """The formula within a line."""
        return self.printer.finish(self.printer(formula))

    def display(self, formulas: Sequence[Formula], room: float) -> str:
        """The inside of a display: formulas in lines no wider than ``room`` em."""
        return self.displays(formulas, (room,))[0]

    def displays(self, formulas: Sequence[Formula], rooms: Sequence[float]) -> list[str]:
        """The same display for several widths."""
        rows = [pieces(formula, self.printer) for formula in formulas]
        # Estimates are good to a few per cent.
        return [self._display(rows, 0.96 * room) for room in rooms]

    def _display(self, rows: Sequence[tuple[Piece, ...]], room: float) -> str:
        if sum(map(width_of, rows)) + _GAP * (len(rows) - 1) <= room:
            return self.printer.finish(self.gap.join(self._join(row) for row in rows))
        lines = self._align(rows, room)
        shown = [
            self.line(
                self._join(line.left),
                self._join(line.right),
                line.indent,
                bool(line.indent) and line.right[0].kind == "sign",
            )
            for line in lines
        ]
        return self.printer.finish(self.lines(shown))

    def _join(self, row: Sequence[Piece]) -> str:
        return source_of(row, self.printer)

    def _align(self, rows: Sequence[tuple[Piece, ...]], room: float) -> list[Line]:
        """The lines of all rows, aligned at their relations where each has a short left side."""
        heads = [next((k for k, p in enumerate(r) if p.kind == "relation"), 0) for r in rows]
        widths = [width_of(row[:head]) for row, head in zip(rows, heads, strict=True)]
        if not all(0 < width <= 0.3 * room for width in widths):
            return [
                line for row in rows for line in break_lines(row, room, self._apart, first=False)
            ]
        lines: list[Line] = []
        for row, head in zip(rows, heads, strict=True):
            first, *others = break_lines(row[head:], room - max(widths), self._apart, first=True)
            lines += [replace(first, left=row[:head]), *others]
        return lines

    def _apart(self, piece: Piece) -> tuple[Piece, Piece]:
        """What stands around the inner pieces of one that is spread over several lines."""
        if not piece.below:
            first, last = piece.inner[0], piece.inner[-1]
            opened = self.opening_bracket(first.text, piece.tall)
            closed = self.closing_bracket(last.text, piece.tall)
            return first._replace(text=opened), last._replace(text=closed)
        inverse = self.printer.fraction(self.printer(Number(1)), self._join(piece.below))
        opened, closed = self.printer.round
        before = self.printer.side_by_side([inverse, self.opening_bracket(opened, tall=True)])
        width = width_of(piece.below) + 1.3
        return Piece(before, width, "open"), Piece(
            self.closing_bracket(closed, tall=True), 0.6, "close"
        )
