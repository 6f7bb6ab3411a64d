r"""2. The phase point on M^4 by three angles, \kappa_n = e^{i\theta_n}, and how they move.

The numbers u_n = r^2\cos2\theta_n are the roots of the cubic polynomial.
"""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import eq10
from ..kharlamov_savushkin2004.setting import complex_integrals
from .levels import complex_J3, cubic, fields, quartic

section = Section("2", "Three angles", copied=None)

point = section.display(
    "point-M4",
    r"""
w_1 = \rho\kappa_1\kappa_2\kappa_3, \quad w_2 = \frac{\rho}{\kappa_1\kappa_2\kappa_3}, \quad
z_1 = \frac{\rho r^2}{2j}\left(\frac{1}{\kappa_1\kappa_2\kappa_3}
+\frac{\kappa_2\kappa_3}{\kappa_1}+\frac{\kappa_1\kappa_3}{\kappa_2}
+\frac{\kappa_1\kappa_2}{\kappa_3}\right), \quad
z_2 = \frac{\rho r^2}{2j}\left(\kappa_1\kappa_2\kappa_3
+\frac{\kappa_1}{\kappa_2\kappa_3}+\frac{\kappa_2}{\kappa_1\kappa_3}
+\frac{\kappa_3}{\kappa_1\kappa_2}\right), \quad
\omega_3 = \frac{j-w_1z_2-w_2z_1}{w_1w_2}""",
)

roots = section.display(
    "roots-M4",
    r"""
u_1 = \frac{r^2}{2}\left(\kappa_1^2+\frac{1}{\kappa_1^2}\right), \quad
u_2 = \frac{r^2}{2}\left(\kappa_2^2+\frac{1}{\kappa_2^2}\right), \quad
u_3 = \frac{r^2}{2}\left(\kappa_3^2+\frac{1}{\kappa_3^2}\right), \quad
v_1 = \frac{j^2(Y-u_1)}{W}-r^4+u_1^2, \quad
v_2 = \frac{j^2(Y-u_2)}{W}-r^4+u_2^2, \quad
v_3 = \frac{j^2(Y-u_3)}{W}-r^4+u_3^2""",
)

rates = section.display(
    "rates-M4",
    r"""
\kappa_1' = \frac{v_1\kappa_1^3(\kappa_2^2\kappa_3^2+1)}
{2r^2j(\kappa_1^2-\kappa_2^2)(\kappa_1^2-\kappa_3^2)}, \quad
\kappa_2' = \frac{v_2\kappa_2^3(\kappa_1^2\kappa_3^2+1)}
{2r^2j(\kappa_2^2-\kappa_1^2)(\kappa_2^2-\kappa_3^2)}, \quad
\kappa_3' = \frac{v_3\kappa_3^3(\kappa_1^2\kappa_2^2+1)}
{2r^2j(\kappa_3^2-\kappa_1^2)(\kappa_3^2-\kappa_2^2)}, \quad
\rho' = \frac{w_1z_2-w_2z_1}{4\rho}""",
)

KAPPAS = (r"\kappa_1", r"\kappa_2", r"\kappa_3")

by_angles = (
    Scene(
        "M⁴ by angles",
        variables=(*KAPPAS, r"\rho"),
        constants=("j", "r"),
        nonzero=(
            "j", "r", *KAPPAS, r"\rho", r"\kappa_1^2-\kappa_2^2", r"\kappa_1^2-\kappa_3^2",
            r"\kappa_2^2-\kappa_3^2",
        ),
        time=r"\tau",
    )
    .moving(rates)
    .defining(point, fields, cubic[2], cubic[3], roots)
)  # fmt: skip

for k in range(1, 10):
    section.states(
        Identity,
        eq10[k],
        on=by_angles,
        says="the point moves by (10) of Kharlamov (2002)",
        ids=(f"angles.{k}",),
    )

section.states(
    Identity,
    complex_J3[1],
    on=by_angles,
    says="the partial integral at the point",
    ids=("angles.j",),
)

with_integrals = (
    by_angles.called("M⁴ by angles, with integrals")
    .adjoining(complex_integrals[3])
    .defining(complex_integrals[1], quartic[1], cubic[1])
)

section.identity(
    "roots",
    r"F(u_1) = 0, \quad F(u_2) = 0, \quad F(u_3) = 0",
    on=with_integrals,
    says="$u_1$, $u_2$ and $u_3$ are the roots of the cubic polynomial",
)

section.identity(
    "radicals-M4",
    r"v_1^2 = -R(u_1), \quad v_2^2 = -R(u_2), \quad v_3^2 = -R(u_3)",
    on=with_integrals,
    says="the radicals by the polynomial of degree 4",
)

section.identity(
    "quadratures",
    r"""
\frac{\kappa_1'}{\kappa_1v_1}+\frac{\kappa_2'}{\kappa_2v_2}+\frac{\kappa_3'}{\kappa_3v_3} = 0,
\quad
\frac{(\kappa_1^4-1)\kappa_1'}{\kappa_1^3v_1}+\frac{(\kappa_2^4-1)\kappa_2'}{\kappa_2^3v_2}
+\frac{(\kappa_3^4-1)\kappa_3'}{\kappa_3^3v_3} = 0, \quad
\frac{(\kappa_1^4+1)\kappa_1'}{\kappa_1^3v_1}+\frac{(\kappa_2^4+1)\kappa_2'}{\kappa_2^3v_2}
+\frac{(\kappa_3^4+1)\kappa_3'}{\kappa_3^3v_3} = \frac{1}{r^2j}""",
    on=by_angles.having(nonzero=("v_1", "v_2", "v_3")),
    says="the equations of motion, as Abelian integrals",
)
