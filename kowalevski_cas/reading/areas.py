r"""Integrals that say how a coordinate moves, where no other equation does: the law of areas.

Where words say that a force is central, :math:`l=mr^2\dot\theta` names a constant that the radial
equation has, and nothing else says how :math:`\theta` moves, this is an equation of motion. So is
:math:`r^2\dot\varphi=h` beside an equation of the second order in which :math:`\dot\varphi` stands.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation import Derivative, Name
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement

_DENIED = re.compile(
    r"\b(?:not?|never|nor|without|unless|would|were|had|не|нет|без|бы)\b|n't\b", re.IGNORECASE
)
_OTHERWISE = re.compile(
    r"\b(?:transvers\w+|tangential\w*|torques?|magnetic|поперечн\w+|касательн\w+|магнитн\w+)\b"
    r"|\b(?:angular\s+momentum|areas?|момент\w*|площад\w*)\b[^.]*"
    r"\b(?:not|decreas\w+|increas\w+|grows?|chang\w+|var(?:y|ies)|убыва\w+|растет|растёт|мен(?:я|и)\w+)\b",
    re.IGNORECASE,
)
"""Words for what turns otherwise."""


def is_of_areas(row: SourceStatement, rows: Sequence[SourceStatement], paper: SourcePaper) -> bool:
    """Whether a row names the constant of areas of a central force, and another row has it.

    There is no other equation for the angle, nor is it named in one; no words tell of another
    force or deny anything, and nothing is supposed.
    """
    if not row.bare or row.members[0] != Name(row.bare[0]) or len(row.rates) != 1:
        return False
    if not cue("central", row.words) or cue("when", row.words) or _DENIED.search(row.words):
        return False
    defined = {one.bare[0] for one in paper.items if one.bare and not one.rates}
    others = [one for one in rows if one is not row and defined.isdisjoint(one.rates)]
    beside = {name for one in others for name in (*one.names, *one.rates)}
    words = paper.prose.between(row.section.start, row.section.end)
    return (
        row.bare[0] in beside
        and beside.isdisjoint(row.rates)
        and not any(row.bare[0] in one.rates for one in others)
        and not (cue("force", words) or _OTHERWISE.search(words))
    )


def completes_law(
    row: SourceStatement, rows: Sequence[SourceStatement], paper: SourcePaper
) -> bool:
    r"""Whether a row has the value of an integral, linear in a rate that no other row gives.

    That rate stands in rows of the second order for all else that moves in these. The value has a
    letter that nothing defines. Words say that it is constant, or it stands behind what is no bare
    rate in their sentence: :math:`\omega=\dot\varphi` may be any velocity.
    """
    if len(row.bare) != 1 or {*row.rates.values()} != {1} or len(row.rates) != 1:
        return False
    (moving,), (value,) = row.rates, row.bare
    printed = row.implied_by or row
    defined = {name for one in paper.items if one is not printed for name in one.bare}
    others = [one for one in rows if not {*one.bare} and moving in one.rates]
    rated = {name for one in others for name in one.rates} - {moving}
    bare = printed.members[0] == Name(value) or any(isinstance(m, Derivative) for m in row.members)
    beside = not bare and any(one.sentence == row.sentence for one in others)
    constant = printed.is_const
    words = paper.prose.between(row.section.start, row.section.end)
    return (
        bool(rated)
        and len(others) == len(rated)
        and all(one.rates[moving] == 1 and max(one.rates.values()) == 2 for one in others)
        and value not in defined | rated | {moving}
        and not any(value in one.rates for one in rows)
        and (beside or constant or any(cue(name, row.words) for name in ("integral", "a constant")))
        and not (cue("when", row.words) or _DENIED.search(row.words))
        and not (cue("force", words) or _OTHERWISE.search(words))
    )
