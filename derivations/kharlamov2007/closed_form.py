"""The formulas by which motions on O^4 are computed; none is typed here a second time."""

from kowalevski_cas.paper.closed_form import HyperellipticForm, Values
from kowalevski_cas.paper.derivation import Scene

from ..kharlamov2005.stability import by_constants
from ..kharlamov2005.third_subsystem import with_constants
from ..kharlamov2005.values import on_O4_values
from ..kharlamov_savushkin2004.setting import complex_variables
from .factors import by_halves, by_roots, factor_products, factored_parts
from .infinity import hatted_fields, hatted_parts, hatted_velocity
from .separation import root

RADICALS = (
    "\\mu_1",
    "A_1",
    "B_1",
    "K_1",
    "\\hat{\\mu}_2",
    "\\hat{A}_2",
    "\\hat{B}_2",
    "\\hat{K}_2",
)
PARTS = tuple(rf"\hat{{{name}}}" for name in (r"\Pi", "Y", "V", "d", "T", r"\Lambda", "N"))
FACTORS = ("S_1", "D_1", "\\hat{S}_2", "\\hat{D}_2")
COORDINATES = ("u_1", "n", "v")
CONSTANTS = ("s", r"\tau_3", "p", "r")

here = Scene(
    "phase point on O⁴, supplied",
    variables=(*COORDINATES, *RADICALS, r"\hat{E}", *PARTS, *CONSTANTS, "vu_1-n", *FACTORS),
)

ROOTS = ("P_1", "Q_1", "\\hat{P}_2", "\\hat{Q}_2")
HALVES = ("a_1", "b_1", "a_2", "b_2")

quotients = Scene(
    "E on O⁴, supplied", variables=(*ROOTS, *HALVES, r"\sqrt{\sigma}", r"\rho", "vu_1+n")
)

values = Scene("constants of O⁴", variables=CONSTANTS)

plane = Scene("X, ξ, q", variables=("X", r"\xi", r"\tau_3", r"\sigma", "q"))


def offer() -> HyperellipticForm:
    """The closed form, with the constants of the third subsystem."""
    return HyperellipticForm(
        constants=Values(
            with_constants, ("s", r"\tau_3", "x_1x_2", "x_1x_2+z_1z_2"), complex_variables.variables
        ),
        variables=Values(
            plane,
            (root[1], r"\tau_3\xi+q", r"\tau_3\xi-q", r"\tau_3-X", r"\tau_3\xi^2+\sigma X"),
            plane.variables,
        ),
        integrals=Values(values, (*on_O4_values,), CONSTANTS),
        curvature=Values(values, (by_constants[1],), CONSTANTS),
        products=Values(here, (*factor_products,), ("K_1", r"\hat{K}_2", "s", r"\tau_3", "r")),
        resolvents=Values(here, (factored_parts[1], factored_parts[2]), (*FACTORS, "s")),
        parts=Values(
            here,
            (*(factored_parts[k] for k in (3, 4, 5)), *(hatted_parts[k] for k in (5, 6, 7))),
            ("v", *RADICALS, *CONSTANTS, r"\hat{d}"),
        ),
        quotients=Values(
            quotients,
            (*by_roots,),
            (*ROOTS, r"\sqrt{\sigma}", "vu_1+n"),
            (r"\sqrt{\sigma}", "vu_1+n"),
        ),
        conjugate_quotients=Values(
            quotients, (*by_halves,), (*HALVES, r"\rho", "vu_1+n"), ("vu_1+n",)
        ),
        phase_point=Values(
            here,
            (*hatted_velocity, *hatted_fields),
            (*RADICALS, r"\hat{E}", *PARTS, "s", r"\tau_3", "r", "vu_1-n"),
            ("vu_1-n",),
        ),
    )
