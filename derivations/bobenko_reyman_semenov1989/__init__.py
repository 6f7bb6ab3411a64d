"""A. I. Bobenko, A. G. Reyman, M. A. Semenov-Tian-Shansky (1989): the Lax pair of the top."""

from kowalevski_cas.paper.derivation import Derivation

from ..kharlamov2002 import derivation as kharlamov2002
from ..kharlamov_savushkin2004 import derivation as kharlamov_savushkin2004
from . import lax_pair

derivation = Derivation(
    name="bobenko_reyman_semenov1989",
    title="The Kowalewski top 99 years later: a Lax pair, generalizations and explicit solutions",
    author="A. I. Bobenko, A. G. Reyman, M. A. Semenov-Tian-Shansky",
    source="Commun. Math. Phys. 122 (1989), restated in the notation of Kharlamov (2002)",
    sections=(lax_pair.section,),
    rests_on=(kharlamov2002, kharlamov_savushkin2004),
)
