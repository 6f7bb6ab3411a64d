"""How a verdict looks: a sign and a word, so that no reader depends on colour."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from kowalevski_cas.verify.outcome import Verdict


@dataclass(frozen=True)
class Mark:
    """The sign of a verdict in text, in LaTeX and in Typst, its colour, and what it means."""

    sign: str
    tex: str
    typst: str
    colour: str
    meaning: str


MARKS: Final[dict[Verdict, Mark]] = {
    Verdict.PROVED: Mark(
        "✓", r"$\checkmark$", "$checkmark$", "1F5C3A", "true as printed, by an exact computation"
    ),
    Verdict.CONDITIONAL: Mark(
        "(✓)",
        r"$(\checkmark)$",
        "$(checkmark)$",
        "8A5A00",
        "true where the named expressions are not zero; what happens elsewhere is said",
    ),
    Verdict.PROBABLE: Mark(
        "≈", r"$\approx$", "$approx$", "555555", "true but for a named chance of error"
    ),
    Verdict.ENCLOSED: Mark("±", r"$\pm$", "$plus.minus$", "555555", "true within a named radius"),
    Verdict.REFUTED: Mark(
        "×",
        r"$\boldsymbol{\times}$",
        "$bold(times)$",
        "A3201D",
        "false as printed, shown by an exact point at which it fails",
    ),
    Verdict.UNDECIDED: Mark("?", r"?", "?", "555555", "neither proved nor refuted"),
    Verdict.TIMEOUT: Mark("…", r"\dots", "…", "555555", "not decided in the time allowed"),
    Verdict.ERROR: Mark("!", r"!", "!", "555555", "not decided, because something went wrong"),
}
