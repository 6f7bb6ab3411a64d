"""Steps of derivations: what does not follow from what stands before it, and would with one change."""

import pytest

from kowalevski_cas.audit.followed import FROM_BEFORE
from kowalevski_cas.reading import read
from kowalevski_cas.reading.following import steps
from kowalevski_cas.source.text import Source
from tests.audit.test_doubted import audited
from tests.sample import sampled

CENTRAL = r"""
A body of mass $\mu$ has the moment $k = \mu\rho^2\dot\varphi$, and its radius obeys
\[ \ddot\rho - \frac{k^2}{\mu^2\rho^3} = \frac{P(\rho)}{\mu} . \]
With $w = 1/\rho$ we have
\[ \ddot\rho = -\frac{k^2}{\mu^2}w^2\frac{d^2 w}{d\varphi^2} . \]
Inserted, this gives
\[ \frac{k^2}{\mu}w^2\left(\frac{d^2w}{d\varphi^2} + w\right) = %s . \]
"""
EXACT = r"""
We want the solutions of
\[ (4z - 2y)\frac{dz}{dy} + 2y - 2z = 0 . \]
The solution is
\[ y^2 %s yz + 2z^2 = K . \]
"""
BEAM = r"""
The deflection obeys
\[ b\,\frac{\partial^2 w}{\partial z^2} = -q\cos\beta . \]
The solution with both ends at rest is
\[ w = \frac{q\cos\beta}{2%s}z(a - z) . \]
"""
CHAIN = r"""
With $\lambda = \sqrt{1 - v^2/c^2}$ we have
\[ E = \frac{mc^2}{\lambda} = \frac{mc^2}{\sqrt{1 %s v^2/c^2}} = mc^2 + \frac12mv^2 + \cdots . \]
"""
RATE = r"""
Let $B$ be constant. The solution is
\[ z = \cosh(B\tau)a + \frac{1}{B}\sinh(B\tau)b . \]
Differentiating we have
\[ z' = B\sinh(B\tau)a + \%s(B\tau)b . \]
"""
INTEGRAND = r"""
The integrand is
\[ g = z\sqrt{1 + (z')^2} , \]
and so
\[ g - z'\frac{\partial g}{\partial %s} = \frac{z}{\sqrt{1 + (z')^2}} = \text{constant} . \]
"""
OSCILLATOR = r"""
The equation of motion is
\[ J\ddot\alpha = -mgb\sin\alpha \]
with $J = 2mb^2$, or
\[ \ddot\alpha = -\frac{g}{%s} . \]
"""
WAVE = r"""
Primes are derivatives by $x$. We have
\begin{align*}
  \chi(x, t) &= \exp\left\{aR(x,t)\right\}, \\
  \chi''(x, t) &= \left(aR''(x, t) + a^2%s\right)\chi(x, t) .
\end{align*}
"""
SCHEME = r"""
The scheme is
\begin{align*}
p^{n+1} &= p^n - \Delta t\,k q^n, \\
q^{n+1} &= q^n + \Delta t\,p^{n+1} .
\end{align*}
This gives
\[ q^{n+1} = q^n + \Delta t(p^n - k\Delta t%s q^n) . \]
"""
SOURCE = r"""
For $y = t^2$
\[ y'' + by = 2 + bt^2 \ne 0 . \]
The equation $y'' + by = s$ has the solution $y = t^2$ for
\[ s = %s . \]
"""
INTEGRAL = r"""
The period is small, and then
\[ \frac{S}{2} = \sqrt{\frac{b}{k}}\int_0^{\beta}\frac{d z}{\sqrt{\beta^2 - z^2}} = %s\sqrt{\frac{b}{k}} . \]
"""
FORM = r"""
The energy is a form in the velocities,
\[ K = \frac{1}{2}\sum_{j,l=1}^n c_{jl}\dot x_j\dot x_l . \]
By the theorem of Euler we have
\[ %s = \sum_{j=1}^n\frac{\partial K}{\partial\dot x_j}\dot x_j . \]
"""
TOTAL = r"""
The function changes by
\[ \frac{dS}{dt} = \sum_{j=1}^n\left(\frac{\partial S}{\partial x_j} %s \dot x_j
 + \frac{\partial S}{\partial y_j}\dot y_j\right) + \frac{\partial S}{\partial t} . \]
"""
ARM = r"""
The arm moves by
\[ \mathbf{J}(\mathbf{x})\ddot{\mathbf{x}} + \mathbf{D}(\mathbf{x},\dot{\mathbf{x}})\dot{\mathbf{x}}
 = \mathbf{E}\mathbf{w} . \]
Solved for the accelerations the equations are
\[ \ddot{\mathbf{x}} = \mathbf{J}^{-1}(\mathbf{x})\left[\mathbf{E}\mathbf{w}
 - \mathbf{D}(\mathbf{x},\dot{\mathbf{x}})%s\right] . \]
"""
CASES = [
    (CENTRAL, "-P(1/w)", "P(1/w)"),
    (EXACT, "-2", "-3"),
    (BEAM, "b", "b^2"),
    (CHAIN, "-", "+"),
    (RATE, "cosh", "sinh"),
    (INTEGRAND, "z'", "z"),
    (OSCILLATOR, r"2b}\sin{\alpha", r"2b\sin\alpha"),
    (WAVE, r"\bigl(R'(x, t)\bigr)^2", r"R''(x, t)"),
    (SCHEME, "", "^2"),
    (INTEGRAL, r"\frac{\pi}{2}", r"2\pi"),
    (FORM, "2K", "K"),
    (TOTAL, "", "+"),
    (ARM, r"\dot{\mathbf{x}}", ""),
    (SOURCE, "2 + bt^2", "bt^2"),
]


