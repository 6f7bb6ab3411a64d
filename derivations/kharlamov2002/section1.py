r"""1. Main equations: the rigid body in two constant fields, and the Kowalevski case."""

from kowalevski_cas.paper.claims import (
    Dimension,
    FirstIntegral,
    Identity,
    Independence,
    InvariantRelations,
    Scaling,
)
from kowalevski_cas.paper.derivation import Scene, Section

section = Section("1", "Main equations")

OMEGA = (r"\omega_1", r"\omega_2", r"\omega_3")
ALPHA = (r"\alpha_1", r"\alpha_2", r"\alpha_3")
BETA = (r"\beta_1", r"\beta_2", r"\beta_3")
FRAME = {
    r"\boldsymbol{\omega}": OMEGA,
    r"\boldsymbol{\alpha}": ALPHA,
    r"\boldsymbol{\beta}": BETA,
}

eq1 = section.display("eq1", r"({\bf e}_1 ,{\bs \alpha}) + ({\bf e}_2 ,{\bs \beta}).")

eq2 = section.display(
    "eq2",
    r"""
{\bf I} \dot {\bs \omega} = {\bf I}{\bs \omega } \times {\bs
\omega} + {\bf e}_1 \times {\bs \alpha} + {\bf e}_2 \times {\bs
\beta},""",
)

eq3 = section.display(
    "eq3",
    r"""
\dot {\bs \alpha}   = {\bs \alpha} \times {\bs \omega}, \quad \dot
{\bs \beta} = {\bs \beta} \times {\bs \omega}""",
)

eq4 = section.display(
    "eq4",
    r"""
({\bs \alpha},{\bs \alpha}) = a^2 , \quad ({\bs \beta},{\bs \beta })
= b^2 , \quad ({\bs \alpha},{\bs \beta}) = c.""",
)

energy = section.display(
    "energy",
    r"""
H = \frac{1}{2} ({\bf I}{\bs \omega},{\bs \omega}) - ({\bf e}_1,
{\bs \alpha}) - ({\bf e}_2, {\bs \beta}).""",
)

inertia = section.display("inertia", r"{\bf I}= \mathop{\rm diag}\nolimits(A_1, A_2,A_3).")

time_unit = section.inline("time-unit", r"\sqrt {A_3 /u_0 }")

unit_inertia = section.inline("A3", r"A_3=1")

kowalevski_case = section.display(
    "kowalevski-case",
    r"""
A_1  = A_2  = 2A_3 , \quad {\bf e}_1  = (1,0,0), \quad {\bf e}_2  =
(0,1,0).""",
)

eq5 = section.display(
    "eq5",
    r"""
2\dot \omega _1 = \omega _2 \omega _3  + \beta _3, \quad 2 \dot
\omega _2 =  - \omega _1 \omega _3  - \alpha _3 , \quad \dot \omega
_3 = \alpha _2  - \beta _1 .""",
)

eq6 = section.display("eq6", r"K = J_1^2  + J_2^2 ,")

J = section.display(
    "J",
    r"""
J_1  = \omega _1^2  - \omega _2^2  + \alpha _1  - \beta _2, \quad
J_2  = 2\omega _1 \omega _2  + \alpha _2  + \beta _1,""",
)

eq7 = section.display("eq7", r"J_1  = 0,\quad J_2  = 0,")

J3 = section.display(
    "J3",
    r"""
J_3  = (\omega _1^2  + \omega _2^2 )\omega _3 + 2(\omega _1 \alpha
_3  + \omega _2 \beta _3 ),""",
)

eq8 = section.display("eq8", r"H = h,\quad J_3  = j")

energy_by_force = section.lemma(
    "energy-by-force",
    r"\frac{1}{2}({\bf I}{\bs\omega},{\bs\omega})-U",
    "the energy by the force function (1)",
)

# -- scenes --------------------------------------------------------------------

any_body = Scene(
    "any body",
    "the Poisson equations (3) with an arbitrary angular velocity",
    vectors=FRAME,
    variables=(*ALPHA, *BETA),
    constants=OMEGA,
    field=(eq3[1], eq3[2]),
)

