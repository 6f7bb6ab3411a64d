"""The report as LaTeX: the same bytes from run to run."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.notation.latex import Latex
from kowalevski_cas.report.document import (
    APPENDIX,
    Document,
    Equations,
    Figure,
    Graph,
    Heading,
    Items,
    Judgement,
    Link,
    Paragraph,
    Table,
    Text,
    for_paper,
)
from kowalevski_cas.report.escaping import ascii_only, escape_latex
from kowalevski_cas.report.graph.tikz import tikz
from kowalevski_cas.report.marks import MARKS, Shown
from kowalevski_cas.report.setting import Typesetter
from kowalevski_cas.report.writer import Writer


def render_latex(document: Document) -> str:
    """The document as LaTeX."""
    return LatexWriter().write(for_paper(document))


class _Typeset(Latex):
    """LaTeX to be looked at; what is read again needs no thin spaces."""

    thin = r"\,"


class LatexSetter(Typesetter):
    """Displays in LaTeX, with the environment ``aligned``."""

    printer = _Typeset()
    gap = r",\quad "

    def opening_bracket(self, bracket: str, tall: bool) -> str:
        return rf"\Bigl{bracket}" if tall else bracket

    def closing_bracket(self, bracket: str, tall: bool) -> str:
        return rf"\Bigr{bracket}" if tall else bracket

    def line(self, left: str, right: str, indent: int, leads: bool) -> str:
        space = r"\quad " * (indent % 2) + r"\qquad " * (indent // 2)
        return f"{left} & {space}{'{} ' if leads else ''}{right}".strip()

    def lines(self, lines: Sequence[str]) -> str:
        body = " \\\\\n".join(lines)
        return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


class LatexWriter(Writer):
    """The document in LaTeX."""

    page = "page.tex"
    setter = LatexSetter()
    origin, emphases = r"{}\par", (r"\emph{{{}}}", r"\textbf{{{}}}")
    whole = r"\mbox{{{}}}", r"\mbox{{{}}}"

    def parts(self, document: Document) -> dict[str, str]:
        properties = {"property": ascii_only(document.title)}
        return {**super().parts(document), **properties}

    def escape(self, text: str) -> str:
        return escape_latex(text)

    def marks(self) -> str:
        return "\n".join(
            rf"\definecolor{{{v}}}{{HTML}}{{{mark.colour}}}"
            rf"\expandafter\def\csname sign.{v}\endcsname{{{mark.tex}}}"
            for v, mark in MARKS.items()
        )

    def code(self, text: str) -> str:
        return rf"\texttt{{{escape_latex(' '.join(text.split()))}}}"

    def sign(self, verdict: Shown) -> str:
        return rf"\Sign{{{verdict}}}"

    def link(self, link: Link) -> str:
        text = self.text(link.text)
        if link.outside:
            return rf"\href{{{link.target}}}{{{text}}}"
        return rf"\hyperlink{{{link.target}}}{{{text}}}"

    def heading(self, block: Heading) -> str:
        name = ("section", "subsection")[block.level - 1]
        text = self.text(block.text)
        small = "\\small\n" * (block.anchor == APPENDIX)
        return f"\n\\{name}[{text}]{{{self._place(block.anchor)}{text}}}\n{small}"

    def paragraph(self, block: Paragraph) -> str:
        stays = r"\interlinepenalty10000 " if block.leads else ""
        text = self.text(block.text)
        kind = {"lead": r"\large ", "note": r"\small "}.get(block.kind, "")
        after = r"\nopagebreak" if block.leads else ""
        return f"\n{{{kind}{stays}{self._place(block.anchor)}{text}\\par}}{after}\n"

    def equations(self, block: Equations) -> str:
        if block.formulas:
            mathematics = self.setter.display(block.formulas, self.room)
            shown = rf"\fit{{{mathematics}}}"
        else:
            shown = self.code(block.source)
        if block.wrong:
            shown = rf"\Wrong{{{shown}}}"
        sign = rf"\Sign{{{block.verdict}}}" if block.verdict else ""
        label = self._place(block.anchor) + self.text(block.label)
        if block.lead:
            return f"\\Led{{{self.text(block.lead)}}}{{{shown}}}{{{label}}}"
        after = r"\nopagebreak" if block.leads else ""
        return f"\\Shown{{{sign}}}{{{shown}}}{{{label}}}{after}"

    def judgement(self, block: Judgement) -> str:
        sign = rf"\Sign{{{block.verdict}}}" if block.verdict else ""
        head = self._place(block.anchor) + self.text(block.head)
        inner = self.blocks(block.blocks)
        if block.folded:
            inner += f"\n{{\\small {self.blocks(block.folded)}}}"
        return f"\n\\Claim{{{sign}}}{{{head}}}{{{self.text(block.label)}}}\n{inner}\n"

    @staticmethod
    def _place(anchor: str) -> str:
        return rf"\Place{{{anchor}}}" if anchor else ""

    def items(self, block: Items) -> str:
        name = "enumerate" if block.numbered else "itemize"
        items = "\n".join(f"\\item {self.blocks(item)}" for item in block.items)
        return f"\n\\begin{{{name}}}\n{items}\n\\end{{{name}}}\n"

    def table(self, block: Table) -> str:
        columns = "".join(
            rf">{{\raggedright\arraybackslash}}p{{{part}\linewidth}}" for part in block.columns
        )
        rows = "\n".join(self._row(row) for row in block.rows)
        return (
            f"\n\\begin{{longtable}}{{@{{}}{columns}@{{}}}}\n\\toprule\n{self._row(block.head)}\n"
            f"\\midrule\n\\endhead\n{rows}\n\\bottomrule\n\\end{{longtable}}\n"
        )

    def _row(self, row: Sequence[Text]) -> str:
        return " & ".join(map(self.text, row)) + r" \\"

    def graph(self, block: Graph) -> str:
        scale, drawn = f"{block.picture.scale:.3f}", tikz(block.picture)
        return (
            f"\n\\scalebox{{{scale}}}{{\\begin{{tikzpicture}}[x=1mm,y=1mm]\n{drawn}\n"
            "\\end{tikzpicture}}\n"
        )

    def figure(self, block: Figure) -> str:
        return (
            f"\n\\begin{{plate}}\n\\includegraphics[width=\\linewidth]{{{block.figure.place}.png}}\n\n"
            f"{self.text(block.caption)}\n\\end{{plate}}\n"
        )
