r"""3. One-variable roots for E, and u_2 as a quotient, which passes through infinity."""

import re

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section1 import eq3, eq4, eq5
from ..kharlamov_savushkin2004.phase_point import no_c
from ..kharlamov_savushkin2004.separation import any_c
from ..kharlamov_savushkin2004.third_integral import VECTORS
from .phase_point import fields, kappa, p_of_sigma, parts, radicals, velocity

section = Section("3", "Quotients of roots, and infinity", copied=False)

one_variable = section.display(
    "one-variable",
    r"""
P_1^2 = u_1+\sqrt{\sigma}, \quad P_2^2 = u_2+\sqrt{\sigma}, \quad
Q_1^2 = u_1-\sqrt{\sigma}, \quad Q_2^2 = u_2-\sqrt{\sigma}""",
)

products = section.display(
    "products", r"\sqrt{\tau_3}\mu_1 = P_1Q_1, \quad \sqrt{\tau_3}\mu_2 = P_2Q_2"
)

solved = section.lemma(
    "solved-products",
    r"\mu_1 = \frac{P_1Q_1}{\sqrt{\tau_3}}, \quad \mu_2 = \frac{P_2Q_2}{\sqrt{\tau_3}}",
    "the line above solved for $\\mu_1$, $\\mu_2$",
)

quotient = section.display(
    "quotient",
    r"""
\left(\frac{P_1P_2-Q_1Q_2}{u_1+u_2}\right)^2 = \frac{2\sigma}{\sigma+u_1u_2+\tau_3\mu_1\mu_2},
\quad \frac{P_1P_2-Q_1Q_2}{u_1+u_2} = \frac{2\sqrt{\sigma}}{P_1P_2+Q_1Q_2}""",
)

with_P = (
    Scene(
        "one-variable roots",
        constants=("u_1", "u_2", r"\sigma", r"\tau_3"),
        nonzero=(r"\sigma", r"\tau_3", "u_1+u_2"),
    )
    .adjoining(r"\sqrt{\sigma}", r"\sqrt{\tau_3}", one_variable)
    .defining(solved)
)

section.states(Identity, products, on=with_P, says="two roots as products of others")
for k in (1, 2):
    section.states(
        Identity,
        radicals[k],
        on=with_P,
        says="the products have the squares of the radicals",
        ids=(f"one-variable.mu{k}",),
    )
section.states(Identity, quotient, on=with_P, says=r"$\varepsilon E^2$, in two forms")

# With u2 = n/v the formulas keep their form, for both signs ε; what has a hat is regular
# where v = 0. A factor common to n and v changes no state: n may well be constant.

HATS = r"(\\mu_2|A_2|B_2|K_2|\\Pi|\\Lambda|(?<![a-z])[YVTNd])(?![a-z])"


def in_chart(tex: str) -> str:
    """A formula with hats on what belongs to u_2, and without signs."""
    tex = re.sub(HATS, r"\\hat{\1}", tex.replace(r"\varepsilon ", "").replace("u_1-u_2", "vu_1-n"))
    return re.sub(r"\\hat\{(\S+?)_2\}", r"\\hat{\1}_2", tex).replace("E", r"\hat{E}")


hats = section.display(
    "hats",
    r"""
\hat{\mu}_2^2 = \frac{n^2-\sigma v^2}{\tau_3}, \quad
\hat{A}_2^2 = n+(\tau_3+r^2)v, \quad \hat{B}_2^2 = n+(\tau_3-r^2)v, \quad
\hat{K}_2^2 = \frac{n^2-\kappa^2v^2}{2s}, \quad
\hat{E}^2 = \frac{2\sigma}{\sigma v+nu_1+\tau_3\mu_1\hat{\mu}_2}""",
)

hatted_parts = section.display(
    "hatted-parts",
    r"""
\hat{\Pi} = (u_1+\tau_3)(n+\tau_3v)-r^4v, \quad
\hat{Y} = \tau_3(n+v(u_1+2\tau_3-2p^2)+\mu_1\hat{\mu}_2), \quad
\hat{V} = 4s^2v-\mu_1\hat{\mu}_2, \quad \hat{d} = v\mu_1-\hat{\mu}_2, \quad
"""
    + ", \\quad ".join(in_chart(parts[k].tex) for k in (4, 5, 7)),
)

hatted_fields = section.display("hatted-fields", in_chart(fields.tex))
hatted_velocity = section.display("hatted-velocity", in_chart(velocity.tex))

hatted_rates = section.display(
    "hatted-rates",
    r"""
\dot u_1 = -\frac{v\mu_1K_1A_1B_1}{vu_1-n}, \quad
\dot v = \frac{\hat{\mu}_2\hat{K}_2\hat{A}_2\hat{B}_2}{n(vu_1-n)}""",
)

chart = (
    Scene(
        "phase point on O⁴ near infinity",
        vectors=VECTORS,
        variables=("u_1", "v"),
        constants=("s", r"\tau_3", "r", r"\sigma", "n"),
        nonzero=("s", r"\tau_3", "r", r"\sigma", "n", "vu_1-n", "vu_1+n"),
    )
    .adjoining(p_of_sigma, any_c, kappa, radicals[1], radicals[3], radicals[4], radicals[7], hats)
    .defining(hatted_parts, hatted_fields, hatted_velocity)
    .moving(hatted_rates)
    .restricted(no_c)
)

section.states(
    Identity,
    eq4,
    on=chart,
    says="the fields have the lengths $a$ and $b$ and are orthogonal",
    ids=("infinity.a", "infinity.b", "infinity.c"),
)
section.states(
    Identity,
    eq3,
    on=chart,
    says="the fields move by (3) of Kharlamov (2002)",
    ids=("infinity.alpha", "infinity.beta"),
)
section.states(
    Identity,
    eq5,
    on=chart,
    says="the body moves by (5) of Kharlamov (2002)",
    ids=("infinity.omega_1", "infinity.omega_2", "infinity.omega_3"),
)
