r"""7. Where regimes meet: the separating curves as coincidences of roots."""

from kowalevski_cas.paper.claims import Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section

from .elliptic import roots_of_phi
from .phase_point import p_without_c
from .phase_point import r as r_without_c
from .separation import phi

section = Section("7", "The separating curves", copied=False)

energy = section.lemma(
    "energy-of-m", r"h = \frac{\ell^2-1-2p^2m^2}{2m}", "the last of the relations solved for $h$"
)

values = (
    Scene("constants", constants=("a", "b", "m", r"\ell"), nonzero=("m",))
    .adjoining(r_without_c, p_without_c)
    .defining(energy, phi, roots_of_phi)
)

distance = section.states(
    Identity,
    section.lemma("distance", r"A-C = \frac1m", r"the roots of $\varphi$ never meet"),
    on=values,
    says=r"the roots of $\varphi$ never meet",
)

resultants = section.states(
    Identity,
    section.lemma(
        "resultants",
        r"""
\varphi(a)\varphi(-a) = 4(h-r^2m-2a)(h-r^2m+2a), \quad
\varphi(b)\varphi(-b) = 4(h+r^2m-2b)(h+r^2m+2b)""",
        "where $A$ or $C$ meets $\\pm a$, and where $\\pm b$",
    ),
    on=values,
    says=r"a root of $\varphi$ meets $\pm a$ on two curves, and $\pm b$ on two others",
    ids=("resultant.a", "resultant.b"),
)

lines = section.display(
    "lines",
    r"""
\ell = 2am+1, \quad \ell = 2am-1, \quad \ell = -2am+1, \quad \ell = -2am-1, \quad
\ell = 2bm+1, \quad \ell = 2bm-1, \quad \ell = -2bm+1, \quad \ell = -2bm-1, \quad \ell = 0""",
)

curves = section.display(
    "curves",
    r"""
h = r^2m+2a, \quad h = r^2m-2a, \quad h = -r^2m+2b, \quad h = -r^2m-2b, \quad
h = -p^2m-\frac{1}{2m}""",
)

ON = (1, 2, 2, 1, 3, 4, 4, 3, 5)
"""On which of the curves each of the lines is."""

for k, (line, curve) in enumerate(zip(lines, ON, strict=True), 1):
    section.states(
        Implication,
        curves[curve],
        on=values,
        says=f"the curve on which ${line.tex}$",
        ids=(f"curve.{k}",),
        given=(line,),
    )
