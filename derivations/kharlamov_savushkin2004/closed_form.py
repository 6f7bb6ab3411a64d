"""The formulas by which motions are computed; none is typed here a second time."""

from kowalevski_cas.paper.closed_form import ClosedForm, Values
from kowalevski_cas.paper.derivation import Scene

from ..kharlamov2002.section1 import ALPHA, BETA, OMEGA
from ..kharlamov2002.section2 import F1, F2, F_prime, c, eq13, eq16, unit, xi
from .phase_point import fields, velocity
from .setting import complex_variables, initial
from .third_integral import VECTORS, G

STATE = (*OMEGA, *ALPHA, *BETA)
ROOT = r"\sqrt{x_1x_2}"

supplied = ("s_1s_2-a^2", "s_1s_2-b^2", r"\ell-2ms_1", r"\ell-2ms_2", "rS_2")
by = ("S_1", "S_2", "f_1", "f_2", "d", r"\psi", *supplied, "r")
known = complex_variables.variables
invariants = ("F_1", "F_2", "U_1", "U_2")

point = Scene("phase point, supplied", variables=(*by, "s_1", "s_2", "a", "b", "m", r"\ell"))

with_G = initial.having(vectors=VECTORS).defining(G)

with_relations = with_G.defining(xi).naming("N_1", eq16[1]).naming("N_2", eq16[2])

beside = (
    Scene("beside N⁴", variables=known)
    .with_unit(unit[1])
    .adjoining(ROOT)
    .defining(c, eq13[1], eq13[2], F1, F2)
)

linear = Scene("across N⁴", variables=(*invariants, "x_1", "x_2")).adjoining(ROOT)


def offer() -> ClosedForm:
    """The closed form, with the relations (16) and the cofactors of the first paper."""
    return ClosedForm(
        equations=Values(initial, tuple(rf"\dot{{{name}}}" for name in STATE), STATE),
        integrals=Values(with_relations, ("H", "K", "a^2", "b^2", "c", "G", "N_1", "N_2"), STATE),
        constants=Values(
            with_G, ("x_1x_2", "x_1x_2+z_1z_2", "w_1w_2", "H", "G", "p^2", "c_1c_2"), STATE
        ),
        phase_point=Values(point, (*velocity, *fields), by, supplied),
        complex_variables=Values(initial, known, (*STATE, "i")),
        across=Values(beside, invariants, (*known, ROOT)),
        across_rates=Values(linear, (*F_prime,), (*linear.variables, ROOT)),
    )
