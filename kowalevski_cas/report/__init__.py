"""Reports of a run: one document, as HTML, LaTeX and PDF.

Here is the document; each writer is a module, and ``pdf`` makes files of them.
"""

from kowalevski_cas.report.contents import Contents, contents
from kowalevski_cas.report.evidence import Evidence
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.places import Item, Row, Section, Stated, sections
from kowalevski_cas.report.sentences import Phrases
