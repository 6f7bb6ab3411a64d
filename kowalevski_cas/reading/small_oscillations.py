"""Characteristic equations and frequencies of small oscillations: of which law, and near what.

They are read where the place is said: in the sentence, or last before it in its paragraph. A law
that is linear has the origin.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Derivative, Formula, Name, Number, Power, Vector
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.degrees import degrees, is_linear
from kowalevski_cas.reading.hypotheses import is_value
from kowalevski_cas.reading.known import CLAIM, NOTATION, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.linear_parts import (
    DETERMINANT,
    KIND,
    LINEAR_PART,
    MATRIX,
    TRACE,
    before_list,
    equations_of,
    gives_all,
    is_of_origin_before,
    last_named,
    point_at,
)
from kowalevski_cas.reading.rest_points import law_of_points
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.tried import exponential, variable_of

FREQUENCY, CHARACTERISTIC = "frequency", "characteristic"
"""The kinds of these claims."""
OF_LINEAR_PART = (KIND, MATRIX, TRACE, DETERMINANT, FREQUENCY, CHARACTERISTIC)
"""The kinds of what is claimed of a linear part, at a point that the words tell."""

_SMALL = (
    r"(?:small|infinitesimal|normal)\s+(?:\w+\s+)?(?:oscillations?|vibrations?|modes?|motions|ones)"
    r"|мал\w+\s+колебани\w+"
)
_FREQUENCY = (
    r"(?P<squares>(?:squares?\s+of\s+the\s+|квадрат\w*\s+)?)"
    r"(?:(?:angular|circular|cyclic|common|natural|круговой|круговую|циклическ\w+)\s+)?"
    r"(?:frequenc(?:y|ies)|wave\s*numbers?|частот\w*|волнов\w+\s+чис\w+)(?:[\s~]+§)?"
)
_PERIOD = r"(?P<squares>)(?:periods?|период\w*)(?:[\s~]+§)?"
_PLACE = (
    r"(?:[\s~]+§)?(?:[\s~]+of\s+(?:the|this|our)\s+\w+)?"
    r"(?:[\s~]+(?:about|around|near|at|in|вблизи|около|возле|в|у)\b[^.;]*)?"
)
_IS = (
    r"(?:is|are|equals?|(?:is|are)\s+(?:given|determined)\s+by(?:\s+the\s+(?:formula|equation|expression|relation))?"
    r"|(?:определя|да)[её]тся(?:\s+(?:формул|равенств|выражени|соотношени)\w+)?|рав(?:ен|н\w+)|есть|суть|[-—–]+)?"
    r"(?:[\s,~]*(?:then|therefore|thus|hence|поэтому|тогда)\b)?[\s:,~]*(?:§[\s,~]*(?:where|with|где)[\s~]*)?$"
)


def _of_small(noun: str) -> re.Pattern[str]:
    """How words end behind which frequencies, or periods, of small oscillations are printed."""
    return re.compile(
        rf"\b{noun}\s+(?:of\s+)?(?:the\s+)?(?:{_SMALL}){_PLACE}[\s~]*{_IS}"
        rf"|\bnormal\s+{noun.replace('squares', 'squares_normal')}[\s~]*{_IS}"
        rf"|\b(?:{_SMALL}){_PLACE}[\s~]+(?:then\s+)?(?:have|has|with|име\w+)\s+(?:then\s+)?(?:the\s+)?"
        rf"{noun.replace('squares', 'squares_behind')}[\s:~]*$",
        re.IGNORECASE,
    )


_OF_SMALL, _PERIOD_OF_SMALL = _of_small(_FREQUENCY), _of_small(_PERIOD)
_OF_EQUATION = re.compile(
    rf"\b{_FREQUENCY}(?:[\s~]+of\s+(?:(?:the|these|this|such|its)\s+)?(?:oscillations?|vibrations?))?[\s~]*{_IS}",
    re.IGNORECASE,
)
"""How words end behind which frequencies are printed, perhaps of the equation before them."""
_EQUATION = re.compile(
    r"\b(?:characteristic|secular|frequency)\s+(?:equation|polynomial)s?\b(?P<rest>[^.;]*)$"
    r"|\b(?:характеристическ\w+|веков\w+|частотн\w+)\s+(?:уравнени|многочлен|полином)\w*(?P<other>[^.;]*)$"
    r"|\beigenvalues?\b(?P<values>[^.;]*)\b(?:satisfy|obey|solve|are\s+(?:the\s+)?(?:roots|solutions)\s+of)\b[^.;]*$"
    r"|\bсобственн\w+\s+(?:числ|значени)\w+(?P<numbers>[^.;]*)\b(?:удовлетворяют|(?:—|являются|суть)\s+корн\w+)[^.;]*$",
    re.IGNORECASE,
)
"""How words end behind which a characteristic equation is printed."""
_READS = re.compile(
    r"\s*(?:is|reads?|becomes|(?:has|takes)\s+the\s+form|§|[-—–]+|имеет\s+вид)?[\s:~]*",
    re.IGNORECASE,
)
"""Words between a characteristic equation and its name: its roots are something else."""
_SECULAR = re.compile(
    r"\b(?:secular|frequenc\w+|веков\w+|частот\w*)\b|\b(?:imaginary|мним\w+)\b", re.IGNORECASE
)
"""Words for equations that are often printed for squares of frequencies."""
_OF_FREQUENCIES = (r"\omega", r"\Omega", r"\nu", r"\sigma")
"""The usual letters of frequencies."""
_OF_MATRIX = re.compile(
    r"\b(?:matri(?:x|ces)|operator|tensor|pencil|матриц\w+|оператор\w*|тензор\w*)\b|\bof[\s~]+§",
    re.IGNORECASE,
)
"""Words for that of which it is the characteristic equation, if that is no law of motion."""
_WHERE = re.compile(
    r"\b(?:about|around|near|at|вблизи|около|возле|neighbou?rhood\s+of|окрестност\w+|в(?=\s+(?:точке|начале)))\s+"
    r"(?:(?:the|this|each\s+of\s+the|its|точк\w+|положени\w+|равновеси\w+|points?|equilibri\w+"
    r"|positions?|states?|of\s+(?:equilibrium|rest))[\s~]+)*(?P<where>origin|начал\w+\s+координат|§)",
    re.IGNORECASE,
)
"""Where something is said to be so."""
_WHERE_BEHIND = re.compile(rf"[\s~]*{_WHERE.pattern}", re.IGNORECASE)
_COMPARED = re.compile(
    r"\bwithout\b(?!\s+loss)|\babsen\w+|\bбез\b|\bотсутств\w+|\brevers\w+|\btwice\b|\b(?:times|half)\s+(?:as|the)\b|\bthan\b|обра(?:щ|т)\w+|\b(?:вдвое|чем)\b",
    re.IGNORECASE,
)
"""Words that compare a system with another one."""
_BECOMES = re.compile(r"\b(?:becomes?|становится)(?=[\s:~]*(?:§|$))", re.IGNORECASE)
_JOINED = re.compile(r"(?:[\s,;~]|\b(?:and|и)\b)*")
_SMALL_ANGLES = re.compile(r"\bsmall\s+angles\b|\bмал\w+\s+угл\w+", re.IGNORECASE)


def small_oscillation(item: SourceStatement, known: Known) -> StatementRole | None:
    """A frequency of small oscillations, or a characteristic equation, at a point that is said."""
    if item.formula is None or item.derives or known.varying(item.names):
        return None
    equation = equation_of_root(item, known)
    if equation is not None and not may_be_of_frequencies(equation, known):
        if not isinstance(item.members[0], Name):
            return None
        return StatementRole(CLAIM, "a root of the characteristic equation before it", KIND)
    found = frequency(item, known) or characteristic(item, known)
    if found and (places_of(item, known) or linear_before(item, known)):
        kind, name, said = found
        why = f"{said} of the linear part, by the words before it"
        return StatementRole(CLAIM, why, kind, (name,) if kind == FREQUENCY and name else ())
    return None


def frequency(item: SourceStatement, known: Known) -> tuple[str, str, str] | None:
    """The name of a frequency of small oscillations, if a statement prints one; no number of them.

    With the number π it may count oscillations in a unit of time, if no words call it a period. A
    name that has been used for something is not given by it.
    """
    if len(item.members) not in (0, 2):
        return None
    if is_period(item):
        given = item.bare[0] if item.bare else ""
        fresh = not given or _is_named_only(given, item, known)
        return (FREQUENCY, given, "a period") if fresh else None
    if PI in item.names:
        return None
    equation = equation_of_root(item, known)
    is_root = equation is not None and may_be_of_frequencies(equation, known)
    if not (_frequencies_before(item) or is_root or is_of_equation(item, known)):
        return None
    match item.members[:1]:
        case () if not isinstance(item.formula, Name) or known.is_known(item.formula.name):
            return FREQUENCY, "", "a frequency"
        case (Name(name),) if is_root or _is_named_only(name, item, known):
            return FREQUENCY, "" if is_root else name, "a frequency"
        case (Power(Name(name), Number(2)),) if is_root or _is_named_only(name, item, known):
            return FREQUENCY, "" if is_root else name, "the square of a frequency"
    return None


def is_period(item: SourceStatement) -> bool:
    """Whether words call a number with π the period of small oscillations."""
    return PI in item.names and _PERIOD_OF_SMALL.search(before_list(item.before)) is not None


def _is_named_only(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether nothing is known of a name, but that the sentence prints it as one before."""
    first = known.seen.get(name)
    if first is None or known.is_defined(name) or known.moves(name):
        return not known.is_known(name)
    return first.sentence == item.sentence and known.roles[first].name == NOTATION


