r"""3. The classical analogue: one field, and the 2nd and 3rd classes of Appelrot."""

from kowalevski_cas.paper.claims import (
    ConstantRoot,
    CriticalSet,
    Dimension,
    Equivalence,
    FirstIntegral,
    Implication,
    InvariantRelations,
    Limit,
)
from kowalevski_cas.paper.derivation import Locus, Scene, Section

from .section1 import eq4, kowalevski
from .section2 import F1, F2, N4, c, eq9, eq10, eq11, eq13, eq16, eq17, tau, unit, xi

section = Section("3", "The classical analogue")

one_field_only = section.inline("beta", r"{\bs \beta} = 0")

POLES = Locus(r"$\alpha_1=\alpha_2=0$", (r"\alpha_1=0", r"\alpha_2=0"), r"\alpha_1^2+\alpha_2^2")

classical = kowalevski.called("one field alone").restricted(one_field_only).having(loci=(POLES,))

with_values = (
    classical.called("one field")
    .having(nonzero=("a^2",))
    .redefining(eq17)
    .adjoining(eq4[1], eq4[2])
    .defining(eq4[3], xi)
)

NO_SECOND_FIELD = r"The invariant relations (\ref{eq16}) take the form"

eq18 = section.states(
    Equivalence,
    section.display(
        "eq18",
        r"""
\displaystyle{(\alpha _1^2  + \alpha _2^2 )\omega _3 - 2(\alpha _1
\omega _1  + \alpha _2 \omega _2 )\alpha _3  =
0,}""",
    ),
    on=with_values,
    says=r"the first relation (16) for $\beta=0$",
    to=eq16[1],
    sentence=NO_SECOND_FIELD,
)

eq19 = section.states(
    Equivalence,
    section.display(
        "eq19",
        r"""
\displaystyle{2\alpha _1 \alpha _2 (\omega _1^2  - \omega _2^2  +
\alpha _1 ) - (\alpha _1^2  - \alpha _2^2 )(2\omega _1 \omega _2  +
\alpha _2 ) = 0}""",
    ),
    on=with_values,
    says=r"the second relation (16) for $\beta=0$",
    to=eq16[2],
    sentence=NO_SECOND_FIELD,
)

norm = section.inline("norm", r"{( {\bs \alpha},{\bs \alpha}) = 1}")

