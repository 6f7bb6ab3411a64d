r"""2. The whole phase point on O^4 by u_1, u_2, for c = 0 and both signs of u_2+\tau_3.

The point is on O^4 with the constants s, \tau_3 and p, r, so the values of H, K, G there are known.
"""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section1 import eq3, eq4, eq5
from ..kharlamov2002.section2 import eq9, eq17, unit
from ..kharlamov2005.third_subsystem import forces, partial, polynomial
from ..kharlamov2005.values import on_O4_values
from ..kharlamov_savushkin2004.phase_point import no_c
from ..kharlamov_savushkin2004.separation import any_c
from ..kharlamov_savushkin2004.setting import p
from ..kharlamov_savushkin2004.third_integral import VECTORS, G
from .separation import abbreviations, separated, xi

section = Section("2", "The phase point", copied=False)

epsilon = section.inline("epsilon", r"\varepsilon^2 = 1")

kappa = section.display("kappa", r"\kappa^2 = \sigma+4s^2\tau_3")

p_of_sigma = section.lemma(
    "p-of-sigma",
    r"p^2 = \frac{\tau_3^2+r^4-\sigma}{2\tau_3}",
    r"the definition of $\sigma$ solved for $p^2$",
)

radicals = section.display(
    "radicals-O4",
    r"""
\mu_1^2 = \frac{u_1^2-\sigma}{\tau_3}, \quad \mu_2^2 = \frac{u_2^2-\sigma}{\tau_3}, \quad
A_1^2 = u_1+\tau_3+r^2, \quad B_1^2 = r^2-\tau_3-u_1, \quad
A_2^2 = \varepsilon(u_2+\tau_3+r^2), \quad B_2^2 = \varepsilon(u_2+\tau_3-r^2), \quad
K_1^2 = \frac{\kappa^2-u_1^2}{2s}, \quad K_2^2 = \frac{u_2^2-\kappa^2}{2s}, \quad
E^2 = \frac{2\varepsilon\sigma}{\sigma+u_1u_2+\tau_3\mu_1\mu_2}""",
)

parts = section.display(
    "parts",
    r"""
\Pi = (u_1+\tau_3)(u_2+\tau_3)-r^4, \quad Y = \tau_3(u_1+u_2+2\tau_3-2p^2+\mu_1\mu_2), \quad
V = 4s^2-\mu_1\mu_2, \quad T = \frac{2s}{\tau_3}K_1K_2, \quad
\Lambda = \varepsilon A_1A_2B_1B_2, \quad d = \mu_1-\mu_2, \quad N = 4s\tau_3r^2d^2""",
)

fields = section.display(
    "fields-by-u",
    r"""
\alpha_1 = \frac{V(\tau_3\Pi+r^2Y)-(\tau_3+r^2)T\Lambda}{N}, \quad
\alpha_2 = \frac{(\tau_3+r^2)V\Lambda+T(\tau_3\Pi+r^2Y)}{N}, \quad
\alpha_3 = \frac{EA_1A_2}{2r}, \quad
\beta_1 = \frac{(\tau_3-r^2)V\Lambda+T(\tau_3\Pi-r^2Y)}{N}, \quad
\beta_2 = \frac{V(r^2Y-\tau_3\Pi)+(\tau_3-r^2)T\Lambda}{N}, \quad
\beta_3 = \frac{EB_1B_2}{2r}""",
)

velocity = section.display(
    "velocity-by-u",
    r"""
\omega_1 = \frac{E(\mu_1A_2B_1K_2-\mu_2A_1B_2K_1)}{4sr(u_1-u_2)}, \quad
\omega_2 = -\frac{E(\mu_1A_1B_2K_2+\mu_2A_2B_1K_1)}{4sr(u_1-u_2)}, \quad
\omega_3 = \frac{\varepsilon A_2B_2K_1-A_1B_1K_2}{\tau_3d}""",
)

rates = section.display(
    "rates-of-u",
    r"""
\dot u_1 = -\frac{\mu_1K_1A_1B_1}{u_1-u_2}, \quad
\dot u_2 = -\frac{\varepsilon\mu_2K_2A_2B_2}{u_1-u_2}""",
)

