r"""2. The third integral G, and what it says about N^4."""

from kowalevski_cas.paper.claims import DoubleZero, FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .setting import (
    ALPHA,
    BETA,
    COMPLEX,
    FIELD,
    FRAME,
    GAMMA,
    INTEGRALS,
    LENGTHS,
    N4,
    OMEGA,
    PAIRS,
    F,
    X,
    change,
    eq4,
    p,
    root_of_c,
    unit,
)

section = Section("2", "The third integral")

G = section.display(
    "G",
    r"""
G = (\omega_1\alpha_1+\omega_2\alpha_2+\tfrac12\omega_3\alpha_3)^2
+(\omega_1\beta_1+\omega_2\beta_2+\tfrac12\omega_3\beta_3)^2
+\omega_3(\omega_1\gamma_1+\omega_2\gamma_2+\tfrac12\omega_3\gamma_3)
-b^2\alpha_1-a^2\beta_2+c(\alpha_2+\beta_1), \quad
{\bs \gamma}={\bs \alpha}\times{\bs \beta}""",
)

bracket = section.display(
    "bracket",
    r"""
\{M_i,M_j\} = -\varepsilon_{ijk}M_k, \quad \{M_i,\alpha_j\} = -\varepsilon_{ijk}\alpha_k, \quad
\{M_i,\beta_j\} = -\varepsilon_{ijk}\beta_k, \quad {\bf M} = (2\omega_1,2\omega_2,\omega_3)""",
)

hamilton = section.lemma(
    "hamilton",
    r"""
\dot{\bf M} = \{{\bf M},H\}, \quad \dot{\bs \alpha} = \{{\bs \alpha},H\}, \quad
\dot{\bs \beta} = \{{\bs \beta},H\}""",
    "the equations (3), (5) in Hamilton's form",
)

involution = section.lemma(
    "involution",
    r"\{H,K\} = 0, \quad \{H,G\} = 0, \quad \{K,G\} = 0",
    "what it means that the integrals are in involution",
)

by_F = section.display(
    "G-by-F",
    r"2G - p^2H = \frac12(U_1+U_2) - \frac12F_1^2, \quad c_1c_2K = U_1U_2",
)

combined = section.inline("combined", r"(2G-p^2H)^2 - r^4K")

solved = section.lemma(
    "solved",
    r"""
G = \frac12p^2H + \frac14(U_1+U_2) - \frac14F_1^2, \quad K = \frac{U_1U_2}{c_1c_2}""",
    "the display above, solved for $G$ and $K$",
)

level = section.lemma("level", r"H = h", "the value of the energy")

constants = section.display(
    "constants",
    r"""
m = \frac{1}{c_2}\frac{x_2}{x_1}(w_1^2+x_1), \qquad
\ell = \frac{1}{\sqrt{x_1x_2}}\left[w_1w_2+(x_1x_2+z_1z_2)m\right]""",
)

# -- scenes --------------------------------------------------------------------

THIRD = {"G": G[1], "g": G[1], "c": eq4[3], r"\boldsymbol{\gamma}": G[2]}
VECTORS = {**FRAME, r"\boldsymbol{\gamma}": GAMMA}

real = Scene(
    "real variables",
    "the equations (3), (5), where $a$, $b$, $c$ abbreviate the integrals (4)",
    vectors=VECTORS,
    variables=(*OMEGA, *ALPHA, *BETA),
    field=FIELD,
    definitions={**INTEGRALS, **THIRD},
    roots=LENGTHS,
)

hamiltonian = Scene(
    "Poisson bracket",
    "the real variables with the bracket of their functions",
    vectors={**VECTORS, r"\mathbf{M}": ("M_1", "M_2", "M_3")},
    variables=(*OMEGA, *ALPHA, *BETA),
    field=FIELD,
    definitions={
        **real.definitions,
        r"\mathbf{M}": bracket[4],
        r"\{M_i,M_j\}": bracket[1],
        r"\{M_i,\alpha_j\}": bracket[2],
        r"\{M_i,\beta_j\}": bracket[3],
    },
    roots=LENGTHS,
)

everything = Scene(
    "complex variables, all constants",
    "the variables (9), where all constants abbreviate functions of them",
    vectors=VECTORS,
    variables=(*X, r"\omega_3"),
    field=change,
    time=r"\tau",
    unit=unit[1],
    conjugates=PAIRS,
    roots={
        **LENGTHS,
        "p": p[1],
        r"\sqrt{x_1x_2}": None,
        r"\sqrt{c_1c_2}": None,
        "r": root_of_c[1],
    },
    nonzero=("x_1", "x_2"),
    definitions={**INTEGRALS, **THIRD, **COMPLEX, "m": constants[1]},
)

by_functions = Scene(
    "near N⁴",
    "$G$ and $K$ through $F_1$, $U_1$, $U_2$ and the other integrals",
    variables=("F_1", "U_1", "U_2", "H"),
    constants=("p", "c_1", "c_2"),
    roots={r"\sqrt{c_1c_2}": None, "r": root_of_c[1]},
    nonzero=("c_1", "c_2"),
    definitions={"G": solved[1], "K": solved[2], "F_2": F[2]},
)

# -- claims --------------------------------------------------------------------

section.claim(
    FirstIntegral("G", real, G[1], "the third integral"),
    *(
        Identity(f"hamilton.{k}", hamiltonian, hamilton[k], "the bracket with $H$ is the motion")
        for k in (1, 2, 3)
    ),
    *(
        Identity(f"involution.{k}", hamiltonian, involution[k], "two integrals in involution")
        for k in (1, 2, 3)
    ),
    Identity("G-by-F", everything, by_F[1], "what $G$ is on $N^4$, and near it"),
    Identity("K-by-U", everything, by_F[2], "$K$ through $U_1$ and $U_2$"),
    DoubleZero(
        "combined",
        by_functions,
        combined[1],
        "it vanishes with its gradient on $N^4$",
        given=(N4[1], N4[2]),
    ),
)
