r"""Points of rest as papers print them: :math:`(1,0)`, :math:`E_1=(1,0)`, :math:`x^*=1,\\ y^*=0`.

Coordinates stand in the order in which the law gives the rates of what moves. Letters with a mark
are those of what moves at the point.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Set

from kowalevski_cas.notation import Formula, Name, Product, Vector, times
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

POINT, MARKED = "rest point", "rest in marked letters"
"""The kinds of these claims."""

_REST = (
    r"(?:equilibri(?:um|a)(?:\s+(?:points?|positions?|states?|solutions?))?"
    r"|(?:states?|points?|positions?)\s+of\s+(?:rest|equilibrium)"
    r"|(?:rest|singular|stationary|fixed|critical|coexistence)\s+points?"
    r"|(?:points?|states?)\s+of\s+coexistence|(?:steady|stationary|endemic)\s+states?)"
)
_RUSSIAN = (
    r"(?:положени\w+\s+равновесия|состояни\w+\s+(?:покоя|равновесия)|равновеси\w+"
    r"|(?:особ|неподвижн|стационарн)\w+\s+точк\w*|точк\w+\s+(?:покоя|равновесия))"
)
_OF = (
    r"(?:\s+of\s+(?:the|this|our)\s+\w+|\s+(?:этой\s+)?системы)?"
    r"(?:(?:\s+of)?[\s~]*\(?\\(?:eq)?ref\s*\{[^{}]*\}\)?)?"
)
FAMILY = r"(?:lines?|curves?|circles?|famil(?:y|ies)|прям\w+|крив\w+|окружност\w+|семейств\w+)"
"""Words for many points of rest together."""
_IS = (
    r"(?:[\s,~—-]*(?:is|are|at|in|by|given|has|have|with|the|coordinates?|points?|namely|lies?|located"
    r"|occurs?|exists?|reads?|there|form|fill|make\s+up|consist\s+of|fall\s+into|an?|one|two|three|four|following|of"
    rf"|{FAMILY}|суть|это|есть|является|являются|имеет|координаты|точк\w+|образуют|составляют|дв[ае]|три|следующ\w+))*[\s:,~—-]*"
)
_BEFORE = re.compile(rf"\b(?:{_REST}|{_RUSSIAN}){_OF}(?:[\s~]*§)?{_IS}$", re.IGNORECASE)
"""How words end behind which points of rest are printed."""
_BEHIND = re.compile(
    rf"[\s,~]*(?:is|are)\s+(?:then\s+|also\s+)?(?:the\s+|an?\s+)?(?:\w+\s+){{0,2}}?{_REST}\b"
    rf"|[\s,~]*(?:—|-{{2,3}}|есть|явля[ею]тся)\s*(?:\w+\s+)?{_RUSSIAN}",
    re.IGNORECASE,
)
"""What says of the points before it that nothing moves there."""
_ALSO = re.compile(
    r"\bthere\s+(?:is|are|exists?)\b(?:\s+(?:also|then|besides|moreover)\b)?[\s~]*(?:(?:an?|one|two|three|four|other|others|another"
    r"|further|more|ones?|points?)\b[\s~]*)*[\s:,~]*$",
    re.IGNORECASE,
)
"""How words end behind which there is more of that of which the sentence before speaks."""
_SPOKEN = re.compile(rf"\b(?:{_REST}|{_RUSSIAN})", re.IGNORECASE)
_NO = re.compile(r"\b(?:no|not|never|neither|нет|не)\s+(?:\w+\s+){0,2}$", re.IGNORECASE)
_ORDERS = (
    ("x", "y", "z"), ("u", "v", "w"), (r"\alpha", r"\beta", r"\gamma"), (r"\xi", r"\eta", r"\zeta"),
)  # fmt: skip
"""Letters of coordinates in their usual order."""
_AND = r"(?:[\s,;~]|\b(?:and|or|и|или|as\s+well\s+as)\b)*"
_MORE = (
    r"(?:(?:for|if|when|при)\s+§[\s,~]*)?(?:the\s+)?(?:(?:other|further)\s+)?"
    r"(?:two|three|four|две|три|четыре)\s+(?:(?:other|further)\s+)?(?:points?|ones|точки)[\s:,~]*"
)
_LIST_BEFORE = re.compile(
    rf"(?:{_AND}(?:{_MORE})?(?:§|\bthe\s+origin\b|\bначало\s+координат))+{_AND}(?:{_MORE})?$",
    re.IGNORECASE,
)
_LIST_BEHIND = re.compile(rf"(?:{_AND}§)*")

_ARBITRARY = r"(?:arbitrary|any|every|each|all|произвольн\w+|люб\w+|всех|кажд\w+)"
_FAMILY_BEFORE = re.compile(
    rf"\b{_ARBITRARY}\s+(?:point|state|точк\w+|состояни\w+)[\s~]*$|\b(?:points|states|точки|состояния)[\s~]*$"
    rf"|\b{FAMILY}\s+(?:of\s+)?(?:{_REST}|{_RUSSIAN})[\s:,~]*$|\b{FAMILY}(?:\s+of\s+points)?[\s:,~]*$"
    rf"|\b{_ARBITRARY}\s+(?:\w+\s+)?§[\s,~]*(?:(?:the|точка)\s+)?(?:point|state)?[\s~]*$",
    re.IGNORECASE,
)
FAMILY_BEHIND = re.compile(
    rf"[\s,~]*(?:with|for|where|при|где)\s+(?:an?\s+)?(?:{_ARBITRARY}\s+(?:\w+\s+)?§"
    rf"|§(?:[\s,~]*(?:(?:and|и)\s+)?§)*[\s~]*(?:is|are|being|[-—–]+)[\s~]*(?:an?\s+)?(?:{_ARBITRARY}|(?:free\s+)?parameter|параметр))",
    re.IGNORECASE,
)
"""How words end before a point with a free letter, or begin behind it, that speak of them all."""


_ANY_NUMBER = re.compile(r"\\in\s*\\(?:mathbb|mathbf|Bbb)\s*\{?\s*R")
"""What says of a letter that it is any real number."""


def rest_point(item: SourceStatement, known: Known) -> StatementRole | None:
    """A point where nothing moves, by words right before it or its list, or right behind."""
    law = law_of_points(item, known)
    if law is None or cue("map", item.words) or not says_rest(item):
        return None
    if coordinates(item, law, known, free=is_of_family(item)):
        names = item.bare[:1]
        return StatementRole(CLAIM, "the words beside it call it a point of rest", POINT, names)
    if marked(item, law, known):
        why = "the words before it call it a point of rest"
        return StatementRole(CLAIM, why, MARKED, item.bare[:1])
    return None


_OTHER_ONE = re.compile(
    r"\b(?:first|former|original|initial|both|each)\b|\b(?:перв|исходн|об[ае]|кажд)\w*"
    r"|\btwo\s+(?:\w+\s+)?(?:systems|equations|laws|cases|problems|flows|models)\b",
    re.IGNORECASE,
)
"""Words for another system than the last one."""


def law_of_points(item: SourceStatement, known: Known) -> Law | None:
    """The one law of which points are spoken of before a statement, that is not one of a map.

    Equations that move what no other one has are one law with those of their sentence; in another
    one they are a system apart, of which is spoken behind them.
    """
    before = [law for law in known.laws if law.order < item.order and not law.images]
    laws = [law for law in before if not law.base]
    if len(laws) != 1:
        return None
    beside = [o for o in before if o.base and o.first.sentence == laws[0].first.sentence]
    if apart := [law for law in before if law.is_apart and law not in beside]:
        return None if _OTHER_ONE.search(item.words) else apart[-1].own
    return beside[-1] if beside and not beside[-1].change else laws[0]


def says_rest(item: SourceStatement) -> bool:
    """Whether words call the list of points, or of coordinates, in which a statement stands so."""
    before = _LIST_BEFORE.sub("", item.before)
    if said := _BEFORE.search(before):
        return not _NO.search(before, 0, said.start())
    if says_more_rest(item):
        return True
    list_behind = FAMILY_BEHIND.match(item.after) or _LIST_BEHIND.match(item.after)
    return bool(_BEHIND.match(item.after, list_behind.end() if list_behind else 0))


def says_more_rest(item: SourceStatement) -> bool:
    """Whether there are more points by words before a list, and the sentence before has some."""
    more = _ALSO.search(_LIST_BEFORE.sub("", item.before)) and item.earlier
    return bool(more and _SPOKEN.search(item.earlier[0]) and not cue("denied", item.earlier[0]))


def is_of_family(item: SourceStatement) -> bool:
    """Whether words say of all points that something is so, which a letter tells apart."""
    behind = _LIST_BEHIND.match(item.after)
    return bool(
        _FAMILY_BEFORE.search(_LIST_BEFORE.sub("", item.before))
        or FAMILY_BEHIND.match(item.after)
        or FAMILY_BEHIND.match(item.after, behind.end() if behind else 0)
        or _ANY_NUMBER.search(item.typed.tex)
    )


def is_membership(item: SourceStatement) -> bool:
    """Whether a statement says of a letter that it is any real number."""
    return _ANY_NUMBER.search(item.printed.tex) is not None


def coordinates(
    item: SourceStatement, law: Law, known: Known, *, free: bool = False
) -> tuple[Formula, ...]:
    """The coordinates of the point that a statement is, or gives a name; none if it is no point.

    Where letters may be ``free``, it is one of a family of points.
    """
    if item.formula is None or len(item.members) not in (0, 2):
        return ()
    if item.members and not (isinstance(item.members[0], Name) or _is_marked_point(item, law)):
        return ()
    found = entries_of(item.members[-1] if item.members else item.formula)
    names = {name for one in found for name in one.names()}
    new = {name for name in names - {PI} if not known.is_defined(name) and known.untied([name])}
    explained = not new or (free and len(new) < len(found) and not any(_tying(new, known)))
    whole = len(found) == len(law.variables) and not known.varying(names)
    return found if whole and explained and _is_in_order(law, known) else ()


def _tying(names: Set[str], known: Known) -> Iterator[SourceStatement]:
    """The equations that say of letters which values they have: they give no other one, or rate.

    So does what a characteristic equation says of an eigenvalue.
    """
    for one in known.items:
        first = one.members[0] if names & one.names and one.members and not one.derives else None
        if first is None or (isinstance(first, Name) and first.name not in names):
            continue
        others = known.untied(one.names - names)
        if all(known.is_defined(name) or known.moves(name) for name in others):
            yield one


def _is_in_order(law: Law, known: Known) -> bool:
    """Whether it is known in which order coordinates stand.

    A list of what moves says so; x, y, z and the like stand in this order, one letter with indices
    in theirs.
    """
    names = tuple(map(Name, law.variables))
    if any(entries_of(one.formula) == names for one in known.items if one.formula is not None):
        return True
    letters = [symbol(name).letter for name in law.variables]
    for usual in _ORDERS:
        if {*letters} <= {*usual} and len({*letters}) == len(letters):
            return letters == sorted(letters, key=usual.index)
    return len({*letters}) > 1 or [*law.variables] == sorted(law.variables)


def entries_of(formula: Formula) -> tuple[Formula, ...]:
    """The coordinates in a list, perhaps with a factor before it."""
    match formula:
        case Vector(entries):
            return tuple(entries)
        case Product(factors) if isinstance(factors[-1], Vector):
            return tuple(times(*factors[:-1], one) for one in factors[-1].components)
    return ()


def marked(item: SourceStatement, law: Law, known: Known) -> dict[str, str]:
    """What moves by law, each with the letter for it at the point that a statement gives in part.

    All are given in the sentence, and marked alike.
    """
    found: dict[str, str] = {}
    mark = ""
    for one in known.paper.items:
        if one.sentence != item.sentence or not one.members or one.derives:
            continue
        first = one.members[0]
        if not isinstance(first, Name) or known.varying(one.names):
            continue
        for name in law.variables:
            own = mark_of(first.name, name)
            if own and (not mark or own == mark):
                mark = own
                found.setdefault(name, first.name)
    whole = {*found} == {*law.variables} and item.bare[:1] and item.bare[0] in found.values()
    return found if whole else {}


def _is_marked_point(item: SourceStatement, law: Law) -> bool:
    """Whether a statement gives a list of what moves by law in its order, all marked alike."""
    names = [one.name for one in entries_of(item.members[0]) if isinstance(one, Name)]
    if len(names) != len(law.variables):
        return False
    marks = {mark_of(*two) for two in zip(names, law.variables, strict=True)}
    return len(marks) == 1 and "" not in marks


def mark_of(name: str, variable: str) -> str:
    """What is printed at a letter beside that of what moves: a star, an index, an accent."""
    one, other = symbol(name), symbol(variable)
    if (one.letter, one.font) != (other.letter, other.font) or one == other:
        return ""
    raised = one.raised if one.raised != other.raised else ""
    accents = "".join(one.accents) if one.accents != other.accents else ""
    index = one.index.removeprefix(other.index).strip(",") if one.index != other.index else ""
    return f"{raised}|{accents}|{index}"


def in_marked_letters(
    found: dict[str, str], item: SourceStatement, known: Known
) -> Iterator[SourceStatement]:
    """The equations by which what moves is what marked letters stand for."""
    for name, letter in found.items():
        id = f"at-rest-{item.order}-{letter}"
        yield unprinted(known.paper, id, f"{name}={letter}", item, "the point of which words speak")
