r"""1. The levels of H and J_3 on M^4, for c = 0: a polynomial of degree 4 and a cubic one."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.closed_form import LevelsOnM4, Values
from kowalevski_cas.paper.derivation import Scene, Section

from ..kharlamov2002.section2 import eq10, tau, unit
from ..kharlamov_savushkin2004.setting import complex_integrals, initial

section = Section("1", "The levels on $M^4$", copied=None)

complex_J3 = section.states(
    Identity,
    section.lemma(
        "complex-J3",
        r"j = w_1w_2\omega_3+w_1z_2+w_2z_1",
        "the partial integral in the variables (9)",
    ),
    on=initial,
    says="the partial integral in complex variables",
    ids=("complex-J3",),
)

fields = section.lemma(
    "fields-on-M4",
    r"""
x_1 = -w_1^2, \quad x_2 = -w_2^2, \quad
y_1 = \frac{z_2^2-r^2}{w_2^2}, \quad y_2 = \frac{z_1^2-r^2}{w_1^2}""",
    "the relations (7) and $c_1=c_2=r^2$ solved for the fields",
)

on_M4 = (
    Scene(
        "M⁴ for c = 0",
        variables=("w_1", "w_2", "z_1", "z_2", r"\omega_3"),
        constants=("r",),
        nonzero=("w_1", "w_2"),
        conjugates=(("w_1", "w_2"), ("z_1", "z_2")),
        time=r"\tau",
    )
    .moving(*(eq10[k] for k in range(5, 10)))
    .with_unit(unit[1], tau[1])
    .defining(fields)
)

for k in range(1, 5):
    section.states(
        Identity,
        eq10[k],
        on=on_M4,
        says="the fields on $M^4$ move by (10) of Kharlamov (2002)",
        ids=(f"M4.{k}",),
    )

quartic = section.display(
    "R-of-u",
    r"""
R(u) = -(u^2-r^4)^2-2hj^2(u^2-r^4)+2j^4(u-p^2), \quad
Q(\xi) = (\xi^2+2h\xi+2p^2)^2-4r^4-4j^2\xi""",
)

cubic = section.display(
    "F-of-u",
    r"""
F(u) = (r^4-u^2)\left[2j(w_1z_2+w_2z_1)-r^2(w_1^2+w_2^2)-2Wu\right]
+j^2\left[2uz_1z_2-r^2(z_1^2+z_2^2)\right], \quad
W = w_1w_2, \quad Y = x_1x_2+z_1z_2""",
)

with_integrals = (
    on_M4.called("levels on M⁴")
    .having(constants=("u",))
    .adjoining(complex_integrals[3])
    .defining(complex_integrals[1], complex_J3, quartic[1], cubic)
)

section.identity(
    "by-squares",
    r"""
j^2F(u)+\left[j^2(Y-u)-W(r^4-u^2)\right]^2+W^2R(u) = 0, \quad
2F(u) = -(r^2-u)\left[(r^2+u)(w_1+w_2)-j(z_1+z_2)\right]^2
-(r^2+u)\left[(r^2-u)(w_1-w_2)+j(z_1-z_2)\right]^2""",
    on=with_integrals,
    says="the cubic polynomial $F$ by $R$, and by squares",
)

section.identity(
    "sides-M4",
    r"""
r^2(z_1+z_2)^2 = (Y+r^2)^2-2(p^2+r^2)W^2, \quad
r^2(z_1-z_2)^2 = (Y-r^2)^2-2(p^2-r^2)W^2""",
    on=with_integrals,
    says=r"$\alpha_3$ and $\beta_3$ by $W$ and $Y$",
)

section.identity(
    "by-xi",
    r"R(u)R(-u) = j^8Q\left(\frac{u^2-r^4}{j^2}\right)",
    on=Scene("levels by ξ", constants=("u", "h", "j", "p", "r"), nonzero=("j",)).defining(quartic),
    says="the roots of $Q$ by those of $R$",
)

NUMBERS = (r"\xi", "h", "j", "p", "r")


def offer() -> LevelsOnM4:
    """The polynomial in ξ, whose real roots count the tori."""
    numbers = Scene("levels of M⁴", variables=NUMBERS)
    return LevelsOnM4(polynomial=Values(numbers, (quartic[2],), NUMBERS))
