"""Eigenvalues of linear parts: at which point, and of which law, by the words before them."""

from __future__ import annotations

import re

from kowalevski_cas.notation import Formula, Name, Product, Vector, times, to_latex
from kowalevski_cas.reading.known import CLAIM, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

KIND = "eigenvalue"
_OF = (
    r"(?:\s+of\s+(?:the\s+)?(?:linear\s+(?:part|system)|lineari[sz]\w+(?:\s+(?:system|equations?))?"
    r"|Jacobian(?:\s+matrix)?)(?:\s+of\s+(?:the\s+)?(?:system|field|equations?)?[\s~]*"
    r"(?:\(?\\(?:eq)?ref\s*\{[^{}]*\}\)?)?)?"
    r"|\s+линейной\s+части|\s+линеаризованн\w+\s+системы)?"
)
_VALUES = (
    r"(?:eigenvalues?|characteristic\s+(?:roots?|exponents?)"
    rf"|собственн\w+\s+(?:числ\w+|значени\w+)){_OF}"
)
_AT = r"(?:at|in|в)\s+(?:the\s+)?(?:point\s+|точке\s+)?(?P<where>origin|начале\s+координат|§)"
_IS = r"(?:are|is|equal|суть|равны|[-—–]+)\s*:?"
_SAID = re.compile(
    rf"\b{_VALUES}[\s~]*{_AT}[\s~]*{_IS}[\s~]*$"
    rf"|\b{_VALUES}.*\bthose\s+{_AT.replace('where', 'there')}[\s~]*{_IS}[\s~]*$",
    re.IGNORECASE | re.DOTALL,
)
"""How words end behind which eigenvalues at a point are printed."""
_THERE = re.compile(
    r"\blinear(?:i[sz]ed)?\s+(?:system|part|equations?)\s+(?:there\s+)?ha(?:s|ve)\s+(?:there\s+)?"
    r"the\s+eigenvalues?[\s:]*$",
    re.IGNORECASE,
)
"""How words end behind which they are printed for the point before."""
_LISTED = re.compile(r"§(?:[\s,;~]|\b(?:and|или|и)\b)*$")
_TEXT = re.compile(r"\\(?:text|mbox|textrm)\s*\{([^{}]*)\}")
_TIMES = re.compile(
    r"\W*(?:and|twice|double|simple|triple|once|(?:two|three|four)\s+times|и)?\W*", re.IGNORECASE
)


def eigenvalue(item: SourceStatement, known: Known) -> StatementRole | None:
    """What words call an eigenvalue at a point of which all coordinates are known."""
    if item.formula is None or item.derives or len(item.members) not in (0, 2):
        return None
    if item.members and not isinstance(item.members[0], Name):
        return None
    printed = known.paper.expanded.text[item.typed.start : item.typed.end]
    if any(not _TIMES.fullmatch(words) for words in _TEXT.findall(printed)):
        return None  # it says in which direction, or when
    if point_of(item, known):
        why = "an eigenvalue of the linear part, by the words before it"
        return StatementRole(CLAIM, why, KIND, item.bare[:1] if item.members else ())
    return None


def point_of(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the point at which words say that something is an eigenvalue."""
    words = item.before
    while (cut := _LISTED.sub("", words)) != words:
        words = cut
    found = _SAID.search(words)
    laws = [law for law in known.laws if law.order < item.order and not (law.images or law.base)]
    if len(laws) != 1:
        return ()
    if found is None:
        return _last_named(item, laws[0], known) if _THERE.search(words) else ()
    where = found["where"] or found["there"]
    law = laws[0]
    if where != "§":
        zeros = dict.fromkeys(law.variables, "0")
        return equations_of(zeros, item, law, known)
    place = words[: found.start("where") if found["where"] else found.start("there")].count("§")
    beside = [one for one in known.items if one.sentence == item.sentence]
    typed = [*dict.fromkeys(one.typed.start for one in beside)]
    if place >= len(typed):
        return ()
    own = [one for one in beside if one.typed.start == typed[place]]
    if len(own) == 1 and isinstance(own[0].formula, Name):
        return _named(own[0], item, law, known)
    gives = {name for one in own for name in one.bare if known.moves(name)}
    return tuple(own) if gives == {*law.variables} else ()


def _last_named(item: SourceStatement, law: Law, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the last point with a name before a statement, in its paragraph."""
    before = [
        one
        for one in known.items
        if one.order < item.order and one.paragraph == item.paragraph
        and one.typed.start in known.paper.sets
    ]  # fmt: skip
    own = tuple(one for one in before if one.typed.start == before[-1].typed.start)
    gives = {name for one in own for name in one.bare if known.moves(name)}
    return own if gives >= {*law.variables} else ()


def _named(
    own: SourceStatement, item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of a set with a name, or of the point that a list of coordinates gives."""
    assert isinstance(own.formula, Name)
    named = [
        one
        for one in known.items
        if known.paper.sets.get(one.typed.start, "").strip() == own.typed.tex.strip()
    ]
    if named:
        gives = {name for one in named for name in one.bare if known.moves(name)}
        return tuple(named) if gives >= {*law.variables} else ()
    by = known.definition(own.formula.name, item)
    entries = _entries(by.members[-1]) if by is not None and len(by.members) == 2 else ()
    if len(entries) != len(law.variables):
        return ()
    values = dict(zip(law.variables, map(to_latex, entries), strict=True))
    return equations_of(values, item, law, known)


def _entries(formula: Formula) -> tuple[Formula, ...]:
    """The coordinates in a list, perhaps with a factor before it."""
    match formula:
        case Vector(entries):
            return tuple(entries)
        case Product(factors) if isinstance(factors[-1], Vector):
            return tuple(times(*factors[:-1], one) for one in factors[-1].components)
    return ()


def equations_of(
    values: dict[str, str], item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of a point with these coordinates, which the paper does not print."""
    return tuple(
        unprinted(
            known.paper,
            f"at-{number}-{item.order}",
            f"{name}={value}",
            law.first,
            "the point of which the words speak",
        )
        for number, (name, value) in enumerate(values.items(), 1)
    )
