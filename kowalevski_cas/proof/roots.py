"""Certificates for systems that are solved by the roots of one equation."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from kowalevski_cas.proof.cases import Squares, Terms


class Eliminant(NamedTuple):
    """A form s of the unknowns, its equation, and each unknown as ``numerator(s) / denominator``.

    Exponents are those of s, then of the parameters; ``form`` holds the
    coefficients of the unknowns.
    """

    form: tuple[int, ...]
    equation: Terms
    denominators: tuple[Terms, ...]
    numerators: tuple[Terms, ...]


class Sign(NamedTuple):
    """A factor as a sum of squares: of polynomials in the parameters, or in all variables.

    Both are empty for a factor of which no such form was found.
    """

    factor: Terms
    in_parameters: Squares
    in_variables: Squares


class Roots(NamedTuple):
    """An eliminant, and why it solves the system with real roots.

    ``quotients`` belong to the equations and the form, with the unknowns
    substituted; ``products`` are the minors of Hermite and the denominators, each
    as a number and the exponents of the factors in ``signs``.
    """

    eliminant: Eliminant
    quotients: tuple[Terms, ...]
    products: tuple[tuple[Fraction, tuple[int, ...]], ...]
    signs: tuple[Sign, ...]

    @classmethod
    def read(cls, value: Any) -> Roots:
        """The certificate that was kept as plain tuples."""
        eliminant, quotients, products, signs = value
        return cls(Eliminant(*eliminant), quotients, products, tuple(Sign(*s) for s in signs))
