"""An audit as annotations of a GitHub workflow, at the lines of the source."""

from __future__ import annotations

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.cli.audit_formats import explained
from kowalevski_cas.cli.formats.github import annotation


def render(audit: Audit) -> str:
    """An error for what is wrong, a warning for what is not decided or moved."""
    lines = []
    for index, formula in enumerate(audit.formulas):
        message = explained(audit, index) or formula.verdict
        if formula.wrong:
            level = "error"
        elif formula.moved or formula.verdict in ("undecided", "timeout"):
            level = "warning"
            message = f"{message}; it has moved" if formula.moved else message
        else:
            continue
        place = audit.source.path, max(1, formula.line)
        lines.append(annotation(level, place, formula.id, f"{formula.verdict}: {message}"))
    for outcome in audit.statements:
        if not outcome.verdict.green:
            words = f"{outcome.verdict}: {outcome.message or outcome.words}"
            level = "error" if outcome in audit.false else "warning"
            place = audit.source.path, audit.lines.get(outcome.claim, 1)
            lines.append(annotation(level, place, outcome.claim, words))
    return "".join(f"{line}\n" for line in lines)
