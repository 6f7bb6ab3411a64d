"""Reports of a run: LaTeX and PDF.

Importing this package loads neither a template engine nor Typst; that happens when a report is
written.
"""

from kowalevski_cas.report.latex import render_latex
from kowalevski_cas.report.pdf import Engine, ReportError, Written, write_report

__all__ = ["Engine", "ReportError", "Written", "render_latex", "write_report"]
