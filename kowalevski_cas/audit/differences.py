"""How an author's texts differ from those of a derivation."""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas.audit.memory import Memory
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.notation import Formula, NotationError, to_latex
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.proof.dependencies import names
from kowalevski_cas.proof.evidence import Evidence


def spliced(texts: Texts, base: Texts, printed: Printed) -> str:
    """The source of a display with one statement as the base has it."""
    wanted = base.statement(printed)
    try:
        own = texts.statement(printed)
    except NotationError:
        return wanted.tex
    return f"{own.tex[: own.start]}{to_latex(wanted.formula)} {own.tex[own.end :]}"


def usable_evidence(memory: Memory, sources: Iterable[Display]) -> dict[str, Evidence]:
    """The evidence that was kept, without corrections of displays that are typed otherwise."""
    typed = {display.id for display in sources}
    kept = dict(memory.evidence)
    for claim, entry in memory.evidence.items():
        if entry.correction is not None and entry.correction.place.rpartition(".")[0] in typed:
            kept[claim] = Evidence(entry.digest, entry.found)
    return kept


def changed_places(texts: Texts, own: Texts, sources: Iterable[Display]) -> frozenset[Printed]:
    """The statements of the sources that are not those of the derivation."""
    changed: set[Printed] = set()
    for display in sources:
        new, old = formulas(texts, display), formulas(own, display)
        for number in range(1, max(len(new), len(old)) + 1):
            if new[number - 1 : number] != old[number - 1 : number]:
                changed.add(display[number])
    return frozenset(changed)


def formulas(texts: Texts, display: Display) -> tuple[Formula, ...]:
    """The statements of a display as they are read; none if it cannot be read."""
    found: list[Formula] = []
    try:
        while True:
            found.append(texts.statement(display[len(found) + 1]).formula)
    except NotationError:
        return tuple(found)


def unused(derivation: Derivation, own: Texts, texts: Texts, printed: Printed) -> list[str]:
    """The constants of scenes that nothing depends on, now that a place has lost them."""
    before = set(names(own.formula(printed)))
    gone = before - set(names(texts.formula(printed)))
    found: dict[str, None] = {}
    for scene in derivation.scenes():
        places = set(scene.places())
        if printed in places:
            places.update(*(c.places() for c in derivation.claims if scene in c.scenes()))
            left = {name for place in places for name in names(texts.formula(place))}
            found.update(dict.fromkeys(sorted(gone & set(scene.constants) - left)))
    return list(found)
