"""How a verdict looks: a sign and a word, so that no reader depends on colour."""

from __future__ import annotations

from typing import Final, NamedTuple

from kowalevski_cas.verify.outcome import Verdict


class VerdictMark(NamedTuple):
    """The word and the sign of a verdict, in LaTeX and Typst too, its colours, what it means."""

    word: str
    sign: str
    tex: str
    typst: str
    colour: str
    on_black: str
    meaning: str


MARKS: Final[dict[Verdict, VerdictMark]] = {
    Verdict.PROVED: VerdictMark("holds", "✓", r"$\checkmark$", "$checkmark$", "1F5C3A", "7BC99B",
        "holds"),
    Verdict.CONDITIONAL: VerdictMark("holds if", "(✓)", r"$(\checkmark)$", "$(checkmark)$",
        "8A5A00", "E0B050", "holds under a condition that is named"),
    Verdict.PROBABLE: VerdictMark("probable", "≈", r"$\approx$", "$approx$", "555555", "AAAAAA",
        "holds but for a named chance of error"),
    Verdict.ENCLOSED: VerdictMark("enclosed", "±", r"$\pm$", "$plus.minus$", "555555", "AAAAAA",
        "holds within a named radius"),
    Verdict.REFUTED: VerdictMark("false", "✗", r"$\boldsymbol{\times}$", "$bold(times)$",
        "A3201D", "FF8A80", "is false: it fails at a point that is given"),
    Verdict.UNDECIDED: VerdictMark("undecided", "?", r"?", "?", "555555", "AAAAAA",
        "is neither proved nor refuted"),
    Verdict.TIMEOUT: VerdictMark("timeout", "…", r"\dots", "…", "555555", "AAAAAA",
        "was not decided in the time allowed"),
    Verdict.ERROR: VerdictMark("error", "!", r"!", "!", "555555", "AAAAAA",
        "was not decided, because something went wrong"),
}  # fmt: skip
