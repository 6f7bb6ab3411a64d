"""Reports of a run: one document, as HTML, LaTeX and PDF.

Importing this package does not load Typst; that happens when a PDF is made.
"""

from kowalevski_cas.report.contents import Contents, contents
from kowalevski_cas.report.evidence import Evidence
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.pdf import Engine, ReportError, Written, page, write_report
from kowalevski_cas.report.places import Item, Row, Section, Stated, sections
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.typst import render_typst

__all__ = [
    "Contents",
    "Engine",
    "Evidence",
    "Findings",
    "Item",
    "Phrases",
    "ReportError",
    "Row",
    "Section",
    "Stated",
    "Written",
    "contents",
    "page",
    "render_html",
    "render_latex",
    "render_typst",
    "sections",
    "write_report",
]
