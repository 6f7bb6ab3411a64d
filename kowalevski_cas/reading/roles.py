"""What each statement of a paper is: one function a rule, in the order in which they are asked."""

from __future__ import annotations

import re
from collections.abc import Callable

from kowalevski_cas.notation import Name, Number, Relation
from kowalevski_cas.reading.all_roots import of_named_roots, of_roots, roots
from kowalevski_cas.reading.beginnings import beginning
from kowalevski_cas.reading.brackets import bracket_of_functions
from kowalevski_cas.reading.brackets_of_momenta import bracket_of_momenta
from kowalevski_cas.reading.canonical import energy
from kowalevski_cas.reading.compositions import gives_map
from kowalevski_cas.reading.constraints import constraint, reaction
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.definitions import (
    bracket,
    change,
    constant,
    coordinate_lines,
    definition,
    law,
    named_set,
    repeated,
    square,
    together,
    unit,
)
from kowalevski_cas.reading.fixed_points import by_steps, fixed_point
from kowalevski_cas.reading.flows import divergence, measure
from kowalevski_cas.reading.given_anew import given_anew
from kowalevski_cas.reading.idle import idle
from kowalevski_cas.reading.index_ranges import is_range
from kowalevski_cas.reading.jets import gives_derivative, special_function
from kowalevski_cas.reading.kept import kept
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    DEFINITION,
    MORE,
    NOTATION,
    OTHER,
    UNREAD,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.letters_of_vectors import members_of_spaces
from kowalevski_cas.reading.levels import level
from kowalevski_cas.reading.linear_parts import eigenvalue, linear_part, trace_or_determinant
from kowalevski_cas.reading.momenta_of_energies import momentum
from kowalevski_cas.reading.named_roots import IS_ROOT, equation_for_roots, named_root
from kowalevski_cas.reading.normalised import normalisation
from kowalevski_cas.reading.obey import said_role
from kowalevski_cas.reading.other_numbers import other_number
from kowalevski_cas.reading.partial_equations import partial_equation
from kowalevski_cas.reading.phrases import (
    DENIES_ALL,
    VERB,
    clause,
    ends_clause,
    joined_tail,
    listed_words,
    right_behind,
    right_of,
    said_again,
    said_of,
    words_of,
)
from kowalevski_cas.reading.polar import radius
from kowalevski_cas.reading.propositions import (
    approximate,
    claimed_set,
    identity,
    integral,
    point,
    rate,
    set_of_rates,
    solution,
    zero_set,
)
from kowalevski_cas.reading.rest_points import POINT, rest_point
from kowalevski_cas.reading.roots_in_words import of_roots_spoken_of, roots_in_words
from kowalevski_cas.reading.rows import is_row
from kowalevski_cas.reading.small_oscillations import OF_LINEAR_PART, small_oscillation
from kowalevski_cas.reading.solutions import constant_of_solution
from kowalevski_cas.reading.solved import solved
from kowalevski_cas.reading.statements import SourceStatement, is_dependence, is_ellipsis
from kowalevski_cas.reading.suppositions import (
    POSITIVE,
    assumption,
    called_condition,
    in_brackets,
    in_several_cases,
    inequality,
    is_called_positive,
    of_levels,
    of_place,
    of_some_motions,
    on_place,
    one_of_several,
    otherwise_given,
    value,
)
from kowalevski_cas.reading.tried import tried
from kowalevski_cas.reading.unknowns import unknown
from kowalevski_cas.reading.unprinted_systems import of_another_system, of_related_law
from kowalevski_cas.reading.which_system import of_several

_BELONGING = re.compile(
    r"\b(?:of|in|for|by|with|on|to|along|about|conjugate|corresponding|associated)[\s~]*(?:the\s+)?(?:\w+\s+){0,2}$"
)
"""How words end behind which something belongs to a name, and is spoken of itself."""

