"""The equations of the critical set and the critical values, as they are computed with."""

from kowalevski_cas.paper.closed_form import CriticalSets, Values
from kowalevski_cas.paper.derivation import Scene

from ..kharlamov_savushkin2004.separation import relations
from ..kharlamov_savushkin2004.setting import complex_variables
from .critical_set import at_critical, zero_level
from .first_two import on_M4

known = complex_variables.variables

with_M4 = at_critical.naming("M_1", zero_level[1]).naming("M_2", zero_level[2])

constants = Scene("constants", constants=("h", "k", "g", "j", "m", r"\ell", "p", "r"))


def offer() -> CriticalSets:
    """The left sides of the equations of M⁴, N⁴ and O⁴, and values of the integrals."""
    return CriticalSets(
        M4=Values(with_M4, ("M_1", "M_2"), known),
        N4=Values(at_critical, ("N_1", "N_2"), known),
        O4=Values(at_critical, ("E_1", "E_2", "E_3", "E_4", "E_5"), (*known, r"\mu")),
        M4_values=Values(constants, (*on_M4,), ("j",)),
        N4_values=Values(constants, (relations[1], relations[2]), ("m", "r")),
    )
