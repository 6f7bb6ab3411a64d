"""The certificates that are committed with a derivation, checked and compared with its record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from kowalevski_cas.problem import checker
from kowalevski_cas.verify.certificate import CORRECTED, FOLDER

Record = Mapping[str, Mapping[str, object]]


@dataclass(frozen=True)
class Checked:
    """What the checker says about certificates.

    ``accepted`` has what it accepts by claim, corrections after a slash; ``rejected`` says why
    for the others, by file; ``without`` lists the recorded claims that have none.
    """

    accepted: dict[str, checker.Certificate] = field(default_factory=dict)
    rejected: dict[str, str] = field(default_factory=dict)
    without: tuple[str, ...] = ()

    @property
    def total(self) -> int:
        """The number of certificates that were checked."""
        return len(self.accepted) + len(self.rejected)

    @property
    def digests(self) -> dict[str, str]:
        """The digests of the problems that are proved, or denied."""
        return {name: certificate.digest for name, certificate in self.accepted.items()}


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
    verdicts = ("proved", "conditional", "refuted")
    decided = [claim for claim, entry in record.items() if entry.get("verdict") in verdicts]
    return decided + [f"{CORRECTED}/{c}" for c in decided if record[c].get("correction")]


def check_files(paths: Sequence[Path], record: Record | None = None) -> Checked:
    """Check certificates; against a record, if there is one."""
    found = Checked()
    for path in paths:
        corrected = path.parent.name == CORRECTED
        try:
            certificate = checker.check(path.read_text(encoding="utf-8"))
            claim = certificate.claim
            name = f"{CORRECTED}/{claim}" if corrected else claim
            checker.need(path.name == f"{claim}.json", f"it is about the claim {claim}")
            checker.need(name not in found.accepted, "the claim was certified before")
            if record is not None:
                _compare(record.get(claim, {}), certificate, corrected)
        except (OSError, UnicodeDecodeError, checker.Rejected) as error:
            found.rejected[str(path)] = str(error) or type(error).__name__
            continue
        found.accepted[name] = certificate
    return found


def _compare(
    entry: Mapping[str, object], certificate: checker.Certificate, corrected: bool
) -> None:
    """Reject a certificate that is not about what the record says."""
    checker.need(entry, "the record has no such claim")
    stale = "`make record` and `make certificates` write both anew"
    if corrected:
        checker.need(entry.get("correction"), f"the record has no correction of it; {stale}")
        checker.need(certificate.sign == "holds", "a correction has to hold")
        return
    same = entry.get("statement") == certificate.digest
    checker.need(same, f"the record has another statement of it; {stale}")
    sign = "denied" if entry.get("verdict") == "refuted" else "holds"
    checker.need(certificate.sign == sign, f"the record has another verdict on it; {stale}")
