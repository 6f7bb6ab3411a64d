r"""1. The problem: two constant fields in the Kowalevski case, and N^4 (Kharlamov 2002)."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Section

from ..kharlamov2002.section1 import eq3, eq4, eq5, kowalevski
from ..kharlamov2002.section2 import PAIRS, c, eq9, eq17, tau, unit

section = Section("1", "The problem", copied=False)

p = section.display("p", r"p^2 = ({\bs \alpha},{\bs \alpha}) + ({\bs \beta},{\bs \beta})")

r = section.display("r", r"r^4 = c_1c_2 = (a^2-b^2)^2 + 4c^2")

root_of_c = section.lemma("root-of-c", r"r^2=\sqrt{c_1c_2}", "the positive root of the line above")

body = kowalevski.moving(eq5, eq3).redefining(eq17)

initial = (
    body.called("initial variables")
    .with_unit(unit[1], tau[1])
    .adjoining(eq4[1], eq4[2], p, r"\sqrt{c_1c_2}", root_of_c)
    .defining(eq9, eq4[3], c)
)

complex_variables = initial.changed(eq9, tau[1], keeping=(r"\omega_3",)).having(conjugates=PAIRS)

section.states(
    Identity, r, on=initial, says="the constant $r$ by $c_1$ and $c_2$, and by $a$, $b$ and $c$"
)

inverse = section.states(
    Identity,
    section.lemma(
        "inverse",
        r"""
\begin{array}{l}
\alpha_1 = \frac14(x_1+x_2+y_1+y_2), \quad \alpha_2 = \frac{1}{4i}(x_1-x_2+y_1-y_2), \quad
\alpha_3 = \frac12(z_1+z_2), \\
\beta_1 = \frac{1}{4i}(x_1-x_2-y_1+y_2), \quad \beta_2 = \frac14(y_1+y_2-x_1-x_2), \quad
\beta_3 = \frac{1}{2i}(z_1-z_2), \\
\omega_1 = \frac12(w_1+w_2), \quad \omega_2 = \frac{1}{2i}(w_1-w_2)
\end{array}""",
        "equations (9) solved for the initial variables",
    ),
    on=initial,
    says="the initial variables by the complex ones",
)

complex_integrals = section.states(
    Identity,
    section.lemma(
        "complex-integrals",
        r"""
h = w_1w_2 + \frac12\omega_3^2 - \frac12(y_1+y_2), \quad
k = (w_1^2+x_1)(w_2^2+x_2), \quad
p^2 = \frac12(x_1x_2+y_1y_2) + z_1z_2""",
        "the integrals in the variables (9)",
    ),
    on=initial,
    says="the energy, the integral $K$ and the constant $p$ in complex variables",
    ids=("complex-energy", "complex-K", "complex-p"),
)
