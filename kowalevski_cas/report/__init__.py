"""Reports of a run: one document, as HTML, LaTeX and PDF.

Importing this package does not load Typst; that happens when a PDF is made.
"""

from kowalevski_cas.report.contents import contents
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.pdf import Engine, ReportError, Written, write_report
from kowalevski_cas.report.places import Item, Row, Section, sections
from kowalevski_cas.report.typst import render_typst

__all__ = [
    "Engine",
    "Item",
    "ReportError",
    "Row",
    "Section",
    "Written",
    "contents",
    "render_html",
    "render_latex",
    "render_typst",
    "sections",
    "write_report",
]
