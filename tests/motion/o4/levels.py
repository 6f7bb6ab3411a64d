"""Constants in every regime of O⁴, real points of O⁴, and the constants at which motions exist."""

from fractions import Fraction

import numpy as np
from hypothesis import strategies as st

from kowalevski_cas.motion import MotionO4, ParametersO4

ANGLES = (Fraction(1, 3), Fraction(2, 3))

EVERY_REGIME = {
    ("1.7", "0.2", "-0.975", "3.325"): ("s < 0, τ > 0, σ < 0", "[-τ-r², -κ]", "[-τ+r², κ]", 1),
    ("2.5", "2.08", "-2", "7.8"): ("s < 0, τ > 0, σ < 0", "[-τ-r², -τ+r²]", "[-κ, κ]", 2),
    ("1.2", "0.32", "-0.6", "9.475"): ("s < 0, τ > 0, σ > 0", "[-τ-r², -κ]", "[-τ+r², -√σ]", 2),
    ("0.95", "0.76", "-0.55", "20.5"): ("s < 0, τ > 0, σ > 0", "[-τ-r², -τ+r²]", "[-κ, -√σ]", 2),
    ("1.8", "0.3", "1.85", "-0.31"): ("s > 0, τ < 0, σ > 0", "[-κ, κ]", "[-τ+r², √σ]", 4),
    ("2.95", "1.87", "0.925", "-2.25"): ("s > 0, τ < 0, σ > 0", "[-τ-r², -τ+r²]", "[κ, √σ]", 2),
    ("2.85", "0.29", "1.525", "-13.9"): ("s > 0, τ < 0, σ > 0", "[-τ-r², κ]", "[-τ+r², √σ]", 2),
    ("3", "1.1", "1.825", "6.6"): (
        "s > 0, τ > 0, σ < 0", "[-κ, -τ+r²]", "[κ, ∞] ∪ [-∞, -τ-r²]", 1,
    ),
    ("2.6", "1.21", "0.8", "1.94"): (
        "s > 0, τ > 0, σ < 0", "[-κ, κ]", "[-τ+r², ∞] ∪ [-∞, -τ-r²]", 2,
    ),
    ("1.15", "1.11", "1.2", "0.32"): (
        "s > 0, τ > 0, σ < 0", "[-τ-r², -τ+r²]", "[κ, ∞] ∪ [-∞, -κ]", 2,
    ),
    ("1.05", "0.175", "1.225", "0.54"): (
        "s > 0, τ > 0, σ > 0", "[√σ, -τ+r²]", "[κ, ∞] ∪ [-∞, -κ]", 4,
    ),
    ("2.8", "0.37", "1.875", "1.26"): (
        "s > 0, τ > 0, σ > 0", "[√σ, -τ+r²]", "[κ, ∞] ∪ [-∞, -τ-r²]", 2,
    ),
    ("2.8", "1.2", "0.75", "0.6"): (
        "s > 0, τ > 0, σ > 0", "[√σ, κ]", "[-τ+r², ∞] ∪ [-∞, -τ-r²]", 2,
    ),
}  # fmt: skip
"""a, b, s, τ in each of the regimes: its signs, the arcs of u1 and u2, the number of tori."""

KNOWN = [tuple(map(Fraction, constants)) for constants in EVERY_REGIME]


def motion(constants, angles=ANGLES, signs=(1, -1, 1, 1, 1)):
    """The motion with the constants a, b, s, τ."""
    return MotionO4(ParametersO4.of(*constants), angles, signs)


def admissible(a, b, s, tau):
    """Whether real motions exist, for constants at which no two roots coincide."""
    r_square, sigma = a**2 - b**2, (tau - (a - b) ** 2) * (tau - (a + b) ** 2)
    if s < 0 > tau:
        return False
    if sigma > 0 < tau:
        return tau < (a - b) ** 2 if s > 0 else tau > (a + b) ** 2 and -s < a
    bound = -sigma / (4 * tau)
    if tau < 0:
        return s**2 < bound if -tau < r_square else s < a
    if s > 0:
        return s**2 > bound if tau < r_square else s > b
    return b < -s < a if tau < r_square else bound < s**2 < a**2


def point(numbers):
    """The real point of O⁴ with these ω1, ω2, ω3, α3, β3, η, s: by the formulas for the fields."""
    omega_1, omega_2, omega_3, alpha_3, beta_3, eta, s = numbers
    w, z = complex(omega_1, omega_2), complex(alpha_3, beta_3)
    w_square, z_square = abs(w) ** 2, abs(z) ** 2
    x = (1j * eta - omega_3 * (z_square - 2 * s * w_square) / 2) / (w * z).conjugate()
    y = (1j * eta - omega_3 * (z_square + 2 * s * w_square) / 2) / (w.conjugate() * z) - 2 * s
    alpha_1, beta_2 = (x + y).real / 2, (y - x).real / 2
    alpha_2, beta_1 = (x + y).imag / 2, (x - y).imag / 2
    fields = alpha_1, alpha_2, alpha_3, beta_1, beta_2, beta_3
    return np.array([omega_1, omega_2, omega_3, *fields])


number = st.floats(-2, 2).filter(lambda x: abs(x) > 0.05)
points = st.tuples(*[number] * 7).map(point)
