"""What scales as nothing else in a source does is told: nothing is decided by it."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from kowalevski_cas.audit.audited import GIVEN, OPEN, Audited
from kowalevski_cas.notation import Edit, NotationError, to_latex
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.reading import Reading
from kowalevski_cas.reading.dimensions import AS_THE_REST, Misscaled, shown
from kowalevski_cas.verify.outcome import Verdict


def tell_scales(found: Sequence[Audited], reading: Reading) -> None:
    """Doubt what scales as nothing else does, unless it is proved or refuted as it stands."""
    by_place = {audited.place: audited for audited in found if audited.place is not None}
    unread = {audited.id: audited for audited in found if audited.place is None}
    for one in reading.misscaled:
        place = one.item.printed
        audited = by_place.get(place) or unread.get(place.display.id)
        if audited is not None and audited.verdict in (GIVEN, OPEN, Verdict.UNDECIDED):
            audited.verdict = Verdict.UNDECIDED
            audited.message = "; ".join(filter(None, (audited.message, _told(one))))
            audited.causes = (audited.name,)


def edits_by_scales(reading: Reading, texts: Texts) -> dict[Printed, list[Edit]]:
    """The edits by which what scales as nothing else does would scale as the rest."""
    found: dict[Printed, list[Edit]] = {}
    for one in reading.misscaled:
        with suppress(NotationError):  # it may be unread
            statement = texts.statement(one.item.printed)
            if statement.formula == one.formula:
                slips = (slip for slip, _ in one.repairs)
                edits = [Edit(*slip, statement, texts.vocabulary) for slip in slips]
                found[one.item.printed] = edits
    return found


def _told(one: Misscaled) -> str:
    """What is strange about the scale of a formula, and what would be right."""
    repairs = " or ".join(f"${to_latex(formula)}$" for _, formula in one.repairs)
    lost = f"by the rest ${shown(one.atom)}$ has a dimension, by this it has none"
    return f"{lost}; {AS_THE_REST} {repairs}"
