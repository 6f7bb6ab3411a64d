"""The report as LaTeX: the same bytes from run to run."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Final

from kowalevski_cas.proof.outcome import Outcome, Point, Run, Verdict
from kowalevski_cas.report import mathematics
from kowalevski_cas.report.context import Report, report
from kowalevski_cas.report.escaping import ascii_only, escaped, quoted, words
from kowalevski_cas.report.graph.svg import svg
from kowalevski_cas.report.graph.tikz import tikz
from kowalevski_cas.report.marks import MARKS
from kowalevski_cas.report.names import anchor
from kowalevski_cas.report.plates import Plate
from kowalevski_cas.report.sentences import listed, number
from kowalevski_cas.report.witnesses import Certified, Witness

if TYPE_CHECKING:
    from jinja2 import Environment

TEMPLATES: Final = Path(__file__).parent / "templates"

_LINES: Final = 12  # longer displays of the program's own steps are shortened by dots


def render_latex(
    run: Run,
    plates: tuple[Plate, ...] = (),
    certified: Certified | None = None,
    programs: tuple[Witness, ...] = (),
) -> str:
    """The report of a run as a LaTeX document, with what other commands made and confirmed."""
    return _render(report(run, certified, programs), plates, "latex")


def render_for_pandoc(
    run: Run,
    plates: tuple[Plate, ...] = (),
    certified: Certified | None = None,
    programs: tuple[Witness, ...] = (),
) -> str:
    """The same document in the LaTeX that pandoc reads."""
    text = _render(report(run, certified, programs), plates, "pandoc").replace(
        r"\begin{aligned}[t]", r"\begin{aligned}"
    )
    # a sign at the beginning of a line
    return re.sub(r"\{\}(?= (?:[+-]|\\pm|\\mp) )", r"\\text{}", text)


def render_typst(run: Run, body: str) -> str:
    """A Typst document around the body that pandoc made."""
    template = _environment().get_template("report.typ.jinja")
    return template.render(report=report(run), body=body)


def render_picture(run: Run) -> str:
    """The picture of which claim rests on which, as SVG."""
    return svg(report(run).picture)


def _render(arranged: Report, plates: tuple[Plate, ...], target: str) -> str:
    template = _environment().get_template("report.tex.jinja")
    text = template.render(report=arranged, plates=plates, target=target)
    text = re.sub(r"[ \t]+\n", "\n", text)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def _environment() -> Environment:
    """A Jinja environment whose delimiters LaTeX never uses."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(TEMPLATES),
        block_start_string="((*",
        block_end_string="*))",
        variable_start_string="(((",
        variable_end_string=")))",
        comment_start_string="((=",
        comment_end_string="=))",
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters.update(
        words=words,
        inline=inline,
        plain=mathematics.plain,
        ascii=ascii_only,
        anchor=anchor,
        tikz=tikz,
        typst=quoted,
        display=display,
        displays=displays,
        number=number,
        cell=cell,
        column=column,
        point=point,
        listed=listed,
        link=link,
        links=links,
        sentence=sentence,
        thousands=thousands,
        short=short,
        upfirst=lambda text: text[:1].upper() + text[1:],
    )
    environment.globals.update(MARKS=MARKS, Verdict=Verdict)
    return environment


# ---------------------------------------------------------------------- filters


def inline(tex: str) -> str:
    """A formula within a sentence."""
    return f"${mathematics.plain(tex)}$"


def display(tex: str, room: float) -> str:
    """A formula on lines of its own, none wider than ``room`` em."""
    return _displayed(mathematics.display(tex, room))


def displays(formulas: tuple[str, ...], room: float) -> str:
    """What belongs to one step: in one display if that is not too high for a page."""
    if 1 < len(formulas) <= _LINES:
        together = mathematics.displays(formulas, room)
        if together.count("\\\\\n") < _LINES:
            return _displayed(together)
    inside = [mathematics.display(tex, room, lines=_LINES) for tex in formulas]
    return "\n".join(map(_displayed, inside))


def _displayed(body: str) -> str:
    return f"\\[\n\\fit{{{body}}}\n\\]"


def cell(tex: str, room: float = 24.0) -> str:
    """A formula in a cell of a table; the first of several lines stands beside the other cells."""
    body = mathematics.display(tex, room).replace(r"\begin{aligned}", r"\begin{aligned}[t]", 1)
    return f"\\cell{{{body}}}"


def column(rows: tuple[Outcome, ...]) -> float:
    """The part of the line that ids and verdicts leave to the formulas in a table of rows."""
    letters = max(1.1 * len(row.claim) + len(row.verdict.value) for row in rows)
    return round(0.92 - 0.0108 * letters, 2)


def point(at: Point) -> str:
    """``At`` and the coordinates of a point, equal ones together, each a formula of its own."""
    equal: dict[str, list[str]] = {}
    for name, value in at.values.items():
        if name == value:
            continue
        equal.setdefault(value, []).append(name)
    out = [
        inline(f"{' = '.join(names)} = {value}")
        for value, names in equal.items()
        if not (value.strip() == "0" and len(equal) > 1 and len(names) > 3)
    ]
    if len(out) < len(equal):
        out.append("the other variables $0$")
    return f"At {', '.join(out)}, " if out else ""


def sentence(text: str, end: str = ".") -> str:
    """Words that begin with a capital (where they begin with a letter) and come to an end."""
    text = text.strip()
    return words(text[:1].upper() + text[1:]) + ("" if text.endswith((".", "!", "?", ":")) else end)


def link(claim: str) -> str:
    """A claim's id, leading to the place where it is treated."""
    return rf"\hyperlink{{claim.{anchor(claim)}}}{{\texttt{{{escaped(claim)}}}}}"


def links(claims: tuple[str, ...]) -> str:
    """Several ids, as a list in words."""
    return listed([link(claim) for claim in claims])


def thousands(number: int) -> str:
    r"""A number with thin spaces between thousands.

    >>> thousands(12345)
    '12\\,345'
    """
    return f"{number:,}".replace(",", r"\,")


def short(text: str, letters: int = 72) -> str:
    """As much of a text as fits in a running head, cut between words."""
    if len(text) <= letters:
        return text
    return text[:letters].rsplit(" ", 1)[0].rstrip(",;:") + " …"
