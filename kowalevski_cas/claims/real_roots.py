r"""Solutions through one root: a system solved by the roots of an eliminant, all of them real."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

from kowalevski_cas.arithmetic.hermite import hermite_minors
from kowalevski_cas.arithmetic.numbers import Substitution
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.claims.cases import is_sum
from kowalevski_cas.proof.cases import Squares
from kowalevski_cas.stage import Stage


class Sign(NamedTuple):
    """A factor as a sum of squares: of polynomials in the parameters, or in all variables."""

    factor: Terms
    in_parameters: Squares
    in_variables: Squares


class Solved(NamedTuple):
    """What the search found: see :class:`kowalevski_cas.search.eliminants.Eliminant`.

    ``products`` are the minors of Hermite and the denominators, each as a number
    and the exponents of the factors in ``signs``.
    """

    form: tuple[int, ...]
    equation: Terms
    denominators: tuple[Terms, ...]
    numerators: tuple[Terms, ...]
    quotients: tuple[Terms, ...]
    products: tuple[tuple[Fraction, tuple[int, ...]], ...]
    signs: tuple[Sign, ...]


@dataclass
class RealRoots:
    r"""The system :math:`P_j(x) = p_j` in one arithmetic, solved by the roots of one equation.

    ``levels`` are the :math:`P_j` in the ``unknowns`` x, ``everywhere`` the same
    integrals before anything was solved for. What is checked:

    * e(s) = 0 and d x = n(s) hold identically when s is the form of the unknowns and
      the parameters are the levels, so every solution is given by a root of e;
    * :math:`P_j(n/d)-p_j` and s(n/d) - s are multiples of e, so every root gives a
      solution, and different roots different ones;
    * the minors of Hermite and the denominators are products of factors, and the
      factors of the minors are sums of squares, so all roots are real and distinct
      where no factor vanishes.
    """

    levels: Sequence[Element]
    unknowns: Sequence[Element]
    everywhere: Sequence[Element]
    solved: Solved

    @cached_property
    def ring(self) -> Ring:
        """Polynomials in the form and the parameters."""
        kind = type(self.levels[0].ring.polynomials)
        return Ring(kind(("s", *(f"p_{k + 1}" for k in range(len(self.levels))))))

    @property
    def degree(self) -> int:
        """The number of roots."""
        return max(exponents[0] for exponents in self.solved.equation)

    def element(self, terms: Terms) -> Element:
        """A polynomial in the form and the parameters."""
        return self.ring.from_terms({0: terms})

    def into(self, values: Sequence[Element], form: Element | None = None) -> Substitution:
        """The homomorphism that gives values to the parameters, and to the form."""
        ring = values[0].ring
        names = self.ring.polynomials.generators
        numbers = dict(zip(names, (form or ring.zero, *values), strict=True))
        return Substitution(self.ring, numbers, ring)
