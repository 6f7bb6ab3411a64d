r"""4. The critical points of the three integrals: M^4, N^4, O^4, and the rotations about an axis.

A point is critical if a combination F of H, K, G has no derivative along the common level of the
integrals (4). For fields that are not parallel the directions along the level are those of the
velocity and three more, the turns of the fields about the axes of the body, here in the complex
variables (9). Either G occurs in F, with a coefficient that can be chosen, or it does not.
"""

from kowalevski_cas.paper.claims import DoubleZero, Identity, Implication, Union
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import c
from ..kharlamov_savushkin2004.setting import complex_integrals, complex_variables
from .third_subsystem import forces, polynomial
from .values import complex_G

section = Section("4", "The critical set", copied=False)


def turns(function: str) -> tuple[str, ...]:
    """The derivatives of a function along the turns of the fields about the axes of the body."""
    x1, x2, y1, y2, z1, z2 = (
        rf"\frac{{\partial {function}}}{{\partial {name}}}"
        for name in ("x_1", "x_2", "y_1", "y_2", "z_1", "z_2")
    )
    return (
        rf"z_1{x1}+z_2{y1}-\frac12y_2{z1}-\frac12x_2{z2}",
        rf"z_2{x2}+z_1{y2}-\frac12x_1{z1}-\frac12y_1{z2}",
        rf"x_1{x1}-x_2{x2}+y_1{y1}-y_2{y2}",
    )


def derivatives(function: str) -> str:
    """That a function has no derivative along the levels of the integrals (4)."""
    velocity = (
        rf"\frac{{\partial {function}}}{{\partial {n}}}" for n in ("w_1", "w_2", r"\omega_3")
    )
    return r",\quad ".join(f"{side} = 0" for side in (*velocity, *turns(function)))


everywhere = (
    complex_variables.called("all points")
    .adjoining(complex_integrals[3])
    .defining(c, complex_integrals[1], complex_integrals[2], complex_G)
)

for name, function in (("p", "p^2"), ("c1", "c_1"), ("c2", "c_2")):
    section.states(
        Identity,
        section.lemma(
            f"along-{name}",
            r",\quad ".join(f"{side} = 0" for side in turns(function)),
            "what it means that the turns of the fields are directions along the level of (4)",
        ),
        on=everywhere,
        says=f"${function}$ does not change when the fields turn about an axis",
    )

# -- each of the three is critical; N^4 is in the paper on it ---------------------------------

K_alone = section.inline("K-alone", "k")

zero_level = section.lemma(
    "zero-level", "w_1^2+x_1 = 0, \\quad w_2^2+x_2 = 0", "the equations (7) in the variables (9)"
)

section.states(
    DoubleZero,
    K_alone[1],
    on=everywhere,
    says="this function and its gradient vanish on $M^4$",
    ids=("M4-critical",),
    given=(*zero_level,),
)

surface = section.inline("surface", r"s^4-2hs^3+(h^2+p^2-k)s^2-2gs+\frac14(p^4-c_1c_2)")

section.states(
    DoubleZero,
    surface[1],
    on=everywhere.having(constants=("s",), nonzero=("s", r"\omega_3")).defining(forces),
    says="this function and its gradient vanish on $O^4$, where $s$ has the value at the point",
    ids=("O4-critical",),
    given=(polynomial[3], polynomial[4], polynomial[5]),
    main=(("w_1", "w_2"), (r"\omega_3",)),
)

# -- and there are no other critical points -----------------------------------------------------

with_G = section.lemma(
    "with-G", r"F = 2g-p^2h+\lambda h+\mu k", "a combination in which $G$ occurs"
)

critical = section.lemma("critical", derivatives("F"), "what it means that the point is critical")

sets = section.lemma(
    "sets",
    r"""
N_1 = x_1x_2\omega_3-x_2z_1w_1-x_1z_2w_2, \quad
N_2 = x_2^2c_1(w_1^2+x_1)-x_1^2c_2(w_2^2+x_2), \quad
E_1 = A+2\mu w_1, \quad E_2 = B+2\mu w_2, \quad
E_3 = 2\mu\omega_3^2-(y_1+2\mu)(y_2+2\mu)+x_1x_2, \quad
E_4 = 2\mu\omega_3w_1-x_1z_2+(y_1+2\mu)z_1, \quad E_5 = 2\mu\omega_3w_2-x_2z_1+(y_2+2\mu)z_2, \quad
Z = \lambda(y_2+2\mu)-c_1x_2-2\mu x_1(w_2^2+x_2)""",
    "the equations of $N^4$, of $O^4$ with $s=\\mu$, and a quantity that tells them apart",
)

