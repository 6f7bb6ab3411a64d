"""The picture as SVG, for Typst and for browsers, where boxes lead to claims and have classes."""

from __future__ import annotations

from html import escape
from typing import Final

from kowalevski_cas.report.document import anchor
from kowalevski_cas.report.graph.drawing import BOX, LETTER, Arrow, Box, Drawing
from kowalevski_cas.report.marks import MARKS
from kowalevski_cas.verify.outcome import Verdict

_STYLE: Final = {
    Verdict.PROVED: 'fill="#fff" stroke="#000" stroke-width="0.18"',
    Verdict.CONDITIONAL: 'fill="#fff" stroke="#000" stroke-width="0.25" stroke-dasharray="1 0.6"',
    Verdict.REFUTED: 'fill="#e4e4e4" stroke="#000" stroke-width="0.6"',
}
_OTHER: Final = 'fill="#fff" stroke="#000" stroke-width="0.25" stroke-dasharray="0.25 0.6"'
_SIGN: Final = {
    Verdict.PROVED: "M-1.1 0.1L-0.3 0.9L1.2 -1",
    Verdict.CONDITIONAL: "M-0.8 0.1L-0.2 0.7L0.9 -0.8"
    "M-1.1 -1.2C-1.9 -0.5 -1.9 0.5 -1.1 1.2M1.1 -1.2C1.9 -0.5 1.9 0.5 1.1 1.2",
    Verdict.REFUTED: "M-0.9 -0.9L0.9 0.9M-0.9 0.9L0.9 -0.9",
}


def svg(picture: Drawing) -> str:
    """A standalone SVG file, at the size that the page has room for."""
    width, height = picture.width * picture.scale, picture.height * picture.scale
    body = [*map(_line, picture.lines), *map(_box, picture.boxes)]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.1f}mm" '
        f'height="{height:.1f}mm" viewBox="0 0 {picture.width:.1f} {picture.height:.1f}">\n'
        + "\n".join(body)
        + "\n</svg>\n"
    )


def _line(line: Arrow) -> str:
    (x0, y0), (x1, y1) = line.start, line.end
    half = (y1 - y0) / 2
    path = f"M{x0:.1f} {y0:.1f}C{x0:.1f} {y0 + half:.1f} {x1:.1f} {y1 - half:.1f} {x1:.1f} {y1:.1f}"
    if line.tip:
        path += f"M{x1 - 0.6:.1f} {y1 - 1.3:.1f}L{x1:.1f} {y1:.1f}L{x1 + 0.6:.1f} {y1 - 1.3:.1f}"
    dashes = ' stroke-dasharray="0.9 0.7"' if line.cited else ""
    return (
        f'<path class="line" data-ends="{" ".join(map(anchor, line.names))}" d="{path}" '
        f'fill="none" stroke="#777" stroke-width="0.18"{dashes}/>'
    )


def _box(box: Box) -> str:
    left, top = box.x - box.width / 2, box.y - BOX / 2
    style = _STYLE.get(box.verdict, _OTHER)
    wide = LETTER * len(box.label)
    start = box.x - (wide + 4.0) / 2
    sign = _SIGN.get(box.verdict)
    mark = (
        f'<path transform="translate({start + 1.3:.2f} {box.y:.2f})" d="{sign}" '
        'class="sign" fill="none" stroke="#000" stroke-width="0.35"/>'
        if sign
        else f'<text x="{start + 1.3:.2f}" y="{box.y + 0.85:.2f}" font-size="2.6" '
        f'text-anchor="middle">{escape(MARKS[box.verdict].sign, quote=False)}</text>'
    )
    label = (
        f'<text x="{start + 4.0:.2f}" y="{box.y + 0.8:.2f}" font-size="2.45" '
        f'textLength="{wide:.2f}" font-family="DejaVu Sans Mono, monospace">'
        f"{escape(box.label, quote=False)}</text>"
    )
    return (
        f'<a href="#claim.{anchor(box.name)}" class="{box.verdict}">'
        f"<title>{escape(box.says or box.label, quote=False)}</title>"
        f'<rect class="box" x="{left:.1f}" y="{top:.1f}" width="{box.width:.1f}" '
        f'height="{BOX}" rx="0.8" {style}/>{mark}{label}</a>'
    )
