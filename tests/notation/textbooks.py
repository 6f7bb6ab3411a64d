"""Formulas as textbooks of mechanics print them, and the names in them."""

from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.notation.functions import FUNCTIONS

WORDS = Vocabulary(
    scalars=frozenset(
        r"""x y z p q k m g c r v H U V T L E \theta \phi \omega \omega_1 \omega_2 \omega_3 \ell \mu
        x_1 x_2 x_3 p_1 p_2 p_3 q_1 q_2 q_3 m_1 m_2 m_3 q_{r_0} p_{O'} a_1 a_2 r_{12} r_{13} r_{23}""".split()
    ),
    vectors=frozenset(
        r"\mathbf{r} \mathbf{p} \mathbf{r}_1 \mathbf{r}_2 \boldsymbol{\gamma} \mathbf{M} \mathbf{L}".split()
    ),
    matrices=frozenset([r"\mathbf{A}", r"\mathbf{B}"]),
    functions=FUNCTIONS,
    times=frozenset("t"),
    moving=frozenset(r"x y q \theta \mathbf{r}".split()),
)

FORMULAS = [
    # derivatives
    r"m\ddot x = -kx",
    r"\frac{d^2x}{dt^2} + \omega^2 x = 0",
    "dx/dt = y",
    "d^2x/dt^2 = -x",
    r"\dot x(t) = y(t)",
    r"\ddot{\theta}(t) + \frac{g}{\ell}\sin\theta(t) = 0",
    r"\dot q = \frac{\partial H}{\partial p}, \quad \dot p = -\frac{\partial H}{\partial q}",
    r"\dot q = \partial H/\partial p",
    r"\dot q_1 = ∂H/∂p_1",
    r"\frac{\partial^2 H}{\partial q^2} + \frac{\partial^2 H}{\partial q\partial p} = 0",
    # sums
    r"T = \frac12\sum_{i=1}^{3} m_i\dot x_i^2",
    r"\sum_{i=1}^3 p_i^2 - \sum_{k=1}^{2} kx_k",
    r"H = \sum_{i=1}^3\left(\frac{p_i^2}{2m_i} + U\right)",
    r"\sum\limits_{i=1}^2 \sum_{j=1}^2 x_ip_j",
    r"U = -\sum_{i=2}^3\frac{m_1m_i}{r_{1i}}",
    r"\sum_{k=1}^2 \mathbf r_k = \mathbf r",
    # numbers
    "x = 0.5y + 12.75",
    "{x \\over 2y} = 3.5.",
    r"\frac{{x+1 \over y}}{2}",
    # functions
    r"\ddot\theta = -\frac{g}{\ell}\sin\theta",
    r"\sin\theta\cos\theta = \frac12\sin 2\theta",
    r"\sin^2\theta + \cos^2\theta = 1",
    r"x = r\sin\theta\cos\phi,\quad y = r\sin\theta\sin\phi,\quad z = r\cos\theta",
    r"H = \frac{p_1^2+p_2^2}{2} + e^{q_1-q_2}",
    r"V = \mathrm{e}^{-2x} - 2\exp(-x) + \ln x",
    r"x = r\cos\omega t, \quad y = \operatorname{tg}\frac{\theta}{2}\ctg\phi + \sec^2\phi",
    r"\dot\theta = 2k\operatorname{cn}(\omega t,k), \quad p = \operatorname{sn}^2(q,k)\mathrm{dc}(q,k)",
    r"\phi = \arctg\frac{y}{x} - \operatorname{artanh}\frac xr, \quad r = \sh\mu\cosh\mu\operatorname{th}\mu",
    # lengths, squares, products
    r"\ddot{\mathbf r} = -\frac{\mu\mathbf r}{|\mathbf r|^3}",
    r"U = -\frac{k}{\|\mathbf r_1 - \mathbf r_2\|}",
    r"\left|\frac{x}{y}\right| + |y| = |x|\,|y|",
    r"\lvert x|y|\rvert = \lvert\mathbf r\rvert",
    r"\boldsymbol\gamma^2 = 1, \quad \langle\mathbf M, \boldsymbol\gamma\rangle = c",
    r"\mathbf L = \mathbf r\times\mathbf p, \quad \mathbf L\cdot\mathbf r = 0",
    # matrices
    r"\dot{\mathbf A} = [\mathbf A, \mathbf B]",
    r"\det(\mathbf A - \mu) = 0, \quad \operatorname{tr}\mathbf A^2 = 2H",
    r"\begin{vmatrix} x & y \\ -y & x \end{vmatrix} = x^2 + y^2",
    r"\begin{pmatrix} \dot x \\ \dot y \\ \dot z \end{pmatrix} = \begin{pmatrix} y \\ x \\ 0 \end{pmatrix}",
    # two signs, relations
    r"\dot x = \pm y, \quad p = q \mp x",
    r"x < y, \quad x \leq 1, \quad y \geqslant 0, \quad x \approx 2.5, \quad H \to 0",
    # Unicode
    "ω_1 − ω_2·x ≤ 3",
    # systems
    r"\begin{align} \dot x &= y \\ \dot y &= -x + 0.1y \end{align}",
    r"\begin{cases} \dot x = y \\ \dot y = -x \end{cases}",
    r"\begin{dcases} \dot x = y, \\ \dot y = -\frac{x}{2}. \end{dcases}",
    r"\begin{eqnarray} \dot x &=& y \\ \dot y &=& x \end{eqnarray}",
]
