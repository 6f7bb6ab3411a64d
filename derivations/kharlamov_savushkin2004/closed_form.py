"""The formulas by which motions are computed; none is typed here a second time."""

from dataclasses import replace

from kowalevski_cas.library import load
from kowalevski_cas.paper.closed_form import ClosedForm, Member, Values
from kowalevski_cas.paper.derivation import Scene

from .elliptic import CN, DN, SN, jacobi, jacobi_rates
from .phase_point import fields, velocity
from .setting import ALPHA, BETA, COMPLEX, OMEGA, X, initial, unit
from .third_integral import real

STATE = (*OMEGA, *ALPHA, *BETA)
ROOT = r"\sqrt{x_1x_2}"

supplied = ("s_1s_2-a^2", "s_1s_2-b^2", r"\ell-2ms_1", r"\ell-2ms_2", "rS_2")
by = ("S_1", "S_2", "f_1", "f_2", "d", r"\psi", *supplied, "r")
known = (*X, r"\omega_3")
invariants = ("F_1", "F_2", "U_1", "U_2")

point = Scene(
    "phase point, supplied",
    "the radicals, and parts of the formulas, as variables",
    variables=(*by, "s_1", "s_2", "a", "b", "m", r"\ell"),
)

functions = Scene(
    "Jacobi's functions",
    "sn, cn, dn as variables",
    variables=(SN, CN, DN),
    constants=("n", "k"),
    field=(jacobi[3], jacobi_rates[1], jacobi_rates[2]),
)

with_G = replace(
    initial, vectors=real.vectors, definitions={**initial.definitions, **real.definitions}
)

beside = Scene(
    "beside N⁴",
    "the variables (9) with $\\sqrt{x_1x_2}$",
    variables=known,
    unit=unit[1],
    roots={ROOT: None},
    definitions=COMPLEX,
)

linear = Scene(
    "across N⁴",
    "$F_1$, $F_2$, $U_1$, $U_2$ as variables",
    variables=(*invariants, "x_1", "x_2"),
    roots={ROOT: None},
)


def offer() -> ClosedForm:
    """The closed form, with the relations (16) and the cofactors from Kharlamov (2002)."""
    printed = {display.id: display for display in load("kharlamov2002").displays()}
    xi, eq16, cofactors = printed["xi"], printed["eq16"], printed["F-prime"]
    with_xi = replace(
        initial, definitions={**initial.definitions, r"\xi_1": xi[1], r"\xi_2": xi[2]}
    )
    return ClosedForm(
        equations=Values(initial, tuple(rf"\dot{{{name}}}" for name in STATE), STATE),
        integrals=Values(
            with_xi, ("H", "K", "a^2", "b^2", "c", Member(eq16[1], 0), Member(eq16[2], 0)), STATE
        ),
        constants=Values(
            with_G, ("x_1x_2", "x_1x_2+z_1z_2", "w_1w_2", "H", "G", "p^2", "c_1c_2"), STATE
        ),
        phase_point=Values(
            point,
            tuple(
                Member(display[k], 1)
                for display, count in ((velocity, 3), (fields, 6))
                for k in range(1, count + 1)
            ),
            by,
            supplied,
        ),
        jacobi_rates=Values(
            functions, tuple(rf"\dot{{{name}}}" for name in (SN, CN, DN)), (SN, CN, DN, "n", "k")
        ),
        complex_variables=Values(initial, known, (*STATE, "i")),
        across=Values(beside, invariants, (*known, ROOT)),
        across_rates=Values(
            linear, (Member(cofactors[1], 1), Member(cofactors[2], 1)), (*linear.variables, ROOT)
        ),
    )
