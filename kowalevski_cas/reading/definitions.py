"""What sets up the mathematics of a paper: its law, and the names that it gives."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation import (
    Application,
    Constant,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Vector,
)
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.reading.brackets import OF_FUNCTIONS
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.distances import twin
from kowalevski_cas.reading.fresh import (
    is_called_constant,
    is_constant_behind,
    is_fresh,
    is_given_behind,
    is_place_of,
    without_factor,
)
from kowalevski_cas.reading.kinetic import has_momentum
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    DEFINITION,
    LAW,
    LEVEL,
    NAMING,
    NOTATION,
    OTHER,
    TOGETHER,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.phrases import (
    integral_words,
    is_deduced_level,
    is_number,
    joined_lead,
    joined_tail,
    last_clause,
    plain,
    reach_of_constants,
    supposing,
    words_behind,
    words_of,
)
from kowalevski_cas.reading.statements import SourceStatement, is_closing
from kowalevski_cas.reading.unprinted import is_printed

ZERO = Number(0)


def named_set(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation of a set that has a name."""
    name = known.paper.sets.get(item.typed.start)
    if name is None or not item.members:
        return None
    return StatementRole(DEFINITION, f"one of the equations of the set {name}", "set")


def coordinate_lines(item: SourceStatement, known: Known) -> StatementRole | None:
    """Where a coordinate is constant: “the curves x=const are hyperbolas”."""
    coordinate = item.is_const and item.bare and not known.is_defined(item.bare[0])
    said = cue("family", joined_lead(item)) if coordinate else ""
    if not said or cue("of motions", joined_tail(item)):
        return None
    return StatementRole(OTHER, f"“{said.strip()}” are named by it")


def law(item: SourceStatement, known: Known) -> StatementRole | None:
    """The equations of motion."""
    found = known.law_of(item)
    if found is None:
        before = any(map(is_printed, _rows_before(item, known)))
        more = item in known.paper.unfinished and not before
        return StatementRole(LAW, "not all equations of this law are printed") if more else None
    if found.images:
        return StatementRole(LAW, "belongs to a map")
    which = "a closed set of rates" if found is known.laws[0] else "a closed set of other rates"
    return StatementRole(LAW, f"belongs to {which}")


