r"""3. The classical analogue: one field, and the 2nd and 3rd classes of Appelrot."""

from kowalevski_cas.claims import (
    Dimension,
    Equivalence,
    FirstIntegral,
    Identity,
    Implication,
)
from kowalevski_cas.derivation import Locus, Scene, Section

from .section1 import ALPHA, FRAME, KOWALEVSKI, OMEGA, eq2, eq3, eq4
from .section2 import eq16, eq17, xi

section = Section("3", "The classical analogue")

one_field_only = section.inline("beta", r"{\bs \beta} = 0")

eq18 = section.display("eq18", r"""
\displaystyle{(\alpha _1^2  + \alpha _2^2 )\omega _3 - 2(\alpha _1
\omega _1  + \alpha _2 \omega _2 )\alpha _3  =
0,}""")

eq19 = section.display("eq19", r"""
\displaystyle{2\alpha _1 \alpha _2 (\omega _1^2  - \omega _2^2  +
\alpha _1 ) - (\alpha _1^2  - \alpha _2^2 )(2\omega _1 \omega _2  +
\alpha _2 ) = 0}""")

norm = section.inline("norm", r"{( {\bs \alpha},{\bs \alpha}) = 1}")

ratio = section.display("ratio", r"""
\displaystyle{ \frac{\omega _1^2 - \omega _2^2 + \alpha _1 }{\alpha
_1^2  - \alpha _2^2}=\frac{2\omega _1 \omega _2 + \alpha _2
}{2\alpha _1 \alpha _2}}""")

eq20 = section.display("eq20", r"""
\begin{array}{c}
\displaystyle{\omega _1^2  - \omega _2^2  + \alpha _1  = {\frac {\alpha _1^2  - \alpha _2^2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k},}  \\
\displaystyle{2\omega _1 \omega _2  + \alpha _2  = {\frac{2\alpha _1
\alpha _2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k}.}
\end{array}""")

area = section.display("area", r"""
L = \alpha _1 \omega _1  + \alpha _2 \omega _2  + \frac{1}{2}\alpha
_3 \omega _3  \equiv \ell.""")

Psi = section.inline("Psi", r"\Psi  = 2L^2  - H")

eq21 = section.display("eq21", r"""
\begin{array}{l}
\displaystyle{\Psi  =  - \frac{1}{2} (\alpha _1^2  + \alpha _2^2
)[\omega _3 - 2{\frac{\alpha _1 \omega _1  + \alpha _2 \omega _2 }
{\alpha _1^2  + \alpha _2^2 }}]^2  +}   \\[2mm]
\displaystyle{\phantom{\Psi=} + \frac{1} {\alpha _1^2  + \alpha _2^2
} [(\alpha_1^2 - \alpha _2^2 )(\omega _1^2  - \omega _2^2  + \alpha
_1 ) + 2\alpha _1 \alpha _2 (2\omega _1 \omega _2  + \alpha _2 )].}
\end{array}""")

eq22 = section.display("eq22", r"2\ell^2  - h = \sqrt {k}.")

combined = section.inline("combined-integral", r"(2L^2  - H)^2  - K")

# -- scenes --------------------------------------------------------------------

POLES = Locus(
    r"$\alpha_1=\alpha_2=0$", (r"\alpha_1=0", r"\alpha_2=0"), r"\alpha_1^2+\alpha_2^2"
)

ONE_FIELD = {
    **KOWALEVSKI,
    "c": eq4[3],
    r"\xi_1": xi[1],
    r"\xi_2": xi[2],
    "H": eq17[1],
    "h": eq17[1],
    "K": eq17[2],
    "k": eq17[2],
    "L": area[1],
    r"\ell": area[1],
    r"\Psi": Psi[1],
}

one_field = Scene(
    "one field",
    "the Kowalevski case for $\\beta=0$, where $h$, $k$, $\\ell$ are the values of the integrals",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    constants=("a", "b"),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    definitions=ONE_FIELD,
    roots={"a": eq4[1], "b": eq4[2]},
    nonzero=("a^2",),
    loci=(POLES,),
)

with_root_of_k = Scene(
    "one field, with the root of k",
    "the Kowalevski case for $\\beta=0$ with $\\sqrt{k}$, one of the two roots of the integral $K$",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    definitions=ONE_FIELD,
    roots={r"\sqrt{k}": None},
    loci=(POLES,),
)

unit_field = Scene(
    "one unit field",
    "the Kowalevski case for $\\beta=0$ and $(\\alpha,\\alpha)=1$",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    definitions=ONE_FIELD,
    roots={r"\alpha_3": norm[1]},
    loci=(POLES,),
)

free_k = Scene(
    "one unit field, any k",
    "the same, where $k$ is any number and $\\sqrt{k}$ one of its roots",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    constants=("k",),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    definitions={name: printed for name, printed in ONE_FIELD.items() if name != "k"},
    roots={r"\alpha_3": norm[1], r"\sqrt{k}": None},
    loci=(POLES,),
)

reduced_space = Scene(
    "reduced phase space",
    "the Euler–Poisson variables in the space of all six, $(\\alpha,\\alpha)$ being an integral",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    definitions=ONE_FIELD,
    loci=(POLES,),
)

# -- claims --------------------------------------------------------------------

section.claim(
    Equivalence("eq18", one_field, eq18[1], r"the first relation (16) for $\beta=0$", to=eq16[1]),
    Equivalence("eq19", one_field, eq19[1], r"the second relation (16) for $\beta=0$", to=eq16[2]),
    Equivalence("ratio", one_field, ratio[1], "the relation (19) as an equality of ratios", to=eq19[1]),
    Implication(
        "eq20.1",
        with_root_of_k,
        eq20[1],
        "it follows from (19) and $K=k$, for one of the two roots",
        given=(eq19[1],),
        root=r"\sqrt{k}",
    ),
    Implication(
        "eq20.2",
        with_root_of_k,
        eq20[2],
        "it follows from (19) and $K=k$, for the same root",
        given=(eq19[1],),
        root=r"\sqrt{k}",
        together=(eq20[1],),
    ),
    FirstIntegral("area", one_field, area[1], "the area integral of the classical problem"),
    Identity("eq21", unit_field, eq21[1], r"$\Psi=2L^2-H$ as a square and a remainder"),
    Implication(
        "eq22",
        free_k,
        eq22[1],
        "it follows from (18) and (20)",
        given=(eq18[1], eq20[1], eq20[2]),
        main=((r"\omega_3", r"\omega_1", r"\omega_2"),),
    ),
    Dimension(
        "appelrot-dimension",
        reduced_space,
        None,
        "in the five-dimensional reduced phase space (18), (19) define a set of dimension three",
        levels=(norm[1],),
        equations=(eq18[1], eq19[1]),
        dimension=3,
    ),
    Implication(
        "redundant-integral",
        unit_field,
        combined[1],
        "on (18), (19) the classical integrals are dependent: this combination vanishes",
        given=(eq18[1], eq19[1]),
        main=((r"\omega_3",),),
    ),
)