_OF_MEASURE = re.compile(
    r"\b(?:densit(?:y|ies)|measures?|volumes?|areas?|плотност\w+|мер[аыу]|объ[её]м\w*)[\s~]*$",
    re.IGNORECASE,
)
"""Words right before the density of a measure, or a form."""
_MAPSTO = re.compile(r"\([^()]*\)\s*\\mapsto\s*\([^()]*'\s*\)\s*(?:,|\.|$)")
"""What is mapped to its image, which has primes: this says that there is a map."""
_SYMBOL = re.compile(r"\s*(?:\\operatorname\s*\{\w+\}|\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)[\s.,;]*")
"""A name alone, as of a function without its argument."""
_TO_INFINITY = re.compile(r"[^=<>]*\\(?:to|rightarrow)\s*[+-]?\s*\\infty[\s.,;]*")
_NUMBERED = re.compile(r"\s*\d+\s*\^\s*(?:\\circ|\{\s*\\circ\s*\})[\s.]*")
_END_OF_PROOF = re.compile(r"\s*\\(?:(?:black)?square|Box|qed)\s*")

Rule = Callable[[SourceStatement, Known], StatementRole | None]


def role_of(item: SourceStatement, known: Known) -> StatementRole:
    """What a statement is: what a comment says, or the first rule that says something."""
    inferred = next(role for rule in RULES if (role := rule(item, known)) is not None)
    if inferred.name == CLAIM and (said := _says_else(item, inferred, known)):
        inferred = StatementRole(OTHER, said, MORE)
    prints = is_row(item) and any(map(known.moves, item.rates))
    own = inferred.name != CLAIM or inferred.kind in (*OF_LINEAR_PART, "approximate")
    other = of_related_law if prints else of_another_system
    said = "" if own else other(item, known)
    if said and not (inferred.kind == POINT and said not in item.before):
        why = f"of a law that is not printed: “{said}”"
        inferred = StatementRole(CLAIM, why, "another-law", inferred.names)
    elif inferred.name == CLAIM and (said := of_several(item, known)):
        why = f"“{said}”: of several systems, and one only would be looked at"
        inferred = StatementRole(CLAIM, why, "another-law", inferred.names)
    found = known.said.role(item)
    return inferred if found is None else said_role(found, item, inferred, known)


def _says_else(item: SourceStatement, inferred: StatementRole, known: Known) -> str:
    """Why a claim is one of means, of several cases, or of what is free of the time and has it."""
    if said := in_several_cases(item, known):
        return f"“{said}” supposes several values of a constant"
    if (said := cue("either", item.before)) and inferred.kind != "rest":
        return f"“{said.split()[0]}” leaves open whether it is this"
    timed = any(known.times & known.below(name) for name in item.names)
    words = item.lead if inferred.kind == IS_ROOT else said_of(item)
    said = cue("only if", words) or cue("in the mean", words)
    said = said or (cue("timeless", item.words) if timed else "")
    return said and f"“{said}” says another thing than is judged"


def unread(item: SourceStatement, known: Known) -> StatementRole | None:
    """What cannot be read; ranges of indices and marks at the end of proofs are no statements."""
    if is_range(item.typed):
        return StatementRole(NOTATION, "says over what an index runs")
    if _END_OF_PROOF.fullmatch(item.typed.tex):
        return StatementRole(NOTATION, "marks the end of a proof")
    if _NUMBERED.fullmatch(item.typed.tex):
        return StatementRole(NOTATION, "numbers what follows, or gives an angle")
    if item.trouble and members_of_spaces(item.typed.tex):
        return StatementRole(NOTATION, "says in which space it is")
    told = _MAPSTO.match(item.typed.tex[item.typed.tex.find("(") :]) or gives_map(item.typed.tex)
    if told and item.trouble:
        return StatementRole(DEFINITION, "says what a map takes to what")
    if is_ellipsis(item):
        return StatementRole(NOTATION, "stands for more of these")
    if item.trouble and _SYMBOL.fullmatch(item.typed.tex):
        return StatementRole(NOTATION, "a name")
    if item.trouble and _TO_INFINITY.fullmatch(item.typed.tex):
        return StatementRole(OTHER, "no equation")
    return StatementRole(UNREAD, item.trouble) if item.trouble else None


