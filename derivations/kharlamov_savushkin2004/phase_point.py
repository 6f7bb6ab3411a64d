r"""5. The whole phase point by s_1, s_2, for c = 0."""

from kowalevski_cas.claims import Identity
from kowalevski_cas.derivation import Scene, Section

from .separation import phi, relations, s, separated
from .setting import (
    ALPHA,
    BETA,
    CHANGE,
    COMPLEX,
    INTEGRALS,
    N4,
    OMEGA,
    c,
    eq3,
    eq4,
    eq5,
    p,
    unit,
)
from .third_integral import THIRD, VECTORS, constants

section = Section("5", "The phase point")

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

root_of_x = section.lemma(
    "root-of-x", r"\sqrt{x_1x_2} = \frac{r^2}{s_1-s_2}", "the difference of $s_1$ and $s_2$"
)

complex_x = section.lemma(
    "complex-x",
    r"""
x_1 = -\frac{r^2(\psi+if_1f_2)}{2d^2}, \quad x_2 = -\frac{r^2(\psi-if_1f_2)}{2d^2}""",
    "the complex variables $x_1$, $x_2$ at the point",
)

real_c = section.lemma(
    "real-c", r"c_1 = r^2, \quad c_2 = r^2", "the constants $c_1$, $c_2$ for $c=0$"
)

# -- scenes --------------------------------------------------------------------

POINT = {
    **dict(zip(ALPHA, (fields[k] for k in (1, 2, 3)), strict=True)),
    **dict(zip(BETA, (fields[k] for k in (4, 5, 6)), strict=True)),
    **dict(zip(OMEGA, (velocity[k] for k in (1, 2, 3)), strict=True)),
}
RADICALS = {
    "a": r[1],
    "S_1": radicals[1],
    "S_2": radicals[2],
    "f_1": radicals[3],
    "f_2": radicals[4],
}
FUNCTIONS = {r"\psi": psi[1], "d": psi[2], r"\varphi(s)": phi[1]}

point = Scene(
    "phase point",
    "the phase space by $s_1$, $s_2$ and the radicals, which move by the separated equations",
    vectors=VECTORS,
    variables=("s_1", "s_2"),
    constants=("r", "b", "m", r"\ell"),
    field=(rates[1], rates[2]),
    zero=(no_c[1],),
    roots={**RADICALS, "p": p_without_c[1]},
    definitions={**FUNCTIONS, **POINT, **INTEGRALS, **{n: d for n, d in THIRD.items() if n != "c"}},
)

with_unit = Scene(
    "phase point with the unit",
    "the same with the complex variables as abbreviations",
    variables=("s_1", "s_2"),
    constants=("r", "b", "m", r"\ell"),
    unit=unit[1],
    roots=RADICALS,
    definitions={**FUNCTIONS, **POINT, **CHANGE, "c_1": c[1], "c_2": c[2]},
)

complex_point = Scene(
    "phase point in complex variables",
    "the same with $x_1$, $x_2$, $c_1$, $c_2$ in closed form, and with $\\sqrt{x_1x_2}$",
    variables=("s_1", "s_2"),
    constants=("r", "b", "m", r"\ell"),
    unit=unit[1],
    roots={**RADICALS, r"\sqrt{x_1x_2}": root_of_x[1]},
    definitions={
        **FUNCTIONS,
        **POINT,
        **CHANGE,
        **COMPLEX,
        "c_1": real_c[1],
        "c_2": real_c[2],
        "x_1": complex_x[1],
        "x_2": complex_x[2],
    },
)

# -- claims --------------------------------------------------------------------

section.claim(
    Identity("point.separated.1", point, separated[1], "the first separated equation"),
    Identity("point.separated.2", point, separated[2], "the second separated equation"),
    Identity("point.a", point, eq4[1], "the length of the first field"),
    Identity("point.b", point, eq4[2], "the length of the second field"),
    Identity("point.c", point, eq4[3], "the fields are orthogonal"),
    Identity("point.p", point, p[1], "the constant $p$"),
    Identity("point.alpha", point, eq3[1], "the motion of the first field"),
    Identity("point.beta", point, eq3[2], "the motion of the second field"),
    *(Identity(f"point.omega_{k}", point, eq5[k], "the motion of the body") for k in (1, 2, 3)),
    Identity("point.k", point, relations[1], "the value of $K$"),
    Identity("point.g", point, relations[2], "the value of $G$"),
    Identity("point.h", point, relations[3], "the value of the energy"),
    Identity("point.x1", with_unit, complex_x[1], "$x_1$ at the point"),
    Identity("point.x2", with_unit, complex_x[2], "$x_2$ at the point"),
    Identity("point.c1", with_unit, real_c[1], "$c_1$ at the point"),
    Identity("point.c2", with_unit, real_c[2], "$c_2$ at the point"),
    Identity("point.F1", complex_point, N4[1], "the point lies on $N^4$"),
    Identity("point.F2", complex_point, N4[2], "the point lies on $N^4$"),
    Identity("point.m", complex_point, constants[1], "the value of $m$"),
    Identity("point.l", complex_point, constants[2], r"the value of $\ell$"),
    Identity("point.s1", complex_point, s[1], "$s_1$ at the point"),
    Identity("point.s2", complex_point, s[2], "$s_2$ at the point"),
)
