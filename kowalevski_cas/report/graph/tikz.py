"""The picture as TikZ, for LaTeX."""

from __future__ import annotations

from kowalevski_cas.report.document import anchor
from kowalevski_cas.report.escaping import escape_latex
from kowalevski_cas.report.graph.drawing import Arrow, Box, Drawing
from kowalevski_cas.report.marks import MARKS


def tikz(picture: Drawing) -> str:
    """The body of a ``tikzpicture``; the page says what the styles are."""
    frame = f"\\useasboundingbox (0,0) rectangle ({picture.width:.1f},{-picture.height:.1f});"
    return "\n".join([frame, *map(_line, picture.lines), *map(_box, picture.boxes)])


def _line(line: Arrow) -> str:
    (x0, y0), (x1, y1) = line.start, line.end
    half = (y1 - y0) / 2
    return (
        f"\\draw[rests{',cited' * line.cited}{',->' * line.tip}] ({x0:.1f},{-y0:.1f}) .. controls "
        f"+(0,{-half:.1f}) and +(0,{half:.1f}) .. ({x1:.1f},{-y1:.1f});"
    )


def _box(box: Box) -> str:
    return (
        f"\\node[claim,{box.verdict.value},minimum width={box.width:.1f}mm] "
        f"at ({box.x:.1f},{-box.y:.1f}) "
        f"{{{MARKS[box.verdict].tex}\\,\\hyperlink{{claim.{anchor(box.name)}}}"
        f"{{\\ttfamily {escape_latex(box.label)}}}}};"
    )
