"""The report as Typst, which makes its PDF where there is no LaTeX."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from kowalevski_cas.notation.typst import TYPST
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
    for_paper,
)
from kowalevski_cas.report.marks import MARKS, Shown
from kowalevski_cas.report.setting import Typesetter
from kowalevski_cas.report.writer import Writer

_SPECIAL: Final = re.compile(r"([\\#$*_`@<>\[\]~=/])")


def render_typst(document: Document) -> str:
    """The document as Typst; the picture of what rests on what is a file of its own beside it."""
    return TypstWriter().write(for_paper(document))


class TypstSetter(Typesetter):
    """Displays in the mathematics of Typst, with its points of alignment."""

    printer = TYPST
    gap = ", quad "

    def opening_bracket(self, bracket: str, tall: bool) -> str:
        return _alone(bracket, tall)

    def closing_bracket(self, bracket: str, tall: bool) -> str:
        return _alone(bracket[0], tall) + bracket[1:]

    def line(self, left: str, right: str, indent: int, leads: bool) -> str:
        # Something empty before a sign makes it an operation.
        nothing = '"" ' if leads else ""
        return f"{left} & {'quad ' * indent}{nothing}{right}".strip()

    def lines(self, lines: Sequence[str]) -> str:
        return " \\\n".join(lines)


def _alone(bracket: str, tall: bool) -> str:
    """A bracket that has no partner on its line."""
    return f"lr⟮\\{bracket}, size: #2.2em⟯" if tall else f"\\{bracket}"


class TypstWriter(Writer):
    """The document in Typst."""

    page = "page.typ"
    setter = TypstSetter()
    origin, emphases = "#origin[{}]", ("#emph[{}];", "#strong[{}];")
    whole = "#box[{}];", "#tall[{}];"

    def escape(self, text: str) -> str:
        return _SPECIAL.sub(r"\\\1", text)

    def marks(self) -> str:
        return "\n".join(
            f'  "{v}": ([{mark.typst}], rgb("#{mark.colour}")),' for v, mark in MARKS.items()
        )

    def code(self, text: str) -> str:
        return f"#raw({_quote(' '.join(text.split()))});"

    def sign(self, verdict: Shown) -> str:
        return f'#sign("{verdict}");'

    def link(self, link: Link) -> str:
        target = _quote(link.target) if link.outside else f"<{link.target}>"
        return f"#link({target})[{self.text(link.text)}];"

    def heading(self, block: Heading) -> str:
        small = "#set text(0.87em)\n" * (block.anchor == APPENDIX)
        return f"\n{'=' * block.level} {self.text(block.text)} <{block.anchor}>\n{small}"

    def paragraph(self, block: Paragraph) -> str:
        kind = "leads" if block.leads else block.kind or "plain"
        place = f" <{block.anchor}>" if block.anchor else ""
        return f"#{kind}[{self.text(block.text)}]{place}"

    def equations(self, block: Equations) -> str:
        shown = f"#code({_quote(' '.join(block.source.split()))})"
        if block.formulas:
            shown = f"$ {self.setter.display(block.formulas, self.room)} $"
        name = f'"{block.verdict}"' if block.verdict else "none"
        place = f" <{block.anchor}>" if block.anchor else ""
        wrong = ", wrong: red" if block.wrong else ""
        label = self.text(block.label)
        if block.lead:
            return f"#led([{self.text(block.lead)}], [{label}])[{shown}]{place}"
        sticky = ", sticky: true" if block.leads or block.wrong else ""
        return f"#shown({name}, [{label}]{wrong}{sticky})[{shown}]{place}"

    def judgement(self, block: Judgement) -> str:
        name = f'"{block.verdict}"' if block.verdict else "none"
        place = f"<{block.anchor}>" if block.anchor else "none"
        inner = f"{self.blocks(block.blocks)}\n#did[\n{self.blocks(block.folded)}\n]"
        head, label = self.text(block.head), self.text(block.label)
        return f"\n#claim({name}, {place}, [{head}], [{label}])\n{inner}\n"

    def items(self, block: Items) -> str:
        name = "enum" if block.numbered else "list"
        return f"#{name}({', '.join(f'[{self.blocks(item)}]' for item in block.items)})"

    def table(self, block: Table) -> str:
        widths = ", ".join(f"{part}fr" for part in block.columns)
        head = ", ".join(f"[{self.text(cell)}]" for cell in block.head)
        rows = "\n".join(
            "  " + " ".join(f"[{self.text(cell)}]," for cell in row) for row in block.rows
        )
        return f"#ruled(({widths},), ({head},),\n{rows}\n)"

    def graph(self, block: Graph) -> str:
        return '#image("picture.svg")'

    def figure(self, block: Figure) -> str:
        return (
            f'#plate(image("{block.figure.place}.png", width: 100%), [{self.text(block.caption)}])'
        )


def _quote(text: str) -> str:
    """A string of Typst."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
