r"""5. The whole phase point by s_1, s_2, for c = 0."""

from kowalevski_cas.paper.claims import Definition, Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .separation import any_c, m_conjugate, omega3, on_N4, phi, relations, s, separated
from .setting import (
    ALPHA,
    BETA,
    CHANGE,
    COMPLEX,
    INTEGRALS,
    N4,
    OMEGA,
    c,
    complex_integrals,
    eq3,
    eq4,
    eq5,
    inverse,
    p,
    tau,
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

solved = section.lemma(
    "solved-radicals",
    r"""
S_1 = \frac{d\alpha_3}{r}, \quad S_2 = \frac{d\beta_3}{r}, \quad
f_1 = \frac{2d\omega_2}{r(\ell-2ms_2)}, \quad f_2 = \frac{2d\omega_1}{r(\ell-2ms_1)}""",
    r"the formulas for $\alpha_3$, $\beta_3$, $\omega_2$, $\omega_1$ solved for the radicals",
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

NONZERO = ("m", "r", "d")

point = Scene(
    "phase point",
    "the phase space by $s_1$, $s_2$ and the radicals, where $m$, $r$ and $d$ are not zero",
    vectors=VECTORS,
    variables=("s_1", "s_2"),
    constants=("r", "b", "m", r"\ell"),
    field=(rates[1], rates[2]),
    zero=(no_c[1],),
    roots={**RADICALS, "p": p_without_c[1]},
    nonzero=NONZERO,
    definitions={**FUNCTIONS, **POINT, **INTEGRALS, **{n: d for n, d in THIRD.items() if n != "c"}},
)

with_unit = Scene(
    "phase point with the unit",
    "the same with the complex variables as abbreviations",
    variables=("s_1", "s_2"),
    constants=("r", "b", "m", r"\ell"),
    unit=unit[1],
    roots=RADICALS,
    nonzero=NONZERO,
    definitions={**FUNCTIONS, **POINT, **CHANGE, "c_1": c[1], "c_2": c[2]},
)

complex_point = Scene(
    "phase point in complex variables",
    "the same with $x_1$, $x_2$, $c_1$, $c_2$ in closed form, and with $\\sqrt{x_1x_2}$",
    variables=("s_1", "s_2"),
    constants=("r", "b", "m", r"\ell"),
    unit=unit[1],
    roots={**RADICALS, r"\sqrt{x_1x_2}": root_of_x[1]},
    nonzero=NONZERO,
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

any_point = Scene(
    "N⁴ without c",
    "any point of $N^4$ for $c=0$, with the radicals that the formulas give there",
    variables=("x_1", "x_2", "z_1", "z_2", "w_1", "w_2"),
    constants=("m", "r"),
    field=on_N4.field,
    time=r"\tau",
    unit=unit[1],
    clock=tau[1],
    roots={
        "w_1": constants[1],
        "w_2": m_conjugate[1],
        r"\sqrt{x_1x_2}": None,
        "p": complex_integrals[3],
        "a": any_c[1],
        "b": any_c[2],
    },
    nonzero=("x_1", "x_2", "m", "r"),
    definitions={
        **{name: place for name, place in on_N4.definitions.items() if name not in {"h", "k"}},
        "c_1": real_c[1],
        "c_2": real_c[2],
        r"\psi": psi[1],
        "d": psi[2],
        **dict(zip((*ALPHA, *BETA, *OMEGA), (inverse[k] for k in range(1, 9)), strict=False)),
        "S_1": solved[1],
        "S_2": solved[2],
        "f_1": solved[3],
        "f_2": solved[4],
        r"\omega_3": omega3[1],
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
    *(
        Identity(f"radicals.{k}", any_point, radicals[k], "the radical at any point of $N^4$")
        for k in (1, 2, 3, 4)
    ),
    *(
        Definition(f"psi.{k}", any_point, psi[k], "what the fields use", equation=fields[1])
        for k in (1, 2)
    ),
    *(
        Identity(f"fields.{k}", any_point, fields[k], "the fields at any point of $N^4$")
        for k in range(1, 7)
    ),
    *(
        Identity(f"velocity.{k}", any_point, velocity[k], "the velocity at any point of $N^4$")
        for k in (1, 2, 3)
    ),
    *(
        Identity(f"rates.{k}", any_point, rates[k], "the motion of the variable on $N^4$")
        for k in (1, 2)
    ),
)
