r"""8. Across N^4: what the cofactor matrix of (15) is along a motion on N^4."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Section

from ..kharlamov2002.section2 import eq13
from .separation import on_N4

section = Section("8", "Across $N^4$", copied=False)

with_U = on_N4.called("N⁴ with U").defining(eq13[1], eq13[2])

sum_of_U = section.states(
    Identity,
    section.lemma(
        "sum-of-U",
        r"U_1+U_2 = 2r^4m",
        "the quotient of the two entries of the cofactor matrix of (15) is $2(U_1+U_2)$",
    ),
    on=with_U,
    says="$U_1+U_2$ is constant on $N^4$",
)

exponent = section.states(
    Identity,
    section.lemma(
        "exponent",
        r"\frac{U_1+U_2}{2x_1x_2} = m(s_1-s_2)^2",
        r"on the left the product of the two entries: minus the square of the exponents in the time $t$",
    ),
    on=with_U,
    says="minus the square of the exponents, by the separated variables",
)