def of_other_number(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is said for another number of what a letter counts than the paper is read for."""
    said = other_number(item, known) if known.law_of(item) is None else ""
    return StatementRole(OTHER, said, "asked") if said else None


def supposed_constant(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is supposed to be constant, as in “if F is constant, then”."""
    if isinstance(item.formula, Relation) or not words_of(item, "integral"):
        return None
    said = _SUPPOSES.search(item.lead)
    why = f"“{said[0].strip()}” supposes it of some cases" if said else ""
    return StatementRole(OTHER, why, "asked") if said else None


def expression(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is no relation: a name, or an expression, of which only words state something."""
    if is_dependence(item):
        return StatementRole(NOTATION, "says on what it depends")
    if isinstance(item.formula, Relation):
        return None
    said = _called_integral(item, known)
    if isinstance(item.formula, Name) and not (said and known.varies(item.formula.name)):
        return _named_alone(item.formula.name, item, known)
    if said and known.varying(item.names):
        if role := unjudged(item, known):
            return role
        if setting := cue("another-law", item.words):
            return StatementRole(CLAIM, f"of a law that is not printed: “{setting}”", "another-law")
        if about := cue("approximate", clause(item)):
            return StatementRole(CLAIM, f"“{about}” is said of it", "approximate")
        if measure := _OF_MEASURE.search(item.lead):
            why = f"“{said}” is said of a measure: “{measure[0].strip()}”"
            return StatementRole(CLAIM, why, "form")
        if _has_differentials(item, known):
            return StatementRole(CLAIM, f"“{said}” is said of a differential form", "form")
        return StatementRole(CLAIM, f"“{said}” is said of it", "integral")
    return StatementRole(OTHER, "an expression: nothing is stated")


def _called_integral(item: SourceStatement, known: Known) -> str:
    """The words that call a name, or an expression, an integral."""
    if isinstance(item.formula, Name):
        spoken_of = VERB.match(item.tail) and not _BELONGING.search(item.lead)
        said = cue("integral", item.tail[:40]) if spoken_of else ""
        said = said or listed_words(item, "integral") or _said_before(item, known)
    else:
        said = words_of(item, "integral") or listed_words(item, "integral")
    return said or _said_again(item, known)


def _named_alone(name: str, item: SourceStatement, known: Known) -> StatementRole:
    """A letter by itself, which words may call positive."""
    if is_called_positive(item, known):
        return StatementRole(NOTATION, "a name; the words call it positive", POSITIVE, (name,))
    return StatementRole(NOTATION, "a name")


_SUPPOSES = re.compile(
    r"\b(?:suppos\w+|assum\w+|if|when(?:ever)?|provided|means?|signif(?:y|ies)|пусть|если|когда|предположим|означает)"
    r"(?:,?\s+(?:that|что))?(?:\s+(?:the|also|both|функция|величина)(?:\s+\w+)?)?[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which it is supposed that something is constant."""
_SUBJECT_BEHIND = re.compile(
    r"\bso\s+(?:is|are|does|do)\s+(?:the\s+)?(?:\w+\s+){0,2}$"
    r"|\b(?:an?|another|(?:second|third|fourth|last)\s+)\s*integral\s+is\s+(?:the\s+)?(?:\w+\s+){0,2}$"
    r"|интегралом\s+(?:является|служит|будет)\s+(?:\w+\s+){0,2}$",
    re.IGNORECASE,
)
"""How words end that say of the name behind them that it is an integral."""


def _said_before(item: SourceStatement, known: Known) -> str:
    """The words right before a name that call it an integral."""
    said = _SUBJECT_BEHIND.search(f"{item.lead} ")
    before = item.before[: said.start()] if said else ""
    if said and not before.strip() and item.earlier and said[0].lower().startswith("so"):
        return cue("integral", item.earlier[0]) if _is_said_of_all(item, known) else ""
    return cue("integral", item.before[-80:]) if said else ""


def _said_again(item: SourceStatement, known: Known) -> str:
    """The words by which what was spoken of before is an integral, and so is this one.

    What the sentence before says of some cases is said of these only.
    """
    said = said_again(item, "integral")
    return said if said in item.words or _is_said_of_all(item, known) else ""


def _is_said_of_all(item: SourceStatement, known: Known) -> bool:
    """Whether the sentence before a statement neither denies nor supposes anything."""
    words = item.earlier[0]
    before = [one for one in known.items if one.order < item.order]
    beside = known.of_sentence(before[-1].sentence) if before else ()
    supposed = any(one in known.roles and known.roles[one].name == ASSUMPTION for one in beside)
    unsure = cue("denied", words) or cue("suppose", words) or DENIES_ALL.match(words)
    return not (unsure or supposed)


def _has_differentials(item: SourceStatement, known: Known) -> bool:
    """Whether d stands before what varies, and is no name that is used elsewhere."""
    if known.is_known("d") or "d" not in item.names:
        return False
    varying = "|".join(map(re.escape, known.varying(item.names)))
    return re.search(rf"(?<![A-Za-z\\])d\s*(?:{varying})", item.printed.tex) is not None


_ONE_CLAUSE = re.compile(
    r"[,;:]|\b(?:and(?!\s+only)|but|so|hence|thus|therefore|и(?!\s+только)|но|поэтому|так\s+что)\b"
)
"""What ends a clause, but for “if and only if”."""


def unjudged(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is denied, quoted, asked or left out, and what is claimed with exceptions."""
    if said := cue("except", item.lead):
        return StatementRole(OTHER, f"“{said}” leaves it out", "excepted")
    mates = (known.roles.get(one) for one in known.of_sentence(item.sentence))
    if cue("excepted", item.after) or any(role and role.kind == "excepted" for role in mates):
        if names := _named(item, known):
            return StatementRole(DEFINITION, "named here; its sentence makes exceptions", "", names)
        return StatementRole(OTHER, "its sentence makes exceptions: it is not judged", "excepted")
    behind = "" if ends_clause(item) else _ONE_CLAUSE.split(item.tail)[0]
    if said := cue("only if", item.lead) or cue("only if", behind):
        return StatementRole(OTHER, f"“{said}” says more than is judged", MORE)
    if said := _denial(item, known):
        if names := _named(item, known):
            return StatementRole(DEFINITION, f"named here; “{said}” is said of it", "", names)
        return StatementRole(
            OTHER, f"“{said}” stands beside it: it is not claimed as printed", "denied"
        )
    if said := cue("so it is not", item.after[:80]) or _for_contradiction(item, known):
        return StatementRole(OTHER, f"“{said}” is said of it: it is not claimed", "denied")
    if said := cue("quoted", clause(item)):
        return StatementRole(OTHER, f"“{said}” stands beside it: others claim it", "quoted")
    if (
        _ASKS.search(item.lead)
        or item.after.endswith("?")
        or known.paper.prose.text[: item.sentence[1]].rstrip()[-1:] == "?"
    ):
        return StatementRole(OTHER, "it is asked, not claimed", "asked")
    return None


_HAPPENS = r"(?:takes?\s+place|occurs?|arises?|happens?|имеет\s+место|возника\w+|происходит)"
_HAPPENS_BEHIND = re.compile(rf"[\s,~]*{_HAPPENS}\b", re.IGNORECASE)
_HAPPENS_BEFORE = re.compile(
    rf"\b{_HAPPENS}(?:\s+(?:only|just|exactly|precisely|только|лишь))?\s+(?:if|when|for|at|если|когда|при)[\s:~]*$",
    re.IGNORECASE,
)


def happening(item: SourceStatement, known: Known) -> StatementRole | None:
    """What words say to happen, or on which condition something does: it is not supposed so."""
    if item.members and (_HAPPENS_BEHIND.match(item.tail) or _HAPPENS_BEFORE.search(item.lead)):
        return StatementRole(OTHER, "words say when something happens: it is not supposed", MORE)
    return None


_ASKS = re.compile(
    r"\bwhether\b[^§.;]*$|\bask\w*\s+(?:when|if)\b[^§.;]*$|,\s*ли\b[^§.;]*$", re.IGNORECASE
)
"""How words end behind which something is asked."""
_CONTRARY = re.compile(
    r"\b(?:assum|suppos)\w*,?\s+(?:(?:on|to|for)\s+)?(?:(?:the\s+)?(?:contrary|opposite|converse)|otherwise)\b"
    r"|\b(?:assum|suppos)\w*\s[^.;§]*\b(?:is|were|was)\s+(?:false|wrong|untrue|not\s+true)\b|\bargu\w+\s+indirectly\b|\breductio\b"
    r"|\b(?:пусть|допустим|предположим),?\s+(?:напротив|обратное|противное)|\bAngenommen\b[^.;§]*\b(?:anders|Gegenteil|falsch)\b"
    r"|\bsupposons\s+le\s+contraire|\bpar\s+l['’]absurde|\b(?:by|for|to\s+(?:get|obtain|reach))\s+(?:an?\s+)?contradiction"
    r"|\bот\s+противного",
    re.IGNORECASE,
)
"""Words that suppose what is to be denied."""
_CONTRADICTION = re.compile(
    r"\bcontradict\w*|\babsurd\w*|\bimpossible\b|\bпротивореч\w*|\bневозможн\w*", re.IGNORECASE
)
"""Words that deny it."""


def _for_contradiction(item: SourceStatement, known: Known) -> str:
    """The words before a statement, in its paragraph, that suppose what is denied behind it."""
    text = known.paper.prose.text
    start = max(item.paragraph, item.section.start)
    said = [*_CONTRARY.finditer(text, start, item.typed.start)]
    if not said or _CONTRADICTION.search(text, said[-1].end(), item.typed.start):
        return ""
    return said[-1][0]


_REASON = re.compile(
    r":\s*$|[,;:]\s*(?:for|since|because|as|так\s+как|поскольку|ибо|потому\s+что)\b(?P<rest>[^,;:]*)$",
    re.IGNORECASE,
)
"""How words end behind which stands why something before is so."""


def _denial(item: SourceStatement, known: Known) -> str:
    """The words beside a statement, or in the sentence behind it, that deny it, or compare it."""
    spared = _explains(item) or (_NOR.search(item.lead) and said_again(item, "integral"))
    said = "" if spared else cue("denied", _same_clause(item)) or _denied_with_others(item)
    return said or cue("compared", item.lead) or _denied_behind(item, known)


_WITH = re.compile(r"(?<=;)[^;]*\b(?:with|where|putting|при|где|полагая)[\s~$]*$", re.IGNORECASE)
"""How words end behind another clause before what is named."""


def _same_clause(item: SourceStatement) -> str:
    """The words right around a statement, without a clause before that says something of others.

    So “the momentum is not conserved; with :math:`E=T+U`” says nothing of E.
    """
    words = clause(item)
    given = _WITH.search(words.partition("§")[0])
    return words[given.start() :] if given else words


_NOR = re.compile(r"\b(?:neither|nor)\s+(?:does|do)\b[\w\s]*$", re.IGNORECASE)
"""How words end behind which stands what does not change either."""


def _denied_with_others(item: SourceStatement) -> str:
    """The words behind a list that deny all that it has."""
    behind = joined_tail(item) if item.formula is not None else ""
    return cue("denied", f"§ {right_of(behind)}") if behind != item.tail else ""


_IT = (
    r"(?:this|that|it|these|they|both|all\s+(?:of\s+)?(?:this|that)|he|she|the\s+(?:latter|former))"
    r"(?:\s+(?:claim|statement|assertion|belief|opinion|view|formula|result)s?)?"
)
_WRONG = (
    r"(?:wrong|false|incorrect|untrue|erroneous|mistaken|absurd|nonsense|not\s+(?:so|true|correct|right|the\s+case)"
    r"|an?\s+(?:\w+\s+)?(?:mistake|error|myth|misconception|misprint|fallacy|illusion))"
)
_DENIED_BEHIND = re.compile(
    r"\W*(?:(?:but|however|yet|of\s+course|in\s+fact|actually|но|однако|конечно|на\s+самом\s+деле)\b\W*)*"
    rf"(?:(?:{_IT}\s+)?(?:(?:is|are|was|were)\s+)?(?:\w+ly\s+|however,?\s+)?{_WRONG}"
    rf"|{_IT}\s+(?:does\s+not\s+hold|do\s+not\s+hold|cannot\s+be(?:\s+(?:so|true|right))?|fails?|errs?)"
    r"|(?:(?:это|они|он|вс[её]\s+это)\s+)?(?:(?:утверждени|мнени|формул)\w+\s+)?(?:\w+\s+)?"
    r"(?:неверн\w+|не\s+(?:так|верно)|ошибк\w+|ошибочн\w*|ложн\w*|заблужд\w+|неправ\w*|ошиба\w+))"
    r"(?:\s+(?:in\s+general|at\s+all|of\s+course|however|though|вообще\s+говоря|конечно))?\s*[.,;:!]",
    re.IGNORECASE,
)
"""A sentence that says of what stands before that it is false, without a condition."""


def _denied_behind(item: SourceStatement, known: Known) -> str:
    """The beginning of the sentence behind that of a statement, if this calls it false."""
    prose = known.paper.prose
    start, end = prose.sentence(item.sentence[1])
    said = _DENIED_BEHIND.match(prose.between(start, end)) if start == item.sentence[1] else None
    return said[0].rstrip(" .,;:!") if said else ""


def _explains(item: SourceStatement) -> bool:
    """Whether a rate is why the words before deny something: behind a colon, or “since”."""
    found = _REASON.search(item.lead)
    said = f"{found['rest'] or ''} § {right_behind(item)}" if found else ""
    rated = item.derives and Number(0) not in item.members
    return rated and found is not None and not cue("denied", said)


def _named(item: SourceStatement, known: Known) -> tuple[str, ...]:
    """The name that an equation gives before words say that it is not something, or not always."""
    heads = item.printed.heads.names
    new = item.bare[:1] == heads[:1] and not any(
        known.is_defined(name) or known.moves(name) for name in heads[:1]
    )
    said = VERB.match(joined_tail(item)) and not cue("denied", item.lead[-60:])
    gives = len(item.members) == 2 and (item.printed.heads.matrix or known.varying(item.names))
    return heads[:1] if heads and new and said and gives else ()


def other(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is left."""
    return StatementRole(OTHER, "nothing is stated")


def of_flow(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is said of the flow and of its points of rest, unless it is denied, quoted or asked."""
    rules: tuple[Rule, ...] = (
        divergence, measure, small_oscillation, trace_or_determinant, linear_part, rest_point,
        fixed_point,
    )  # fmt: skip
    found = next((role for rule in rules if (role := rule(item, known))), None)
    return (unjudged(item, known) or found) if found else None


RULES: tuple[Rule, ...] = (
    unread, of_other_number, beginning, idle, eigenvalue, of_flow, supposed_constant,
    expression, named_set, coordinate_lines, law, partial_equation, radius, solved, constraint,
    reaction, together, unit, bracket_of_momenta, bracket, bracket_of_functions, unjudged,
    inequality, of_named_roots, roots_in_words, happening, kept, unknown, repeated,
    gives_derivative, special_function, change, roots, by_steps, claimed_set, point, tried,
    of_roots_spoken_of, solution, constant_of_solution, energy, momentum, named_root,
    normalisation, of_place, on_place, of_levels, in_brackets, one_of_several, of_roots,
    otherwise_given, constant, definition, given_anew, square, called_condition, assumption, value,
    approximate, set_of_rates, of_some_motions, rate, zero_set, level, integral,
    equation_for_roots, identity, other,
)  # fmt: skip
"""The rules, in the order in which they are asked."""
