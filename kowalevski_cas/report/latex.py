"""The report as LaTeX: the same bytes from run to run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kowalevski_cas.notation.latex import LATEX
from kowalevski_cas.report.context import Report, report
from kowalevski_cas.report.escaping import ascii_only, escaped
from kowalevski_cas.report.graph.tikz import tikz
from kowalevski_cas.report.names import anchor
from kowalevski_cas.report.plates import Plate
from kowalevski_cas.report.setting import Setter
from kowalevski_cas.report.witnesses import Witness
from kowalevski_cas.report.writer import Writer
from kowalevski_cas.verify.outcome import Run


def render_latex(
    run: Run,
    plates: tuple[Plate, ...] = (),
    certified: Mapping[str, str] | None = None,
    programs: tuple[Witness, ...] = (),
) -> str:
    """The report of a run as a LaTeX document, with what other commands made and confirmed."""
    return LatexWriter(report(run, certified, programs)).write(plates)


class LatexSetter(Setter):
    """Displays in LaTeX, with the environment ``aligned``."""

    printer = LATEX
    gap = r",\quad "

    def opened(self, bracket: str, tall: bool) -> str:
        return rf"\Bigl{bracket}" if tall else bracket

    def closed(self, bracket: str, tall: bool) -> str:
        return rf"\Bigr{bracket}" if tall else bracket

    def line(self, left: str, right: str, indent: int, leads: bool) -> str:
        space = r"\quad " * (indent % 2) + r"\qquad " * (indent // 2)
        return f"{left} & {space}{'{} ' if leads else ''}{right}".strip()

    def left_out(self, lines: int) -> str:
        return rf"& \quad {{}} + \cdots \quad\text{{({lines} more lines)}}"

    def lines(self, lines: Sequence[str]) -> str:
        body = " \\\\\n".join(lines)
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


class LatexWriter(Writer):
    """The report in LaTeX."""

    suffix, space = "tex", r"\,"
    setter = LatexSetter()

    def escaped(self, text: str) -> str:
        return escaped(text)

    def property(self, text: str) -> str:
        return ascii_only(text)

    def within(self, mathematics: str) -> str:
        return f"${mathematics}$"

    def displayed(self, mathematics: str) -> str:
        return f"\\[\n\\fit{{{mathematics}}}\n\\]"

    def in_cell(self, mathematics: str) -> str:
        """The first of several lines stands beside the other cells."""
        first = mathematics.replace(r"\begin{aligned}", r"\begin{aligned}[t]", 1)
        return f"\\cell{{{first}}}"

    def verbatim(self, source: str) -> str:
        return rf"\texttt{{{escaped(' '.join(source.split()))}}}"

    def linked(self, claim: str) -> str:
        return rf"\hyperlink{{claim.{anchor(claim)}}}{{\texttt{{{escaped(claim)}}}}}"

    def picture(self, report: Report) -> str:
        scale = f"{report.picture.scale:.3f}"
        drawn = f"\\begin{{tikzpicture}}[x=1mm,y=1mm]\n{tikz(report.picture)}\n\\end{{tikzpicture}}"
        return rf"\scalebox{{{scale}}}{{{drawn}}}"
