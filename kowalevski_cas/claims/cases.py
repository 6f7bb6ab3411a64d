"""Trees of cases, checked: every split is an identity in the arithmetic of the bench."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.proof.cases import Case, Reduction, Squares


@dataclass(frozen=True)
class System:
    """Equations in one arithmetic.

    ``targets`` vanish by assumption, ``granted`` do not; what is to be shown is
    that all ``goals`` vanish.
    """

    ring: Ring
    targets: Sequence[Element]
    goals: Sequence[Element]
    granted: Sequence[Element]

    def holds(self, case: Case) -> bool:
        """Whether each step of a tree is true; an open case is, for it says nothing."""
        if case.kind == "open":
            return True
        if case.kind == "empty":
            return all(
                not r.content and self.reduces(r, self.granted, case) for r in case.reductions
            ) and bool(case.reductions)
        if case.kind == "set":
            settled = {r.target for r in case.reductions}
            return settled == set(range(len(self.goals))) and all(
                not r.content and self.reduces(r, self.goals, case) for r in case.reductions
            )
        (split,) = case.reductions
        return (
            _is_number(split.content)
            and self.reduces(split, self.targets, case)
            and all(
                self._opens(factor, squares, case, child) and self.holds(child)
                for (factor, _), (squares, child) in zip(split.factors, case.children, strict=True)
            )
        )

    def reduces(self, reduction: Reduction, targets: Sequence[Element], case: Case) -> bool:
        """Whether the identity of a reduction holds."""
        left = self.powers(reduction.unit) * targets[reduction.target]
        right = self.element(reduction.content) * self.powers(reduction.dropped)
        for factor, exponent in reduction.factors:
            right = right * self.element(factor) ** exponent
        for quotient, known in zip(reduction.quotients, case.known, strict=True):
            right = right + self.element(quotient) * self.element(known)
        return (left - right).is_zero

    def _opens(self, factor: Terms, squares: Squares, case: Case, child: Case) -> bool:
        """Whether a real zero of the factor obeys what the case takes as known."""
        bases = tuple(base for _, base in squares) or (factor,)
        if child.known != (*case.known, *bases):
            return False
        return not squares or is_sum(self.ring, self.element(factor), squares)

    def powers(self, exponents: Sequence[int]) -> Element:
        """A product of powers of what is granted."""
        result = self.ring.one
        for expression, exponent in zip(self.granted, exponents, strict=True):
            result = result * expression**exponent if exponent else result
        return result

    def element(self, terms: Terms) -> Element:
        """A polynomial as an element."""
        return self.ring.from_terms({0: terms})


def _is_number(content: Terms) -> bool:
    """Whether a polynomial is a number other than zero."""
    return len(content) == 1 and not any(next(iter(content))) and any(content.values())


def is_sum(ring: Ring, element: Element, squares: Squares) -> bool:
    """Whether an element is this sum of squares, the factors being positive."""
    total = ring.zero
    for factor, base in squares:
        total = total + ring.number(factor) * ring.from_terms({0: base}) ** 2
    return all(factor > 0 for factor, _ in squares) and (element - total).is_zero
