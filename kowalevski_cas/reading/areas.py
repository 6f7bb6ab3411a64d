r"""The law of areas of a central force: its constant says how the angle turns.

Where words say that a force is central, :math:`l=mr^2\dot\theta` names a constant that the radial
equation has, and nothing else says how :math:`\theta` moves, this is an equation of motion.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation import Name
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
