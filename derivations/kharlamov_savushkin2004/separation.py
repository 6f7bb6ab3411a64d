r"""3. N^4 separated: the constants m and \ell, the variables s_1 and s_2, any c."""

from kowalevski_cas.paper.claims import Definition, FirstIntegral, Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import F1, F2, PAIRS, c, eq10, eq13, eq15, tau, unit
from .setting import complex_integrals, complex_variables, root_of_c
from .third_integral import constants, level, solved

section = Section("3", "Separation of variables", copied=False)

near_N4 = complex_variables.having(
    constants=("c_1", "c_2"), conjugates=(("c_1", "c_2"),), nonzero=("x_1", "x_2", "c_1", "c_2")
).defining(F1, eq13[1], eq13[2], F2, constants)

with_root = (
    near_N4.called("complex variables")
    .solving("z_1", c[1])
    .solving("z_2", c[2])
    .adjoining(r"\sqrt{x_1x_2}")
)

section.states(Identity, eq10, on=with_root, says=r"the equations of motion in the time $\tau$")
section.states(
    FirstIntegral,
    constants[1],
    on=with_root,
    says="a constant on $N^4$",
    ids=("m",),
    given=(*eq15,),
)

real = section.inline("real", r"\overline{m} = m, \quad \overline{\ell} = \ell")

m_conjugate = section.lemma(
    "m-conjugate",
    r"m = \frac{1}{c_1}\frac{x_1}{x_2}(w_2^2+x_2)",
    "the conjugate of the display above",
)

section.states(
    Implication,
    real[1],
    on=with_root,
    says=r"$m$ and $\ell$ are real on $N^4$",
    ids=("m-real",),
    given=(eq15[2],),
)
section.states(
    Implication, m_conjugate, on=with_root, says="the conjugate formula for $m$", given=(eq15[2],)
)
section.states(
    Implication,
    real[2],
    on=with_root,
    says=r"$m$ and $\ell$ are real on $N^4$",
    ids=("l-real",),
    given=(eq15[2],),
)

relations = section.display(
    "relations", r"k = r^4m^2, \qquad 2g-p^2h = r^4m, \qquad \ell^2 = 2p^2m^2+2hm+1"
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

y = section.lemma(
    "y",
    r"y_1 = \frac{c_2-z_2^2}{x_2}, \quad y_2 = \frac{c_1-z_1^2}{x_1}",
    "the constants $c_1$, $c_2$ solved for",
)

omega3 = section.lemma(
    "omega3", r"\omega_3 = \frac{x_2z_1w_1+x_1z_2w_2}{x_1x_2}", "$F_1=0$ solved for"
)

solved_for = (
    Scene(variables=("x_1", "x_2", "z_1", "z_2", "w_1", "w_2"), constants=("m",), time=r"\tau")
    .moving(*(eq10[k] for k in (1, 2, 5, 6, 7, 8)))
    .with_unit(unit[1], tau[1])
    .having(conjugates=tuple(pair for pair in PAIRS if pair != ("y_1", "y_2")))
    .solving("w_1", constants[1])
    .solving("w_2", m_conjugate[1])
    .adjoining(r"\sqrt{x_1x_2}")
    .defining(y, omega3, constants[2], s, phi)
)

any_level = solved_for.called("N⁴").having(
    constants=("c_1", "c_2"),
    conjugates=(("c_1", "c_2"),),
    nonzero=("x_1", "x_2", "c_1", "c_2", "m"),
)

on_N4 = (
    any_level.called("N⁴ with a and b")
    .adjoining(r"\sqrt{c_1c_2}", root_of_c, complex_integrals[3], any_c)
    .defining(complex_integrals[1], complex_integrals[2])
)

section.states(FirstIntegral, constants[2], on=any_level, says="a constant on $N^4$", ids=("l",))
section.states(Identity, relations[1], on=on_N4, says="the integrals on $N^4$", ids=("k",))
section.states(Identity, relations[3], on=on_N4, says="the integrals on $N^4$", ids=("h",))
for k in (3, 4, 9):
    section.states(
        Identity,
        eq10[k],
        on=on_N4,
        says="the variables on $N^4$ move by (10) of Kharlamov (2002)",
        ids=(f"N4.{k}",),
    )

squares = section.states(
    Identity,
    section.lemma(
        "squares",
        r"""
2w_1w_1'+x_1' = mc_2\left(\frac{x_1}{x_2}\right)', \quad
2w_2w_2'+x_2' = mc_1\left(\frac{x_2}{x_1}\right)'""",
        "the derivatives of what defines $w_1$, $w_2$ on $N^4$",
    ),
    on=on_N4,
    says="the variables on $N^4$ move by (10) of Kharlamov (2002)",
)

with_G = (
    near_N4.called("complex variables and G")
    .having(constants=("p", "h"))
    .adjoining(r"\sqrt{x_1x_2}", r"\sqrt{c_1c_2}", root_of_c)
    .defining(level)
    .naming("g", solved[1])
)

section.states(
    Implication,
    relations[2],
    on=with_G,
    says="the integrals on $N^4$",
    ids=("g",),
    given=(*eq15,),
    main=((r"\omega_3",),),
)
section.states(Definition, s, on=on_N4, says="the variables that separate", equation=separated)
section.states(
    Definition,
    phi,
    on=on_N4,
    says="the polynomial of the separated equations",
    equation=separated[1],
)
section.states(Definition, any_c, on=on_N4, says="$a$ and $b$ for any $c$", equation=separated)
section.states(Identity, separated, on=on_N4, says="the separated equations")
