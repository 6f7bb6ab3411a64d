"""Results and audits as JSON."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.notation import to_latex
from kowalevski_cas.schema import head
from kowalevski_cas.source.text import Region
from kowalevski_cas.verify.diagnostic import Diagnostic
from kowalevski_cas.verify.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    Value,
    in_latex,
)

if TYPE_CHECKING:
    from kowalevski_cas.audit.audit import Audit
    from kowalevski_cas.audit.audited import Audited


def render(results: Sequence[ComparedRun]) -> str:
    """All claims, and a summary."""
    outcomes = [(r.run.derivation, o) for r in results for o in r.run.outcomes]
    differences = [d for r in results for d in r.differences]
    counts = Counter(str(o.verdict) for _, o in outcomes)
    value = {
        **head("verify"),
        "claims": [_claim(derivation, outcome) for derivation, outcome in outcomes],
        "summary": {
            "claims": len(outcomes),
            **{str(verdict): count for verdict, count in sorted(counts.items())},
            "differences": [
                {"id": d.claim, "recorded": d.recorded, "found": d.found} for d in differences
            ],
            "certificates": sum(len(o.certificates) for _, o in outcomes),
            "seconds": round(sum(sum(o.seconds.values()) for _, o in outcomes), 6),
            "digests": {r.run.derivation: r.run.digest for r in results},
            "versions": results[0].run.versions if results else {},
        },
    }
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"


def _claim(derivation: str, outcome: Outcome) -> dict[str, Any]:
    return {
        "id": outcome.claim,
        "derivation": derivation,
        "section": outcome.section,
        "scene": outcome.scene,
        "printed": outcome.source,
        "words": outcome.words,
        "verdict": str(outcome.verdict),
        "verdicts": {name: str(verdict) for name, verdict in outcome.verdicts.items()},
        **_evidence(outcome),
        "failures": [
            {
                "condition": to_latex(c.expression),
                "words": c.words,
                "counterexample": counterexample(c.witness),
            }
            for c in outcome.conditions
            if c.witness is not None
        ],
        "chance": outcome.chance,
        "radius": outcome.radius,
        "seconds": {name: round(value, 6) for name, value in outcome.seconds.items()},
        "branches": [to_latex(formula) for formula in outcome.branches],
        "rests_on": list(outcome.rests_on),
        "corrected": list(outcome.corrected),
        "digest": outcome.digest,
    }


def _evidence(found: Outcome | Audited) -> dict[str, Any]:
    """What a verdict depends on, what is against it, and what is said."""
    return {
        "conditions": conditions(found.conditions),
        "counterexample": counterexample(found.counterexample),
        "correction": correction(found.correction),
        "alternatives": [*map(correction, found.alternatives)],
        "message": found.message,
    }


def audited(audit: Audit) -> str:
    """All formulas, the statements in words, what is to be looked at, and a summary."""
    from kowalevski_cas.audit.diagnostics import diagnostics

    value = {
        **head("audit"),
        **_assumptions(audit),
        "formulas": [_formula(audit, formula) for formula in audit.formulas],
        "statements": [_statement(audit, outcome) for outcome in audit.statements],
        "diagnostics": [*map(_diagnostic, diagnostics(audit))],
        "uncovered": [passage._asdict() for passage in audit.uncovered],
        "comments": [*_comments(audit)],
        "summary": {
            "source": audit.source.path,
            "derivation": audit.session.interpretation.derivation.name,
            "formulas": len(audit.formulas),
            **audit.counts,
            "claims": Counter(str(outcome.verdict) for outcome in audit.outcomes.values()),
            "certificates": len(audit.certificates),
            "wrong": audit.wrong,
            "moved": [formula.id for formula in audit.formulas if formula.moved],
            "notes": [{"line": line, "words": words} for line, words in audit.notes],
            "seconds": round(audit.seconds, 6),
        },
    }
    return json.dumps(value, indent=2, ensure_ascii=False) + "\n"


def _comments(audit: Audit) -> Iterator[dict[str, Any]]:
    """The comments that say what is inferred of a source that is its own derivation."""
    if audit.reading is None:
        return
    from kowalevski_cas.reading.draft import insertions

    ids = {id(place.typed): place.display.id for place in audit.places}
    for typed, interval, text in insertions(audit.reading):
        yield {"id": ids[id(typed)], **_region(audit.source.region(*interval)), "text": text}


def _assumptions(audit: Audit) -> dict[str, Any]:
    """What a source that is its own derivation takes for granted."""
    if audit.reading is None:
        return {}
    from kowalevski_cas.audit.assumed import assumptions_of

    return {
        "assumed": [
            {
                "kind": assumption.kind,
                "words": assumption.words,
                "id": assumption.place.place if assumption.place else None,
                "claims": list(assumption.claims),
            }
            for assumption in assumptions_of(audit)
        ]
    }


def _diagnostic(diagnostic: Diagnostic) -> dict[str, Any]:
    return {
        "rule": diagnostic.rule,
        "level": diagnostic.level,
        "id": diagnostic.id,
        "message": diagnostic.message,
        **_region(diagnostic.region),
        "fixes": [{**_region(fix.region), "text": fix.text} for fix in diagnostic.fixes],
        "fingerprint": diagnostic.fingerprint,
    }


def _region(region: Region) -> dict[str, Any]:
    """A region; what does not stand in the file has no line."""
    names = ("file", "line", "column", "end_line", "end_column")
    return {name: value or None for name, value in zip(names, region, strict=True)}


def _formula(audit: Audit, formula: Audited) -> dict[str, Any]:
    return {
        "id": formula.id,
        "label": formula.label or None,
        **_region(formula.region),
        "role": formula.role,
        "reason": formula.reason or None,
        "on": list(formula.on),
        "reads": _reads(audit, formula),
        "tex": formula.tex,
        "verdict": formula.verdict,
        "claims": list(formula.claims),
        "digests": {
            id: audit.outcomes[id].digest for id in formula.claims if audit.outcomes[id].certificate
        },
        **_evidence(formula),
        "causes": _ids(audit, formula.causes),
        "breaks": list(formula.breaks),
        "moved": formula.moved,
    }


def _ids(audit: Audit, places: Iterable[str]) -> list[str]:
    """The ids of the formulas at some places, or these where the source has none."""
    ids = {formula.name: formula.id for formula in audit.formulas}
    return [ids.get(place, place) for place in places]


def _reads(audit: Audit, formula: Audited) -> list[str]:
    """The formulas, other than itself, on which the verdict on a formula depends."""
    claims = audit.session.interpretation.derivation.claims
    read = {place for claim in claims if claim.id in formula.claims for place in claim.reads()}
    return [f.id for f in audit.formulas if f.place in read and f is not formula]


def _statement(audit: Audit, outcome: Outcome) -> dict[str, Any]:
    causes = audit.session.causes.places.get(outcome.claim, ())
    return {
        "id": outcome.claim,
        "words": outcome.words,
        **_region(audit.sentences.get(outcome.claim, Region(audit.source.path))),
        "verdict": str(outcome.verdict),
        **_evidence(outcome),
        "causes": _ids(audit, [cause.place for cause in causes]),
    }


def counterexample(found: Counterexample | None) -> dict[str, Any] | None:
    """A counterexample as JSON."""
    if found is None:
        return None
    return {
        "point": {to_latex(name): _value(value) for name, value in found.point.values.items()},
        "left": _value(found.left),
        "right": _value(found.right),
        "words": found.words,
    }


def correction(found: Correction | None) -> dict[str, Any] | None:
    """A correction as JSON."""
    if found is None:
        return None
    return {
        "printed": in_latex(found.formulas),
        "words": found.words,
        "verdict": str(found.verdict),
        "conditions": conditions(found.conditions),
        "accepted": found.accepted,
        "blamed": in_latex(found.blamed),
        "place": found.printed.place if found.printed else None,
        "others": list(found.others),
    }


def conditions(found: Sequence[Condition]) -> list[str]:
    """Conditions as JSON."""
    return [to_latex(condition.expression) for condition in found]


def _value(value: Value) -> str:
    return value if isinstance(value, str) else to_latex(value)
