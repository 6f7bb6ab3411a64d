"""On what a claim may stand: sets in force, what its sentence cites, what stands just before it."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Collection, Iterator

from kowalevski_cas.notation import (
    CrossProduct,
    Derivative,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    ScalarProduct,
    Sum,
    to_latex,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, SETS, Known
from kowalevski_cas.reading.phrases import right_behind
from kowalevski_cas.reading.sets import SetOfEquations, sets_of
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import references
from kowalevski_cas.reading.tried import amplitude_equations
from kowalevski_cas.reading.unknowns import equations_before
from kowalevski_cas.reading.unprinted import unprinted

EQUATIONS = ("integral", "identity")
"""The kinds of claims that may hold on a part of the phase space only."""


def hypotheses(item: SourceStatement, known: Known) -> list[SetOfEquations]:
    """What may be given: sets in force, what the sentence cites, and both.

    What stands just before is given too, if the words say so; so is what is left of the law by
    forms of solutions that are tried before, and equations for unknowns.
    """
    sets = sets_in_force(item, known)
    cited = [one for one in known.cited(item) if _restricts(one, known)]
    cited += [one for one in _said_to_hold(item, known) if _restricts(one, known)]
    here = known.supposed(item)
    cited = [one for one in cited if one not in here]
    if cue("on it", _place_words(item)):
        cited += just_before(item, known)
    elif one := _restricting(item, known):
        cited += just_before(one, known)
    cited += _named_before(item, known) or set_right_before(item, known)
    cited += points_spoken_of(item, known)
    cited += set_right_behind(item, known)
    alone = ((one,) for one in amplitude_equations(item, known))
    unknowns, value = equations_before(item, known), value_right_before(item, known)
    found = (sets, tuple(cited), (*sets, *cited), *alone, unknowns, (*sets, *value))
    return [*dict.fromkeys(tuple(dict.fromkeys(one)) for one in found if one)]


def just_before(item: SourceStatement, known: Known) -> SetOfEquations:
    """The set that was spoken of, or cited, last in the same paragraph; none of several."""
    last: list[SourceStatement] = []
    for one in known.roles:
        if one.order < item.order and one.paragraph == item.paragraph:
            last += [o for o in (one, *known.cited(one)) if is_set(o, known)]
    if not last:
        return ()
    display = [one for one in known.roles if one.typed is last[-1].typed and is_set(one, known)]
    sets = sets_of({*last, *display}, known.paper.source.text)
    own = next(one for one in sets if last[-1] in one)
    beside = [one for one in sets if one[0].sentence == own[0].sentence]
    return own if len(beside) == 1 or not cue("on them", _place_words(item)) else ()


def sets_in_force(item: SourceStatement, known: Known) -> SetOfEquations:
    """The sets that are supposed where a statement stands, with that of a change of variables."""
    return (*known.sets(item), *_of_change(item, known))


def _of_change(item: SourceStatement, known: Known) -> SetOfEquations:
    """The set on which the last change before a statement gives variables by fewer new names.

    It was spoken of last before the change, in its paragraph.
    """
    changed = [law for law in known.laws if law.change and law.change[-1].order < item.order]
    if not changed or changed[-1].change[0].section is not item.section:
        return ()
    first = changed[-1].change[0]
    beside = (one for one in known.of_sentence(first.sentence) if one not in changed[-1].change)
    more = any(
        one.members[1:] and one.members[1].names() & {*changed[-1].new} and known.moves(one.bare[0])
        for one in beside
        if one.bare and one.members[0] == Name(one.bare[0])
    )
    return just_before(first, known) if more else ()


_RESTRICTS = re.compile(
    r"(?:^|[.;,])\s*(?:on|на)\s+(?:it|them|(?:this|these|that|such\s+an?|этом|этой|этих)\s+\w+|н[её][мй]?|них)\b[^.;§]*?"
    r"(?:\b(?:system|equations?|motions?|flow|problem|систем\w+|уравнени\w+|движени\w+)\b[^.;]*?"
    r"\b(?:becomes?|reduces?|turns?|takes?|are|is|reads?|goes|go|принима\w+|сводя?тся|име[ею]т|переход\w+)\b"
    r"|\b(?:we|one|мы)?\s*(?:puts?|sets?|introduces?|uses?|writes?|takes?|положим|введ[её]м|полагаем)\b)",
    re.IGNORECASE,
)
"""How a sentence begins in which equations, or variables, are those on a set: so they are then."""


def _restricting(item: SourceStatement, known: Known) -> SourceStatement | None:
    """The last statement before, in its section, that says how equations are on a set.

    Nothing stands in what is said behind it that vanishes, or is given, on this set.
    """
    before = [
        one
        for one in known.items
        if one.order < item.order and one.section is item.section and _RESTRICTS.search(one.before)
    ]
    if not before:
        return None
    given = {name for one in just_before(before[-1], known) for name in one.names}
    below = {inner for name in item.names for inner in known.below(name)}
    return before[-1] if given.isdisjoint(known.names.scalars(below)) else None


def _named_before(item: SourceStatement, known: Known) -> SetOfEquations:
    """The equations of the set that its sentence names before a statement, as in “on K we have”."""
    for one in known.items:
        before = one.sentence == item.sentence and one.order < item.order
        if before and isinstance(one.formula, Name) and cue("on a set", one.lead):
            equations = [o for o in known.items if _is_of_set(o, one.typed.tex, known)]
            if equations:
                return tuple(equations)
    return ()


def normalisations(item: SourceStatement, known: Known) -> SetOfEquations:
    r"""The equations before a statement that say which of the vectors in it are unit vectors.

    So :math:`(\gamma,\gamma)=1` is said once, and holds wherever the vector stands; nothing is
    supposed by it.
    """
    below = {n for name in item.names for n in known.below(name)}
    vectors = {known.names.whole(name) for name in below} & {*known.names.vectors}
    letters = {symbol(name).letter for name in below if known.moves(name)}
    moving = [name for law in known.laws for name in law.variables]
    families = [{n for n in moving if symbol(n).letter == one} for one in sorted(letters)]
    printed = tuple(
        one
        for one in known.items
        if one.order < item.order
        and Number(1) in one.members
        and not one.derives
        and not any(cue(words, one.lead) for words in ("suppose", "level", "if"))
        and (
            any(_is_square(one, vector, known) for vector in vectors)
            or any(_is_sum_of_squares(one, family) for family in families)
        )
    )
    return (*printed, *_in_words(vectors, item, known)) if not printed else printed


_UNIT_VECTOR = re.compile(
    r"\bunit\s+(?:\w+\s+){0,3}?vectors?[\s~]*$"
    r"|\bединичн\w+\s+(?:\w+\s+){0,2}вектор\w*[\s~]*$",
    re.IGNORECASE,
)
_IS_UNIT = re.compile(
    r"[\s,~]*(?:be|is|denotes?|being|[-—–]+)\s+(?:the|an?)?\s*unit\s+(?:\w+\s+){0,3}?vector\b"
    r"|[\s,~]*(?:[-—–]+|есть)?\s*единичн\w+\s+(?:\w+\s+){0,2}вектор",
    re.IGNORECASE,
)
"""Words beside a vector that call it a unit vector."""


def has_unit_vector_under_products(known: Known) -> bool:
    """Whether words call a vector a unit vector of which a law gives no derivative alone."""
    rows = [row for law in known.laws for row in law.rows]
    return any(
        isinstance(one.formula, Name)
        and (_UNIT_VECTOR.search(one.lead) or _IS_UNIT.match(one.tail))
        and any(_is_in_product(one.formula.name, row) for row in rows)
        for one in known.items
    )


def _is_in_product(name: str, row: SourceStatement) -> bool:
    """Whether a derivative of a vector stands in a vector product of a row."""
    nodes = row.formula.nodes() if row.formula is not None else ()
    products = [node for node in nodes if isinstance(node, CrossProduct)]
    inner = (one for product in products for one in product.nodes())
    return any(isinstance(one, Derivative) and name in one.names() for one in inner)


def _in_words(
    vectors: Collection[str], item: SourceStatement, known: Known
) -> Iterator[SourceStatement]:
    """That vectors which move are unit vectors, where words beside their letters say so."""
    for one in known.items:
        name = one.formula.name if isinstance(one.formula, Name) else ""
        if one.order < item.order and name in vectors and known.moves(name):
            if _UNIT_VECTOR.search(one.lead) or _IS_UNIT.match(one.tail):
                id, why = f"unit-{one.order}-{item.order}", "words call it a unit vector"
                yield unprinted(known.paper, id, rf"{name}\cdot{name}=1", one, why)
                parts = {name, *known.names.vectors[name]}
                rates = [n for law in known.laws for x, n in law.orders.items() if x in parts]
                if max(rates, default=0) > 1:
                    rate = rf"{name}\cdot\dot{{{name}}}=0"
                    yield unprinted(known.paper, f"{id}-along", rate, one, why)


def _is_square(one: SourceStatement, vector: str, known: Known) -> bool:
    """Whether an equation gives the square of a vector that moves, and nothing else."""
    if not known.moves(vector):
        return False
    if _is_sum_of_squares(one, known.names.vectors[vector]):
        return True
    whole, two = Name(vector), Number(2)
    length = Modulus(whole)
    squares = (ScalarProduct(whole, whole), Power(whole, two), length, Power(length, two))
    return len(one.members) == 2 and any(member in squares for member in one.members)


def _is_sum_of_squares(one: SourceStatement, names: Collection[str]) -> bool:
    """Whether an equation with one gives the sum of the squares of all of some names."""
    sums = [member for member in one.members if isinstance(member, Sum)]
    squares = {Power(Name(name), Number(2)) for name in names}
    return len(one.members) == 2 and any({*sum.terms} == squares for sum in sums)


_THERE = re.compile(
    r"[\s,;]*(?:and\s+)?(?:where|there|with|at\s+which|for\s+which|где|там|с|при\s+этом)\b",
    re.IGNORECASE,
)


def set_right_before(item: SourceStatement, known: Known) -> SetOfEquations:
    """The display of a set behind which a statement says what is so there, as in “…, where q=2”."""
    before = [one for one in known.items if one.order < item.order]
    last = before[-1] if before else item
    if last.sentence != item.sentence or last.typed.inline or not _THERE.match(item.lead):
        return ()
    return tuple(one for one in before if one.typed is last.typed and is_set(one, known))


_FROM = re.compile(
    r"\b(?:from|by|using|with|because\s+of|из|по|в\s+силу)\s+(?:the\s+)?(?:\w+\s+){0,3}?"
    r"(?:integrals?|conservation|conserved|интеграл\w*|закон\w*\s+сохранени\w+)\b[^§]*$",
    re.IGNORECASE,
)
"""How words end behind which stands an integral from which something is deduced."""
_FOLLOWS = re.compile(
    r"[\s,;]*(?:and\s+hence\s+|then\s+)?(?:(?:it\s+)?follows|implies|gives|yields|(?:we|one)\s+(?:then\s+)?(?:have|has|gets?|finds?|obtains?)"
    r"|следует|вытека\w+|получ\w+|находим|имеем|да[её]т)(?:,?\s+(?:that|what|что))?(?:\s+(?:the|\w+))?[\s:,~]*",
    re.IGNORECASE,
)
"""The words between an integral and what is deduced from it."""


def value_right_before(item: SourceStatement, known: Known) -> SetOfEquations:
    """The integral with the value that its constants give it, from which a statement is deduced.

    It stands right before in the sentence, as in “from the integral of energy v²/2+gy=v_0²/2”.
    """
    before = [one for one in known.of_sentence(item.sentence) if one.order < item.order]
    last = before[-1] if before else item
    role = known.roles.get(last)
    fixed = any(not known.varying(member.names()) for member in last.members)
    claimed = role is not None and role.kind == "integral" and not (role.names or role.value)
    said = _FROM.search(last.lead) and _FOLLOWS.fullmatch(item.lead)
    return (_over_mass(last, known),) if said and claimed and fixed else ()


def _over_mass(one: SourceStatement, known: Known) -> SourceStatement:
    """An equation without the constants that stand in each of its terms.

    It would hold wherever these vanish.
    """
    terms = [t for m in one.members for t in (m.terms if isinstance(m, Sum) else (m,))]
    shared = set[str].intersection(*(_factors(term) for term in terms))
    masses = sorted(name for name in shared if not known.varies(name))
    if not masses:
        return one
    sides = (rf"\frac{{{to_latex(member)}}}{{{' '.join(masses)}}}" for member in one.members)
    id = f"value-{one.order}"
    return unprinted(known.paper, id, "=".join(sides), one, f"{one.printed.place} says it")


def _factors(term: Formula) -> set[str]:
    """The names that a term has as factors."""
    match term:
        case Name(name):
            return {name}
        case Negative(inner):
            return _factors(inner)
        case Power(Name(name), Number(exponent)) if exponent > 0:
            return {name}
        case Quotient(numerator, _):
            return _factors(numerator)
        case Product(factors):
            return set[str]().union(*map(_factors, factors))
    return set()


_AT_POINTS = re.compile(
    r"\b(?:at|in|of)\s+(?:this|these|that|those|both)\s+(?:\w+\s+)?(?:points?|equilibri(?:um|a)|positions?)\b"
    r"|\bв\s+(?:этих|этой|этом|обеих|обоих)\s+(?:точк\w+|положени\w+)",
    re.IGNORECASE,
)
"""Words for points that stand before them."""


def points_spoken_of(item: SourceStatement, known: Known) -> SetOfEquations:
    """The equations of the points that were printed last in the paragraph: “at these points”.

    None of several: what holds at one need not hold at all. Equilibria have no velocities.
    """
    if not _AT_POINTS.search(item.before):
        return ()
    before = [
        one for one in known.roles if one.order < item.order and one.paragraph == item.paragraph
    ]
    last = [one for one in before if is_set(one, known) and is_value(one, known)]
    beside = [one for one in last if one.sentence == last[-1].sentence]
    found = sets_of(beside, known.paper.source.text)
    sets = [own for own in found if max(own, key=lambda o: o.order).typed is last[-1].typed]
    if len(sets) != 1:
        return ()
    (own,) = sets
    at_rest = any(known.roles[one].kind == "rest" for one in before if one.order < own[-1].order)
    return (*own, *(_velocities(own[-1], known) if at_rest else ()))


def _velocities(one: SourceStatement, known: Known) -> Iterator[SourceStatement]:
    """That the velocities vanish of what moves by equations of the second order."""
    orders = {name: order for law in known.laws for name, order in law.orders.items()}
    for name in (name for name, order in orders.items() if order > 1):
        id, tex = f"rest-{name}-{one.order}", rf"\dot{{{name}}}=0"
        yield unprinted(known.paper, id, tex, one, "words call it an equilibrium")


_IN_LIST = re.compile(r"[\s,]*(?:\b(?:and|и)\b[\s,]*)?")
_OR = re.compile(r"[\s,]*\b(?:or|или)\b", re.IGNORECASE)
_WHERE = re.compile(
    r"[\s,;]*(?:only\s+)?(?:for|if|when|whenever|where|at|on|along|as\s+long\s+as|provided(?:\s+that)?|при|если|когда|где|на)"
    r"(?:\s+(?:the\s+)?(?:axis|axes|line|plane|circle|curve|sphere|ellipse|surface|points?|set|level|оси|прямой|плоскости"
    r"|кривой|окружности|точк\w+))?[\s~]*",
    re.IGNORECASE,
)
"""How words end behind which is printed where it is so what stands before them."""


def set_right_behind(item: SourceStatement, known: Known) -> SetOfEquations:
    """The equations right behind a statement, or its list, that say where it is so."""
    behind = [
        one
        for one in known.items
        if one.sentence == item.sentence and one.order > item.order and one.typed is not item.typed
    ]
    start = next((k for k, one in enumerate(behind) if not _IN_LIST.fullmatch(one.lead)), None)
    if start is None or not _WHERE.fullmatch(behind[start].lead):
        return ()
    own: list[SourceStatement] = []
    for one in behind[start:]:
        beside = not own or one.typed is own[-1].typed or _IN_LIST.fullmatch(one.lead)
        if not beside and _OR.match(one.lead):
            return ()
        if not beside:
            break
        own.append(one)
    given = [name for one in own for name in one.bare]
    several = len(given) > len({*given})  # it is so at each of some places
    return () if several or not all(is_set(one, known) for one in own) else tuple(own)


def _is_of_set(item: SourceStatement, name: str, known: Known) -> bool:
    """Whether a statement is an equation of a set with a name."""
    own = known.paper.sets.get(item.typed.start, "")
    return bool(own and item.members) and _bare(own) == _bare(name)


def _bare(tex: str) -> str:
    return re.sub(r"[\s{}.,;]", "", tex)


def is_value(one: SourceStatement, known: Known) -> bool:
    """Whether a statement gives variables by constants, and not by a time."""
    if one.names & known.times:
        return False
    moving = [name for name in one.bare if known.moves(name)]
    others = [member for member in one.members if member not in [*map(Name, moving)]]
    names = {name for member in others for name in member.names()}
    return bool(moving) and not one.derives and not any(map(known.varies, names - known.levels))


def _place_words(item: SourceStatement) -> str:
    """The words that may say where a statement holds: before it, and right behind it."""
    return f"{item.before[-80:]} {right_behind(item)}"


_HOLDS = re.compile(
    r"\b(?:suppos|assum)\w+\b[^.;]*?\\(?:eq|c|C|auto)?ref\b"
    r"|\blet\b[^.;]*?\\(?:eq|c|C|auto)?ref\b[^.;]*?\b(?:hold|be\s+(?:satisfied|fulfilled|valid|true))\b"
    r"|\b(?:пусть|предположим|допустим)\b[^.;]*?\b(?:выполн|справедлив|име[ею]т\s+место)",
    re.IGNORECASE,
)
"""Words that suppose what they cite: it is in force to the end of the section."""


_NOT_SUPPOSED = re.compile(
    r"\b(?:not|never|no\s+longer|without|nobody|не|без)\s+(?:\w+\s+)?(?:suppos|assum|предпол)\w*",
    re.IGNORECASE,
)
"""Words that suppose nothing."""


def _said_to_hold(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """What a sentence before a statement, in its section, supposes to hold by citing it."""
    prose, labels = known.paper.prose, known.paper.labels
    for stop in reversed(prose.stops[: bisect_left(prose.stops, item.sentence[0])]):
        if stop < item.section.start:
            break
        words = prose.between(*prose.sentence(stop))
        if _HOLDS.search(words) and not (cue("denied", words) or _NOT_SUPPOSED.search(words)):
            return [one for label in references(words) for one in labels.get(label, ())]
    return []


def _restricts(one: SourceStatement, known: Known) -> bool:
    """Whether a statement holds on a part of the phase space only, so that it can be given.

    So does what is supposed of constants.
    """
    role = known.roles.get(one)
    if role is None or not one.members or one.derives:
        return False
    if role.name == ASSUMPTION and role.kind in ("", "of the sentence"):
        return True
    if not known.varying(one.names):
        return False
    if role.name == ASSUMPTION or role.kind in SETS:
        return True
    said = known.said.verb(one) == "claim"
    return role.name == CLAIM and not role.names and (said or role.kind in EQUATIONS)


def is_set(one: SourceStatement, known: Known) -> bool:
    """Whether a statement is an equation of a set of the phase space."""
    role = known.roles.get(one)
    return role is not None and (role.kind.startswith("set") or role.kind in SETS)
