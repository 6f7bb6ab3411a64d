r"""Letters that words, or factors, name as all the roots of a polynomial.

They are constants where its coefficients are, or values of integrals; else they move, by the
derivatives of Vieta's relations.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Power,
    Relation,
    to_latex,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.paper.signs import is_inequality
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.factors import roots_in_factors
from kowalevski_cas.reading.fresh import is_fresh
from kowalevski_cas.reading.known import CLAIM, DEFINITION, LEVEL, OTHER, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.phrases import integral_words, plain, supposing
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.text import references
from kowalevski_cas.reading.unprinted import unprinted
from kowalevski_cas.reading.vieta import NamedRoots, letters_of, polynomial_of, relations

SAYS = "the relation of roots with the coefficients"

_ROOTS = r"(?:roots|zeroe?s|корн(?:и|ями|ей)|нул(?:и|ями|ей))"
_ARE_ROOTS = re.compile(rf"(?P<are>[^§]*?)\b{_ROOTS}\b(?P<of>[^§.;:,]*)", re.IGNORECASE)
"""Words behind letters that call them the roots of something."""
_ROOTS_ARE = re.compile(rf"(?P<has>[^§]*)\b{_ROOTS}\b(?P<of>[^§]*)$", re.IGNORECASE)
"""How words end behind which stand the letters for the roots of what they speak of."""
_ROOTS_OF = re.compile(rf"\b{_ROOTS}\b(?P<of>[^§]*)$", re.IGNORECASE)
_DENOTED = re.compile(r"(?:denoted|by|as|through|через|обозначим)[\s:~]*$", re.IGNORECASE)
"""How words end behind which stand letters for what is printed before them."""
_ARE = frozenset(
    """be is are was were being denote denotes denoted denoting call called then the its a both all
    two three four five six real different distinct simple as by to we with has have having let and
    which it where in general defined given introduced taken found obtained will again now here so
    this that on
    — – - суть являются есть все три два две вещественные действительные различные простые через
    обозначим имеет пусть его где и""".split()
)
"""Words beside roots that say that letters are these, and no more."""
_OF = frozenset(
    """of the this that its their following quadratic cubic quartic quintic algebraic characteristic
    secular last latter same above equation polynomial trinomial function expression right left hand
    side entry element in on eq i e namely first second
    уравнения многочлена полинома трёхчлена трехчлена функции этого последнего правой левой части
    квадратного кубического характеристического следующего""".split()
)
"""Words behind roots that say of what they are the roots, and not of what is made from that."""
_OF_OTHERS = re.compile(
    r"\bof[\s~]*$|\b(?:squares?|inverses?|reciprocals?|doubled?|halves|half|квадрат\w*|обратн\w+|удвоенн\w+)\b",
    re.IGNORECASE,
)
"""Words before letters by which not these are roots, but what is made from them."""
_THIS = re.compile(r"\b(?:this|that|its|last|latter|этого|последнего|правой)\b", re.IGNORECASE)
_CITED = re.compile(r"\(?\\[A-Za-z]+\s*\{[^{}]*\}\)?")
_IN_LIST = re.compile(r"[\s,~]*(?:\b(?:and|и)\b[\s,~]*)?")


def _only(words: str, *allowed: Collection[str]) -> bool:
    """Whether some words are all among others, but for citations."""
    found = re.findall(r"[^\W\d_]+", _CITED.sub(" ", words).lower())
    return {*found} <= frozenset().union(*allowed)


def roots_named(
    item: SourceStatement, paper: SourcePaper, mentioned: Collection[str]
) -> NamedRoots | None:
    """The roots that words at the last of some letters name, of what is printed beside them."""
    listed = _list_before(item, paper)
    names = tuple(name for one in listed for name in _letters(one))
    if len(names) < 2 or len({*names}) < len(names):
        return None
    for of in _spoken_of(listed, paper):
        formula = _polynomial(of)
        highest = {
            letter: polynomial_of(formula, letter, names, item, paper)
            for letter in _unknowns(formula, names, item, paper, mentioned)
        }
        degrees = [len(one) - 1 if one else len(names) for one in highest.values()]
        if degrees.count(len(names)) == 1 and max(degrees) == len(names):
            return next(
                (
                    NamedRoots(item, names, letter, one)
                    for letter, one in highest.items()
                    if one and len(one) > len(names)
                ),
                None,
            )
    return None


def _unknowns(
    formula: Formula,
    names: Sequence[str],
    item: SourceStatement,
    paper: SourcePaper,
    mentioned: Collection[str],
) -> Collection[str]:
    """The letters of a formula of which it may have roots: that of the roots, or free ones.

    A free letter is neither given, nor in an equation with rates. Where there is none it is one of
    the others.
    """
    found = letters_of(formula, names, item, paper)
    own = {replace(symbol(name), index="").name for name in names}
    if len(own) == 1 and own <= found:
        return own
    before = [one for one in paper.items if one.sentence[0] <= item.sentence[0]]
    bound = {name for one in before for name in one.names if one.derives}
    bound |= {name for one in before if one.members for name in one.printed.heads.names}
    return found - bound - {*mentioned} or found


def _letters(item: SourceStatement) -> tuple[str, ...]:
    """The letters of which a statement is a list, or which it puts in their order."""
    formula = item.formula
    if isinstance(formula, Name):
        return (formula.name,)
    if isinstance(formula, Relation) and is_inequality(formula):
        names = [one.name for one in formula.members if isinstance(one, Name)]
        return tuple(names) if len(names) == len(formula.members) else ()
    return ()


def _list_before(item: SourceStatement, paper: SourcePaper) -> list[SourceStatement]:
    """The letters of a list, up to the last one; none before this is reached."""
    beside = [one for one in paper.items if one.sentence == item.sentence and _letters(one)]
    if item not in beside:
        return []
    place = beside.index(item)
    behind = beside[place + 1 : place + 2]
    if behind and _are_beside(item, behind[0]):
        return []
    first = place
    while first and _are_beside(beside[first - 1], beside[first]):
        first -= 1
    return beside[first : place + 1]


def _are_beside(one: SourceStatement, other: SourceStatement) -> bool:
    """Whether nothing but a comma or an “and” stands between two letters."""
    following = other.order == one.order + 1
    return following and (one.typed is other.typed or bool(_IN_LIST.fullmatch(other.lead)))


def _spoken_of(listed: Sequence[SourceStatement], paper: SourcePaper) -> Iterator[SourceStatement]:
    """What words call the polynomial, or the equation, with these roots."""
    first, last = listed[0], listed[-1]
    order = {one.order: one for one in paper.items}
    before, behind = order.get(first.order - 1), order.get(last.order + 1)
    before = before if before is not None and before.paragraph == first.paragraph else None
    behind = behind if behind is not None and behind.sentence == last.sentence else None
    for of, follows in _words_of_roots(first, last, before):
        cited = [one for label in references(of) for one in paper.labels.get(label, ())]
        found = cited[0] if cited else behind if follows else before
        if found is not None:
            yield found


def _words_of_roots(
    first: SourceStatement, last: SourceStatement, before: SourceStatement | None
) -> Iterator[tuple[str, bool]]:
    """The words that say of what letters are the roots, and whether this follows them."""
    said = _ARE_ROOTS.match(last.tail)
    if said and _only(said["are"], _ARE) and _only(said["of"], _OF):
        if not _OF_OTHERS.search(first.lead):
            yield said["of"], _follows(said["of"], last.tail[said.end() :])
        return
    said = _ROOTS_ARE.search(first.lead)
    if said and _only(said["has"], _ARE, _OF) and _only(said["of"], _ARE, _OF):
        behind = _BEHIND.match(last.tail) is not None and _only(last.tail, _OF)
        if not behind and before and before.sentence == first.sentence:
            if _OF_OTHERS.search(before.lead):  # “the derivative of P has the roots”
                return
        yield said["of"] + (last.tail if behind else ""), behind and _follows(last.tail)
        return
    said = _ROOTS_OF.search(before.lead) if before and _DENOTED.search(first.lead) else None
    if said and _only(said["of"], _OF) and _only(first.lead, _ARE):
        yield "", False


_BEHIND = re.compile(r"[\s~]*(?:of|многочлена|уравнения|полинома)\b", re.IGNORECASE)
"""How words begin behind the letters for roots that say of what they are the roots."""


def _follows(of: str, rest: str = "") -> bool:
    """Whether the polynomial is printed behind these words: it is not spoken of before."""
    nothing = not rest.strip(" ~:\n")
    return nothing and _BEHIND.match(of) is not None and not _THIS.search(of)


def _polynomial(item: SourceStatement) -> Formula:
    """What has to vanish for a root: the side of an equation that is no name, nor has rates."""
    assert item.formula is not None
    if len(item.members) < 2:
        return item.formula
    left, right = item.members[0], item.members[-1]
    if Number(0) in (left, right):
        return left if right == Number(0) else right
    alone = isinstance(left, Name | Application | Power)
    rated = any(isinstance(node, Derivative) for node in left.nodes())
    return right if alone or rated else minus((left, right))


def find_moving_roots(
    law: Law, items: Sequence[SourceStatement], paper: SourcePaper
) -> Iterator[Law]:
    """The law with the roots that are named behind it, where coefficients move."""
    moving = {*law.variables}
    seen = moving.union(law.mentions, *(one.names for one in law.items))
    for item in items:
        old = item.members and moving & {*law.names.scalars(item.names)}
        if old and not _is_of_integral(item):
            moving |= {*item.printed.heads.names, *item.printed.heads.squares} - law.mentions
        roots = None
        if item.order > law.order:
            roots = roots_named(item, paper, law.mentions) or roots_in_factors(item, (), paper)
        if roots is not None and seen.isdisjoint(roots.names):
            named = {name for one in roots.polynomial for name in one.names()}
            if moving & {*law.names.scalars(named)}:
                own = relations(roots, paper, named & moving)
                rows = tuple(_row(one, paper) for one in own)
                yield Law(rows, law.names, base=law, together=tuple(own), new=roots.names)
        seen |= item.names if item.members else set()


def _is_of_integral(item: SourceStatement) -> bool:
    """Whether words call what a statement gives an integral: then it is a constant of motions."""
    return bool(integral_words(item) or cue("energy", item.lead))


def _row(item: SourceStatement, paper: SourcePaper) -> SourceStatement:
    """The derivative of a relation between roots."""
    left, right = (rf"\frac{{d}}{{dt}}\left({to_latex(one)}\right)" for one in item.members)
    return unprinted(paper, f"rate-of-{item.printed.display.id}", f"{left}={right}", item, SAYS)


def roots_at(item: SourceStatement, known: Known) -> NamedRoots | None:
    """The new letters that a statement makes roots of a polynomial with constant coefficients."""
    mentioned = {name for law in known.laws for name in law.mentions}
    roots = roots_named(item, known.paper, mentioned)
    roots = roots or roots_in_factors(item, _given(item, known), known.paper)
    again = {name for names, _ in known.rooted for name in names} if not item.members else set()
    if roots is None or any(
        known.moves(name) or _is_old(name, item, known) for name in {*roots.names} - again
    ):
        return None
    named = {name for one in roots.polynomial for name in one.names()}
    giving = {one for name in named for one in known.definitions.get(name, ())}
    named -= {name for one in filter(_is_of_integral, giving) for name in known.roles[one].names}
    return None if known.varying(named - known.levels) else roots


def roots(item: SourceStatement, known: Known) -> StatementRole | None:
    """A polynomial that is known already, with factors which have new names in them."""
    if not item.members or roots_at(item, known) is None:
        return None
    return StatementRole(CLAIM, "has new names for the roots of what is known", "identity")


def of_roots(item: SourceStatement, known: Known) -> StatementRole | None:
    """What is said of roots that have been named, and of nothing new."""
    related = {name for _, own in known.rooted for one in own for name in one.names}
    named = {name for names, _ in known.rooted for name in names}
    if len(item.members) < 2 or named.isdisjoint(item.names) or item.derives:
        return None
    heads = item.printed.heads
    given = {*heads.names, *heads.squares, *heads.multiples, *item.names - related}
    new = any(name not in related and is_fresh(name, item, known) for name in given)
    case = item.typed.inline and item.names <= named and not cue("deduced", item.lead)
    if new or case or supposing(item) or cue("define", item.lead):
        return None
    return StatementRole(CLAIM, "an equation between what is known", "identity")


def of_named_roots(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation for a letter of its own, of which words name the roots: it need not hold."""
    if len(item.members) != 2 or item.derives or isinstance(item.members[0], Name | Application):
        return None
    beside = (one for one in known.items if abs(one.order - item.order) < _NEAR)
    mentioned = {name for law in known.laws for name in law.mentions}
    for one in beside:
        roots = roots_named(one, known.paper, mentioned) if _letters(one) else None
        if roots is not None and item in _spoken_of(_list_before(one, known.paper), known.paper):
            new = not any(_is_old(name, one, known) for name in roots.names)
            if new and roots.letter in item.names and not known.varies(roots.letter):
                why = f"{', '.join(map(plain, roots.names))} are its roots"
                return StatementRole(OTHER, f"{why}: it is not said to hold always")
    return None


_NEAR = 6
"""So many formulas are between an equation and the letters for its roots at most."""


def _given(item: SourceStatement, known: Known) -> list[SourceStatement]:
    """The equations before a statement that hold where it stands, those that it cites last."""
    here, cited = {*known.supposed(item)}, [*known.cited(item)]
    before = [
        one
        for one, role in known.roles.items()
        if one.order < item.order
        and role.name in (CLAIM, DEFINITION, LEVEL)
        and {*known.supposed(one)} <= here
    ]
    return sorted(before, key=lambda one: (one in cited, one.order))


def _is_old(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a name moves, is given, or stands in an equation before, and is not new here."""
    if any(name in law.new for law in known.laws if law.together):
        return False
    if known.moves(name) or known.is_defined(name):
        return True
    first = known.seen.get(name)
    if first is None or first.sentence == item.sentence:
        return False
    return known.roles[first].kind != "inequality"
