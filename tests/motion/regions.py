"""Motions in every regime, and on the separating curves, for the tests of this folder."""

from fractions import Fraction

from kowalevski_cas.motion import Motion, Parameters

EVERY_REGIME = [
    ("0.8", "0.9"), ("0.5", "1.45"), ("0.3", "1.7"),
    ("0.8", "-0.9"), ("0.5", "-1.45"), ("0.3", "-1.7"),
    ("-0.3", "1.1"), ("-0.3", "0.5"), ("-0.3", "0"), ("-0.8", "0.5"), ("-0.6", "0"), ("-0.3", "-0.5"),
    ("-2", "0.3"), ("-2", "-2"), ("-0.3", "-1.1"),
]  # fmt: skip
"""(m, ℓ) for a = 1, b = 2/5: one in each of the fifteen regimes."""

SEPARATING = {
    "s1 rests": ("0.8", "0.6"),
    "s2 rests": ("0.5", "0.6"),
    "both rest": (Fraction(5, 7), Fraction(3, 7)),
    "s1 is asymptotic": ("0.5", "2"),
    "s2 is asymptotic": ("0.5", "1.4"),
    "s1 through infinity is asymptotic": ("-0.4", "0.2"),
    "s1 goes from one double root to the other": ("-0.5", "0"),
    "s2 goes from one double root to the other": ("-1.25", "0"),
}


def motion(m, ell, **start):
    return Motion(Parameters.of(1, "0.4", m, ell), **start)