_ROOTS = re.compile(
    r"\broots(?:\s+of\s+(?:it|which|this\s+equation))?\s*(?:are|:)?[\s:~]*$|\b(?:hence|whence|so\s+that)[\s,~]*$"
    r"|\bкорни(?:\s+(?:его|которого))?\s*(?:суть|[-—–]+|равны)?[\s:~]*$|\b(?:откуда|отсюда)[\s,~]*$",
    re.IGNORECASE,
)
"""How words end behind which the roots of an equation are printed."""


def equation_of_root(item: SourceStatement, known: Known) -> SourceStatement | None:
    """The characteristic equation before a statement of which that prints a root.

    A display prints one of what the equation is for, unless words suppose it; inline words say so.
    """
    said = _ROOTS.search(before_list(item.before))
    if len(item.members) != 2 or not (said or not (item.typed.inline or cue("when", item.lead))):
        return None
    if not isinstance(item.members[0], Name | Power) or not item.members[0].names():
        return None
    letters = {symbol(name).letter for name in item.members[0].names()}
    before = (one for one in known.items if one.order < item.order)
    equations = [
        one
        for one in before
        if one.paragraph == item.paragraph and known.roles[one].kind == CHARACTERISTIC
    ]
    if not equations or letters != {symbol(variable_of(equations[-1], known)).letter}:
        return None
    return equations[-1]


