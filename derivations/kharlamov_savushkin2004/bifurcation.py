r"""7. Where regimes meet: the separating curves as coincidences of roots."""

from kowalevski_cas.paper.claims import Identity, Implication
from kowalevski_cas.paper.derivation import Scene, Section

from .elliptic import roots_of_phi
from .phase_point import p_without_c
from .phase_point import r as r_without_c
from .separation import phi

section = Section("7", "The separating curves")

LINES = (
    r"\ell = 2am+1",
    r"\ell = 2am-1",
    r"\ell = -2am+1",
    r"\ell = -2am-1",
    r"\ell = 2bm+1",
    r"\ell = 2bm-1",
    r"\ell = -2bm+1",
    r"\ell = -2bm-1",
    r"\ell = 0",
)

lines = section.display("lines", r", \quad ".join(LINES))

curves = section.display(
    "curves",
    r"""
h = r^2m+2a, \quad h = r^2m-2a, \quad h = -r^2m+2b, \quad h = -r^2m-2b, \quad
h = -p^2m-\frac{1}{2m}""",
)

resultants = section.lemma(
    "resultants",
    r"""
\varphi(a)\varphi(-a) = 4(h-r^2m-2a)(h-r^2m+2a), \quad
\varphi(b)\varphi(-b) = 4(h+r^2m-2b)(h+r^2m+2b)""",
    "where $A$ or $C$ meets $\\pm a$, and where $\\pm b$",
)

distance = section.lemma("distance", r"A-C = \frac1m", r"the roots of $\varphi$ never meet")

energy = section.lemma(
    "energy", r"h = \frac{\ell^2-1-2p^2m^2}{2m}", "the last of the relations solved for $h$"
)

# -- scenes --------------------------------------------------------------------

values = Scene(
    "constants",
    "the constants of a motion on $N^4$ for $c=0$, where $m$ is not zero",
    constants=("a", "b", "m", r"\ell"),
    roots={"r": r_without_c[1], "p": p_without_c[1]},
    nonzero=("m",),
    definitions={
        "h": energy[1],
        r"\varphi(s)": phi[1],
        "A": roots_of_phi[1],
        "C": roots_of_phi[2],
    },
)

# -- claims --------------------------------------------------------------------

WHERE = (1, 2, 2, 1, 3, 4, 4, 3, 5)
"""On which of the curves each of the lines is."""

section.claim(
    Identity("distance", values, distance[1], r"the distance of the roots of $\varphi$"),
    Identity(
        "resultant.a", values, resultants[1], r"a root of $\varphi$ meets $\pm a$ on two curves"
    ),
    Identity(
        "resultant.b", values, resultants[2], r"a root of $\varphi$ meets $\pm b$ on two curves"
    ),
    *(
        Implication(
            f"curve.{k}",
            values,
            curves[curve],
            f"the curve on which ${line}$",
            given=(lines[k],),
        )
        for k, (line, curve) in enumerate(zip(LINES, WHERE, strict=True), 1)
    ),
)
