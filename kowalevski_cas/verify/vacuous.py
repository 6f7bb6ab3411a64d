"""What a proposal has to say: a statement that is true by itself corrects nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import combinations

from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Constant,
    Derivative,
    Edit,
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    subtree,
)
from kowalevski_cas.notation.errors import closeness
from kowalevski_cas.notation.misprints import factors_of
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.names import Images
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Exists, Follows, simple
from kowalevski_cas.verify.statement import Statement

ALIKE = 2.5
"""From what closeness on a name is easily taken for another one."""


def unlike(edit: Edit) -> bool:
    """Whether an edit puts a name in the place of one that neither looks nor sounds like it."""
    old, new = subtree(edit.statement.formula, edit.path), edit.replacement
    if not isinstance(old, Name) or not isinstance(new, Name):
        return False
    return closeness(old.name, new.name) < ALIKE


def says_something(neighbour: Neighbour, statement: Statement, printed: Statement) -> bool:
    """Whether a true neighbour is a statement about what is printed, and not true of itself.

    It involves variables if the print does, and the function that the print is about; no equation
    that it supposes vanishes identically, or is a multiple of another one, and it states no
    multiple of one of them; none of its formulas stands there twice; its sides are not the same and
    have no function as a common factor that they do not have in print, and no sum has a term twice,
    with either sign.
    """
    if _moves(printed) and not _moves(statement):
        return False
    for count in (_empty, _count_repeated, _count_printed_before):
        if (many := count(statement)) and many > count(printed):
            return False
    edit = neighbour.edit
    if edit is None:
        return True
    defined = set(neighbour.claim.scene.definitions)
    before, after = edit.statement.formula, edit.formula
    if _derives_what_stands(before, after, statement.on(neighbour.claim.scene)):
        return False
    replaced = (before.names() - after.names()) & defined
    if replaced and unlike(edit) and not edit.replacement.names() & defined:
        return False
    factors = _common(after) - _common(before)
    defined |= {n for name in defined for n in neighbour.claim.scene.vectors.get(name, ())}
    return is_trivial(before) >= is_trivial(after) and not factors & defined


def _moves(statement: Statement) -> bool:
    """Whether variables are reached from a statement."""
    return any(space.variables for space in statement.legend)


def _empty(statement: Statement) -> int:
    """How many of the equations that are supposed hold everywhere."""
    simple_ones = (part for goal in statement.goals for part in simple(goal))
    given = ((part.space, getattr(part, "given", ())) for part in simple_ones)
    return sum(d.is_zero for space, some in given for d in finder_of(space).differences(some))


def _count_printed_before(statement: Statement) -> int:
    """How many formulas of a claim stand there before."""
    formulas = statement.claim.formulas(statement.on.texts)
    return len(formulas) - len({*formulas})


def _count_repeated(statement: Statement) -> int:
    """How many equations that are supposed or stated are multiples of another that is supposed."""
    count = 0
    for goal in statement.goals:
        for part in simple(goal):
            at = finder_of(part.space)
            given, stated = at.differences(getattr(part, "given", ())), list[Element]()
            if isinstance(part, Follows) and not isinstance(goal, Exists):
                stated = [e for conclusion in part.conclusions for e in at.differences(conclusion)]
            count += _count_multiples(given, stated)
    return count


def _count_multiples(given: Sequence[Element], others: Sequence[Element]) -> int:
    """How many elements that do not vanish are multiples of a given one, which is another."""
    every, found = [*given, *others], set[int]()
    for k, one in enumerate(given):
        places = [n for n, element in enumerate(every) if n != k and not element.is_zero]
        vanish = vanish_on([every[n] for n in places], [one])
        found |= {n for n, vanishes in zip(places, vanish, strict=True) if vanishes}
    return len(found)


def _derives_what_stands(before: Formula, after: Formula, on: Elaboration) -> bool:
    """Whether an edit brings in a derivative that is zero by itself, as that of a constant."""
    rates, old = (
        Counter(node for node in formula.nodes() if isinstance(node, Derivative))
        for formula in (after, before)
    )
    new = [(on.plain(rate), Number(0)) for rate in rates - old]
    return any(rest.is_zero for rest in on.finder.differences(new))


def is_trivial(formula: Formula) -> bool:
    """Whether two sides, terms, or arguments of a bracket are the same, but for their signs.

    Or a factor that is no number stands both above and below a line.
    """
    nodes = [*formula.nodes()]
    several = (node for node in nodes if isinstance(node, Relation | PoissonBracket | Sum))
    return any(
        len({*map(_unsigned, node.children())}) < len(node.children()) for node in several
    ) or any(_is_cancelled(node) for node in nodes if isinstance(node, Quotient))


def _is_cancelled(quotient: Quotient) -> bool:
    factors = ({*factors_of(_unsigned(part))} for part in quotient.children())
    return any(not isinstance(one, Number) for one in set.intersection(*factors))


def _unsigned(formula: Formula) -> Formula:
    return formula.argument if isinstance(formula, Negative) else formula


def _common(formula: Formula) -> set[str]:
    """The names that are factors of all sides, or terms, but zeros."""
    match formula:
        case Name(name):
            return {name}
        case Number(0):
            return set()
        case Product():
            return set().union(*map(_common, formula.factors))
        case Negative() | Power():
            return _common(formula.children()[0])
        case Relation() | Sum():
            parts = [
                _common(part)
                for part in formula.children()
                if part != Number(0) and not isinstance(part, Constant)
            ]
            return set.intersection(*parts) if parts else set()
        case Quotient():
            return _common(formula.numerator)
    return set()


def stops(claim: Claim, edited: Neighbour, on: Elaborations) -> bool:
    """Whether what moves stands still when a claim is edited, or what is said to be constant."""
    now = on.under(edited.texts)
    about = {
        node.name
        for formula in claim.formulas(now.texts)
        for rate in formula.nodes()
        if isinstance(rate, Derivative)
        for node in rate.nodes()
        if isinstance(node, Name) and node.name in claim.scene.definitions
    }
    images: Images = getattr(claim, "images", ())  # those of a map
    return stands_still(on(claim.scene), now(edited.claim.scene), about, images)


def stands_still(
    before: Elaboration, after: Elaboration, names: Iterable[str], images: Images = ()
) -> bool:
    """Whether of what moves on a scene something stands still on an edited one, or of some names.

    So no law is changed into one of which anything is true, and no function into a constant; nor
    does a map leave a variable where it is. New names for variables may be integrals.
    """
    was, now = before.finder, after.finder
    if images:
        return any((now.scalar(Name(x)) - now.scalar(Name(new))).is_zero for x, new in images)
    moving = was.rates.items() if before.scene.field else ()
    new = _new_names(before)
    if any(
        now.rates[x].is_zero
        for x, rate in moving
        if x in now.rates and x not in new and not rate.is_zero
    ):
        return True
    return any(_still(name, now) and not _still(name, was) for name in names)


def _new_names(at: Elaboration) -> set[str]:
    """The variables by which others are given, of which the equations of motion print the rates."""
    scene = at.scene
    if isinstance(scene.field, Change):
        return {*scene.variables} - {*scene.field.source.variables}
    nodes = [node for place in scene.field for node in at.texts.formula(place).nodes()]
    rated = {n for node in nodes if isinstance(node, Derivative) for n in node.names()}
    if rated.isdisjoint(scene.definitions):
        return set()
    named = {node.name for node in nodes if isinstance(node, Name)}
    return {*scene.variables} - named - {n for v in named for n in scene.vectors.get(v, ())}


def count_equal_rates(scene: Elaboration) -> int:
    """How many pairs of variables have the same rate, which is not zero."""
    rates = [rate for rate in scene.finder.rates.values() if not rate.is_zero]
    return sum((one - other).is_zero for one, other in combinations(rates, 2))


def _still(name: str, at: Evaluation) -> bool:
    """Whether a name stands for numbers and constants."""
    parts = at.components(Name(name))
    return all(at.partial(part, x).is_zero for part in parts for x in at.setting.variables)
