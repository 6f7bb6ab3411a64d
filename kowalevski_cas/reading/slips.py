"""The slips that a step of a derivation may have: of one token, or a part of what stands before."""

from __future__ import annotations

from collections.abc import Iterator
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
from kowalevski_cas.notation.edits import subtree
from kowalevski_cas.notation.errors import closeness
from kowalevski_cas.notation.misprints import Misprint, factors_of, misprints
from kowalevski_cas.reading.premises import leaves_out
from kowalevski_cas.reading.steps import DerivationStep
from kowalevski_cas.verify.vacuous import ALIKE

KINDS = (
    "sign", "exponent", "power", "root", "index", "letter", "coefficient", "factor", "missing",
    "operation", "end",
)  # fmt: skip
"""The kinds of slips, the likelier ones first."""

LARGEST = 4
"""No number of a coefficient that is tried is larger."""

RATIOS = tuple(
    Number(above) if below == 1 else Quotient(Number(above), Number(below))
    for below in range(1, LARGEST + 1)
    for above in range(1, LARGEST + 1)
    if gcd(above, below) == 1 and (above, below) != (1, 1)
)
"""The numbers that a coefficient may be."""


def slips(step: DerivationStep, words: Vocabulary, offered: set[str]) -> Iterator[Misprint]:
    """The slips of a step: of one token, or a term or a factor of what stands before it."""
    yield from (slip for slip in misprints(step.formula, words, offered) if slip[0] in KINDS)
    waiting: list[tuple[tuple[int, ...], Formula, Formula | None]] = [((), step.formula, None)]
    while waiting:
        path, node, parent = waiting.pop()
        waiting += [((*path, k), child, node) for k, child in enumerate(node.children())]
        if _is_ratio(node):
            yield from (("coefficient", path, number, "") for number in RATIOS if number != node)
        yield from (*_of_two(path, node), *_roots(path, node, parent), *_ends(path, node, offered))
        yield from _squares(path, node, offered)
        if isinstance(parent, Sum | Negative | Relation) and isinstance(node, Name):
            for rate in sorted(step.before.rates, key=to_latex):
                yield "missing", path, times(node, rate), ""
        if isinstance(parent, Relation) and not isinstance(node, Constant | Unwritten):
            own = node.terms if isinstance(node, Sum) else (node,)
            for number in RATIOS:
                yield "coefficient", path, times(number, *factors_of(node)), ""
            for term in step.before.terms:
                yield "missing", path, Sum((term, *own)), ""


def _is_ratio(node: Formula) -> bool:
    """Whether a node is a quotient of whole numbers."""
    return isinstance(node, Quotient) and all(isinstance(n, Number) for n in node.children())


def _of_two(path: tuple[int, ...], node: Formula) -> Iterator[Misprint]:
    """A plus for a product, and a second derivative for the square of the first one."""
    match node:
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


def _roots(path: tuple[int, ...], node: Formula, parent: Formula | None) -> Iterator[Misprint]:
    """A square root more, of a member or a factor, or one less."""
    if isinstance(node, Root):
        yield "root", path, node.argument, ""
    elif isinstance(parent, Relation | Product) and isinstance(node, Quotient | Name | Sum):
        if not isinstance(parent, Relation) or path != (0,):
            yield "root", path, Root(node), ""


def _squares(path: tuple[int, ...], node: Formula, offered: set[str]) -> Iterator[Misprint]:
    """The square of a name that is missing above or below a line."""
    if isinstance(node, Quotient) and not _is_ratio(node):
        above, below = factors_of(node.numerator), factors_of(node.denominator)
        for square in (Power(Name(name), Number(2)) for name in sorted(offered)):
            yield "missing", path, Quotient(node.numerator, times(*below, square)), ""
            yield "missing", path, Quotient(times(*above, square), node.denominator), ""


def _ends(path: tuple[int, ...], node: Formula, offered: set[str]) -> Iterator[Misprint]:
    """Another name at an end of an integral."""
    match node:
        case Application(function, (_, _, by, _)) if function == INTEGRAL:
            for end, name in ((k, name) for k in (0, 1) for name in sorted(offered)):
                if Name(name) not in (node.arguments[end], by):
                    yield "end", (*path, end), Name(name), ""


def is_integrated(formula: Formula, path: tuple[int, ...]) -> bool:
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