by_u = (
    Scene(
        variables=("u_1", "u_2"),
        constants=("s", r"\tau_3", "r", r"\sigma"),
        nonzero=("s", r"\tau_3", "r", r"\sigma", "u_1-u_2", "u_1+u_2"),
    )
    .adjoining(p_of_sigma, any_c, epsilon, kappa, radicals)
    .defining(parts, fields, velocity)
)

point = (
    by_u.called("phase point on O⁴")
    .having(vectors=VECTORS)
    .moving(rates)
    .restricted(no_c)
    .defining(eq17, G)
    .naming("g", G[1])
)

section.states(
    Identity,
    separated,
    on=by_u.called("separated by u").moving(rates).defining(on_O4_values[2]),
    says="the separated equations",
)
section.states(
    Identity,
    eq4,
    on=point,
    says="the fields have the lengths $a$ and $b$ and are orthogonal",
    ids=("point.a", "point.b", "point.c"),
)
section.states(
    Identity,
    eq3,
    on=point,
    says="the fields move by (3) of Kharlamov (2002)",
    ids=("point.alpha", "point.beta"),
)
section.states(
    Identity,
    eq5,
    on=point,
    says="the body moves by (5) of Kharlamov (2002)",
    ids=("point.omega_1", "point.omega_2", "point.omega_3"),
)
section.states(Identity, p, on=point, says="the constant $p$ by the fields", ids=("point.p",))
with_unit = by_u.called("phase point on O⁴ with the unit").with_unit(unit[1]).defining(eq9)

complex_point = section.states(
    Identity,
    section.display(
        "complex-point",
        r"""
x_1 = \frac{(V+iT)(\Pi+i\Lambda)}{2sr^2d^2}, \quad y_1 = \frac{(V+iT)(Y+i\Lambda)}{2s\tau_3d^2}, \quad
z_1 = \frac{E}{2r}(A_1A_2+iB_1B_2), \quad
w_1 = -\frac{E(A_1B_2+iA_2B_1)(\mu_2K_1+i\mu_1K_2)}{4sr(u_1-u_2)}""",
    ),
    on=with_unit,
    says="$x_1$, $y_1$, $z_1$ and $w_1$ at the point",
    ids=("point.x1", "point.y1", "point.z1", "point.w1"),
)

conjugate_point = section.states(
    Identity,
    section.lemma(
        "conjugate-point",
        r"""
x_2 = \frac{(V-iT)(\Pi-i\Lambda)}{2sr^2d^2}, \quad y_2 = \frac{(V-iT)(Y-i\Lambda)}{2s\tau_3d^2}, \quad
z_2 = \frac{E}{2r}(A_1A_2-iB_1B_2), \quad
w_2 = -\frac{E(A_1B_2-iA_2B_1)(\mu_2K_1-i\mu_1K_2)}{4sr(u_1-u_2)}""",
        "the conjugates of the line above",
    ),
    on=with_unit,
    says="$x_2$, $y_2$, $z_2$ and $w_2$ at the point",
    ids=("point.x2", "point.y2", "point.z2", "point.w2"),
)

short = (
    with_unit.called("phase point on O⁴ in complex variables")
    .redefining(complex_point, conjugate_point)
    .defining(forces, abbreviations[3])
)

norms = section.identity(
    "norms",
    r"""
x_1x_2 = \frac{(u_1-u_2)^2}{d^2} = \tau_3(1-\varepsilon E^2), \quad
\xi = \frac12\varepsilon E^2(u_1+u_2), \quad
z_1z_2 = \frac12\varepsilon E^2(u_1+u_2+2\tau_3), \quad
V^2+T^2 = 4s^2d^2, \quad \Pi^2+\Lambda^2 = r^4(u_1-u_2)^2""",
    on=short,
    says=r"$x_1x_2$, $\xi$ and $z_1z_2$ at the point, and the norms of $V+iT$ and $\Pi+i\Lambda$",
)

section.states(
    Identity,
    polynomial,
    on=short,
    says="the point is on $O^4$",
    ids=[f"point.O4.{k}" for k in range(1, 6)],
)
section.states(Identity, partial[2], on=short, says=r"$\tau_3$ at the point", ids=("point.tau",))
section.states(Identity, xi, on=short, says=r"$\xi$ by the velocity", ids=("point.xi",))
