"""What each statement of a paper is: one function a rule, in the order in which they are asked."""

from __future__ import annotations

import re
from collections.abc import Callable

from kowalevski_cas.notation import (
    Application,
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Relation,
    Vector,
    to_plain,
)
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.reading.cues import cue, last_cue
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    DEFINITION,
    LAW,
    LEVEL,
    NAMING,
    NOTATION,
    OTHER,
    UNREAD,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.obey import said_role
from kowalevski_cas.reading.statements import SourceStatement

Rule = Callable[[SourceStatement, Known], StatementRole | None]
ZERO = Number(0)


def role_of(item: SourceStatement, known: Known) -> StatementRole:
    """What a statement is: what a comment says, or the first rule that says something."""
    inferred = next(role for rule in RULES if (role := rule(item, known)) is not None)
    found = known.said.role(item)
    return inferred if found is None else said_role(found, item, inferred, known)


_VERB = re.compile(
    r"[\s~]*(?:(?:also|thus|hence)\s+)?"
    r"(?:is|are|remains?|stays?|does|do|сохран|постоян|не\s+меня|есть|явля|оста[её]тся|[-—–]+\s)",
    re.IGNORECASE,
)
"""What says of the expression before it that it is something, or does something."""


# -- what states nothing ---------------------------------------------------------------


def unread(item: SourceStatement, known: Known) -> StatementRole | None:
    """What cannot be read."""
    return StatementRole(UNREAD, item.trouble) if item.formula is None else None


