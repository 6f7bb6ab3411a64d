"""The equations of the critical set, as they are computed with."""

from kowalevski_cas.paper.closed_form import CriticalSets, Member, Values

from ..kharlamov_savushkin2004.setting import complex_variables
from .critical_set import N4, O4, at_critical, zero_level

known = complex_variables.variables


def offer() -> CriticalSets:
    """The left sides of the equations of M⁴, N⁴ and O⁴."""
    return CriticalSets(
        M4=Values(at_critical, tuple(Member(printed, 0) for printed in zero_level), known),
        N4=Values(at_critical, tuple(Member(printed, 0) for printed in N4), known),
        O4=Values(at_critical, tuple(Member(printed, 0) for printed in O4), (*known, r"\mu")),
    )
