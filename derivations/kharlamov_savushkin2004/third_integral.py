r"""2. The third integral G, and what it says about N^4."""

from kowalevski_cas.claims import DoubleZero, FirstIntegral, Identity
from kowalevski_cas.derivation import Scene, Section

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

gamma = section.lemma(
    "gamma-components",
    r"""
\gamma_1=\alpha_2\beta_3-\alpha_3\beta_2, \quad
\gamma_2=\alpha_3\beta_1-\alpha_1\beta_3, \quad
\gamma_3=\alpha_1\beta_2-\alpha_2\beta_1""",
    "the components of the vector product",
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

THIRD = {
    "G": G[1],
    "g": G[1],
    "c": eq4[3],
    **dict(zip(GAMMA, (gamma[1], gamma[2], gamma[3]), strict=True)),
}

real = Scene(
    "real variables",
    "the equations (3), (5), where $a$, $b$, $c$ abbreviate the integrals (4)",
    vectors={**FRAME, r"\boldsymbol{\gamma}": GAMMA},
    variables=(*OMEGA, *ALPHA, *BETA),
    field=FIELD,
    definitions={**INTEGRALS, **THIRD},
    roots=LENGTHS,
)

everything = Scene(
    "complex variables, all constants",
    "the variables (9), where all constants abbreviate functions of them",
    vectors=FRAME,
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
    definitions={**INTEGRALS, **THIRD, **COMPLEX, "m": constants[1]},
)

by_functions = Scene(
    "near N⁴",
    "$G$ and $K$ through $F_1$, $U_1$, $U_2$ and the other integrals",
    variables=("F_1", "U_1", "U_2", "H"),
    constants=("p", "c_1", "c_2"),
    roots={r"\sqrt{c_1c_2}": None, "r": root_of_c[1]},
    definitions={"G": solved[1], "K": solved[2], "F_2": F[2]},
)

# -- claims --------------------------------------------------------------------

section.claim(
    Identity("gamma", real, G[2], r"the components of $\gamma$ that $G$ uses"),
    FirstIntegral("G", real, G[1], "the third integral"),
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
