r"""1. The third integral on the first two critical subsystems, M^4 and N^4."""

from kowalevski_cas.paper.claims import Implication
from kowalevski_cas.paper.derivation import Section

from ..kharlamov2002.section1 import eq7
from ..kharlamov2002.section2 import eq15
from ..kharlamov_savushkin2004.setting import p
from ..kharlamov_savushkin2004.third_integral import by_functions, level, real, solved

section = Section("1", "The first two critical subsystems", copied=False)

on_M4 = section.display("on-M4", r"k = 0, \quad p^2h-2g = \frac12j^2")

on_N4 = section.display("on-N4", r"(2g-p^2h)^2 = r^4k")

section.states(
    Implication,
    on_M4,
    on=real.adjoining(p),
    says="the integrals on $M^4$, where $J_3=j$",
    ids=("M4.k", "M4.g"),
    given=(*eq7,),
    main=((r"\alpha_1", r"\alpha_2"),),
)

section.states(
    Implication,
    on_N4,
    on=by_functions.naming("h", level[1]).naming("g", solved[1]).naming("k", solved[2]),
    says="the integrals on $N^4$",
    ids=("N4.g",),
    given=(*eq15,),
)
