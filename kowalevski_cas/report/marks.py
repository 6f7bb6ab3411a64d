"""How a verdict looks: a sign and a word, so that no reader depends on colour."""

from __future__ import annotations

from typing import Final, Literal, NamedTuple

from kowalevski_cas.verify.outcome import Outcome, Verdict

Shown = Verdict | Literal["spoiled"]
"""How a statement is shown: by its verdict, unless another formula makes it false."""

SPOILED: Final = "spoiled"


class VerdictMark(NamedTuple):
    """The word and the sign of a verdict, in LaTeX and Typst too, its colours, what it means."""

    word: str
    sign: str
    tex: str
    typst: str
    colour: str
    on_black: str
    meaning: str


MARKS: Final[dict[Shown, VerdictMark]] = {
    Verdict.PROVED: VerdictMark("holds", "✓", r"$\checkmark$", "$checkmark$", "1F5C3A", "7BC99B",
        "holds"),
    Verdict.CONDITIONAL: VerdictMark("holds if", "(✓)", r"$(\checkmark)$", "$(checkmark)$",
        "8A5A00", "E0B050", "holds under a condition that is named"),
    Verdict.PROBABLE: VerdictMark("probable", "≈", r"$\approx$", "$approx$", "555555", "AAAAAA",
        "holds up to a stated probability of error"),
    Verdict.ENCLOSED: VerdictMark("enclosed", "±", r"$\pm$", "$plus.minus$", "555555", "AAAAAA",
        "holds within a named radius"),
    Verdict.REFUTED: VerdictMark("false", "✗", r"$\boldsymbol{\times}$", "$bold(times)$",
        "A3201D", "FF8A80", "is false or misprinted, as an exact point shows"),
    SPOILED: VerdictMark("fails because of another formula", "(✗)", r"$(\boldsymbol{\times})$",
        "$(bold(times))$", "8A5A00", "E0B050", "fails only because another formula is misprinted"),
    Verdict.UNDECIDED: VerdictMark("undecided", "?", r"?", "?", "555555", "AAAAAA",
        "is neither proved nor refuted"),
    Verdict.TIMEOUT: VerdictMark("timeout", "…", r"\dots", "…", "555555", "AAAAAA",
        "was not decided in the time allowed"),
    Verdict.ERROR: VerdictMark("error", "!", r"!", "!", "555555", "AAAAAA",
        "was not decided, because something went wrong"),
}  # fmt: skip


def shown_as(outcome: Outcome) -> Shown:
    """How a statement with its outcome is shown."""
    return SPOILED if outcome.spoiled else outcome.verdict
