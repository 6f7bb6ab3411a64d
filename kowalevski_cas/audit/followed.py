"""What does not follow from what stands before it is told: nothing is decided by it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kowalevski_cas.audit.audited import GIVEN, OPEN, Audited
from kowalevski_cas.audit.doubted import AS_FREE, OF_A_PLACE
from kowalevski_cas.notation import to_latex
from kowalevski_cas.reading import CLAIM, Reading
from kowalevski_cas.reading.dimensions import AS_THE_REST
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Correction, Verdict

FROM_BEFORE = "from what stands before it this would follow:"
"""The words for repairs."""
FOLLOWS = "it seems to follow from what stands before it, and is not proved"


def tell_steps(
    found: Sequence[Audited], repairs: Mapping[str, Correction], reading: Reading
) -> None:
    """Doubt what follows with one change only, unless it is decided; not what follows as it is."""
    from kowalevski_cas.reading.definite_integrals import with_integrals  # they load FLINT
    from kowalevski_cas.reading.following import steps

    by_place = {audited.place: audited for audited in found if audited.place is not None}
    unread = {audited.id: audited for audited in found if audited.place is None}
    for known in reading.parts.known:
        at = {
            item: audited
            for item in known.items
            if (audited := by_place.get(item.printed) or unread.get(item.printed.display.id))
        }
        open_ones = {one for one, audited in at.items() if _may_be_wrong(audited)}
        doubted = {one for one, audited in at.items() if _is_doubted(audited)}
        left = {one for one in doubted if not _is_free(at[one], repairs)}
        for one in steps(known, *map(frozenset, (open_ones, doubted, left))):
            audited = at[one.item]
            if one.follows:
                mended = AS_THE_REST in audited.message or {*audited.claims} & repairs.keys()
                if FALSE_AS_READ in audited.message and not mended:
                    audited.verdict, audited.message, audited.causes = OPEN, FOLLOWS, ()
                continue
            shown = " or ".join(f"${to_latex(with_integrals(formula))}$" for formula in one.repairs)
            said = [audited.message] if FALSE_AS_READ in audited.message else [FALSE_AS_READ]
            if audited.message not in said and audited.role != "unread":
                said += filter(None, [audited.message])
            audited.verdict = Verdict.UNDECIDED
            cause = at[one.of or one.item]
            there = "" if cause is audited else f" with this in line {cause.line}:"
            audited.message = "; ".join([*said, f"{FROM_BEFORE}{there} {shown}"])
            audited.causes = (cause.name,)


def _may_be_wrong(audited: Audited) -> bool:
    """Whether nothing is decided of a formula."""
    return audited.verdict in (GIVEN, OPEN, Verdict.UNDECIDED)


def _is_doubted(audited: Audited) -> bool:
    """Whether a formula may be wrong by what is said of it."""
    doubted = audited.verdict == Verdict.UNDECIDED and bool(audited.message)
    if OF_A_PLACE in audited.message:
        return False
    return audited.wrong or (audited.role == CLAIM and doubted) or AS_THE_REST in audited.message


def _is_free(audited: Audited, repairs: Mapping[str, Correction]) -> bool:
    """Whether a doubted formula may well be what gives its letters, of which nothing is known."""
    found = [repairs[id] for id in audited.claims if id in repairs]
    mended = AS_THE_REST in audited.message or any(one.edit is not None for one in found)
    return AS_FREE in audited.message and not mended
