"""A paper's source read as a derivation: what each formula is, and on what it stands."""

from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    CONVENTION,
    DEFINITION,
    LAW,
    UNREAD,
    StatementRole,
)
from kowalevski_cas.reading.reader import JudgedStatement, Reading, read

__all__ = [
    "ASSUMPTION",
    "CLAIM",
    "CONVENTION",
    "DEFINITION",
    "LAW",
    "UNREAD",
    "JudgedStatement",
    "Reading",
    "StatementRole",
    "read",
]