at_critical = (
    everywhere.called("critical points")
    .having(constants=(r"\lambda", r"\mu"))
    .defining(forces, with_G, sets)
)

consequences = section.states(
    Implication,
    section.lemma(
        "consequences",
        r"""
N_1 = \lambda\omega_3, \quad
\lambda E_1 = w_1Z, \quad \lambda E_2 = w_2Z, \quad
\lambda E_4 = (z_1+w_1\omega_3)Z, \quad \lambda E_5 = (z_2+w_2\omega_3)Z, \quad
\lambda w_1E_3 = \left[w_1(\omega_3^2-y_1-2\mu)+x_1w_2+z_1\omega_3\right]Z, \quad
\lambda w_2E_3 = \left[w_2(\omega_3^2-y_2-2\mu)+x_2w_1+z_2\omega_3\right]Z, \quad
\lambda z_1E_3 = \left[w_1\omega_3(w_1w_2-y_2)-x_1z_2-(y_2+2\mu)z_1\right]Z, \quad
\lambda z_2E_3 = \left[w_2\omega_3(w_1w_2-y_1)-x_2z_1-(y_1+2\mu)z_2\right]Z, \quad
Z(x_2w_1^2-x_1w_2^2) = 0, \quad kZ\omega_3 = 0, \quad kZ(y_1-y_2) = 0, \quad
N_2 = \lambda\left[x_2w_1E_1-x_1w_2E_2-\omega_3(x_2z_1w_1-x_1z_2w_2)+x_1x_2(y_2-y_1)\right]""",
        "combinations of the critical equations",
    ),
    on=at_critical,
    says="consequences at a critical point",
    given=(*critical,),
)

without_G = section.lemma("without-G", r"F_0 = \lambda h+\mu k", "a combination without $G$")

critical_without_G = section.lemma(
    "critical-without-G", derivatives("F_0"), "what it means that the point is critical"
)

consequences_without_G = section.states(
    Implication,
    section.lemma(
        "consequences-without-G",
        r"""
\lambda N_1 = 0, \quad \lambda N_2 = 0, \quad
\lambda w_1 = -2\mu w_2(w_1^2+x_1), \quad \lambda w_2 = -2\mu w_1(w_2^2+x_2), \quad
\lambda z_1 = 2\mu z_2(w_1^2+x_1), \quad \lambda z_2 = 2\mu z_1(w_2^2+x_2)""",
        "combinations of the critical equations",
    ),
    on=at_critical.defining(without_G),
    says="consequences at a critical point",
    given=(*critical_without_G,),
)

M4 = section.lemma("set-M4", "k = 0", "the set $M^4$")
N4 = section.lemma("set-N4", r"N_1 = 0, \quad N_2 = 0", "the set $N^4$")
O4 = section.lemma(
    "set-O4",
    r"E_1 = 0, \quad E_2 = 0, \quad E_3 = 0, \quad E_4 = 0, \quad E_5 = 0",
    "the set $O^4$",
)
axis = section.lemma(
    "set-axis",
    r"w_1 = 0, \quad w_2 = 0, \quad z_1 = 0, \quad z_2 = 0",
    "rotations about the third axis, which stays orthogonal to the fields",
)

none = section.lemma("no-multiplier", r"\lambda = 0, \quad \mu = 0", "no combination at all")

by_consequences = Scene(
    "critical points, by consequences",
    variables=(
        *("k", "N_1", "N_2", "E_1", "E_2", "E_3", "E_4", "E_5", "Z"),
        *("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", "w_1", "w_2", r"\omega_3"),
    ),
    constants=(r"\lambda", r"\mu"),
)

section.claim(
    Union(
        "critical-points",
        by_consequences,
        "a critical point of a combination with $G$ is on $M^4$, $N^4$, $O^4$, or rotates "
        "about the third axis",
        sets=((*M4,), (*N4,), (*O4,), (*axis,)),
        given=(*consequences,),
    ),
    Union(
        "critical-points-without-G",
        by_consequences,
        "a critical point of a combination without $G$ is on $M^4$, $N^4$, or rotates about the "
        "third axis",
        sets=((*M4,), (*N4,), (*axis,), (*none,)),
        given=(*consequences_without_G, complex_integrals[2]),
    ),
)

section.states(
    Implication,
    section.lemma(
        "rotations",
        r"E_3 = -(4\mu^2-4h\mu+y_1y_2-x_1x_2)",
        "which rotations are on $O^4$ as well: those with $h^2 \\ge y_1y_2-x_1x_2$",
    ),
    on=at_critical,
    says="the equation for $s=\\mu$ at a rotation about the third axis",
    given=(*axis,),
)
