r"""2. The third critical subsystem O^4: two invariant relations, two constants, all points."""

from kowalevski_cas.paper.claims import FirstIntegral, Identity, Implication, InvariantRelations
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import eq10, tau, unit
from ..kharlamov_savushkin2004.setting import complex_variables

section = Section("2", "The third critical subsystem", copied=False)

forces = section.display(
    "forces",
    r"A = y_2w_1+x_1w_2+z_1\omega_3, \quad B = x_2w_1+y_1w_2+z_2\omega_3",
)

R = section.display(
    "R",
    r"R_1 = w_2A-w_1B, \quad R_2 = 2w_1w_2\left(\frac{A}{w_1}-\frac{B}{w_2}\right)'",
)

O4 = section.display("O4", r"R_1 = 0, \quad R_2 = 0")

near_O4 = (
    complex_variables.described("near O⁴", "the variables (9) where $w_1$, $w_2$ are not zero")
    .having(nonzero=("w_1", "w_2"))
    .defining(forces, R)
)

section.claim(
    InvariantRelations(
        "O4",
        near_O4,
        None,
        "$R_1=0$, $R_2=0$ defines an invariant set",
        relations=(*O4,),
        names=("R_1", "R_2"),
        main=(("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", r"\omega_3"),),
    )
)

linear = section.states(
    Identity,
    section.lemma(
        "linear",
        r"""
\frac{\partial^2R_1}{\partial y_1^2} = 0, \quad
\frac{\partial}{\partial y_1}\frac{\partial R_1}{\partial y_2} = 0, \quad
\frac{\partial^2R_1}{\partial y_2^2} = 0, \quad
\frac{\partial^2R_2}{\partial y_1^2} = 0, \quad
\frac{\partial}{\partial y_1}\frac{\partial R_2}{\partial y_2} = 0, \quad
\frac{\partial^2R_2}{\partial y_2^2} = 0""",
        "what it means that both are linear in $y_1$, $y_2$",
    ),
    on=near_O4,
    says="they are linear in $y_1$, $y_2$",
)

partial = section.display(
    "partial-integrals",
    r"""
s = -\frac14\left(\frac{A}{w_1}+\frac{B}{w_2}\right), \quad
\tau_3 = \frac12(w_1B+w_2A)+x_1x_2+z_1z_2""",
)

with_constants = near_O4.described(
    "near O⁴, with constants", "the same with $s$ and $\\tau_3$"
).defining(partial)

section.states(
    FirstIntegral,
    partial,
    on=with_constants,
    says="it is constant on $O^4$",
    ids=("s", "tau"),
    given=(*O4,),
)

# O^4 by x1, x2, y1, y2, z1, z2 and s: there the velocity is rational in a square root.

polynomial = section.lemma(
    "polynomial",
    r"""
A = -2sw_1, \quad B = -2sw_2, \quad 2s\omega_3^2 = (y_1+2s)(y_2+2s)-x_1x_2, \quad
2s\omega_3w_1 = x_1z_2-(y_1+2s)z_1, \quad 2s\omega_3w_2 = x_2z_1-(y_2+2s)z_2""",
    "the two relations with the constant $s$, without denominators",
)

section.states(
    Implication,
    polynomial,
    on=with_constants,
    says="it follows from the two relations",
    given=(*O4,),
    main=(("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", r"\omega_3"),),
)

velocity = section.lemma(
    "velocity-on-O4",
    r"""
w_1 = \frac{x_1z_2-(y_1+2s)z_1}{2s\omega_3}, \quad w_2 = \frac{x_2z_1-(y_2+2s)z_2}{2s\omega_3}""",
    "the last two lines above solved for the velocity",
)

on_O4 = (
    Scene(
        "O⁴",
        "$O^4$ by $x_1$, $x_2$, $y_1$, $y_2$, $z_1$, $z_2$ and the constant $s$, where $s$ and "
        "$\\omega_3$ are not zero",
        variables=("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", r"\omega_3"),
        constants=("s",),
        nonzero=("s", r"\omega_3^2"),
        time=r"\tau",
    )
    .moving(*(eq10[k] for k in range(1, 7)))
    .with_unit(unit[1], tau[1])
    .solving(r"\omega_3", polynomial[3])
    .defining(velocity, forces)
)

for k in (7, 8, 9):
    section.states(
        Identity, eq10[k], on=on_O4, says="the velocity on $O^4$ moves by (10)", ids=(f"O4.{k}",)
    )

section.states(
    Identity,
    section.lemma("O4-again", r"A = -2sw_1, \quad B = -2sw_2", "the first two lines above"),
    on=on_O4,
    says="these points obey the relations, with the constant $s$",
)
