"""A source made of a derivation, for when the paper's own is not at hand."""

from __future__ import annotations

from kowalevski_cas.audit.source import Source
from kowalevski_cas.paper.derivation import Derivation


def synthetic(derivation: Derivation) -> Source:
    """The displays of a derivation, and the sentences that it quotes, as a LaTeX article."""
    sentences = dict.fromkeys(claim.sentence for claim in derivation.claims if claim.sentence)
    said = _without_spaces("".join(sentences))
    lines = [r"\documentclass{article}", r"\newcommand{\bs}{\boldsymbol}", r"\begin{document}"]
    for display in derivation.displays():
        tex = display.tex.strip()
        if display.source or (display.inline and _without_spaces(f"${tex}$") in said):
            continue
        if display.inline:
            lines += [f"Here ${tex}$.", ""]
        else:
            label = rf"\label{{{display.id}}}"
            lines += [rf"\begin{{equation}}{label}", tex, r"\end{equation}", ""]
    lines += [line for sentence in sentences for line in (sentence, "")]
    lines += [r"\end{document}", ""]
    return Source(f"{derivation.name}.tex", "\n".join(lines))


def _without_spaces(text: str) -> str:
    return "".join(text.split())
