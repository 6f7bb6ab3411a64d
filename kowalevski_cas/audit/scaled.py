"""What scales as nothing else in a source does is told: nothing is decided by it."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.audit.audited import GIVEN, OPEN, Audited
from kowalevski_cas.notation import to_latex
from kowalevski_cas.reading import Reading
from kowalevski_cas.reading.dimensions import AS_THE_REST, Misscaled, misscaled, shown
from kowalevski_cas.verify.outcome import Verdict


def tell_scales(found: Sequence[Audited], reading: Reading) -> None:
    """Doubt what scales as nothing else does, unless it is proved or refuted as it stands."""
    by_place = {audited.place: audited for audited in found if audited.place is not None}
    unread = {audited.id: audited for audited in found if audited.place is None}
    for known in reading.parts.known:
        for one in misscaled(known):
            place = one.item.printed
            audited = by_place.get(place) or unread.get(place.display.id)
            if audited is not None and audited.verdict in (GIVEN, OPEN, Verdict.UNDECIDED):
                audited.verdict = Verdict.UNDECIDED
                audited.message = "; ".join(filter(None, (audited.message, _told(one))))
                audited.causes = (audited.name,)


def _told(one: Misscaled) -> str:
    """What is strange about the scale of a formula, and what would be right."""
    repairs = " or ".join(f"${to_latex(formula)}$" for formula in one.repairs)
    return f"by the rest ${shown(one.atom)}$ has a dimension, by this it has none; {AS_THE_REST} {repairs}"
