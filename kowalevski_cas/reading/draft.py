"""All that is inferred of a paper as comments: an author corrects them, and composes none."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby

from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.reading.grammar import AS, RULED
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, DEFINITION, LAW, LEVEL
from kowalevski_cas.reading.reader import JudgedStatement, Reading
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import is_printed
from kowalevski_cas.source.comments import MARK
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.text import Source

_VERBS = {LAW: "law", DEFINITION: "define", LEVEL: "level", ASSUMPTION: "given"}
_KINDS = {kind: word for word, kind in AS.items()}


def draft(reading: Reading) -> Source:
    """The source with a comment for every role that is inferred."""
    return reading.paper.source.edited({place: text for _, place, text in insertions(reading)})


def insertions(reading: Reading) -> Iterator[tuple[TypedFormula, tuple[int, int], str]]:
    """The formulas of which something is inferred, and where the comments on each are inserted.

    Where a line begins with several formulas, the first one has the comments.
    """
    source, seen = reading.paper.source, set[int]()
    for typed, lines in comments(reading):
        place = _place(typed, reading.paper)
        begin = source.text.rfind("\n", 0, place) + 1
        indented = source.text[begin:place]
        written = "".join(f"{indented if indented.isspace() else ''}{line}\n" for line in lines)
        if not indented.strip():
            place = begin
        else:
            written = ("\n" if indented[-1].isspace() else "%\n") + written
        if place not in seen:
            seen.add(place)
            yield typed, (place, place), written


def beside(reading: Reading) -> str:
    """The same comments as a file beside the source."""
    source = reading.paper.source
    kept = f"{source.beside.text.rstrip()}\n" if source.beside is not None else ""
    anchored = (
        f"{_anchor(typed, reading.paper)} {line}\n"
        for typed, lines in comments(reading)
        for line in lines
    )
    return kept + "".join(anchored)


def comments(reading: Reading) -> Iterator[tuple[TypedFormula, list[str]]]:
    """The formulas of which something is inferred, each with the comments that say it."""
    said = reading.parts.said
    printed = [formula for formula in reading.formulas if formula.item.typed.kind]
    for _, group in groupby(printed, key=lambda formula: id(formula.item.typed)):
        formulas = [*group]
        typed = formulas[0].item.typed
        texts = ["" if said.of.get(f.item) else text_of(f, reading.paper) for f in formulas]
        if len({*texts}) == 1:
            lines = texts[:1]
        else:
            lines = [
                f"{f.item.printed.number} {t}" for f, t in zip(formulas, texts, strict=True) if t
            ]
        lines = [f"{MARK} {line}" for line in lines if line]
        if lines and typed.kind:  # what is deduced of a printed one stands nowhere
            yield typed, lines


def text_of(formula: JudgedStatement, paper: SourcePaper) -> str:
    """The comment that says the role of a statement; empty for what states nothing."""
    role = formula.role
    names = " ".join(name.replace(" ", "") for name in role.names)
    if role.name == CLAIM and role.kind in RULED:
        words = ["claim", role.kind, *(["names", names] if names else [])]
        on = [_called(item, paper) for item in formula.on if is_printed(item)]
        if on and formula.doubt is not Doubt.ALWAYS:  # else it would say what nobody knows
            words += ["on", *on]
        return " ".join(words)
    if role.name == DEFINITION and role.kind == "change":
        return f"map {names}"
    if role.name not in _VERBS or role.kind not in ("", *_KINDS) or formula.item.formula is None:
        return ""
    if role.name == LAW:
        return "law"
    kind = f"as {_KINDS[role.kind]} " if role.kind else ""
    return f"{_VERBS[role.name]} {kind}{names}".strip()


def _called(item: SourceStatement, paper: SourcePaper) -> str:
    """What a statement is called in a comment."""
    beside = [one for one in paper.items if one.typed is item.typed]
    return item.printed.display.id if len(beside) == 1 else item.printed.place


def _place(typed: TypedFormula, paper: SourcePaper) -> int:
    """Where in the file a formula begins, with what opens it."""
    text, before = paper.expanded.text, [f for _, f in paper.displays if f.start < typed.start]
    mark = typed.kind if typed.kind[0] in "$\\" else f"\\begin{{{typed.kind}}}"
    opened = text.rfind(mark, 0, typed.start)
    if opened < 0 or (before and opened < before[-1].end):  # another row of the environment
        opened = _start(typed)
    return paper.expanded.origin(opened, opened + 1)[0]


def _start(typed: TypedFormula) -> int:
    """Where in the text a formula prints its first sign."""
    return typed.start + len(typed.tex) - len(typed.tex.lstrip())


def _anchor(typed: TypedFormula, paper: SourcePaper) -> str:
    """The label of a formula, or enough of its words in quotes."""
    if typed.labels:
        return typed.labels[0]
    text = paper.source.visible
    start = paper.expanded.origin(_start(typed), _start(typed) + 1)[0]
    end = start
    while end < len(text):
        end = next((m.end() for m in re.compile(r"\s*\S{1,12}").finditer(text, end)), len(text))
        words = text[start:end].split()
        if len([*re.finditer(r"[\s~]+".join(map(re.escape, words)), text)]) == 1:
            break
    return f'"{" ".join(words)}"'
