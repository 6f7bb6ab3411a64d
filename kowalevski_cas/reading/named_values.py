"""Names that words give to the value of a function, as “denote by E the value of H on a motion”."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from kowalevski_cas.notation import Name, Relation, to_latex
from kowalevski_cas.paper.implied import HAMILTONIANS
from kowalevski_cas.reading.known import CONVENTION, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

CALLED_ENERGY = "called the energy"
"""The kind of a convention that a letter is the energy: it may be a multiple of it."""

_BY = re.compile(r"(?:\b(?:denote|write)s?\s+by|\bчерез)[\s~]*$", re.IGNORECASE)
_VALUE = re.compile(
    r"\s*(?:the\s|обозначим\s)?\s*(?:values?|значение)(?:\s+of)?[\s~]*$", re.IGNORECASE
)
_IS_VALUE = re.compile(
    r"[\s~]*(?:(?:is|denotes|being|stands\s+for|есть|[-—–]+)\s+)(?:the\s+)?"
    r"(?:(?:constant|fixed|initial|conserved|given|постоянное|начальное)\s+)?(?:value|constant|значение|постоянная)"
    r"(?:\s+of)?(?:\s+(?:the\s+)?(?:\w+\s+){0,2}(?:energy|integral|function|Hamiltonian|momentum|интеграла|функции|гамильтониана))?[\s~]*$",
    re.IGNORECASE,
)
"""Words between a letter and a function that call it the value of this."""
_IS_ENERGY = re.compile(
    r"[\s~]*(?:(?:is|denotes|being|есть|[-—–]+)\s+)(?:the\s+)?(?:(?:constant|value|total|полная|постоянная|значение)\s+)*"
    r"(?:(?:of\s+)?(?:the\s+)?(?:total\s+)?energy(?:\s+(?:constant|integral))?|энерги[ия]|интеграла\s+энергии)[\s~]*(?=[.,;)]|$)",
    re.IGNORECASE,
)
"""Words behind a letter that call it the energy."""
_WHERE = re.compile(r"\b(?:where|here|and|with|где|здесь|и|Let|let)[\s~,]*$")
"""How words end before a letter that they explain."""
_ENDS = re.compile(
    r"[\s~]*(?:(?:along|on)\s+(?:a|an|the|each|every)\s+(?:solution|motion|trajectory|orbit)"
    r"|(?:на|вдоль)\s+(?:решени|движени|траектори)\w+)?[\s~]*"
    r"(?:[.;)]|,(?!\s*(?:at|on|in|for|when|if|as|при|в|на|когда)\b)|$)",
    re.IGNORECASE,
)
"""What stands behind a function of which the value is meant along any motion, and nowhere else."""


def named_values(paper: SourcePaper) -> Iterator[SourceStatement]:
    """What words say of names that they give to the value of a function, as equations."""
    for one, other in pairwise(paper.items):
        if not isinstance(one.formula, Name) or other.formula is None:
            continue
        if isinstance(other.formula, Relation) or one.sentence != other.sentence:
            continue
        called = _BY.search(one.lead) and _VALUE.fullmatch(other.lead)
        called = called or (_WHERE.search(one.lead) and _IS_VALUE.fullmatch(other.lead))
        if called and _ENDS.match(other.tail):
            yield _equation(one, to_latex(other.formula), other, paper)


def _equation(
    one: SourceStatement, value: str, beside: SourceStatement, paper: SourcePaper
) -> SourceStatement:
    """That a letter is the value of a function, where words beside a statement say so."""
    assert one.formula is not None
    tex, id = f"{to_latex(one.formula)}={value}", f"{beside.printed.display.id}-in-words"
    return unprinted(paper, id, tex, beside, f"{beside.printed.place} says it")


def _energies(known: Known) -> Iterator[SourceStatement]:
    """What words say of letters that they call the energy, where one function is that."""
    energies = [name for name in (*HAMILTONIANS, "E") if known.varies(name)]
    for one in known.items if len(energies) == 1 else ():
        if isinstance(one.formula, Name) and _WHERE.search(one.lead):
            if one.formula.name not in energies and _IS_ENERGY.match(one.tail):
                yield _equation(one, energies[0], one, known.paper)


def values_in_words(known: Known) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """Those of a part for which nothing else says what they are."""
    places = {one.typed.start for one in known.items}
    energies = [*_energies(known)]
    for item in (*named_values(known.paper), *energies):
        name, of = item.bare[0], item.members[1]
        said = known.is_defined(name) or known.moves(name) or not known.varying(of.names())
        mentioned = any(name in law.mentions for law in known.laws)
        if item.typed.start in places and not (said or mentioned):
            why = f"words call it the value of {plain(to_latex(of))}"
            kind = CALLED_ENERGY if item in energies else ""
            yield item, StatementRole(CONVENTION, why, kind, (name,))
