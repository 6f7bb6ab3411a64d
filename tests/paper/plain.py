"""Formulas in plain Python: complex numbers with their rates, and the equations of motion by hand.

Nothing of the program computes here but its reader, so that a counterexample
can be checked by somebody else.
"""

from collections import defaultdict
from math import isclose, prod

from kowalevski_cas.notation import (
    Conjugate,
    Constant,
    Derivative,
    ImaginaryPart,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    RealPart,
    Root,
    ScalarProduct,
    Sum,
    Vocabulary,
    read,
)

NUMBERS = Vocabulary(scalars=frozenset({"i"}))


class Dual:
    """A number with its rate."""

    def __init__(self, value, rate=0):
        self.value, self.rate = complex(value), complex(rate)

    def __add__(self, other):
        other = dual(other)
        return Dual(self.value + other.value, self.rate + other.rate)

    def __neg__(self):
        return Dual(-self.value, -self.rate)

    def __sub__(self, other):
        return self + -dual(other)

    def __rsub__(self, other):
        return dual(other) - self

    def __mul__(self, other):
        other = dual(other)
        return Dual(self.value * other.value, self.value * other.rate + self.rate * other.value)

    def __truediv__(self, other):
        other = dual(other)
        value = self.value / other.value
        return Dual(value, (self.rate - value * other.rate) / other.value)

    def __pow__(self, exponent):
        return Dual(
            self.value**exponent,
            exponent * self.value ** (exponent - 1) * self.rate if exponent else 0,
        )

    def root(self):
        value = self.value**0.5
        return Dual(value, self.rate / (2 * value))

    __radd__, __rmul__ = __add__, __mul__


def dual(number):
    return number if isinstance(number, Dual) else Dual(number)


OPERATIONS = {
    Sum: lambda f, of: sum(map(of, f.terms), Dual(0)),
    Negative: lambda f, of: -of(f.argument),
    Product: lambda f, of: prod(map(of, f.factors), start=Dual(1)),
    Quotient: lambda f, of: of(f.numerator) / of(f.denominator),
    Power: lambda f, of: of(f.base) ** f.exponent.value,
    Root: lambda f, of: of(f.argument).root(),
    Derivative: lambda f, of: Dual(of(f.argument).rate),
    Conjugate: lambda f, of: Dual(of(f.argument).value.conjugate()),
    RealPart: lambda f, of: Dual(of(f.argument).value.real),
    ImaginaryPart: lambda f, of: Dual(of(f.argument).value.imag),
    ScalarProduct: lambda f, of: sum(
        (a * b for a, b in zip(of(f.left), of(f.right), strict=True)), Dual(0)
    ),
    Number: lambda f, of: Dual(f.value),
    Constant: lambda f, of: None,
}


def evaluate(formula, names):
    """The value of a formula with its rate, where names have theirs."""
    if isinstance(formula, Name):
        return names[formula.name]
    return OPERATIONS[type(formula)](formula, lambda part: evaluate(part, names))


def value(tex):
    """A printed number: rationals, i, square roots."""
    return evaluate(read(tex, NUMBERS), {"i": Dual(1j)}).value


def close(a, b):
    return isclose(abs(a - b), 0, abs_tol=1e-7 * (1 + abs(a) + abs(b)))


