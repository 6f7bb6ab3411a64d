"""Results, and audits at the lines of their sources, as annotations of a GitHub workflow."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.cli.formats.diagnostics import diagnostics
from kowalevski_cas.verify.diagnostic import NOTE, Diagnostic

if TYPE_CHECKING:
    from kowalevski_cas.audit.audit import Audit


def render(results: Sequence[ComparedRun]) -> str:
    """An error for each difference, a notice for each misprint and each false statement."""
    return workflow_commands(diagnostic for result in results for diagnostic in diagnostics(result))


def audited(audit: Audit) -> str:
    """An error for what is wrong, a warning for what is not decided or moved."""
    from kowalevski_cas.audit.diagnostics import diagnostics

    return workflow_commands(diagnostics(audit))


def workflow_commands(found: Iterable[Diagnostic]) -> str:
    """A workflow command for each diagnostic, escaped as GitHub asks."""
    return "".join(f"{_annotation(diagnostic)}\n" for diagnostic in found)


def _annotation(diagnostic: Diagnostic) -> str:
    path, line, column, end_line, end_column = diagnostic.region
    place: dict[str, object] = {"file": path, "line": max(1, line)}
    if end_line > line:  # columns are for one line only
        place["endLine"] = end_line
    elif column:
        place |= {"col": column, "endColumn": end_column}
    told = ",".join(f"{key}={_escape(str(value))}" for key, value in place.items())
    level = "notice" if diagnostic.level == NOTE else diagnostic.level
    text = diagnostic.message.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
    return f"::{level} {told},title={_escape(diagnostic.id)}::{text}"


def _escape(text: str) -> str:
    for sign in "%\r\n:,":
        text = text.replace(sign, f"%{ord(sign):02X}")
    return text
