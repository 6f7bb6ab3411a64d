"""What a paper claims in its formulas: rates, sets, integrals, identities."""

from __future__ import annotations

import re

from kowalevski_cas.notation import (
    Derivative,
    Name,
    Number,
    Partial,
    PoissonBracket,
    Power,
    Relation,
    Vector,
)
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.degrees import degrees, is_linear
from kowalevski_cas.reading.deviations import is_linear_in_deviations
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, DEFINITION, OTHER, Known, StatementRole
from kowalevski_cas.reading.phrases import (
    AT_TIMES,
    IMPLIES,
    integral_words,
    is_level,
    is_value,
    joined_lead,
    joined_tail,
    plain,
    reach,
    resting,
    set_beside,
    solved_by,
    words_behind,
    words_of,
)
from kowalevski_cas.reading.rest_points import says_more_rest
from kowalevski_cas.reading.sets import has_set_beside
from kowalevski_cas.reading.solutions import rated_before
from kowalevski_cas.reading.statements import SourceStatement

ZERO = Number(0)
_KINDS = (("invariant", "invariant"), ("equilibrium", "rest"))
"""The words for what a set is, with the kinds of these claims."""


def approximate(item: SourceStatement, known: Known) -> StatementRole | None:
    """What holds approximately: it is not judged."""
    said = item in known.paper.approximate_here or is_linear_in_deviations(item, known)
    said = said or _is_linear_near_a_place(item, known)
    if not said or not item.members:
        return None
    if ZERO in item.members and all(m == ZERO or isinstance(m, Name) for m in item.members):
        return None  # it says where, and not what is small there
    return StatementRole(CLAIM, "the words before say that it holds approximately", "approximate")


def _is_linear_near_a_place(item: SourceStatement, known: Known) -> bool:
    """Whether rates are linear near a place, where the law is not: its letters deviate."""
    near = cue("place", item.before) and item.rates and known.varying(item.names)
    linear = cue("linear", item.before) or all(degrees(m, known) <= {0, 1} for m in item.members)
    return bool(near and linear) and not all(is_linear(law, known) for law in known.laws)


def solution(item: SourceStatement, known: Known) -> StatementRole | None:
    """A variable as a function of the time, or as words call it: a solution is claimed.

    It defines no variable, also where the law that moves it cannot be read.
    """
    moving = [name for name in item.bare if known.moves(name)]
    timed = item.names & {"t"} or item.is_const
    beside = known.varying(item.names - {*item.bare})  # a relation with the time is an identity
    if moving and timed and not (beside and item.derives):
        return StatementRole(
            CLAIM, f"gives {plain(moving[0])} by the time", "solution", (moving[0],)
        )
    timed = item.names & {"t"}  # then it is no identity of what the law moves
    given = [name for name in item.bare if timed and _is_given_by_time(name, item, known)]
    if given:
        return StatementRole(CLAIM, f"gives {plain(given[0])} by the time", "solution")
    rated = [name for name in item.bare if any(name in one.rates for one in known.items)]
    if rated and known.paper.primed_by[0] in item.names and _is_by_other(rated[0], item, known):
        why = f"gives {plain(rated[0])} by {plain(known.paper.primed_by[0])}"
        return StatementRole(CLAIM, why, "somewhere")
    said = cue("a solution", f"{item.lead[-60:]} § {item.tail[:40]}")
    if moving and not beside and item.typed.inline and not said:  # it is one of a list
        said = cue("a solution", f"{joined_lead(item)[-60:]} § {joined_tail(item)[:40]}")
    if rated and said and not item.derives:
        return StatementRole(CLAIM, f"“{said}” stands beside it", "solution")
    return None


