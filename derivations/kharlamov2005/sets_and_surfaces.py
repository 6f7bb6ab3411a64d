"""The equations of the critical set and the critical values, as they are computed with."""

from kowalevski_cas.paper.closed_form import CriticalSets, Member, Values
from kowalevski_cas.paper.derivation import Scene
from kowalevski_cas.paper.texts import Printed

from ..kharlamov_savushkin2004.separation import relations
from ..kharlamov_savushkin2004.setting import complex_variables
from .critical_set import N4, O4, at_critical, zero_level
from .first_two import on_M4

known = complex_variables.variables

constants = Scene(
    "constants",
    constants=("h", "k", "g", "j", "m", r"\ell", "p", "r"),
)


def sides(place: int, *printed: Printed) -> tuple[Member, ...]:
    """The left sides of relations, 0, or their right sides, 1."""
    return tuple(Member(one, place) for one in printed)


def offer() -> CriticalSets:
    """The left sides of the equations of M⁴, N⁴ and O⁴, and values of the integrals."""
    return CriticalSets(
        M4=Values(at_critical, sides(0, *zero_level), known),
        N4=Values(at_critical, sides(0, *N4), known),
        O4=Values(at_critical, sides(0, *O4), (*known, r"\mu")),
        M4_values=Values(constants, sides(1, *on_M4), ("j",)),
        N4_values=Values(constants, sides(1, relations[1], relations[2]), ("m", "r")),
    )
