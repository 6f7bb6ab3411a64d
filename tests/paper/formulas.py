"""Formulas at random in the variables of the paper."""

from hypothesis import strategies as st

from kowalevski_cas.notation import Name, Negative, Number, Power, Product, Sum

REAL = tuple(rf"\{letter}_{k}" for letter in ("omega", "alpha", "beta") for k in (1, 2, 3))
COMPLEX = ("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", "w_1", "w_2", r"\omega_3")


def formulas(names):
    leaves = st.sampled_from(names).map(Name) | st.integers(0, 5).map(Number)
    return st.recursive(
        leaves,
        lambda inner: st.one_of(
            st.tuples(inner, inner).map(Sum),
            st.tuples(inner, inner).map(Product),
            inner.map(Negative),
            st.builds(Power, inner, st.integers(0, 2).map(Number)),
        ),
        max_leaves=6,
    )
