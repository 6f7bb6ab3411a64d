"""An audit as SARIF 2.1.0, for code scanning."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from kowalevski_cas import __version__
from kowalevski_cas.audit.audit import Audit

RULES = {
    "refuted": "The formula, or the statement, is false at an exact point.",
    "suspect": "A changed definition makes other formulas false.",
    "error": "The formula has no meaning where it stands.",
    "unreadable": "The formula cannot be read.",
    "missing": "A formula that the derivation needs is not in the source.",
    "undecided": "The formula was neither proved nor refuted.",
    "timeout": "The formula was not decided in time.",
    "moved": "The formula stands elsewhere than in the derivation.",
}
WARNINGS = ("undecided", "timeout", "moved")


def audited(audit: Audit) -> str:
    """One run, a result for each formula or statement that an author has to look at."""
    results = []
    for formula in audit.formulas:
        rule = formula.verdict if formula.verdict in RULES else "moved" if formula.moved else ""
        if not rule:
            continue
        message = f"{formula.id}: {audit.explained(formula) or RULES[rule]}"
        results.append(_result(audit, rule, message, formula.line, formula.column))
    for outcome in audit.false:
        message = f"{outcome.claim}: {outcome.words}"
        results.append(_result(audit, "refuted", message, audit.lines.get(outcome.claim, 1), 1))
    value = {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [
            {
                "tool": {
                    "driver": {
                        "name": "kowalevski-cas",
                        "version": __version__,
                        "rules": [
                            {"id": rule, "shortDescription": {"text": words}}
                            for rule, words in RULES.items()
                        ],
                    }
                },
                "columnKind": "unicodeCodePoints",
                "results": results,
            }
        ],
    }
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"


def _result(audit: Audit, rule: str, message: str, line: int, column: int) -> dict[str, Any]:
    region = {"startLine": max(1, line), "startColumn": max(1, column)}
    location = {"uri": Path(audit.source.path).as_posix()}
    return {
        "ruleId": rule,
        "level": "warning" if rule in WARNINGS else "error",
        "message": {"text": message},
        "locations": [{"physicalLocation": {"artifactLocation": location, "region": region}}],
    }
