"""M. P. Kharlamov, A. Yu. Savushkin (2004): the motions on N^4, separated and solved."""

from kowalevski_cas.paper.closed_form import ClosedForm
from kowalevski_cas.paper.derivation import Derivation

from ..kharlamov2002 import derivation as kharlamov2002
from . import (
    across,
    bifurcation,
    closed_form,
    elliptic,
    phase_point,
    reduction,
    separation,
    setting,
    third_integral,
)

derivation = Derivation(
    name="kharlamov_savushkin2004",
    title=(
        "Separation of variables and integral manifolds in one partial problem of motion "
        "of the generalized Kowalevski top"
    ),
    author="M. P. Kharlamov, A. Yu. Savushkin",
    source="Ukr. Math. Bull. 1 (2004), restated in the notation of Kharlamov (2002)",
    sections=(
        setting.section,
        third_integral.section,
        separation.section,
        reduction.section,
        phase_point.section,
        elliptic.section,
        bifurcation.section,
        across.section,
    ),
    rests_on=(kharlamov2002,),
    offers={ClosedForm: closed_form.offer},
)
