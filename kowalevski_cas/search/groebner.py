"""Gröbner bases, of which each element remembers how it was made (Buchberger).

Where there are unknowns, the generators are of degree 0 or 1 in them, and so is what is combined
from them. So pairs whose S-polynomial would be of degree 2 are left out: this is a basis of a
module. Other programs are a few times faster (the study has a chart) and do not tell how an element
was made, which is the evidence.
"""

from __future__ import annotations

from collections.abc import Sequence
from heapq import heapify, heappop, heappush
from operator import sub

from flint import fmpq_mpoly

from kowalevski_cas.algebra.ideals import remainder

LONGEST = 500_000
"""How many terms are reduced to make a basis, before it is given up."""

Monomial = tuple[int, ...]
Made = dict[int, fmpq_mpoly]
"""How a polynomial is combined from elements of a basis, by their places."""


class Basis:
    """A Gröbner basis of polynomials that are linear in the variables at some places."""

    def __init__(self, generators: Sequence[fmpq_mpoly], linear: Sequence[int]) -> None:
        self.context = generators[0].context()
        self.linear = linear
        self.count = len(generators)
        self.elements: list[fmpq_mpoly] = []
        self.leads: list[Monomial] = []
        self.made: list[Made] = []
        self._kept: list[int] = []
        """The places of elements whose leads no later one divides."""
        self._pairs: list[tuple[int, int, int, Monomial]] = []
        for k, generator in enumerate(generators):
            self._enter(generator, {k: self.context.constant(1)})
        self._steps = 0
        """The terms that were reduced so far."""
        while self._pairs and self._steps <= LONGEST:
            _, i, j, _ = heappop(self._pairs)
            rest, made = self._normal_form(*self._pair(i, j))
            if not rest.is_zero():
                self._enter(rest, made)

    def cofactors(self, target: fmpq_mpoly) -> list[fmpq_mpoly] | None:
        """The combination of the generators that a polynomial is, if it is one."""
        rest, made = self._normal_form(target, {})
        if not rest.is_zero():
            return None
        zero = self.context.constant(0)
        row = [-made.get(k, zero) for k in range(len(self.elements))]
        for k in reversed(range(self.count, len(self.elements))):
            for place, factor in self.made[k].items():
                row[place] += row[k] * factor
        return row[: self.count]

    @property
    def minimal_elements(self) -> list[fmpq_mpoly]:
        """The elements whose leading monomials no later one divides."""
        return [self.elements[k] for k in self._kept]

    def interreduce(self) -> list[fmpq_mpoly]:
        """A basis in which no monomial is divisible by the leading one of another element."""
        found = self.minimal_elements
        for k, own in enumerate(found):
            found[k] = remainder(own, (*found[:k], *found[k + 1 :]))
        return [polynomial for polynomial in found if polynomial]

    def _enter(self, polynomial: fmpq_mpoly, made: Made) -> None:
        """Add an element, with the pairs that are needed (Gebauer and Möller)."""
        place, lead = len(self.elements), _lead(polynomial)
        self.elements.append(polynomial)
        self.leads.append(lead)
        self.made.append(made)
        known = [(k, _lcm(lead, self.leads[k])) for k in self._kept]
        new = [(k, lcm) for k, lcm in known if sum(lcm[n] for n in self.linear) < 2]
        reached = dict(known)
        self._pairs = [
            (degree, i, j, lcm)
            for degree, i, j, lcm in self._pairs
            if not _divides(lead, lcm)
            or lcm in (_lcm(lead, self.leads[i]), _lcm(lead, self.leads[j]))
        ]
        heapify(self._pairs)
        least: dict[Monomial, int] = {}
        for k, lcm in sorted(new, key=lambda pair: sum(pair[1])):
            if lcm in least:
                if self._coprime_leads(lead, k):
                    least[lcm] = k
            elif not any(_divides(other, lcm) for other in least):
                least[lcm] = k
        for lcm, k in least.items():
            if not self._coprime_leads(lead, k):
                heappush(self._pairs, (sum(lcm), k, place, lcm))
        self._kept = [k for k in self._kept if reached[k] != self.leads[k]] + [place]

    def _coprime_leads(self, lead: Monomial, k: int) -> bool:
        """Whether a lead has no variable in common with that of an element."""
        return not any(a and b for a, b in zip(lead, self.leads[k], strict=True))

    def _pair(self, i: int, j: int) -> tuple[fmpq_mpoly, Made]:
        """The S-polynomial of two elements, and how it is made."""
        common = _lcm(self.leads[i], self.leads[j])
        first, second = (
            self.context.from_dict({tuple(map(sub, common, self.leads[k])): 1})
            / self.elements[k].leading_coefficient()
            for k in (i, j)
        )
        return first * self.elements[i] - second * self.elements[j], {i: first, j: -second}

    def _normal_form(self, rest: fmpq_mpoly, made: Made) -> tuple[fmpq_mpoly, Made]:
        """What is left of a polynomial when leading terms are reduced, and how it is made."""
        made = dict(made)
        while not rest.is_zero():
            lead = _lead(rest)
            place = next((k for k in self._kept if _divides(self.leads[k], lead)), None)
            if place is None:
                break
            factor, rest = divmod(rest, self.elements[place])
            self._steps += len(factor) * len(self.elements[place]) + len(rest)
            made[place] = made.get(place, self.context.constant(0)) - factor
        return rest, made


def _lead(polynomial: fmpq_mpoly) -> Monomial:
    return tuple(map(int, polynomial.monomial(0)))


def _lcm(one: Monomial, other: Monomial) -> Monomial:
    return tuple(map(max, one, other))


def _divides(one: Monomial, other: Monomial) -> bool:
    return all(a <= b for a, b in zip(one, other, strict=True))
