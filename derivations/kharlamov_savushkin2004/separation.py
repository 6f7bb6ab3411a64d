r"""3. N^4 separated: the constants m and \ell, the variables s_1 and s_2, any c."""

from kowalevski_cas.paper.claims import Definition, FirstIntegral, Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section

from .setting import (
    COMPLEX,
    N4,
    PAIRS,
    X,
    c,
    change,
    complex_integrals,
    root_of_c,
    tau,
    unit,
)
from .third_integral import constants, level, solved

section = Section("3", "Separation of variables")


real = section.inline("real", r"\overline{m} = m, \quad \overline{\ell} = \ell")

relations = section.display(
    "relations",
    r"k = r^4m^2, \qquad 2g-p^2h = r^4m, \qquad \ell^2 = 2p^2m^2+2hm+1",
)

s = section.display(
    "s",
    r"""
s_1 = \frac{x_1x_2+z_1z_2+r^2}{2\sqrt{x_1x_2}}, \qquad
s_2 = \frac{x_1x_2+z_1z_2-r^2}{2\sqrt{x_1x_2}}""",
)

phi = section.display("phi", r"\varphi(s) = 4ms^2-4\ell s+(\ell^2-1)/m")

separated = section.display(
    "separated",
    r"""
4\dot s_1^2 = -(s_1^2-a^2)\varphi(s_1), \qquad
4\dot s_2^2 = (b^2-s_2^2)\varphi(s_2)""",
)

any_c = section.inline("any-c", r"a^2=\frac{p^2+r^2}{2}, \quad b^2=\frac{p^2-r^2}{2}")

# N^4 by x1, x2, z1, z2 and the constants: there w1 and w2 are square roots.

m_conjugate = section.lemma(
    "m-conjugate",
    r"m = \frac{1}{c_1}\frac{x_1}{x_2}(w_2^2+x_2)",
    "the conjugate of the display above",
)

y = section.lemma(
    "y",
    r"y_1 = \frac{c_2-z_2^2}{x_2}, \quad y_2 = \frac{c_1-z_1^2}{x_1}",
    "the constants $c_1$, $c_2$ solved for",
)

omega3 = section.lemma(
    "omega3", r"\omega_3 = \frac{x_2z_1w_1+x_1z_2w_2}{x_1x_2}", "$F_1=0$ solved for"
)

equations = section.lemma(
    "eq10",
    r"""
x_1' = -x_1\omega_3+z_1w_1, \quad x_2' = x_2\omega_3-z_2w_2, \quad
y_1' = -y_1\omega_3+z_2w_1, \quad y_2' = y_2\omega_3-z_1w_2, \quad
2z_1' = x_1w_2-y_2w_1, \quad 2z_2' = -x_2w_1+y_1w_2, \quad
2w_1' = -(w_1\omega_3+z_1), \quad 2w_2' = w_2\omega_3+z_2, \quad 2\omega_3' = y_2-y_1""",
    "Kharlamov (2002), equations (10), corrected",
)

squares = section.lemma(
    "squares",
    r"""
2w_1w_1'+x_1' = mc_2\left(\frac{x_1}{x_2}\right)', \quad
2w_2w_2'+x_2' = mc_1\left(\frac{x_2}{x_1}\right)'""",
    "the derivatives of what defines $w_1$, $w_2$ on $N^4$",
)

# -- scenes --------------------------------------------------------------------

with_root = Scene(
    "complex variables",
    "the variables (9) with $\\sqrt{x_1x_2}$, where $c_1$, $c_2$ are constants and nothing is zero",
    variables=(*X, r"\omega_3"),
    constants=("c_1", "c_2"),
    field=change,
    time=r"\tau",
    conjugates=(*PAIRS, ("c_1", "c_2")),
    roots={"z_1": c[1], "z_2": c[2], r"\sqrt{x_1x_2}": None},
    nonzero=("x_1", "x_2", "c_1", "c_2"),
    definitions={
        **{n: d for n, d in COMPLEX.items() if n not in {"c_1", "c_2"}},
        "m": constants[1],
        r"\ell": constants[2],
    },
)

