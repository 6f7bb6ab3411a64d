r"""Vectors in steps of derivations, by components of which nobody needs to know the directions.

Where a vector product stands, each vector has three components; else one does, and what fails with
one is false.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial

from kowalevski_cas.algebra.samples import Valueless
from kowalevski_cas.notation import (
    CrossProduct,
    Derivative,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    ScalarProduct,
    Sum,
    Vector,
    Vocabulary,
    rank,
    times,
    total,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR, VECTOR

SPACE = range(3)
ZERO = Number(0)
NABLA, CURL, LAPLACE = r"\nabla ", r"\nabla\times ", r"\nabla^2 "
"""How the names of a gradient, of a curl, and of what Laplace's operator makes begin."""
_LENGTHS = frozenset({"v", "r", "p", "u", r"\omega", r"\Omega"})
"""The letters of vectors of which the same letters in other type are the lengths."""


AXES = ("x", "y", "z")


def is_derived_vector(name: str) -> bool:
    """Whether it is the name of a gradient, of a curl, or of a vector from Laplace's operator."""
    bold = symbol(name.removeprefix(LAPLACE)).is_bold
    return name.startswith((NABLA, CURL)) or (name.startswith(LAPLACE) and bold)


def multiplies_vectors(formulas: Sequence[Formula]) -> bool:
    """Whether a vector product, or a unit vector of an axis, stands in formulas."""
    return any(
        isinstance(node, CrossProduct) or (isinstance(node, Name) and axis_of(node.name))
        for one in formulas
        for node in one.nodes()
    )


def axis_of(name: str) -> str:
    r"""The axis of a unit vector, as x of :math:`\mathbf e_x` and of :math:`\hat{\mathbf x}`."""
    parts = symbol(name)
    hat = r"\hat" in parts.accents
    axis = parts.index if parts.letter == "e" else "" if parts.index or not hat else parts.letter
    return axis if parts.is_bold and axis in AXES else ""


class Components:
    """Vectors by their components, of which some are printed beside them: others are new names."""

    def __init__(self, words: Vocabulary, names: Collection[str]) -> None:
        self._words, self._names = words, {*names}

    def of(self, formula: Formula) -> list[Formula]:
        """What an equation says of the components of its vectors.

        Raises:
            Valueless: it cannot be written by them.
        """
        if not isinstance(formula, Relation):
            return [formula]
        ranks = {rank(one, self._words) for one in formula.members if one != ZERO}
        if ranks == {SCALAR} or not ranks:
            return [Relation((*map(self._number, formula.members),), formula.signs)]
        if ranks != {VECTOR}:
            raise Valueless("members of several kinds")
        members = map(self._vector, formula.members)
        return [Relation(row, formula.signs) for row in zip(*members, strict=True)]

    def _number(self, formula: Formula) -> Formula:
        """A number, with its vectors by components."""
        match formula:
            case ScalarProduct(left, right):
                sides = zip(self._vector(left), self._vector(right), strict=True)
                return Sum((*(Product(pair) for pair in sides),))
            case Power(base, Number(2)) if rank(base, self._words) == VECTOR:
                return self._square(base)
            case Modulus(inner) if rank(inner, self._words) == VECTOR:
                return Root(self._square(inner))
        by_vector = isinstance(formula, Partial) and self._words.rank(formula.by) != SCALAR
        if by_vector or rank(formula, self._words) != SCALAR:
            raise Valueless("no number")
        return formula.map_children(self._number)

    def _square(self, formula: Formula) -> Formula:
        return Sum((*(Power(one, Number(2)) for one in self._vector(formula)),))

    def _vector(self, formula: Formula) -> tuple[Formula, ...]:
        """The components of a vector."""
        if formula == ZERO:
            return (ZERO,) * len(SPACE)
        if rank(formula, self._words) in (MATRIX, SCALAR):
            raise Valueless("no vector")

        def of(part: Formula, k: int) -> Formula:
            is_vector = rank(part, self._words) == VECTOR
            return self._vector(part)[k] if is_vector else self._number(part)

        match formula:
            case Name(name):
                return self._named(name)
            case Vector(entries) if len(entries) == len(SPACE):
                return (*map(self._number, entries),)
            case CrossProduct(left, right):
                a, b = self._vector(left), self._vector(right)
                pairs = ((a[k - 2], b[k - 1], a[k - 1], b[k - 2]) for k in SPACE)
                return (*(Sum((times(p, q), Negative(times(r, s)))) for p, q, r, s in pairs),)
            case Derivative(Name(name)) if axis_of(name):
                raise Valueless("axes that turn")
            case Partial(inner, by) if rank(inner, self._words) == SCALAR:
                return (*(Partial(self._number(inner), f"{by}[{k}]") for k in SPACE),)
            case Negative() | Derivative() | Partial() | Sum() | Product() | Quotient():
                return (*(formula.map_children(partial(of, k=k)) for k in SPACE),)
        raise Valueless(type(formula).__name__)

    def _named(self, name: str) -> tuple[Formula, ...]:
        """The components of a vector, as they are named if more than one of them is printed."""
        if axis := axis_of(name):
            return (*(Number(int(one == axis)) for one in AXES),)
        parts = symbol(name)
        printed = [parts.component(one).name for one in AXES]
        if parts.without_type.name == "r" and len({*AXES} & self._names) > 1:
            printed = [*AXES]
        if len({*printed} & self._names) > 1:
            return (*map(Name, printed),)
        return (*(Name(f"{name}[{k}]") for k in SPACE),)


