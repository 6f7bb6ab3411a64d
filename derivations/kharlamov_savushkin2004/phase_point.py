r"""5. The whole phase point by s_1, s_2, for c = 0."""

from kowalevski_cas.paper.claims import Definition, Identity
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section1 import eq3, eq4, eq5
from ..kharlamov2002.section2 import F1, F2, c, eq9, eq13, eq15, eq17, unit
from .separation import any_c, phi, relations, s, separated, solved_for
from .setting import complex_integrals, inverse, p
from .third_integral import VECTORS, G, constants

section = Section("5", "The phase point", copied=False)

no_c = section.inline("no-c", "c=0")

r = section.inline("r-of-a-b", r"r^2=a^2-b^2")

p_without_c = section.lemma("p-of-a-b", r"p^2=a^2+b^2", "the constant $p$ through $a$ and $b$")

radicals = section.display(
    "radicals",
    r"""
S_1^2 = s_1^2-a^2, \quad S_2^2 = b^2-s_2^2, \quad f_1^2 = -\varphi(s_1), \quad
f_2^2 = \varphi(s_2)""",
)

psi = section.display("psi", r"\psi = 4ms_1s_2-2\ell(s_1+s_2)+(\ell^2-1)/m, \quad d = s_1-s_2")

fields = section.display(
    "fields",
    r"""
\begin{array}{l}
\alpha_1 = \frac{(s_1s_2-a^2)\psi+S_1S_2f_1f_2}{2d^2},\quad
\alpha_2 = \frac{(s_1s_2-a^2)f_1f_2-S_1S_2\psi}{2d^2},\quad
\alpha_3 = \frac{rS_1}{d}, \\
\beta_1 = -\frac{(s_1s_2-b^2)f_1f_2-S_1S_2\psi}{2d^2},\quad
\beta_2 = \frac{(s_1s_2-b^2)\psi+S_1S_2f_1f_2}{2d^2},\quad
\beta_3 = \frac{rS_2}{d},
\end{array}""",
)

velocity = section.display(
    "velocity",
    r"""
\omega_1 = \frac{r(\ell-2ms_1)f_2}{2d},\quad
\omega_2 = \frac{r(\ell-2ms_2)f_1}{2d},\quad
\omega_3 = -\frac{S_2f_1+S_1f_2}{d}""",
)

rates = section.display("rates", r"\dot s_1 = \tfrac12S_1f_1,\quad \dot s_2 = \tfrac12S_2f_2")

by_s = (
    Scene(variables=("s_1", "s_2"), constants=("r", "b", "m", r"\ell"), nonzero=("m", "r", "d"))
    .solving("a", r[1])
    .adjoining(radicals)
    .defining(psi, phi, fields, velocity)
)

point = (
    by_s.called("phase point")
    .having(vectors=VECTORS)
    .moving(rates)
    .restricted(no_c)
    .adjoining(p_without_c)
    .defining(eq17, G)
    .naming("g", G[1])
)

section.states(
    Identity,
    separated,
    on=point,
    says="the separated equations",
    ids=("point.separated.1", "point.separated.2"),
)
section.states(
    Identity,
    eq4,
    on=point,
    says="the fields have the lengths $a$ and $b$ and are orthogonal",
    ids=("point.a", "point.b", "point.c"),
)
section.states(Identity, p, on=point, says="the constant $p$ by the fields", ids=("point.p",))
section.states(
    Identity,
    eq3,
    on=point,
    says="the fields move by (3) of Kharlamov (2002)",
    ids=("point.alpha", "point.beta"),
)
section.states(
    Identity,
    eq5,
    on=point,
    says="the body moves by (5) of Kharlamov (2002)",
    ids=("point.omega_1", "point.omega_2", "point.omega_3"),
)
section.states(
    Identity,
    relations,
    on=point,
    says="the integrals at the point",
    ids=("point.k", "point.g", "point.h"),
)

with_unit = by_s.called("phase point with the unit").with_unit(unit[1]).defining(eq9, c)

complex_x = section.states(
    Identity,
    section.lemma(
        "complex-x",
        r"""
x_1 = -\frac{r^2(\psi+if_1f_2)}{2d^2}, \quad x_2 = -\frac{r^2(\psi-if_1f_2)}{2d^2}""",
        "the complex variables $x_1$, $x_2$ at the point",
    ),
    on=with_unit,
    says="$x_1$ and $x_2$ at the point",
    ids=("point.x1", "point.x2"),
)

real_c = section.states(
    Identity,
    section.lemma("real-c", r"c_1 = r^2, \quad c_2 = r^2", "the constants $c_1$, $c_2$ for $c=0$"),
    on=with_unit,
    says="$c_1$ and $c_2$ at the point",
    ids=("point.c1", "point.c2"),
)

root_of_x = section.lemma(
    "root-of-x", r"\sqrt{x_1x_2} = \frac{r^2}{s_1-s_2}", "the difference of $s_1$ and $s_2$"
)

complex_point = (
    with_unit.called("phase point in complex variables")
    .redefining(complex_x, real_c)
    .solving(r"\sqrt{x_1x_2}", root_of_x[1])
    .defining(eq13[1], eq13[2], F1, F2)
)

section.states(
    Identity, eq15, on=complex_point, says="the point lies on $N^4$", ids=("point.F1", "point.F2")
)
section.states(
    Identity,
    constants,
    on=complex_point,
    says=r"$m$ and $\ell$ at the point",
    ids=("point.m", "point.l"),
)
section.states(
    Identity, s, on=complex_point, says="$s_1$ and $s_2$ at the point", ids=("point.s1", "point.s2")
)

solved = section.lemma(
    "solved-radicals",
    r"""
S_1 = \frac{d\alpha_3}{r}, \quad S_2 = \frac{d\beta_3}{r}, \quad
f_1 = \frac{2d\omega_2}{r(\ell-2ms_2)}, \quad f_2 = \frac{2d\omega_1}{r(\ell-2ms_1)}""",
    r"the formulas for $\alpha_3$, $\beta_3$, $\omega_2$, $\omega_1$ solved for the radicals",
)

any_point = (
    solved_for.called("N⁴ without c")
    .having(constants=("r",), nonzero=("x_1", "x_2", "m", "r"))
    .adjoining(complex_integrals[3], any_c)
    .defining(real_c, psi, inverse, solved)
)

section.states(Identity, radicals, on=any_point, says="the radicals at any point of $N^4$")
section.states(
    Definition,
    psi,
    on=any_point,
    says=r"$\psi$ and $d$ in the formulas for the fields",
    equation=fields[1],
)
section.states(Identity, fields, on=any_point, says="the fields at any point of $N^4$")
section.states(Identity, velocity, on=any_point, says="the angular velocity at any point of $N^4$")
section.states(Identity, rates, on=any_point, says="the motion of $s_1$ and $s_2$")