def _rows_before(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """The equations of motion before a statement."""
    return [row for law in known.laws for row in law.rows if row.order < item.order]


def unit(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""The imaginary unit, :math:`i^2=-1`, components, and another time, :math:`dt=r\,d\tau`."""
    match item.members:
        case (Power(Name("i"), Number(2)), Number() | Negative(Number())):
            return StatementRole(NOTATION, "says what the imaginary unit is", "unit", ("i",))
        case (Name(name), Vector()) if known.names.are_components(item.members):
            return StatementRole(DEFINITION, f"names the components of {plain(name)}", "vector")
    if item.other_time in known.times:
        return StatementRole(DEFINITION, f"gives another time {item.other_time}", "clock")
    return None


def bracket(item: SourceStatement, known: Known) -> StatementRole | None:
    """Poisson brackets of variables, before anything is claimed of them."""
    if any(role.kind == OF_FUNCTIONS for role in known.roles.values()):
        return None
    brackets = item.members[:-1]
    if not brackets or not all(_is_of_letters(one, known) for one in brackets):
        return None
    if item.members[-1] == ZERO and len(brackets) > 1:
        return StatementRole(DEFINITION, "brackets of variables that vanish")
    heads = item.printed.heads.names
    if len(heads) < len(brackets) or any(name in known.definitions for name in heads):
        return None
    why = f"first with {'these brackets' if len(brackets) > 1 else 'this bracket'} of variables"
    return StatementRole(DEFINITION, why, "", heads[: len(brackets)])


def _is_of_letters(bracket: Formula, known: Known) -> bool:
    """Whether a formula is the bracket of two coordinates that nothing defines.

    One of a coordinate and its momentum says that both are coordinates.
    """
    match bracket:
        case PoissonBracket(Name(x), Name(y)):
            momentum = known.moves(x) and y in (f"p_{x}", f"p_{{{x}}}") and not known.is_defined(y)
            return momentum or all(
                _is_coordinate(n, known) and not _is_given(n, known) for n in (x, y)
            )
    return False


def _is_given(name: str, known: Known) -> bool:
    """Whether a name has a meaning, and not only that of another link of a closed chain.

    What moves by the equations before it has none by new variables, if no brackets are printed of
    these.
    """
    given = known.definitions.get(name, ())
    rows = [row.order for law in known.laws for row in law.rows if name in row.rates]
    changed = given and rows and all(one.order > rows[0] for one in given)
    others = {other for one in given for other in one.names - {name}}
    brackets = (head(one)[1] for one in known.definitions if one.startswith(BRACKET))
    changed = changed and others.isdisjoint(other for own in brackets for other in own)
    return known.is_defined(name) and not (changed or any(map(is_closing, given)))


_WITH_ZERO = 3
"""The members of a chain that names a function, and says no more than where it vanishes."""


def _chain(
    item: SourceStatement, known: Known, fresh: Sequence[str], others: Sequence[Formula]
) -> StatementRole | None:
    r"""What a chain of equalities claims: that of a set where it ends with zero.

    So does :math:`f\equiv Ap+Cr=0`, by which f has its name.
    """
    varying = known.varying(item.names - {*fresh})
    if item.members[-1] == ZERO and len(item.members) == _WITH_ZERO and varying:
        kinds = {"invariant": "invariant", "equilibrium": "rest"}
        said = next(((k, s) for k in kinds if (s := words_of(item, k))), None)
        if said is not None:
            kind, words = said
            why = f"“{words}” is said of the set"
            return StatementRole(CLAIM, why, kinds[kind], (*fresh,))
        why = f"names {plain(fresh[0])}, which vanishes on a set"
        return StatementRole(DEFINITION, why, "", (*fresh,))
    if len([m for m in others if not isinstance(m, Name | Constant)]) > 1:
        why = f"a chain of equalities; it names {plain(fresh[0])}"
        return StatementRole(CLAIM, why, "identity", (*fresh,))
    return None


def _is_coordinate(name: str, known: Known) -> bool:
    """Whether a name moves, or is what moves: with any index, or beyond the end of a chain."""
    giving = (*known.later.get(name, ()), *known.definitions.get(name, ()))
    closing = (one for one in giving if is_closing(one))
    moves = known.moves(name) or any(map(known.moves, (one.bare[1] for one in closing)))
    return moves or name.endswith(("_i", "_j"))


def definition(item: SourceStatement, known: Known) -> StatementRole | None:
    """A name that nothing has defined, alone on a side."""
    given = item.printed.heads
    fresh = _fresh(item, known)
    opposite = not given.names and any(isinstance(m, Negative) for m in item.members)
    if opposite and not known.varying(item.names - {*fresh}):
        return None  # it gives no value of anything that moves
    if not fresh or has_momentum(fresh[0], item, known) or _is_given_beside(item, fresh[0], known):
        return None
    heads = {head(name)[0] for name in fresh}
    alone = [without_factor(m) for m in item.members]
    others = [m for m in alone if getattr(m, "name", getattr(m, "function", "")) not in heads]
    listed = any(isinstance(one, Vector | Diagonal) for one in others)
    listed = listed and not any(map(known.is_known, fresh))
    numbers = is_number(others) and not any(known.is_known(n) for n in item.names - {*fresh})
    if numbers and not listed:
        why = "gives a number for a name"
        return StatementRole(ASSUMPTION, why, reach_of_constants(item), tuple(fresh))
    if cue("if", item.lead) and not _CALLED.match(item.tail):
        moving = known.varying(item.names - {*fresh})
        lasts = "set" if moving else reach_of_constants(item)
        return StatementRole(ASSUMPTION, "supposed in its sentence", lasts, tuple(fresh))
    if said := _specialising(item, known, fresh):
        why = f"“{said}” gives what was general before"
        return StatementRole(ASSUMPTION, why, reach_of_constants(item), tuple(fresh))
    if len(others) == 1 and isinstance(others[0], Derivative) and not _is_law_left(item):
        if said := words_behind(item, "integral"):
            why = f"“{said}” stands beside it; it names {plain(fresh[0])}"
            return StatementRole(CLAIM, why, "integral", tuple(fresh))
        return StatementRole(LEVEL, f"names the rate {plain(fresh[0])}", "", tuple(fresh))
    if role := _integral_that_defines(item, known, fresh) or _constant(item, known, fresh):
        return role
    if role := _chain(item, known, fresh, others) or _level(item, known, fresh, others):
        return role
    return twin(fresh[0], item, known) or StatementRole(
        DEFINITION, f"first with {plain(fresh[0])} alone on a side", "", tuple(fresh)
    )


def constant(item: SourceStatement, known: Known) -> StatementRole | None:
    """A letter that is said to be constant, and of which nothing else is said: “k = const”."""
    letters = item.is_const and len(item.bare) == len(item.members) - 1 and len(item.bare) == 1
    if not letters or known.varies(item.bare[0]) or known.is_defined(item.bare[0]):
        return None
    given = item.bare[0] in known.later or any(item.bare[0] in one.rates for one in known.items)
    return None if given else StatementRole(NOTATION, "says that it is constant")


def _is_given_beside(item: SourceStatement, name: str, known: Known) -> bool:
    r"""Whether a rate is a letter that the next equation gives: :math:`\ddot r=-k, k=g/4`."""
    rated = item.derives and item.members[0] != Name(name)
    given = (one for one in known.later.get(name, ()) if one.typed is item.typed)
    return rated and any(
        one.order > item.order and one.members[0] == Name(name) and not known.varying(one.names)
        for one in given
    )


_CALLED = re.compile(
    r"[\s,~]*(?:denotes?|(?:is|are)\s+the\s+(?!same|only|case)\w|обознача[ею]т|есть\s|[-—–]+\s*\w)",
    re.IGNORECASE,
)
"""How words begin that say how the name before them is called: it is no condition then."""


def _fresh(item: SourceStatement, known: Known) -> list[str]:
    """The names that a statement gives: of new ones that are the same it gives all but the last."""
    given = item.printed.heads
    fresh = [n for n in given.names or given.multiples if is_fresh(n, item, known)]
    fresh = [name for name in fresh if not is_given_behind(name, item, known)]
    if len(fresh) == len(item.members) and all(isinstance(m, Name) for m in item.members):
        fresh = fresh[:-1]
    return [] if fresh and is_place_of(fresh[0], item, known) else fresh


_EXAMPLE = re.compile(r"\be\.\s*g\.|\bfor\s+(?:instance|example)\b|\bнапример\b", re.IGNORECASE)
"""Words for an example: what they give constants of laws is so in that only."""


def _specialising(item: SourceStatement, known: Known, fresh: list[str]) -> str:
    """The words that give constants special values, of which laws in other sections have spoken.

    Or of which they speak later, if it makes two of them equal. They are in force to the end of
    their section, as what is supposed is.
    """
    names = [head(name)[0] for name in fresh]
    of_laws = {name for law in known.laws for name in (*law.mentions, *law.names.vectors)}
    before = [known.seen.get(name) for name in names]
    apart = all(one is not None and one.section not in item.sections for one in before)
    apart = apart or known.paper.prose.footnote(item.typed.start) is not None
    others = [without_factor(one) for one in item.members if one not in (*map(Name, names),)]
    alike = item.names <= of_laws and all(isinstance(o, Name) for o in others)
    equal = alike and not any(before)
    example = _EXAMPLE.search(item.before)
    if not {*names} <= of_laws or known.varying(item.names - {*names}):
        return ""
    if example is not None and item.names <= of_laws:
        return example[0]
    said = supposing(item) or cue("lasting", item.before) if apart or equal else ""
    return said or (cue("in this part", item.before) if equal or (alike and apart) else "")


def _level(
    item: SourceStatement, known: Known, fresh: list[str], others: list[Formula]
) -> StatementRole | None:
    """A value for which there is a new name: of a function, of what moves, or of constants."""
    named = [m for m in others if isinstance(m, Name) and known.varies(m.name)]
    if named and item.members and item.members[0] == named[0]:
        why = f"names the value {plain(fresh[0])} of {plain(named[0].name)}"
        return StatementRole(LEVEL, why, "", (*fresh,))
    first = without_factor(item.members[0])
    several = any(head(name)[1] for name in fresh)  # values, one for each argument
    behind = not (named or several) and len(others) == len(item.members) - 1
    if behind and not isinstance(first, Name | Application | PoissonBracket):
        if known.varying(item.names - {*fresh}):
            why = f"names the value {plain(fresh[0])}"
            listed = last_clause(joined_lead(item)) if joined_lead(item) != item.lead else ""
            if said := cue("integral", listed) if item.typed.inline else "":
                why = f"“{said}” is said of it and others; it names {plain(fresh[0])}"
                return StatementRole(CLAIM, why, "integral", (*fresh,))
            if (
                (item.typed.inline and not is_deduced_level(item))
                or cue("suppose", item.lead)
                or cue("level", item.lead)
            ):
                return StatementRole(LEVEL, why, "", (*fresh,))
            return StatementRole(CLAIM, f"{why}, which is constant then", "integral", (*fresh,))
    chain = len(item.bare) > 2 and not any(map(known.is_defined, item.names - {*fresh}))
    chain = chain and not known.varying(item.names) and len(fresh) == 1
    if (item.bare[:1] != tuple(fresh[:1]) or chain) and len(item.bare) == len(item.members):
        why = "gives constants by a new one"
        return StatementRole(ASSUMPTION, why, reach_of_constants(item), item.bare)
    return None


def repeated(item: SourceStatement, known: Known) -> StatementRole | None:
    """What has been said before, sign for sign, to name something."""
    for one in known.paper.alike[item.formula]:
        role = known.roles.get(one)
        if one not in known.items:
            continue  # it names something in another part
        if (
            role is not None
            and role.name in NAMING
            and role.kind != "set"
            and one.order < item.order
        ):
            said = integral_words(item) if role.name == DEFINITION else ""
            if said and role.names and known.varying(item.names):
                why = f"“{said}” stands beside it; it names {plain(role.names[0])}"
                return StatementRole(CLAIM, why, "integral", role.names)
            if role.name != CLAIM or (role.names and item.typed.inline):
                return StatementRole(NOTATION, f"said before, at {one.printed.place}")
    return None


def together(item: SourceStatement, known: Known) -> StatementRole | None:
    """One of several equations that give names which none of them gives alone."""
    for law in known.laws:
        if item in law.together:
            words = f"gives {', '.join(map(plain, law.new))}, with others"
            return StatementRole(DEFINITION, words, TOGETHER)
    return None


_SOLUTION = re.compile(
    r"\b(?:solutions?|решени\w+)\s*(?:(?:then|is|are|reads?|имеет\s+вид|—)\s*)*[\s:,~§]*$",
    re.IGNORECASE,
)
"""How words end behind which solutions are printed, perhaps with others before it."""


def change(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""New names for the parts of what moves, as :math:`v=v_0+\zeta`."""
    for law in known.laws:
        if item in law.momenta:
            moving = plain(law.momenta[item])
            return StatementRole(
                DEFINITION, f"gives it by {moving}, which moves", "", item.bare[:1]
            )
        if item in law.change:
            words = f"gives it by {', '.join(map(plain, law.new))}"
            return StatementRole(DEFINITION, words, "change", item.bare[:1])
    first = item.bare[0] if item.bare and item.members[0] == Name(item.bare[0]) else ""
    new = [name for name in item.names if name != first and not known.is_known(name)]
    said = cue("define", item.lead)
    if "t" not in item.names:  # else it is a solution
        said = said or cue("suppose", item.lead)
    solved = "t" in item.names and _SOLUTION.search(item.before)
    if cue("equilibrium", item.words) or solved or len(item.members) != 2:
        return None  # that is a point, or a solution
    if first and new and said and not item.derives:
        if known.moves(known.names.whole(first)) or first.endswith("_i"):
            return StatementRole(DEFINITION, f"gives {plain(first)} by what is new", "change")
    return None


def square(item: SourceStatement, known: Known) -> StatementRole | None:
    """The square of a name that nothing has defined, alone on a side."""
    fresh = [n for n in item.printed.heads.squares if is_fresh(n, item, known)]
    if not fresh or has_momentum(fresh[0], item, known):
        return None
    if not known.varying(item.names - {*fresh}):
        if len(item.bare) == len(item.members) - 1 > 1:
            return None  # it makes constants equal
        return _square_of_constants(item, known, fresh)
    first = item.members[0] == Power(Name(fresh[0]), Number(2))
    claimed = _integral_further_off(item, known) if first else integral_words(item)
    claimed = claimed or words_behind(item, "integral")
    claimed = claimed or ("constant" if is_constant_behind(fresh[0], item, known) else "")
    if claimed:
        return StatementRole(
            CLAIM,
            f"“{claimed}” stands beside it; it names {plain(fresh[0])}",
            "integral",
            (*fresh,),
        )
    return twin(fresh[0], item, known) or StatementRole(
        DEFINITION,
        f"first with the square of {plain(fresh[0])} alone on a side",
        "square",
        (*fresh,),
    )


def _square_of_constants(
    item: SourceStatement, known: Known, fresh: list[str]
) -> StatementRole | None:
    """The square of a new constant by known ones, where words define it."""
    first = known.seen.get(fresh[0])
    beside = first is not None and first.typed is item.typed
    new = beside or not any(map(known.is_known, fresh))
    others = [m for m in item.members if m.names().isdisjoint(fresh)]
    said = beside or (cue("define", item.lead) and not cue("if", item.lead))
    if new and said and item.members[0] == Power(Name(fresh[0]), Number(2)):
        if not is_number(others) and all(map(known.is_known, item.names - {*fresh})):
            why = f"first with the square of {plain(fresh[0])} alone on a side"
            return StatementRole(DEFINITION, why, "square", (*fresh,))
    return None


def _constant(item: SourceStatement, known: Known, fresh: list[str]) -> StatementRole | None:
    """What is said to be the constant of which something has been claimed: that it is one.

    So does “const” at the end of what names it.
    """
    if item.is_const and known.varying(item.names - {*fresh}):
        why = f"“const” stands at its end; it names {plain(fresh[0])}"
        return StatementRole(CLAIM, why, "integral", (*fresh,))
    first = known.seen.get(fresh[0])
    used = first is not None and known.roles[first].name == CLAIM
    if used and is_called_constant(fresh[0], item, known) and known.varying(item.names - {*fresh}):
        why = f"{plain(fresh[0])} is called a constant; it is this"
        return StatementRole(CLAIM, why, "integral", (*fresh,))
    return None


def _is_law_left(item: SourceStatement) -> bool:
    """Whether a rate stands on the left."""
    return isinstance(item.members[0], Derivative) and not item.typed.inline


_SYMMETRY = re.compile(
    r"(?:because\s+of|owing\s+to|by\s+virtue\s+of)\s+(?:\w+\s+){0,2}(?:symmetry|invariance|homogeneity)"
    r"|в\s+силу\s+(?:\w+\s+){0,2}(?:симметри|инвариантност|однородност)\w+",
    re.IGNORECASE,
)
"""Words for why something is an integral: it is not deduced from what is printed."""


def _integral_further_off(item: SourceStatement, known: Known) -> str:
    """The words of the sentence of a display that call it an integral, or the energy."""
    lead = _SYMMETRY.sub("", item.lead)
    if item.typed.inline or cue("follows", lead) or cue("deduced", lead):
        return ""
    if said := cue("integral", last_clause(item.before)) or cue("energy", item.lead):
        return said
    before = [one for one in known.roles if one.typed is item.typed and one.order < item.order]
    integrals = any(known.roles[one].kind == "integral" for one in before)
    return integral_words(before[0]) if integrals else ""


_OF_FUNCTION = re.compile(
    r"\b(?:functions?|polynomials?|expressions?|quantit(?:y|ies)|функци\w+)[\s~:]*$", re.IGNORECASE
)
_INVARIANT = re.compile(r"[\s,~]*is\s+(?:\w+\s+)?invariant\s+under\b", re.IGNORECASE)


def _invariant(item: SourceStatement) -> str:
    """The words behind that call a function invariant under a map, or a flow."""
    found = _INVARIANT.match(item.tail) if _OF_FUNCTION.search(item.lead) else None
    return found[0].strip() if found else ""


_THEY_ARE = re.compile(
    r"\W*(?:explicitly|namely|in\s+(?:detail|full)|written\s+out|(?:they|these)\s+(?:are|read|have\s+the\s+form)"
    r"|в\s+явном\s+виде|явно|а\s+именно|они\s+име[ею]т\s+вид|вот\s+они)\b[^§]*",
    re.IGNORECASE,
)
"""How a sentence begins that prints what the one before it speaks of."""


def _spoken_of(item: SourceStatement) -> str:
    """The words by which the sentence before calls integrals what a display prints in full."""
    before = item.earlier[0] if item.earlier else ""
    if item.typed.inline or not _THEY_ARE.fullmatch(joined_lead(item)):
        return ""
    return "" if cue("denied", before) or cue("when", before) else cue("integral", before)


def _integral_that_defines(
    item: SourceStatement, known: Known, fresh: list[str]
) -> StatementRole | None:
    """An integral with a name that is new: a claim, unless its rate is claimed elsewhere.

    A theorem claims it itself; its rate is the proof.
    """
    said = integral_words(item) or _integral_further_off(item, known) or _invariant(item)
    said = said or _spoken_of(item)
    moves = known.varying(item.names - {*fresh}) or item.derives
    if not said or not moves or cue("where", item.lead):
        return None
    vanishing = integral_words(item)
    later = known.paper.items if item.theorem is None or not vanishing else ()
    for one in later[item.order + 1 : item.order + 12]:
        if ZERO in one.members or not vanishing:
            if not one.rates.keys().isdisjoint(fresh):
                return None
    return StatementRole(
        CLAIM, f"“{said}” stands beside it; it names {plain(fresh[0])}", "integral", (*fresh,)
    )
