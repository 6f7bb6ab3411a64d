"""What somebody has to look at, at its place in a file: what editors and reviews show."""

from __future__ import annotations

from typing import NamedTuple

from kowalevski_cas.source.text import Region

RULES = {
    "refuted": "The formula, or the statement, is false at an exact point.",
    "suspect": "A changed definition makes other formulas false.",
    "error": "The formula has no meaning where it stands.",
    "unreadable": "The formula cannot be read.",
    "missing": "A formula that the derivation needs is not in the source.",
    "undecided": "The formula was neither proved nor refuted.",
    "timeout": "The formula was not decided in time.",
    "moved": "The formula stands elsewhere than in the derivation.",
    "open": "The formula claims something, and is not judged.",
    "different": "The verdict differs from the recorded or expected one.",
}
"""The kinds of diagnostics, with what each says."""

ERROR, WARNING, NOTE = "error", "warning", "note"


class Replacement(NamedTuple):
    """Text that belongs in the place of what stands in a region."""

    region: Region
    text: str


class Diagnostic(NamedTuple):
    """Something to look at: its kind, how bad it is, what it is about, where, and what mends it.

    ``fingerprint`` is that of the same formula, or statement, with the same trouble, wherever it
    stands in its file.
    """

    rule: str
    level: str
    id: str
    message: str
    region: Region
    fixes: tuple[Replacement, ...] = ()
    fingerprint: str = ""
