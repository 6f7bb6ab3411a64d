r"""Names with primes, as :math:`\gamma,\gamma',\gamma''` of the components of a vector."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Derivative, Formula, Name
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.reader import read_display
from kowalevski_cas.notation.vocabulary import Vocabulary


def primed_names(tex: str, words: Vocabulary) -> Iterator[str]:
    r"""The names with primes, where rates of some are printed, as :math:`d\gamma'/dt`.

    Then no prime is a derivative.
    """
    chains = _chains(tex, words)
    if any("prime" in marks and {*marks} != {"prime"} for _, marks in chains):
        yield from (name + "'" * marks.count("prime") for name, marks in chains if name)


def primed_vectors(tex: str, words: Vocabulary) -> Iterator[str]:
    """The vectors with primes, where no prime is a derivative."""
    for name, marks in _chains(tex, words):
        if name in words.vectors and "prime" in marks:
            yield name + "'" * marks.count("prime")


def _chains(tex: str, words: Vocabulary) -> list[tuple[str, list[str]]]:
    """The names under derivatives in a formula that has primes, and how these are printed."""
    if "'" not in tex and r"\prime" not in tex:
        return []
    try:
        found = read_display(tex, words, OpenParser)
    except NotationError:
        return []  # who reads it says so
    return [_marks(node) for one in found for node in one.formula.nodes()]


def _marks(formula: Formula) -> tuple[str, list[str]]:
    """The name under derivatives, and how they are printed; empty for anything else."""
    marks: list[str] = []
    while isinstance(formula, Derivative):
        marks.append(formula.mark)
        formula = formula.argument
    return (formula.name, marks) if isinstance(formula, Name) and marks else ("", [])