def _frequencies_before(item: SourceStatement) -> re.Match[str] | None:
    """The words before a statement, or its list, that call it a frequency."""
    return _OF_SMALL.search(before_list(item.before))


def is_of_equation(item: SourceStatement, known: Known) -> bool:
    """Whether words only call it a frequency, behind linear equations of which it may be one.

    A letter alone is only named so.
    """
    named = isinstance(item.formula, Name) or _frequencies_before(item)
    said = not named and _OF_EQUATION.search(before_list(item.before))
    return bool(said) and bool(linear_before(item, known))


def is_damped(row: SourceStatement) -> bool:
    """Whether a rate stands beside an acceleration: oscillations may be damped."""
    rates = [node.argument for member in row.members for node in _derivatives(member)]
    return len({*map(type, rates)}) > 1


def _derivatives(formula: Formula) -> Iterator[Derivative]:
    """The derivatives in a formula that are derived no more."""
    if isinstance(formula, Derivative):
        yield formula
        return
    for child in formula.children():
        yield from _derivatives(child)


def linear_before(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The last equations with rates before a statement in its paragraph, if they are linear.

    They say how all moves that stands in them, and it moves by a law.
    """
    before = [
        one
        for one in known.items
        if one.paragraph == item.paragraph and one.order < item.order and one.rates
    ]
    rows = tuple(one for one in before if one.typed is before[-1].typed)
    moving = {name for one in rows for name in one.rates}
    closed = all(
        one.members
        and {*known.varying(one.names)} <= moving
        and all(degrees(member, known) <= {1} for member in one.members)
        for one in rows
    )
    return rows if closed and len(rows) == len(moving) and all(map(known.moves, moving)) else ()


def prints_square(item: SourceStatement) -> bool:
    """Whether it is the square of a frequency that a statement prints."""
    said = before_list(item.before)
    found = _OF_SMALL.search(said) or _OF_EQUATION.search(said)
    squares = found is not None and any(found.groupdict().values())
    return isinstance(item.members[0], Power) if item.members else squares


def characteristic(item: SourceStatement, known: Known) -> tuple[str, str, str] | None:
    """The variable of a characteristic equation, if a statement prints one, and no root of it."""
    variable = variable_of(item, known)
    said = _EQUATION.search(item.before)
    is_root = Name(variable) in (item.formula, *item.members)
    if Power(Name(variable), Number(2)) in item.members and Number(0) not in item.members:
        is_root = said is None or not any(map(_READS.fullmatch, filter(None, said.groups())))
    listed = isinstance(item.formula, Vector)
    if not variable or len(item.members) not in (0, 2) or is_root or listed:
        return None
    about = "".join(filter(None, said.groups())) if said else ""
    if said and not _OF_MATRIX.search(LINEAR_PART.sub("", about)):
        return CHARACTERISTIC, variable, "the characteristic equation"
    if item.members and exponential(variable, item, known):
        return CHARACTERISTIC, variable, "the equation of the exponents"
    return None


def letters_for(item: SourceStatement, known: Known) -> set[str]:
    """The letter of an eigenvalue, or of a frequency, in what is said of one."""
    role = known.roles.get(item)  # what the paper does not print has none
    kind = role.kind if role is not None else ""
    if kind == CHARACTERISTIC:
        return {variable_of(item, known)}
    return item.members[0].names() if kind in (KIND, FREQUENCY) and item.members else set()


def may_be_of_squares(item: SourceStatement, known: Known) -> bool:
    """Whether what is said of a linear part may be meant of squares, or by another time.

    A characteristic equation may be one for a frequency; where accelerations are printed, the
    eigenvalues may be those of the matrix that gives them.
    """
    kind = known.roles[item].kind
    if kind == CHARACTERISTIC:
        squares = may_be_of_frequencies(item, known)
    else:
        orders = (n for law in known.laws for row in law.rows for n in row.rates.values())
        squares = kind != FREQUENCY and max(orders, default=1) > 1
    return squares or bool(known.clocks)


def may_be_of_frequencies(item: SourceStatement, known: Known) -> bool:
    """Whether a characteristic equation may be one for a frequency: by its letter, or by words.

    It is no other one where the exponents are imaginary.
    """
    name = variable_of(item, known)
    if tried := exponential(name, item, known):
        return tried["i"] is not None
    letter = symbol(name).letter
    return letter in _OF_FREQUENCIES or _SECULAR.search(item.words) is not None


def law_at_rest(item: SourceStatement, known: Known) -> Law | None:
    """The law of motion before a statement of which it speaks, if there is one."""
    law = law_of_points(item, known)
    return law if law is not None and not law.change else None


def places_of(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations of the point near which a statement says something; none if it is not said.

    What cites something else than the law, or stands behind equations of other deviations or
    words of another case, is said of these.
    """
    law = law_at_rest(item, known)
    if law is None or _is_of_others(item, law, known):
        return ()
    origin = equations_of(dict.fromkeys(law.variables, "0"), item, law, known)
    clause = _clause(item, known)
    found = [one["where"] for one in _WHERE.finditer(known.paper.prose.text, *clause)]
    places = [*dict.fromkeys(_listed(clause, item, law, known))]
    if places or found:
        places += [origin] if any(where != "§" for where in found) else []
        return places[0] if len(places) == 1 and gives_all(places[0], law) else ()
    if is_of_origin_before(item):
        return origin
    if last := last_named(item, law, known):
        return last
    words = known.paper.prose.between(item.section.start, item.sentence[1])
    return origin if is_linear(law, known) or _SMALL_ANGLES.search(words) else ()


def _is_of_others(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether a statement may follow from other equations than the law."""
    start = max(item.paragraph, item.section.start, law.items[-1].typed.end)
    words = f"{item.words} {known.paper.prose.between(start, item.typed.start)}"
    if law.first.paragraph == item.paragraph:
        words = _BECOMES.sub("", words)  # it becomes so by this law
    others = ("force", "another system", "another case")
    if any(cue(name, words) for name in others) or _COMPARED.search(words):
        return True
    if any(one not in law.rows and not is_value(one, known) for one in known.cited(item)):
        return True
    before = (one for one in known.items if one.section is item.section and one.order < item.order)
    rated = (name for one in before if one not in law.rows for name in one.rates)
    return not all(known.varies(name) or known.is_defined(name) for name in rated)


def _clause(item: SourceStatement, known: Known) -> tuple[int, int]:
    """Where the words of a sentence stand that say where a statement holds.

    They stand right behind it, or else between it and another claim on a linear part, or last
    anywhere behind this.
    """
    (start, end), text = item.sentence, known.paper.prose.text
    beside = known.of_sentence(item.sentence)
    typed = [*dict.fromkeys(one.typed.start for one in beside)]
    formulas = (start + found.start() for found in re.finditer("§", text[start:end]))
    places = dict(zip(typed, formulas, strict=False))
    here = places[item.typed.start]
    for one in beside:
        other = places[one.typed.start]
        if other < here and known.roles[one].kind in (CHARACTERISTIC, FREQUENCY, KIND):
            start = start if _JOINED.fullmatch(text, other + 1, here) else other + 1
    if _WHERE_BEHIND.match(text, here + 1):
        name = variable_of(item, known)
        rows = {one.typed.start: [o for o in beside if o.typed is one.typed] for one in beside}
        alike = (  # behind a place with which its row begins
            places[start] + (_place_in(row) != row)
            for start, row in rows.items()
            if places[start] > here and any(name in one.names for one in row)
        )
        return here, min(alike, default=end)
    return start, here if _WHERE.search(text, start, here) else end


def _listed(
    clause: tuple[int, int], item: SourceStatement, law: Law, known: Known
) -> Iterator[tuple[SourceStatement, ...]]:
    """The equations of the places that a clause in the sentence of a statement names."""
    beside, text = known.of_sentence(item.sentence), known.paper.prose.text
    typed = [*dict.fromkeys(one.typed.start for one in beside)]
    for found in _WHERE.finditer(text, *clause):
        if found["where"] != "§":
            continue
        first = text[item.sentence[0] : found.start("where")].count("§")
        own: list[SourceStatement] = []
        for start in typed[first:]:
            here = _place_in([one for one in beside if one.typed.start == start])
            if not own and (point := point_at(here, item, law, known)):
                own = [*point]
                break
            joined = not own or _JOINED.fullmatch(here[0].lead)
            if not (joined and all(is_value(one, known) for one in here)):
                break
            own += here
        yield tuple(own)


def _place_in(row: list[SourceStatement]) -> list[SourceStatement]:
    """The statements of a row of a display, or the only list with which it begins.

    That is the place of what stands in the row before, as in “f at (1,0), g at (2,0)”.
    """
    listed = [one for one in row if isinstance(one.formula, Vector)]
    return listed if listed == row[:1] else row
