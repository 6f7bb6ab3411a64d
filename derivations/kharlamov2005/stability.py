r"""5. The type of the critical points on O^4.

On O^4 the number s is a double root of a polynomial Q whose coefficients are the integrals. Near
O^4, with s the function that is constant on it, :math:`2QQ''-(Q')^2` vanishes to the second order,
and but for terms of the third it is an integral: that of the lowest value of Q, times 2Q''. Along
the two directions in which O^4 is left it is a quadratic form. The tori are elliptic if it is
definite, and hyperbolic if it is not: in the real coordinates of y_1 and its conjugate y_2 its
determinant has the sign opposite to that in y_1, y_2, and the Jacobian of R_1, R_2, of which the
first is imaginary and the second real, is real. So they are hyperbolic where
:math:`s\tau_3Q''(s)>0`, and elliptic where it is negative.
"""

from kowalevski_cas.paper.claims import Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import c, unit
from ..kharlamov_savushkin2004.setting import complex_integrals
from .third_subsystem import O4, R, forces, partial, with_constants, written_out
from .values import complex_G, constants

section = Section("5", "The type of the critical points on $O^4$", copied=False)

polynomial = section.lemma(
    "Q",
    r"""
Q = s^4-2hs^3+(h^2+p^2-k)s^2-2gs+\frac14(p^4-c_1c_2), \quad
Q_1 = 4s^3-6hs^2+2(h^2+p^2-k)s-2g, \quad
Q_2 = 12s^2-12hs+2(h^2+p^2-k)""",
    "the polynomial of which $s$ is a double root, and its derivatives",
)

near = (
    with_constants.called("across O⁴")
    .adjoining(complex_integrals[3])
    .defining(c, complex_integrals[1], complex_integrals[2], complex_G, polynomial)
)

section.states(
    Implication,
    section.lemma("on-the-surface", "Q = 0, \\quad Q_1 = 0", "what holds on $O^4$"),
    on=near,
    says="$s$ is a double root of $Q$",
    given=(*O4,),
)

by_constants = section.states(
    Identity,
    section.lemma(
        "type-by-constants",
        r"12s^2-12hs+2(h^2+p^2-k) = 2(\tau_3-p^2+s^2)+\frac{p^4-r^4}{2s^2}",
        "the value of $Q_2$ on $O^4$",
    ),
    on=constants,
    says="the second derivative of $Q$ at the double root, by the constants",
)

beside = section.lemma(
    "beside-O4",
    r"""
x_1 = \frac{i\eta-\frac12\omega_3(z_1z_2-2\mu w_1w_2)}{w_2z_2}, \quad
x_2 = -\frac{i\eta+\frac12\omega_3(z_1z_2-2\mu w_1w_2)}{w_1z_1}, \quad
y_1 = \frac{i\eta-\frac12\omega_3(z_1z_2+2\mu w_1w_2)}{w_2z_1}-2\mu+e_1, \quad
y_2 = -\frac{i\eta+\frac12\omega_3(z_1z_2+2\mu w_1w_2)}{w_1z_2}-2\mu+e_2""",
    "the fields on $O^4$ with $s=\\mu$, and beside it",
)

across = (
    Scene(
        "beside O⁴",
        variables=("w_1", "w_2", "z_1", "z_2", r"\omega_3", r"\eta", "e_1", "e_2"),
        constants=(r"\mu",),
        nonzero=("w_1", "w_2", "z_1", "z_2"),
        conjugates=(("w_1", "w_2"), ("z_1", "z_2"), ("e_1", "e_2")),
    )
    .with_unit(unit[1])
    .defining(beside, forces, R[1], written_out, partial)
    .adjoining(complex_integrals[3])
    .defining(c, complex_integrals[1], complex_integrals[2], complex_G, polynomial)
)

section.states(
    Implication,
    section.lemma(
        "type",
        r"""
16w_1^2w_2^2\left[\left(Q_2\frac{\partial^2Q}{\partial e_1^2}
-\left(\frac{\partial Q_1}{\partial e_1}\right)^2\right)
\left(Q_2\frac{\partial^2Q}{\partial e_2^2}
-\left(\frac{\partial Q_1}{\partial e_2}\right)^2\right)
-\left(Q_2\frac{\partial}{\partial e_1}\frac{\partial Q}{\partial e_2}
-\frac{\partial Q_1}{\partial e_1}\frac{\partial Q_1}{\partial e_2}\right)^2\right]
= s\tau_3Q_2\left(\frac{\partial R_1}{\partial e_1}\frac{\partial R_2}{\partial e_2}
-\frac{\partial R_1}{\partial e_2}\frac{\partial R_2}{\partial e_1}\right)^2""",
        "the determinant of a quadratic form that is an integral of the variation",
    ),
    on=across,
    says=r"the determinant of the quadratic form has the sign of $s\tau_3Q''$",
    given=(*section.lemma("on-O4-itself", "e_1 = 0, \\quad e_2 = 0", "the set $O^4$"),),
)
