"""The certificates that are committed with a derivation, checked against its statements."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from kowalevski_cas.proof import checker

FOLDER = "certificates"


@dataclass(frozen=True, slots=True)
class Committed:
    """What the checker says about the certificates of a derivation.

    ``digests`` has the accepted certificates by claim, ``said`` what each of them
    proves; ``rejected`` says why for the others; ``without`` lists the claims that
    have none.
    """

    digests: dict[str, str] = field(default_factory=dict)
    said: dict[str, list[str]] = field(default_factory=dict)
    rejected: dict[str, str] = field(default_factory=dict)
    without: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """One line about all of them."""
        number = len(self.digests) + len(self.rejected)
        return f"CERTIFIED {len(self.digests)} of {number}"


def certificate_files(folder: Path) -> list[Path]:
    """The certificates in the folder of a derivation, by name."""
    return sorted((folder / FOLDER).glob("*.json"))


def check_committed(folder: Path, statements: Mapping[str, str]) -> Committed:
    """Check the certificates in a derivation's folder.

    ``statements`` has the digest of the statement of each claim, as the run or the
    record has it; a certificate for another statement is rejected.
    """
    found = Committed()
    for path in certificate_files(folder):
        name = path.stem
        try:
            text = path.read_text(encoding="utf-8")
            claim, said = checker.check(text)
            data = json.loads(text)
            checker.need(claim == name, f"it is about the claim {claim}")
            checker.need(claim in statements, "there is no such claim")
            checker.need(data["statement"] == statements[claim], "it is about another statement")
        except Exception as error:  # whatever goes wrong, nothing is certified
            found.rejected[name] = str(error) or type(error).__name__
            continue
        found.digests[name], found.said[name] = str(data["digest"])[:16], said
    certified = {*found.digests, *found.rejected}
    without = tuple(claim for claim in statements if claim not in certified)
    return Committed(found.digests, found.said, found.rejected, without)
