r"""5. The parts by factors: sums of products in which nothing large cancels.

The sum and the difference of two terms have a product that is one radical squared. So whichever
cancels follows from the other one; and the parts are made of such factors.
"""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov_savushkin2004.separation import any_c
from .infinity import hats, hatted_parts, one_variable
from .phase_point import kappa, p_of_sigma, radicals

section = Section("5", "The parts by factors", copied=False)

factors = section.lemma(
    "factors-O4",
    r"""
S_1 = 2s+\mu_1, \quad D_1 = 2s-\mu_1, \quad
\hat{S}_2 = 2sv+\hat{\mu}_2, \quad \hat{D}_2 = 2sv-\hat{\mu}_2""",
    "sums and differences of which one is small where the other is not",
)

with_factors = (
    Scene(
        "factors on O⁴",
        variables=("u_1", "n", "v"),
        constants=("s", r"\tau_3", "r", r"\sigma"),
        nonzero=("s", r"\tau_3", "r", r"\sigma", "v", "vu_1-n", "vu_1+n"),
    )
    .adjoining(p_of_sigma, any_c, kappa, radicals[1], radicals[3], radicals[4], radicals[7], hats)
    .defining(hatted_parts, factors)
)

factor_products = section.states(
    Identity,
    section.lemma(
        "factor-products",
        r"""
S_1D_1 = \frac{2s}{\tau_3}K_1^2, \quad \hat{S}_2\hat{D}_2 = -\frac{2s}{\tau_3}\hat{K}_2^2""",
        "what the product of a sum and a difference is",
    ),
    on=with_factors,
    says="the product of a sum and of a difference is one radical squared",
)

factored_parts = section.states(
    Identity,
    section.lemma(
        "factored-parts",
        r"""
\hat{V} = \frac12(S_1\hat{D}_2+D_1\hat{S}_2), \quad
\hat{d} = \frac{S_1\hat{D}_2-D_1\hat{S}_2}{4s}, \quad
\hat{\Pi} = \frac12\left(A_1^2\hat{B}_2^2-B_1^2\hat{A}_2^2\right), \quad
\hat{Y} = \frac{\hat{A}_2^2\hat{B}_2^2-v^2A_1^2B_1^2-\tau_3\hat{d}^2}{2v}, \quad
\hat{Y} = \tau_3\left(\frac12v(A_1^2-B_1^2)+\frac12(\hat{A}_2^2+\hat{B}_2^2)-2p^2v
+\mu_1\hat{\mu}_2\right)""",
        "the parts by sums of products",
    ),
    on=with_factors,
    says="the parts of the phase point by factors",
)

# E by roots of one variable: u1, u2 above ±√σ, or, for σ < 0, conjugate complex numbers.

hatted_roots = section.lemma(
    "hatted-roots",
    r"""
\hat{P}_2^2 = n+\sqrt{\sigma}v, \quad \hat{Q}_2^2 = n-\sqrt{\sigma}v, \quad
\mu_1 = \frac{P_1Q_1}{\sqrt{\tau_3}}, \quad
\hat{\mu}_2 = \frac{\hat{P}_2\hat{Q}_2}{\sqrt{\tau_3}}""",
    "the roots of one variable near infinity",
)

by_roots = section.lemma(
    "E-by-roots",
    r"""
E_1 = \frac{2\sqrt{\sigma}}{P_1\hat{P}_2+Q_1\hat{Q}_2}, \quad
E_2 = \frac{P_1\hat{P}_2-Q_1\hat{Q}_2}{vu_1+n}""",
    "two forms of $\\hat{E}$",
)

two_forms = section.lemma(
    "two-forms",
    r"""
E_1^2 = \frac{2\sigma}{\sigma v+nu_1+\tau_3\mu_1\hat{\mu}_2}, \quad E_1 = E_2""",
    "that both are $\\hat{E}$",
)

section.states(
    Identity,
    two_forms,
    on=Scene(
        "one-variable roots near infinity",
        constants=("u_1", "n", "v", r"\sigma", r"\tau_3"),
        nonzero=(r"\sigma", r"\tau_3", "vu_1+n"),
    )
    .adjoining(
        r"\sqrt{\sigma}",
        r"\sqrt{\tau_3}",
        one_variable[1],
        one_variable[3],
        hatted_roots[1],
        hatted_roots[2],
    )
    .defining(hatted_roots[3], hatted_roots[4], by_roots),
    says=r"$\hat{E}$ by roots of one variable, in two forms",
    ids=("roots.E", "roots.forms"),
)

half_arguments = section.lemma(
    "half-arguments",
    r"""
\rho = 2a_1b_1, \quad \sigma = -\rho^2, \quad
u_1 = a_1^2-b_1^2, \quad v = \frac{2a_2b_2}{\rho}, \quad n = a_2^2-b_2^2, \quad
\mu_1 = \frac{a_1^2+b_1^2}{\sqrt{\tau_3}}, \quad
\hat{\mu}_2 = -\frac{a_2^2+b_2^2}{\sqrt{\tau_3}}""",
    "the roots of $u_1+i\\rho$ and of $n+i\\rho v$ for $\\sigma=-\\rho^2$",
)

by_halves = section.lemma(
    "E-by-half-arguments",
    r"E_1 = \frac{\rho}{a_1b_2+a_2b_1}, \quad E_2 = \frac{2(a_1a_2-b_1b_2)}{vu_1+n}",
    "two forms of $\\hat{E}$ for negative $\\sigma$",
)

by_half_arguments = (
    Scene(
        "half arguments on O⁴",
        constants=("a_1", "b_1", "a_2", "b_2", r"\tau_3"),
        nonzero=("a_1", "b_1", r"\tau_3", "vu_1+n", "a_1b_2+a_2b_1"),
    )
    .adjoining(r"\sqrt{\tau_3}")
    .defining(half_arguments, by_halves)
)

for place, square in enumerate((radicals[1], hats[1]), 1):
    section.states(
        Identity,
        square,
        on=by_half_arguments,
        says=r"the radicals for negative $\sigma$, of opposite signs",
        ids=(f"half-arguments.mu{place}",),
    )

section.states(
    Identity,
    two_forms,
    on=by_half_arguments,
    says=r"$\hat{E}$ for negative $\sigma$, in two forms",
    ids=("half-arguments.E", "half-arguments.forms"),
)
