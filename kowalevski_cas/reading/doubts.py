"""How sure it is that a claim was meant as it was read: only what is sure can be red."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence, Set
from dataclasses import replace

from kowalevski_cas.notation import Derivative, Name, Number, PoissonBracket, Power, Relation, Root
from kowalevski_cas.notation.layout import EITHER_SIGN
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.paper.implied import HAMILTONIANS, LAGRANGIANS
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.reading.beginnings import gives_velocity
from kowalevski_cas.reading.canonical import MOMENTUM
from kowalevski_cas.reading.compositions import is_of_maps
from kowalevski_cas.reading.cues import cue, cues
from kowalevski_cas.reading.hypotheses import EQUATIONS, has_unit_vector_under_products
from kowalevski_cas.reading.inertia import INERTIA
from kowalevski_cas.reading.kept import kept_before
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    BEGINNING,
    CLAIM,
    DEFINITION,
    LAW,
    NAMED_LEVEL,
    SETS,
    Known,
)
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.linear_parts import KIND as EIGENVALUE
from kowalevski_cas.reading.linear_parts import MATRIX
from kowalevski_cas.reading.measures import differentials_of_images
from kowalevski_cas.reading.named_values import CALLED_ENERGY
from kowalevski_cas.reading.normalised import is_of_other_parameter
from kowalevski_cas.reading.obey import SAID
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.permuted import has_more_rows
from kowalevski_cas.reading.phrases import AT_TIMES, integral_words, is_conditional
from kowalevski_cas.reading.rest_points import MARKED, POINT
from kowalevski_cas.reading.rows import is_row
from kowalevski_cas.reading.rung import Rung
from kowalevski_cas.reading.small_oscillations import OF_LINEAR_PART, may_be_of_squares
from kowalevski_cas.reading.statements import SourceStatement, is_numerical
from kowalevski_cas.reading.suppositions import OTHERWISE
from kowalevski_cas.reading.unprinted import SOURCE, is_printed
from kowalevski_cas.reading.variations import is_power_of_difference
from kowalevski_cas.reading.varied_laws import is_varied

_INDEXED = re.compile(r"_\{?[ijk]\b")
_ANOTHER = re.compile(
    r"\b(?:an?other|other|second|third|twice|half)\b|\b(?:друг\w+|втор\w+|трет\w+|вдвое)\b",
    re.IGNORECASE,
)
_NUMBERED = re.compile(r"_\{?\d")


_SMALL = re.compile(r"\\(?:to|rightarrow|ll|approx|simeq)(?![A-Za-z])")
"""The signs of limits, and of approximations."""
_UNEQUAL = frozenset({r"\ne", r"\neq"})
_MEANS = (
    r"(?!§|\(|\\|\d|(?:this|that|th[eo]se|all|any|every|each|both|our|its|their|which|what|it|them|arbitrary|general"
    r"|particular|fact|view|virtue|accordance|agreement|analogy|addition|turn|short|order|terms|other\s+words|effect"
    r"|example|instance|brevity|convenience|simplicity|definiteness|account|substitut\w+|differentiat\w+|inserting|using"
    r"|an?\s+(?:similar|word|way|frame|donc|alors|ainsi)|obtient|trouve|voit|(?:the\s+)?(?:\w+\s+)?(?:notations?|variables?|coordinates?|forms?|components?|paper"
    r"|sections?|theorem|lemma|proof|equations?|sequel|functions?|derivatives?|rates?|integrals?|quantit(?:y|ies)|sake"
    r"|expressions?|energy|hand|other|sides?|flow|left|right|same|following|usual|first|second|third"
    r"|quadrant|octant|domain|region|half-?(?:plane|space)|phase)"
    r"|силу|результате|частности|итоге|помощи|виде|этом\s+виде|люб\w+|все\w*|кажд\w+)\b)"
)
"""What stands here behind a preposition is no circumstance, but a means, or all that there is."""
_CIRCUMSTANCE = re.compile(
    r"(?:^|[.;:]|,|\b(?:has|have|is|are|име[ею]т)\b)\W*(?:(?:hence|so|thus|therefore|then|consequently|finally|but|and|now|also|even|отсюда|следовательно"
    r"|поэтому|значит|итак)\W+)*"
    r"(?:(?:at|under|during|near|without|inside|outside|while|as\s+(?:long|soon)\s+as|once|until|before|after|between)\s+"
    r"(?!least|last|first\s+(?:sight|glance)|once|this|these|any|all|every|each|the\s+same|which|the\s+flow)"
    r"|(?:if|when|whenever|если|когда|wenn|falls|si|lorsque|quand)\s+(?!we\b|one\b)[^,.;]+,"
    r"|(?:neglect|ignor|disregard|omitt|пренебрег)\w+|(?:initially|momentarily|sometimes|вначале|иногда|anfangs)\b"
    rf"|(?:in|on|for)\s+{_MEANS}|(?:в|на|при|для)\s+{_MEANS}(?=\w)"
    r"|(?:im|bei|beim|am|ohne|sans|dans|aux?|à)\s+(?!d(?:ie|en|em)\s+Gleichung|allgemeinen)|à\s*l['’])[^§.]*(?:§[^§.]*)*$",
    re.IGNORECASE,
)
"""How the words before an equation begin that say when, or where, it is so."""
_IN_STATE = re.compile(
    r"\b(?:is|are|stays?|remains?|lies?)\s+(?:\w+\s+){0,2}at\s+rest\b[^\w§]*$"
    r"|(?:^|[.;:,])[^§.;:,]*\bbeing\s+(?:equal|alike|the\s+same|zero|small|large|absent|at\s+rest)\b[^§.;:]*,[^§.;:]*$"
    r"|\b(?:покоится|в\s+покое|неподвиж\w+)\b[^\w§]*$",
    re.IGNORECASE,
)
"""How they end if they say in which state something is."""
_AT_THAT = re.compile(
    r"[\s,~]*(?:there\b(?!\s+(?:is|are|exist))|at\s+(?:this|that|these|those)\s+(?:moment|instant|time|point|place|position)s?"
    r"|in\s+(?:this|that)\s+(?:position|state|motion|case)|(?:if|when|whenever|provided|near|on)\b|twice\b|once\b"
    r"|(?:means?|implies|requires?|is\s+(?:equivalent|possible|satisfied))\b"
    r"|в\s+(?:этот\s+момент|этой\s+точке|этом\s+положении)|(?:если|когда)\b)",
    re.IGNORECASE,
)
"""How words begin behind an equation that say so."""


def _has_circumstance(item: SourceStatement) -> bool:
    """Whether words say when, or where, an equation holds, and no equation that was read does."""
    said = _CIRCUMSTANCE.search(item.before) or _IN_STATE.search(item.before)
    said = said or _AT_THAT.match(item.tail)
    return bool(said or cue("on it", item.words))


def doubt_of(
    item: SourceStatement, rung: Rung, candidates: Sequence[Rung], parts: Parts
) -> Doubt | None:
    """How a claim may have been meant otherwise; ``None`` if it is sure.

    ``candidates`` are all claims that the statement may make.
    """
    known = parts.of(item)
    role, roles = parts.roles[item], parts.roles.values()
    fixed = (member for member in item.members if not known.varying(member.names()))
    if role.kind == "identity" and not item.derives and any(fixed):
        return Doubt.ALWAYS
    if (
        role.kind in ("solution", "energy", MATRIX, POINT, MARKED)
        or role.found
        or rung.claim.scene.jets  # words may say which functions are meant
        or _is_unequal(item)
        or _has_momentum(rung, known)
        or _is_in_coordinates_of_words(rung, known)
        or _is_called_real(rung, known)
        or _is_bracket_elsewhere(item, known)
        or _has_reaction(rung, item, known)
        or has_unit_vector_under_products(known)
        or any(map(has_more_rows, known.laws))
        or parts.is_averaged(item)
        or kept_before(item, known)
        or any(role.kind == CALLED_ENERGY and {*role.names} & item.names for role in roles)
    ):
        return Doubt.ALWAYS
    if role.kind in OF_LINEAR_PART and may_be_of_squares(item, known):
        return Doubt.ALWAYS
    if role.kind == SAID:
        return None
    if role.kind == "identity" and (_is_of_a_motion(item, known) or _has_one_of_signs(item)):
        return Doubt.ALWAYS
    if is_varied(item, known) or is_of_other_parameter(item, known):
        return Doubt.ALWAYS
    told = item.derives or role.kind in ("identity", "constant", "integral")
    read = any(one.sentence == item.sentence for one in rung.on)  # a condition beside the claim
    if told and not (rung.given or read) and _has_circumstance(item):
        return Doubt.ALWAYS
    if _is_said_elsewhere(item, known) or _stands_apart(item, rung, candidates, known):
        return Doubt.ALWAYS
    if item in known.apart or (role.kind not in ("integral", EIGENVALUE) and not item.derives):
        return Doubt.UNLESS_MENDED
    return None if _is_sure(item, rung, candidates, parts) else Doubt.UNLESS_MENDED


def _is_unequal(item: SourceStatement) -> bool:
    """Whether something is said not to be zero: it may be meant that it is not so always."""
    return isinstance(item.formula, Relation) and {*item.formula.signs} <= _UNEQUAL


def _is_bracket_elsewhere(item: SourceStatement, known: Known) -> bool:
    """Whether a statement gives a bracket of names that another section gives: it may be new."""
    match item.members[:1]:
        case (PoissonBracket(Name(), Name()),):
            given = [
                one
                for head, own in known.definitions.items()
                for one in own
                if head.startswith(BRACKET) and one.members[:1] == item.members[:1]
            ]
            return bool(given) and all(one.section is not item.section for one in given)
    return False


_REACTIONS = ("N", "R", "T", "S")


def _has_reaction(rung: Rung, item: SourceStatement, known: Known) -> bool:
    """Whether a force stands in a claim that is given by an equation which is none of motion."""
    letters = {*rung.claim.scene.constants} & {*_REACTIONS}
    others = (one for one in known.items if one is not item and one.members and not one.derives)
    return any(
        letters & one.names and known.roles[one].name == CLAIM and len(one.names) > 1
        for one in others
    )


def _is_said_elsewhere(item: SourceStatement, known: Known) -> bool:
    """Whether words, or signs, leave open of what a statement is made, or by which law."""
    printed = known.paper.expanded.text[item.typed.start : item.typed.end]
    return (
        _is_unread_summary(item, known)
        or item in known.paper.approximate
        or known.roles[item].kind == "approximate"
        or item.typed.start in known.paper.orbits
        or ({"dot", "prime"} <= item.marks and not known.clocks)  # the prime of another frame
        or (
            known.roles[item].kind == "identity"
            and not item.derives
            and bool(cue("lasting", item.lead))
        )
        or _is_of_another(item, known)
        or _is_not_deduced(item, known)
        or is_of_a_place(item, known)
        or bool(cue("ideal case", item.words))
        or _is_of_what_is_left(item, known)
        or _is_below_other_rates(item, known)
        or _is_below_other_energy(item, known)
        or _is_before_its_law(item, known)
        or _is_below_another_value(item, known)
        or _has_condition_beside(item, known)
        or _is_in_limit(item, known)
        or bool(differentials_of_images(printed))
        or is_of_maps(printed)
        or (is_power_of_difference(printed) and bool(known.untied((r"\Delta", r"\delta"))))
    )


def _is_of_what_is_left(item: SourceStatement, known: Known) -> bool:
    """Whether its paragraph neglects something before it: what moves then may be another system.

    What a footnote neglects is so to its end.
    """
    prose, start = known.paper.prose, max(item.paragraph, item.section.start)
    said = cues("neglected", prose.text[: item.typed.start], start)
    notes = (prose.footnote(one.start()) for one in said)
    return any(note is None or note[0] <= item.typed.start < note[1] for note in notes)


def _is_of_another(item: SourceStatement, known: Known) -> bool:
    """Whether a letter is given once more, and words speak of another thing: of that it may be."""
    if not _gives_again(item, known):
        return False
    return bool(_ANOTHER.search(f"{item.earlier[0] if item.earlier else ''} {item.words}"))


def _is_not_deduced(item: SourceStatement, known: Known) -> bool:
    """Whether rates of what the law moves are printed, and no words deduce them in the sentence.

    They may be those of another case, or at one place: “in the overdamped regime”.
    """
    said = any(cue(name, f"{item.before} ") for name in ("claim", "follows", "deduced"))
    return is_row(item) and all(map(known.moves, item.rates)) and not said


def is_of_a_place(item: SourceStatement, known: Known) -> bool:
    """Whether a name that is defined is given once more, and words may say where, or when.

    So they do in “at the lowest point the tension is …”.
    """
    return _gives_again(item, known) and AT_TIMES.search(item.before) is not None


_MAY_BE_CONDITION = re.compile(
    r"\\(?:forall|in)(?![A-Za-z])"
    r"|^(?!.*\\lim(?![A-Za-z])).*\\(?:to|rightarrow|infty)(?![A-Za-z])|^[^=]*$",
    re.DOTALL,
)
"""What is no equation, or tends to something, but for a limit."""


def _has_condition_beside(item: SourceStatement, known: Known) -> bool:
    """Whether something in its display that cannot be read may say where, or of what, it holds."""
    beside = (one for one in known.items if one.typed is item.typed and one.formula is None)
    return any(_MAY_BE_CONDITION.search(one.printed.tex) for one in beside)


def _is_below_another_value(item: SourceStatement, known: Known) -> bool:
    """Whether a constant has got another value in its section: its equations may say more then."""
    before = ((one, role) for one, role in known.roles.items() if one.order < item.order)
    return any(one.section is item.section and r.reason == OTHERWISE for one, r in before)


def _gives_again(item: SourceStatement, known: Known) -> bool:
    """Whether an equation gives a name that another one defines."""
    first = item.members[0] if item.members else None
    if not isinstance(first, Name):
        return False
    return known.definition(first.name, item) not in (None, item)


def _is_of_a_motion(item: SourceStatement, known: Known) -> bool:
    """Whether an equation gives a velocity by the place, or stands where words begin a motion.

    No law has the first for all motions that it allows.
    """
    begun = (one for one, role in known.roles.items() if role.kind == BEGINNING)
    return gives_velocity(item, known) or any(one.section is item.section for one in begun)


def _has_one_of_signs(item: SourceStatement) -> bool:
    r"""Whether a rate is given with either sign of a term, as :math:`\pm xy`: it has one of them.

    That of a root is looked for.
    """
    nodes = item.formula.nodes() if item.formula is not None else ()
    signs = len(EITHER_SIGN.findall(item.printed.tex))
    return item.derives and signs == 1 and not any(isinstance(node, Root) for node in nodes)


def _is_in_limit(item: SourceStatement, known: Known) -> bool:
    """Whether what tends to something, or is small, stands before a statement in its sentence."""
    before = (
        one
        for one in known.items
        if one.sentence == item.sentence and one.typed.start < item.typed.start
    )
    return any(_SMALL.search(one.typed.tex) for one in before)


def _stands_apart(
    item: SourceStatement, rung: Rung, candidates: Sequence[Rung], known: Known
) -> bool:
    """Whether a claim leaves aside what its words, or its section, say of where it holds."""
    beside = {one for other in candidates for one in other.on}
    return (
        (not rung.given and bool(cue("restricted", item.words)))
        or _has_usual_bracket(item, rung, known)
        or _is_conditioned(item, rung, known)
        or any(_implied(rung, known))
        or _is_constrained(rung, known)
        or (known.said.on(item) is None and _has_case(item, rung, beside, known))
        or _has_statement_below(item, rung, known)
    )


def _is_sure(item: SourceStatement, rung: Rung, candidates: Sequence[Rung], parts: Parts) -> bool:
    """Whether nothing is left open by which a rate, or an integral, might be another one."""
    known, role = parts.of(item), parts.roles[item]
    given = any({*one.given} - {*known.bound} for one in candidates)
    further_off = role.kind == "integral" and role.names and not integral_words(item)
    return not (
        given
        or further_off
        or rung.constants
        or (role.kind == "inequality" and rung.claim.scene.constants)
        or cue("on it", item.words)
        or _has_level(item, rung, known)
        or _has_constant(item, rung, known)
        or not _is_plain(rung, item, parts)
        or _is_below_unread(item, known)
        or _has_basis(rung, known)
        or any(one.title == "abstract" for one in item.sections)
    )


def _is_unread_summary(item: SourceStatement, known: Known) -> bool:
    """Whether it is claimed in an abstract, of what is not all read."""
    abstract = any(one.title == "abstract" for one in item.sections)
    return abstract and any(one.formula is None for one in known.items)


def _has_usual_bracket(item: SourceStatement, rung: Rung, known: Known) -> bool:
    """Whether a claim depends on the sign of a bracket that the paper does not print."""
    usual = {p for name, p in rung.claim.scene.definitions.items() if name.startswith(BRACKET)}
    usual = {place for place in usual if place.display.source == SOURCE}
    nodes = item.formula.nodes() if item.formula is not None else ()
    bracketed = any(isinstance(node, PoissonBracket) for node in nodes)
    return bool(usual) and bracketed and Number(0) not in item.members


def _has_momentum(rung: Rung, known: Known) -> bool:
    """Whether a claim stands on momenta that the paper does not give."""
    own = {one.printed for one, role in known.roles.items() if role.kind == MOMENTUM}
    return not own.isdisjoint(rung.claim.scene.definitions.values())


def _is_in_coordinates_of_words(rung: Rung, known: Known) -> bool:
    """Whether a claim stands on coordinates that words name only: an angle may be another one."""
    own = {one.printed for law in known.laws for one in law.change if not is_printed(one)}
    return not own.isdisjoint(rung.claim.scene.definitions.values())


_REAL = re.compile(r"\breal\b|\b(?:вещественн|действительн)\w+", re.IGNORECASE)


def _is_called_real(rung: Rung, known: Known) -> bool:
    """Whether it stands on what is given by the imaginary unit, with letters that words call real.

    That is meant of some motions only, as in “put a=-ix with real x”.
    """
    places = {*rung.claim.scene.definitions.values()}
    sentences = {one.sentence for one in known.items if one.printed in places}
    beside = [one for sentence in sentences for one in known.of_sentence(sentence)]
    real = any(_REAL.search(one.words) for one in beside)
    return real and any("i" in one.names for one in beside)


def _has_basis(rung: Rung, known: Known) -> bool:
    """Whether it stands on vectors of a basis, or tensors, of which the paper does not say so."""
    kinds = ("basis", INERTIA)
    basis = {one.printed for one, role in known.roles.items() if role.kind in kinds}
    return not basis.isdisjoint(rung.claim.scene.definitions.values())


def _is_conditioned(item: SourceStatement, rung: Rung, known: Known) -> bool:
    """Whether the words tell a place, a case or a set on which the claim does not rest.

    In a theorem with its proof that are its assumptions; else what stands before it in its
    sentence.
    """
    placed = known.roles[item].kind in OF_LINEAR_PART
    if cue("place", item.before) and not placed:
        return True
    for one in known.items:
        if one is item or one in rung.on or one.order > item.order:
            continue
        role = known.roles.get(one)
        there = role is not None and role.kind in ("set of the sentence", NAMED_LEVEL)
        if there and one.paragraph == item.paragraph and _is_next(one, item, known):
            return True
        set_there = role is not None and (role.kind in SETS or role.name == ASSUMPTION)
        if one.sentence == item.sentence and _is_place(one) and not placed:
            return True
        if one.sentence == item.sentence and set_there:
            return True
        if one.sentence == item.sentence and one.members and _is_supposed(one):
            gives = role is not None and role.name == DEFINITION
            if not gives and not {*(role.names if role else ())} & {*rung.claim.scene.definitions}:
                return True
        proved = item.theorem is not None and one.theorem == item.theorem
        apart = item.entry is not None and one.entry is not None and one.entry != item.entry
        if proved and not apart and role is not None and role.name == ASSUMPTION and one.members:
            return True
    return False


def _is_next(one: SourceStatement, item: SourceStatement, known: Known) -> bool:
    """Whether a statement stands in the sentence of another one, or in the next with formulas."""
    between = [other for other in known.items if one.order < other.order <= item.order]
    return bool(between) and len({other.sentence for other in between} - {one.sentence}) <= 1


def _is_place(one: SourceStatement) -> bool:
    """Whether words before an equation, or before a name, say that it is a place."""
    if isinstance(one.formula, Name):
        return bool(cue("on a set", one.lead))
    return bool(one.members) and bool(cue("here", f"{one.before} "))


def _is_supposed(one: SourceStatement) -> bool:
    """Whether words right before a statement suppose it, or the clause that its sentence begins."""
    return bool(cue("suppose", one.lead)) or is_conditional(one)


def _has_statement_below(item: SourceStatement, rung: Rung, known: Known) -> bool:
    """Whether it stands on a display that no words call a definition, and that is used once.

    Such a display may state something, and be wrong itself.
    """
    places = set() if item.derives else {*rung.claim.scene.definitions.values()}
    for one, role in known.roles.items():
        plain = role.name == DEFINITION and not role.kind and not one.typed.inline
        words = one.lead if one.lead.strip(" ,;") else one.before
        if not plain or one.printed not in places or one is item or cue("define", words):
            continue
        users = [o for o in known.items if o.members and {*role.names} & o.names and o is not one]
        if users == [item] and known.varying(one.names - {*role.names}):
            return True
    return False


def _has_two_meanings(item: SourceStatement, rung: Rung, known: Known) -> bool:
    """Whether a name on which it rests stands alone on a side once more in its section."""
    places = rung.claim.scene.definitions
    before = [one for one in known.items if one.order < item.order and one.members]
    return any(
        one.printed != places[name] and one.section in item.sections[1:]
        for one in before
        for name in one.bare[:1]
        if name in places
        and one.members[0] == Name(name)
        and not any(map(is_numerical, one.members))
    )


def _is_constrained(rung: Rung, known: Known) -> bool:
    """Whether a display before the law says where it moves, and the claim is not made there."""
    first = min((law.first.order for law in known.laws), default=0)
    return any(
        one.order < first and not one.typed.inline and one not in rung.on and one.members
        for one in known.assumptions
        if known.roles[one].kind.startswith("set")
    )


def _is_below_unread(item: SourceStatement, known: Known) -> bool:
    """Whether something cannot be read in its section that may say where all of it holds."""
    return any(
        one.formula is None
        and one.order < item.order
        and one.section in item.sections[1:]
        and any(cue(name, one.before) for name in ("suppose", "level", "restricted"))
        for one in known.items
    )


def _is_below_other_rates(item: SourceStatement, known: Known) -> bool:
    """Whether its section prints a rate before it with constants that no law has: a force, perhaps.

    What moves by the law may move there by another one, that was not read.
    """
    of_laws = {name for law in known.laws for own in law.mentions for name in known.below(own)}
    before = (one for one in known.items if one.order < item.order and is_row(one))
    others = (one for one in before if one.section is item.section and known.law_of(one) is None)
    return any(
        _is_of_highest_order(one, known)
        and not all(
            name in of_laws or known.moves(name) or known.is_defined(name) or name in known.times
            for name in known.names.scalars(one.names)
        )
        for one in others
    )


def _is_below_other_energy(item: SourceStatement, known: Known) -> bool:
    """Whether a Hamiltonian, or a Lagrangian, is printed before it beside that of the law.

    It has the letter of one, perhaps with an index or an accent, and squares of what moves, or of
    its rates: what is said behind it may be said of another system.
    """
    of_laws = {name for law in known.laws for name in law.mentions}
    energies = (*HAMILTONIANS, *LAGRANGIANS)
    for one in known.items if of_laws & {*energies} else ():
        name = one.bare[0] if one.bare and one.members[0] == Name(one.bare[0]) else ""
        if one.order >= item.order or name in of_laws or len(one.members) != 2:
            continue
        letter = replace(symbol(name), index="", accents=(), raised="").name if name else ""
        if letter in energies and known.roles[one].name == DEFINITION and _has_squares(one, known):
            return True
    return False


def _has_squares(one: SourceStatement, known: Known) -> bool:
    """Whether squares of several names that move, or of rates, stand in what an equation gives."""
    nodes = one.members[1].nodes()
    bases = {n.base for n in nodes if isinstance(n, Power) and n.exponent == Number(2)}
    moving = [b for b in bases if isinstance(b, Name) and known.moves(b.name)]
    return len(moving) > 1 or any(isinstance(base, Derivative) for base in bases)


def _is_before_its_law(item: SourceStatement, known: Known) -> bool:
    """Whether a row is printed before the law, which may be another system then."""
    first = min((law.first.order for law in known.laws), default=0)
    return item.order < first and is_row(item) and _is_of_highest_order(item, known)


def _is_of_highest_order(one: SourceStatement, known: Known) -> bool:
    """Whether a row has derivatives of variables, printed as in a law, and as high as there."""
    rows = [row for law in known.laws for row in law.rows if row.marks & one.marks]
    alike = [row for row in rows if {*row.rates} & {*one.rates}]
    same = any(one.rates.get(name, 0) >= n for row in alike for name, n in row.rates.items())
    return same and all(map(known.moves, one.rates))


def _has_level(item: SourceStatement, rung: Rung, known: Known) -> bool:
    """Whether something that moves has a number for its value before it, where it may hold.

    That a vector is a unit vector is said once, and used from there on.
    """
    return any(
        role.kind in EQUATIONS
        and one.order < item.order
        and one not in rung.on
        and not one.derives
        and any(isinstance(member, Number) for member in one.members)
        and known.varying(one.names)
        for one, role in known.roles.items()
    )


def _has_constant(item: SourceStatement, rung: Rung, known: Known) -> bool:
    r"""Whether an equation has a constant that no law has: it may belong to a motion.

    So :math:`\dot\theta^2=4(k^2-\sin^2\frac\theta2)` holds for the k of this motion.
    """
    return known.roles[item].kind == "identity" and bool(known.untied(rung.claim.scene.constants))


def _has_case(
    item: SourceStatement, rung: Rung, tried: Collection[SourceStatement], known: Known
) -> bool:
    """Whether its section supposes something of its constants that was not tried.

    Words may mean a case by its name, as one that a definition in the section says.
    """
    return any(
        one.section in item.sections[1:]
        and one.order < item.order
        and one not in tried
        and {*known.roles[one].names} & {*rung.claim.scene.constants}
        and one.theorem is not None
        and one.entry is None
        for one in known.assumptions
    )


def _implied(rung: Rung, known: Known) -> Iterator[str]:
    """The names that are no constants, though nothing was read that says what they are.

    They stand with what moves in an equation that is not solved for them, have numbers for indices
    where the law has letters for them, or are named by what says something else.
    """
    mentions = {name for law in known.laws for name in law.mentions}
    families = any(_INDEXED.search(name) for name in mentions)
    for name in rung.claim.scene.constants:
        seen = known.seen.get(name)
        role = known.roles[seen] if seen is not None else None
        if role is not None and seen is not None and role.name in (CLAIM, ASSUMPTION):
            told = role.kind == "identity" or role.kind.startswith("set")
            moving = known.varying(seen.names) and not seen.derives
            if told and moving and name not in role.names:
                yield name
        if (families and _NUMBERED.search(name)) or _is_lost(name, known):
            yield name


def _is_lost(name: str, known: Known) -> bool:
    """Whether a name, or its square, stands alone before what moves, and has no meaning by that."""
    alone = (Name(name), Power(Name(name), Number(2)))
    for one in known.items:
        role = known.roles.get(one)
        if one.members and one.members[0] in alone and role is not None:
            solved = role.name not in (ASSUMPTION, LAW) and name not in role.names
            if solved and known.varying(one.names - {name}):
                return True
    return False


def _moves_on(law: Law, rows: Set[Printed], defined: Set[Printed]) -> bool:
    """Whether a law is that of a scene with these equations of motion and definitions."""
    if law.images:
        return not rows and {one.printed for one in law.given.values()} <= defined
    return {row.printed for row in law.rows} == rows


def _is_plain(rung: Rung, item: SourceStatement, parts: Parts) -> bool:
    """Whether a claim stands on the only law of its variables, which rests on no other one."""
    if _has_two_meanings(item, rung, parts.of(item)):
        return False
    scene = rung.claim.scene
    rows = {*scene.field} if isinstance(scene.field, tuple) else set()
    laws = [law for law in parts.of(item).laws if not law.change]
    defined = {*scene.definitions.values()}
    law = next((one for one in laws if _moves_on(one, rows, defined)), None)
    changed = law is not None and {*law.variables} != {*rung.claim.scene.variables}
    if law is None or changed or law.base is not None or not parts.is_sure(item, rung.claim.scene):
        return False
    others = (one for one in laws if one is not law)
    return not any({*one.variables} & {*law.variables} for one in others)
