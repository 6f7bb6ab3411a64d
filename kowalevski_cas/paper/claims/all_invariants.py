r"""That all polynomial invariants of a map up to a degree are known.

What a polynomial with unknown coefficients changes by under the map is a fraction, whose numerator
vanishes identically where all its coefficients do: these are linear in the unknown ones.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import chain, count, product

from kowalevski_cas.algebra.present import fraction_formula, polynomial_formula, power_formula
from kowalevski_cas.notation import Formula, Name, substitute, times, total
from kowalevski_cas.paper.claims.forms import ONE, function, minus, vanishes
from kowalevski_cas.paper.claims.maps import OfMap, expand_definitions, invariance
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal, identity
from kowalevski_cas.problem.polynomial_fields import Exponents, Terms, monomials
from kowalevski_cas.problem.space import Meaningless


class AllInvariantsOfMap(OfMap):
    """The polynomial invariants up to a degree are polynomials in those that are printed.

    It is so at some ``values`` of the constants, and hence for almost all: there are no more
    invariants with coefficients that depend on the constants than at special ones.
    """

    invariants: tuple[Printed, ...]
    degree: int
    values: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        r"""What the map is at the values, how a polynomial changes under it, and which do not.

        With F = Σ c_k x^k and a divisor D of the map, D (F(φ(x)) − F(x)) = Σ r_m x^m. Where all
        r_m are zero, F = Σ e_j K_j with the products K_j of the printed invariants, coefficient by
        coefficient. Of a sum of these the e_j, which are linear in the c_k as well, are its own.
        """
        from kowalevski_cas.algebra.kernels import coordinates, rank  # no library is read with it

        values = {name: Fraction(value) for name, value in self.values}
        if self.degree < 1 or {*values} != {*self.scene.constants}:
            raise Meaningless("a degree is at least 1, and all constants have values")
        exponents = exponents_up_to(len(self.images), self.degree)
        names = unused_names(self.scene, len(exponents))
        space = on(self.scene.having(constants=names))
        numbers = {name: fraction_formula(value) for name, value in values.items()}
        variables = [Name(x) for x, _ in self.images]
        new = [Name(image) for _, image in self.images]
        printed = [space.plain(function(on, space, place)) for place in self.invariants]
        images, known = (at_values(space, part, numbers) for part in (new, printed))
        special = tuple((Name(name), number) for name, number in numbers.items())
        named = tuple(zip((*new, *printed), (*images, *known), strict=True))
        yield Follows(space, (named,), special)
        if printed:
            yield identity(space, *(invariance(space, one, self.images) for one in printed))

        coefficients = dict(zip(exponents, map(Name, names), strict=True))
        here, there = (_combination(coefficients, point) for point in (variables, images))
        divisor, rows = _conditions(space, minus((there, here)), variables, coefficients)
        conditions = {m: _linear(row, coefficients) for m, row in rows.items()}
        changes = (times(r, _monomial(variables, m)) for m, r in conditions.items())
        yield identity(space, (times(divisor, minus((there, here))), total(changes)))

        terms = [terms_of(space, one, variables) for one in known]
        products = products_of(terms, len(variables), self.degree)
        if values and rank(rows.values()) + rank(products.values()) < len(exponents):
            raise Meaningless("there are others at these values, and may be none elsewhere")
        found = coordinates([*products.values()], exponents)
        forms = dict(zip(products, (_linear(form, coefficients) for form in found), strict=True))
        sums = {
            k: total(
                times(fraction_formula(part[k]), forms[j])
                for j, part in products.items()
                if k in part
            )
            for k in exponents
        }
        same = tuple((coefficients[k], sums[k]) for k in exponents)
        yield Follows(space, (same,), tuple(map(vanishes, conditions.values())))
        whole = total(times(e, _monomial(known, j)) for j, e in forms.items())
        yield identity(space, (_combination(sums, variables), whole))

    def establishes(self) -> Iterator[Printed]:
        yield from self.invariants


def exponents_up_to(width: int, degree: int) -> list[Exponents]:
    """Those of the monomials up to a degree, of the constant one first."""
    return [one for size in range(degree + 1) for one in monomials((1,) * width, size)]


def unused_names(scene: Scene, number: int) -> tuple[str, ...]:
    """Names of coefficients of which a scene has none."""
    known = {*scene.names(), *scene.definitions}
    letters = chain("ckCK", (f"c^{{({n})}}" for n in count()))
    indices = [str(k) if k < 10 else f"{{{k}}}" for k in range(1, number + 1)]
    choices = (tuple(f"{letter}_{index}" for index in indices) for letter in letters)
    return next(names for names in choices if known.isdisjoint(names))


def at_values(
    space: Elaboration, formulas: Sequence[Formula], values: Mapping[str, Formula]
) -> list[Formula]:
    """Formulas in variables only, with values in the place of constants."""
    return [space.plain(substitute(expand_definitions(space, one), values)) for one in formulas]


def _linear(form: Terms, names: Mapping[Exponents, Formula]) -> Formula:
    return total(times(fraction_formula(value), names[k]) for k, value in form.items())


def _monomial(point: Sequence[Formula], exponents: Exponents) -> Formula:
    return times(*(power_formula(x, k) for x, k in zip(point, exponents, strict=True) if k))


def _combination(coefficients: Mapping[Exponents, Formula], point: Sequence[Formula]) -> Formula:
    """The value of a polynomial at a point."""
    return total(times(c, _monomial(point, k)) for k, c in coefficients.items())


def _conditions(
    space: Elaboration,
    change: Formula,
    variables: Sequence[Name],
    coefficients: Mapping[Exponents, Name],
) -> tuple[Formula, dict[Exponents, Terms]]:
    """The divisor of a fraction, and the linear forms in a polynomial's coefficients above it.

    They come by the monomials before which they stand.
    """
    element = space.finder.scalar(change)
    ring, generators = element.ring, element.ring.polynomials.generators
    if {*element.terms()} - {0}:
        raise Meaningless("invariants of a map with functions or roots are not looked for")
    below = ring.divisor_product(element.denominator)
    parts = {} if below is None else ring.polynomials.terms(below)
    divisor = polynomial_formula(parts, [*map(Name, generators)]) if parts else ONE
    places = [generators.index(x.name) for x in variables]
    units = {generators.index(c.name): key for key, c in coefficients.items()}
    found = defaultdict[Exponents, Terms](dict)
    for exponents, value in element.terms().get(0, {}).items():
        (place, size), *others = ((k, e) for k, e in enumerate(exponents) if e and k not in places)
        if others or size != 1 or place not in units:
            raise Meaningless("in the images there is what neither moves nor is a constant")
        found[tuple(exponents[k] for k in places)][units[place]] = Fraction(value)
    return divisor, found


def terms_of(space: Elaboration, formula: Formula, variables: Sequence[Name]) -> Terms:
    """The coefficients of a polynomial; raises :class:`Meaningless` if it is none."""
    element = space.finder.scalar(formula)
    places = [element.ring.polynomials.generators.index(x.name) for x in variables]
    terms = element.terms().get(0, {})
    plain = all(sum(e) == sum(e[k] for k in places) for e in terms)
    if element.denominator or {*element.terms()} - {0} or not plain:
        raise Meaningless("an invariant that is no polynomial")
    return {tuple(e[k] for k in places): Fraction(value) for e, value in terms.items()}


def products_of(known: Sequence[Terms], width: int, degree: int) -> dict[Exponents, Terms]:
    """The products of polynomials up to a degree, 1 among them, by their exponents."""
    sizes = [max(map(sum, one), default=0) for one in known]
    if not all(sizes):
        raise Meaningless("a constant is no invariant")
    ranges = (range(degree // size + 1) for size in sizes)
    found = {}
    for powers in product(*ranges):
        if sum(k * size for k, size in zip(powers, sizes, strict=True)) <= degree:
            whole: Terms = {(0,) * width: Fraction(1)}
            for one, k in zip(known, powers, strict=True):
                for _ in range(k):
                    whole = _times(whole, one)
            found[powers] = whole
    return found


def _times(left: Terms, right: Terms) -> Terms:
    found = defaultdict[Exponents, Fraction](Fraction)
    for (a, x), (b, y) in product(left.items(), right.items()):
        found[tuple(map(sum, zip(a, b, strict=True)))] += x * y
    return {key: value for key, value in found.items() if value}
