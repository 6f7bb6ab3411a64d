"""Steps of derivations: what does not follow from what stands before it, and would with one change."""

import pytest

from kowalevski_cas.audit.followed import FOLLOWS, FROM_BEFORE
from kowalevski_cas.reading import read
from kowalevski_cas.reading.following import steps
from kowalevski_cas.reading.free_formulas import free_formulas
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
HAMILTON = r"""
Two masses are coupled,
\[ H = \frac{p_1^2}{2\mu} + \frac{p_2^2}{2\mu} + \frac12\kappa(q_1 - q_2)^2 . \]
Hamilton's equations are
\begin{align*} \dot p_1 &= -\kappa(q_1 - %s), \\ \dot p_2 &= \kappa(q_1 - q_2) . \end{align*}
"""
CONSERVED = r"""
The energy of the wheel
\[ E = \frac12 J\dot\alpha^2 - Nb\sin\alpha \]
is constant. Differentiating it by the time we get
\[ \ddot\alpha = \frac{Nb}{J}\%s\alpha . \]
"""
LAGRANGE = r"""
A bead has the Lagrangian
\[ L = \frac12\mu\dot s^2 - \frac14\beta s^4 . \]
Lagrange's equation is
\[ \mu\ddot s = -\beta s%s . \]
"""
DAMPED = r"""
A wheel is damped by a brake, so that
\[ M = -c\alpha - b\dot\alpha , \]
and $J\ddot\alpha = M$ becomes
\[ J\ddot\alpha = -c\alpha %s b\dot\alpha . \]
"""
REDUCED = r"""
Two bodies push each other,
\[ a\ddot z_1 = S, \qquad b\ddot z_2 = -S . \]
For $z = z_1 - z_2$ we have $\nu\ddot z = S$, and so
\[ \nu = \frac{ab}{a %s b} . \]
"""
PERIOD = r"""
The frequency is
\[ \nu = \sqrt{\frac{\kappa}{b}} . \]
Therefore $T = 2\pi/\nu$ is
\[ T = 2\pi%s . \]
"""
CENTRE = r"""
A rod has the mass
\[ W = \sigma a . \]
Its centre is therefore at
\[ z = \frac{1}{W}\int_0^{%s} y\sigma\,dy = \frac{a}{2} . \]
"""
SPEED = r"""
A string obeys
\[ \sigma\frac{\partial^2 w}{\partial t^2} = S\frac{\partial^2 w}{\partial z^2} , \]
which takes the form
\[ \frac{\partial^2 w}{\partial t^2} = b^2\frac{\partial^2 w}{\partial z^2} . \]
Hence
\[ b^2 = \frac{S}{%s} . \]
"""
DECAY = r"""
The number of atoms obeys
\[ \frac{dn}{dt} = -\mu n . \]
The solution is
\[ n = Ke^{%s\mu t} . \]
"""
LOST = r"""
The velocity and the way are
\[ w = w_0 + bt, \qquad s = w_0t + \frac12bt^2 . \]
Eliminating the time we find
\[ w^2 = w_0^2 + 2b%s . \]
"""
ELLIPSE = r"""
An ellipse has the half axes $a$ and $b$,
\[ c = ka, \qquad a^2 = b^2 + c^2 . \]
Therefore
\[ b^2 = a^2(1 %s k^2) . \]
"""
BY_PARTS = r"""
The integrand has no $z$. So
\[ c = w - \kappa\sqrt{1 + (w')^2} %s \frac{\kappa (w')^2}{\sqrt{1 + (w')^2}}
 = w - \frac{\kappa}{\sqrt{1 + (w')^2}} . \]
"""
EFFECTIVE = r"""
With the constant $k = \mu\rho^2\dot\varphi$ the energy is
\[ E = \frac12\mu\dot\rho^2 + \frac12\mu\rho^2\dot\varphi^2 + V(\rho)
 = \frac12\mu\dot\rho^2 + W(\rho) , \]
where
\[ W(\rho) = V(\rho) + \frac{k^2}{%s\mu\rho^2} . \]
"""
SERIES = r"""
The energy is
\[ T = \frac{\mu c^2}{\sqrt{1 - v^2/c^2}} - \mu c^2 . \]
For small speeds
\[ T \approx \frac12\mu v^2 + %s\frac{\mu v^4}{c^2} . \]
"""
SWING = r"""
The period is
\[ S = 4\sqrt{\frac{b}{g}}\int_0^{\pi/2}\frac{d\beta}{\sqrt{1 - k^2\sin^2\beta}} . \]
We expand it,
\[ S = 2\pi\sqrt{\frac{b}{g}}\left(1 + %sk^2 + \dots\right) . \]
"""
ORDER = r"""
The force is
\[ P(z) = -b\sin z . \]
Near the place of rest it is
\[ P(z) = -bz + \frac{bz^3}{%s} + O(z^5) . \]
"""
LIMIT = r"""
The speed is
\[ w = \frac{g}{\beta}(1 - e^{-\beta t}) . \]
At first there is little resistance,
\[ \lim_{\beta\to0} w = %s . \]
"""
SEPARATED = r"""
A body falls,
\[ \mu\frac{dw}{dt} = \mu g - bw . \]
Separating the variables,
\[ \int_0^w\frac{dw'}{g - bw'/\mu} = %s . \]
"""
LOGARITHM = r"""
The rocket obeys
\[ \mu\frac{dw}{dt} = -b\frac{d\mu}{dt} . \]
Integrating from $\mu_0$ to $\mu$ we have
\[ w = w_0 + b\ln\frac{\mu_0}{%s} . \]
"""
DIFFERENTIAL = r"""
The energy is
\[ U = \frac12kz^2 + azy . \]
Its differential is
\[ dU = (kz + ay)\,dz + a%s\,dy . \]
"""
MANY_BODIES = r"""
Let
\[ G = \sum_{i=1}^N\mathbf p_i\cdot\mathbf r_i , \qquad \mathbf p_i = m_i\dot{\mathbf r}_i , \qquad
 \dot{\mathbf p}_i = \mathbf F_i , \qquad T = \frac12\sum_{i=1}^N m_i\dot{\mathbf r}_i^2 . \]
Then
\[ \frac{dG}{dt} = %sT + \sum_{i=1}^N\mathbf F_i\cdot\mathbf r_i . \]
"""
TURNING = r"""
With $z = x + iy$ the equations
\[ \ddot x = 2\nu\dot y , \qquad \ddot y = -2\nu\dot x \]
become $\ddot z = -2i\nu\dot z$. Therefore
\[ \dot z = \dot z_0e^{-%si\nu t} . \]
"""
AREA = r"""
The area is $S = \pi ab$, with $b = a\sqrt{1 - e^2}$, and the parameter is
$p = a(1 - e^2)$, $p = \frac{k^2}{\mu\beta}$. From $S = \frac{k}{2\mu}T$ we get
\[ T^2 = \frac{4\pi^2\mu a^%s}{\beta} . \]
"""
FRAME = r"""
The frame $\mathcal K$ grows with $b$,
\[ \mathbf z^{\mathcal K} = \frac{\mathbf z^{\mathcal S}}{b} . \]
Differentiating we have
\[ \dot{\mathbf z}^{\mathcal K} = \frac1b\dot{\mathbf z}^{\mathcal S}
 - \frac{\dot b}{b}\mathbf z^{%s} . \]
"""
SPHERICAL = r"""
The path is
\[ \mathbf w = \dot\rho\,\mathbf e_1 + \rho\dot\varphi\,\mathbf e_2 . \]
With $\mathbf e_1\times\mathbf e_2 = \mathbf e_3$ the moment is
\[ \mathbf G = \rho\,\mathbf e_1\times\mu\mathbf w = \mu\rho%s\dot\varphi\,\mathbf e_3 . \]
"""
LORENTZ = r"""
An ion moves by
\[ \mu\mathbf a = e\mathbf E + e\mathbf v\times\mathbf B , \qquad \mathbf E = -\nabla\psi . \]
With the energy
\[ W = \frac12\mu\mathbf v^2 + e\psi \]
we have
\[ \frac{dW}{dt} = \mu\mathbf v\cdot\mathbf a + e\mathbf v\cdot\nabla\psi
 = e\mathbf v\cdot(\mathbf E %s \nabla\psi) . \]
"""
PARTICLES = r"""
The momenta in the frame of the centre are
\[ \mathbf P = \sum_{i=1}^N\mu_i\mathbf u_i , \qquad \mathbf w_i = \mathbf u_i + \mathbf b . \]
The whole momentum is
\[ \sum_{i=1}^N\mu_i\mathbf w_i = \mathbf P + \sum_{i=1}^N\mu_i%s . \]
"""
KOENIG = r"""
The sum $\mathbf Q = \sum_{i=1}^N\mu_i\mathbf u_i$ vanishes. With $W = \sum_{i=1}^N\mu_i$ we have
\[ T = \frac12\sum_{i=1}^N\mu_i(\mathbf w + \mathbf u_i)^2 = \frac12W\mathbf w^2
 + %s\sum_{i=1}^N\mu_i\mathbf u_i^2 . \]
"""
ENERGY_OF_TIME = r"""
A bead on a wire has the Lagrangian
\[ L = \frac12\mu\dot s^2 - \psi(s, t) , \]
and the energy
\[ W = \dot s\frac{\partial L}{\partial\dot s} - L . \]
Hence
\[ \frac{dW}{dt} = %s\frac{\partial\psi}{\partial t} . \]
"""
BRACKETS = r"""
The motion is
\[ \dot x_j = \frac{\partial K}{\partial y_j} , \qquad \dot y_j = -\frac{\partial K}{\partial x_j} . \]
Inserting it we find
\[ \frac{dS}{dt} = \sum_{j=1}^n\left(\frac{\partial S}{\partial x_j}\frac{\partial K}{\partial y_j}
 %s \frac{\partial S}{\partial y_j}\frac{\partial K}{\partial x_j}\right)
 + \frac{\partial S}{\partial t} . \]
"""
CONSEQUENCE = r"""
We have
\begin{align*}
\sigma &= \mu\dot z + \nu\dot y = \text{const.} \\
\Rightarrow \dot z &= \frac{\sigma - \nu\dot y}{%s} .
\end{align*}
"""
PLUS = r"""
The centre is given by
\[ z = -\frac{b}{a + b}\lambda . \]
Its end is
\[ y = z + \lambda = \frac{a}{a %s b}\lambda . \]
"""
MISSING = r"""
A cart with a pendulum has the Lagrangian
\[ L = \frac12a\dot z^2 + b\dot z\dot\beta\cos\beta + c\cos\beta . \]
The momentum is
\[ \pi_z = \frac{\partial L}{\partial\dot z} = a\dot z + b\dot\beta%s . \]
"""
CASES = [
    (FRAME, r"\mathcal K", r"\mathcal S"),
    (SPHERICAL, "^2", ""),
    (LORENTZ, "+", "-"),
    (PARTICLES, r"\mathbf b", r"2\mathbf b"),
    (KOENIG, r"\frac12", ""),
    (ENERGY_OF_TIME, "", "-"),
    (BRACKETS, "-", "+"),
    (CONSEQUENCE, r"\mu", r"\mu^2"),
    (PLUS, "+", ""),
    (MISSING, r"\cos\beta", ""),
    (SERIES, r"\frac38", r"\frac34"),
    (SWING, r"\frac14", r"\frac12"),
    (ORDER, "6", "3"),
    (LIMIT, "gt", "2gt"),
    (SEPARATED, "t", "2t"),
    (LOGARITHM, r"\mu", r"\mu^2"),
    (DIFFERENTIAL, "z", "z^2"),
    (MANY_BODIES, "2", ""),
    (TURNING, "2", ""),
    (AREA, "3", "2"),
    (HAMILTON, "q_2", "q_1"),
    (CONSERVED, "cos", "sin"),
    (LAGRANGE, "^3", "^2"),
    (DAMPED, "-", "+"),
    (REDUCED, "+", "-"),
    (PERIOD, r"\sqrt{\frac{b}{\kappa}}", r"\frac{b}{\kappa}"),
    (CENTRE, "a", "W"),
    (SPEED, r"\sigma", r"\sigma^2"),
    (DECAY, "-", ""),
    (LOST, "s", "z"),
    (ELLIPSE, "-", "+"),
    (BY_PARTS, "+", "-"),
    (CENTRAL, "-P(1/w)", "P(1/w)"),
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


@pytest.mark.parametrize(("body", "right", "wrong"), sampled(CASES, 12))
def test_a_step_is_doubted_that_follows_with_one_change_only(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.repairs


def test_of_a_step_and_what_it_is_explained_by_either_may_be_wrong():
    assert found(EFFECTIVE % "2") == []
    doubted = {one.item.order: one.repairs for one in found(EFFECTIVE % "4")}
    assert len(doubted) == 2 and all(doubted.values())


WEIGHTS = r"""
Two weights hang on a thread,
\begin{align*}
U &= -(cy + %sz)g, \\
K &= \frac12(c\dot y^2 + C\dot z^2) .
\end{align*}
The thread has the length $b = y + z$, so that $z = b - y$ and $\dot z = -\dot y$. The Lagrangian is
\[ L = K - U = \frac12(c + C)\dot y^2 + c gy + C g(b - y) , \]
and the equation of motion
\[ \ddot y = \frac{c - C}{c + C}g . \]
"""
ANY_TWO = r"""
The motion is
\[ \dot x_j = \frac{\partial K}{\partial y_j} , \qquad \dot y_j = -\frac{\partial K}{\partial x_j} . \]
The bracket of two functions is
\[ \{R, S\} = \sum_{j=1}^n\left(\frac{\partial R}{\partial x_j}\frac{\partial S}{\partial y_j}
 %s \frac{\partial R}{\partial y_j}\frac{\partial S}{\partial x_j}\right) . \]
With it we have
\[ \dot x_j = \{x_j, K\} , \qquad \frac{dR}{dt} = \{R, K\} + \frac{\partial R}{\partial t} . \]
"""


@pytest.mark.parametrize(("body", "right", "wrong"), [(WEIGHTS, "C", "c"), (ANY_TWO, "-", "+")])
def test_where_a_step_fails_what_it_rests_on_may_be_wrong(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.of.order < one.item.order and one.repairs[0] == found_first(body % right, one.of)


def found_first(body, place):
    """The formula that stands at a place of another page."""
    (known,) = read(page(body)).parts.known
    item = known.items[place.order]
    return free_formulas(known.paper, known.items)[item]


TWO_CASES = r"""
On the left we have
\[ \psi = \dot b y , \]
and on the right
\[ \psi = -\dot b y . \]
Therefore
\[ \chi = \psi + b = b - \dot b y . \]
"""
UNSAID_DIRECTIONS = r"""
Let $G = \mu\rho^2\dot\varphi$. The moment is
\[ \mathbf G = \mu\mathbf x\times\dot{\mathbf x} = \mu\rho\hat{\mathbf x}\times
 (\dot\rho\hat{\mathbf x} + \rho\dot\varphi\hat{\mathbf n}) = \mu\rho^2\dot\varphi\,\hat{\mathbf k} . \]
"""
EITHER_SIGN = r"""
On the line
\[ \frac{y}{z} = -\tan\beta . \]
Hence
\[ y\cos\beta = \pm z\sin\beta . \]
"""
BRAKED = r"""
A bead has the Lagrangian
\[ L = \frac12\mu\dot s^2 - \frac12\kappa s^2 . \]
With friction the equation of motion is
\[ \mu\ddot s = -\kappa s - b\dot s . \]
"""
SECOND_SPRING = r"""
The energy
\[ E = \frac12\mu\dot s^2 + \frac12\kappa s^2 \]
is constant. With a second spring we get
\[ \mu\ddot s = -2\kappa s . \]
"""
UPSIDE_DOWN = r"""
The energy
\[ E = \frac12 J\dot\alpha^2 - N\cos\alpha \]
is constant. Of the inverted pendulum we get
\[ J\ddot\alpha = N\sin\alpha . \]
"""
NAMED = r"""
The force is
\[ S = \mu b . \]
Let $\beta$ be the deceleration. Therefore
\[ S = -\mu\beta . \]
"""
LIMITS = r"""
The sum of the masses is
\[ W = \sum_{j=1}^n\mu_j . \]
Therefore
\[ 2W = \sum_{j=1}^n\left(\mu_j + \mu_j\right) . \]
"""
ANOTHER_HAMILTONIAN = r"""
Let
\[ H = \frac{p^2}{2\mu} + \frac12\kappa q^2 . \]
Replacing $q$ by $2q$ we have Hamilton's equations
\[ \dot p = -4\kappa q . \]
"""
NEGATIVE_ROOT = r"""
On the circle
\[ z^2 + y^2 = b^2 . \]
Therefore below the axis
\[ z = -\sqrt{b^2 - y^2} . \]
"""
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
    "body",
    [
        TWO_BODIES,
        HEAVIER,
        IF,
        DENIED,
        OTHER_SECTION,
        UNKNOWN,
        LAW,
        BOUNDARY,
        BRAKED,
        SECOND_SPRING,
        UPSIDE_DOWN,
        NAMED,
        LIMITS,
        ANOTHER_HAMILTONIAN,
        NEGATIVE_ROOT,
        TWO_CASES,
        UNSAID_DIRECTIONS,
        EITHER_SIGN,
    ],
)
def test_what_need_not_follow_is_not_doubted(body):
    assert found(body) == []


def test_it_is_yellow_with_what_would_follow_and_nothing_is_refuted():
    page = CHAIN % "+"
    (one,) = [one for one in audited(page).formulas if FROM_BEFORE in one.message]
    assert one.verdict == "undecided" and r"\sqrt{1 - \frac{v^2}{c^2}}" in one.message
    assert not [one for one in audited(CHAIN % "-").formulas if FROM_BEFORE in one.message]


KEPLER = r"""
Gravity keeps a moon on a circle of radius $a$,
\[ \frac{\Gamma M}{a^2} = a\nu^2 . \]
Therefore
\[ \nu^2 = \frac{\Gamma M}{%s} . \]
"""


def test_what_follows_is_not_called_false_though_no_equation_gives_its_letters():
    *_, right = audited(KEPLER % "a^3").formulas
    assert (right.verdict, right.message) == ("open", FOLLOWS)
    *_, wrong = audited(KEPLER % "a^2").formulas
    assert wrong.verdict == "undecided" and r"\frac{\Gamma M}{a^3}" in wrong.message


def test_a_step_beside_equations_that_leave_out_terms_is_looked_at():
    text = r"""In first order
    \[ \ddot{\mathbf r} = \mathbf g - 2\boldsymbol\omega\times\dot{\mathbf r} + O(\omega^2) . \]
    Integrating it we have
    \[ \dot{\mathbf r} = \mathbf gt - 2\boldsymbol\omega\times\mathbf r + O(\omega^2) . \]
    Put back into the equation it gives
    \[ \ddot{\mathbf r} = \mathbf g\,\boldsymbol\omega\times\mathbf gt + O(\omega^2) . \]"""
    assert not [one for one in found(text) if one.follows]


WEAK = r"""The masses move by \[ m\ddot x=-kx-c(x-y),\qquad m\ddot y=-ky+c(x-y) . \]
\section{Frequencies} The frequencies are \[ \omega_1=\sqrt{\frac km},\qquad \omega_2=\sqrt{\frac km+\frac{2c}m} . \]
\section{Beats} For a weak coupling we have approximately \[ \omega_2-\omega_1\approx%s . \]"""


def test_an_expansion_follows_from_what_another_section_gives():
    *_, right = audited(WEAK % r"\frac{c}{\sqrt{km}}").formulas
    assert right.verdict != "undecided"
    *_, wrong = audited(WEAK % r"\frac{c}{2\sqrt{km}}").formulas
    assert wrong.verdict == "undecided" and r"\frac{c}{\sqrt{km}}" in wrong.message
