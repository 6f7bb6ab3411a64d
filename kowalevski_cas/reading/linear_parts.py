"""Eigenvalues of linear parts: at which point, and of which law, by the words before them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from kowalevski_cas.notation import Formula, Name, Relation, Vector, to_latex
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.degrees import is_linear
from kowalevski_cas.reading.hypotheses import is_value
from kowalevski_cas.reading.known import CLAIM, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.rest_points import (
    MARKED,
    POINT,
    coordinates,
    entries_of,
    in_marked_letters,
    law_of_points,
    marked,
)
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

KIND, MATRIX, TRACE, DETERMINANT = "eigenvalue", "linear part", "trace", "determinant"
_OF = (
    r"(?:\s+of\s+(?:the\s+)?(?:linear\s+(?:part|system)|lineari[sz]\w+(?:\s+(?:system|equations?))?"
    r"|Jacobian(?:\s+matrix)?)(?:\s+of\s+(?:the\s+)?(?:system|field|equations?)?[\s~]*"
    r"(?:\(?\\(?:eq)?ref\s*\{[^{}]*\}\)?)?)?"
    r"|\s+линейной\s+части|\s+линеаризованн\w+\s+системы)?"
)
_VALUES = (
    r"(?:eigenvalues?|characteristic\s+(?:roots?|exponents?|values?)"
    r"|roots?\s+of\s+(?:the\s+|its\s+)?characteristic\s+(?:equation|polynomial)"
    r"|корн\w+\s+характеристическ\w+\s+(?:уравнени|многочлен|полином)\w+"
    r"|корень\s+характеристическ\w+\s+(?:уравнени|многочлен|полином)\w+"
    rf"|собственн\w+\s+(?:числ\w+|значени\w+)|характеристическ\w+\s+(?:числ|показател|корн)\w+){_OF}"
)
_OF_VALUES = re.compile(
    r"\b(?:sums?|products?|parts?|modul(?:us|i)|absolute\s+values?|squares?|numbers?|signs?|ratios?|differences?"
    r"|multiplicit(?:y|ies)|сумм\w+|произведени\w+|част[ьи]|модул\w+|квадрат\w*|разност\w+|отношени\w+|количеств\w+)"
    rf"\s+(?:of\s+)?(?:(?:the|all|both|its|these|two|three|other)\s+)*(?:\w+\s+)?{_VALUES}",
    re.IGNORECASE,
)
"""Words for what is made of eigenvalues, and is none itself."""
_NOUN = (
    r"(?:equilibri\w+|points?|positions?|states?"
    r"|точ(?:к\w+|ек)|положени\w+|равновеси\w+|состояни\w+)"
)
_KIND_OF = (
    r"(?:the|this|each|of|rest|steady|fixed|interior|trivial|singular|stationary|critical|other"
    rf"|{_NOUN})"
)
_WHERE = r"(?P<where>origin|начал\w\s+координат|§)"
_AT = (
    rf"(?:(?:at|in|в)\s+|(?:for|of|для)\s+(?=(?:{_KIND_OF}[\s~]+)*(?:origin|начал|{_NOUN}[\s~]+§)))"
    rf"(?:{_KIND_OF}[\s~]+)*{_WHERE}(?P<more>(?:[\s~]*(?:,|\band\b|\bи\b)[\s~]*§)*)"
)
_AT_ANY = rf"(?:at|in|for|of|в|для)\s+(?:{_KIND_OF}[\s~]+)*{_WHERE}"
_HERE = (
    r"(?:there|at\s+(?:it|them)|(?:at|in|for|of)\s+(?:this|that|these|those|each\s+of\s+these|such(?:\s+an?)?)\s+(?:\w+\s+)?"
    rf"(?:{_NOUN}|rotations?|motions?)(?:\s+of\s+(?:rest|equilibrium))?"
    rf"|(?:в|для)\s+(?:этой|этом|этих|этого|такой|таком|таких|такого)\s+(?:\w+\s+)?(?:{_NOUN}|вращени\w+|движени\w+))"
)
"""Words for the place that was named before."""
_AND = re.compile(
    r"[\s,]*(?:,|\band|\bor|\bи)\s*(?:at\s+)?(?:the\s+)?(?:points?\s+)?§", re.IGNORECASE
)
_IS = r"(?:are|is|equals?|суть|равны|рав[её]н|равно|[-—–]+)\s*:?"
_MATRIX = (
    r"(?:Jacobian(?:\s+matrix)?|Jacobi\s+matrix|linear\s+part|lineari[sz]ation"
    r"|lineari[sz]ed\s+(?:system|equations?|field)"
    r"|matrix\s+of\s+the\s+(?:linear\s+(?:part|system)|lineari[sz]ation|lineari[sz]ed\s+(?:system|equations?))"
    r"|матриц\w+\s+(?:Якоби|линейной\s+части)|линейн\w+\s+част\w+)"
)
LINEAR_PART = re.compile(rf"\b{_MATRIX}", re.IGNORECASE)
"""Words for the linear part of a law."""
_FIELD = r"(?:\s+of\s+(?:the|this|our)\s+(?:vector\s+)?(?:system|field|flow|equations?))?"
_POINT = r"(?:saddle|node|focus|cent(?:er|re)|spiral|sink|source|equilibrium)(?:\s+point)?"
_SAID = [
    re.compile(said, re.IGNORECASE | re.DOTALL)
    for said in (
        rf"\b{_VALUES}[\s~]*{_AT}[\s~]*{_IS}[\s~]*$",
        rf"\b{_VALUES}.*\bthose\s+{_AT}[\s~]*{_IS}[\s~]*$",
        rf"\b{_VALUES}.*\b{_AT_ANY}[\s~,]*(?:they|они)\s+{_IS}[\s~]*$",
        rf"\b{_AT}[\s~,]*(?:(?:the|its)\s+)?{_VALUES}[\s~]*{_IS}[\s~]*$",
        rf"\b{_MATRIX}[\s~]+{_AT}[\s~,]*(?:has|have|gives?|yields?|имеет|да[её]т)\s+(?:the\s+)?(?:{_VALUES}|exponents|показатели)[\s:~]*$",
        rf"\b{_AT}[\s~,]*(?:we|one)\s+(?:ha(?:ve|s)|gets?|finds?|obtains?)\s+(?:the\s+)?{_VALUES}[\s:~]*$",
        rf"(?P<where>\borigin|§)[\s~,]+(?:is|are)\s+(?:then\s+)?an?\s+(?:\w+\s+){{0,3}}?{_POINT}"
        rf"[\s~,]+with\s+(?:the\s+)?{_VALUES}[\s:~]*$",
        rf"\b(?:(?=origin)|{_NOUN}[\s~]+){_WHERE}[\s~,]+(?:then\s+)?(?:has|имеет)\s+(?:the\s+)?{_VALUES}[\s:~]*$",
    )
]
"""How words end behind which eigenvalues at a point are printed."""
_THERE = re.compile(
    r"\blinear(?:i[sz]ed)?\s+(?:system|part|equations?)\s+(?:there\s+)?ha(?:s|ve)\s+(?:there\s+)?"
    rf"the\s+eigenvalues?[\s:]*$|\b{_VALUES}[\s~]+{_HERE}[\s~]*{_IS}[\s~]*$"
    rf"|\b{_HERE}[\s~,]*(?:(?:the|its)\s+)?(?:non-?zero\s+)?{_VALUES}[\s~]*{_IS}[\s~]*$"
    rf"|\b{_MATRIX}[\s~]+{_HERE}[\s~,]*(?:has|have|имеет)\s+(?:the\s+)?{_VALUES}[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which they are printed for the point before."""
