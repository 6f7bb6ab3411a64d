r"""4. Any c: the fields and the body turned so that c is zero."""

from kowalevski_cas.paper.claims import Implication
from kowalevski_cas.paper.derivation import Section

from ..kharlamov2002.section2 import eq10
from .separation import with_root
from .setting import complex_integrals

section = Section("4", "Fields that are not orthogonal", copied=False)

unit_modulus = section.inline("unit-modulus", "q_1q_2 = 1")

angle = section.lemma(
    "angle",
    r"q_1^2c_1 = r^2, \quad q_2^2c_2 = r^2",
    r"the angle of $q_1$ is half of $-\arctan\frac{2c}{a^2-b^2}$",
)

turned = section.lemma(
    "turned",
    r"""
X_1 = q_1^2x_1, \quad X_2 = q_2^2x_2, \quad Y_1 = y_1, \quad Y_2 = y_2, \quad
Z_1 = q_1z_1, \quad Z_2 = q_2z_2, \quad W_1 = q_1w_1, \quad W_2 = q_2w_2""",
    "the axes in the body and the fields, turned by the same angle",
)

rotation = (
    with_root.called("turned variables")
    .moving(eq10)
    .having(
        constants=("q_1", "q_2", "r"), conjugates=(("q_1", "q_2"),), nonzero=("q_1", "q_2", "r")
    )
    .adjoining(complex_integrals[3])
    .defining(turned)
)

motion = section.states(
    Implication,
    section.lemma(
        "turned-motion",
        r"""
X_1' = -X_1\omega_3+Z_1W_1, \quad X_2' = X_2\omega_3-Z_2W_2, \quad
Y_1' = -Y_1\omega_3+Z_2W_1, \quad Y_2' = Y_2\omega_3-Z_1W_2, \quad
2Z_1' = X_1W_2-Y_2W_1, \quad 2Z_2' = -X_2W_1+Y_1W_2, \quad
2W_1' = -(W_1\omega_3+Z_1), \quad 2W_2' = W_2\omega_3+Z_2, \quad 2\omega_3' = Y_2-Y_1""",
        "the equations of motion in the turned variables",
    ),
    on=rotation,
    says="the equations of motion stay the same",
    ids=[f"turned.{k}" for k in range(1, 10)],
    given=(unit_modulus[1],),
)

real_c = section.states(
    Implication,
    section.lemma(
        "turned-c",
        r"Z_1^2+X_1Y_2 = r^2, \quad Z_2^2+X_2Y_1 = r^2",
        "$c_1=c_2$ is the same as $c=0$",
    ),
    on=rotation,
    says="the fields become orthogonal",
    ids=("turned.c1", "turned.c2"),
    given=(unit_modulus[1], *angle),
)

kept = section.states(
    Implication,
    section.lemma(
        "turned-constants",
        r"""
p^2 = \frac12(X_1X_2+Y_1Y_2)+Z_1Z_2, \quad
m = \frac{1}{r^2}\frac{X_2}{X_1}(W_1^2+X_1), \quad
\ell = \frac{1}{\sqrt{x_1x_2}}\left[W_1W_2+(X_1X_2+Z_1Z_2)m\right]""",
        "the constants of the motion in the turned variables",
    ),
    on=rotation,
    says=r"$p$, $m$ and $\ell$ stay the same",
    ids=("turned.p", "turned.m", "turned.l"),
    given=(unit_modulus[1], *angle),
)
