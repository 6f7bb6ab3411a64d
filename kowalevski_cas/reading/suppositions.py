"""What a paper supposes: of constants, of what moves, and by inequalities."""

from __future__ import annotations

import re

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Number,
    PoissonBracket,
    Power,
    Product,
    Relation,
    Vector,
)
from kowalevski_cas.paper.signs import is_inequality
from kowalevski_cas.reading.clauses import is_in_brackets
from kowalevski_cas.reading.cues import cue, last_cue
from kowalevski_cas.reading.fresh import is_place_of
from kowalevski_cas.reading.hypotheses import set_right_before
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    DEFINITION,
    NAMED_LEVEL,
    OTHER,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.phrases import (
    IMPLIES,
    PUT,
    is_number,
    is_value,
    joined_lead,
    joined_tail,
    reach,
    reach_of_constants,
    supposing,
)
from kowalevski_cas.reading.statements import SourceStatement, derived_names

OTHERWISE = "another value of what is given before"
"""Why a value is claimed that is supposed nowhere."""


_ALWAYS = re.compile(
    r"\b(?:always|evidently|clearly|obviously|всегда|очевидно)[\s,~]*$", re.IGNORECASE
)
_SINCE = re.compile(r"[\s,~]*(?:since|because|as|так\s+как|поскольку|ибо)\b[\s~]*$", re.IGNORECASE)
"""Words before, or behind, what is claimed of constants that are given."""


def inequality(item: SourceStatement, known: Known) -> StatementRole | None:
    """What says that something is larger, or is not; of what moves it is claimed, as a rule."""
    if item.members:
        return None
    assert isinstance(item.formula, Relation)
    if why := _is_no_statement(item, known):
        return StatementRole(OTHER, why)
    conditioned = _IN_CONDITION.fullmatch(item.before) is not None
    if said := _stated_under(item):
        return StatementRole(CLAIM, f"it is said when “{said.strip()}”", "condition")
    if is_inequality(item.formula) and known.varying(item.names):
        if said := cue("region", joined_lead(item)):
            return StatementRole(OTHER, f"“{said}” names a region by it")
        others = (one for one in known.paper.items if one.typed is item.typed)
        beside = not item.typed.inline and len([*others]) > 1
        deduced = item.derives and "=" in item.formula.signs and not cue("when", item.lead)
        ordered = all(isinstance(one, Name) for one in item.formula.members)
        told = item.typed.inline and ordered and not cue("claim", item.before)
        told = told or beside or bool(supposing(item)) or conditioned or _is_looked_at(item)
        supposed = not deduced and (told or _is_of_new(item, known))
    else:
        words = item.lead[-30:] if item.typed.inline else item.before
        claimed = last_cue("claim", words) > last_cue("suppose", words)
        claimed = claimed and not _is_in_apposition(item)
        claimed = claimed or (not item.typed.inline and bool(cue("claim", item.tail)))
        claimed = claimed or (cue("further", item.lead) != "" and not supposing(item))
        claimed = claimed or _is_said_not_to_vanish(item, known)
        given = any(known.is_defined(name) for name in item.names)
        claimed = claimed or (given and bool(_ALWAYS.search(item.lead) or _SINCE.match(item.tail)))
        if not claimed and _is_concluded(item):
            why = "an inequality that words say to be found"
            return StatementRole(CLAIM, why, "inequality", found=True)
        begun = bool(cue("suppose", item.before[:12])) and not cue("claim", item.lead)
        begun = begun or conditioned
        supposed = begun or not claimed or _says_first(item, known)
        if not supposed and {*item.formula.signs} & {r"\ll", r"\gg"}:
            return StatementRole(OTHER, "how small something is")
    if supposed:
        why = "an inequality that is supposed"
        return StatementRole(ASSUMPTION, why, "inequality", tuple(sorted(item.names)))
    return StatementRole(CLAIM, "an inequality that is claimed", "inequality")