def expression(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is no relation: a name, or an expression, of which only words state something."""
    if isinstance(item.formula, Relation):
        return None
    said = cue("integral", item.tail[:40]) if _VERB.match(item.tail) else ""
    if isinstance(item.formula, Name) and not (said and known.varies(item.formula.name)):
        return StatementRole(NOTATION, "a name")
    if said and known.varying(item.names):
        if role := unjudged(item, known):
            return role
        return StatementRole(CLAIM, f"“{said}” stands behind it", "integral")
    return StatementRole(OTHER, "an expression: nothing is stated")


def inequality(item: SourceStatement, known: Known) -> StatementRole | None:
    """What says that something is larger, or is not."""
    if item.members:
        return None
    assert isinstance(item.formula, Relation)
    if not {*item.formula.signs} & {"<", ">", r"\le", r"\ge", r"\leq", r"\geq", r"\ne", r"\neq"}:
        return StatementRole(OTHER, "no equation")
    words = item.lead[-30:] if item.typed.inline else item.before
    claimed = last_cue("claim", words) > last_cue("suppose", words)
    supposed = cue("suppose", item.before[:12])
    if supposed or not (claimed or (not item.typed.inline and cue("claim", item.tail))):
        why = "an inequality that is supposed"
        return StatementRole(ASSUMPTION, why, "inequality", tuple(item.names))
    return StatementRole(CLAIM, "an inequality that is claimed", "inequality")


# -- what sets up the mathematics --------------------------------------------------------


def law(item: SourceStatement, known: Known) -> StatementRole | None:
    """The equations of motion."""
    found = known.law_of(item)
    if found is None:
        return None
    which = "a closed set of rates" if found is known.laws[0] else "a closed set of other rates"
    return StatementRole(LAW, f"belongs to {which}")


def unit(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""The imaginary unit, as :math:`i^2=-1`, and another time, as :math:`\tau=it`."""
    match item.members:
        case (Power(Name("i"), Number(2)), Number() | Negative(Number())):
            return StatementRole(NOTATION, "says what the imaginary unit is", "unit", ("i",))
        case (Name(name), right) if name in known.paper.times and "t" in right.names():
            return StatementRole(DEFINITION, f"gives another time {name}", "clock")
    return None


def bracket(item: SourceStatement, known: Known) -> StatementRole | None:
    """Poisson brackets of variables, before anything is claimed of them."""
    if len(item.members) == 2 and isinstance(left := item.members[0], PoissonBracket):
        inner = left.children()
        names = [one.name for one in inner if isinstance(one, Name)]
        letters = all(known.moves(name) or name.endswith(("_i", "_j")) for name in names)
        if len(names) == 2 and letters and not any(map(known.is_defined, names)):
            heads = item.printed.heads.names
            if heads and heads[0] not in known.definitions:
                return StatementRole(
                    DEFINITION, "first with this bracket of variables", "", heads[:1]
                )
    return None


def unjudged(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is denied, quoted or asked, and what holds approximately."""
    if said := cue("denied", _clause(item)):
        return StatementRole(
            OTHER, f"“{said}” stands beside it: it is not claimed as printed", "denied"
        )
    if said := cue("quoted", _clause(item)):
        return StatementRole(OTHER, f"“{said}” stands beside it: others claim it", "quoted")
    if item.after.endswith("?") or known.paper.prose.text[: item.sentence[1]].rstrip()[-1:] == "?":
        return StatementRole(OTHER, "it is asked, not claimed", "asked")
    return None


def definition(item: SourceStatement, known: Known) -> StatementRole | None:
    """A name that nothing has defined, alone on a side."""
    fresh = [n for n in item.printed.heads.names if _is_fresh(n, item, known)]
    if not fresh:
        return None
    heads = {head(name)[0] for name in fresh}
    others = [
        m for m in item.members if getattr(m, "name", getattr(m, "function", "")) not in heads
    ]
    if not any(known.is_known(n) for n in item.names - {*fresh}) and _is_number(others):
        return StatementRole(ASSUMPTION, "gives a number for a name", "value", tuple(fresh))
    if cue("if", item.lead):
        return StatementRole(ASSUMPTION, "supposed in its sentence", "set", tuple(fresh))
    if len(others) == 1 and isinstance(others[0], Derivative) and not _is_law_left(item):
        return StatementRole(LEVEL, f"names the rate {_plain(fresh[0])}", "", tuple(fresh))
    role = _integral_that_defines(item, known, fresh)
    if role is not None:
        return role
    if len([m for m in others if not isinstance(m, Name | Constant)]) > 1:
        why = f"a chain of equalities; it names {_plain(fresh[0])}"
        return StatementRole(CLAIM, why, "identity", (*fresh,))
    named = [m for m in others if isinstance(m, Name) and known.varies(m.name)]
    if named and item.members and item.members[0] == named[0]:
        return StatementRole(
            LEVEL, f"names the value {_plain(fresh[0])} of {_plain(named[0].name)}", "", (*fresh,)
        )
    if (
        named == []
        and not isinstance(item.members[0], Name)
        and len(others) == len(item.members) - 1
    ):
        if known.varying(item.names - {*fresh}) and not isinstance(item.members[0], PoissonBracket):
            return StatementRole(LEVEL, f"names the value {_plain(fresh[0])}", "", (*fresh,))
    return StatementRole(
        DEFINITION, f"first with {_plain(fresh[0])} alone on a side", "", tuple(fresh)
    )


def repeated(item: SourceStatement, known: Known) -> StatementRole | None:
    """What has been said before, sign for sign, to name something."""
    for one, role in known.roles.items():
        if role.name in NAMING and one.formula == item.formula and one.order < item.order:
            if role.name != CLAIM or item.typed.inline:
                return StatementRole(NOTATION, f"said before, at {one.printed.place}")
    return None


def change(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""New names for the parts of what moves, as :math:`v=v_0+\zeta`."""
    first = item.bare[0] if item.bare and item.members[0] == Name(item.bare[0]) else ""
    new = [name for name in item.names if not known.is_known(name)]
    said = cue("suppose", item.lead) or cue("define", item.lead)
    if first and new and said and not item.derives:
        if known.moves(known.names.whole(first)) or first.endswith("_i"):
            return StatementRole(DEFINITION, f"gives {_plain(first)} by what is new", "change")
    return None


def square(item: SourceStatement, known: Known) -> StatementRole | None:
    """The square of a name that nothing has defined, alone on a side."""
    fresh = [n for n in item.printed.heads.squares if _is_fresh(n, item, known)]
    if not fresh or not known.varying(item.names - {*fresh}):
        return None
    claimed = _integral_words(item) if item.members[0] != Power(Name(fresh[0]), Number(2)) else ""
    if claimed:
        return StatementRole(
            CLAIM,
            f"“{claimed}” stands before it; it names {_plain(fresh[0])}",
            "integral",
            (*fresh,),
        )
    return StatementRole(
        DEFINITION,
        f"first with the square of {_plain(fresh[0])} alone on a side",
        "square",
        (*fresh,),
    )


def assumption(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is supposed of constants, in force to the end of the section."""
    if not item.members or item.derives or known.varying(item.names - {*item.bare}):
        return None
    names = [name for name in item.bare if not known.varies(name)]
    moving = [name for name in item.bare if known.moves(name)]
    supposing = _supposing(item)
    if moving and supposing and _is_number(m for m in item.members if not isinstance(m, Name)):
        if cue("invariant", item.words) or cue("equilibrium", item.words):
            return None
        words = f"“{supposing}” supposes it of what moves"
        return StatementRole(ASSUMPTION, words, _reach(item), tuple(moving))
    if known.varying(item.names) or not item.names:
        return None
    if not names and not supposing:
        return None
    values = all(_is_value(m) for m in item.members)
    if supposing or (names and (item.typed.inline or values)):
        brief = cue("for", item.before) or cue("if", item.lead)
        lasting = cue("lasting", item.before)
        where = "of the sentence" if item.typed.inline and brief and not lasting else ""
        why = f"“{supposing}” supposes it" if supposing else "gives a constant that was seen before"
        return StatementRole(ASSUMPTION, why, where, tuple(names) or tuple(sorted(item.names)))
    return None


# -- what is claimed ---------------------------------------------------------------------


def approximate(item: SourceStatement, known: Known) -> StatementRole | None:
    """What holds approximately: it is not judged."""
    if item not in known.paper.approximate or not item.members:
        return None
    return StatementRole(CLAIM, "the words before say that it holds approximately", "approximate")


def solution(item: SourceStatement, known: Known) -> StatementRole | None:
    """A variable as a function of the time: a solution is claimed."""
    moving = [name for name in item.bare if known.moves(name)]
    timed = item.names & {"t"} or any(isinstance(member, Constant) for member in item.members)
    if moving and timed:
        return StatementRole(
            CLAIM, f"gives {_plain(moving[0])} by the time", "solution", (moving[0],)
        )
    return None


def value(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""A value that is supposed of a function, as :math:`(\alpha,\alpha)=1`."""
    said = cue("suppose", item.lead)
    if len(item.members) != 2 or item.derives or not said or not item.typed.inline:
        return None
    left, right = item.members
    if _is_number([right]) and known.varying(left.names()) and not cue("invariant", item.words):
        return StatementRole(ASSUMPTION, f"“{said}” supposes it of what moves", _reach(item))
    return None


def rate(item: SourceStatement, known: Known) -> StatementRole | None:
    """Rates after the law: of a known function, and of variables once more."""
    if not item.derives:
        return None
    if ZERO in item.members and len(item.members) == 2:
        other = next(m for m in item.members if m != ZERO)
        if isinstance(other, Derivative):
            inner = other.argument
            if isinstance(inner, Name) and known.moves(inner.name) and _set_beside(item, known):
                return StatementRole(CLAIM, "one of the equations of a set", "invariant")
            return StatementRole(CLAIM, "a rate that vanishes", "integral")
    return None


def zero_set(item: SourceStatement, known: Known) -> StatementRole | None:
    """Equations of a set: what vanishes, or has a value, without being so identically."""
    if not item.members or item.derives:
        return None
    if ZERO in item.members and (said := cue("invariant", item.words)):
        if len(item.members) == 2 and known.varying(item.names):
            return StatementRole(CLAIM, f"“{said}” in its sentence", "invariant")
    values = [m for m in item.members if _is_value(m) and not known.varying(m.names())]
    others = [m.name for m in item.members if isinstance(m, Name) and known.varies(m.name)]
    if not values or len(others) < len(item.members) - len(values) or not others:
        return None
    if all(map(known.moves, others)) or ZERO in values:
        said = cue("invariant", item.words) or cue("equilibrium", item.words)
        if said and (all(map(known.moves, others)) or cue("invariant", item.words)):
            return StatementRole(CLAIM, f"“{said}” in its sentence", "invariant")
        return StatementRole(ASSUMPTION, "a set that the text speaks of", _reach(item))
    return StatementRole(CLAIM, "a value that is taken somewhere", "somewhere")


def integral(item: SourceStatement, known: Known) -> StatementRole | None:
    """What words call an integral, or constant."""
    if not item.members:
        return None
    if any(isinstance(member, Constant) for member in item.members):
        return StatementRole(CLAIM, "“const” stands at its end", "constant")
    assert isinstance(item.formula, Relation)
    if (said := _integral_words(item)) and _is_level(item, known):
        return StatementRole(CLAIM, f"“{said}” stands beside it", "integral")
    return None


def identity(item: SourceStatement, known: Known) -> StatementRole | None:
    """What else is printed as an equation, of names that are known."""
    return (
        StatementRole(CLAIM, "an equation between what is known", "identity")
        if item.members
        else None
    )


def other(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is left."""
    return StatementRole(OTHER, "nothing is stated")


RULES: tuple[Rule, ...] = (
    unread, expression, inequality, law, unit, bracket, unjudged, repeated, change, definition,
    square, solution, assumption, value, approximate, rate, zero_set, integral, identity, other,
)  # fmt: skip
"""The rules, in the order in which they are asked."""


# -- parts of rules ------------------------------------------------------------------------


def _clause(item: SourceStatement) -> str:
    """The words right around a statement."""
    return f"{item.lead[-60:]} § {item.tail[:30]}"


def _is_fresh(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether nothing has said yet what a name is."""
    function, arguments = head(name)
    if function == BRACKET:
        return False
    if found := known.definitions.get(function) or known.definitions.get(
        known.names.whole(function)
    ):
        unclear = any(not known.is_explained(n) for one in found for n in one.names)
        return unclear and all(known.is_explained(n) for n in item.names)
    if known.moves(function) or function in known.paper.times:
        return False
    alone = (Name(function), Power(Name(function), Number(2)))
    if any(function in m.names() for m in item.members if m not in alone) and not arguments:
        return False
    others = item.names - {function, *arguments}
    new = bool(others) and not any(map(known.is_known, others))
    return (
        function not in known.seen
        or bool(cue("where", item.lead))
        or (new and not item.typed.inline)
    )


def _called(formula: Formula) -> str:
    """The name that a formula is, or of whose values it is one."""
    if isinstance(formula, Application):
        return formula.function
    return formula.name if isinstance(formula, Name) else ""


def _is_number(members: object) -> bool:
    found = list(members)  # type: ignore[call-overload]
    return bool(found) and all(_is_value(m) and not m.names() for m in found)


def _is_value(formula: Formula) -> bool:
    """Whether a member is a number, a name, or a vector of numbers."""
    if isinstance(formula, Negative):
        return _is_value(formula.argument)
    if isinstance(formula, Vector):
        return all(map(_is_value, formula.components))
    return (
        not any(isinstance(n, Derivative) for n in formula.nodes()) and len([*formula.nodes()]) <= 5
    )


def _reach(item: SourceStatement) -> str:
    """How far it reaches what is supposed of what moves."""
    if cue("here", f"{item.before} "):
        return "set of the sentence"
    return "set in force" if cue("suppose", item.lead) else "set"


def _is_law_left(item: SourceStatement) -> bool:
    """Whether a rate stands on the left."""
    return isinstance(item.members[0], Derivative) and not item.typed.inline


def _supposing(item: SourceStatement) -> str:
    """The words by which something is supposed right before a statement."""
    said = cue("suppose", item.lead)
    if said:
        return said
    before = item.before.rsplit("§", 1)[0] if "§" in item.before else ""
    between = item.lead.strip(" ,;~")
    joined = between in ("", "and", "и", "or", "или", ", and")
    return cue("suppose", before) if joined and before else ""


def _integral_words(item: SourceStatement) -> str:
    """The words near a statement that call it an integral, if no other words stand between."""
    tail = _joined_tail(item)[:60]
    if not re.match(r"\s*(?:which|where|with|that)", tail) and (said := cue("integral", tail)):
        if last_cue("claim", item.lead[-30:]) < 0 or not item.typed.inline:
            return said
    return cue("integral", item.lead) or (
        cue("integral", item.before)
        if not item.typed.inline and item.lead.strip(" ,;") in ("", "and")
        else ""
    )


_AND = re.compile(r"[\s,;~]*(?:(?:and|or|и|или)[\s~]*)?(?:§[\s,;~]*(?:(?:and|or|и|или)[\s~]*)?)*")


def _joined_tail(item: SourceStatement) -> str:
    """The words behind a statement, and behind those that only a comma or “and” joins to it."""
    if not item.typed.inline:
        return item.tail
    found = _AND.match(item.after)
    joined = item.after[found.end() :] if found else item.after
    return joined.partition("§")[0]


def _integral_that_defines(
    item: SourceStatement, known: Known, fresh: list[str]
) -> StatementRole | None:
    """An integral with a name that is new: a claim, unless its rate is claimed elsewhere."""
    said = _integral_words(item)
    if not said or not known.varying(item.names - {*fresh}) or cue("where", item.lead):
        return None
    for one in known.paper.items:
        if one.order > item.order and one.order < item.order + 12 and ZERO in one.members:
            rated = [m.argument for m in one.members if isinstance(m, Derivative)]
            if any(isinstance(m, Name) and m.name in fresh for m in rated):
                return None
    return StatementRole(
        CLAIM, f"“{said}” stands beside it; it names {_plain(fresh[0])}", "integral", (*fresh,)
    )


def _is_level(item: SourceStatement, known: Known) -> bool:
    """Whether an equation gives a function a value."""
    fixed = [m for m in item.members if not known.varying(m.names())]
    return (bool(fixed) and len(fixed) < len(item.members)) or "\\equiv" in getattr(
        item.formula, "signs", ()
    )


def _set_beside(item: SourceStatement, known: Known) -> bool:
    """Whether a statement stands beside another one that vanishes, in the same display."""
    beside = [one for one in known.paper.items if one.typed is item.typed and one is not item]
    return any(ZERO in one.members for one in beside)


def _plain(name: str) -> str:
    return to_plain(Name(name)) if not head(name)[1] else head(name)[0]
