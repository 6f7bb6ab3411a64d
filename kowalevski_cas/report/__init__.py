"""Reports of a run: LaTeX and PDF.

Importing this package loads neither a template engine nor Typst; that happens when a report is
written.
"""

from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.pdf import Engine, ReportError, Written, write_report
from kowalevski_cas.report.typst import render_typst

__all__ = ["Engine", "ReportError", "Written", "render_latex", "render_typst", "write_report"]
