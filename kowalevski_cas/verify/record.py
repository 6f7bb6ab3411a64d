"""The record: verdicts that are committed, and how a run differs from them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from kowalevski_cas import UserError
from kowalevski_cas.files import read_json
from kowalevski_cas.notation import to_latex
from kowalevski_cas.schema import head
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict, as_recorded

FILE = "record.json"


class RecordError(UserError, ValueError):
    """A record that cannot be read; the message says what to do."""


class Difference(NamedTuple):
    """One way in which a run differs from the record."""

    claim: str
    recorded: str
    found: str


def describe(outcome: Outcome) -> dict[str, object]:
    """What is recorded of an outcome."""
    correction = outcome.correction
    recorded: dict[str, object] = {
        "verdict": str(outcome.verdict),
        "conditions": [to_latex(condition.expression) for condition in outcome.conditions],
        "correction": None
        if correction is None
        else as_recorded(correction.formulas, correction.words, outcome.formulas),
        "statement": outcome.digest,
    }
    if correction is not None and correction.elsewhere:
        recorded["mended"] = correction.elsewhere
    return recorded


def dump_record(run: Run, recorded: Mapping[str, Mapping[str, object]]) -> str:
    """The record of a run, as JSON; of claims that came to no end, what was ``recorded``."""
    claims = {
        outcome.claim: recorded[outcome.claim] if outcome in open_ones(run) else describe(outcome)
        for outcome in run.outcomes
        if outcome not in open_ones(run) or outcome.claim in recorded
    }
    about = {"derivation": run.derivation, "digest": run.digest}
    return _text({**head("record"), **about, "claims": claims})


def open_ones(run: Run) -> list[Outcome]:
    """The claims of a run that came to no end, for want of time or by an error."""
    return [o for o in run.outcomes if o.verdict in (Verdict.TIMEOUT, Verdict.ERROR)]


def _sorted(value: object) -> object:
    """What is recorded, whatever the order in which conditions were found."""
    return sorted(map(str, value)) if isinstance(value, list) else value


def _text(value: object) -> str:
    return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def load_record(folder: Path) -> dict[str, dict[str, object]] | None:
    """The recorded outcomes by claim; ``None`` if there is no record yet."""
    path = folder / FILE
    if not path.exists():
        return None
    try:
        claims = read_json(path)["claims"]
        if all(isinstance(entry, dict) for entry in claims.values()):
            return dict(claims)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise RecordError(
            f"{path}: the record cannot be read ({error}); `make record` writes it anew"
        ) from None
    raise RecordError(f"{path}: the record cannot be read; `make record` writes it anew")


def differences(
    run: Run, record: Mapping[str, Mapping[str, object]], whole: bool = True
) -> list[Difference]:
    """Where the outcomes of a run differ from the record; of all claims if the run is whole."""
    found = {outcome.claim: describe(outcome) for outcome in run.outcomes}
    result = []
    for claim, now in found.items():
        then = record.get(claim)
        if then is None:
            result.append(Difference(claim, "not in the record", str(now["verdict"])))
            continue
        for key, value in now.items():
            if _sorted(then.get(key)) != _sorted(value):
                result.append(
                    Difference(claim, _words_for(key, then.get(key)), _words_for(key, value))
                )
    if whole:
        gone = [claim for claim in record if claim not in found]
        result += [Difference(c, str(record[c].get("verdict")), "not a claim") for c in gone]
    return result


def unexpected_verdicts(run: Run, expected: Mapping[str, str]) -> list[Difference]:
    """Where outcomes are others than the author expects: that all is true, unless he says so."""
    return [
        Difference(o.claim, expected.get(o.claim, "that it is true"), str(o.verdict))
        for o in run.outcomes
        if not (o.verdict == expected[o.claim] if o.claim in expected else o.verdict.likely)
    ]


def contradictions(run: Run, record: Mapping[str, Mapping[str, object]]) -> list[Difference]:
    """Where a screening denies the record; that it proves less is no difference."""
    result = []
    for outcome in run.outcomes:
        then = record.get(outcome.claim, {})
        recorded, found = str(then.get("verdict", "not in the record")), outcome.verdict
        denied = found.likely if recorded == Verdict.REFUTED else found is Verdict.REFUTED
        if denied or found is Verdict.ERROR or then.get("statement") != outcome.digest:
            result.append(Difference(outcome.claim, recorded, str(found)))
    return result


def _words_for(key: str, value: object) -> str:
    if isinstance(value, list):
        value = ", ".join(map(str, value)) or "none"
    return str(value) if key == "verdict" else f"{key} {value if value is not None else 'none'}"
