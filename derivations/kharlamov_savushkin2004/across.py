r"""8. Across N^4: what the cofactor matrix of (15) is along a motion on N^4."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .separation import on_N4, s
from .setting import U

section = Section("8", "Across N⁴")

sum_of_U = section.lemma(
    "sum-of-U",
    r"U_1+U_2 = 2r^4m",
    "the quotient of the two entries of the cofactor matrix of (15) is $2(U_1+U_2)$",
)

exponent = section.lemma(
    "exponent",
    r"\frac{U_1+U_2}{2x_1x_2} = m(s_1-s_2)^2",
    r"on the left the product of the two entries: minus the square of the exponents in the time $t$",
)

near_N4 = Scene(
    "N⁴ with U",
    "$N^4$ by $x_1$, $x_2$, $z_1$, $z_2$ and the constants $m$, $c_1$, $c_2$, with $U_1$ and $U_2$",
    variables=on_N4.variables,
    constants=on_N4.constants,
    roots={n: on_N4.roots[n] for n in ("w_1", "w_2", r"\sqrt{x_1x_2}", r"\sqrt{c_1c_2}", "r")},
    nonzero=on_N4.nonzero,
    definitions={"U_1": U[1], "U_2": U[2], "s_1": s[1], "s_2": s[2]},
)

section.claim(
    Identity("sum-of-U", near_N4, sum_of_U[1], "the quotient of the entries is constant"),
    Identity("exponent", near_N4, exponent[1], "the exponents by the separated variables"),
)
