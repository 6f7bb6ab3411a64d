r"""4. Any c: the fields and the body turned so that c is zero."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .separation import equations
from .setting import PAIRS, X, c, complex_integrals, root_of_c
from .third_integral import constants

section = Section("4", "Fields that are not orthogonal")

angle = section.lemma(
    "angle",
    r"q^2 = \frac{r^2}{c_1}",
    r"the number $q$ of modulus one whose angle is half of $-\arctan\frac{2c}{a^2-b^2}$",
)

turned = section.lemma(
    "turned",
    r"""
X_1 = q^2x_1, \quad X_2 = \frac{x_2}{q^2}, \quad Y_1 = y_1, \quad Y_2 = y_2, \quad
Z_1 = qz_1, \quad Z_2 = \frac{z_2}{q}, \quad W_1 = qw_1, \quad W_2 = \frac{w_2}{q}""",
    "the axes in the body and the fields, turned by the same angle",
)

motion = section.lemma(
    "turned-motion",
    r"""
X_1' = -X_1\omega_3+Z_1W_1, \quad X_2' = X_2\omega_3-Z_2W_2, \quad
Y_1' = -Y_1\omega_3+Z_2W_1, \quad Y_2' = Y_2\omega_3-Z_1W_2, \quad
2Z_1' = X_1W_2-Y_2W_1, \quad 2Z_2' = -X_2W_1+Y_1W_2, \quad
2W_1' = -(W_1\omega_3+Z_1), \quad 2W_2' = W_2\omega_3+Z_2, \quad 2\omega_3' = Y_2-Y_1""",
    "the equations of motion in the turned variables",
)

real_c = section.lemma(
    "turned-c",
    r"Z_1^2+X_1Y_2 = r^2, \quad Z_2^2+X_2Y_1 = r^2",
    "$c_1=c_2$ is the same as $c=0$",
)

kept = section.lemma(
    "turned-constants",
    r"""
p^2 = \frac12(X_1X_2+Y_1Y_2)+Z_1Z_2, \quad
m = \frac{1}{r^2}\frac{X_2}{X_1}(W_1^2+X_1), \quad
\ell = \frac{1}{\sqrt{x_1x_2}}\left[W_1W_2+(X_1X_2+Z_1Z_2)m\right]""",
    "the constants of the motion in the turned variables",
)

# -- scenes --------------------------------------------------------------------

TURNED = ("X_1", "X_2", "Y_1", "Y_2", "Z_1", "Z_2", "W_1", "W_2")

rotation = Scene(
    "turned variables",
    "the complex variables, turned so that both constants $c_1$ and $c_2$ become $r^2$",
    variables=(*X, r"\omega_3"),
    constants=("c_1", "c_2"),
    field=tuple(equations[k] for k in range(1, 10)),
    time=r"\tau",
    conjugates=(*PAIRS, ("c_1", "c_2")),
    roots={
        "z_1": c[1],
        "z_2": c[2],
        r"\sqrt{x_1x_2}": None,
        r"\sqrt{c_1c_2}": None,
        "r": root_of_c[1],
        "q": angle[1],
        "p": complex_integrals[3],
    },
    nonzero=("x_1", "x_2", "c_1", "c_2"),
    definitions={
        **dict(zip(TURNED, (turned[k] for k in range(1, 9)), strict=True)),
        "m": constants[1],
        r"\ell": constants[2],
    },
)

# -- claims --------------------------------------------------------------------

section.claim(
    *(
        Identity(f"turned.{k}", rotation, motion[k], "the equations of motion stay the same")
        for k in range(1, 10)
    ),
    Identity("turned.c1", rotation, real_c[1], "the fields become orthogonal"),
    Identity("turned.c2", rotation, real_c[2], "the fields become orthogonal"),
    Identity("turned.p", rotation, kept[1], "$p$ stays the same"),
    Identity("turned.m", rotation, kept[2], "$m$ stays the same"),
    Identity("turned.l", rotation, kept[3], r"$\ell$ stays the same"),
)
