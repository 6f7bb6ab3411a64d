"""Results and audits as SARIF 2.1.0, for code scanning and editors."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from kowalevski_cas import __version__
from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.cli.formats.diagnostics import diagnostics
from kowalevski_cas.cli.project import url
from kowalevski_cas.source.text import Region
from kowalevski_cas.verify.diagnostic import RULES, Diagnostic, Replacement

if TYPE_CHECKING:
    from kowalevski_cas.audit.audit import Audit

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
FINGERPRINT = "kowalevskiCas/v1"
"""What the fingerprints are called; another number if they are computed otherwise."""


def render(results: Sequence[ComparedRun]) -> str:
    """A result for each difference from the record, and for each refuted claim."""
    return log(diagnostic for result in results for diagnostic in diagnostics(result))


def audited(audit: Audit) -> str:
    """A result for each formula or statement that an author has to look at."""
    from kowalevski_cas.audit.diagnostics import diagnostics

    return log(diagnostics(audit))


def log(found: Iterable[Diagnostic]) -> str:
    """One run with these results."""
    driver = {
        "name": "kowalevski-cas",
        "semanticVersion": __version__,
        "rules": [_rule(rule, words) for rule, words in RULES.items()],
    }
    if about := url("Repository"):
        driver["informationUri"] = about
    value = {
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [
            {
                "tool": {"driver": driver},
                "columnKind": "unicodeCodePoints",
                "results": [*map(_result, found)],
            }
        ],
    }
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"


def _rule(rule: str, words: str) -> dict[str, Any]:
    found: dict[str, Any] = {
        "id": rule,
        "shortDescription": {"text": words},
        "help": {"text": f"{words} The page of the documentation on formats says more."},
    }
    if pages := url("Documentation"):
        found["helpUri"] = f"{pages}/formats/#{rule}"
    return found


def _result(diagnostic: Diagnostic) -> dict[str, Any]:
    result = {
        "ruleId": diagnostic.rule,
        "ruleIndex": [*RULES].index(diagnostic.rule),
        "level": diagnostic.level,
        "message": {"text": f"{diagnostic.id}: {diagnostic.message}"},
        "locations": [{"physicalLocation": _place(diagnostic.region)}],
        "partialFingerprints": {FINGERPRINT: diagnostic.fingerprint},
    }
    if diagnostic.fixes:
        result["fixes"] = [
            {
                "description": {"text": f"mend {diagnostic.id}"},
                "artifactChanges": [
                    {
                        "artifactLocation": _artifact(path),
                        "replacements": [*map(_replacement, replacements)],
                    }
                    for path, replacements in groupby(diagnostic.fixes, lambda fix: fix.region.path)
                ],
            }
        ]
    return result


def _replacement(fix: Replacement) -> dict[str, Any]:
    return {"deletedRegion": _region(fix.region), "insertedContent": {"text": fix.text}}


def _place(region: Region) -> dict[str, Any]:
    place: dict[str, Any] = {"artifactLocation": _artifact(region.path)}
    if region.line:
        place["region"] = _region(region)
    return place


def _region(region: Region) -> dict[str, int]:
    found = {"startLine": region.line}
    if region.column:
        found |= {
            "startColumn": region.column,
            "endLine": region.end_line,
            "endColumn": region.end_column,
        }
    return found


def _artifact(path: str) -> dict[str, str]:
    """A file by its path from here, as a review wants it; elsewhere by its whole path."""
    here, file = Path.cwd(), Path(path).absolute()
    inside = file.is_relative_to(here)
    return {"uri": quote(file.relative_to(here).as_posix()) if inside else file.as_uri()}
