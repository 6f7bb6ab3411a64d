"""What follows at real points only: products split, and sums of squares fall apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import chain, product
from itertools import combinations as subsets
from operator import add, mul

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.factors import irreducible_factors, vanishes_with
from kowalevski_cas.algebra.flat import Flat
from kowalevski_cas.algebra.flint import polynomial_of, terms_of
from kowalevski_cas.algebra.ideals import reduce_groebner_basis
from kowalevski_cas.algebra.polynomials import TooLarge
from kowalevski_cas.algebra.present import formula_rows
from kowalevski_cas.algebra.squares import few_squares, sum_of_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evidence import Proof
from kowalevski_cas.problem.examine import value_of
from kowalevski_cas.search.combinations import Combinations, complete
from kowalevski_cas.search.gram import Representation
from kowalevski_cas.search.weighted_squares import represent

DEPTH = 12
"""How many splits may follow one another."""

Group = tuple[Element, ...]
"""What vanishes with a factor: itself, or all that is squared in it."""

Rows = Sequence[Sequence[Element]]


class RealCases:
    """Proofs that at each real point where what is known vanishes all of a conclusion does.

    There an element of a Gröbner basis of the known ones vanishes, and so does one of its factors;
    if this is a sum of squares, each square does. A root is real, so that what is known falls apart
    as well if it is a sum of squares times products of squares of roots.

    Args:
        conclusions: of one of these all elements have to vanish; without any, 1 has to.
        granted: what vanishes nowhere.
    """

    def __init__(
        self, conclusions: Rows, known: Sequence[Element], granted: Sequence[Element] = ()
    ) -> None:
        self.conclusions, self.granted = conclusions, granted
        self.everything = [*known, *chain.from_iterable(conclusions)]
        self.ring = self.everything[0].ring
        self.flat = Flat(self.ring)
        self.context = fmpq_mpoly_ctx.get(self.flat.context.names(), Ordering.deglex)

    def proof(self, known: Sequence[Element], fresh: int = 0, depth: int = DEPTH) -> Proof | None:
        """A proof from what is known; what stands at ``fresh`` or behind is new."""
        one = [self.ring.one]
        targets = [*chain.from_iterable(self.conclusions), *one]
        combinations = Combinations(targets, known, units=self._units(known))
        for k, conclusion in enumerate(self.conclusions or [one]):
            rows = complete(_zero_or(combinations, element, known) for element in conclusion)
            if rows is not None:
                return Proof(formula_rows([*_alternatives(self.conclusions, k, rows)]))
        if not depth:
            return None
        products = [*self._products(known, combinations)]
        apart = [one for one in products if any(len(group) > 1 for group in one[1])]
        if not apart and (step := self._by_signs(known, fresh)) is not None:
            group, row = step
            inside = self.proof([*known, *group], len(known) + len(group), depth - 1)
            if inside is not None:
                power = 2 if len(group) == 1 else 1  # the value of one is no square
                return Proof(formula_rows([row]), formula_rows([group]), (inside,), power)
        for _, groups, power in sorted(apart or products, key=lambda found: found[0])[:1]:
            whole = reduce(mul, map(value_of, groups))
            found = _zero_or(combinations, whole**power, known)
            cases = (self.proof([*known, *group], len(known), depth - 1) for group in groups)
            if found is not None and (proofs := complete(cases)) is not None:
                return Proof(formula_rows([found]), formula_rows(groups), tuple(proofs), power)
        return self._at_edges(known) if depth == DEPTH else None

    def _at_edges(self, known: Sequence[Element]) -> Proof | None:
        r"""A proof from equations that inequalities leave, as :math:`a=0` for ``0\le a\le0``."""
        weights = self._weights([*map(self.flat.polynomial, [*known, *self.everything])])
        squares = [square for _, square in weights]
        for root, square in weights[: len(self.ring.roots)]:
            found = represent(-square, squares)
            if found is None:
                continue
            # the square of this root and these ones have the sum zero, whatever is known
            group = (root, *self._squared(found, weights))
            inside = self.proof([*known, *group], len(known) + len(group), DEPTH - 1)
            row = [self.ring.zero for _ in known]
            return inside and Proof(formula_rows([row]), formula_rows([group]), (inside,))
        return None

    def _units(self, known: Sequence[Element]) -> list[Element]:
        """What vanishes nowhere and speaks of what is known; without roots nothing does.

        That nothing is left may not rest on a norm, which vanishes where its element does not.
        """
        polynomials = [*map(self.flat.polynomial, known), *self._relations(known)]
        used = {k for one in polynomials for k, d in enumerate(one.degrees()) if d}
        return [
            one
            for one in self.granted
            if used & {k for k, d in enumerate(self.flat.polynomial(one).degrees()) if d}
            and (self.conclusions or _divides_exactly(one))
        ]

    def _products(
        self, known: Sequence[Element], combinations: Combinations
    ) -> Iterator[tuple[tuple[bool, int], list[Group], int]]:
        """Groups of factors of elements of the basis, and a power of their product in the ideal.

        The best ones have a sum of squares in them, and few terms. The relation of a root is
        factored as well, unless it is known which factor vanishes.
        """
        relations = self._relations([*known, *self.everything]) if known else []
        for polynomial in (*self._basis(known), *relations):
            terms = terms_of(polynomial)
            factors = irreducible_factors(terms)
            groups = [
                tuple(
                    self._element(base) * self.ring.number(part)
                    for number, base in sum_of_squares(factor) or ((Fraction(1), factor),)
                    for part in few_squares(number)
                    if part
                )
                for factor, _ in factors
            ]
            one = all(len(group) == 1 for group in groups)
            settled = polynomial in relations and any(
                _zero_or(combinations, value_of(group), known) is not None for group in groups
            )
            power = max(exponent for _, exponent in factors)
            several = len(groups) > 1 or (power > 1 and self.ring.roots)
            if not settled and (not one or several):
                yield (one, len(terms)), groups, power
        for element, _, other in self._norms():
            if combinations.row(other) is None:
                yield (True, 0), [(element,), (other,)], 1

    def _norms(self) -> Iterator[tuple[Element, int, Element]]:
        """What has to vanish, a root in it, and its conjugate by that, if their product is zero."""
        for element in chain.from_iterable(self.conclusions):
            for bit in range(len(self.ring.roots)):
                other = element.conjugate_root(bit)
                if not (element - other).is_zero and (element * other).is_zero:
                    yield element, bit, other

    def _basis(self, known: Sequence[Element]) -> list[fmpq_mpoly]:
        """The reduced basis of what is known, with the relations of the roots that stand there."""
        given = [self.flat.polynomial(one) for one in known if not one.is_zero]
        both = [*given, *self._relations([*known, *self.everything])]
        if not both:
            return []
        try:
            return reduce_groebner_basis([self.context.from_dict(one.to_dict()) for one in both])
        except TooLarge:
            return []

    def _relations(self, elements: Sequence[Element]) -> list[fmpq_mpoly]:
        """The relations of the roots in elements, and of those in their squares."""
        used = 0
        for element in elements:
            used = reduce(lambda a, b: a | b, element.parts, used)
        for bit in reversed(range(len(self.ring.roots))):
            if used >> bit & 1:
                used = reduce(lambda a, b: a | b, self.ring.radicands[bit].parts, used)
        return [
            relation
            for bit, relation in zip(
                reversed(range(len(self.ring.roots))), self.flat.relations(), strict=True
            )
            if used >> bit & 1
        ]

    def _by_signs(self, known: Sequence[Element], fresh: int) -> tuple[Group, list[Element]] | None:
        """What is squared in something new that vanishes, and the row of the sum of squares."""
        if not self.ring.roots:
            return None
        polynomials = [self.flat.polynomial(one) for one in known]
        for k in range(fresh, len(known)):
            weights = self._weights([*polynomials, *map(self.flat.polynomial, self.everything)])
            others = [p for j, p in enumerate(polynomials) if j != k]
            squares = [self.flat.element(square) for _, square in weights]
            relations = self._relations([*known, *self.everything, *squares])
            factors = [*self._multipliers(polynomials[k], [w for _, w in weights])]
            ways = product((1, -1), factors, ([], relations))
            below = self.flat.inverse_denominator(known[k]).inverse()
            odd = self._odd_divisors(known[k])
            for sign, factor, more in ways:
                target = sign * factor * polynomials[k] * odd
                found = represent(target, [w for _, w in weights], [*others, *more])
                if found is None:
                    continue
                group = (*self._squared(found, weights),)
                row = [*map(self.flat.element, found.factors[: len(others)])]
                row.insert(k, self.flat.element(sign * factor * odd) * below)
                if group and group != (known[k],):
                    return group, row
        return None

    def _squared(
        self, found: Representation, weights: Sequence[tuple[Element, object]]
    ) -> Iterator[Element]:
        """What is squared in a sum of squares times weights, which are squares of roots."""
        for places, squares in found.summands:
            for number, base in squares:
                for part in few_squares(number):
                    if part:
                        root = self._root(places, weights)
                        yield self._element(base) * self.ring.number(part) * root

    def _odd_divisors(self, element: Element) -> fmpq_mpoly:
        """What an element is divided by an odd number of times: of this its sign depends."""
        divisors = (self.ring.divisors[k] for k, power in element.denominator.items() if power % 2)
        elements = (Element(self.ring, {0: one}, {}) for one in divisors)
        return reduce(mul, map(self.flat.polynomial, elements), self.flat.context.constant(1))

    def _multipliers(
        self, target: fmpq_mpoly, weights: Sequence[fmpq_mpoly]
    ) -> Iterator[fmpq_mpoly]:
        r"""Polynomials by which a target may be multiplied: of roots and squares, and conjugates.

        So from :math:`a<b` follows :math:`b-\sqrt{ab}>0`, of which :math:`b+\sqrt{ab}` makes
        :math:`b(b-a)`.
        """
        gens, one = self.flat.context.gens(), self.flat.context.constant(1)
        yield one
        own = {self.flat.roots - 1 - bit for _, bit, _ in self._norms()}
        roots = [gens[k] for k in range(self.flat.roots) if k not in own and gens[k] in weights]
        if roots:
            yield from (reduce(add, roots), reduce(add, roots, one))
        places = [k for k, d in enumerate(target.degrees()) if d > 1 and k >= self.flat.roots]
        if places:
            yield reduce(lambda a, k: a + gens[k] ** 2, places, one)
        for k in range(self.flat.roots):
            if k not in own and gens[k] in weights and target.degrees()[k] == 1:
                yield target.compose(*gens[:k], -gens[k], *gens[k + 1 :])

    def _weights(self, polynomials: Sequence[fmpq_mpoly]) -> list[tuple[Element, fmpq_mpoly]]:
        """The roots whose squares have to do with polynomials, with these squares."""
        used = {k for one in polynomials for k, d in enumerate(one.degrees()) if d}
        squares = [*map(self.flat.polynomial, self.ring.radicands)]
        trivial = {k for k, one in enumerate(squares) if _is_square(one)}
        found: dict[int, fmpq_mpoly] = {}
        before = -1
        while before != len(found):
            before = len(found)
            for bit, square in enumerate(squares):
                own = {k for k, d in enumerate(square.degrees()) if d}
                own.add(self.flat.roots - 1 - bit)
                if own & used:
                    used |= own
                    found[bit] = square
        gens = self.flat.context.gens()
        weights = [
            self._without_squares(self.flat.element(gens[self.flat.roots - 1 - bit]), square)
            for bit, square in found.items()
            if bit not in trivial
        ]
        products = [
            (one[1] * other[1], self._without_squares(one[0] * other[0], one[1] * other[1]))
            for one, other in subsets(weights, 2)
        ]
        return [*weights, *(product for whole, product in products if product[1] != whole)]

    def _without_squares(self, root: Element, square: fmpq_mpoly) -> tuple[Element, fmpq_mpoly]:
        """A root and its square, both divided by what vanishes nowhere in the statement."""
        exact = [one.inverse() for one in self.granted if _divides_exactly(one)]
        for divisor in map(self.flat.polynomial, self.ring.divisors_of([*self.everything, *exact])):
            while (divided := divmod(square, divisor**2))[1].is_zero():
                square, root = divided[0], root * self.flat.inverse(divisor)
        return root, square

    def _root(self, places: Sequence[int], weights: Sequence[tuple[Element, object]]) -> Element:
        return reduce(mul, (weights[k][0] for k in places), self.ring.one)

    def _element(self, terms: dict[tuple[int, ...], Fraction]) -> Element:
        return self.flat.element(polynomial_of(self.flat.context, terms))


def _is_square(polynomial: fmpq_mpoly) -> bool:
    """Whether a polynomial is a square, up to a number."""
    return not any(exponent % 2 for _, exponent in polynomial.factor()[1])


def _divides_exactly(element: Element) -> bool:
    """Whether an element vanishes wherever the norm by which its inverse divides does."""
    ring = element.ring
    norms = (Element(ring, {0: ring.divisors[k]}, {}) for k in element.inverse().denominator)
    return all(vanishes_with(element, norm) for norm in norms)


def _zero_or(
    combinations: Combinations, element: Element, known: Sequence[Element]
) -> list[Element] | None:
    """The row of an element; of zero, where nothing is known, it is empty."""
    if element.is_zero:
        return [element.ring.zero for _ in known]
    return combinations.row(element)


def _alternatives(
    conclusions: Sequence[Sequence[Element]], place: int, rows: Sequence[Sequence[Element]]
) -> Iterator[list[Element]]:
    """Rows for the products of an element of each conclusion, from those for one conclusion."""
    places = (range(len(one)) for one in conclusions)
    for choice in product(*places):
        factor = rows[0][0].ring.one if rows[0] else None
        for k, (conclusion, number) in enumerate(zip(conclusions, choice, strict=True)):
            factor = factor if k == place or factor is None else factor * conclusion[number]
        row = rows[choice[place]] if conclusions else rows[0]
        yield [factor * entry for entry in row if factor is not None]
