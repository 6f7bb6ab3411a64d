r"""4. The variables u_1, u_2 at any point of the phase space, for c = 0 and any number \tau_3."""

from kowalevski_cas.paper.claims import Implication
from kowalevski_cas.paper.derivation import Section

from ..kharlamov2002.section1 import eq4
from ..kharlamov2002.section2 import eq9, unit
from ..kharlamov_savushkin2004.phase_point import no_c, r
from ..kharlamov_savushkin2004.setting import body, p
from .separation import abbreviations

section = Section("4", "The converse", copied=False)

anywhere = (
    body.described(
        "phase space for c = 0",
        "the equations (3), (5) with a number $\\tau_3$, where the fields are orthogonal",
    )
    .having(constants=(r"\tau_3",))
    .with_unit(unit[1])
    .adjoining(eq4[1], eq4[2], p, r)
    .defining(eq9, eq4[3], abbreviations)
)

# For real points the signs differ: u1, u2 are real, with u1 between the two numbers and u2 not.

section.states(
    Implication,
    section.display(
        "ends",
        r"""
(\tau_3-X)(\tau_3+r^2)^2+2\tau_3\xi(\tau_3+r^2)+\tau_3\xi^2+\sigma X = 4\tau_3r^2\alpha_3^2, \quad
(\tau_3-X)(\tau_3-r^2)^2+2\tau_3\xi(\tau_3-r^2)+\tau_3\xi^2+\sigma X = -4\tau_3r^2\beta_3^2""",
    ),
    on=anywhere,
    says=(
        r"the quadratic polynomial of $u_1$, $u_2$ at $-\tau_3-r^2$",
        r"the quadratic polynomial of $u_1$, $u_2$ at $-\tau_3+r^2$",
    ),
    given=(*no_c,),
)

symmetric = section.lemma(
    "symmetric-parts",
    r"""
\Pi = \frac{\tau_3\left((\xi+\tau_3)^2-r^4-2p^2X\right)+2r^4X}{\tau_3-X}, \quad
\Lambda = \frac{\tau_3r^2(z_1^2-z_2^2)}{i(\tau_3-X)}, \quad
Y = \tau_3\frac{2\tau_3\xi+2(\tau_3-p^2)(\tau_3-X)+\sigma-\xi^2}{\tau_3-X}""",
    "parts of the phase point, which are symmetric in $u_1$, $u_2$",
)

section.states(
    Implication,
    section.display("y-by-x", r"\tau_3y_1(\Pi+i\Lambda) = r^2x_1(Y+i\Lambda)"),
    on=anywhere.described("parts for c = 0", "the same with parts of the phase point")
    .having(nonzero=(r"\tau_3-X",))
    .defining(symmetric),
    says="$y_1$ by $x_1$, as at the phase point",
    given=(*no_c,),
)
