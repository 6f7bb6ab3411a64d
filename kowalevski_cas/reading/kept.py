r"""Letters for the constant value of what moves: “if :math:`\theta=\theta_0` is constant, then”.

They name it at each point, and suppose nothing. What is printed with them is said of motions that
keep it: its rate vanishes there, and so does that of its rate where the law gives this.
"""

from __future__ import annotations

import re

from kowalevski_cas.notation import Constant, Name
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import LEVEL, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

KEPT = "kept"
"""The kind of the roles of what names such a value."""
_BEHIND = re.compile(
    r"[\s,~]*(?:(?:is|are|being|remains?|stays?|be|is\s+kept)\s+(?:a\s+|also\s+)?)?(?:constant|fixed)\b"
    r"|[\s,~]*(?:остаётся\s+|остается\s+)?(?:постоян|неизмен)\w*",
    re.IGNORECASE,
)
"""How words begin behind what is constant."""
_BEFORE = re.compile(
    r"\b(?:is|be|are|remains?|stays?)\s+(?:constant|fixed)[\s,:~]*$"
    r"|\b(?:constant|fixed|постоянн\w+)\s+(?:(?:angle|radius|inclination|distance|nutation|value|height|length)\s+)?$"
    r"|\b(?:circular|conical|regular|steady|stationary|кругов\w+|коническ\w+|регулярн\w+|стационарн\w+)\s+"
    r"(?:motions?|orbits?|precessions?|rotations?|solutions?|trajector\w+|орбит\w*|движени\w+|прецесси\w+)"
    r"(?:[\s,]+(?:of|with|at|where|has|have|the|a|radius|inclination|angle|on|which|we|one|there|is|радиус\w*|с|где|имеем))*"
    r"[\s,:~]*$",
    re.IGNORECASE,
)
"""How words end before it."""
_CIRCULAR = re.compile(
    r"\b(?:on|for|along|in)\s+(?:(?:an?|the|any|every|each|this|such|all)\s+)?(?:stable\s+)?circular\s+"
    r"(?:orbit|motion|trajector|solution)\w*"
    r"|\b(?:на|для|вдоль|при)\s+(?:\w+\s+)?кругов\w+\s+(?:орбит|движени|траектори)\w*",
    re.IGNORECASE,
)
"""Words for motions on circles, on which the radius is constant."""
_MORE = re.compile(
    r"\b(?:all|any|every|each|general|arbitrary|other)\s+(?:(?!circular)\w+\s+)?(?:orbit|motion|trajector|solution)\w*"
    r"|\b(?:as|like|unlike|only|also|even|both|not|как|не|также|всех)\b",
    re.IGNORECASE,
)
"""Words by which it may be said of other motions, too."""
_RADII = ("r", "\\rho", "R")


def kept(item: SourceStatement, known: Known) -> StatementRole | None:
    """A new letter for what moves where words say that it is constant there."""
    match item.members:
        case (Name(moving), Name(value)) | (Name(moving), Name(value), Constant()):
            constant = len(item.members) == 3
        case _:
            return None
    mentioned = any(value in law.mentions for law in known.laws)
    used = mentioned or value in known.seen or known.is_known(value)
    if used or not _order(moving, known) or cue("deduced", item.lead):
        return None
    if not (constant or _BEHIND.match(item.tail) or _BEFORE.search(item.lead)):
        return None
    why = f"names the constant value {plain(value)} of {plain(moving)}"
    return StatementRole(LEVEL, why, KEPT, (value,))


def kept_before(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """What names a constant value that stands in a statement, in its section and before it."""
    return [
        one
        for one, role in known.roles.items()
        if role.kind == KEPT and one.section is item.section and one.order < item.order
        and {*role.names} & item.names
    ]  # fmt: skip


def constancy(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """The equations by which what a statement has letters for is constant, or its words say so."""
    given = [(one, one.bare[0]) for one in kept_before(item, known)]
    given += [(item, name) for name in _radius_kept(item, known)]
    return [
        unprinted(
            known.paper, f"kept-{one.order}-{item.order}-{k}", f"{dots}=0", one, "is constant"
        )
        for one, name in given
        for k in range(1, _order(name, known) + 1)
        for dots in [rf"\{'d' * k}ot{{{name}}}"]
    ]


def _radius_kept(item: SourceStatement, known: Known) -> list[str]:
    """The radius that is constant where words before a statement speak of circular orbits."""
    names = dict.fromkeys(name for law in known.laws for name in law.variables)
    found = [name for name in names if symbol(name).letter in _RADII]
    said = _CIRCULAR.search(item.before) and not _MORE.search(item.before)
    return found if len(found) == 1 and said else []


def _order(name: str, known: Known) -> int:
    """The highest order of the derivatives of what moves in its law; two at most."""
    rates = (row.rates.get(name, 0) for law in known.laws for row in law.rows)
    return min(max(rates, default=0), 2)
