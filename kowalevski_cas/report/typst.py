"""The report as Typst, which makes its PDF where there is no LaTeX."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Final

from kowalevski_cas.notation.typst import TYPST
from kowalevski_cas.report.context import Report, report
from kowalevski_cas.report.names import anchor
from kowalevski_cas.report.plates import Plate
from kowalevski_cas.report.setting import Setter
from kowalevski_cas.report.witnesses import Witness
from kowalevski_cas.report.writer import Writer
from kowalevski_cas.verify.outcome import Run

_SPECIAL: Final = re.compile(r"([\\#$*_`@<>\[\]~=/])")


def render_typst(
    run: Run,
    plates: tuple[Plate, ...] = (),
    certified: Mapping[str, str] | None = None,
    programs: tuple[Witness, ...] = (),
) -> str:
    """The same report as a Typst document; its picture is a file of its own beside it."""
    return TypstWriter(report(run, certified, programs)).write(plates)


class TypstSetter(Setter):
    """Displays in the mathematics of Typst, with its points of alignment."""

    printer = TYPST
    gap = ", quad "

    def opened(self, bracket: str, tall: bool) -> str:
        return _alone(bracket, tall)

    def closed(self, bracket: str, tall: bool) -> str:
        return _alone(bracket[0], tall) + bracket[1:]

    def line(self, left: str, right: str, indent: int, leads: bool) -> str:
        # Something empty before a sign makes it an operation.
        nothing = '"" ' if leads else ""
        return f"{left} & {'quad ' * indent}{nothing}{right}".strip()

    def left_out(self, lines: int) -> str:
        return f'& quad "" + dots.c quad "({lines} more lines)"'

    def lines(self, lines: Sequence[str]) -> str:
        return " \\\n".join(lines)


def _alone(bracket: str, tall: bool) -> str:
    """A bracket that has no partner on its line."""
    return f"lr⟮\\{bracket}, size: #2.2em⟯" if tall else f"\\{bracket}"


class TypstWriter(Writer):
    """The report in Typst."""

    suffix, space = "typ", "\u2009"
    setter = TypstSetter()

    def escaped(self, text: str) -> str:
        return _SPECIAL.sub(r"\\\1", text)

    def property(self, text: str) -> str:
        return self.words(text)

    def within(self, mathematics: str) -> str:
        return f"${mathematics}$"

    def displayed(self, mathematics: str) -> str:
        return f"#display($ {mathematics} $)"

    def in_cell(self, mathematics: str) -> str:
        return f"#cell($ {mathematics} $)"

    def verbatim(self, source: str) -> str:
        return f"#raw({quoted(' '.join(source.split()))})"

    def linked(self, claim: str) -> str:
        return f"#link(<claim.{anchor(claim)}>, raw({quoted(claim)}));"

    def picture(self, report: Report) -> str:
        return '#image("picture.svg")'


def quoted(text: str) -> str:
    """A string of Typst."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