_THEY = re.compile(rf"^\W*{_AT_ANY}[\s~,]*(?:they|они)\s+{_IS}[\s~]*$", re.IGNORECASE)
"""How a sentence begins behind one that prints them for another point."""
_ITS = re.compile(
    r"(?:^|[:;,]|\b(?:and|since|because|as|for|и|так\s+как|поскольку|ибо)\b)\s*"
    rf"(?:(?:one|two|both|all)\s+of\s+)?(?:(?P<its>its|его|е[её])|the)\s+(?:non-?zero\s+)?{_VALUES}\s*{_IS}[\s~]*$",
    re.IGNORECASE,
)
_OF_OTHERS = re.compile(
    r"\b(?:revers|invers|averag|truncat|adjoint|monodromy|обра[щт]|усредн)\w*|\bwithout\b|\bбез\b",
    re.IGNORECASE,
)
"""Words for another system than that of which something was said before."""
_OF_LINEAR = re.compile(
    rf"\b(?:the|its)\s+{_VALUES}\s+{_IS}[\s:~]*$"
    rf"|\b(?:system|equations?|it)(?:[\s,]*§|,?\s+and\b)*,?\s+(?:then\s+)?ha(?:s|ve)\s+(?:the\s+)?{_VALUES}[\s:~]*$"
    rf"|^\s*{_VALUES}\s+{_IS}[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which they are printed for a system that is linear, and so at any point."""
_OF_POINT = re.compile(
    r"\W*(?:(?:for|if|when|при|если)\s+§[\s,]*|(?:\w+,?\s+){0,2}?)(?:the\s+)?(?:(?P<origin>origin|начало\s+координат)|(?:\w+\s+)?(?:point|state|equilibrium"
    r"|точка|положение\s+равновесия|равновесие)[\s~]+(?P<where>§))(?:,[^,§]*,)?"
    r"\s+(?:is|has|exists|loses|becomes|remains|[-—–]+|явля\w+|(?:не)?устойчив\w+)(?!\w)",
    re.IGNORECASE,
)
"""How a sentence begins that speaks of one point, perhaps in the clause before “its”."""
_AT_ORIGIN = re.compile(r"\W*(?:at\s+the\s+origin|в\s+начале\s+координат)\b", re.IGNORECASE)
"""How a sentence begins that speaks of the origin."""
_IS_ORIGIN = re.compile(
    r"\b(?:equilibri\w+|point|state)(?:\s+of\s+\w+)?\s+is\s+(?:at\s+)?the\s+origin\W*$",
    re.IGNORECASE,
)
_OF_MATRIX = re.compile(
    rf"\b{_MATRIX}{_FIELD}(?P<place>[\s~]+(?:{_AT}|there))?[\s~,]*"
    r"(?:is|has\s+the\s+form|reads?|becomes|equals?|имеет\s+вид|равна|есть|[-—–]+)?[\s:,~]*(?:§[\s~=]*)?$",
    re.IGNORECASE,
)
"""How words end behind which the matrix of a linear part is printed."""
_NUMBER_OF_MATRIX = re.compile(
    rf"\b(?:(?P<trace>trace|след)|determinant|определител\w+)(?:(?:\s+of\s+(?:the|this|its))?\s+{_MATRIX}{_FIELD})?"
    rf"(?:[\s~]+(?:{_AT}|there|at\s+this\s+point))?[\s~]*(?:{_IS})?[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which the trace of a matrix is printed, or its determinant."""
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
    text, end = known.paper.expanded.text, item.typed.end
    behind = text.find("}", end) + 1 if text[:end].endswith("{") else end  # words of its display
    if any(not _TIMES.fullmatch(words) for words in _TEXT.findall(text[item.typed.start : behind])):
        return None  # it says in which direction, or when
    point = point_of(item, known)
    if point and not _is_only_named(item, point, known):
        why = "an eigenvalue of the linear part, by the words before it"
        return StatementRole(CLAIM, why, KIND, item.bare[:1] if item.members else ())
    if not point and _is_somewhere(item, known):
        return StatementRole(CLAIM, "an eigenvalue, by the words before it", KIND)
    return None


def _is_somewhere(item: SourceStatement, known: Known) -> bool:
    """Whether words say it to be one where some of what moves has a value, and not all of it."""
    words = before_list(item.before)
    found = next(filter(None, (said.search(words) for said in _SAID)), None)
    if found is None or found["where"] != "§" or _OF_VALUES.search(words) or item.members:
        return False
    typed = [*dict.fromkeys(one.typed.start for one in known.of_sentence(item.sentence))]
    place = words[: found.start("where")].count("§")
    beside = known.of_sentence(item.sentence)
    return any(
        one.typed.start in typed[place : place + 1] and is_value(one, known) for one in beside
    )


def _is_only_named(item: SourceStatement, point: Sequence[SourceStatement], known: Known) -> bool:
    """Whether an eigenvalue is printed by a letter that nothing gives, and its point has not."""
    assert item.formula is not None
    parts = item.formula.members if isinstance(item.formula, Relation) else (item.formula,)
    first = parts[0].names() if len(parts) > 1 and isinstance(parts[0], Name) else set()
    own = item.names - first - {"i", PI} - {name for one in point for name in one.names}
    return any(not known.is_defined(name) and name not in known.later for name in known.untied(own))


def linear_part(item: SourceStatement, known: Known) -> StatementRole | None:
    """A matrix that words call the Jacobian of the law, or its linear part at a point."""
    law, found = law_of_points(item, known), _OF_MATRIX.search(item.before)
    matrix = item.members[-1] if item.members else item.formula
    if law is None or found is None or not isinstance(matrix, Vector) or len(item.members) > 2:
        return None
    if not all(isinstance(row, Vector) for row in matrix.components):
        return None
    varying = known.varying(matrix.names())
    if found["place"] if varying else not matrix_point(item, known):
        return None
    why = "the matrix of the linear part, by the words before it"
    return StatementRole(CLAIM, why, MATRIX, item.bare[:1])


def matrix_point(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the point at which a matrix is said to be the linear part, if one is."""
    law, found = law_of_points(item, known), _OF_MATRIX.search(item.before)
    if law is None or found is None:
        return ()
    if not found["place"]:
        places = [*re.finditer(_AT, item.before, re.IGNORECASE)]
        return _at(places[0], item.before, item, law, known) if len(places) == 1 else ()
    return _at(found, item.before, item, law, known)


def trace_or_determinant(item: SourceStatement, known: Known) -> StatementRole | None:
    """The trace, or the determinant, of a linear part at a point, by the words before it."""
    found = _NUMBER_OF_MATRIX.search(item.before)
    if found is None or item.formula is None or item.derives:
        return None
    if item.members and len(item.members) != 2:
        return None
    if known.varying(item.names) or not point_of_number(item, known):
        return None
    kind = TRACE if found["trace"] else DETERMINANT
    why = f"the {kind} of the linear part, by the words before it"
    return StatementRole(CLAIM, why, kind, item.bare[:1])


def point_of_number(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the one point at which the sentence of a number speaks of a linear part."""
    behind = item.after.partition(";")[0]
    law, words = law_of_points(item, known), f"{item.before} § {behind}"
    places = [*re.finditer(_AT, words, re.IGNORECASE)]
    if law is None or not re.search(rf"\b{_MATRIX}", words, re.IGNORECASE) or len(places) > 1:
        return ()
    if not places:
        other = cue("ideal case", words) or cue("another system", words)
        return () if other else last_named(item, law, known)
    return _at(places[0], words, item, law, known)


def point_of(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the point at which words say that something is an eigenvalue."""
    words, law = before_list(item.before), law_of_points(item, known)
    if law is None or _OF_VALUES.search(words):
        return ()  # they are of something else
    earlier = item.earlier[0] if item.earlier else ""
    found = next(filter(None, (said.search(words) for said in _SAID)), None)
    if found is None and re.search(_VALUES, earlier, re.IGNORECASE):
        found = None if cue("denied", earlier) else _THEY.search(words)
    if found is not None:
        return _at(found, words, item, law, known)
    if _OF_OTHERS.search(words) or any(cue(name, words) for name in ("force", "another system")):
        return ()
    its = _ITS.search(words)
    if its and (own := _of_which(its, words, item, law, known)):
        return own
    if _THERE.search(words):
        if is_of_origin_before(item):
            return _origin(item, law, known)
        return last_named(item, law, known)
    linear = _OF_LINEAR.search(words) and is_linear(law, known)
    return _origin(item, law, known) if linear else ()


def _origin(item: SourceStatement, law: Law, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the origin."""
    return equations_of(dict.fromkeys(law.variables, "0"), item, law, known)


def _of_which(
    its: re.Match[str], words: str, item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of the point of which the clause before “its” speaks, or the sentence."""
    if here := words[: its.start()].strip():
        return _spoken_of(here, item.sentence, item, law, known)
    if not (its["its"] and item.earlier):
        return ()
    before = max(
        (one.sentence for one in known.items if one.sentence < item.sentence), default=None
    )
    return _spoken_of(item.earlier[0], before or item.sentence, item, law, known)


def _spoken_of(
    words: str, sentence: tuple[int, int], item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of the point of which some words of a sentence speak, if it is one alone."""
    of = _OF_POINT.match(words)
    if of is None:
        return ()
    beside = [one for one in known.of_sentence(sentence) if one.order < item.order]
    typed = [*dict.fromkeys(one.typed.start for one in beside)] if "§" in words else []
    place = words[: of.start("where")].count("§") if of["where"] else len(typed)
    lists = (one for one in beside if one.formula is not None and entries_of(one.formula))
    if {one.typed.start for one in lists} & {*typed} - {*typed[place : place + 1]}:
        return ()  # it speaks of another one too
    if of["origin"] or place >= len(typed):
        return _origin(item, law, known) if of["origin"] else ()
    own = [one for one in beside if one.typed.start == typed[place]]
    return point_at(own, item, law, known) or last_named(item, law, known)


def before_list(words: str) -> str:
    """The words before a formula without those that it is listed with."""
    while (cut := _LISTED.sub("", words)) != words:
        words = cut
    return words


def is_of_origin_before(item: SourceStatement) -> bool:
    """Whether something is said of the origin, of which the sentence before speaks."""
    before = item.earlier[0] if item.earlier else ""
    before = before if "§" not in before or _AT_ORIGIN.match(before) else ""
    here = re.search(r"^\s*its\b|\bthere\b|\bat\s+this\s+point\b", item.before, re.IGNORECASE)
    return bool(
        here and (_OF_POINT.match(before) or _IS_ORIGIN.search(before) or _AT_ORIGIN.match(before))
    )


def _at(
    found: re.Match[str], words: str, item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of the point at which some words before a statement say it to be so."""
    if found["where"] is None:
        return last_named(item, law, known)
    if found["where"] != "§":
        return _origin(item, law, known)
    place = words[: found.start("where")].count("§")
    if more := found.groupdict().get("more", "").count("§"):
        return _listed(place, more, item, law, known)
    if _AND.match(words, found.end("where")) and place + 1 < item.before.count("§"):
        return ()  # it is said of several points
    beside = [one for one in known.items if one.sentence == item.sentence]
    typed = [*dict.fromkeys(one.typed.start for one in beside)]
    if place >= len(typed):
        return ()
    own = [one for one in beside if one.typed.start == typed[place]]
    if point := point_at(own, item, law, known):
        return point
    gives = {name for one in own for name in one.bare if known.moves(name)}
    return tuple(own) if gives == {*law.variables} else ()


def _listed(
    place: int, more: int, item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of a point in a list that begins at a place, if they give all that moves."""
    typed = [*dict.fromkeys(one.typed.start for one in known.of_sentence(item.sentence))]
    places = typed[place : place + more + 1]
    own = tuple(one for one in known.of_sentence(item.sentence) if one.typed.start in places)
    return own if gives_all(own, law) and all(is_value(one, known) for one in own) else ()


def point_at(
    own: Sequence[SourceStatement], item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of the point that a formula names, or of which it lists the coordinates."""
    if len(own) == 1 and (named := _named_set(own[0], known)):
        gives = {name for one in named for name in one.bare if known.moves(name)}
        return named if gives >= {*law.variables} else ()
    if len(own) != 1:
        return ()
    return _with_coordinates(_entries_at(own[0], item, law, known), item, law, known)


def _entries_at(
    one: SourceStatement, item: SourceStatement, law: Law, known: Known
) -> tuple[Formula, ...]:
    """The coordinates that a statement before another one lists, or has a name for."""
    if isinstance(one.formula, Name):
        by = known.definition(one.formula.name, item)
        return entries_of(by.members[-1]) if by is not None and len(by.members) == 2 else ()
    for other, role in known.roles.items():
        named = other.members[:1] == (one.formula,) and other.order < item.order
        if named and role.kind == POINT:
            return coordinates(other, law, known, free=True)
    return coordinates(one, law, known, free=True)


def last_named(item: SourceStatement, law: Law, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the last point before a statement, in its paragraph, if it is one alone."""
    points = [
        one
        for one, role in known.roles.items()
        if role.kind in (POINT, MARKED)
        and one.order < item.order and one.paragraph == item.paragraph
    ]  # fmt: skip
    last = [one for one in points if one.sentence == points[-1].sentence]
    behind = (one for one in known.items if last and last[-1].order < one.order < item.order)
    if any(coordinates(one, law, known) for one in behind):
        return ()  # another place is printed since then
    if last and known.roles[last[0]].kind == MARKED:
        return tuple(in_marked_letters(marked(last[0], law, known), item, known))
    if len(last) == 1:
        own = coordinates(last[0], law, known, free=True)
        return _with_coordinates(own, item, law, known)
    before = [
        one
        for one in known.items
        if one.order < item.order and one.paragraph == item.paragraph
        and one.typed.start in known.paper.sets
    ]  # fmt: skip
    named = tuple(one for one in before if one.typed.start == before[-1].typed.start)
    gives = {name for one in named for name in one.bare if known.moves(name)}
    if gives >= {*law.variables}:
        return named
    return values if gives_all(values := last_values(item, known), law) else ()


def last_values(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the point that was printed last before a statement in its paragraph."""
    start = max(item.paragraph, item.section.start)
    before = [
        one
        for one in known.items
        if start <= one.typed.start and one.order < item.order and is_value(one, known)
    ]
    return tuple(one for one in before if one.sentence == before[-1].sentence)


def gives_all(equations: tuple[SourceStatement, ...], law: Law) -> bool:
    """Whether equations give all that moves, each once."""
    given = [name for one in equations for name in one.bare if name in law.variables]
    return sorted(given) == sorted(law.variables)


def _named_set(one: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the set of which a statement is the name."""
    if not isinstance(one.formula, Name):
        return ()
    name = one.typed.tex.strip()
    sets = known.paper.sets
    return tuple(own for own in known.items if sets.get(own.typed.start, "").strip() == name)


def _with_coordinates(
    entries: Sequence[Formula], item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of a point with these coordinates, if they are as many as the variables."""
    if len(entries) != len(law.variables):
        return ()
    values = dict(zip(law.variables, map(to_latex, entries), strict=True))
    return equations_of(values, item, law, known)


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


_ARE_ALL = re.compile(rf"\b(?:the|its|their)\s+{_VALUES}.*\bare\b|^\W*{_VALUES}", re.IGNORECASE)
"""Words for all eigenvalues of a linear part."""


def fewer_eigenvalues(
    items: Sequence[SourceStatement], known_at: Callable[[SourceStatement], Known]
) -> Iterator[tuple[int, int]]:
    """The sentences that list eigenvalues as all that there are, and have fewer than the law."""
    for sentence, many in Counter(item.sentence for item in items).items():
        item = next(one for one in items if one.sentence == sentence)
        law = law_of_points(item, known_at(item))
        if law and many < sum(law.orders.values()) and _ARE_ALL.search(item.words):
            yield sentence
