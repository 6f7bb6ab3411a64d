r"""Names with primes, as :math:`\gamma,\gamma',\gamma''` of the components of a vector."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Derivative, Formula, Name, Relation, Vector
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.reader import read_display
from kowalevski_cas.notation.vocabulary import Vocabulary


def primed_names(tex: str, words: Vocabulary) -> Iterator[str]:
    r"""The names with primes, where rates of some are printed, as :math:`d\gamma'/dt`.

    Then no prime is a derivative.
    """
    chains = [_marks(node) for one in _formulas(tex, words) for node in one.nodes()]
    if any("prime" in marks and {*marks} != {"prime"} for _, marks in chains):
        yield from (name + "'" * marks.count("prime") for name, marks in chains if name)


def primed_vectors(tex: str, words: Vocabulary) -> Iterator[str]:
    r"""The vectors with primes that have components with primes, :math:`\mathbf r'=(x',y')`."""
    for formula in _formulas(tex, words):
        match formula:
            case Relation((left, Vector(components))):
                name, marks = _marks(left)
                primed = all("prime" in own for _, own in map(_marks, components))
                if primed and {*marks} == {"prime"}:
                    yield name + "'" * len(marks)


def _formulas(tex: str, words: Vocabulary) -> Iterator[Formula]:
    """The formulas in a text that has primes; none if it cannot be read: who reads it says so."""
    if "'" in tex or r"\prime" in tex:
        with suppress(NotationError):
            yield from (one.formula for one in read_display(tex, words, OpenParser))


def _marks(formula: Formula) -> tuple[str, list[str]]:
    """The name under derivatives, and how they are printed; empty for anything else."""
    marks: list[str] = []
    while isinstance(formula, Derivative):
        marks.append(formula.mark)
        formula = formula.argument
    return (formula.name, marks) if isinstance(formula, Name) and marks else ("", [])
