r"""2. The third critical subsystem O^4: two invariant relations, two constants, all points."""

from kowalevski_cas.paper.claims import FirstIntegral, Identity, Implication, InvariantRelations
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import eq10, tau, unit
from ..kharlamov_savushkin2004.setting import complex_variables

section = Section("2", "The third critical subsystem", copied=False)

forces = section.display(
    "forces", r"A = y_2w_1+x_1w_2+z_1\omega_3, \quad B = x_2w_1+y_1w_2+z_2\omega_3"
)

R = section.display(
    "R", r"R_1 = w_2A-w_1B, \quad R_2 = 2w_1w_2\left(\frac{A}{w_1}-\frac{B}{w_2}\right)'"
)

written_out = section.lemma(
    "R2-written-out",
    r"""
R_2 = (w_1z_2+w_2z_1)\omega_3^2
+\left[w_1^2x_2+w_2^2x_1+w_1w_2(y_1+y_2)+\frac{w_2z_1^2}{w_1}+\frac{w_1z_2^2}{w_2}\right]\omega_3
+\frac{w_2^2x_1z_1}{w_1}+\frac{w_1^2x_2z_2}{w_2}+w_1x_2z_1+w_2x_1z_2+(y_1-y_2)(w_1z_2-w_2z_1)""",
    "the second relation without a derivative",
)

O4 = section.display("O4", r"R_1 = 0, \quad R_2 = 0")

near_O4 = (
    complex_variables.called("near O⁴")
    .having(nonzero=("w_1", "w_2"))
    .defining(forces, R[1], written_out)
)

FIELDS = ("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", r"\omega_3")

section.states(Identity, R[2], on=near_O4, says="the second relation is a derivative", ids=("R2",))

section.claim(
    InvariantRelations(
        "O4",
        near_O4,
        "the equations $R_1=0$, $R_2=0$ define an invariant set",
        relations=(*O4,),
        main=(FIELDS,),
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
    says="the relations are linear in $y_1$, $y_2$",
)

partial = section.display(
    "partial-integrals",
    r"""
s = -\frac14\left(\frac{A}{w_1}+\frac{B}{w_2}\right), \quad
\tau_3 = \frac12(w_1B+w_2A)+x_1x_2+z_1z_2""",
)

with_constants = near_O4.called("near O⁴, with constants").defining(partial)

section.states(
    FirstIntegral,
    partial,
    on=with_constants,
    says=r"$s$ and $\tau_3$ are constant on $O^4$",
    ids=("s", "tau"),
    given=(*O4,),
    main=(FIELDS,),
)

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
    says="consequences of the two relations",
    given=(*O4,),
    main=(("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", r"\omega_3"),),
)

# O^4 by the velocity, z1, z2, a real number and s: there all is rational.

fields = section.lemma(
    "fields-on-O4",
    r"""
x_1 = \frac{i\eta-\frac12\omega_3(z_1z_2-2sw_1w_2)}{w_2z_2}, \quad
x_2 = -\frac{i\eta+\frac12\omega_3(z_1z_2-2sw_1w_2)}{w_1z_1}, \quad
y_1 = \frac{i\eta-\frac12\omega_3(z_1z_2+2sw_1w_2)}{w_2z_1}-2s, \quad
y_2 = -\frac{i\eta+\frac12\omega_3(z_1z_2+2sw_1w_2)}{w_1z_2}-2s""",
    "the lines above solved for the fields, with a real number $\\eta$",
)

solved_eta = section.lemma(
    "eta",
    r"i\eta = w_2z_1(y_1+2s)+\frac12\omega_3(z_1z_2+2sw_1w_2)",
    "the third of these formulas solved for $\\eta$",
)

eta_motion = section.lemma(
    "eta-motion",
    r"""
i\eta' = \frac12\left[(w_2\omega_3+z_2)z_1+(x_1w_2-y_2w_1)w_2\right](y_1+2s)
+w_2z_1(z_2w_1-y_1\omega_3)+\frac14(y_2-y_1)(z_1z_2+2sw_1w_2)
+\frac14\omega_3\left[(x_1w_2-y_2w_1)z_2+(y_1w_2-x_2w_1)z_1+2s(w_1z_2-w_2z_1)\right]""",
    "the derivative of the line above by (10)",
)

on_O4 = (
    Scene(
        "O⁴",
        variables=("w_1", "w_2", "z_1", "z_2", r"\omega_3", r"\eta"),
        constants=("s",),
        nonzero=("w_1", "w_2", "z_1", "z_2"),
        conjugates=(("w_1", "w_2"), ("z_1", "z_2")),
        time=r"\tau",
    )
    .moving(*(eq10[k] for k in range(5, 10)), eta_motion)
    .with_unit(unit[1], tau[1])
    .defining(fields, forces)
)

for k in range(1, 5):
    section.states(
        Identity,
        eq10[k],
        on=on_O4,
        says="the fields on $O^4$ move by (10) of Kharlamov (2002)",
        ids=(f"O4.{k}",),
    )

section.states(
    Identity,
    polynomial,
    on=on_O4,
    says="these points satisfy the two relations, with the constant $s$",
    ids=[f"O4.point.{k}" for k in range(1, 6)],
)
