"""A vector is in a cone, or a plane lies between them."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra.cones import combination_in_cone

SMALL = st.integers(-3, 3).map(Fraction)
VECTORS = st.lists(st.tuples(SMALL, SMALL, SMALL), min_size=1, max_size=6)


@given(VECTORS, st.lists(st.integers(0, 3), min_size=6, max_size=6))
def test_a_combination_is_found_where_there_is_one(vectors, weights):
    pairs = [*zip(weights, vectors, strict=False)]
    target = [sum((w * v[k] for w, v in pairs), Fraction(0)) for k in range(3)]
    found = combination_in_cone(vectors, target)
    assert found is not None and min(found) >= 0
    assert target == [
        sum((w * v[k] for w, v in zip(found, vectors, strict=True)), Fraction(0)) for k in range(3)
    ]


@given(VECTORS, st.tuples(SMALL, SMALL, SMALL))
def test_there_is_none_beyond_a_plane(vectors, normal):
    inside = [v for v in vectors if sum(a * b for a, b in zip(v, normal, strict=True)) >= 0]
    if any(normal):
        assert combination_in_cone(inside, [-a for a in normal]) is None
