"""The report as one HTML file: MathML and SVG within it, nothing to load.

A small script computes counterexamples anew; the page is whole without it.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Sequence
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import Final

from kowalevski_cas.notation import Formula, to_plain
from kowalevski_cas.notation.mathml import MATHML, grow_bracket
from kowalevski_cas.report.compare import without_marks
from kowalevski_cas.report.document import (
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
    Trial,
    TrialVersion,
)
from kowalevski_cas.report.graph.svg import svg
from kowalevski_cas.report.marks import MARKS, Shown
from kowalevski_cas.report.pieces import Piece, pieces, source_of, width_of
from kowalevski_cas.report.setting import SHORT, Typesetter
from kowalevski_cas.report.writer import Writer
from kowalevski_cas.verify.outcome import in_latex

_NARROW: Final = 19.0
"""The width of a telephone, in em of a formula."""

_FIRST: Final = re.compile('^<mo( form="prefix")?>')

_STOP: Final = re.compile(
    r"(?:[(“]<math>(?:(?!</math>).)*</math>[.,;:)”]*|<math>(?:(?!</math>).)*</math>[.,;:)”]+)"
)


def render_html(document: Document, beside: Path = Path()) -> str:
    """The document as HTML; figures are from the folder ``beside`` and become a part of it."""
    return HtmlWriter(beside).write(document)


class HtmlSetter(Typesetter):
    """Displays in MathML, their lines the rows of a table."""

    printer = MATHML
    gap = '<mo separator="true">,</mo><mspace width="1.5em"></mspace>'

    def opening_bracket(self, bracket: str, tall: bool) -> str:
        return grow_bracket(bracket) if tall else bracket

    closing_bracket = opening_bracket

    def line(self, left: str, right: str, indent: int, leads: bool) -> str:
        space = f'<mspace width="{indent}em"></mspace>' if indent else ""
        if leads:
            right = _infix(right)
        return f"<mtr><mtd>{left}</mtd><mtd>{space}{right}</mtd></mtr>"

    def lines(self, lines: Sequence[str]) -> str:
        return f'<mtable displaystyle="true" class="lines">{"".join(lines)}</mtable>'

    def inline(self, formula: Formula) -> str:
        """A formula within a line: a long one in parts, between which the line may be broken."""
        row = pieces(formula, self.printer)
        parts: list[list[Piece]] = [[]]
        for piece in row:
            if piece.kind in ("sign", "relation") and width_of(parts[-1]) > _NARROW / 4:
                parts.append([])
            parts[-1].append(piece)
        if width_of(row) <= SHORT:
            parts = [[*row]]
        texts = [source_of(part, self.printer) for part in parts if part]
        after_space = (_FIRST.sub('<mo form="infix" lspace="0">', text) for text in texts[1:])
        return " ".join(f"<math>{text}</math>" for text in (*texts[:1], *after_space))


def _infix(text: str) -> str:
    """A part of a formula that begins with a sign, which stands between it and what is before."""
    return _FIRST.sub('<mo form="infix">', text)


def _plain(text: Text) -> str:
    """A text in plain letters."""
    said = ""
    for part in text:
        match part:
            case str():
                said += part
            case Formula():
                said += to_plain(part)
            case Link(text=inner):
                said += _plain(inner)
    return said


class HtmlWriter(Writer):
    """The document in HTML."""

    page = "page.html"
    setter = HtmlSetter()
    room = 39.5
    origin, emphases = "<p>{}</p>", ("<em>{}</em>", "<strong>{}</strong>")

    def __init__(self, beside: Path) -> None:
        self.beside = beside

    def parts(self, document: Document) -> dict[str, str]:
        links = (
            f'<li><a href="#{block.anchor}">{self.text(block.text)}</a></li>'
            for block in document.blocks
            if isinstance(block, Heading) and block.level == 1
        )
        found = {**super().parts(document), "contents": "\n".join(links)}
        wanted = {"page.js": '<span class="copy"', "trial.js": '<form class="trial"'}
        codes = (
            (files(__package__) / "pages" / name).read_text(encoding="utf-8")
            for name, use in wanted.items()
            if use in found["body"]
        )
        return {**found, "script": "".join(f"<script>{{\n{code}}}</script>\n" for code in codes)}

    def escape(self, text: str) -> str:
        return escape(text.replace("'", "’"))

    def text(self, text: Text) -> str:
        """No line is broken between a formula and the stop behind it, or the bracket before it."""
        return _STOP.sub(r'<span class="nobr">\g<0></span>', super().text(text))

    def marks(self) -> str:
        light = "".join(f"--{verdict}: #{mark.colour};" for verdict, mark in MARKS.items())
        dark = "".join(f"--{verdict}: #{mark.on_black};" for verdict, mark in MARKS.items())
        colours = "".join(f".{v} {{ --mark: var(--{v}); }}\n" for v in MARKS)
        return (
            f":root {{ {light} }}\n@media screen and (prefers-color-scheme: dark) "
            f"{{ :root {{ {dark} }} }}\n{colours}"
        )

    def formula(self, formula: Formula) -> str:
        return self.setter.inline(formula)

    def code(self, text: str) -> str:
        return f"<code>{escape(' '.join(text.split()))}</code>"

    def sign(self, verdict: Shown) -> str:
        mark = MARKS[verdict]
        return (
            f'<span class="mark {verdict}" role="img" aria-label="{mark.word}" '
            f'title="{mark.word}">{mark.sign}</span>'
        )

    def link(self, link: Link) -> str:
        target = escape(link.target if link.outside else f"#{link.target}")
        return f'<a href="{target}">{self.text(link.text)}</a>'

    def heading(self, block: Heading) -> str:
        level = block.level + 1
        return f'<h{level} id="{block.anchor}">{self.text(block.text)}</h{level}>'

    def paragraph(self, block: Paragraph) -> str:
        kind = f' class="{block.kind}"' if block.kind else ""
        place = f' id="{block.anchor}"' if block.anchor else ""
        return f"<p{place}{kind}>{self.text(block.text)}</p>"

    def equations(self, block: Equations) -> str:
        """A display, for wide and for narrow pages if these differ."""
        if not block.formulas:
            inner = f'<span class="source">{escape(" ".join(block.source.split()))}</span>'
        else:
            both = self.setter.displays(block.formulas, (self.room, _NARROW))
            wide, narrow = (f'<math display="block">{side}</math>' for side in both)
            inner = f"<div>{wide}</div>"
            if wide != narrow:
                inner = f'<div class="wide">{wide}</div><div class="narrow">{narrow}</div>'
        if block.wrong:
            inner = f"<s>{inner}</s>"
        sign = self.sign(block.verdict) if block.verdict else ""
        place = f' id="{block.anchor}"' if block.anchor else ""
        label = self._label(block.label, block.anchor)
        kind = f" {block.verdict}" if block.verdict else ""
        return (
            f'<div class="display{kind}"{place}>{sign}<div class="math">{inner}</div>{label}'
            f"{self._copies(block)}</div>"
        )

    def _label(self, label: Text, place: str) -> str:
        """What stands behind a formula: a number is the address of what it numbers."""
        match label:
            case ():
                return ""
            case (str(),) if place:
                return f'<a class="label" href="#{place}">{self.text(label)}</a>'
        return f'<span class="label">{self.text(label)}</span>'

    def _copies(self, block: Equations) -> str:
        """What can be copied of a display, for the script."""
        tex = block.source or in_latex(map(without_marks, block.formulas))
        texts = {"TeX": " ".join(tex.split()), "erratum": block.erratum}
        buttons = " ".join(
            f'<button type="button" data-text="{escape(text)}">copy {what}</button>'
            for what, text in texts.items()
            if text
        )
        return f'<span class="copy" hidden>{buttons}</span>'

    def judgement(self, block: Judgement) -> str:
        sign = self.sign(block.verdict) if block.verdict else ""
        place = f' id="{block.anchor}"' if block.anchor else ""
        first = next((b.anchor for b in block.blocks if isinstance(b, Equations)), "")
        label = self._label(block.label, block.anchor or first)
        head = f'<div class="head">{sign}<p>{self.text(block.head)}</p>{label}</div>'
        body = self.blocks(block.blocks)
        if block.folded:
            summary = "<summary>What the program did</summary>"
            body += f"\n<details>{summary}\n{self.blocks(block.folded)}\n</details>"
        kind = f" {block.verdict}" if block.verdict else ""
        return f'<section class="claim{kind}"{place}>\n{head}\n{body}\n</section>'

    def items(self, block: Items) -> str:
        name = "ol" if block.numbered else "ul"
        items = "\n".join(f"<li>{self.blocks(item)}</li>" for item in block.items)
        return f"<{name}>\n{items}\n</{name}>"

    def table(self, block: Table) -> str:
        head = "".join(f"<th>{self.text(cell)}</th>" for cell in block.head)
        rows = "\n".join(
            f"<tr>{''.join(f'<td>{self.text(cell)}</td>' for cell in row)}</tr>"
            for row in block.rows
        )
        return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}\n</tbody>\n</table>"

    def graph(self, block: Graph) -> str:
        wide = f"--wide: {block.picture.width:.1f}"
        named = '<svg role="group" aria-label="What rests on what" '
        drawn = svg(block.picture).replace("<svg ", named, 1)
        return f'<div class="graph" tabindex="0" style="{wide}">{drawn}</div>'

    def figure(self, block: Figure) -> str:
        """A picture, as a drawing that takes the page's ink; how its caption begins is its name."""
        name = escape(_plain(block.caption).partition(". ")[0])
        image = block.figure.drawing(self.beside)
        if image:
            image = image.replace("<svg ", f'<svg role="img" aria-label="{name}" ', 1)
        else:
            data = b64encode(block.figure.file(self.beside).read_bytes()).decode()
            image = f'<img alt="{name}" src="data:image/png;base64,{data}">'
        caption = self.text(block.caption)
        return f"<figure>{image}<figcaption>{caption}</figcaption></figure>"

    def trial(self, block: Trial) -> str:
        """Boxes for the numbers of each version, which the script shows."""
        choice = ""
        if len(block.versions) > 1:
            choice = "".join(
                f'<label><input type="radio" name="version"{" checked" if not k else ""}> '
                f"{version.label}</label> "
                for k, version in enumerate(block.versions)
            )
        parts = "\n".join(map(self._version, block.versions))
        head = f"<summary>Try other numbers{self.text(block.of)}</summary>"
        choice = f"<p>{choice}</p>" if choice else ""
        button = '<p><button type="button">Back to the point above</button></p>'
        inner = f"<details>{head}\n{choice}\n{parts}\n{button}</details>"
        return f'<form class="trial" hidden>{inner}</form>'

    def _version(self, version: TrialVersion) -> str:
        boxes = " ".join(
            f'<label>{self.formula(shown)} = <input name="{escape(name)}" size="9" '
            'spellcheck="false" autocomplete="off"></label>'
            for name, shown in version.names
        )
        broken = "".join(f"<li hidden>{self.text(words)}</li>" for words in version.hypotheses)
        said = '<div class="broken" hidden>No verdict, for this does not hold here:'
        return (
            f'<fieldset data-steps="{escape(version.steps)}" hidden><p>{boxes}</p>'
            f"{said}<ul>{broken}</ul></div><output></output></fieldset>"
        )
