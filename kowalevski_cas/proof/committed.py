"""The certificates that are committed with a derivation, checked and compared with its record."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from kowalevski_cas.proof import checker

FOLDER = "certificates"
Record = Mapping[str, Mapping[str, object]]


@dataclass(frozen=True)
class Checked:
    """What the checker says about certificates.

    ``digests`` has the accepted ones by claim, ``statements`` the digests of what
    they state, ``said`` what each of them proves,
    ``notes`` what it leaves to an argument in words;
    ``rejected`` says why for the others, by file; ``without`` lists the recorded
    claims that have none.
    """

    digests: dict[str, str] = field(default_factory=dict)
    statements: dict[str, str] = field(default_factory=dict)
    said: dict[str, list[str]] = field(default_factory=dict)
    notes: dict[str, list[str]] = field(default_factory=dict)
    rejected: dict[str, str] = field(default_factory=dict)
    without: tuple[str, ...] = ()

    @property
    def total(self) -> int:
        """The number of certificates that were checked."""
        return len(self.digests) + len(self.rejected)


def certificate_files(folder: Path) -> list[Path]:
    """The certificates in the folder of a derivation, by name."""
    return sorted((folder / FOLDER).glob("*.json"))


def check_committed(folder: Path, record: Record) -> Checked:
    """Check the certificates in a derivation's folder.

    A certificate is rejected if the record has another statement of the claim, or
    another certificate, than the file; so is one that is recorded and missing.
    """
    found = check_files(certificate_files(folder), record)
    for claim, entry in record.items():
        if entry.get("certificate") and not (folder / FOLDER / f"{claim}.json").is_file():
            found.rejected[f"{claim}.json"] = "it is in the record, and missing"
    without = tuple(claim for claim, entry in record.items() if not entry.get("certificate"))
    return replace(found, without=without)


def check_files(paths: Sequence[Path], record: Record | None = None) -> Checked:
    """Check certificates; against a record, if there is one."""
    found = Checked()
    for path in paths:
        try:
            text = path.read_text(encoding="utf-8")
            claim, said = checker.check(text)
            data = json.loads(text)
            checker.need(path.name == f"{claim}.json", f"it is about the claim {claim}")
            checker.need(claim not in found.digests, "the claim was certified before")
            if record is not None:
                entry = record.get(claim, {})
                checker.need(entry, "the record has no such claim")
                stale = "`make record` and `make certificates` write both anew"
                same = entry.get("statement") == data["statement"]
                checker.need(same, f"the record has another statement of it; {stale}")
                same = entry.get("certificate") == data["digest"]
                checker.need(same, f"the record has another certificate for it; {stale}")
        except Exception as error:  # whatever goes wrong, nothing is certified
            found.rejected[str(path)] = str(error) or type(error).__name__
            continue
        found.digests[claim], found.said[claim] = str(data["digest"]), said
        found.statements[claim] = str(data["statement"])
        found.notes[claim] = list(map(str, data["notes"]))
    return found
