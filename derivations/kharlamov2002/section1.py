r"""1. Main equations: the rigid body in two constant fields, and the Kowalevski case."""

from kowalevski_cas.paper.claims import (
    Dimension,
    FirstIntegral,
    Independence,
    InvariantRelations,
    Scaling,
)
from kowalevski_cas.paper.derivation import Locus, Scene, Section

section = Section("1", "Main equations")

OMEGA = (r"\omega_1", r"\omega_2", r"\omega_3")
ALPHA = (r"\alpha_1", r"\alpha_2", r"\alpha_3")
BETA = (r"\beta_1", r"\beta_2", r"\beta_3")
FRAME = {r"\boldsymbol{\omega}": OMEGA, r"\boldsymbol{\alpha}": ALPHA, r"\boldsymbol{\beta}": BETA}
AXES = {
    r"\mathbf{e}_1": ("e_{11}", "e_{12}", "e_{13}"),
    r"\mathbf{e}_2": ("e_{21}", "e_{22}", "e_{23}"),
}
MOMENTS = ("A_1", "A_2", "A_3")

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

any_body = Scene("any body", vectors=FRAME, variables=(*ALPHA, *BETA), constants=OMEGA).moving(eq3)

eq4 = section.states(
    FirstIntegral,
    section.display(
        "eq4",
        r"""
({\bs \alpha},{\bs \alpha}) = a^2 , \quad ({\bs \beta},{\bs \beta })
= b^2 , \quad ({\bs \alpha},{\bs \beta}) = c.""",
    ),
    on=any_body,
    says="the lengths of the fields and their scalar product are constant",
    sentence=r"can be considered as equations in ${\bf R}^9$ with three geometrical integrals",
)

energy = section.display(
    "energy",
    r"""
H = \frac{1}{2} ({\bf I}{\bs \omega},{\bs \omega}) - ({\bf e}_1,
{\bs \alpha}) - ({\bf e}_2, {\bs \beta}).""",
)

inertia = section.display("inertia", r"{\bf I}= \mathop{\rm diag}\nolimits(A_1, A_2,A_3).")

energy_by_force = section.lemma(
    "energy-by-force",
    r"\frac{1}{2}({\bf I}{\bs\omega},{\bs\omega})-U",
    "the energy by the force function (1)",
)

general = (
    Scene(
        "general body",
        vectors={**FRAME, **AXES},
        variables=(*OMEGA, *ALPHA, *BETA),
        constants=(*MOMENTS, *AXES[r"\mathbf{e}_1"], *AXES[r"\mathbf{e}_2"]),
        nonzero=MOMENTS,
    )
    .moving(eq2, eq3)
    .defining(inertia)
    .naming("U", eq1[1])
)

section.states(
    FirstIntegral,
    energy_by_force,
    on=general,
    says="with the force function (1) the energy is constant",
    ids=("eq1",),
    sentence=r"""
Consider the problem of motion of a rigid body about a fixed point in the potential force field
with a force function of the type""",
)
section.states(
    FirstIntegral,
    energy,
    on=general,
    says="the energy integral of any body",
    sentence=r"Eqs.~(\ref{eq2}),(\ref{eq3}) have the energy integral",
)

time_unit = section.inline("time-unit", r"\sqrt {A_3 /u_0 }")

unit_inertia = section.inline("A3", r"A_3=1")

kowalevski_case = section.display(
    "kowalevski-case",
    r"""
A_1  = A_2  = 2A_3 , \quad {\bf e}_1  = (1,0,0), \quad {\bf e}_2  =
(0,1,0).""",
)

body = Scene(vectors=FRAME, variables=(*OMEGA, *ALPHA, *BETA)).moving(eq2, eq3).defining(inertia)

any_scale = (
    body.called("unscaled")
    .having(constants=("A_3", "u_0"), nonzero=("A_3", "u_0"))
    .defining(kowalevski_case)
    .adjoining(r"\sqrt{A_3/u_0}")
)

equations = body.called("Euler–Poisson equations").defining(kowalevski_case, unit_inertia)

