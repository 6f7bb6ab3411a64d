"""The slips that a step of a derivation may have: of one token, or a part of what stands before."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace as fields_replaced
from math import gcd

from kowalevski_cas.algebra.quadrature import INTEGRAL
from kowalevski_cas.notation import (
    Application,
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    Unwritten,
    Vocabulary,
    times,
    to_latex,
    total,
)
from kowalevski_cas.notation.edits import replace, subtree
from kowalevski_cas.notation.errors import closeness
from kowalevski_cas.notation.misprints import HALF, TWO, Misprint, Path, factors_of, misprints
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.premises import leaves_out
from kowalevski_cas.reading.steps import DerivationStep
from kowalevski_cas.verify.vacuous import ALIKE

KINDS = (
    "sign", "exponent", "power", "root", "index", "letter", "coefficient", "factor", "missing",
    "operation", "end",
)  # fmt: skip
"""The kinds of slips, the likelier ones first."""

LIKELY = frozenset({"sign", "exponent", "index", "letter", "coefficient", "factor"})
"""Those that are looked for in what a step rests on."""

LARGEST = 4
"""No number of a coefficient that is tried is larger."""

RATIOS = tuple(
    Number(above) if below == 1 else Quotient(Number(above), Number(below))
    for below in range(1, LARGEST + 1)
    for above in range(1, LARGEST + 1)
    if gcd(above, below) == 1 and (above, below) != (1, 1)
)
"""The numbers that a coefficient may be."""

_FIRST = re.compile(r"(?<!\d)1(?!\d)")
"""The first value of an index."""


def slips(step: DerivationStep, words: Vocabulary, offered: set[str]) -> Iterator[Misprint]:
    """The slips of a step: of one token, or a term or a factor of what stands before it."""
    yield from (slip for slip in misprints(step.formula, words, offered) if slip[0] in KINDS)
    waiting: list[tuple[Path, Formula, Formula | None]] = [((), step.formula, None)]
    while waiting:
        path, node, parent = waiting.pop()
        waiting += [((*path, k), child, node) for k, child in enumerate(node.children())]
        if _is_ratio(node):
            yield from (("coefficient", path, number, "") for number in RATIOS if number != node)
        if isinstance(node, Quotient) and path != (0,):
            yield "factor", path, node.numerator, ""
        yield from (*_of_two(path, node), *_roots(path, node, parent), *_ends(path, node, offered))
        yield from (*_squares(path, node, offered), *_from_before(path, node, parent, step))


def _from_before(
    path: Path, node: Formula, parent: Formula | None, step: DerivationStep
) -> Iterator[Misprint]:
    """A factor of a term, or a term of a member, that stands before; a number before either."""
    if isinstance(parent, Sum | Negative | Relation) and isinstance(node, Name | Product):
        before = step.before
        rates = {one for one in before.printed if isinstance(one, Derivative)}
        factors = before.factors | (rates if isinstance(node, Name) else set())
        for factor in sorted(factors - {*factors_of(node)}, key=to_latex):
            yield "missing", path, times(*factors_of(node), factor), ""
    if isinstance(parent, Sum | Negative) and isinstance(node, Sum) and _is_summed(node):
        yield from (("coefficient", path, times(number, node), "") for number in (TWO, HALF))
    if isinstance(parent, Relation) and not isinstance(node, Constant | Unwritten):
        own = node.terms if isinstance(node, Sum) else (node,)
        for number in RATIOS:
            yield "coefficient", path, times(number, *factors_of(node)), ""
        for term in step.before.terms:
            yield "missing", path, Sum((term, *own)), ""


def with_slip(formula: Formula, path: Path, new: Formula) -> list[Formula]:
    """A formula with a slip; of the first term of a sum over an index, also with it in all."""
    if isinstance(formula, Relation) and path == (0,) and new == Negative(formula.members[0]):
        first, *others = formula.members  # no formula begins with a minus
        return [fields_replaced(formula, members=(first, *map(_negated, others)))]
    found = [replace(formula, path, new)]
    for length, place in enumerate(path):
        node = subtree(formula, path[:length])
        if isinstance(node, Sum) and not place and _is_summed(node):
            term = subtree(found[-1], path[: length + 1])
            terms = (_of_index(term, number) for number in range(1, len(node.terms) + 1))
            every = fields_replaced(node, terms=(*terms,))
            found.append(replace(found[-1], path[:length], every))
    return found


def _negated(formula: Formula) -> Formula:
    """A member with the other signs."""
    if isinstance(formula, Sum):
        return Sum((*map(_negated, formula.terms),))
    return formula.argument if isinstance(formula, Negative) else Negative(formula)


def _is_summed(node: Sum) -> bool:
    """Whether its terms are the first one for each value of an index, from 1 on."""
    first, *others = node.terms
    return first != others[0] and all(
        _of_index(first, number) == one for number, one in enumerate(others, 2)
    )


def _of_index(formula: Formula, number: int) -> Formula:
    """A formula with another index for 1."""
    if isinstance(formula, Name):
        return Name(_with_index(formula.name, number))
    found = formula.map_children(lambda child: _of_index(child, number))
    if isinstance(found, Partial):
        return fields_replaced(found, by=_with_index(found.by, number))
    return found


def _with_index(name: str, number: int) -> str:
    parts = symbol(name)
    index = _FIRST.sub(str(number), parts.index)
    return fields_replaced(parts, index=index).name


def _is_ratio(node: Formula) -> bool:
    """Whether a node is a quotient of whole numbers."""
    return isinstance(node, Quotient) and all(isinstance(n, Number) for n in node.children())


def _of_two(path: Path, node: Formula) -> Iterator[Misprint]:
    """A plus for a product, or a product for it; a second derivative for a square of the first."""
    match node:
        case Product((Name(), Name()) as factors):
            yield "operation", path, Sum(factors), ""
        case Sum(terms):
            for k in range(1, len(terms)):
                if leaves_out(terms[k]):
                    continue
                joined = times(*factors_of(terms[k - 1]), *factors_of(terms[k]))
                yield "operation", path, total((*terms[: k - 1], joined, *terms[k + 1 :])), ""
        case Derivative(Derivative(_, mark) as inner, other) if mark == other:
            yield "operation", path, Power(inner, Number(2)), ""
        case Partial(Name() as inner, by):
            yield "letter", path, Partial(inner, f"{by}'"), ""


def _roots(path: Path, node: Formula, parent: Formula | None) -> Iterator[Misprint]:
    """A square root more, of a member or a factor, or one less."""
    if isinstance(node, Root):
        yield "root", path, node.argument, ""
    elif isinstance(parent, Relation | Product) and isinstance(node, Quotient | Name | Sum):
        if not isinstance(parent, Relation) or path != (0,):
            yield "root", path, Root(node), ""


def _squares(path: Path, node: Formula, offered: set[str]) -> Iterator[Misprint]:
    """The square of a name that is missing above or below a line."""
    if isinstance(node, Quotient) and not _is_ratio(node):
        above, below = factors_of(node.numerator), factors_of(node.denominator)
        for square in (Power(Name(name), Number(2)) for name in sorted(offered)):
            yield "missing", path, Quotient(node.numerator, times(*below, square)), ""
            yield "missing", path, Quotient(times(*above, square), node.denominator), ""


def _ends(path: Path, node: Formula, offered: set[str]) -> Iterator[Misprint]:
    """Another name at an end of an integral."""
    match node:
        case Application(function, (_, _, by, _)) if function == INTEGRAL:
            for end, name in ((k, name) for k in (0, 1) for name in sorted(offered)):
                if Name(name) not in (node.arguments[end], by):
                    yield "end", (*path, end), Name(name), ""


def is_integrated(formula: Formula, path: Path) -> bool:
    """Whether a place is in an integral: other integrands take long, and are not tried."""
    above = (subtree(formula, path[:length]) for length in range(len(path) - 1))
    inner = any(isinstance(node, Application) and node.function == INTEGRAL for node in above)
    last = subtree(formula, path[:-1]) if path else formula
    ends = isinstance(last, Application) and last.function == INTEGRAL and path[-1] > 1
    return inner or ends


def may_be(formula: Formula, slip: Misprint, lost: frozenset[str] = frozenset()) -> bool:
    """Whether a slip is one: no name of another kind, no name by itself, no term twice.

    In the place of a name that is ``lost`` any other one may be meant.
    """
    kind, path, new, _ = slip
    old = subtree(formula, path)
    members = formula.members if isinstance(formula, Relation) else (formula,)
    if kind == "end":
        return True
    if isinstance(old, Name) and isinstance(new, Name):
        return path != (0,) and (old.name in lost or closeness(old.name, new.name) >= ALIKE)
    alone = {one.name for one in members if isinstance(one, Name)}
    if path[:1] == (0,) and alone & members[0].names():
        return kind == "coefficient"
    if kind != "missing":
        return True
    added = {term for term in getattr(new, "terms", ())} - {*getattr(old, "terms", (old,))}
    terms = {term for one in members for term in getattr(one, "terms", (one,))}
    return alone.isdisjoint(new.names() - old.names()) and added.isdisjoint(terms)
