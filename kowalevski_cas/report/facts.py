"""What stands behind a report, for programs: digests, versions, and who confirms which claim."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

from kowalevski_cas.report.witnesses import Witness
from kowalevski_cas.verify.outcome import Outcome, Run


def facts(run: Run, certified: Mapping[str, str], programs: Sequence[Witness]) -> str:
    """A run as JSON, without what it measured of time: the same bytes from run to run."""

    def claim(outcome: Outcome) -> dict[str, object]:
        return {
            "section": outcome.section,
            "scene": outcome.scene,
            "verdict": outcome.verdict,
            "statement": outcome.digest,
            "certificate": certified.get(outcome.claim),
            "decided by": dict(outcome.verdicts),
            "confirmed by": [one.name for one in programs if outcome.claim in one.claims],
            "rests on": list(outcome.rests_on),
            "read with the corrections of": list(outcome.corrected),
        }

    content = {
        "derivation": run.derivation,
        "digest": run.digest,
        "versions": {**run.versions, **{one.name: one.version for one in programs}},
        "claims": {outcome.claim: claim(outcome) for outcome in run.outcomes},
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"
