"""Formulas at random: every tree that makes sense, whose names are declared."""

from hypothesis import strategies as st

from kowalevski_cas.notation import (
    Application,
    Commutator,
    Conjugate,
    Constant,
    CrossProduct,
    Derivative,
    Diagonal,
    ImaginaryPart,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Root,
    ScalarProduct,
    Sum,
    Summation,
    Unwritten,
    Vector,
    Vocabulary,
)
from kowalevski_cas.notation.symbols import TRANSPOSED

# The scalar d and the time t are there to be confused with the d and t of a derivative.
WORDS = Vocabulary(
    scalars=frozenset(
        r"""x_1 x_2 \omega_1 \omega_{12} \ell \Psi i d a m u_0
        \mathrm{sn} \tilde{q}_2 y_{\alpha} v_{\perp} x^*_1 \hat{\omega}^*""".split()
    ),
    vectors=frozenset(
        [r"\boldsymbol{\alpha}", r"\boldsymbol{\omega}", r"\mathbf{e}_1", r"\hat{\mathbf{e}}_1"]
    ),
    matrices=frozenset([r"\mathbf{I}", "L"]),
    functions=frozenset([r"\varphi", r"\sin", "f_1"]),
    times=frozenset([r"\tau", "t"]),
)

_names = {
    rank: st.sampled_from(sorted(n for n, r in WORDS.ranks.items() if r == rank)).map(Name)
    for rank in (0, 1, 2)
}


def _several(items, most=3):
    return st.lists(items, min_size=2, max_size=most).map(tuple)


def _kept(values):
    """What has the kind of its argument."""
    return st.one_of(
        st.builds(Negative, values),
        st.builds(Derivative, values, st.sampled_from(["dot", "prime", r"\tau", "t"])),
        st.builds(Partial, values, st.sampled_from(sorted(WORDS.scalars | WORDS.times))),
        st.builds(Conjugate, values),
        st.builds(RealPart, values),
        st.builds(ImaginaryPart, values),
        st.builds(Sum, _several(values)),
    )


def _summed(values):
    """A sum with two terms or three; its index stands nowhere, or as a factor."""
    first, count = st.integers(0, 2), st.integers(1, 2)
    body = st.one_of(values, values.map(lambda one: Product((Name("j"), one))))
    return st.builds(
        lambda k, more, inner: Summation("j", Number(k), Number(k + more), inner),
        first,
        count,
        body,
    )


def _with_scalar(scalars, values):
    return st.tuples(scalars, values).map(Product)


def _extended(kinds):
    """One storey more on scalars, vectors and matrices."""
    scalar, vector, matrix = kinds
    terms = st.one_of(scalar, scalar.map(Negative), st.just(Unwritten()))
    scalars = st.one_of(
        scalar,
        _kept(scalar),
        st.builds(Sum, _several(terms)),
        st.builds(Product, _several(scalar)),
        st.builds(Quotient, scalar, scalar),
        st.builds(Power, scalar, scalar),
        st.builds(Root, scalar),
        st.builds(
            Application,
            st.sampled_from(sorted(WORDS.functions)),
            st.lists(scalar, min_size=1, max_size=2).map(tuple),
        ),
        st.builds(ScalarProduct, vector, vector),
        st.builds(PoissonBracket, scalar, scalar),
        st.builds(Modulus, st.one_of(scalar, vector)),
        st.builds(Power, vector, st.just(Number(2))),
        _summed(scalar),
    )
    vectors = st.one_of(
        vector,
        _kept(vector),
        st.builds(CrossProduct, vector, vector),
        st.builds(PoissonBracket, vector, scalar),
        st.builds(Vector, _several(scalar)),
        _with_scalar(scalar, vector),
        st.tuples(matrix, vector).map(Product),
        st.builds(Quotient, vector, scalar),
        _summed(vector),
    )
    rows = st.integers(2, 3).flatmap(
        lambda n: _several(st.builds(Vector, st.lists(scalar, min_size=n, max_size=n).map(tuple)))
    )
    matrices = st.one_of(
        matrix,
        _kept(matrix),
        st.builds(Diagonal, _several(scalar)),
        st.builds(Vector, rows),
        st.builds(Product, _several(matrix)),
        st.builds(Commutator, matrix, matrix),
        _with_scalar(scalar, matrix),
        st.builds(Power, matrix, scalar.filter(_is_no_mark)),
    )
    return scalars, vectors, matrices


def _is_no_mark(exponent):
    """Whether an exponent does not look like the mark of a transposed matrix."""
    return not isinstance(exponent, Name) or exponent.name not in TRANSPOSED


_kinds = (st.one_of(_names[0], st.integers(0, 120).map(Number)), _names[1], _names[2])
for _ in range(3):
    _kinds = _extended(_kinds)

expressions = st.one_of(_kinds)
_signs = st.sampled_from(["=", r"\equiv", r"\ne"])
relations = st.one_of(
    [
        st.builds(
            lambda first, rest, const: Relation(
                (first, *(member for _, member in rest), *([Constant()] if const else [])),
                (*(sign for sign, _ in rest), *(["="] if const else [])),
            ),
            values,
            st.lists(st.tuples(_signs, values), min_size=1, max_size=2),
            st.booleans(),
        )
        for values in _kinds
    ]
)
formulas = st.one_of(expressions, relations)