ratio = section.states(
    Equivalence,
    section.display(
        "ratio",
        r"""
\displaystyle{ \frac{\omega _1^2 - \omega _2^2 + \alpha _1 }{\alpha
_1^2  - \alpha _2^2}=\frac{2\omega _1 \omega _2 + \alpha _2
}{2\alpha _1 \alpha _2}}""",
    ),
    on=with_values,
    says="the relation (19) as an equality of ratios",
    to=eq19[1],
    sentence=r"Write (\ref{eq19}) in the form",
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

with_root_of_k = (
    classical.called("one field, with the root of k").redefining(eq17).adjoining(r"\sqrt{k}")
)

TO_OBTAIN = "and substitute to the Kowalevski integral to obtain"

section.states(
    Implication,
    eq20[1],
    on=with_root_of_k,
    says="both follow from (19) and $K=k$, for the same one of the two roots",
    given=(*eq19,),
    root=r"\sqrt{k}",
    sentence=TO_OBTAIN,
)
section.states(
    Implication,
    eq20[2],
    on=with_root_of_k,
    says="both follow from (19) and $K=k$, for the same one of the two roots",
    given=(*eq19,),
    root=r"\sqrt{k}",
    together=(eq20[1],),
    sentence=TO_OBTAIN,
)

area = section.display(
    "area",
    r"""
L = \alpha _1 \omega _1  + \alpha _2 \omega _2  + \frac{1}{2}\alpha
_3 \omega _3  \equiv \ell.""",
)

Psi = section.inline("Psi", r"\Psi  = 2L^2  - H")

section.states(
    FirstIntegral,
    area,
    on=with_values,
    says="the area integral of the classical problem",
    sentence="Recall the classical area integral",
)

with_area = classical.defining(area, Psi)

reduced_space = with_area.called("reduced phase space").redefining(eq17)

unit_field = reduced_space.called("one unit field").solving(r"\alpha_3", norm[1])

eq21 = section.identity(
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
    on=unit_field,
    says=r"$\Psi=2L^2-H$ as a square and a remainder",
)

eq22 = section.display("eq22", r"2\ell^2  - h = \sqrt {k}.")

free_k = (
    with_area.called("one unit field, any k")
    .having(constants=("k",))
    .redefining(eq17)
    .solving(r"\alpha_3", norm[1])
    .adjoining(r"\sqrt{k}")
)

section.states(
    Implication,
    eq22,
    on=free_k,
    says="the relation of the constants that follows from (18) and (20)",
    given=(*eq18, *eq20),
    main=((r"\omega_3", r"\omega_1", r"\omega_2"),),
    sentence=r"""
Under the conditions (\ref{eq18}) and (\ref{eq20}) the last expression turns into the following""",
)

combined = section.inline("combined-integral", r"(2L^2  - H)^2  - K")

CRITICAL = r"""
Analyzing the structure of (\ref{eq21}) and (\ref{eq22}), we conclude that the three-dimensional
manifold (\ref{eq18}), (\ref{eq19}) is exactly the set of critical points of the combined first
integral $(2L^2  - H)^2 - K$"""

section.states(
    CriticalSet,
    combined,
    on=reduced_space,
    says=r"the zeros of (18), (19) are exactly the critical points of $(2L^2-H)^2-K$",
    ids=("critical-set",),
    equations=(*eq18, *eq19),
    level=norm[1],
    sentence=CRITICAL,
)
section.claim(
    Dimension(
        "appelrot-dimension",
        reduced_space,
        "in the five-dimensional reduced phase space the relations (18), (19) define a set of "
        "dimension three",
        levels=(*norm,),
        equations=(*eq18, *eq19),
        dimension=3,
        sentence=CRITICAL,
    )
)
section.states(
    Implication,
    combined,
    on=unit_field,
    says="on (18), (19) the classical integrals are dependent: this combination vanishes",
    ids=("redundant-integral",),
    given=(*eq18, *eq19),
    main=((r"\omega_3",),),
    sentence="In particular, one of the classic integrals on this manifold becomes redundant",
)

# What the paper uses of Kowalevski's separation of variables, in the complex variables (9).

complex_unit_field = free_k.called("one unit field, complex").with_unit(unit[1]).defining(eq9)

squares = section.states(
    Implication,
    section.lemma(
        "appelrot-squares",
        r"w_1^2+x_1=\frac{x_1}{x_2}\sqrt{k}, \quad w_2^2+x_2=\frac{x_2}{x_1}\sqrt{k}",
        "equations (20) in the variables (9)",
    ),
    on=complex_unit_field,
    says="the equations (20) in the complex variables",
    given=(*eq20,),
    ours=True,
)

area_on_set = section.states(
    Implication,
    section.lemma(
        "appelrot-area", r"\ell=\frac{x_1w_2+x_2w_1}{2x_1x_2}", "the area integral on (18)"
    ),
    on=complex_unit_field,
    says="the area integral on (18)",
    given=(*eq18,),
    main=((r"\omega_3",),),
    ours=True,
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

third_component = section.lemma(
    "appelrot-field",
    r"""
\alpha_3^2=1-x_1x_2, \quad z_1=\alpha_3, \quad z_2=\alpha_3, \quad
\omega_3=\frac{(x_1w_2+x_2w_1)\alpha_3}{x_1x_2}""",
    r"the norm, $\beta=0$ and (18) in the variables (9)",
)

appelrot = (
    Scene(
        "Appelrot's motions",
        variables=("x_1", "x_2", "w_1", "w_2"),
        constants=("k", "s"),
        time=r"\tau",
    )
    .moving(*(eq10[k] for k in (1, 2, 7, 8)))
    .having(conjugates=(("x_1", "x_2"), ("w_1", "w_2")))
    .adjoining(r"\sqrt{k}", third_component[1])
    .solving("w_1", squares[1])
    .solving("w_2", squares[2])
    .defining(*(third_component[k] for k in (2, 3, 4)), area_on_set, h_on_set, separation)
)

section.states(
    ConstantRoot,
    separation_variables,
    on=appelrot,
    says="on (18), (19) one of Kowalevski's variables stays constant",
    ids=("kowalevski-variable",),
    unknown="s",
    basis=("h", r"\sqrt{k}", "1"),
    sentence=r"""
These are, naturally, the solutions on which one of the Kowalevski variables remains constant""",
)

limit_scene = (
    classical.called("the limit")
    .with_unit(unit[1], tau[1])
    .adjoining(r"\sqrt{x_1x_2}")
    .defining(eq9, eq11, c, F1, eq13[1], eq13[2], F2)
)

section.claim(
    Limit(
        "limit",
        limit_scene,
        r"as $\beta\to 0$ the matrix that gives the derivatives of the functions (15) by these "
        r"functions tends to that for (18), (19), up to a change of basis",
        sentence=r"""
Therefore the family of motions (\ref{eq16}) found in this paper generalizes the so-called
{\it especially remarkable} motions of the 2nd and 3rd Appelrot classes""",
        ours=True,
        general=N4,
        special=InvariantRelations(
            "limit/direct",
            reduced_space,
            "the relations (18), (19) by themselves",
            relations=(*eq18, *eq19),
            main=((r"\omega_3",),),
        ),
    )
)
