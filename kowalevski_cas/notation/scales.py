r"""How formulas scale: what has a dimension is multiplied by a number when units are changed.

A quantity is a product of powers of names, up to numbers: :math:`m\dot x^2` is
:math:`m\,x^2\,t^{-2}`. What is added, compared, or set equal scales alike, and the argument of a
sine does not scale. So a formula says of some products of powers that they do not scale, and these
are linear equations for the dimensions of its names.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from kowalevski_cas.notation.formula import (
    Application,
    Commutator,
    CrossProduct,
    Derivative,
    Formula,
    ImaginaryPart,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Radical,
    RealPart,
    Relation,
    Root,
    ScalarProduct,
    Sum,
    Summation,
    Transposed,
)
from kowalevski_cas.notation.functions import EXTREMES, FAMILY_OF, FUNCTIONS, OF_A_MATRIX, SIGN
from kowalevski_cas.notation.symbol import name_of_rate, symbol

MODULUS = 2**31 - 1
"""Of a prime: exponents are counted modulo it, and a half is a whole number then."""

Scale = Mapping[str, int]
"""A product of powers: the exponent of each name, modulo the prime."""

TIME = "t"
"""By what a dot derives."""

_OF_ANY = frozenset({SIGN, *EXTREMES, *OF_A_MATRIX, r"\ln", r"\log"})
"""The functions whose argument may scale."""


class Unscaled(Exception):
    """What a formula stands for is no product of powers of names, as a vector by its components."""


class Scales:
    """What a formula says of the scales of its names.

    ``alike`` are the quotients of what is added, compared or set equal there, and ``pure`` what
    stands as an argument, an exponent or an index: neither scales. ``atoms`` are the scales of its
    names, and of what it derives. ``primed`` is the variable by which a prime derives.
    """

    def __init__(self, formula: Formula, primed: str = TIME) -> None:
        self._by = {"dot": TIME, "prime": primed}
        self.alike: list[Scale] = []
        self.pure: list[Scale] = []
        self.atoms: list[Scale] = []
        self._scale(formula)

    @property
    def all(self) -> list[Scale]:
        """What does not scale."""
        return [*self.alike, *self.pure]

    @property
    def names(self) -> set[str]:
        """The names that may scale."""
        return {name for atom in self.atoms for name in atom}

    def _scale(self, node: Formula) -> Scale | None:
        """The scale of a node; ``None`` of what scales as anything, as zero, or is not known."""
        try:
            return self._known(node)
        except Unscaled:
            return None

    def _needed(self, *nodes: Formula) -> list[Scale]:
        """The scales of nodes that are multiplied with others."""
        found = [scale for scale in map(self._scale, nodes) if scale is not None]
        if len(found) < len(nodes):
            raise Unscaled
        return found

    def _known(self, node: Formula) -> Scale | None:
        match node:
            case Name():
                return self._atom(_of_name(node.name))
            case Number():
                return {} if node.value else None
            case Sum() | Relation():
                return self._common(node.children())
            case Power():
                return self._power(node)
            case Derivative() | Partial():
                return self._derived(node)
            case Application():
                return self._application(node)
            case Summation():
                return self._scale(node.body)
            case Negative() | Modulus() | Transposed() | RealPart() | ImaginaryPart():
                return self._scale(node.argument)
        return self._multiplied(node)

    def _multiplied(self, node: Formula) -> Scale | None:
        """The scale of products and roots; of anything else what stands in it is looked at."""
        match node:
            case Product() | ScalarProduct() | CrossProduct() | Commutator():
                return _product((scale, 1) for scale in self._needed(*node.children()))
            case Quotient():
                return _product(zip(self._needed(*node.children()), (1, -1), strict=True))
            case Root() | Radical():
                order = node.order if isinstance(node, Radical) else 2
                (under,) = self._needed(node.argument)
                return _product([(under, pow(order, -1, MODULUS))])
        for child in node.children():
            self._scale(child)
        return None

    def _derived(self, node: Derivative | Partial) -> Scale:
        (of,) = self._needed(node.argument)
        if isinstance(node, Partial):
            return _product([(of, 1), (_of_name(node.by), -1)])
        by = self._by.get(node.mark, node.mark)
        return self._atom(_product([(of, 1), ({by: 1}, -1)]))

    def _atom(self, scale: Scale) -> Scale:
        self.atoms.append(scale)
        return scale

    def _common(self, nodes: Iterable[Formula]) -> Scale | None:
        """The scale that several nodes have in common."""
        found = [scale for scale in map(self._scale, nodes) if scale is not None]
        self.alike += [_product(((one, 1), (found[0], -1))) for one in found[1:]]
        return found[0] if found else None

    def _power(self, node: Power) -> Scale | None:
        exponent = _number(node.exponent)
        if exponent is not None:
            (base,) = self._needed(node.base)
            return _product([(base, exponent)])
        raised = self._scale(node.exponent)
        if node.base != Name("e"):  # it may be an index that is raised
            return None
        self.pure += [raised] if raised else []
        return {}

    def _application(self, node: Application) -> Scale | None:
        arguments = [self._scale(argument) for argument in node.arguments]
        if node.function in EXTREMES:
            return self._common(node.arguments)
        if node.function in _OF_ANY:
            return None if node.function in OF_A_MATRIX else {}
        if node.function in FAMILY_OF or node.function in FUNCTIONS:
            self.pure += [scale for scale in arguments if scale]
            return {}
        base = node.function.rstrip("'")
        derived = len(node.function) - len(base)
        if derived and (len(arguments) != 1 or arguments[0] is None):
            raise Unscaled
        by = [(arguments[0] or {}, -derived)] if derived else []
        return self._atom(_product([({base: 1}, 1), *by]))


def _of_name(name: str) -> Scale:
    r"""The scale of a name; a vector with a hat, a differential and :math:`\pi` have none."""
    variable, order = name, 0
    while (one := name_of_rate(variable)) != variable:
        variable, order = one, order + 1
    parts = symbol(variable)
    if variable in ("d", r"\pi") or (parts.is_bold and r"\hat" in parts.accents):
        return {}
    return _product([({variable: 1}, 1), ({TIME: 1}, -order)])


def _number(node: Formula) -> int | None:
    """The value of an exponent that is a number."""
    match node:
        case Number(value):
            return value
        case Negative():
            inner = _number(node.argument)
            return None if inner is None else -inner
        case Quotient():
            above, below = _number(node.numerator), _number(node.denominator)
            return above * pow(below, -1, MODULUS) if above is not None and below else None
    return None


def _product(factors: Iterable[tuple[Scale, int]]) -> dict[str, int]:
    """The product of some scales, each with its exponent."""
    found: dict[str, int] = {}
    for scale, exponent in factors:
        for name, own in scale.items():
            found[name] = (found.get(name, 0) + own * exponent) % MODULUS
    return {name: exponent for name, exponent in found.items() if exponent}


class Span:
    """What does not scale: all that follows from some scales that do not."""

    def __init__(self, rows: Mapping[str, Scale] | None = None) -> None:
        self._rows: dict[str, Scale] = {**rows} if rows else {}

    def __contains__(self, scale: Scale) -> bool:
        return not self.rest(scale)

    def copy(self) -> Span:
        """The same, to be added to."""
        return Span(self._rows)

    def add(self, scale: Scale) -> bool:
        """Let a scale be none; whether that says anything new."""
        rest = self.rest(scale)
        if not rest:
            return False
        first = min(rest)
        self._rows[first] = _product([(rest, pow(rest[first], -1, MODULUS))])
        return True

    def explains(self, scales: Iterable[Scale], new: Collection[str]) -> bool:
        """Whether that some scales are none says no more than what some new names are."""
        found = self.copy()
        for scale in scales:
            if rest := found.rest(scale):
                own = [name for name in rest if name in new]
                if not own:
                    return False
                found._rows[own[0]] = _product([(rest, pow(rest[own[0]], -1, MODULUS))])
        return True

    def rest(self, scale: Scale) -> Scale:
        """What is left of a scale."""
        rest: Scale = scale
        while found := [name for name in rest if name in self._rows]:
            name = min(found)
            rest = _product(((rest, 1), (self._rows[name], -rest[name])))
        return rest
