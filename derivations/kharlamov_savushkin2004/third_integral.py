r"""2. The third integral G, and what it says about N^4."""

from kowalevski_cas.paper.claims import DoubleZero, FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section1 import FRAME, eq4
from ..kharlamov2002.section2 import F1, F2, c, eq13, eq15, eq17, unit
from .setting import body, complex_variables, p, root_of_c

section = Section("2", "The third integral", copied=False)

G = section.display(
    "G",
    r"""
G = (\omega_1\alpha_1+\omega_2\alpha_2+\tfrac12\omega_3\alpha_3)^2
+(\omega_1\beta_1+\omega_2\beta_2+\tfrac12\omega_3\beta_3)^2
+\omega_3(\omega_1\gamma_1+\omega_2\gamma_2+\tfrac12\omega_3\gamma_3)
-b^2\alpha_1-a^2\beta_2+c(\alpha_2+\beta_1), \quad
{\bs \gamma}={\bs \alpha}\times{\bs \beta}""",
)

VECTORS = {**FRAME, r"\boldsymbol{\gamma}": (r"\gamma_1", r"\gamma_2", r"\gamma_3")}

real = (
    body.called("real variables")
    .having(vectors=VECTORS)
    .adjoining(eq4[1], eq4[2])
    .defining(eq4[3], G)
    .naming("g", G[1])
)

section.states(FirstIntegral, G[1], on=real, says="$G$ is a first integral", ids=("G",))

bracket = section.display(
    "bracket",
    r"""
\{M_i,M_j\} = -\varepsilon_{ijk}M_k, \quad \{M_i,\alpha_j\} = -\varepsilon_{ijk}\alpha_k, \quad
\{M_i,\beta_j\} = -\varepsilon_{ijk}\beta_k, \quad {\bf M} = (2\omega_1,2\omega_2,\omega_3)""",
)

hamiltonian = (
    real.called("Poisson bracket")
    .having(vectors={r"\mathbf{M}": ("M_1", "M_2", "M_3")})
    .defining(bracket)
)

hamilton = section.states(
    Identity,
    section.lemma(
        "hamilton",
        r"""
\dot{\bf M} = \{{\bf M},H\}, \quad \dot{\bs \alpha} = \{{\bs \alpha},H\}, \quad
\dot{\bs \beta} = \{{\bs \beta},H\}""",
        "the equations (3), (5) in Hamilton's form",
    ),
    on=hamiltonian,
    says="the equations of motion in Hamilton's form",
)

involution = section.states(
    Identity,
    section.lemma(
        "involution",
        r"\{H,K\} = 0, \quad \{H,G\} = 0, \quad \{K,G\} = 0",
        "what it means that the integrals are in involution",
    ),
    on=hamiltonian,
    says="the integrals are in involution",
)

constants = section.display(
    "constants",
    r"""
m = \frac{1}{c_2}\frac{x_2}{x_1}(w_1^2+x_1), \qquad
\ell = \frac{1}{\sqrt{x_1x_2}}\left[w_1w_2+(x_1x_2+z_1z_2)m\right]""",
)

everything = (
    complex_variables.called("complex variables, all constants")
    .having(vectors=VECTORS, nonzero=("x_1", "x_2"))
    .with_unit(unit[1])
    .adjoining(eq4[1], eq4[2], p, r"\sqrt{x_1x_2}", r"\sqrt{c_1c_2}", root_of_c)
    .defining(eq4[3], c, eq13[1], eq13[2], F1, F2, eq17, G, constants[1])
    .naming("g", G[1])
)

by_F = section.identity(
    "G-by-F",
    r"2G - p^2H = \frac12(U_1+U_2) - \frac12F_1^2, \quad c_1c_2K = U_1U_2",
    on=everything,
    says="$G$ and $K$ by $F_1$, $U_1$ and $U_2$",
    ids=("G-by-F", "K-by-U"),
)

solved = section.lemma(
    "solved",
    r"""
G = \frac12p^2H + \frac14(U_1+U_2) - \frac14F_1^2, \quad K = \frac{U_1U_2}{c_1c_2}""",
    "the display above, solved for $G$ and $K$",
)

by_functions = (
    Scene(
        "near N⁴",
        variables=("F_1", "U_1", "U_2", "H"),
        constants=("p", "c_1", "c_2"),
        nonzero=("c_1", "c_2"),
    )
    .adjoining(r"\sqrt{c_1c_2}", root_of_c)
    .defining(solved, F2)
)

combined = section.states(
    DoubleZero,
    section.inline("combined", r"(2G-p^2H)^2 - r^4K"),
    on=by_functions,
    says="this function and its gradient vanish on $N^4$",
    given=(*eq15,),
)

level = section.lemma("level", r"H = h", "the value of the energy")
