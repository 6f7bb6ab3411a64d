"""How an audit is printed: one file for each format."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.verify.outcome import in_latex

FORMATS = ("pretty", "json", "sarif", "github")
"""The formats that are chosen by name; ``-v`` chooses :mod:`.verbose`."""


def load_format(name: str) -> Callable[[Audit], str]:
    """The function that turns an audit into text in this format."""
    render: Callable[[Audit], str] = import_module(f"{__name__}.{name}").render
    return render


def explained(audit: Audit, index: int) -> str:
    """What is wrong with a formula, in one sentence, with mathematics between dollars."""
    formula = audit.formulas[index]
    parts = said(audit, index)
    if formula.correction is not None:
        parts.append(f"correct: ${in_latex(formula.correction.formulas)}$")
    return "; ".join(parts)


def said(audit: Audit, index: int) -> list[str]:
    """The same in parts, without the correction."""
    formula = audit.formulas[index]
    causes = [cause for cause in formula.causes if cause != _place(audit, index)]
    parts = [formula.message.splitlines()[0]] if formula.message else []
    if formula.breaks and not formula.claims:
        parts.append(f"because of it these do not hold: {', '.join(formula.breaks)}")
    if causes:
        parts.append(f"because of {', '.join(located(audit, cause) for cause in causes)}")
    if (
        formula.verdict == "suspect"
        and formula.correction is None
        and formula.place in audit.session.changed
    ):
        parts.append("it is not what the derivation has here")
    return parts


def located(audit: Audit, place: str) -> str:
    """A place with its line in the source."""
    for index, formula in enumerate(audit.formulas):
        if _place(audit, index) == place:
            return f"{formula.id} (line {formula.line})"
    return place


def _place(audit: Audit, index: int) -> str:
    formula = audit.formulas[index]
    return formula.place.place if formula.place is not None else formula.id
