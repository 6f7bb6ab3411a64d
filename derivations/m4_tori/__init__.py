"""The tori of Bogoyavlensky's case, K = 0, derived here: no paper is restated."""

from kowalevski_cas.paper.closed_form import LevelsOnM4
from kowalevski_cas.paper.derivation import Derivation

from ..kharlamov2002 import derivation as kharlamov2002
from ..kharlamov2005 import derivation as kharlamov2005
from ..kharlamov_savushkin2004 import derivation as kharlamov_savushkin2004
from . import angles, coincidences, levels

derivation = Derivation(
    name="m4_tori",
    title="The levels and the tori of the class K = 0",
    author="Derived by the kowalevski_cas authors",
    source=(
        "O. I. Bogoyavlensky's class of 1984, in the notation of Kharlamov (2002); its topology is the "
        "subject of D. B. Zotev, Regul. Chaotic Dyn. 5 (2000)"
    ),
    sections=(levels.section, angles.section, coincidences.section),
    rests_on=(kharlamov2002, kharlamov_savushkin2004, kharlamov2005),
    offers={LevelsOnM4: levels.offer},
)
