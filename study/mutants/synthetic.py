"""A source made of a derivation, for when the paper's own is not at hand."""

from __future__ import annotations

from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.source.text import Source


def synthetic(derivation: Derivation) -> Source:
    """The displays of a derivation, and the sentences that it quotes, as a LaTeX article.

    A sentence that quotes a formula stands where the formula does; the others are at the end.
    """
    sentences = dict.fromkeys(claim.sentence for claim in derivation.claims if claim.sentence)
    said = _without_spaces("".join(sentences))
    lines = [r"\documentclass{article}", r"\newcommand{\bs}{\boldsymbol}", r"\begin{document}"]
    for display in derivation.displays():
        tex = display.tex.strip()
        if display.source:
            continue
        quoted = _without_spaces(f"${tex}$")
        if display.inline and quoted in said:
            here = [sentence for sentence in sentences if quoted in _without_spaces(sentence)]
            lines += [line for sentence in here for line in (sentence, "")]
            sentences = {sentence: None for sentence in sentences if sentence not in here}
        elif display.inline:
            lines += [f"Here ${tex}$.", ""]
        else:
            label = rf"\label{{{display.id}}}"
            lines += [rf"\begin{{equation}}{label}", tex, r"\end{equation}", ""]
    lines += [line for sentence in sentences for line in (sentence, "")]
    lines += [r"\end{document}", ""]
    return Source(f"{derivation.name}.tex", "\n".join(lines))


def _without_spaces(text: str) -> str:
    return "".join(text.split())
