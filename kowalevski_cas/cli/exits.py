"""Exit codes, and errors that end a command with one of them."""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas import UserError

AS_RECORDED = 0
DIFFERENT = 1
USAGE = 2
UNDECIDED = 3
DISAGREEMENT = 4
REJECTED = 5
NOTHING = 6
FAILED = 7
INTERRUPTED = 130

EXIT_CODES = """exit codes:
  0   as recorded; nothing is wrong that was not known to be
  1   a verdict differs from the record, or (audit) a formula is refuted
  2   wrong usage, or input that cannot be read
  3   undecided or timed out, or (audit) a claim is not judged
  4   the arithmetics disagree
  5   a certificate is rejected, or not confirmed
  6   nothing was selected, or (audit) a source has no equations of motion, or no claims
  7   the program itself failed
  130 interrupted
"""

_URGENCY = (AS_RECORDED, DIFFERENT, REJECTED, UNDECIDED, USAGE, DISAGREEMENT)


def most_urgent(codes: Iterable[int]) -> int:
    """The code with which a command ends that has several results."""
    return max(codes, key=_URGENCY.index)


class CommandError(UserError):
    """What keeps a command from its work; it ends with ``code``."""

    def __init__(self, message: str, code: int = USAGE) -> None:
        super().__init__(message)
        self.code = code
