"""Polynomials and towers at random, in neutral form."""

from fractions import Fraction

from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.tower import Ring

NAMES = ("x", "y", "z")

fractions = st.builds(Fraction, st.integers(-9, 9), st.integers(1, 5))
exponents = st.tuples(*[st.integers(0, 2)] * len(NAMES))


nonzero = st.builds(Fraction, st.sampled_from([-7, -3, -2, -1, 1, 2, 5]), st.integers(1, 4))


def terms(most=4, least=0):
    """A polynomial: exponents to coefficients, none of them zero."""
    return st.dictionaries(exponents, nonzero, min_size=least, max_size=most)


def tower(arithmetic):
    r"""Polynomials in x, y, z with i, with s = \sqrt{xy}, and with a root of z + s."""
    ring = Ring(load(arithmetic)(NAMES))
    ring.adjoin("i", ring.number(-1))
    s = ring.adjoin("s", ring.generator("x") * ring.generator("y"))
    ring.adjoin("r", ring.generator("z") + s)
    return ring


numerators = st.dictionaries(st.integers(0, 7), terms(2, 1), max_size=2)
divisors = st.just([]) | terms(2, 1).map(lambda divisor: [divisor])


@st.composite
def neutrals(draw):
    """An element of the tower: parts by products of roots, and what it is divided by."""
    return draw(numerators), draw(divisors)


def build(ring, neutral):
    """The element of a tower with these parts and divisors."""
    parts, below = neutral
    element = ring.from_terms(parts)
    for divisor in below:
        element = element / ring.from_terms({0: divisor})
    return element


simple = st.dictionaries(st.integers(0, 3), terms(1, 1), min_size=1, max_size=2).map(
    lambda parts: (parts, [])
)
"""Elements with i and s only, one term each: norms of others are long."""
