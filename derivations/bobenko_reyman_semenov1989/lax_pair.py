r"""1. The Lax pair with a spectral parameter, and what its characteristic polynomial conserves."""

from kowalevski_cas.paper.claims import Definition, Identity
from kowalevski_cas.paper.derivation import Section

from ..kharlamov2002.section1 import eq4
from ..kharlamov2002.section2 import c, eq17, unit
from ..kharlamov_savushkin2004.setting import complex_variables, p
from ..kharlamov_savushkin2004.third_integral import VECTORS, G

section = Section("1", "The Lax pair", copied=False)

pair = section.display(
    "pair",
    r"""
{\bf L} = \begin{pmatrix}
0 & x_2/\kappa & -2w_2 & z_2/\kappa\\
-x_1/\kappa & 0 & -z_1/\kappa & 2w_1\\
-2w_1 & z_2/\kappa & -2\omega_3 & -y_1/\kappa-4\kappa\\
-z_1/\kappa & 2w_2 & y_2/\kappa+4\kappa & 2\omega_3
\end{pmatrix}, \quad
{\bf M} = \begin{pmatrix}
-\omega_3/2 & 0 & w_2/2 & 0\\
0 & \omega_3/2 & 0 & -w_1/2\\
w_1/2 & 0 & \omega_3/2 & \kappa\\
0 & -w_2/2 & -\kappa & -\omega_3/2
\end{pmatrix}""",
)

spectral = (
    complex_variables.called("spectral parameter")
    .having(vectors=VECTORS, constants=(r"\kappa", r"\mu"), nonzero=(r"\kappa",))
    .with_unit(unit[1])
    .adjoining(eq4[1], eq4[2], p)
    .defining(eq4[3], c, eq17, G, pair)
)

lax = section.display("lax", r"{\bf L}' = {\bf L}{\bf M}-{\bf M}{\bf L}")

for k, letter in enumerate("LM", 1):
    section.states(
        Definition,
        pair[k],
        on=spectral,
        says="the matrices of the Lax pair",
        ids=(letter,),
        equation=lax[1],
    )

section.states(Identity, lax, on=spectral, says="the equations of motion as a Lax equation")

polynomial = section.identity(
    "polynomial",
    r"""
{\rm det}({\bf L}-\mu) = \mu^4+\left(16\kappa^2-8H+\frac{2p^2}{\kappa^2}\right)\mu^2
+16K+\frac{8(2G-p^2H)}{\kappa^2}+\frac{c_1c_2}{\kappa^4}""",
    on=spectral,
    says="the characteristic polynomial, whose coefficients are the integrals",
)
