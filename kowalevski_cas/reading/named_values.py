"""Names that words give to the value of a function, as “denote by E the value of H on a motion”."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from kowalevski_cas.notation import Name, Relation, to_latex
from kowalevski_cas.paper.implied import HAMILTONIANS
from kowalevski_cas.reading.known import CONVENTION, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.text import references
from kowalevski_cas.reading.unprinted import unprinted

CALLED_ENERGY = "called the energy"
"""The kind of a convention that a letter is the energy: it may be a multiple of it."""

_VALUE = re.compile(
    r"\s*(?:for\s+)?(?:the\s|обозначим\s)?\s*(?:(?:constant|fixed|conserved|постоянное)\s+)?(?:values?|значение)(?:\s+of)?[\s~]*$",
    re.IGNORECASE,
)
_CALLS = r"\b(?:call|denot|nam|writ|обознач)\w*\s+"
_CALLING = re.compile(
    r"\b(?:(?:call|denot|nam|writ|обознач)\w*(?:\s+by)?|through|через)[\s~]*$", re.IGNORECASE
)
_VALUE_OF = re.compile(
    rf"(?:{_CALLS}|^\W*)(?:the\s+)?(?:(?:constant|fixed|conserved|постоянное)\s+)?(?:value|значение)(?:\s+of)?(?:\s+(?:the\s+)?\w+)?[\s~]*$",
    re.IGNORECASE,
)
_ITS_VALUE = re.compile(
    rf"{_CALLS}(?:its|the|его|её)\s+(?:(?:constant|fixed|conserved|постоянное)\s+)*(?:value|constant|значение)(?:\s+(?:by|as|через))?[\s~]*$",
    re.IGNORECASE,
)
"""How words end before a letter that is the value of what stands before it."""
_HAS_VALUE = re.compile(
    r"[\s~,]*\b(?:ha(?:s|ve)|having|tak(?:es?|ing)|assum(?:es?|ing)|принимает|имеет)\s+(?:then\s+)?(?:the\s+)?"
    r"(?:(?:constant|fixed|conserved|given|постоянное)\s+)*(?:value|значение)[\s~]*",
    re.IGNORECASE,
)
"""Words between a function and the letter of its value."""
_BY_ALONE = re.compile(
    r"[\s~]*(?:(?:is|will\s+be)\s+(?:denoted|called|written)\s+)?(?:by|as|через)?[\s~]*",
    re.IGNORECASE,
)
_IS_VALUE = re.compile(
    r"[\s~]*(?:(?:is|be|denotes|being|stands\s+for|есть|[-—–]+)\s+)(?:the\s+)?"
    r"(?:(?:constant|fixed|initial|conserved|given|постоянное|начальное)\s+)?(?:value|constant|значение|постоянная)"
    r"(?:\s+of)?(?:\s+(?:the\s+)?(?:\w+\s+){0,2}(?:energy|integral|function|Hamiltonian|momentum|интеграла|функции|гамильтониана))?[\s~]*$",
    re.IGNORECASE,
)
"""Words between a letter and a function that call it the value of this."""
_IS_ENERGY = re.compile(
    r"[\s~]*(?:(?:is|be|denotes|being|есть|[-—–]+)\s+)(?:the\s+)?(?:(?:constant|value|total|полная|постоянная|значение)\s+)*"
    r"(?:(?:of\s+)?(?:the\s+)?(?:total\s+)?energy(?:\s+(?:constant|integral))?|энерги[ия]|интеграла\s+энергии)[\s~]*(?=[.,;)]|$)",
    re.IGNORECASE,
)
"""Words behind a letter that call it the energy."""
_WITH_ENERGY = re.compile(
    r"\b(?:with|of|at|having)\s+(?:the\s+)?(?:(?:given|fixed|total|constant)\s+)*energy[\s~]*$"
    r"|\bdenot\w*\s+the\s+energy(?:\s+constant)?\s+by[\s~]*$|\b(?:с|при)\s+энергией[\s~]*$",
    re.IGNORECASE,
)
"""How words end before a letter for the energy of some motions."""
_WHERE = re.compile(r"\b(?:where|here|and|with|где|здесь|и|Let|let)[\s~,]*$")
"""How words end before a letter that they explain."""
_ENDS = re.compile(
    r"[\s~]*(?:(?:along|on)\s+(?:a|an|the|each|every)\s+(?:solution|motion|trajectory|orbit)"
    r"|(?:на|вдоль)\s+(?:решени|движени|траектори)\w+)?[\s~]*"
    r"(?:[.;)]|(?:we|one|мы)\b|,(?!\s*(?:at|on|in|for|when|if|as|при|в|на|когда)\b)|$)",
    re.IGNORECASE,
)
"""What stands behind a function of which the value is meant along any motion, and nowhere else."""


_OF_CITED = re.compile(
    r"[\s~]*(?:(?:is|be|denotes|being|stands\s+for|есть|[-—–]+)\s+)?(?:the\s+)?(?:(?:constant|fixed|conserved|постоянное)\s+)?"
    r"(?:value|constant|значение|постоянн\w+)(?:\s+of)?(?:\s+(?:the\s+)?(?:\w+\s+){0,2}(?:integrals?|functions?|интеграла|функции))?"
    r"[\s~]*(?P<cited>\(?\\(?:eq|c|C|auto)?ref\s*\{[^{}]*\}\)?)",
    re.IGNORECASE,
)
"""Words behind a letter that call it the value of what they cite."""
_JOINED = re.compile(r"[\s,~]*(?:\b(?:and|и)\b)?[\s~]*", re.IGNORECASE)
_ARE_VALUES = re.compile(
    r"\s*(?:(?:be|are|denote|being|stand\s+for|суть|[-—–]+)\s+)?(?:the\s+)?"
    r"(?:(?:constant|fixed|conserved|respective|постоянные)\s+)*(?:values|constants|значения)(?:\s+of)?"
    r"(?:\s+(?:the\s+)?(?:\w+\s+)?(?:integrals|functions|интегралов|функций))?[\s~]*",
    re.IGNORECASE,
)
"""Words between letters and as many functions that call them the values of these."""


def _runs(items: Sequence[SourceStatement]) -> Iterator[list[SourceStatement]]:
    """The formulas that nothing but commas, or “and”, joins, one sentence after the other."""
    run: list[SourceStatement] = []
    for one in items:
        if run and not (run[-1].sentence == one.sentence and _JOINED.fullmatch(one.lead)):
            yield run
            run = []
        run.append(one)
    yield from [run] if run else []


def _several_values(paper: SourcePaper) -> Iterator[SourceStatement]:
    """What words say of several names at once: “let h and k be the values of H and K”."""
    for own, others in pairwise(_runs(paper.items)):
        alike = len(own) == len(others) > 1 and own[0].sentence == others[0].sentence
        if not (alike and _ARE_VALUES.fullmatch(others[0].lead) and _ENDS.match(others[-1].tail)):
            continue
        called = _CALLING.search(own[0].lead) or _WHERE.search(own[0].lead)
        for one, other in zip(own, others, strict=True) if called else ():
            of = other.formula
            if isinstance(one.formula, Name) and of is not None and not isinstance(of, Relation):
                yield _equation(one, to_latex(of), other, paper)


def named_values(paper: SourcePaper) -> Iterator[SourceStatement]:
    """What words say of names that they give to the value of a function, as equations."""
    yield from _several_values(paper)
    yield from _of_cited(paper)
    for one, other in pairwise(paper.items):
        if one.formula is None or other.formula is None or one.paragraph != other.paragraph:
            continue
        if isinstance(other.formula, Name) and (value := _value_before(one, other)):
            if _ENDS.match(other.tail):
                yield _equation(other, value, other, paper)
        elif isinstance(one.formula, Name) and not isinstance(other.formula, Relation):
            called = _CALLING.search(one.lead) and _VALUE.fullmatch(other.lead)
            called = called or (_WHERE.search(one.lead) and _IS_VALUE.fullmatch(other.lead))
            if called and one.sentence == other.sentence and _ENDS.match(other.tail):
                yield _equation(one, to_latex(other.formula), other, paper)


def _of_cited(paper: SourcePaper) -> Iterator[SourceStatement]:
    """What words say of letters for the values of what they cite: “f is the constant of (3)”."""
    for one in paper.items:
        if not isinstance(one.formula, Name):
            continue
        called = _CALLING.search(one.lead) or _WHERE.search(one.lead)
        found = _OF_CITED.match(one.tail) if called else None
        cited = (
            [o for label in references(found["cited"]) for o in paper.labels.get(label, ())]
            if found
            else []
        )
        if found and len(cited) == 1 and _ENDS.match(one.tail[found.end() :]):
            (of,) = cited
            if of.order < one.order and of.bare and of.members[0] == Name(of.bare[0]):
                yield _equation(one, of.bare[0], one, paper)


def _value_before(one: SourceStatement, name: SourceStatement) -> str:
    """The function printed right before a name that words give to its value; empty if none is."""
    of = _VALUE_OF.search(one.lead) and _BY_ALONE.fullmatch(name.lead)
    if not (of or _ITS_VALUE.search(name.lead) or _HAS_VALUE.fullmatch(name.lead)):
        return ""
    if one.formula is None or not isinstance(one.formula, Relation):
        return to_latex(one.formula) if one.formula is not None else ""
    return one.bare[0] if one.bare and one.members[0] == Name(one.bare[0]) else ""


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
        if isinstance(one.formula, Name) and one.formula.name not in energies:
            called = _WHERE.search(one.lead) and _IS_ENERGY.match(one.tail)
            if called or _WITH_ENERGY.search(one.lead):
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
