"""Exit codes, and errors that end a command with one of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

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

_ALWAYS = {
    USAGE: "wrong usage, or input that cannot be read",
    FAILED: "the program itself failed",
    INTERRUPTED: "interrupted",
}
_RUN = {
    AS_RECORDED: "every verdict is as recorded, or as expected",
    DIFFERENT: "a verdict differs from the recorded or expected one",
    UNDECIDED: "nothing else differs, and a claim is undecided, or timed out",
    DISAGREEMENT: "the arithmetics disagree",
    REJECTED: "with a report: a certificate is rejected",
    NOTHING: "there is no such claim, or none at all",
}
_MEANINGS = {
    "": {
        AS_RECORDED: "as recorded: nothing is wrong that was not known to be",
        DIFFERENT: "a verdict differs from the record, or a formula is false",
        UNDECIDED: "nothing of that, and something undecided, timed out, or not judged",
        DISAGREEMENT: "the arithmetics disagree",
        REJECTED: "a certificate is rejected, or not confirmed",
        NOTHING: "nothing was selected",
    },
    "verify": _RUN,
    "report": _RUN,
    "audit": {
        AS_RECORDED: "all that is claimed is proved",
        DIFFERENT: "a formula is false, or cannot be read",
        UNDECIDED: "nothing is false, and a claim is undecided, timed out, or is not judged",
        DISAGREEMENT: "the arithmetics disagree",
        NOTHING: "there are no equations of motion, or no claims",
        INTERRUPTED: "interrupted: what was decided by then is printed",
    },
    "review": {
        AS_RECORDED: "nothing is false but what was known to be",
        DIFFERENT: "a formula is false, and was not known to be",
        UNDECIDED: "with --strict: something is undecided or not judged",
        NOTHING: "there is no paper, or none that claims anything",
    },
    "bundle": {AS_RECORDED: "it is written", NOTHING: "there are no certificates"},
    "find": {
        AS_RECORDED: "the search is complete, and what was found is proved",
        UNDECIDED: "something may be left, or is undecided",
        NOTHING: "there is no such scene",
    },
    "prove": {AS_RECORDED: "the certificate is printed", UNDECIDED: "no evidence was found"},
    "check": {
        AS_RECORDED: "every certificate is accepted",
        REJECTED: "a certificate is rejected, or is about another statement",
        NOTHING: "there are no certificates",
    },
    "certificates": {AS_RECORDED: "they are written", NOTHING: "there is nothing to write"},
    "export": {
        AS_RECORDED: "the files are written",
        REJECTED: "a certificate is rejected",
        NOTHING: "nothing can be said in that language",
    },
    "witness": {
        AS_RECORDED: "every claim that can be said there is confirmed",
        REJECTED: "a claim is not confirmed",
        NOTHING: "nothing can be said in that language",
    },
    "motion": {AS_RECORDED: "the states are printed", UNDECIDED: "no method reached the last time"},
    "pictures": {AS_RECORDED: "they are drawn", NOTHING: "there is no such picture"},
    "record": {
        AS_RECORDED: "the record is written, and every claim has a verdict",
        UNDECIDED: "the record is written, and something is undecided",
        DISAGREEMENT: "the arithmetics disagree, and nothing is written",
        NOTHING: "there are no claims",
    },
}


def exit_codes(command: str, own: Mapping[int, str] | None = None) -> str:
    """What the exit codes of a command mean, or of all, to stand at the end of a help.

    A command that is none of the package's says what its ``own`` mean.
    """
    meanings = {AS_RECORDED: "done"} | _ALWAYS | {**(own or _MEANINGS.get(command, {}))}
    lines = (f"  {code:<3} {words}\n" for code, words in sorted(meanings.items()))
    return "exit codes:\n" + "".join(lines)


_URGENCY = (AS_RECORDED, UNDECIDED, DIFFERENT, REJECTED, USAGE, DISAGREEMENT)


def most_urgent(codes: Iterable[int]) -> int:
    """The code with which a command ends that has several results."""
    return max(codes, key=_URGENCY.index)


class CommandError(UserError):
    """What keeps a command from its work; it ends with ``code``."""

    def __init__(self, message: str, code: int = USAGE) -> None:
        super().__init__(message)
        self.code = code
