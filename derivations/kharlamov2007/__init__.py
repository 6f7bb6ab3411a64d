"""M. P. Kharlamov (2007): the motions on O^4, separated; the whole phase point."""

from kowalevski_cas.paper.closed_form import HyperellipticForm
from kowalevski_cas.paper.derivation import Derivation

from ..kharlamov2002 import derivation as kharlamov2002
from ..kharlamov2005 import derivation as kharlamov2005
from ..kharlamov_savushkin2004 import derivation as kharlamov_savushkin2004
from . import closed_form, converse, factors, infinity, phase_point, separation

derivation = Derivation(
    name="kharlamov2007",
    title="Separation of variables in the generalized 4th Appelrot class",
    author="M. P. Kharlamov",
    source="Regul. Chaotic Dyn. 12 (2007), restated in the notation of Kharlamov (2002)",
    sections=(
        separation.section,
        phase_point.section,
        infinity.section,
        converse.section,
        factors.section,
    ),
    rests_on=(kharlamov2002, kharlamov_savushkin2004, kharlamov2005),
    offers={HyperellipticForm: closed_form.offer},
)