general = Scene(
    "general body",
    "the equations (2), (3) of a body with any principal moments of inertia and any e1, e2",
    vectors={
        **FRAME,
        r"\mathbf{e}_1": ("e_{11}", "e_{12}", "e_{13}"),
        r"\mathbf{e}_2": ("e_{21}", "e_{22}", "e_{23}"),
    },
    variables=(*OMEGA, *ALPHA, *BETA),
    constants=("A_1", "A_2", "A_3", "e_{11}", "e_{12}", "e_{13}", "e_{21}", "e_{22}", "e_{23}"),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions={r"\mathbf{I}": inertia[1], "U": eq1[1]},
    nonzero=("A_1", "A_2", "A_3"),
)

KOWALEVSKI = {
    r"\mathbf{I}": inertia[1],
    "A_1": kowalevski_case[1],
    "A_2": kowalevski_case[1],
    "A_3": unit_inertia[1],
    r"\mathbf{e}_1": kowalevski_case[2],
    r"\mathbf{e}_2": kowalevski_case[3],
    "H": energy[1],
    "K": eq6[1],
    "J_1": J[1],
    "J_2": J[2],
    "J_3": J3[1],
    "h": eq8[1],
    "j": eq8[2],
}

kowalevski = Scene(
    "Kowalevski case",
    "the equations (2), (3) specialised to the analogue of the Kowalevski case",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions=KOWALEVSKI,
)

any_scale = Scene(
    "unscaled",
    "the equations (2), (3) in the analogue of the Kowalevski case, in any units",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    constants=("A_3", "u_0"),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions={name: printed for name, printed in KOWALEVSKI.items() if name != "A_3"},
    roots={r"\sqrt{A_3/u_0}": None},
    nonzero=("A_3", "u_0"),
)

# -- claims --------------------------------------------------------------------

section.claim(
    FirstIntegral("eq4.1", any_body, eq4[1], "the square of the first field is constant"),
    FirstIntegral("eq4.2", any_body, eq4[2], "the square of the second field is constant"),
    FirstIntegral("eq4.3", any_body, eq4[3], "the scalar product of the fields is constant"),
    FirstIntegral(
        "eq1", general, energy_by_force[1], "with the force function (1) the energy is constant"
    ),
    FirstIntegral("energy", general, energy[1], "the energy integral of any body"),
    Scaling(
        "time-unit",
        any_scale,
        time_unit[1],
        "with this unit of time the equations are those with $A_3=1$",
        simple=kowalevski,
        measures=((OMEGA, -1, "1"), ((*ALPHA, *BETA), 0, "u_0")),
    ),
    Identity("eq5.1", kowalevski, eq5[1], "the first of the Euler equations (2)"),
    Identity("eq5.2", kowalevski, eq5[2], "the second of the Euler equations (2)"),
    Identity("eq5.3", kowalevski, eq5[3], "the third of the Euler equations (2)"),
    FirstIntegral("eq6", kowalevski, eq6[1], "the integral of Kowalevski's type"),
    InvariantRelations(
        "eq7",
        kowalevski,
        None,
        "the zero level of $K$ is invariant",
        relations=(eq7[1], eq7[2]),
        names=("J_1", "J_2"),
    ),
    FirstIntegral(
        "J3",
        kowalevski,
        J3[1],
        "a partial integral: it is constant on (7), and not off it",
        on=(eq7[1], eq7[2]),
        main=((r"\alpha_1", r"\alpha_2"),),
    ),
    Dimension(
        "M4-dimension",
        kowalevski,
        None,
        "with (4), the relations (7) define a four-dimensional manifold",
        levels=(eq4[1], eq4[2], eq4[3]),
        equations=(eq7[1], eq7[2]),
        dimension=4,
    ),
    Independence(
        "M4-independence",
        kowalevski,
        None,
        "$H$ and $J_3$ are independent on it",
        levels=(eq4[1], eq4[2], eq4[3]),
        equations=(eq7[1], eq7[2]),
        functions=(eq8[1], eq8[2]),
    ),
)