_FOR_SOME = re.compile(
    r"\b(?:where|with|if|when(?:ever)?|unless|provided|for|since|because|as|at|on|such\s+that|which|where|whose"
    r"|где|если|когда|при|так\s+как|для)\b[^§]*$",
    re.IGNORECASE,
)
"""How words end behind which something is said of what they speak of."""


def _is_said_not_to_vanish(item: SourceStatement, known: Known) -> bool:
    """Whether a rate, or a bracket, is said not to be zero, and no words suppose it."""
    assert isinstance(item.formula, Relation)
    bracket = any(isinstance(node, PoissonBracket) for node in item.formula.nodes())
    nonzero = {*item.formula.signs} <= {r"\ne", r"\neq"} and bool(known.varying(item.names))
    told = supposing(item) or _FOR_SOME.search(item.lead)
    return nonzero and (item.derives or bracket) and not told


_COMPARING = {"<", ">", r"\ll", r"\gg", r"\le", r"\ge", r"\leq", r"\geq", r"\ne", r"\neq"}


def _is_no_statement(item: SourceStatement, known: Known) -> str:
    """Why what compares nothing, or only says of what something is said, states nothing."""
    assert isinstance(item.formula, Relation)
    signs = {*item.formula.signs}
    if not signs & _COMPARING:
        return "no equation"
    if signs & {r"\ll", r"\gg"} and known.varying(item.names):
        return "how small something is where it moves"
    aside = known.varying(item.names) and _is_in_apposition(item)
    return "stands in apposition: it says of which something is said" if aside else ""


def _is_in_apposition(item: SourceStatement) -> bool:
    return item.typed.inline and bool(_IN_APPOSITION.search(f"{item.lead}§{item.tail}"))


_IN_CONDITION = re.compile(
    r"\W*(?:if|when|suppose|assume|если|когда|пусть)\b(?:[^,;.:§]|§(?!\s*$))*\b(?:and|и)\s*",
    re.IGNORECASE,
)
"""What stands before the second condition of a sentence that begins with one."""


