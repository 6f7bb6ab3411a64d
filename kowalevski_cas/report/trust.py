"""What is proved, and what has to be trusted: the same words in every report."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from kowalevski_cas.report.document import Block, Emphasis, Heading, Paragraph
from kowalevski_cas.report.sentences import Phrases

_TRUST: Final = (
    (
        "What is proved",
        "Every verdict is an exact computation with polynomials that have rational coefficients: "
        "$i$ and square roots are generators with relations, derivatives are taken along the "
        "printed vector field, points have exact coordinates. What is proved holds wherever the "
        "named expressions are not zero; what is refuted fails at a point that is given.",
    ),
    (
        "How it is meant",
        "A dimension is that of a manifold near the exact point that is given, where the "
        "differentials are independent; where they are dependent, neither a dimension nor "
        "independence says anything. A root stands for either of its values that the relations "
        "allow, unless a statement says which.",
    ),
    (
        "What has to be trusted",
        "You must trust that each formula was transcribed and interpreted correctly: compare it "
        "with the paper. For a certified statement you then need to trust only the checker and "
        "the integers of Python, or any other program that confirms its certificate; for any "
        "other statement, the program and one of its three arithmetics, which share how LaTeX is "
        "read and put into polynomials.",
    ),
    (
        "What is not proved",
        "Nothing is said here about how motions behave in the long run, how a set looks as a "
        "whole, or whether a list of cases in the paper is complete, unless a statement above "
        "says so.",
    ),
)


def trust(phrases: Phrases) -> Iterator[Block]:
    """The section that says so."""
    yield Heading(("What is proved, and what has to be trusted",), "section.trust")
    for name, text in _TRUST:
        yield Paragraph((Emphasis((f"{name}.",)), " ", *phrases.words(text)))
