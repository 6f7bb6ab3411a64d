"""The formats of JSON that the program writes: their versions, and the schema of them all.

A document says first what it is, ``"format": "kowalevski-cas audit"``, and in which ``version``:
another number if a reader of the earlier one could misread it. Keys may be added without one.
"""

from __future__ import annotations

import json
from typing import Any, Final

VERSIONS: Final = {
    "verify": 1,
    "audit": 1,
    "baseline": 1,
    "listing": 1,
    "find": 1,
    "motion": 1,
    "figures": 1,
    "facts": 1,
    "record": 1,
    "testimony": 1,
    "certificate": 2,
}
"""The version of each format that is written now."""


def head(name: str) -> dict[str, object]:
    """What a document of a format begins with.

    >>> head("audit")
    {'format': 'kowalevski-cas audit', 'version': 1}
    """
    return {"format": f"kowalevski-cas {name}", "version": VERSIONS[name]}


def schema() -> dict[str, Any]:
    """The schema (JSON Schema, draft 2020-12) of every document that the program writes."""
    from importlib.resources import files  # who writes a document needs no more than its head

    text = (files("kowalevski_cas") / "schema.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text)
    return found
