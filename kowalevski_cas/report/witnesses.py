"""Who confirms a claim: arithmetics, the checker, and programs that other commands ran.

A program that read the certificates left in the folder of the reports what it confirmed, as
``witnesses/kharlamov2002/rocq.json``::

    {"program": "rocq", "program_version": "…", "confirmed": {"eq15": "<digest>"}, "failed": {}}
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from kowalevski_cas.files import read_json
from kowalevski_cas.tools import TOOLS, title
from kowalevski_cas.verify.outcome import Outcome

FOLDER: Final = "witnesses"


@dataclass(frozen=True)
class Witness:
    """A program, its version, and the claims that it confirms."""

    name: str
    version: str
    claims: frozenset[str]


def arithmetics(outcomes: Sequence[Outcome]) -> tuple[Witness, ...]:
    """The arithmetics that came to the verdict of the run, in the order in which they ran."""
    names = dict.fromkeys(name for outcome in outcomes for name in outcome.verdicts)
    return tuple(
        Witness(
            title(name),
            "",
            frozenset(o.claim for o in outcomes if o.verdicts.get(name) is o.verdict),
        )
        for name in names
    )


def programs(folder: Path, derivation: str, certified: Mapping[str, str]) -> tuple[Witness, ...]:
    """The programs that confirmed certificates as they are now, in the folder of a report.

    ``certified`` has the digests of the accepted certificates by claim. What was said about
    another certificate is passed over, and so is a file that cannot be read.
    """
    found: dict[str, Witness] = {}
    for file in sorted((folder / FOLDER / derivation).glob("*.json")):
        try:
            content: dict[str, Any] = read_json(file)
            confirmed = dict(content["confirmed"]).items()
            claims = frozenset(c for c, digest in confirmed if certified.get(c) == digest)
            name, version = str(content["program"]), str(content["program_version"])
        except (OSError, ValueError, KeyError, TypeError):
            continue
        if claims:
            found[name] = Witness(title(name), version, claims)
    order = [*(name for name in TOOLS if name in found), *(n for n in found if n not in TOOLS)]
    return tuple(found[name] for name in order)