_IN_APPOSITION = re.compile(
    r"[^\W\d_]{3,}[\s~]*,[\s~]*§[\s~]*,[\s~]*"
    r"(?:is|are|was|has|have|does|do|can|cannot|remains?|becomes?|loses?|oscillates?|moves?"
    r"|(?:не\s+)?(?:явля|име[ею]т|(?:не)?устойчив|остаё?е?тся|будет|движ|колебл)\w*|ist|sind|hat|est|sont)\b"
    r"|[^\W\d_]{3,}[\s~]*\([\s~]*§[\s~]*\)[\s~]*(?:is|are|has|have|remains?|becomes?|loses?)\b",
    re.IGNORECASE,
)
"""An inequality between a noun and its verb, which are the clause without it."""
_LOOKED_AT = re.compile(
    r"\b(?:interested|interests?\s+us|concerned|confin\w+|limit\s+\w+sel\w+|deal|study|look(?=\s+(?:\w+\s+)?at\b)"
    r"|интересу\w+|рассматрива\w+|ограничи\w+|изуча\w+|betracht\w+|interessier\w+|beschr\w+|int\S+ressons|bornons)\b"
    r"(?P<at>(?:[\s~]|(?!(?:and|that|is|are|where|и|что|(?:show|prov|find|check|verif|доказ|провер)\w*)\b)\w)*)"
    r"(?P<colon>:?)[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands what is looked at."""
_ONLY = re.compile(r"\b(?:only|solely|merely|just|лишь|только|nur|seulement|uniquement)\b", re.I)


def _is_looked_at(item: SourceStatement) -> bool:
    """Whether words look at nothing but what they say, as “we study only positive solutions: §”."""
    words = joined_lead(item)
    found = _LOOKED_AT.search(words)
    only = found and (not found["colon"] or _ONLY.search(words))
    return bool(only) and not re.search(r"\b(?:not|never|не|nicht|pas)\b", words, re.IGNORECASE)


POSITIVE = "positive"
_POSITIVE = r"(?:positive|положительн\w+)"
_POSITIVE_BEFORE = re.compile(
    rf"(?<!non-)\b{_POSITIVE}\s+(?:real\s+)?(?:parameters?|constants?|numbers?|masses|coefficients?|lengths?|reals?"
    r"|постоянн\w+|параметр\w*|числ\w+|масс\w*|коэффициент\w*)[\s:~]*$",
    re.IGNORECASE,
)
_POSITIVE_BEHIND = re.compile(
    r"[\s,~]*(?:(?:are|is|be|denotes?)\s+(?:(?:all|both|given|an?|small|some|fixed|assumed|taken|to|be)\s+)*positive\b"
    r"(?![\s-]+(?:definite|for|in|at|near|only|if|when|where|on|while|unless|or)\b)"
    r"|[-—–]*\s*положительн(?:ы|а|о|ые)\b)",
    re.IGNORECASE,
)
"""How words end, or begin, beside letters of constants that are positive."""


_CLOSE = 60
"""So many signs before a letter stand words that are about it."""
_NOT_OF_THESE = re.compile(
    r"\b(?:either|neither|or|unlike|usually|generally|often|mostly|normally|typically|sometimes|или|либо|обычно"
    r"|часто)\b|\[\d|\\cite",
    re.IGNORECASE,
)
_OF = re.compile(r"\b(?:of|из)\b", re.IGNORECASE)
"""Words before letters that do not speak of these, or not of each of them."""


def is_called_positive(item: SourceStatement, known: Known) -> bool:
    """Whether words beside the letter of a constant, or its list, call it positive."""
    assert isinstance(item.formula, Name)
    if known.varies(item.formula.name) or cue("if", item.before) or cue("denied", item.words):
        return False
    before, behind = joined_lead(item), joined_tail(item)
    close = item.before[-_CLOSE:]
    if _NOT_OF_THESE.search(close):
        return False
    each = _POSITIVE_BEHIND.match(behind) and not _OF.search(close)
    return bool(_POSITIVE_BEFORE.search(before) or each)


_OF_NEW = re.compile(
    r"\b(?:the|an?|its|their)\s+(?:\w+\s+)?\w+[\s~]*$|\w{4,}[\s~]*$", re.IGNORECASE
)
"""How words end behind which the letter for a quantity is printed."""


def _is_of_new(item: SourceStatement, known: Known) -> bool:
    """Whether an inequality restricts a letter where it is first printed: “the length r > 0”."""
    assert isinstance(item.formula, Relation)
    first, *others = item.formula.members
    new = isinstance(first, Name) and first.name not in known.seen
    new = new and all(one.order >= item.order for one in known.items if first.names() & one.names)
    return new and is_number(others) and item.typed.inline and bool(_OF_NEW.search(item.lead))


_SEEN = re.compile(
    r"\b(?:see|seen|saw|finds?|found|concludes?|notes?|noted|observes?|know|known|deduces?|infers?"
    r"|follows|clear|obvious|evident|easy)\b(?:\s+(?:\w+\s+){0,3})?(?P<that>\s*\bthat\b)"
    r"|\b(?:видим|видно|заключаем|ясно|очевидно|следует|находим|заметим|получаем)(?P<что>,?\s+что)\b",
    re.IGNORECASE,
)
"""Words for what is known or found, with the conjunction behind which it stands."""
_THAT = re.compile(r"(?:,?\s*(?:\band|\bи)\s+)?\b(?:that|что)[\s,~]*$", re.IGNORECASE)


def _is_concluded(item: SourceStatement) -> bool:
    """Whether words say of an inline inequality that it is found: “we see that a > b”.

    So does a sentence that begins with “therefore”, if it supposes nothing.
    """
    if not item.typed.inline or cue("suppose", f"{item.lead} ") or _is_in_apposition(item):
        return False
    if item.lead == item.before and cue("deduced", item.lead[:14]):
        return True
    return bool(_THAT.search(item.lead) and _SEEN.search(item.before))


_STATES = re.compile(
    r"\b(?:is|are|has|have|exists?|remains?|becomes?|occurs?)\b|\bсуществу|устойчив|вещественн",
    re.IGNORECASE,
)
_OF_DOMAIN = re.compile(
    r"defin|valid|sense|regular|определен|определён|имеет\s+смысл", re.IGNORECASE
)
_BEHIND = re.compile(r"[\s,;.]*(?:$|which\b|and\b|where\b|что\b|котор|а\b|и\b)", re.IGNORECASE)


def _stated_under(item: SourceStatement) -> str:
    """The words that a displayed inequality is the condition of, as in “real motions exist for”.

    They are the main clause, with nothing behind but what is said of the condition itself. It is
    claimed that they hold under it: it is supposed of nothing else.
    """
    words, inside = item.before.rstrip(), item.typed.inline or "§" in item.before
    condition = cue("if", item.lead) or cue("for", f"{item.lead} ")
    if inside or not condition or not _BEHIND.match(item.after):
        return ""
    main = words.removesuffix(condition.strip())
    domain = _OF_DOMAIN.search(main) or cue("suppose", main) or cue("region", main)
    return main if _STATES.search(main) and not domain else ""


def _says_first(item: SourceStatement, known: Known) -> bool:
    """Whether letters are compared of which nothing has been said: it cannot be claimed of them."""
    assert isinstance(item.formula, Relation)
    said = {name for one in known.assumptions for name in one.names}
    free = not any(name in said or known.is_defined(name) for name in item.names)
    behind = any(one.typed is item.typed and one.order < item.order for one in known.paper.items)
    apart = behind and not item.typed.inline  # the words before the display are about its first
    free = free and (apart or not (cue("deduced", item.lead) or cue("then", item.lead)))
    told = bool(_SATISFY.search(item.lead))  # then they may be multiples of letters
    terms = [
        factor
        for one in item.formula.members
        for factor in (one.factors if told and isinstance(one, Product) else (one,))
    ]
    return free and all(isinstance(one, Name | Number) for one in terms)


_SATISFY = re.compile(r"\b(?:satisf\w+|obey\w*|удовлетвор\w+)[\s~]*$", re.IGNORECASE)


_CONDITION = re.compile(
    r"\b(?:conditions?|restrictions?)(?:\s+(?:of\s+\w+|is|reads))?[\s:~]*$|\b(?:услови[ея]|ограничени[ея])(?:\s+\w+)?[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which a condition on constants is displayed."""


def called_condition(item: SourceStatement, known: Known) -> StatementRole | None:
    """A condition on constants, as words call it: it is supposed where it is cited."""
    if not item.members or item.derives or item.typed.inline or supposing(item):
        return None
    given = any(not known.varies(name) for name in item.bare)
    if given or known.varying(item.names) or not (item.names and _CONDITION.search(item.lead)):
        return None
    why, names = "words call it a condition", tuple(sorted(item.names))
    return StatementRole(ASSUMPTION, why, "of the sentence", names)


def assumption(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is supposed of constants, in force to the end of the section."""
    if not item.members or item.derives:
        return None
    moving = [name for name in item.bare if known.moves(name)]
    said = supposing(item) or _where_it_is(item, known)
    if moving and said and item.typed.inline and all(map(known.moves, item.names)):
        words = f"“{said}” supposes it of what moves"  # as x=-y, between variables alone
        return StatementRole(ASSUMPTION, words, reach(item), tuple(moving))
    if known.varying(item.names - {*item.bare} - known.levels):
        return None
    others = [member for member in item.members if not isinstance(member, Name)]
    names_of = {name for member in others for name in member.names()}
    below = {inner for name in names_of for inner in known.below(name)}
    names = [name for name in item.bare if not known.varies(name) and name not in below]
    names += _squares_of_new(item, known)
    given = isinstance(others[0], Vector) if others else False
    given = given and not any(map(known.varies, names_of - known.levels))
    if moving and said and (is_number(others) or (given and is_value(others[0]))):
        if cue("invariant", item.words) or cue("equilibrium", item.words):
            return None
        words = f"“{said}” supposes it of what moves"
        return StatementRole(ASSUMPTION, words, reach(item), tuple(moving))
    if known.varying(item.names) or not item.names:
        return None
    if not names and not said:
        return None
    if not said and any(name in derived_names(one) for name in names for one in known.items):
        return None  # it is a value of a function, somewhere
    values = all(is_value(m) for m in item.members) and not any(map(known.is_defined, names))
    if said or (names and (item.typed.inline or values)):
        why = f"“{said}” supposes it" if said else "gives a constant that was seen before"
        gives = tuple(names) or tuple(sorted(item.names))
        return StatementRole(ASSUMPTION, why, reach_of_constants(item), gives)
    return None


_VALUES_OF = re.compile(
    r"\b(?:values|roots|solutions|exponents|multipliers|eigenvalues|frequencies|rates|branches"
    r"|значени(?:я|ями)|корн(?:и|ями)|показател(?:и|ями)|числ(?:а|ами)|частот(?:ы|ами))\b[^§.;]*$",
    re.IGNORECASE,
)
"""How words end behind which a list of values stands."""


def in_brackets(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""The value of a constant in brackets, for which what stands before it holds: F (a=1)."""
    match item.members:
        case (Name(name), value) if is_value(value) and is_in_brackets(item):
            if not known.varying(item.names) and not known.is_defined(name):
                why = "stands in brackets behind what it is supposed for"
                return StatementRole(ASSUMPTION, why, "of the sentence", (name,))
    return None


def otherwise_given(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""The value that words deduce for a name of constants that was given: so it is claimed.

    Supposed, as :math:`D=0` behind :math:`D=1-a`, it would say silently what the constants are.
    """
    match item.members:
        case (Name(name), value) if is_value(value) and not known.varying(item.names):
            defined = (known.roles.get(one) for one in known.definitions.get(name, ()))
            given = any(role is not None and role.name == DEFINITION for role in defined)
            before = f"{item.before} "
            if given and not supposing(item) and (cue("deduced", before) or cue("then", before)):
                return StatementRole(CLAIM, OTHERWISE, "identity")
    return None


def one_of_several(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""One of several values that a list gives a constant, as :math:`\lambda=0,\lambda=\pm a`.

    One of a law has each of them in some case.
    """
    if not _listed_with(item, known):
        return None
    if known.untied(item.bare[:1]):
        return StatementRole(OTHER, "one of several values: none of them is supposed")
    return StatementRole(ASSUMPTION, "one of several values", "of the sentence", item.bare[:1])


def _listed_with(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """The list of several values of one constant of which a statement is one; empty of others.

    The two signs of one value are several where words speak of values, and no law has the letter.
    """
    if len(item.members) != 2 or not isinstance(name := item.members[0], Name):
        return []
    if is_in_brackets(item):
        return []
    if known.varies(name.name) or known.is_defined(name.name):
        return []
    words = _before_list(item)
    values = [
        one
        for one in known.of_sentence(item.sentence)
        if one.members[:1] == (name,) and len(one.members) == 2 and _before_list(one) == words
    ]
    several = len({one.members[1] for one in values}) > 1
    apart = len({one.span for one in values}) > 1
    numbers = apart and any(is_number(one.members[1:]) for one in values)
    told = _VALUES_OF.search(words) and (apart or known.untied([name.name]))
    return values if several and (numbers or told) else []


def _before_list(item: SourceStatement) -> str:
    """The words before a list, which may stand before each of it once more."""
    return _ONCE_MORE.sub("", joined_lead(item)).strip(" ,~").lower()


_ONCE_MORE = re.compile(r"^[\s,;~]*(?:and|or|и|или)\s+(?=\w+[\s~]*$)", re.IGNORECASE)


def in_several_cases(item: SourceStatement, known: Known) -> str:
    """The words before several values of a constant, in the sentence of another statement.

    They suppose these, or a law has the constant.
    """
    if said := _behind(item, known):
        return said
    for one in known.of_sentence(item.sentence):
        own = _listed_with(one, known) if one is not item else []
        if own and item not in own:
            words = f"{_before_list(one)} "
            if said := cue("suppose", words):
                return said
            if not known.untied(one.bare[:1]):
                return words.strip()
    return ""


_SUPPOSES = re.compile(r"\b(?:for|if|when|при|если|когда)[\s~]*$", re.IGNORECASE)
_NOT = re.compile(r"\b(?:not|no|fails?|unless|не|нет)\b", re.IGNORECASE)


def _behind(item: SourceStatement, known: Known) -> str:
    """The words before the second of two values of a constant that stand right behind a statement.

    As in “F is an integral for a=1 and for a=2”.
    """
    met: dict[str, Formula] = {}
    for one in known.of_sentence(item.sentence):
        if one.order <= item.order:
            continue
        match one.members:
            case (Name(name), value) if is_number([value]) and not known.varies(name):
                words = _SUPPOSES.search(one.lead)
                if words is None or _NOT.search(one.lead):
                    return ""
                if met.setdefault(name, value) != value:
                    return words[0].strip()
            case _:
                return ""
    return ""


def _where_it_is(item: SourceStatement, known: Known) -> str:
    """The words that give a place of which the sentence names the coordinate just before."""
    before = [one for one in known.of_sentence(item.sentence) if one.order < item.order]
    named = any(is_place_of(name, one, known) for name in item.names for one in before)
    return cue("where", item.lead) if named else ""


_AT_PLACE = re.compile(r"[\s~]*(?:at|when|where|for|при|в)[\s~]*", re.IGNORECASE)


def of_place(item: SourceStatement, known: Known) -> StatementRole | None:
    """A number for a name at one for another name, as “with x=0 at y=0”: so it is there only.

    If it were supposed, what is printed behind would hold because both sides vanish.
    """
    if not item.typed.inline or not _is_number_of_name(item):
        return None
    if known.moves(item.bare[0]) and (said := _AT_TIME.match(item.tail)):
        return StatementRole(OTHER, f"“{said[0].strip()}”: nothing is supposed at other times")
    for one in known.items:
        first, second = sorted((one, item), key=lambda each: each.order)
        near = one.sentence == item.sentence and second.order == first.order + 1
        if near and one.typed.inline and _is_number_of_name(one):
            if _AT_PLACE.fullmatch(first.tail) and _AT_PLACE.fullmatch(second.lead):
                return StatementRole(OTHER, "a value at one place: nothing is supposed elsewhere")
    return None


_AT_TIME = re.compile(
    r"[\s~]*(?:(?:at|for)\s+(?:some|one|an?|a\s+(?:given|certain|single)|the\s+(?:initial|first))\s+(?:moment|instant|time)"
    r"|(?:initially|at\s+(?:the\s+)?(?:beginning|start|first))\b|в\s+(?:\w+\s+)?момент|вначале|сначала)",
    re.IGNORECASE,
)
"""How words begin behind what is so at one time."""


def _is_number_of_name(one: SourceStatement) -> bool:
    members = one.members
    return len(members) == 2 and isinstance(members[0], Name) and is_number(members[1:])


_CITED = r"(?![\s~]*\(?\\(?:eq|c|C|auto)?ref(?![A-Za-z]))"
"""What is supposed is not cited: what stands behind a citation is said under what it cites."""
_SOME = (
    r"\b(?:if|when|whenever|suppos\w+|assum\w+|requir(?:e|ing)|demand(?:ing)?|impos(?:e|ing)|seek|sought|impossible)\b"
    r"|\b(?:motions?|solutions?|points?|states?|moments?|instants?|times?|orbits?|trajector(?:y|ies)|curves?)"
    r"\s+(?:with|where|when|(?:at|for|in|on)\s+which|such\s+that|that\s+satisfy|satisfying)\b"
    rf"|^\W*(?:where\b|let(?=[\s~]*$)|let\s+us\s+(?:seek|suppose|assume|look|require)\b)|\b(?:conditions?|requirement)\b{_CITED}"
    rf"|\b(?:если|когда|пусть|предполож\w+|допуст\w+|невозможно|услови\w+)\b{_CITED}|\b(?:для|при|в|на)\s+котор\w+|(?:точк|движени|решени|состояни)\w+,\s+где\b"
)
_OF_SOME = re.compile(rf"(?:{_SOME})[^§,;:]*$", re.IGNORECASE)
"""How words end behind which something is supposed of some motions."""
_OF_ALL = re.compile(
    r"\bunder\s+(?:this|these|our|such|the\s+(?:same|above))\s+(?:\w+\s+)?(?:assumption|supposition|condition|requirement|hypothes[ie])s?\b"
    r"|\b(?:any|all|every|arbitrary)\s+initial\s+conditions?\b|\bпри\s+(?:этом|этих|любых)\s+(?:\w+\s+)?(?:услови|предположени)\w+",
    re.IGNORECASE,
)
"""Words for what was supposed already, or for all motions."""


def of_some_motions(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation with rates of which the clause before it says that it may hold sometimes."""
    if not item.derives or not item.members or not known.varying(item.names):
        return None
    if Number(0) in item.members and item.typed.inline and (said := IMPLIES.match(item.tail)):
        why = f"“{said[0].strip()}”: it is supposed of some motions"
        return StatementRole(ASSUMPTION, why, "set of the sentence")
    if Number(0) in item.members and item.typed.inline and (put := PUT.search(item.lead)):
        why = f"“{put[0].strip()}” supposes it of some motions"
        return StatementRole(ASSUMPTION, why, "set of the sentence")
    if Number(0) in item.members and item.typed.inline and _is_listed_with_set(item, known):
        return StatementRole(ASSUMPTION, "supposed with what stands before it", reach(item))
    said = _OF_SOME.search(_OF_ALL.sub("", item.before))
    if said is None or cue("then", said[0]) or cue("claim", said[0]):
        return None
    return StatementRole(OTHER, f"“{said[0].strip()}”: it is said of some motions", "asked")


def _is_listed_with_set(item: SourceStatement, known: Known) -> bool:
    r"""Whether a velocity vanishes in a list with the place where it does: “with q=0, dq/dt=0”."""
    before = [one for one in known.of_sentence(item.sentence) if one.order == item.order - 1]
    joined = any(one.typed is item.typed for one in before)
    joined = joined or (bool(before) and item.lead.strip(" ,~") in ("", "and", "и"))
    role = known.roles.get(before[0]) if joined else None
    placed = role is not None and role.name == ASSUMPTION and role.kind.startswith("set")
    still = [one for one in item.members if isinstance(one, Derivative)]
    names = [one.argument.name for one in still if isinstance(one.argument, Name)]
    return placed and names == [*before[0].bare[:1]] and known.moves(names[0])


def _squares_of_new(item: SourceStatement, known: Known) -> list[str]:
    r"""The constant of which the square comes first, by one that nothing has said before.

    So :math:`k^2=g/l` says what k is, wherever it stands.
    """
    squares = [
        n for n in item.printed.heads.squares if item.members[0] == Power(Name(n), Number(2))
    ]
    others = item.names - {*squares}
    deduced = cue("deduced", item.lead) or cue("then", item.lead) or cue("claim", item.lead)
    given = any(map(known.is_defined, squares)) or known.varying(item.names)
    return [] if deduced or given or all(map(known.is_known, others)) else squares


def of_levels(item: SourceStatement, known: Known) -> StatementRole | None:
    """A value that words suppose of an integral, by constants and values of others: “with k=Cn”."""
    if len(item.members) < 2 or item.derives or not item.typed.inline:
        return None
    *first, other = item.members
    names = [one.name for one in first if isinstance(one, Name)]
    if len(names) < len(first) or not {*names, *known.varying(other.names())} <= known.levels:
        return None
    said = supposing(item)
    if not said or other.names() & {*names}:
        return None
    if cue("claim", f"{item.lead.rpartition(said)[2]} "):
        return None
    why = f"“{said}” supposes it of the value of an integral"
    kind = "set in force" if cue("lasting", f"{joined_lead(item)} ") else "set of the sentence"
    if kind != "set in force" and isinstance(other, Name) and _is_new(other.name, known):
        kind = NAMED_LEVEL
    return StatementRole(ASSUMPTION, why, kind, tuple(names))


def _is_new(name: str, known: Known) -> bool:
    """Whether nothing has used a name yet, no law has it, and nothing gives it later."""
    mentioned = any(name in law.mentions for law in known.laws)
    return not (mentioned or name in known.seen or known.is_known(name) or name in known.later)


_ON_PLACE = re.compile(
    r"(?:^|[.;,]|\b(?:and|but|that|и|а))\s*(?:on|на)\s+(?:(?:the|this|each|every)\s+)?(?:\w+\s+)?"
    r"(?:plane|line|axis|surface|curve|circle|sphere|cone|cylinder|ellipsoid|hyperplane|level|separatri"
    r"|плоскост|прям|ос|поверхност|крив|окружност|сфер|конус|цилиндр|уровн|сепаратрис)\w*"
    r"(?:[\s,]*\b(?:where|on\s+which|(?:given|defined)\s+by|где|на\s+котор\w+))?[\s,~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands the equation of a place where their clause holds."""
_SAYS_THERE = re.compile(
    r"[\s,~]*(?:we|one|it|there|this|the\s+\w+\s+(?:has|have|obey|satisf|is|are)|мы|имеем|получ|находим|будет)\b",
    re.IGNORECASE,
)
_BECOMES = re.compile(
    r"[\s,~]*(?:the|our|these|this|its)?\s*(?:system|equations?|motion|flow|lattice|law|систем\w+|уравнени\w+)"
    r"(?:\s+of\s+motion|\s+движения|\s*\(?\\(?:eq)?ref\{[^{}]*\}\)?)?\s+"
    r"(?:becomes?|reduces?|turns?\s+into|takes?|simplif\w+|принима\w+|сводя?тся|превраща\w+|име[ею]т\s+вид)\b",
    re.IGNORECASE,
)
"""How words begin by which equations become others at a place."""


def on_place(item: SourceStatement, known: Known) -> StatementRole | None:
    """The equation of a place where its sentence says something, as “on the plane x=y we have”.

    Where the equations become others there, what follows is about these, to the end of the section.
    """
    if not item.typed.inline or len(item.members) != 2 or item.derives:
        return None
    varying = known.varying(item.names)
    if not varying or not (said := _ON_PLACE.search(item.before)):
        return None
    if cue("level", said[0]) and not all(known.varying(one.names()) for one in item.members):
        return None  # the level of one function: how far that reaches the words tell
    becomes = _BECOMES.match(item.tail)
    if "§" in said[0] or not (becomes or _SAYS_THERE.match(item.tail)):
        return None
    words = f"“{said[0].strip(' .,;')}” supposes it there"
    reach = "set in force" if becomes else "set of the sentence"
    return StatementRole(ASSUMPTION, words, reach, tuple(varying))


_OF_THESE = re.compile(
    r"\b(?:if|when|whenever|for|suppos\w+|assum\w+|если|когда|при|предположим|допустим)"
    r"(?:,?\s+(?:that|что))?[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which it is said of which motions they speak."""


def value(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""A value that is supposed of a function, as :math:`(\alpha,\alpha)=1`, or that two agree.

    That is said of the motions of which words speak, and of no others.
    """
    said = supposing(item)
    if len(item.members) != 2 or item.derives or not said or not item.typed.inline:
        return None
    left, right = item.members
    if set_right_before(item, known):
        return None  # it is said of the set
    two = known.varying(right.names()) and bool(_OF_THESE.search(item.lead))
    if not (is_number([right]) or two) or cue("invariant", item.words):
        return None
    if known.varying(left.names()):
        return StatementRole(ASSUMPTION, f"“{said}” supposes it of what moves", reach(item))
    return None
