r"""Vectors in steps of derivations, by components of which nobody needs to know the directions.

Where a vector product stands, each vector has three components; else one does, and what fails with
one is false.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain

from kowalevski_cas.algebra.samples import Valueless
from kowalevski_cas.notation import (
    Application,
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
    Transposed,
    Vector,
    Vocabulary,
    rank,
    times,
    to_latex,
    total,
)
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR, VECTOR

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


Row = tuple[Formula, ...]
"""The components of a vector, or a row of a matrix."""


def dimension(formulas: Sequence[Formula]) -> int:
    """How many components vectors have in formulas; one, if nothing tells that they have more.

    A vector product tells it, a unit vector of an axis, and a matrix that is printed.
    """
    nodes = {node for one in formulas for node in one.nodes()}
    if any(isinstance(one, CrossProduct) for one in nodes):
        return len(AXES)
    matrices = [one for one in nodes if isinstance(one, Vector) and _is_matrix(one)]
    sizes = {
        len(row) for one in matrices for row in (one.components, *map(_entries, one.components))
    }
    if len(sizes) == 1:
        return sizes.pop()
    named = any(isinstance(one, Name) and axis_of(one.name) for one in nodes)
    return len(AXES) if named else 1


def _is_matrix(formula: Vector) -> bool:
    return all(isinstance(one, Vector) for one in formula.components)


def _entries(row: Formula) -> Row:
    return row.components if isinstance(row, Vector) else ()


def axis_of(name: str) -> str:
    r"""The axis of a unit vector, as x of :math:`\mathbf e_x` and of :math:`\hat{\mathbf x}`."""
    parts = symbol(name)
    hat = r"\hat" in parts.accents
    axis = parts.index if parts.letter == "e" else "" if parts.index or not hat else parts.letter
    return axis if parts.is_bold and axis in AXES else ""


class Components:
    """Vectors by their components, of which some are printed beside them: others are new names.

    So are matrices by their entries.
    """

    def __init__(self, words: Vocabulary, names: Collection[str], size: int) -> None:
        self._words, self._names, self._places = words, {*names}, range(size)
        self._found: dict[Formula, Row] = {}

    def of(self, formula: Formula) -> list[Formula]:
        """What an equation says of the components of its vectors.

        Raises:
            Valueless: it cannot be written by them.
        """
        if not isinstance(formula, Relation):
            return [formula]
        if any(map(_turns, formula.nodes())):
            raise Valueless("axes that turn")
        members = [one for one in formula.members if one != ZERO]
        ranks = {self._rank(one) for one in members}
        if MATRIX in ranks and all(self._is_matrix(one) for one in members):
            matrices = [[*chain(*self._matrix(one))] for one in formula.members]
            return [Relation(row, formula.signs) for row in zip(*matrices, strict=True)]
        if ranks <= {SCALAR}:
            return [Relation((*map(self._number, formula.members),), formula.signs)]
        if ranks != {VECTOR}:
            raise Valueless("members of several kinds")
        vectors = map(self._vector, formula.members)
        return [Relation(row, formula.signs) for row in zip(*vectors, strict=True)]

    def _rank(self, formula: Formula) -> int:
        return rank(formula, self._words)

    def _is_matrix(self, formula: Formula) -> bool:
        """Whether it is a matrix, or what may be one at an argument."""
        return self._rank(formula) == MATRIX or isinstance(formula, Application)

    def _number(self, formula: Formula) -> Formula:
        """A number, with its vectors by components."""
        match formula:
            case ScalarProduct(left, right):
                return _sum_of_products(self._vector(left), self._vector(right))
            case Power(base, Number(2)) if self._rank(base) == VECTOR:
                return self._square(base)
            case Modulus(inner) if self._rank(inner) == VECTOR:
                return Root(self._square(inner))
        by_vector = isinstance(formula, Partial) and self._words.rank(formula.by) != SCALAR
        if by_vector or self._rank(formula) != SCALAR:
            raise Valueless("no number")
        return formula.map_children(self._number)

    def _square(self, formula: Formula) -> Formula:
        return Sum((*(Power(one, Number(2)) for one in self._vector(formula)),))

    def _vector(self, formula: Formula) -> Row:
        """The components of a vector, which are found once."""
        if formula not in self._found:
            self._found[formula] = self._components(formula)
        return self._found[formula]

    def _components(self, formula: Formula) -> Row:
        if formula == ZERO:
            return (ZERO,) * len(self._places)
        if self._rank(formula) in (MATRIX, SCALAR):
            raise Valueless("no vector")

        def of(part: Formula, k: int) -> Formula:
            is_vector = self._rank(part) == VECTOR
            return self._vector(part)[k] if is_vector else self._number(part)

        match formula:
            case Name(name):
                return self._named(name)
            case Vector(entries) if len(entries) == len(self._places):
                return (*map(self._number, entries),)
            case CrossProduct(left, right):
                a, b = self._vector(left), self._vector(right)
                pairs = ((a[k - 2], b[k - 1], a[k - 1], b[k - 2]) for k in range(3))
                return (*(Sum((times(p, q), Negative(times(r, s)))) for p, q, r, s in pairs),)
            case Product(factors) if MATRIX in map(self._rank, factors):
                return self._turned(factors)
            case Partial(inner, by) if self._rank(inner) == SCALAR:
                return (*(Partial(self._number(inner), f"{by}[{k}]") for k in self._places),)
            case Negative() | Derivative() | Partial() | Sum() | Product() | Quotient():
                return (*(formula.map_children(partial(of, k=k)) for k in self._places),)
        raise Valueless(type(formula).__name__)

    def _turned(self, factors: Sequence[Formula]) -> Row:
        """The components of a vector behind matrices."""
        *matrices, vector = factors
        column, rows = self._vector(vector), self._matrix(Product((*matrices,)))
        return (*(_sum_of_products(row, column) for row in rows),)

    def _matrix(self, formula: Formula) -> list[Row]:
        """The rows of a matrix."""
        places = self._places
        match formula:
            case Name() | Application():
                name = to_latex(formula)
                return [(*(Name(f"{name}[{j}{k}]") for k in places),) for j in places]
            case Vector(rows) if len(rows) == len(places) and self._rank(formula) == MATRIX:
                return [(*map(self._number, _entries(row)),) for row in rows]
            case Transposed(inner):
                return [*zip(*self._matrix(inner), strict=True)]
            case Power(base, Number(power)) if power in (2, 3):
                return self._matrix(Product((base,) * int(power)))
            case Negative() | Sum() | Derivative():
                parts = [self._matrix(one) for one in formula.children()]
                return [
                    (*(_with_children(formula, [one[j][k] for one in parts]) for k in places),)
                    for j in places
                ]
            case Product(factors):
                numbers = [self._number(one) for one in factors if self._rank(one) == SCALAR]
                found, *others = (self._matrix(one) for one in factors if self._rank(one) == MATRIX)
                for other in others:
                    columns = [*zip(*other, strict=True)]
                    found = [(*(_sum_of_products(row, one) for one in columns),) for row in found]
                return [(*(times(*numbers, one) for one in row),) for row in found]
        raise Valueless(type(formula).__name__)

    def _named(self, name: str) -> Row:
        """The components of a vector, as they are named if more than one of them is printed."""
        if axis := axis_of(name):
            return (*(Number(int(one == axis)) for one in AXES),)
        parts = symbol(name)
        axes = AXES[: len(self._places)]
        printed = [parts.component(one).name for one in axes]
        places = [replace(parts.without_type, letter=one).name for one in axes]
        if parts.letter == "r" and len({*places} & self._names) > 1:
            printed = places
        if len({*printed} & self._names) > 1 and len(axes) == len(self._places):
            return (*map(Name, printed),)
        return (*(Name(f"{name}[{k}]") for k in self._places),)


def _turns(node: Formula) -> bool:
    """Whether it is the rate of an axis."""
    inner = node.argument if isinstance(node, Derivative) else None
    return isinstance(inner, Name) and bool(axis_of(inner.name))


def _sum_of_products(one: Row, other: Row) -> Formula:
    return Sum((*map(Product, zip(one, other, strict=True)),))


def _with_children(formula: Formula, children: Sequence[Formula]) -> Formula:
    """A formula with other children, in their order."""
    given = iter(children)
    return formula.map_children(lambda _: next(given))


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
