r"""3. The classical analogue: one field, and the 2nd and 3rd classes of Appelrot."""

from kowalevski_cas.paper.claims import (
    ConstantRoot,
    CriticalSet,
    Dimension,
    Equivalence,
    FirstIntegral,
    Identity,
    Implication,
    InvariantRelations,
    Limit,
)
from kowalevski_cas.paper.derivation import Locus, Scene, Section

from .section1 import ALPHA, FRAME, KOWALEVSKI, OMEGA, eq2, eq3, eq4
from .section2 import CHANGE, F1, F2, N4, c, eq11, eq13, eq16, eq17, tau, unit, xi

section = Section("3", "The classical analogue")

one_field_only = section.inline("beta", r"{\bs \beta} = 0")

eq18 = section.display(
    "eq18",
    r"""
\displaystyle{(\alpha _1^2  + \alpha _2^2 )\omega _3 - 2(\alpha _1
\omega _1  + \alpha _2 \omega _2 )\alpha _3  =
0,}""",
)

eq19 = section.display(
    "eq19",
    r"""
\displaystyle{2\alpha _1 \alpha _2 (\omega _1^2  - \omega _2^2  +
\alpha _1 ) - (\alpha _1^2  - \alpha _2^2 )(2\omega _1 \omega _2  +
\alpha _2 ) = 0}""",
)

norm = section.inline("norm", r"{( {\bs \alpha},{\bs \alpha}) = 1}")

ratio = section.display(
    "ratio",
    r"""
\displaystyle{ \frac{\omega _1^2 - \omega _2^2 + \alpha _1 }{\alpha
_1^2  - \alpha _2^2}=\frac{2\omega _1 \omega _2 + \alpha _2
}{2\alpha _1 \alpha _2}}""",
)

eq20 = section.display(
    "eq20",
    r"""
\begin{array}{c}
\displaystyle{\omega _1^2  - \omega _2^2  + \alpha _1  = {\frac {\alpha _1^2  - \alpha _2^2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k},}  \\
\displaystyle{2\omega _1 \omega _2  + \alpha _2  = {\frac{2\alpha _1
\alpha _2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k}.}
\end{array}""",
)

area = section.display(
    "area",
    r"""
L = \alpha _1 \omega _1  + \alpha _2 \omega _2  + \frac{1}{2}\alpha
_3 \omega _3  \equiv \ell.""",
)

Psi = section.inline("Psi", r"\Psi  = 2L^2  - H")

eq21 = section.display(
    "eq21",
    r"""
\begin{array}{l}
\displaystyle{\Psi  =  - \frac{1}{2} (\alpha _1^2  + \alpha _2^2
)[\omega _3 - 2{\frac{\alpha _1 \omega _1  + \alpha _2 \omega _2 }
{\alpha _1^2  + \alpha _2^2 }}]^2  +}   \\[2mm]
\displaystyle{\phantom{\Psi=} + \frac{1} {\alpha _1^2  + \alpha _2^2
} [(\alpha_1^2 - \alpha _2^2 )(\omega _1^2  - \omega _2^2  + \alpha
_1 ) + 2\alpha _1 \alpha _2 (2\omega _1 \omega _2  + \alpha _2 )].}
\end{array}""",
)

eq22 = section.display("eq22", r"2\ell^2  - h = \sqrt {k}.")

combined = section.inline("combined-integral", r"(2L^2  - H)^2  - K")

# What the paper uses of Kowalevski's separation of variables, in the complex variables (9).

squares = section.lemma(
    "appelrot-squares",
    r"w_1^2+x_1=\frac{x_1}{x_2}\sqrt{k}, \quad w_2^2+x_2=\frac{x_2}{x_1}\sqrt{k}",
    "equations (20) in the variables (9)",
)

area_on_set = section.lemma(
    "appelrot-area",
    r"\ell=\frac{x_1w_2+x_2w_1}{2x_1x_2}",
    "the area integral on (18)",
)

h_on_set = section.lemma("appelrot-energy", r"h=2\ell^2-\sqrt{k}", "equation (22)")

