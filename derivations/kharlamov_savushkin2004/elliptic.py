r"""6. The separated equations solved in Jacobi's elliptic functions, in every regime."""

from kowalevski_cas.paper.claims import Definition, Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .separation import phi, separated

section = Section("6", "Elliptic functions", copied=False)

roots_of_phi = section.display(
    "roots-of-phi", r"A = \frac{\ell+1}{2m}, \quad C = \frac{\ell-1}{2m}"
)

factors = section.lemma(
    "factors", r"\varphi(s) = 4m(s-A)(s-C)", "what it means that $A$ and $C$ are the roots"
)

first = section.lemma("B-D.1", r"B=a, \quad D=-a", "in the equation for $s_1$ we put")

second = section.lemma("B-D.2", r"B=b, \quad D=-b", "in the equation for $s_2$ we put")

parameters = section.display(
    "parameters",
    r"""
k^2 = \frac{(A-B)(C-D)}{(A-C)(B-D)}, \quad n = \frac12\sqrt{m(A-C)(B-D)}, \quad
\kappa = \frac{A-B}{A-C}""",
)

solution = section.display(
    "solution",
    r"""
s_1 = \frac{B-C\kappa\,{\rm sn}^2(n(t-t_1),k)}{1-\kappa\,{\rm sn}^2(n(t-t_1),k)}, \qquad
s_2 = \frac{D(A-C)+A(C-D)\,{\rm sn}^2(n(t-t_2),k)}{(A-C)+(C-D)\,{\rm sn}^2(n(t-t_2),k)}""",
)

quartic = section.lemma(
    "quartic",
    r"""
\dot s_1^2 = -m(s_1-A)(s_1-B)(s_1-C)(s_1-D), \quad
\dot s_2^2 = -m(s_2-A)(s_2-B)(s_2-C)(s_2-D)""",
    "the separated equations by the roots of their right sides, in any order",
)

by_modulus = section.lemma(
    "by-modulus",
    r"""
A = C+(\kappa-k^2)\lambda, \quad B = C+(1-\kappa)(\kappa-k^2)\lambda, \quad
D = C-k^2(1-\kappa)\lambda""",
    r"$k$ and $\kappa$ solved for the roots, $\lambda$ being any number",
)

any_regime = (
    Scene(
        "any regime",
        constants=("t_1", "t_2", "C", "k", r"\kappa", r"\lambda", "m"),
        nonzero=(r"\lambda", r"\kappa", r"1-\kappa", r"\kappa-k^2"),
    )
    .adjoining(r"\sqrt{m(A-C)(B-D)}")
    .defining(by_modulus, parameters[2], solution)
)

section.states(
    Identity,
    parameters[1],
    on=any_regime,
    says=r"the modulus, the factor of the time, and $\kappa$, by the roots",
    ids=("modulus",),
)
section.states(
    Identity,
    parameters[3],
    on=any_regime,
    says=r"the modulus, the factor of the time, and $\kappa$, by the roots",
    ids=("kappa",),
)

section.states(
    Definition,
    solution,
    on=any_regime,
    says="the solutions in any regime, $s_1$ between $B$ and $A$, $s_2$ between $D$ and $C$",
    equation=quartic,
)
section.states(
    Definition,
    parameters[2],
    on=any_regime,
    says=r"the modulus, the factor of the time, and $\kappa$, by the roots",
    ids=("frequency",),
    equation=quartic[1],
)

one_variable = (
    Scene()
    .adjoining(parameters[1], r"\sqrt{m(A-C)(B-D)}")
    .defining(parameters[2], parameters[3], solution, roots_of_phi, phi)
)

for_s1 = (
    one_variable.called("first variable")
    .having(constants=("t_1", "t_2", "a", "m", r"\ell", "s"), nonzero=("m", "a"))
    .defining(first)
)

for_s2 = (
    one_variable.called("second variable")
    .having(constants=("t_1", "t_2", "b", "m", r"\ell"), nonzero=("m", "b"))
    .defining(second)
)

section.states(
    Definition,
    roots_of_phi,
    on=for_s1,
    says=r"the roots of $\varphi$",
    ids=("A", "C"),
    equation=factors[1],
)
section.states(
    Identity,
    separated[1],
    on=for_s1,
    says="the solutions satisfy the separated equations",
    ids=("elliptic.1",),
)
section.states(
    Identity,
    separated[2],
    on=for_s2,
    says="the solutions satisfy the separated equations",
    ids=("elliptic.2",),
)
