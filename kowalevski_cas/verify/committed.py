"""The certificates that are committed with a derivation, checked and compared with its record."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from kowalevski_cas.problem import checker
from kowalevski_cas.verify.certificate import CORRECTED, FOLDER

Record = Mapping[str, Mapping[str, object]]


@dataclass(frozen=True)
class Checked:
    """What the checker says about certificates.

    ``digests`` has the digests of the accepted problems by claim, those of corrections after a
    slash; ``said`` what each of them proves; ``rejected`` says why for the others, by file;
    ``without`` lists the recorded claims that have none.
    """

    digests: dict[str, str] = field(default_factory=dict)
    said: dict[str, list[str]] = field(default_factory=dict)
    rejected: dict[str, str] = field(default_factory=dict)
    without: tuple[str, ...] = ()

    @property
    def total(self) -> int:
        """The number of certificates that were checked."""
        return len(self.digests) + len(self.rejected)


def certificate_files(folder: Path) -> list[Path]:
    """The certificates in the folder of a derivation, by name, with those of corrections."""
    return sorted((folder / FOLDER).glob("*.json")) + sorted(
        (folder / FOLDER / CORRECTED).glob("*.json")
    )


def check_committed(folder: Path, record: Record) -> Checked:
    """Check the certificates in a derivation's folder.

    A certificate is rejected if the record has another statement of the claim, or another sign,
    than the file; so is one that the record asks for and that is missing.
    """
    found = check_files(certificate_files(folder), record)
    for name in wanted(record):
        if not (folder / FOLDER / f"{name}.json").is_file():
            found.rejected[f"{name}.json"] = "it is in the record, and missing"
    without = tuple(claim for claim in record if claim not in wanted(record))
    return replace(found, without=without)


def wanted(record: Record) -> list[str]:
    """The names of the certificates that a record asks for."""
    decided = [
        c for c, e in record.items() if e.get("verdict") in ("proved", "conditional", "refuted")
    ]
    return decided + [f"{CORRECTED}/{c}" for c in decided if record[c].get("correction")]


def check_files(paths: Sequence[Path], record: Record | None = None) -> Checked:
    """Check certificates; against a record, if there is one."""
    found = Checked()
    for path in paths:
        corrected = path.parent.name == CORRECTED
        try:
            text = path.read_text(encoding="utf-8")
            certificate = checker.check(text)
            claim = certificate.claim
            name = f"{CORRECTED}/{claim}" if corrected else claim
            checker.need(path.name == f"{claim}.json", f"it is about the claim {claim}")
            checker.need(name not in found.digests, "the claim was certified before")
            data = json.loads(text)
            if record is not None:
                _compare(record.get(claim, {}), data, corrected)
        except (OSError, UnicodeDecodeError, checker.Rejected) as error:
            found.rejected[str(path)] = str(error) or type(error).__name__
            continue
        found.digests[name] = str(data["digest"])
        found.said[name] = [theorem.words for theorem in certificate.theorems]
    return found


def _compare(entry: Mapping[str, object], data: Mapping[str, object], corrected: bool) -> None:
    """Reject a certificate that is not about what the record says."""
    checker.need(entry, "the record has no such claim")
    stale = "`make record` and `make certificates` write both anew"
    if corrected:
        checker.need(entry.get("correction"), f"the record has no correction of it; {stale}")
        checker.need(data["sign"] == "holds", "a correction has to hold")
        return
    same = entry.get("statement") == data["digest"]
    checker.need(same, f"the record has another statement of it; {stale}")
    sign = "denied" if entry.get("verdict") == "refuted" else "holds"
    checker.need(data["sign"] == sign, f"the record has another verdict on it; {stale}")