with_G = Scene(
    "complex variables and G",
    "the variables (9), where $G$ is known through $F_1$, $U_1$, $U_2$",
    variables=(*X, r"\omega_3"),
    constants=("c_1", "c_2", "p", "h"),
    conjugates=with_root.conjugates,
    roots={r"\sqrt{x_1x_2}": None, r"\sqrt{c_1c_2}": None, "r": root_of_c[1]},
    nonzero=("x_1", "x_2", "c_1", "c_2"),
    definitions={**with_root.definitions, "H": level[1], "g": solved[1]},
)

on_N4 = Scene(
    "N⁴",
    "$N^4$ by $x_1$, $x_2$, $z_1$, $z_2$ and the constants $m$, $c_1$, $c_2$, none of which is zero",
    variables=("x_1", "x_2", "z_1", "z_2", "w_1", "w_2"),
    constants=("m", "c_1", "c_2"),
    field=tuple(equations[k] for k in (1, 2, 5, 6, 7, 8)),
    time=r"\tau",
    unit=unit[1],
    clock=tau[1],
    roots={
        "w_1": constants[1],
        "w_2": m_conjugate[1],
        r"\sqrt{x_1x_2}": None,
        r"\sqrt{c_1c_2}": None,
        "r": root_of_c[1],
        "p": complex_integrals[3],
        "a": any_c[1],
        "b": any_c[2],
    },
    nonzero=("x_1", "x_2", "c_1", "c_2", "m"),
    definitions={
        "y_1": y[1],
        "y_2": y[2],
        r"\omega_3": omega3[1],
        r"\ell": constants[2],
        "h": complex_integrals[1],
        "k": complex_integrals[2],
        "s_1": s[1],
        "s_2": s[2],
        r"\varphi(s)": phi[1],
    },
)

# -- claims --------------------------------------------------------------------

section.claim(
    *(
        Identity(f"eq10.{k}", with_root, equations[k], "an equation of motion in the time $\\tau$")
        for k in range(1, 10)
    ),
    FirstIntegral("m", with_root, constants[1], "it is constant on $N^4$", on=(N4[1], N4[2])),
    Implication("m-real", with_root, real[1], "it is real on $N^4$", given=(N4[2],)),
    Implication(
        "m-conjugate", with_root, m_conjugate[1], "so it is its conjugate as well", given=(N4[2],)
    ),
    Implication("l-real", with_root, real[2], "it is real on $N^4$", given=(N4[2],)),
    FirstIntegral("l", on_N4, constants[2], "it is constant on $N^4$"),
    Identity("k", on_N4, relations[1], "$K$ on $N^4$"),
    Identity("h", on_N4, relations[3], "the energy on $N^4$"),
    *(
        Identity(f"N4.{k}", on_N4, equations[k], "the variables on $N^4$ move by (10)")
        for k in (3, 4, 9)
    ),
    *(
        Identity(f"squares.{k}", on_N4, squares[k], "the variables on $N^4$ move by (10)")
        for k in (1, 2)
    ),
    Implication(
        "g", with_G, relations[2], "$G$ on $N^4$", given=(N4[1], N4[2]), main=((r"\omega_3",),)
    ),
    *(
        Definition(f"s.{k}", on_N4, s[k], "the variable that separates", equation=separated[k])
        for k in (1, 2)
    ),
    Definition(
        "phi", on_N4, phi[1], "the polynomial of the separated equations", equation=separated[1]
    ),
    *(
        Definition(
            f"any-c.{k}", on_N4, any_c[k], "how to read it for any $c$", equation=separated[k]
        )
        for k in (1, 2)
    ),
    Identity("separated.1", on_N4, separated[1], "the first separated equation"),
    Identity("separated.2", on_N4, separated[2], "the second separated equation"),
)
