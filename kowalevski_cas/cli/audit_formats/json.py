"""An audit as JSON."""

from __future__ import annotations

import json
from collections import Counter
from typing import Any

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import Audited
from kowalevski_cas.cli.formats.json import conditions, correction, counterexample
from kowalevski_cas.verify.outcome import Outcome


def render(audit: Audit) -> str:
    """All formulas, the statements in words, and a summary."""
    value = {
        "formulas": [_formula(formula) for formula in audit.formulas],
        "statements": [_statement(audit, outcome) for outcome in audit.statements],
        "summary": {
            "source": audit.source.path,
            "derivation": audit.session.derivation.name,
            "formulas": len(audit.formulas),
            **audit.counts,
            "claims": Counter(str(outcome.verdict) for outcome in audit.outcomes.values()),
            "wrong": audit.wrong,
            "moved": [formula.id for formula in audit.formulas if formula.moved],
            "notes": [{"line": line, "words": words} for line, words in audit.notes],
            "seconds": round(audit.seconds, 6),
        },
    }
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"


def _formula(formula: Audited) -> dict[str, Any]:
    return {
        "id": formula.id,
        "label": formula.label or None,
        "line": formula.line,
        "column": formula.column,
        "role": formula.role,
        "tex": formula.tex,
        "verdict": formula.verdict,
        "claims": list(formula.claims),
        "conditions": conditions(formula.conditions),
        "counterexample": counterexample(formula.counterexample),
        "correction": correction(formula.correction),
        "causes": list(formula.causes),
        "breaks": list(formula.breaks),
        "moved": formula.moved,
        "message": formula.message,
    }


def _statement(audit: Audit, outcome: Outcome) -> dict[str, Any]:
    causes = audit.session.causes.get(outcome.claim, ())
    return {
        "id": outcome.claim,
        "words": outcome.words,
        "line": audit.lines.get(outcome.claim),
        "verdict": str(outcome.verdict),
        "conditions": conditions(outcome.conditions),
        "counterexample": counterexample(outcome.counterexample),
        "correction": correction(outcome.correction),
        "causes": [cause.place for cause in causes],
        "message": outcome.message,
    }
