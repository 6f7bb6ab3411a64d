r"""In a notebook: a magic for one formula, and reports that show themselves.

``%load_ext kowalevski_cas.notebook`` makes ``%kc`` known, which takes a formula as it is printed:

    %kc lorenz integral x^2-2\sigma z
"""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kowalevski_cas import UserError
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.reading import read
from kowalevski_cas.report.annotated import annotate
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import Document
from kowalevski_cas.report.html import render_html
from kowalevski_cas.report.places import sections
from kowalevski_cas.source.files import read_source
from kowalevski_cas.system import System
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session, run_together

if TYPE_CHECKING:
    from IPython.core.interactiveshell import InteractiveShell

VERBS = ("identity", "integral", "invariant", "casimir", "define", "where", "conditions")
"""What ``%kc`` asks of a system: its functions that take one formula."""


class ReportPage:
    """A page that a notebook shows in a frame of its own."""

    def __init__(self, document: Document) -> None:
        self.html = render_html(document)

    def _repr_html_(self) -> str:
        style = "width:100%;height:36em;border:1px solid #ccc"
        return f'<iframe srcdoc="{escape(self.html)}" style="{style}"></iframe>'


def report(system: System, title: str = "A system of equations") -> ReportPage:
    """The report on all that is claimed of a system so far: each claim is decided."""
    derivation = Derivation("notebook", title, "", "", (system.section,))
    texts = derivation.texts()
    session = Session(derivation, ("flint",), True, timeout=system.seconds, texts=texts)
    (run,) = run_together([session])
    return ReportPage(Contents(run, sections(run, derivation, texts)).document())


def audit(paper: str | Path, seconds: float = 5.0) -> ReportPage:
    """The page of a paper in a file, with a verdict beside each formula; a claim has its seconds.

    Raises:
        SourceError: it cannot be read.
    """
    run = ReadingSession(read(read_source(Path(paper))), explain=True, timeout=seconds)
    return ReportPage(annotate(audit_reading(run)))


def ask(line: str, names: dict[str, Any]) -> Any:
    """What ``%kc SYSTEM VERB FORMULA`` answers; a system is known by its name among ``names``.

    Raises:
        UserError: there is no such system, or no such verb.
    """
    name, verb, formula = (*line.split(maxsplit=2), "", "", "")[:3]
    system = names.get(name)
    if not isinstance(system, System):
        raise UserError(f"“{name}” is no System; write %kc SYSTEM VERB FORMULA")
    if verb not in VERBS or not formula:
        raise UserError(f"%kc {name} VERB FORMULA, where VERB is one of {', '.join(VERBS)}")
    return getattr(system, verb)(formula.strip())


def load_ipython_extension(shell: InteractiveShell) -> None:
    """Make ``%kc`` known, and show verdicts as words."""

    def kc(line: str) -> Any:
        """Ask one formula of a system: %kc SYSTEM VERB FORMULA, as in %kc lorenz integral x^2-y."""
        return ask(line, shell.user_ns)

    shell.register_magic_function(kc, "line", "kc")  # type: ignore[arg-type] # it is bound
    assert shell.display_formatter is not None
    html = shell.display_formatter.formatters["text/html"]
    html.for_type(Verdict, lambda verdict, *_: f"<b>{verdict}</b>")