# -- what is usually meant ------------------------------------------------------------------


def usual_meanings(formulas: Sequence[Formula], words: Vocabulary) -> Iterator[Formula]:
    r"""What the usual letters of vectors mean, where nothing gives them.

    The acceleration is the rate of the velocity; a length is that of its vector; a function of the
    place changes by its gradient times the velocity, and :math:`\mathbf r=r\mathbf e_r`.
    """
    nodes = {node for one in formulas for node in one.nodes()}
    names = {node.name for node in nodes if isinstance(node, Name)}
    firsts = (one.members[0] for one in formulas if isinstance(one, Relation))
    given = {one.name for one in firsts if isinstance(one, Name)}
    lengths = {name for one in formulas for name in _by_squares(one)}
    for name in sorted(name for name in names if words.rank(name) == VECTOR):
        parts = symbol(name)
        velocity = replace(parts, letter="v").name
        plain, radial = parts.without_type.name, replace(parts, letter="e", index="r").name
        if parts.letter == "a" and velocity in names - {name} and name not in given:
            yield _equal(Name(name), Derivative(Name(velocity), "dot"))
        for primes in range(3) if parts.letter in _LENGTHS and plain not in lengths else ():
            pair = [_primed(Name(one), primes) for one in (plain, name)]
            if nodes.issuperset(pair):
                yield _equal(*(Power(one, Number(2)) for one in pair))
        if parts.letter == "r" and {plain, radial} <= names and name not in given | {radial}:
            yield _equal(Name(name), Product((Name(plain), Name(radial))))
    yield from _gradients(names, nodes, words)


def chain_rules(formulas: Sequence[Formula]) -> Iterator[Formula]:
    r"""How derivatives by old variables are those by new ones, where both are printed.

    So is :math:`\partial_qH=\partial_QH\,\partial_qQ+\partial_PH\,\partial_qP`, beside
    a product of such derivatives.
    """
    nodes = {node for one in formulas for node in one.nodes()}
    partials = {node for node in nodes if isinstance(node, Partial)}
    printed = {(one.argument.name, one.by) for one in partials if isinstance(one.argument, Name)}
    products = [{*node.factors} & partials for node in nodes if isinstance(node, Product)]
    for function, old in sorted(printed):
        by = {name for one, name in printed if one == function}
        new = [name for name in sorted(by) if (name, old) in printed]
        olds = {one for name, one in printed if name in new}
        terms = [(Partial(Name(function), name), Partial(Name(name), old)) for name in new]
        if by - olds == {*new} and any(one >= {*term} for one in products for term in terms):
            yield _equal(Partial(Name(function), old), total(map(Product, terms)))


def _by_squares(formula: Formula) -> Iterator[str]:
    r"""The lengths by their components, as r in :math:`r^2=x^2+y^2`: a vector is not one number."""
    members = getattr(formula, "members", ())
    if any(isinstance(one, Sum) and all(map(_squared, one.terms)) for one in members):
        yield from filter(None, map(_squared, members))


def _squared(formula: Formula) -> str:
    """The name of which a formula is the square, or none."""
    match formula:
        case Power(Name(name), Number(2)):
            return name
    return ""


def _primed(formula: Formula, primes: int) -> Formula:
    return _primed(Derivative(formula, "prime"), primes - 1) if primes else formula


def _gradients(names: set[str], nodes: set[Formula], words: Vocabulary) -> Iterator[Formula]:
    """How functions of which gradients are printed change where something moves."""
    letters = ((name, symbol(name)) for name in sorted(names) if words.rank(name) == VECTOR)
    moving = [Name(name) for name, parts in letters if (parts.letter, parts.index) == ("v", "")]
    for name in sorted(names):
        function = Name(name.removeprefix(NABLA))
        if name == function.name or len(moving) != 1 or words.rank(function.name):
            continue
        along: Formula = ScalarProduct(moving[0], Name(name))
        slope = Partial(function, "t")
        whole = Sum((slope, along)) if slope in nodes else along
        yield _equal(Derivative(function, "dot"), whole)


def _equal(left: Formula, right: Formula) -> Formula:
    return Relation((left, right), ("=",))