def page(body):
    text = "\\documentclass{article}\n\\begin{document}\n" + body + "\n\\end{document}\n"
    return Source("PAPER.tex", text)


def found(body):
    reading = read(page(body))
    (known,) = reading.parts.known
    return [*steps(known, frozenset(known.items), frozenset(), frozenset())]


@pytest.mark.parametrize(("body", "right", "wrong"), sampled(CASES, 5))
def test_a_step_is_doubted_that_follows_with_one_change_only(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.repairs


TWO_BODIES = r"""
The sum and the difference are
\[ \sigma = a + b . \]
Then
\[ \delta = a - b , \]
and thus
\[ a = \frac{\sigma + \delta}{2} . \]
"""
HEAVIER = r"""
A body obeys
\[ \ddot\zeta = -\frac{k}{\mu}\zeta . \]
With twice the mass this becomes
\[ 2\mu\ddot\zeta = -k\zeta . \]
"""
IF = r"""
The frequency is
\[ \nu = \sqrt{k/\mu} . \]
If the springs are two, then
\[ \nu^2 = \frac{2k}{\mu} . \]
"""
DENIED = r"""
The frequency is
\[ \nu = \sqrt{k/\mu} . \]
It is not true that
\[ \nu^2 = \frac{2k}{\mu} . \]
"""
OTHER_SECTION = r"""
The frequency is
\[ \nu = \sqrt{k/\mu} . \]
\section{Two springs}
Then
\[ \nu^2 = \frac{2k}{\mu} . \]
"""
UNKNOWN = r"""
The momentum is
\[ p = \mu\dot\zeta . \]
Thus the force is
\[ F(\zeta) = -\kappa\zeta . \]
"""
LAW = r"""
The energy is
\[ E = \frac{1}{2}\mu\dot\zeta^2 + \frac{1}{2}k\zeta^2 . \]
Hence the equation of motion is
\[ \mu\ddot\zeta = -k\zeta . \]
"""
BOUNDARY = r"""
The deflection obeys
\[ \frac{\partial^2 w}{\partial z^2} = -q . \]
We have $w = 0$ when $z = 0$ and when $z = a$. The solution is
\[ w = \frac{q}{2}z(a - z) . \]
"""


@pytest.mark.parametrize(
    "body", [TWO_BODIES, HEAVIER, IF, DENIED, OTHER_SECTION, UNKNOWN, LAW, BOUNDARY]
)
def test_what_need_not_follow_is_not_doubted(body):
    assert found(body) == []


def test_it_is_yellow_with_what_would_follow_and_nothing_is_refuted():
    page = CHAIN % "+"
    (one,) = [one for one in audited(page).formulas if FROM_BEFORE in one.message]
    assert one.verdict == "undecided" and r"\sqrt{1 - \frac{v^2}{c^2}}" in one.message
    assert not [one for one in audited(CHAIN % "-").formulas if FROM_BEFORE in one.message]
