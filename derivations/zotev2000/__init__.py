"""D. B. Zotev (2000): the tori of Bogoyavlensky's case, K = 0."""

from kowalevski_cas.paper.closed_form import LevelsOnM4
from kowalevski_cas.paper.derivation import Derivation

from ..kharlamov2002 import derivation as kharlamov2002
from ..kharlamov2005 import derivation as kharlamov2005
from ..kharlamov_savushkin2004 import derivation as kharlamov_savushkin2004
from . import angles, coincidences, levels

derivation = Derivation(
    name="zotev2000",
    title="Fomenko-Zieschang invariant in the Bogoyavlenskyi case",
    author="D. B. Zotev",
    source=(
        "the subject is that of Regul. Chaotic Dyn. 5 (2000); the formulas are derived anew, "
        "in the notation of Kharlamov (2002)"
    ),
    sections=(levels.section, angles.section, coincidences.section),
    rests_on=(kharlamov2002, kharlamov_savushkin2004, kharlamov2005),
    offers={LevelsOnM4: levels.offer},
)