section.states(
    Scaling,
    time_unit,
    on=any_scale,
    says="with this unit of time the equations are those with $A_3=1$",
    simple=equations,
    measures=((OMEGA, -1, "1"), ((*ALPHA, *BETA), 0, "u_0")),
    sentence=r"""
Take $\sqrt{A_3 /u_0 }$ as the time unit ($u_0$ is some common unit of measurement for the
components of ${\bs \alpha}, {\bs \beta}$). Formally it is equivalent to the choice $A_3=1$""",
)

eq5 = section.identity(
    "eq5",
    r"""
2\dot \omega _1 = \omega _2 \omega _3  + \beta _3, \quad 2 \dot
\omega _2 =  - \omega _1 \omega _3  - \alpha _3 , \quad \dot \omega
_3 = \alpha _2  - \beta _1 .""",
    on=equations,
    says="the Euler equations (2) by components",
)

eq6 = section.display("eq6", r"K = J_1^2  + J_2^2 ,")

J = section.display(
    "J",
    r"""
J_1  = \omega _1^2  - \omega _2^2  + \alpha _1  - \beta _2, \quad
J_2  = 2\omega _1 \omega _2  + \alpha _2  + \beta _1,""",
)

eq7 = section.display("eq7", r"J_1  = 0,\quad J_2  = 0,", cites=("eq6",))

J3 = section.display(
    "J3",
    r"""
J_3  = (\omega _1^2  + \omega _2^2 )\omega _3 + 2(\omega _1 \alpha
_3  + \omega _2 \beta _3 ),""",
)

eq8 = section.display("eq8", r"H = h,\quad J_3  = j")

kowalevski = (
    equations.called("Kowalevski case")
    .defining(energy, eq6, J, J3)
    .naming("h", eq8[1])
    .naming("j", eq8[2])
)

M4 = r"""
Thus, the system of invariant relations (\ref{eq7}) defines the four-dimensional manifold $M^4$"""

section.states(
    FirstIntegral,
    eq6,
    on=kowalevski,
    says="the integral of Kowalevski's type",
    sentence=r"""
O.I.\,Bogoyavlensky \cite{bib2} showed that Eqs.~(\ref{eq3}), (\ref{eq5}) have the first integral
of the Kowalevski type""",
)
section.claim(
    InvariantRelations(
        "eq7",
        kowalevski,
        "the zero level of $K$ is invariant; with (4) it is the set $M^4$",
        relations=(*eq7,),
        sentence=M4,
    )
)
section.states(
    FirstIntegral,
    J3,
    on=kowalevski,
    says="a partial integral: it is constant on (7), and not off it",
    given=(*eq7,),
    main=((r"\alpha_1", r"\alpha_2"),),
    sentence="there exists a new partial integral, namely,",
)
# The paper assumes that the vector product of the fields is not zero; this is its square.
NOT_PARALLEL = ("a^2b^2-c^2",)

AS_LARGE = Locus("$a^2=b^2$ and $c=0$", ("a^2-b^2=0", "c=0"), "(a^2-b^2)^2+4c^2")

# On M4 the relations (7) are singular there only at rest in the plane, and then c1 c2 vanishes.
PLANAR = Locus(
    "$a^2=b^2$ and $c=0$",
    (r"\omega_1=0", r"\omega_2=0", r"\alpha_3=0", r"\beta_3=0"),
    AS_LARGE.condition,
)

real_variables = (
    kowalevski.called("initial variables, real").adjoining(eq4[1], eq4[2]).defining(eq4[3])
)

over_M4 = section.lemma(
    "over-M4",
    r"\alpha_1=\beta_2-\omega_1^2+\omega_2^2, \quad \alpha_2=-\beta_1-2\omega_1\omega_2",
    "the relations (7) solved for two variables",
)

section.claim(
    Dimension(
        "M4-dimension",
        real_variables.having(loci=(PLANAR,), nonzero=NOT_PARALLEL),
        "with (4), the relations (7) define a four-dimensional manifold $M^4$",
        levels=(*eq4,),
        equations=(*eq7,),
        dimension=4,
        sentence=M4,
    ),
    Independence(
        "M4-independence",
        kowalevski,
        "$H$ and $J_3$ are independent on $M^4$",
        levels=(*eq4,),
        equations=(*eq7,),
        functions=(*eq8,),
        graph=(*over_M4,),
        sentence="The induced (not reduced) system on it has two first integrals",
    ),
)