def _is_by_other(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a statement gives what has primes, which derive by a letter that stands in it."""
    primed = any(name in one.rates and "prime" in one.marks for one in known.items)
    return primed and item.members[0] == Name(name) and not known.moves(name)


def _is_given_by_time(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether what stands for a function of what moves has a printed rate, and no time in it.

    Nothing else that moves stands beside the time.
    """
    moved = known.varies(name) and not known.moves(name)
    moved = moved and not known.varying(item.names - {*item.bare} - known.levels)
    return moved and "t" not in known.below(name) and rated_before(name, item, known)


_FOUND_FROM = re.compile(
    r"\b(?:found|determined|obtained|calculated|computed|defined|given)\s+(?:from|by)(?:\s+the)?"
    r"(?:\s+(?:conditions?|requirements?|equations?|relations?|equality|equalities))?(?:\s+that)?[\s:~]*$"
    r"|\b(?:(?:находим|определяем|найд[её]м)\s+из|(?:находи|определя|найд)(?!(?:ем|[её]м|м)\b)\w+(?:\s+из)?)"
    r"(?:\s+(?:услови\w+|уравнени\w+|соотношени\w+|равенств\w*))?[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands an equation for something that is sought."""
_IS_PLACE = re.compile(
    r"\b(?:isoclines?|nullclines?|turning\s+points?|points?\s+of\s+return|apsides|apses|pericent(?:er|re)s?|peri\w+s"
    r"|apo\w+s|extrem\w+|(?:max|min)im\w+(?:\s+(?:height|altitude|distance|elongation|value|deflection|amplitude)s?)?"
    r"|highest\s+point|lowest\s+point|vert(?:ex|ices)|изоклин\w+|точ\w+\s+(?:поворота|остановки))"
    r"(?:\s+of\s+(?:the\s+)?\w+|\s+of\s+§|\s+§)?\s+(?:is|are|occurs?|corresponds?\s+to|суть|определя\w+)"
    r"(?:\s+(?:then|therefore|given|found|determined|obtained|defined|reached|attained|located|by|from|where|when|if|at"
    r"|the\s+(?:line|curve)s?|условием|уравнением|из))*[\s:~]*(?:§[\s,]*(?:and|or|и)?[\s,]*)*$",
    re.IGNORECASE,
)
"""How words end behind which vanishing rates say where a special point is: they vanish there."""


_AT_ACCELERATION = re.compile(
    r"\b(?:if|when|where|for|from|with|putting|setting|conditions?|если|когда|при|из|положив|полагая|услови\w+)[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which accelerations vanish for what the sentence says."""


def _has_no_acceleration(item: SourceStatement, known: Known) -> bool:
    """Whether words suppose that second derivatives of what moves vanish, in a chain or a list."""
    others = [member for member in item.members if member != ZERO]
    rates = [row.rates for law in known.laws for row in law.rows]
    free = item.typed.inline and all(
        isinstance(one, Derivative)
        and isinstance(one.argument, Derivative)
        and isinstance(one.argument.argument, Name)
        and max((own.get(one.argument.argument.name, 0) for own in rates), default=0) == 2
        for one in others
    )
    if not free:
        return False
    if _AT_ACCELERATION.search(item.lead):
        return True
    before = [one for one in known.of_sentence(item.sentence) if one.order < item.order]
    joined = bool(before) and item.lead.strip(" ,;~") in ("", "and", "и")
    return joined and _has_no_acceleration(before[-1], known)


def set_of_rates(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""Rates that vanish on a set, with what moves, as :math:`x=0, \dot x=0`, or in a chain.

    What moves does not vanish everywhere: a chain is a set also where no words say more of it. One
    of rates alone is a set unless words conclude it.
    """
    if not item.derives or ZERO not in item.members:
        return None
    if _IS_PLACE.search(item.before) or _FOUND_FROM.search(item.lead):
        return StatementRole(ASSUMPTION, "says where something is", "set of the sentence")
    if _has_no_acceleration(item, known):
        return StatementRole(
            ASSUMPTION, "supposes that nothing is accelerated", "set of the sentence"
        )
    others = [member for member in item.members if member != ZERO]
    inner = [one.argument if isinstance(one, Derivative) else one for one in others]
    if not all(isinstance(one, Name) and known.moves(one.name) for one in inner):
        return None
    still = all(isinstance(one, Derivative) for one in others)
    concluded = cue("deduced", item.lead) or cue("then", item.lead)
    chain = len(others) > 1 and not (still and concluded)
    if not (chain or has_set_beside(item, known)):
        return None
    printed = {name for one in known.of_sentence(item.sentence) for name in one.names}
    whole = any({*law.variables} <= printed for law in known.laws)
    for words, kind in _KINDS:
        if (said := words_behind(item, words)) and (whole or kind == "invariant"):
            return StatementRole(CLAIM, f"“{said}” is said of the set", kind)
    return (
        StatementRole(ASSUMPTION, "a set that the text speaks of", reach(item)) if chain else None
    )


def rate(item: SourceStatement, known: Known) -> StatementRole | None:
    """Rates after the law: of a known function, and of variables once more."""
    if not item.derives or ZERO not in item.members:
        return None
    if len(item.members) == 2:
        other = next(member for member in item.members if member != ZERO)
        if isinstance(other, Derivative):
            inner = other.argument
            if isinstance(inner, Name) and known.moves(inner.name) and set_beside(item, known):
                return StatementRole(CLAIM, "one of the equations of a set", "invariant")
            return StatementRole(CLAIM, "a rate that vanishes", "integral")
    return None


_CYCLE = re.compile(
    r"\bcycle,?\s+(?:namely\s+)?the\s+(?:circle|ellipse|curve|oval)\s*$"
    r"|\bпредельн\w+\s+цикл\w*,?\s+(?:окружность|эллипс|кривая)\s*$",
    re.IGNORECASE,
)
"""How words end behind which stands the equation of a closed orbit."""


_IS_ORBIT = re.compile(
    r"[\s,~]*(?:of\s+radius[\s~]+§[\s,~]*)?is\s+(?:then\s+|also\s+)?(?:an?|the(?:\s+only)?)\s+(?:\w+\s+){0,2}?"
    r"(?:limit\s+cycle|cycle|(?:periodic|closed|homoclinic)\s+(?:orbit|trajectory)|separatrix)\b"
    r"|[\s,~]*(?:—|-{2,3}|есть|является)\s*(?:\w+\s+){0,2}?(?:предельн\w+\s+цикл\w*|сепаратрис\w+)",
    re.IGNORECASE,
)
"""How words begin behind the equation of an orbit."""


_OF_FUNCTION = re.compile(
    r"\b(?:values?|levels?|minim\w+|maxim\w+)\s+of\s+(?:the|this|an)\s+(?:\w+\s+)?invariant\b"
    r"|\b(?:the|this)\s+invariant\s+(?:is|has|equals|takes|becomes)\b"
    r"|\bзначени\w+\s+инварианта\b",
    re.IGNORECASE,
)
"""Words that speak of a function that is constant, and of its value: not of a set."""


_IS_MODE = r"(?:[\s,:~]|\b(?:is|are|has|have|with|by|where|given|described|the|we|one|имеем)\b)*"
_MODE = re.compile(
    rf"\b(?:modes?|normal\s+(?:oscillation|vibration)s?|мод[аыеу]|нормальн\w+\s+колебани\w+)"
    rf"{_IS_MODE}(?:§[^§]*)*$",
    re.IGNORECASE,
)
"""How words end, or their list, behind which a normal mode is printed."""
_ONE = re.compile(r"\b(?:in|for)\s+the\s+\w+(?:\s+one)?[\s,:]*$|\bво?\s+втор\w+[\s,:]*$")
"""How words end behind which what is one more of them stands."""


def _motion(item: SourceStatement) -> str:
    """The words that call a set a closed curve in which points move, or a normal mode."""
    found = _CYCLE.search(item.lead) or _IS_ORBIT.match(item.tail) or _MODE.search(item.lead)
    if not found and (_ONE.search(item.lead) or item.lead.strip(" ,;~") in ("", "and", "и")):
        found = _MODE.search(item.before)
    return found[0].strip() if found else ""


def claimed_set(item: SourceStatement, known: Known) -> StatementRole | None:
    """Equations of a set of which the words around them say that it is invariant, or at rest."""
    if not item.members or item.derives or not known.varying(item.names):
        return None
    if words_of(item, "of a map") or _OF_FUNCTION.search(item.lead):
        return None
    if any(isinstance(m, Vector) and isinstance(m.components[0], Vector) for m in item.members):
        return None  # it is a matrix
    first = item.members[0]
    if isinstance(first, Name) and not known.is_known(first.name):
        return None  # it is a function that is defined
    for words, kind in _KINDS:
        if said := words_of(item, words):
            return StatementRole(CLAIM, f"“{said}” is said of the set", kind)
    if said := resting(item):
        return StatementRole(CLAIM, f"“{said}” is said of the points", "rest")
    if says_more_rest(item):
        return StatementRole(CLAIM, "there are more points of rest, as words say", "rest")
    if motion := _motion(item):
        return StatementRole(CLAIM, f"“{motion}” is a motion in the set", "invariant")
    return _solutions_at_rest(item, known)


def _solutions_at_rest(item: SourceStatement, known: Known) -> StatementRole | None:
    """Equations of which words call the solutions equilibria; a number may decide if all are."""
    said = solved_by(item, "equilibrium")
    if said and known.paper.numbers and (only := _ONLY.search(item.before)):
        why = f"“{only[0]}” is said for any number, which decides what else is at rest"
        return StatementRole(OTHER, why, "asked")
    return StatementRole(CLAIM, f"“{said}” are the solutions", "rest") if said else None


_ONLY = re.compile(r"\b(?:only|all|exactly|no\s+other|единственн\w+|все)\b", re.IGNORECASE)
"""Words that say of a set that nothing is at rest beside it."""


def point(item: SourceStatement, known: Known) -> StatementRole | None:
    """One of the equations of a display that gives a point, or a set, which words call at rest."""
    said = cue("equilibrium", item.before)
    if item.typed.inline or not said:
        return None
    display = [one for one in known.items if one.typed is item.typed]
    if len(display) > 1 and all(_is_place(one, known) for one in display):
        return StatementRole(CLAIM, f"“{said}” is given by it, with others", "rest")
    return None


def _is_place(item: SourceStatement, known: Known) -> bool:
    """Whether a statement gives what moves, or its squares, by constants and by integrals."""
    levels = known.levels
    fixed = [one for one in item.members if not known.varying(one.names() - levels)]
    moving = [member for member in item.members if member not in fixed]
    bases = [one.base if isinstance(one, Power) else one for one in moving]
    letters = all(isinstance(one, Name) and known.moves(one.name) for one in bases)
    return bool(fixed and moving) and letters and not item.derives


def _is_on_level(item: SourceStatement, known: Known) -> bool:
    """Whether words say “on the level” of a function that is defined and has a constant value."""
    match item.members:
        case (Name(function), value) if known.is_defined(function) and known.varies(function):
            there = cue("level", item.lead) and cue("here", f"{item.lead} ")
            return bool(there) and not known.varying(value.names())
    return False


_CONSEQUENCE = re.compile(
    r"§[\s~]+(?:would\s+)?(?:impl(?:y|ies)|entails?|forces?|влеч[её]т)(?:\s+that)?[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands what follows from what is supposed right before."""


def zero_set(item: SourceStatement, known: Known) -> StatementRole | None:
    """Equations of a set: what vanishes, or has a value, without being so identically."""
    if not item.members or item.derives or _CONSEQUENCE.search(item.before):
        return None
    if _is_on_level(item, known):
        return StatementRole(ASSUMPTION, "a set that the text speaks of", reach(item))
    if ZERO in item.members and (said := cue("invariant", item.words)):
        if len(item.members) == 2 and known.varying(item.names):
            return StatementRole(CLAIM, f"“{said}” in its sentence", "invariant")
    values = [m for m in item.members if is_value(m) and not known.varying(m.names())]
    others = [m.name for m in item.members if isinstance(m, Name) and known.varies(m.name)]
    if not values or len(others) < len(item.members) - len(values) or not others:
        return None
    if all(map(known.moves, others)) or ZERO in values:
        for words, kind in _KINDS:
            said = cue(words, item.words)
            if said and (all(map(known.moves, others)) or kind == "invariant"):
                return StatementRole(CLAIM, f"“{said}” in its sentence", kind)
        kind = "set of the sentence" if IMPLIES.match(item.tail) else reach(item)
        return StatementRole(ASSUMPTION, "a set that the text speaks of", kind)
    return StatementRole(CLAIM, "a value that is taken somewhere", "somewhere")


def integral(item: SourceStatement, known: Known) -> StatementRole | None:
    """What words call an integral, or constant."""
    if not item.members:
        return None
    if item.is_const:
        return StatementRole(CLAIM, "“const” stands at its end", "constant")
    if all(isinstance(member, PoissonBracket) or member == ZERO for member in item.members):
        return None  # it is said of what stands in the brackets
    assert isinstance(item.formula, Relation)
    if any(isinstance(node, Partial) for node in item.formula.nodes()):
        return None  # its derivatives are said to have this value
    if (said := integral_words(item)) and is_level(item, known):
        return StatementRole(CLAIM, f"“{said}” stands beside it", "integral")
    return None


def identity(item: SourceStatement, known: Known) -> StatementRole | None:
    """What else is printed as an equation, of names that are known."""
    if not item.members:
        return None
    first = item.members[0]
    squared = isinstance(first, Power) and first.exponent == Number(2)
    given = first.base if isinstance(first, Power) and squared else first
    if isinstance(given, Name) and _is_given_here_alone(given.name, item, known):
        why = f"the only equation that gives {plain(given.name)}"
        return StatementRole(DEFINITION, why, "square" if squared else "", (given.name,))
    if (name := _unknown_of(item, known)) is not None:
        return StatementRole(CLAIM, f"an equation for {plain(name)}", "somewhere")
    return StatementRole(CLAIM, "an equation between what is known", "identity")


def _unknown_of(item: SourceStatement, known: Known) -> str | None:
    """The letter for which an equation of constants with a zero is one, as that of exponents.

    No law has it, and nothing says what it is, but perhaps other such equations: of all its values
    nothing is claimed.
    """
    if ZERO not in item.members or item.derives or known.varying(item.names) or not known.laws:
        return None
    said = {name for one in known.supposed(item) for name in one.names}
    sought = {one for one, role in known.roles.items() if role.kind == "somewhere"}
    before = (one for one in known.items if one.order < item.order and one.members)
    said |= {name for one in before if one not in sought for name in one.names}
    said |= {name for one in known.items for name in one.bare if one.members}
    new = [name for name in known.untied(sorted(item.names - said)) if not known.is_defined(name)]
    return new[0] if len(new) == 1 else None


def _is_given_here_alone(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether nothing but an equation says what a name is, though it stood before.

    It is none that a law has, or that moves by it; what words deduce, or say of one place or time,
    is no definition, and what is derived somewhere is given by what is derived as well.
    """
    others = [one for one in known.later.get(name, ()) if one is not item]
    moving = any(name in law.variables for law in known.laws)
    rest = len(item.members) == 2 and name not in item.members[1].names()
    deduced = cue("deduced", f"{item.before} ") or cue("follows", f"{item.lead} ")
    resting = any(name in known.below(one) for one in item.names - {name})
    new = rest and not (others or moving or resting or known.is_defined(name))
    new = new and name in known.paper.words.scalars and not known.is_step(name)
    rates = {one for other in known.items for one in other.rates}
    still = name in rates and rates.isdisjoint(item.names - {name})
    told = deduced or AT_TIMES.search(item.before) or still
    told = told or any(name in one.names for one in known.supposed(item))
    return bool(new and not told and known.untied((name,)))
