r"""1. O^4 separated: the variables u_1 and u_2."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2005.values import on_O4_values, with_integrals

section = Section("1", "Separation of variables", copied=False)

abbreviations = section.display(
    "abbreviations",
    r"""
\sigma = \tau_3^2-2p^2\tau_3+r^4, \quad X = x_1x_2, \quad \xi = x_1x_2+z_1z_2-\tau_3""",
)

xi = section.inline("xi-w", r"\xi = 2sw_1w_2")

separated = section.display(
    "separated-O4",
    r"""
(u_1-u_2)^2\dot u_1^2 = \frac{1}{2s\tau_3}(u_1^2-\sigma)(u_1^2-4s^2k)\left((u_1+\tau_3)^2-r^4\right),
\quad
(u_1-u_2)^2\dot u_2^2 = \frac{1}{2s\tau_3}(u_2^2-\sigma)(u_2^2-4s^2k)\left((u_2+\tau_3)^2-r^4\right)""",
)

# On O^4: what X and xi are there, and how they move.

plane = with_integrals.called("O⁴ with X and ξ").defining(abbreviations)

section.states(Identity, xi, on=plane, says="the second variable of the plane")

known = section.states(
    Identity,
    section.lemma(
        "X-xi",
        r"""
\sigma = 4s^2(k-\tau_3), \quad
X = \frac{\eta^2+\frac14\omega_3^2(z_1z_2-2sw_1w_2)^2}{w_1w_2z_1z_2}, \quad
\tau_3 = X+z_1z_2-2sw_1w_2, \quad
\dot X = 2\eta, \quad \dot\xi = is(w_1z_2-w_2z_1)""",
        "the variables of the plane by those of $O^4$",
    ),
    on=plane,
    says="the constants, the variables of the plane, and their motion on $O^4$",
)

root = section.lemma(
    "root-of-u", r"q^2 = X\left(\tau_3\xi^2-\sigma(\tau_3-X)\right)", "the discriminant over four"
)

rates_on_O4 = section.lemma(
    "rates-on-O4",
    r"\alpha = 2\eta, \quad \beta = is(w_1z_2-w_2z_1)",
    "the velocity of $X$ and $\\xi$ on $O^4$, from above",
)

speed = section.lemma(
    "speed",
    r"""
V = \left(\sigma(\tau_3-X)-\xi^2(\tau_3+X)\right)\alpha-2(\tau_3-X)X\xi\beta, \quad
W = \xi\alpha+(\tau_3-X)\beta, \quad
L = \xi^2(\tau_3+X)-\sigma(\tau_3-X), \quad
N = 2\tau_3\xi(\tau_3-X+\xi)-(\tau_3-X)\left(\xi^2+\sigma+4s(h-s)(\tau_3-X)\right)""",
    "parts of the derivatives of $u_1$ and $u_2$",
)

cubic = section.lemma(
    "cubic",
    r"""
2s(V-2qW)^2 = (L+2\xi q)\left(L-4s^2(\tau_3-X)^2+2\xi q\right)\left(N+2(\tau_3-X+\xi)q\right),
\quad
2s(V+2qW)^2 = (L-2\xi q)\left(L-4s^2(\tau_3-X)^2-2\xi q\right)\left(N-2(\tau_3-X+\xi)q\right)""",
    "the separated equations in $X$ and $\\xi$",
)

section.states(
    Identity,
    cubic,
    on=plane.called("O⁴ with the discriminant")
    .redefining(known[1], known[2], known[3], xi)
    .having(constants=("a", "b", "c"))
    .adjoining(root)
    .defining(rates_on_O4, speed),
    says="the velocities of the variables of the plane on $O^4$",
)

# In the plane of X and xi: how u1 and u2 move.

roots = section.lemma(
    "u",
    r"u_1 = \frac{\tau_3\xi+q}{\tau_3-X}, \quad u_2 = \frac{\tau_3\xi-q}{\tau_3-X}",
    "the roots of the quadratic equation",
)

rates = section.lemma("plane-rates", r"\dot X = \alpha, \quad \dot\xi = \beta", "any velocity")

in_plane = (
    Scene(
        "plane of X and ξ",
        variables=("X", r"\xi"),
        constants=("s", r"\tau_3", "p", "r", r"\alpha", r"\beta"),
        nonzero=("s", r"\tau_3", r"\tau_3-X", "q^2"),
    )
    .moving(rates)
    .defining(abbreviations[1], on_O4_values[1], on_O4_values[2])
    .adjoining(root)
    .defining(speed, roots)
)

section.states(
    Identity,
    section.lemma(
        "quadratic-u",
        r"""
(\tau_3-X)u_1^2-2\tau_3\xi u_1+\tau_3\xi^2+\sigma X = 0, \quad
(\tau_3-X)u_2^2-2\tau_3\xi u_2+\tau_3\xi^2+\sigma X = 0""",
        "the quadratic equation at its roots",
    ),
    on=in_plane,
    says="$u_1$ and $u_2$ are the roots of a quadratic equation",
)

section.states(
    Identity,
    section.lemma(
        "sides",
        r"""
(u_1-u_2)^2\dot u_1^2 = \frac{\tau_3^2(V-2qW)^2}{(\tau_3-X)^6}, \quad
(u_1-u_2)^2\dot u_2^2 = \frac{\tau_3^2(V+2qW)^2}{(\tau_3-X)^6}, \quad
(u_1^2-\sigma)(u_1^2-4s^2k)\left((u_1+\tau_3)^2-r^4\right) = \frac{\tau_3^3(L+2\xi q)
\left(L-4s^2(\tau_3-X)^2+2\xi q\right)\left(N+2(\tau_3-X+\xi)q\right)}{(\tau_3-X)^6}, \quad
(u_2^2-\sigma)(u_2^2-4s^2k)\left((u_2+\tau_3)^2-r^4\right) = \frac{\tau_3^3(L-2\xi q)
\left(L-4s^2(\tau_3-X)^2-2\xi q\right)\left(N-2(\tau_3-X+\xi)q\right)}{(\tau_3-X)^6}""",
        "both sides of the separated equations, by those of the equations in $X$ and $\\xi$",
    ),
    on=in_plane,
    says=r"both sides of the separated equations, by $X$ and $\xi$",
)
