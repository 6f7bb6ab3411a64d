"""Misprints mended in the author's own lines, as a unified diff."""

from __future__ import annotations

from dataclasses import replace

from kowalevski_cas.audit.audit import Audit, audit
from kowalevski_cas.audit.author import AuthorSession
from kowalevski_cas.audit.causes import AuditBase
from kowalevski_cas.audit.places import Correspondence
from kowalevski_cas.notation import NotationError, read_display
from kowalevski_cas.source.difference import difference
from kowalevski_cas.source.text import Source
from kowalevski_cas.source.tokens import changes

ROUNDS = 3
"""A misprint can hide behind another one; so what is mended is audited again."""


def repair_source(found: Audit) -> Source:
    """The source with every misprint mended that a true formula is known for."""
    if found.reading is not None:  # nothing of it differs from its derivation
        return _once(found)
    source = found.source
    for _ in range(ROUNDS):
        before, source = source, _once(found)
        if source.text == before.text:
            break
        found = audit(source, found.session.base)
    return source


def _once(audit: Audit) -> Source:
    """The source with those misprints mended that one audit finds."""
    edits: dict[tuple[int, int], str] = {}
    for place in audit.places:
        edits |= repairs(audit, place)
    return audit.source.edited(edits)


def repairs(audit: Audit, place: Correspondence) -> dict[tuple[int, int], str]:
    """The intervals of the source in which a display is to be mended, with what belongs there."""
    wanted = corrected_tex(audit, place)
    if place.typed is None or wanted is None:
        return {}
    if place.display.tex.startswith(place.typed.tex):  # ranges of indices that stand elsewhere
        wanted = wanted.removesuffix(place.display.tex.removeprefix(place.typed.tex))
    found: dict[tuple[int, int], str] = {}
    end_of_line = "\r\n" if "\r\n" in audit.source.text else "\n"
    for start, end, typed in _minimal(audit, place.typed.tex, wanted):
        first, last = place.typed.start + start, place.typed.start + end
        interval = audit.expanded.origin(first, last)
        if start == end:  # behind what printed the character before
            behind = audit.expanded.origin(first - 1, first)[1] if first else 0
            interval = behind, behind
        found[interval] = typed.replace("\r", "").replace("\n", end_of_line)
    return found


def corrected_tex(audit: Audit, place: Correspondence) -> str | None:
    """The source of a display as it should be; ``None`` if nothing is wrong with it.

    What the author has changed is to be what the derivation has, and a misprint to be mended. It
    is ``None`` too where one row stands for several, of which edits mend one without the others.
    """
    display = place.display
    wrong = [f.place for f in audit.formulas if f.wrong and f.place and f.place.display == display]
    if not wrong:
        return None
    changed = any(printed in audit.session.changed for printed in wrong)
    session: AuditBase | AuthorSession = audit.session.base if changed else audit.session
    texts = session.decider.interpretation.texts
    for printed, edit in session.causes.repairs(display, session.outcomes.values()):
        # An edit before this one may have changed the source: it is read again.
        try:
            statement = texts.statement(printed)
        except NotationError:
            return None
        texts = texts.with_source(display, replace(edit, statement=statement).tex)
    return texts.source(display)


def _minimal(audit: Audit, tex: str, wanted: str) -> list[tuple[int, int, str]]:
    """The least to type anew; the whole formula if less would not read as what is wanted."""
    small = list(changes(tex, wanted))
    result = _replace(tex, {(start, end): typed for start, end, typed in small})
    vocabulary = audit.session.interpretation.texts.vocabulary
    try:
        found = [statement.formula for statement in read_display(result, vocabulary)]
        if found == [statement.formula for statement in read_display(wanted, vocabulary)]:
            return small
    except NotationError:
        pass
    return [(0, len(tex), wanted)]


def _replace(text: str, replacements: dict[tuple[int, int], str]) -> str:
    for start, end in sorted(replacements, reverse=True):
        text = text[:start] + replacements[start, end] + text[end:]
    return text


def patch(found: Audit) -> str:
    """A unified diff that mends every misprint, empty if there is none."""
    return difference(found.source, repair_source(found))