def complex_motion(point):
    """The equations (10), with the third angular velocity, in tau; names defined on top of them.

    What a point leaves out does not stand in the statement: it is zero here.
    """
    n = defaultdict(complex, {name: value(tex) for name, tex in point.items()})
    x1, x2, y1, y2 = n["x_1"], n["x_2"], n["y_1"], n["y_2"]
    z1, z2, w1, w2, w3 = n["z_1"], n["z_2"], n["w_1"], n["w_2"], n[r"\omega_3"]
    rates = {
        "x_1": -x1 * w3 + z1 * w1, "x_2": x2 * w3 - z2 * w2,
        "y_1": -y1 * w3 + z2 * w1, "y_2": y2 * w3 - z1 * w2,
        "z_1": (x1 * w2 - y2 * w1) / 2, "z_2": (y1 * w2 - x2 * w1) / 2,
        "w_1": -(w1 * w3 + z1) / 2, "w_2": (w2 * w3 + z2) / 2, r"\omega_3": (y2 - y1) / 2,
    }  # fmt: skip
    names = {name: Dual(v, rates.get(name, 0)) for name, v in n.items()}
    X1, X2, Z1, Z2, W1, W2, W3 = (
        names[k] for k in ("x_1", "x_2", "z_1", "z_2", "w_1", "w_2", r"\omega_3")
    )
    names["i"] = Dual(1j)
    names[r"\theta"] = X1 * X2
    names["Q_1"] = X2 * Z1 * W1 + X1 * Z2 * W2
    names["Q_2"] = X2 * Z1 * W1 - X1 * Z2 * W2
    if "c_1" in n:
        root = names[r"\theta"].root()
        names["U_1"] = X2 / X1 * names["c_1"] * (W1 * W1 + X1)
        names["U_2"] = X1 / X2 * names["c_2"] * (W2 * W2 + X2)
        names["F_1"] = root * W3 - names["Q_1"] / root
        names["F_2"] = names["U_1"] - names["U_2"]
    return names


def motion(point):
    """The equations (3), (5) by hand, in t, with everything that is defined on top of them."""
    n = {name: value(tex) for name, tex in point.items()}
    w = [n.get(rf"\omega_{k}", 0) for k in (1, 2, 3)]
    a = [n.get(rf"\alpha_{k}", 0) for k in (1, 2, 3)]
    b = [n.get(rf"\beta_{k}", 0) for k in (1, 2, 3)]

    def cross(p, q):
        return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]

    rates = [(w[1] * w[2] + b[2]) / 2, (-w[0] * w[2] - a[2]) / 2, a[1] - b[0]]
    W = [Dual(*pair) for pair in zip(w, rates, strict=True)]
    A = [Dual(*pair) for pair in zip(a, cross(a, w), strict=True)]
    B = [Dual(*pair) for pair in zip(b, cross(b, w), strict=True)]
    names = {}
    for letter, triple in ((r"\omega", W), (r"\alpha", A), (r"\beta", B)):
        names[rf"\boldsymbol{{{letter}}}"] = triple
        names |= {f"{letter}_{k}": triple[k - 1] for k in (1, 2, 3)}
    i = Dual(1j)
    xi1, xi2 = A[0] - B[1], A[1] + B[0]
    J1, J2 = W[0] ** 2 - W[1] ** 2 + xi1, 2 * W[0] * W[1] + xi2
    K = J1**2 + J2**2
    H = W[0] ** 2 + W[1] ** 2 + W[2] ** 2 / 2 - A[0] - B[1]
    L = A[0] * W[0] + A[1] * W[1] + A[2] * W[2] / 2
    aa, bb, ab = (
        sum((p * q for p, q in zip(P, Q, strict=True)), Dual(0))
        for P, Q in ((A, A), (B, B), (A, B))
    )
    names |= {
        r"\xi_1": xi1, r"\xi_2": xi2, "J_1": J1, "J_2": J2, "K": K, "H": H, "L": L, r"\ell": L,
        "J_3": (W[0] ** 2 + W[1] ** 2) * W[2] + 2 * (W[0] * A[2] + W[1] * B[2]),
        r"\Psi": 2 * L * L - H, "h": H, "c": ab, "i": i, "A_1": Dual(2), "A_2": Dual(2), "A_3": Dual(1),
        "x_1": xi1 + i * xi2, "x_2": xi1 - i * xi2, "z_1": A[2] + i * B[2], "z_2": A[2] - i * B[2],
        "y_1": A[0] + B[1] + i * (A[1] - B[0]), "y_2": A[0] + B[1] - i * (A[1] - B[0]),
        "w_1": W[0] + i * W[1], "w_2": W[0] - i * W[1],
        "c_1": aa - bb + 2 * i * ab, "c_2": aa - bb - 2 * i * ab,
    }  # fmt: skip
    names["j"] = names["J_3"]
    names["a"] = Dual(n["a"]) if "a" in n else aa.root()
    names["b"] = Dual(n["b"]) if "b" in n else Dual(0) if not any(b) else bb.root()
    names["k"] = Dual(n["k"]) if "k" in n else K
    return names
