"""M. P. Kharlamov (2005): the critical set of the integrals of the top."""

from kowalevski_cas.paper.closed_form import CriticalSets
from kowalevski_cas.paper.derivation import Derivation

from ..kharlamov2002 import derivation as kharlamov2002
from ..kharlamov_savushkin2004 import derivation as kharlamov_savushkin2004
from . import critical_set, first_two, sets_and_surfaces, stability, third_subsystem, values

derivation = Derivation(
    name="kharlamov2005",
    title="Bifurcation diagrams of the Kowalevski top in two constant fields",
    author="M. P. Kharlamov",
    source="Regul. Chaotic Dyn. 10 (2005), restated in the notation of Kharlamov (2002)",
    sections=(
        first_two.section,
        third_subsystem.section,
        values.section,
        critical_set.section,
        stability.section,
    ),
    rests_on=(kharlamov2002, kharlamov_savushkin2004),
    offers={CriticalSets: sets_and_surfaces.offer},
)
