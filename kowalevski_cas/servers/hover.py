"""What is said of a formula of an audit, in Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

Json = Mapping[str, Any]


def explain(document: Json, formula: Json) -> str:
    """The verdict on a formula, and all that it depends on; ``document`` is the audit."""
    return "\n\n".join(_paragraphs(document, formula))


def verdict_line(formula: Json) -> str:
    """The role of a formula and its verdict."""
    return f"{formula['role']}, {formula['verdict']}"


def rests_on(document: Json, id: str) -> list[Json]:
    """The formulas whose verdicts depend on one."""
    return [
        formula for formula in document["formulas"] if id in formula["reads"] or id in formula["on"]
    ]


def _paragraphs(document: Json, formula: Json) -> Iterator[str]:
    name = f" ({formula['label']})" if formula["label"] else ""
    yield f"**{formula['verdict']}**{name}: {formula['role']}"
    if formula["reason"]:
        yield f"Read so because: {formula['reason']}"
    if formula["conditions"]:
        yield "where " + ", ".join(f"${condition} \\neq 0$" for condition in formula["conditions"])
    if formula["message"]:
        yield formula["message"]
    if (against := formula["counterexample"]) is not None:
        yield against["words"]
        yield "at " + ", ".join(f"${name} = {value}$" for name, value in against["point"].items())
    if (correction := formula["correction"]) is not None:
        yield f"Correct: ${correction['printed']}$ ({correction['words']})"
    if formula["causes"]:
        yield f"Because of {', '.join(formula['causes'])}"
    if below := [*formula["on"], *formula["reads"]]:
        yield f"It rests on {', '.join(dict.fromkeys(below))}"
    if above := rests_on(document, formula["id"]):
        yield f"On it rest {', '.join(dependent['id'] for dependent in above)}"
    for claim, digest in formula["digests"].items():
        yield f"Certificate of {claim}: `{digest}`"
