"""Which names are new where a statement gives them: nothing has said yet what they are."""

from __future__ import annotations

import re

from kowalevski_cas.notation import Formula, Name, Negative, Number, Power, Product
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.kinetic import has_momentum
from kowalevski_cas.reading.known import CLAIM, DEFINITION, LAW, OTHER, Known
from kowalevski_cas.reading.phrases import joined_lead
from kowalevski_cas.reading.statements import SourceStatement, derived_names, is_numerical


def is_fresh(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether nothing has said yet what a name is."""
    function, arguments = head(name)
    first_names = {member.name for member in item.members[:1] if isinstance(member, Name)}
    if {function, *first_names} & known.functions.keys():
        return False  # it may be any function, and what is said of one names no value
    if function == BRACKET or (function == PI and item.members[0] != Name(PI)):
        return False
    if found := known.definitions.get(function) or known.definitions.get(
        known.names.whole(function)
    ):
        if _defines_anew(function, item, found, known):
            return True
        bound = {n for one in found for name in one.printed.heads.names for n in head(name)[1]}
        unclear = any(not _is_clear(n, one, known) for one in found for n in one.names - bound)
        rests = any(function in known.below(n) for n in item.names - {function})
        return unclear and not rests and all(known.is_explained(n) for n in item.names)
    if known.moves(function) or function in known.times or known.is_step(function):
        return False
    alone = (Name(function), Power(Name(function), Number(2)))
    rest = (m for m in item.members if m not in alone and without_factor(m) not in alone)
    if any(function in m.names() for m in rest) and not arguments:
        return False
    others = item.names - {function, *arguments}
    new = bool(others) and not any(map(known.is_known, others))
    first = known.seen.get(function)
    return (
        first is None
        or (known.roles[first].name in (LAW, DEFINITION) and first.sentence == item.sentence)
        or (first.typed is item.typed and item.members[0] in alone)
        or (known.roles[first].name == LAW and _gives(function, item, known))
        or (_explains(item) and _is_near(first, item))
        or (first.sentence == item.sentence and bool(_WITH.search(joined_lead(item))))
        or _is_explained(function, first, item)
        or (known.roles[first].name == LAW and function in derived_names(first))
        or (new and not item.typed.inline)
        or _is_used_before(function, first, item, known)
        or _is_left_open(function, first, item, known)
        or (known.roles[first].name == OTHER and bool(_CALLED.search(first.words)))
    )


_CALLED = re.compile(
    r"\b(?:is|are|be)\s+(?:called|said\s+to\s+be|termed)\b|\bназыва\w+", re.IGNORECASE
)
"""Words that say how whatever satisfies something is called: its letter stands for any of these."""


def _is_clear(name: str, one: SourceStatement, known: Known) -> bool:
    """Whether it is known what a name in a definition is, as a constant of the energy, too."""
    if known.is_explained(name) or has_momentum(name, one, known):
        return True
    energies = (n for law in known.laws for n in law.mentions if known.is_defined(n))
    return any(name in known.below(energy) for energy in energies)


def _is_used_before(name: str, first: SourceStatement, item: SourceStatement, known: Known) -> bool:
    """Whether what has been claimed of a name is said of what a statement behind it gives it for.

    Nothing else gives the name, or supposes anything of it, and no words derive the statement.
    """
    is_field = name in derived_names(first)
    left = (one for one in known.items if one.members[:1] == (Name(name),))
    giving = (one for one in left if not (is_field and any(map(is_numerical, one.members))))
    if known.roles[first].name != CLAIM or next(giving, item) is not item or cue("if", item.lead):
        return False
    if is_field:
        return True  # it solves what was printed of its derivatives
    if known.laws and not known.varying(item.names - {name}):
        return False
    supposed = any(name in known.roles[one].names for one in known.assumptions)
    mentioned = any(name in law.mentions for law in known.laws)
    alone = item.members[0] == Name(name) and not item.typed.inline
    explained = all(map(known.is_explained, item.names - {name}))
    told = bool(cue("deduced", item.lead)) and not is_called_constant(name, item, known)
    return alone and explained and not (supposed or mentioned or told)


def _is_left_open(name: str, first: SourceStatement, item: SourceStatement, known: Known) -> bool:
    """Whether it is the constant of an ansatz, of which a display says later what it has to be.

    Nothing else gives it or supposes anything of it, and it is none of a law.
    """
    if known.roles[first].name != DEFINITION or item.typed.inline or known.varying(item.names):
        return False
    if item.members[0] != Name(name) or not cue("ansatz", first.lead):
        return False
    giving = (one for one in known.items if one.members[:1] == (Name(name),))
    supposed = any(name in known.roles[one].names for one in known.assumptions)
    mentioned = any(name in law.mentions for law in known.laws)
    return next(giving, item) is item and not (supposed or mentioned)


def is_called_constant(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether words call a name a constant, before a statement, or right before it."""
    before = (one for one in known.items if one.formula == Name(name) and one.order < item.order)
    leads = [item.lead, *(one.lead for one in before)]
    return any(cue("a constant", lead[-40:]) for lead in leads)


_WITH_CONSTANT = re.compile(
    r"\s*,?\s*(?:with|where|for)\s+(?:an?|some)\s+(?:\w+\s+)?constant\s*$"
    r"|\s*,?\s*(?:с|где)\s+(?:\w+\s+)?постоянн\w+\s*$",
    re.IGNORECASE,
)
"""The words between a value and its name that call it constant: “with a constant c”."""


def is_constant_behind(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether the words right behind a statement call a name in it a constant."""
    behind = (one for one in known.of_sentence(item.sentence) if one.order > item.order)
    first = next(behind, None)
    return first is not None and name in first.names and bool(_WITH_CONSTANT.match(first.lead))


def is_given_behind(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a function on a right side is what its sentence gives behind, at its argument."""
    function, arguments = head(name)
    first = item.members[0]
    if not arguments or getattr(first, "function", "") == function:
        return False
    return any(
        one.order > item.order and one.sentence == item.sentence
        and bool(one.members) and getattr(one.members[0], "function", "") == function
        for one in known.items
    )  # fmt: skip


def is_place_of(name: str, item: SourceStatement, known: Known) -> bool:
    r"""Whether a new letter is where a variable of the law is, and no name for the variable.

    Then constants give it behind, as in “at rest :math:`x=a`, where :math:`a=mg/k`”, or a function
    of it in the same sentence, as :math:`\cos a`; or it gives the variable with something else, as
    in :math:`x=a+\xi`.
    """
    match item.members:
        case (Name(variable), Name(other)) if other == name and known.moves(variable):
            behind = [one for one in known.items if one.order > item.order]
            giving = [one for one in behind if one.bare and one.members[0] == Name(one.bare[0])]
            given = [one for one in giving if one.bare[0] == name and len(one.members) == 2]
            given = given[:1] + [
                one
                for one in behind
                if one.sentence == item.sentence and len(one.members) == 2
                and name in one.names - {*one.bare}
                and not (isinstance(one.members[0], Name) and not known.is_known(one.bare[0]))
            ]  # fmt: skip
            by_constants = any(not known.varying(one.names - {name}) for one in given)
            return by_constants or any(
                one.bare[0] == variable and name in one.names and one.members[1] != Name(name)
                for one in giving
            )
    return False


def without_factor(formula: Formula) -> Formula:
    """What stands behind a number, as T in 2T, or a sign; any other formula itself."""
    match formula:
        case Product((Number(), inner)) | Negative(Name() as inner):
            return inner
    return formula


def _defines_anew(
    name: str, item: SourceStatement, found: list[SourceStatement], known: Known
) -> bool:
    """Whether words let a display of another section define a name on its left once more.

    In the new variables of a change it is what it was before. One more integral may have the letter
    of another one.
    """
    if any(item.names & {*law.new} for law in known.laws) or name not in item.members[0].names():
        return False
    apart = all(one.section not in item.sections for one in found)
    said = cue("hamiltonian", item.lead[-40:]) or cue("define", item.lead)
    more = _ONE_MORE_INTEGRAL.search(item.lead)
    timed = item.names & {"t"}  # it is a solution
    anew = apart and not item.typed.inline and not timed
    return anew and bool(said or more) and not cue("derived", item.lead)


_ONE_MORE_INTEGRAL = re.compile(
    r"\b(?:an?|another|additional|further|more|new|second|third|fourth|fifth|following|there\s+(?:is|exists)|"
    r"has|have|possess(?:es)?|admits?|ещ[её]|дополнительн\w+|нов\w+|втор\w+|трет\w+|четв[её]рт\w+|допуска\w+|имеет)\b"
    r"[^.;§]*\b(?:integrals?|интеграл\w*)\b[^.;§]*$",
    re.IGNORECASE,
)
"""How words end that introduce one more integral."""


def _gives(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a display gives a name of the law by what moves, as it does a potential."""
    first = item.members[0] if item.members else None
    alone = name in (getattr(first, "name", ""), getattr(first, "function", ""))
    moving = known.varying(item.names - {name})
    return alone and bool(moving) and not item.typed.inline and not item.derives


_FOR = re.compile(
    r"\W*(?:(?:(?:holds?|is\s+(?:true|valid|satisfied|so))\W+)?(?:for|with|для)\W*)?", re.IGNORECASE
)
"""All that stands before what says what a name was, as in “the rate vanishes for F=x²”."""


def _is_explained(name: str, first: SourceStatement, item: SourceStatement) -> bool:
    """Whether it is said behind the claim of a rate of which function that is."""
    behind = first.sentence == item.sentence and _FOR.fullmatch(item.lead) is not None
    return behind and name in first.rates


_WITH_THE = re.compile(r"\bwith\s+(?:the|its|their)\s+(?:[\w-]+\s+){0,3}$", re.IGNORECASE)
"""How words end behind which letters are explained, as in “an ellipse … with the semiaxes”."""


_WITH = re.compile(r"\bwith[\s~]*$", re.IGNORECASE)
"""How words end behind which a letter of the sentence is given."""


def _explains(item: SourceStatement) -> bool:
    """Whether words let a statement, with those that it is joined to, say what letters are."""
    words = joined_lead(item)
    return bool(cue("where", words) or _WITH_THE.search(f"{words.rstrip()} "))


def _is_near(one: SourceStatement, item: SourceStatement) -> bool:
    """Whether a statement may explain what another one has before it: in its paragraph."""
    return one.paragraph == item.paragraph
