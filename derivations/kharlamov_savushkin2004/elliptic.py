r"""6. The separated equations solved in Jacobi's elliptic functions, in every regime."""

from kowalevski_cas.paper.claims import Definition, Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .separation import phi, separated

section = Section("6", "Elliptic functions")

SN, CN, DN = r"\mathrm{sn}", r"\mathrm{cn}", r"\mathrm{dn}"

roots_of_phi = section.display(
    "roots-of-phi",
    r"A = \frac{\ell+1}{2m}, \quad C = \frac{\ell-1}{2m}",
)

factors = section.lemma(
    "factors", r"\varphi(s) = 4m(s-A)(s-C)", "what it means that $A$ and $C$ are the roots"
)

first = section.inline("B-D.1", r"B=a, \quad D=-a")

second = section.inline("B-D.2", r"B=b, \quad D=-b")

parameters = section.display(
    "parameters",
    r"""
k^2 = \frac{(A-B)(C-D)}{(A-C)(B-D)}, \quad n = \frac12\sqrt{m(A-C)(B-D)}, \quad
\kappa = \frac{A-B}{A-C}""",
)

solution = section.display(
    "solution",
    r"""
s_1 = \frac{B-C\kappa\,{\rm sn}^2}{1-\kappa\,{\rm sn}^2}, \qquad
s_2 = \frac{D(A-C)+A(C-D)\,{\rm sn}^2}{(A-C)+(C-D)\,{\rm sn}^2}""",
)

jacobi = section.lemma(
    "jacobi",
    r"""
{\rm cn}^2 = 1-{\rm sn}^2, \quad {\rm dn}^2 = 1-k^2\,{\rm sn}^2, \quad
\dot{\rm sn} = n\,{\rm cn}\,{\rm dn}""",
    "Jacobi's elliptic functions of $n(t-t_j)$ with the modulus $k$",
)

jacobi_rates = section.lemma(
    "jacobi-rates",
    r"\dot{\rm cn} = -n\,{\rm sn}\,{\rm dn}, \quad \dot{\rm dn} = -nk^2\,{\rm sn}\,{\rm cn}",
    "the derivatives of the other two",
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

# -- scenes --------------------------------------------------------------------

FUNCTIONS = {CN: jacobi[1], DN: jacobi[2]}
SOLUTION = {"n": parameters[2], "s_1": solution[1], "s_2": solution[2]}

any_regime = Scene(
    "any regime",
    "Jacobi's functions with any four roots $A$, $B$, $C$, $D$, by $k$, $\\kappa$ and $\\lambda$",
    variables=(SN,),
    constants=("C", "k", r"\kappa", r"\lambda", "m"),
    field=(jacobi[3],),
    roots={r"\sqrt{m(A-C)(B-D)}": None, **FUNCTIONS},
    nonzero=(r"\lambda", r"\kappa", r"1-\kappa", r"\kappa-k^2"),
    definitions={"A": by_modulus[1], "B": by_modulus[2], "D": by_modulus[3], **SOLUTION},
)

for_s1 = Scene(
    "first variable",
    "Jacobi's functions with the roots of the equation for $s_1$",
    variables=(SN,),
    constants=("a", "m", r"\ell", "s"),
    field=(jacobi[3],),
    roots={"k": parameters[1], r"\sqrt{m(A-C)(B-D)}": None, **FUNCTIONS},
    nonzero=("m", "a"),
    definitions={
        **SOLUTION,
        r"\kappa": parameters[3],
        "A": roots_of_phi[1],
        "B": first[1],
        "C": roots_of_phi[2],
        "D": first[2],
        r"\varphi(s)": phi[1],
    },
)

for_s2 = Scene(
    "second variable",
    "Jacobi's functions with the roots of the equation for $s_2$",
    variables=(SN,),
    constants=("b", "m", r"\ell"),
    field=(jacobi[3],),
    roots=for_s1.roots,
    nonzero=("m", "b"),
    definitions={**for_s1.definitions, "B": second[1], "D": second[2]},
)

# -- claims --------------------------------------------------------------------

BETWEEN = (
    "the solution between $B$ and $A$, in any regime",
    "the solution between $D$ and $C$, in any regime",
)

section.claim(
    Identity("modulus", any_regime, parameters[1], "the modulus by the roots"),
    Identity("kappa", any_regime, parameters[3], r"$\kappa$ by the roots"),
    Identity("cn", any_regime, jacobi_rates[1], r"the derivative of $\mathrm{cn}$"),
    Identity("dn", any_regime, jacobi_rates[2], r"the derivative of $\mathrm{dn}$"),
    *(
        Definition(
            f"solution.{k}",
            any_regime,
            solution[k],
            words,
            equation=quartic[k],
        )
        for k, words in enumerate(BETWEEN, 1)
    ),
    Definition(
        "frequency", any_regime, parameters[2], "what multiplies the time", equation=quartic[1]
    ),
    Definition("A", for_s1, roots_of_phi[1], r"one root of $\varphi$", equation=factors[1]),
    Definition("C", for_s1, roots_of_phi[2], r"the other root of $\varphi$", equation=factors[1]),
    Identity("elliptic.1", for_s1, separated[1], "the solution of the first separated equation"),
    Identity("elliptic.2", for_s2, separated[2], "the solution of the second separated equation"),
)
