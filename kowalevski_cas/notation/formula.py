"""The formula: an immutable tree of what is printed.

A node says what stands on the paper and nothing about what it means: whether
``c_1(w_1^2+x_1)`` is a product, which names exist and along which field a dot
differentiates is the business of a :class:`~kowalevski_cas.notation.Vocabulary`
and of a scene.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import wraps
from inspect import get_annotations
from operator import is_
from typing import Any, ClassVar, TypeVar, dataclass_transform

Kind = TypeVar("Kind")

EQUALITIES = frozenset({"=", r"\equiv"})
"""The signs that say that two members are equal."""


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def node(kind: type[Kind]) -> type[Kind]:
    """A kind of nodes with the attributes that it declares. Type checkers let nobody change one.

    A frozen dataclass would see to it at run time as well, whenever one of so many nodes is made.
    """
    return dataclass(unsafe_hash=True)(kind)


@node
class Formula:
    """A node of the tree. Children are formulas or tuples of formulas."""

    _below: ClassVar[tuple[tuple[str, bool], ...]] = ()
    """The attributes with children, and whether there is a tuple of them."""

    method: ClassVar[str]
    """What a printer calls the method for such nodes."""

    bracket: str = field(default="", kw_only=True, compare=False, repr=False)
    """The opening bracket in which it is printed: nothing of its meaning, and two formulas that
    differ in no more are equal."""

    def __init_subclass__(cls) -> None:
        kinds = {"Formula": False, "tuple[Formula, ...]": True}
        annotations = get_annotations(cls).items()
        cls._below += tuple((name, kinds[kind]) for name, kind in annotations if kind in kinds)
        cls.method = re.sub(r"(?<!^)(?=[A-Z])", "_", cls.__name__).lower()

    def __reduce__(self) -> tuple[type[Formula], tuple[object, ...], dict[str, str]]:
        """What was found of a node and is kept with it is no part of it."""
        names: tuple[str, ...] = self.__match_args__
        values = tuple(getattr(self, name) for name in names)
        return type(self), values, {"bracket": self.bracket}

    def children(self) -> tuple[Formula, ...]:
        """The subformulas directly below this node, from left to right."""
        found: tuple[Formula, ...] = ()
        for name, several in self._below:
            value = getattr(self, name)
            found += value if several else (value,)
        return found

    def nodes(self) -> Iterator[Formula]:
        """The formula and all its subformulas, each before those below it, from left to right."""
        waiting: list[Formula] = [self]
        while waiting:
            formula = waiting.pop()
            yield formula
            if formula._below:
                waiting += reversed(formula.children())

    def names(self) -> set[str]:
        """The names that stand in the formula."""
        return {node.name for node in self.nodes() if isinstance(node, Name)}

    def map_children(self, change: Callable[[Formula], Formula]) -> Formula:
        """The formula with its children changed; itself, if no child is another one."""
        changed = {}
        for name, several in self._below:
            old: Any = getattr(self, name)
            new: Any = tuple(map(change, old)) if several else change(old)
            if not (all(map(is_, old, new)) if several else old is new):
                changed[name] = new
        return replace(self, **changed) if changed else self


@node
class Unary(Formula):
    """A node with one argument."""

    argument: Formula


@node
class Binary(Formula):
    """A node with two arguments."""

    left: Formula
    right: Formula


@node
class Number(Formula):
    """A non-negative integer, as printed."""

    value: int


@node
class Name(Formula):
    r"""A symbol with its index, in canonical LaTeX: ``\omega_1``, ``\boldsymbol{\alpha}``."""

    name: str


@node
class Sum(Formula):
    """Two or more terms; a subtracted term is a :class:`Negative`."""

    terms: tuple[Formula, ...]


class Negative(Unary):
    """A term with a minus sign."""


@node
class Product(Formula):
    """Two or more factors, printed side by side."""

    factors: tuple[Formula, ...]


@node
class Quotient(Formula):
    r"""``\frac{numerator}{denominator}``, or a slash."""

    numerator: Formula
    denominator: Formula


@node
class Power(Formula):
    """A base with an exponent, which may be a formula of symbols."""

    base: Formula
    exponent: Formula


class Root(Unary):
    """A square root."""


@node
class Radical(Unary):
    r"""A root of an order above two, as :math:`\sqrt[3]{x}`: of odd order it is real everywhere."""

    order: int


@node
class Derivative(Unary):
    r"""A derivative along the motion.

    ``mark`` is how it is printed: ``"dot"``, ``"prime"``, or the independent
    variable of a written-out quotient, as ``"\tau"`` in :math:`dF/d\tau`.
    """

    mark: str


@node
class Partial(Unary):
    r"""The partial derivative by a name, printed :math:`\partial f/\partial x`."""

    by: str


class Conjugate(Unary):
    """The complex conjugate, printed with a bar."""


class RealPart(Unary):
    """The real part."""


class ImaginaryPart(Unary):
    """The imaginary part."""


@node
class Application(Formula):
    r"""A declared function applied to arguments, as :math:`\varphi(s_1)`."""

    function: str
    arguments: tuple[Formula, ...]


@node
class Vector(Formula):
    """Components in parentheses, as ``(1,0,0)``."""

    components: tuple[Formula, ...]


@node
class Diagonal(Formula):
    """A diagonal matrix by its entries."""

    entries: tuple[Formula, ...]


class ScalarProduct(Binary):
    """The scalar product of two vectors, printed as a pair in parentheses."""


class CrossProduct(Binary):
    """The vector product."""


class PoissonBracket(Binary):
    r"""The Poisson bracket of two functions, as :math:`\{H,K\}`."""


class Commutator(Binary):
    r"""The commutator :math:`[L,M]=LM-ML` of two matrices."""


class Transposed(Unary):
    r"""The transposed matrix, as :math:`R^T`."""


class Modulus(Unary):
    r"""The absolute value of a number, or the length of a vector: :math:`|x|`."""


@node
class Summation(Formula):
    r"""A sum over an index, as :math:`\sum_{i=1}^{3}p_i^2`; it reaches as far as a term does."""

    index: str
    first: Formula
    last: Formula
    body: Formula


class Unwritten(Formula):
    """An ellipsis: terms that the author does not print."""


class Constant(Formula):
    r"""The word ``const`` at the end of a chain of equalities."""


@node
class Relation(Formula):
    r"""A chain ``members[0] signs[0] members[1] …`` with signs ``=``, ``\equiv``, ``\ne``."""

    members: tuple[Formula, ...]
    signs: tuple[str, ...]

    @property
    def is_equality(self) -> bool:
        """Whether all members are said to be equal."""
        return EQUALITIES.issuperset(self.signs)


Found = TypeVar("Found")


def once(function: Callable[[Formula], Found]) -> Callable[[Formula], Found]:
    """A function of formulas, whose value is found once for each of them and kept with it.

    All who ask are given the same value, which nobody changes.
    """
    name = f"{function.__module__}.{function.__qualname__}"

    @wraps(function)
    def found(formula: Formula) -> Found:
        value: Found
        try:
            value = getattr(formula, name)
        except AttributeError:
            setattr(formula, name, value := function(formula))
        return value

    return found


def total(terms: Iterable[Formula]) -> Formula:
    """The sum of any number of terms."""
    found = tuple(terms)
    return Sum(found) if len(found) > 1 else found[0] if found else Number(0)


def times(*factors: Formula) -> Formula:
    """The product of any number of factors, without those that are 1."""
    kept = tuple(factor for factor in factors if factor != Number(1))
    return Product(kept) if len(kept) > 1 else kept[0] if kept else Number(1)


def power(base: Formula, exponent: Formula | int) -> Formula:
    """A power, which is the base if the exponent is 1."""
    raised = Number(exponent) if isinstance(exponent, int) else exponent
    return base if raised == Number(1) else Power(base, raised)


def equal(*members: Formula) -> Formula:
    """That several members are equal; a single one is left alone."""
    return Relation(members, ("=",) * (len(members) - 1)) if len(members) > 1 else members[0]


@node
class Changed(Unary):
    """A part that another formula has not: ``wrong`` if it should not stand, else as it should.

    No reader gives it; it is for a printer, which marks the part, or in a sum the ``sign`` before
    it alone.
    """

    wrong: bool = False
    sign: bool = False
