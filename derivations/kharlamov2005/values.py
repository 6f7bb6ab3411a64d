r"""3. The integrals on O^4, and their place on the surface of double roots."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import c
from ..kharlamov_savushkin2004.setting import complex_integrals, root_of_c
from ..kharlamov_savushkin2004.third_integral import everything
from .third_subsystem import on_O4, partial

section = Section("3", "The integrals on the third subsystem", copied=False)

complex_G = section.states(
    Identity,
    section.lemma(
        "complex-G",
        r"""
g = \frac14\left[w_1^2x_2y_2+w_2^2x_1y_1+w_1w_2(x_1x_2+y_1y_2)+x_1z_2^2+x_2z_1^2
-(y_1+y_2)z_1z_2\right]+\frac12\omega_3(x_2z_1w_1+x_1z_2w_2)
+\frac18\omega_3^2(y_1y_2-x_1x_2+2z_1z_2)+\frac18(y_1+y_2)(x_1x_2-y_1y_2)""",
        "the third integral in the variables (9)",
    ),
    on=everything,
    says="the integral $G$ in complex variables",
)

on_O4_values = section.display(
    "on-O4",
    r"""
h = \frac{p^2-\tau_3}{2s}+s, \quad
k = \frac{\tau_3^2-2p^2\tau_3+r^4}{4s^2}+\tau_3, \quad
g = \frac{p^4-r^4}{4s}+\frac{(p^2-\tau_3)s}{2}""",
)

with_integrals = (
    on_O4.called("O⁴ with integrals")
    .having(nonzero=("s",))
    .adjoining(r"\sqrt{c_1c_2}", root_of_c, complex_integrals[3])
    .defining(c, complex_integrals[1], complex_integrals[2], complex_G, partial[2])
)

section.states(
    Identity,
    on_O4_values,
    on=with_integrals,
    says="the integrals on $O^4$",
    ids=("O4.h", "O4.k", "O4.g"),
)

constants = Scene("constants", constants=("s", r"\tau_3", "p", "r"), nonzero=("s",)).defining(
    on_O4_values
)

double_root = section.states(
    Identity,
    section.lemma(
        "double-root",
        r"""
s^4-2hs^3+(h^2+p^2-k)s^2-2gs+\frac{p^4-r^4}{4} = 0, \quad
4s^3-6hs^2+2(h^2+p^2-k)s-2g = 0""",
        "what it means that $s$ is a double root of $s^4-2hs^3+(h^2+p^2-k)s^2-2gs+(p^4-r^4)/4$",
    ),
    on=constants,
    says="$s$ is a double root of this polynomial",
)
