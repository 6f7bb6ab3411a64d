r"""The regimes of O⁴: where the radicands of the phase point are positive.

A motion is real where the squares of :math:`\mu_1, A_1, B_1, K_1`, of
:math:`\hat\mu_2, \hat A_2, \hat B_2, \hat K_2`, and of :math:`\hat E` are positive. The first eight
change their signs at the roots alone. As
:math:`(\sigma+u_1u_2)^2-\tau^2\mu_1^2\mu_2^2=\sigma(u_1+u_2)^2`, the last has the sign of
:math:`\hat n u_1+\sigma v` for σ > 0, and for σ < 0 the opposite one of :math:`\mu_1\hat\mu_2`. So
:math:`u_1` runs over an arc between two neighbouring roots, and :math:`u_2` over another one, which
may pass through infinity.

The squares leave 32 points above :math:`(u_1, u_2)`, 16 for σ < 0, told apart by the signs of
:math:`\mu_1\mu_2, EA_1A_2, EB_1B_2, \mu_1K_1A_2B_2, \mu_1K_2A_1B_1`. Passing the end of an arc
changes some of these; the classes that stay apart are the tori.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise, product

from kowalevski_cas.motion.o4.parameters import HIGH, KAPPA, LOW, MU, Degenerate, ParametersO4
from kowalevski_cas.motion.parameters import Inadmissible
from kowalevski_cas.motion.regimes import Arc, check_torus

PRODUCTS = (
    ("mu1", "mu2"),
    ("A1", "A2"),
    ("B1", "B2"),
    ("mu1", "K1", "A2", "B2"),
    ("mu1", "K2", "A1", "B1"),
)
"""The products of radicals, with E > 0, whose signs tell the points above (u1, u2) apart."""

LEAST_GAP = 2.0**-400
"""Between two roots, relative to the largest: what is less comes from rounding."""

CHOSEN = ("K1", "mu2", "A2", "B2", "K2")
"""The radicals whose signs choose a torus, and the point on it."""

RADICAL = {**dict.fromkeys(MU, "mu"), **dict.fromkeys(KAPPA, "K"), LOW: "A", HIGH: "B"}
"""The radical that vanishes at a root."""


@dataclass(frozen=True)
class RegimeO4:
    """The arcs of both variables, for certain signs of s, τ and σ."""

    signs: tuple[bool, bool, bool]
    u1: Arc
    u2: Arc

    @property
    def tori(self) -> int:
        """The number of tori on which the constants have their values."""
        return 1 << len(self._products) - len(self._basis)

    def signs_of(self, torus: int) -> tuple[int, ...]:
        """Signs of K1, μ2, A2, B2, K2 on a torus, one of :attr:`tori`, from 1; μ1, A1, B1 > 0."""
        check_torus(torus, self.tori)
        first: dict[int, tuple[int, ...]] = {}
        for signs in product((1, -1), repeat=len(CHOSEN)):
            if self.signs[2] or signs[1] < 0:  # σ < 0: μ1 and μ2 have opposite signs
                first.setdefault(self.invariant(signs), signs)
        return list(first.values())[torus - 1]

    def invariant(self, signs: Sequence[int]) -> int:
        """What signs of K1, μ2, A2, B2, K2 on one torus have in common, and on no other."""
        negative = {name for name, sign in zip(CHOSEN, signs, strict=True) if sign < 0}
        return _residue(self._vector(negative), self._basis)

    @property
    def _products(self) -> tuple[tuple[str, ...], ...]:
        return PRODUCTS if self.signs[2] else PRODUCTS[1:]

    @property
    def _basis(self) -> list[int]:
        """Independent changes of the signs of the products at the ends of the arcs."""
        return _independent(
            self._vector({f"{RADICAL[end]}{number}"})
            for number, arc in ((1, self.u1), (2, self.u2))
            for end in arc.ends
        )

    def _vector(self, negative: set[str]) -> int:
        """Which products change their signs with these radicals, as binary digits."""
        return sum(
            len(negative.intersection(product)) % 2 << place
            for place, product in enumerate(self._products)
        )

    def __str__(self) -> str:
        """The signs, and the arcs."""
        signs = ", ".join(
            f"{name} {'>' if sign else '<'} 0" for name, sign in zip("sτσ", self.signs, strict=True)
        )
        return f"{signs}, u1 in {self.u1}, u2 in {self.u2}"


def regime_of(constants: ParametersO4) -> RegimeO4:
    """The regime of given constants.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if there is no real motion, and
    :class:`~kowalevski_cas.motion.o4.parameters.Degenerate` where two roots coincide.
    """
    largest = max(abs(constants.root(name)) for name in constants.roots)
    for left, right in pairwise(constants.roots):
        if not constants.gap(right, left) > LEAST_GAP * largest:
            raise Degenerate(f"{left} = {right}, or almost: the tori of O⁴ degenerate")
    signs = (constants.s > 0, constants.tau > 0, constants.sigma > 0)
    for first, at_1 in _arcs(constants, 1):
        for second, at_2 in _arcs(constants, 2):
            if not signs[2] or _positive(constants, at_1, at_2):
                return RegimeO4(signs, first, second)
    a, b, s, tau = map(float, (constants.a, constants.b, constants.s, constants.tau))
    raise Inadmissible(
        f"no real motion on O⁴ has s = {s:.6g}, τ = {tau:.6g} in fields of lengths {a:.6g}, "
        f"{b:.6g}: one of the radicands is negative everywhere"
    )


def _arcs(constants: ParametersO4, number: int) -> Iterator[tuple[Arc, Fraction]]:
    """The arcs on which the radicands of u1 or u2 are positive, and a point of each.

    The point is told by its square with its own sign, like the roots.
    """
    roots, keys = constants.roots, constants.keys
    outside = 2 * max(map(abs, keys.values()))
    for place in range(len(roots)):
        after = (place + 1) % len(roots)
        # x|x| rises with x: between two roots lies what has the mean of their keys
        point = outside if after == 0 else (keys[roots[place]] + keys[roots[after]]) / 2
        if all(_radicands(constants, number, point)):
            above = roots[(place + 2) % len(roots)]
            yield Arc((roots[place], roots[after], above, roots[place - 1]), after == 0), point


def _radicands(constants: ParametersO4, number: int, key: Fraction) -> tuple[bool, ...]:
    """Whether the squares of μ, A, B, K are positive at a point."""
    low, high = constants.keys[LOW], constants.keys[HIGH]
    mu = (abs(key) > constants.sigma) == (constants.tau > 0)
    inside = abs(key) < constants.kappa_square
    if number == 1:
        return mu, key > low, key < high, inside == (constants.s > 0)
    # Of n + (τ ± r²)v either sign will do: the sign of v is free.
    return mu, (key > low) == (key > high), inside != (constants.s > 0)


def _positive(constants: ParametersO4, first: Fraction, second: Fraction) -> bool:
    """Whether nu1 + σv is positive, for n + τv > 0, where σ is; both points by their squares."""
    beyond = 1 if second > constants.keys[LOW] else -1  # the sign of v
    # as x|x| rises, this has the sign of u₁u₂ + σ
    square = first * second + constants.sigma * abs(constants.sigma)
    return square * beyond > 0


def _independent(vectors: Iterable[int]) -> list[int]:
    """A basis over the field of two elements of vectors, each a number by its binary digits."""
    basis: list[int] = []
    for vector in vectors:
        if rest := _residue(vector, basis):
            basis.append(rest)
    return basis


def _residue(vector: int, basis: Sequence[int]) -> int:
    """What is left of a vector by a basis: the same for all that differ by a combination of it."""
    for known in basis:
        # the smaller one is without the leading digit of the known one, which no other known one
        # has
        vector = min(vector, vector ^ known)
    return vector