separation = section.lemma(
    "kowalevski-polynomials",
    r"""
R_1=-w_1^4+2hw_1^2+4\ell w_1+1-k, \quad R_2=-w_2^4+2hw_2^2+4\ell w_2+1-k, \quad
R_{12}=-w_1^2w_2^2+2hw_1w_2+2\ell(w_1+w_2)+1-k""",
    "S. Kowalevski, Acta Math. 12 (1889), pp. 177–232, in the units of the paper",
)

separation_variables = section.lemma(
    "kowalevski-variables",
    r"[2(w_1-w_2)^2s-R_{12}]^2=R_1R_2",
    "S. Kowalevski, Acta Math. 12 (1889): $s_1$, $s_2$ less a constant are the roots",
)

# -- scenes --------------------------------------------------------------------

POLES = Locus(r"$\alpha_1=\alpha_2=0$", (r"\alpha_1=0", r"\alpha_2=0"), r"\alpha_1^2+\alpha_2^2")

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

complex_unit_field = Scene(
    "one unit field, complex",
    "the same with $i$ and the variables (9)",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    constants=("k",),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    unit=unit[1],
    definitions={**CHANGE, **free_k.definitions},
    roots=free_k.roots,
    loci=(POLES,),
)

appelrot = Scene(
    "Appelrot's motions",
    "the set (18), (20) by $x_1$, $x_2$ and $\\sqrt{k}$: $w_1$, $w_2$ are square roots on it",
    variables=("x_1", "x_2", "w_1", "w_2"),
    constants=("k", "s"),
    roots={r"\sqrt{k}": None, "w_1": squares[1], "w_2": squares[2]},
    definitions={
        r"\ell": area_on_set[1],
        "h": h_on_set[1],
        "R_1": separation[1],
        "R_2": separation[2],
        "R_{12}": separation[3],
    },
)

limit_scene = Scene(
    "the limit",
    "the Kowalevski case for $\\beta=0$ with the variables (9), $i$ and $\\sqrt{x_1x_2}$",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA),
    field=(eq2[1], eq3[1], eq3[2]),
    zero=(one_field_only[1],),
    unit=unit[1],
    clock=tau[1],
    definitions={
        **KOWALEVSKI,
        **CHANGE,
        r"\theta": eq11[1],
        "Q_1": eq11[2],
        "c_1": c[1],
        "c_2": c[2],
        "U_1": eq13[1],
        "U_2": eq13[2],
        "F_1": F1[1],
        "F_2": F2[1],
    },
    roots={r"\sqrt{x_1x_2}": None},
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
    Equivalence(
        "ratio", one_field, ratio[1], "the relation (19) as an equality of ratios", to=eq19[1]
    ),
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
    CriticalSet(
        "critical-set",
        reduced_space,
        combined[1],
        "(18), (19) is exactly the set of its critical points on the reduced phase space",
        equations=(eq18[1], eq19[1]),
        level=norm[1],
        main=((r"\omega_3",),),
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
    Implication(
        "appelrot-squares.1",
        complex_unit_field,
        squares[1],
        "the equations (20) in the complex variables",
        given=(eq20[1], eq20[2]),
    ),
    Implication(
        "appelrot-squares.2",
        complex_unit_field,
        squares[2],
        "the equations (20) in the complex variables",
        given=(eq20[1], eq20[2]),
    ),
    Implication(
        "appelrot-area",
        complex_unit_field,
        area_on_set[1],
        "the area integral on (18)",
        given=(eq18[1],),
        main=((r"\omega_3",),),
    ),
    ConstantRoot(
        "kowalevski-variable",
        appelrot,
        separation_variables[1],
        "on (18), (19) one of Kowalevski's variables stays constant",
        unknown="s",
        basis=("h", r"\sqrt{k}", "1"),
    ),
    Limit(
        "limit",
        limit_scene,
        None,
        r"the limit $\beta\to 0$ commutes with the derivation of the cofactor matrix",
        general=N4,
        special=InvariantRelations(
            "limit/direct",
            reduced_space,
            None,
            "the relations (18), (19) by themselves",
            relations=(eq18[1], eq19[1]),
            names=("E_1", "E_2"),
            main=((r"\omega_3",),),
        ),
    ),
)
