r"""4. Why every real point of O^4 is a phase point: what its parts are at any point, for c = 0."""

from kowalevski_cas.paper.claims import Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section1 import eq4
from ..kharlamov2002.section2 import eq9, unit
from ..kharlamov2005.third_subsystem import on_O4, partial
from ..kharlamov_savushkin2004.phase_point import no_c, r
from ..kharlamov_savushkin2004.setting import body, complex_integrals, p
from .separation import abbreviations, in_plane

section = Section("4", "The converse", copied=False)

anywhere = (
    body.called("phase space for c = 0")
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
    says="the quadratic polynomial with the roots $u_1$, $u_2$ at two points",
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
    on=anywhere.called("parts for c = 0").having(nonzero=(r"\tau_3-X",)).defining(symmetric),
    says="$y_1$ by $x_1$, as at the phase point",
    given=(*no_c,),
)

# O^4 for c = 0 by x1, x2, z1, z2 and the constants s, r: there all is rational.

by_velocity = section.states(
    Identity,
    section.lemma(
        "by-fields",
        r"""
\tau_3 = x_1x_2+z_1z_2-\frac{\left(x_1z_2-(y_1+2s)z_1\right)\left(x_2z_1-(y_2+2s)z_2\right)}
{(y_1+2s)(y_2+2s)-x_1x_2}, \quad
w_1^2 = \frac{\left(x_1z_2-(y_1+2s)z_1\right)^2}{2s\left((y_1+2s)(y_2+2s)-x_1x_2\right)}""",
        "the constant $\\tau_3$ and the velocity from the equations of $O^4$",
    ),
    on=on_O4.called("O⁴ where ω3 is not zero")
    .having(nonzero=("s", r"\omega_3"))
    .defining(partial[2]),
    says=r"$\tau_3$ and $w_1$ by the fields and $s$",
)

by_fields = (
    Scene(
        "O⁴ for c = 0 by the fields",
        variables=("x_1", "x_2", "z_1", "z_2"),
        constants=("s", "r"),
        nonzero=("s", "r", "x_1", "x_2", "(y_1+2s)(y_2+2s)-x_1x_2", r"\tau_3-X"),
        conjugates=(("x_1", "x_2"), ("z_1", "z_2")),
    )
    .with_unit(unit[1])
    .defining(
        section.lemma(
            "y-by-r",
            r"y_1 = \frac{r^2-z_2^2}{x_2}, \quad y_2 = \frac{r^2-z_1^2}{x_1}",
            "the constants $c_1=c_2=r^2$ solved for",
        ),
        by_velocity[1],
        abbreviations,
        symmetric,
        section.lemma("V-by-X-xi", r"V = 4s^2-\frac{\sigma-\xi^2}{\tau_3-X}", "another such part"),
    )
    .adjoining(complex_integrals[3])
)

section.states(
    Identity,
    section.display("x-real", r"s\left(x_1(\Pi-i\Lambda)+x_2(\Pi+i\Lambda)\right) = r^2VX"),
    on=by_fields,
    says="the real part of $x_1$ by $s$, as at the phase point",
)

section.states(
    Identity,
    section.display(
        "mu-product",
        r"""
\left(\frac{\sigma-\xi^2}{\tau_3-X}\right)^2 = \frac{(u_1^2-\sigma)(u_2^2-\sigma)}{\tau_3^2}""",
    ),
    on=in_plane,
    says=r"the square of a real number that is $\mu_1\mu_2$",
)
