r"""Letters with an index that words call roots of the equation before them."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

RADIAL = r"""The equation of motion is $\ddot r=-V'(r)$ with $V(r)=-\frac{M}{r}+\frac{h^2}{2r^2}-\frac{Mh^2}{r^3}$.
The radius of a circular orbit is a root of the quadratic equation \[Mr^2-h^2r+3Mh^2=0 .\]
WORDS \[r_\pm=\frac{h^2}{2M}\left(1\pm\sqrt{1-\frac{12M^2}{h^2}}\right) .\]"""
EQUILIBRIA = r"The system is $\ddot f=cf-3f^2+a$. WORDS \[f_{1,2}=\frac{c\pm\sqrt{c^2+12a}}{6} .\]"
TOP = r"""For the velocity $\omega$ of precession we obtain the equation \[A\omega^2\cos\theta_0-p\omega+k=0 .\]
WORDS \[\omega_{1,2}=\frac{p\pm\sqrt{p^2-4Ak\cos\theta_0}}{2A\cos\theta_0} .\]"""
CUBIC = r"""We study \[f(u)=(1-u)^2\left[\beta(1+u)-a^2\right] .\] WORDS \[u_3=\frac{a^2}{\beta}-1 .\]"""


@pytest.mark.parametrize(
    ("text", "words", "wrong"),
    [
        (RADIAL, "There are two roots", ("12M", "10M")),
        (RADIAL, "Its solutions are", (r"1-\frac", r"1+\frac")),
        (EQUILIBRIA, "Equilibria satisfy $3f^2-cf-a=0$, whence", ("12a", "6a")),
        (EQUILIBRIA, r"The equilibria are the roots of \[3f^2-cf-a=0,\] namely", ("{6}", "{3}")),
        (TOP, "It has the roots", ("4Ak", "2Ak")),
        (TOP, "Solving it we find", ("{2A", "{A")),
        (TOP, "Его корни суть", ("4Ak", "2Ak")),
        (CUBIC, "Besides the double root $u=1$ it has the root", ("-1 .", "+1 .")),
    ],
)
def test_a_root_satisfies_its_equation(text, words, wrong):
    """And what is no root is noticed."""
    true = verdicts(text.replace("WORDS", words))
    false = verdicts(text.replace("WORDS", words).replace(*wrong))
    assert [*true.values()][-1].green
    assert not [*false.values()][-1].green
    assert all(one is not Verdict.REFUTED for one in true.values())


@pytest.mark.parametrize(
    "words",
    [
        "We denote",
        "Approximately the roots are",
        "If",
        "The sum of the roots is",
        "For small $M$ the root is",
    ],
)
def test_without_such_words_it_is_a_definition(words):
    found = reading(RADIAL.replace("WORDS", words))
    assert not any(f.role.kind == "named root" for f in found.formulas)
