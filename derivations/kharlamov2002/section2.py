r"""2. New solution with two invariant relations: the complex variables, F1 and F2, and N^4."""

from kowalevski_cas.paper.claims import (
    ChangedEquation,
    Coefficient,
    Degree,
    Dimension,
    Equilibria,
    Equivalence,
    FirstIntegral,
    Identity,
    Independence,
    InvariantRelations,
    InvertibleChange,
    LastMultiplier,
    Reality,
    SolvedExponents,
    Unit,
)
from kowalevski_cas.paper.derivation import Locus, Section

from .section1 import AS_LARGE, FRAME, NOT_PARALLEL, OMEGA, eq4, kowalevski, real_variables

section = Section("2", "New solution with two invariant relations")

section.claim(
    Degree(
        "linear-in-w3",
        kowalevski,
        r"the derivative of any expression free of $\omega_3$ is at most linear in $\omega_3$",
        variable=r"\omega_3",
        degree=1,
        sentence=r"""
Note that the derivative, in the above sense, of any expression not containing $\omega_3$, is linear
in $\omega_3$""",
    )
)

unit = section.inline("eq9.i", r"i^2=1")
section.accept(unit[1], "i^2=-1")  # otherwise (9) does not lead to (10)

eq9 = section.display(
    "eq9",
    r"""
\begin{array}{ll}
x_1 = (\alpha_1  - \beta_2) + i(\alpha_2  + \beta_1),&
x_2 = (\alpha_1  - \beta_2) - i(\alpha_2  + \beta_1 ), \\
y_1 = (\alpha_1  + \beta_2) + i(\alpha_2  - \beta_1), & y_2 =
(\alpha_1  + \beta_2) -
i(\alpha_2  - \beta_1), \\
 z_1 = \alpha_3  + i\beta_3, &
z_2 = \alpha_3  - i\beta_3,\\
w_1 = \omega_1  + i\omega_2 , & w_2 = \omega_1  - i\omega_2.
\end{array}""",
)

tau = section.inline("tau", r"\tau=it")

eq10 = section.display(
    "eq10",
    r"""
\begin{array}{c}
\begin{array}{ll}
{x'_1  =  - x_1 w_3  + z_1 w_1,} & {x'_2  = x_2 w_3  - z_2 w_2,} \cr
{y'_1  =  - y_1 w_3  + z_2 w_1,} & {y'_2  = y_2 w_3  - z_1 w_2 ,}
\cr {2z'_1  = x_1 w_2  - y_2 w_1,} & {2z'_2  =  - x_2 w_1 + y_1
w_2,}
\end{array} \\
2w'_1  =  - (w_1 w_3  + z_1 ),\quad 2w'_2  = w_2 w_3  + z_2, \quad
2\omega'_3 = y_2  - y_1.
\end{array}""",
    cites=("eq3", "eq5"),
)
for row in (1, 2, 3, 4, 7, 8):  # nothing defines w_3
    section.accept(eq10[row], eq10[row].tex.replace("w_3", r"\omega_3"))

eq11 = section.display(
    "eq11",
    r"""
\theta  = x_1 x_2 ,\quad Q_1  = x_2 z_1 w_1  + x_1 z_2 w_2 , \quad
Q_2 = x_2 z_1 w_1  - x_1 z_2 w_2.""",
)

PAIRS = (("x_1", "x_2"), ("y_1", "y_2"), ("z_1", "z_2"), ("w_1", "w_2"))

with_unit = (
    kowalevski.called("initial variables")
    .having(undefined=("w_3",))
    .defining(eq9)
    .with_unit(unit[1], tau[1])
)

complex_variables = (
    with_unit.changed(eq9, tau[1], keeping=(r"\omega_3",))
    .called("complex variables")
    .having(undefined=("w_3",), conjugates=PAIRS)
    .defining(eq11)
)

section.states(
    Unit,
    unit,
    on=with_unit,
    says=r"the unit of (9) and of $\tau=it$: with it (9) leads to (10), where $x'=\dot x/i$",
    rows=(*eq10,),
)
section.claim(
    InvertibleChange(
        "eq9",
        complex_variables,
        "the change (9) is invertible, and the variables come in conjugate pairs",
        old=with_unit,
        pairs=PAIRS,
        sentence=r"""
Following the idea of S.\,Kowalevski \cite{bib4} of using complex variables, introduce the change of
variables ($i^2=1$)""",
    )
)
section.states(
    ChangedEquation,
    eq10,
    on=complex_variables,
    says="the equations of motion in the complex variables, where $w_3$, which is not defined, is taken for one more independent variable",
    old=with_unit,
)

theta_prime = section.states(
    Identity,
    section.inline("theta-prime", r"\theta ' = Q_2"),
    on=complex_variables,
    says=r"the derivative of $\theta$",
)

Q1_prime = section.states(
    Coefficient,
    section.inline("Q1-prime", r"Q'_1  = \frac{1}{2}Q_2 \omega _3 + ..."),
    on=complex_variables,
    says=r"the derivative of $Q_1$ up to terms free of $\omega_3$",
    variable=r"\omega_3",
    sentence=r"""
Then $ \theta ' = Q_2$, $Q'_1  = \frac{1}{2}Q_2 \omega _3 + ...$, where "$...$"\, stands for the
terms not depending on $\omega_3$""",
)

ansatz = section.display("ansatz", r"\theta ^m \omega _3  - \theta ^n Q_1.")

symbolic_exponents = complex_variables.called("symbolic exponents").having(
    constants=("m", "n"), powers=((r"\theta", "m"), (r"\theta", "n"))
)

ansatz_coefficient = section.states(
    Coefficient,
    section.display(
        "ansatz-coefficient",
        r"""
m\theta ^{m - 1} \theta ' - \frac{1}{2}\theta ^n Q_2  = (m\theta ^{m
- 1}  - \frac{1}{2} \theta ^n )Q_2""",
    ),
    on=symbolic_exponents,
    says=r"the coefficient of $\omega_3$ in the derivative of $\theta^m\omega_3-\theta^nQ_1$",
    variable=r"\omega_3",
    derivative_of=ansatz[1],
    sentence=r"In its derivative, the coefficient of $\omega_3$ is equal to",
)

ansatz_exponents = section.inline("ansatz-exponents", r"m = \frac{1}{2},n =  - \frac{1}{2}")
section.claim(
    SolvedExponents(
        "ansatz-exponents",
        symbolic_exponents,
        "the coefficient vanishes for these exponents and for no others",
        values=(*ansatz_exponents,),
        ansatz=ansatz[1],
        variable=r"\omega_3",
        sentence=r"and vanishes if $m = \frac{1}{2},n =  - \frac{1}{2}$",
    )
)

F1 = section.display(
    "F1",
    r"""
F_1  = \sqrt {x_1 x_2 } \omega _3  - \frac{1} {\sqrt {x_1 x_2 } }
(x_2 z_1 w_1  + x_1 z_2 w_2 ).""",
)

eq12 = section.display(
    "eq12",
    r"""
\frac{d F_1} {d\tau}  = \frac{1} {2\sqrt {x_1 x_2 }} \,[\frac{x_2}
{x_1 } (z_1^2  + x_1 y_2 )(w_1^2  + x_1 ) - \frac{x_1} {x_2 } (z_2^2
+ x_2 y_1 )(w_2^2  + x_2 )].""",
    cites=("eq10",),
)

c = section.display(
    "c",
    r"""
\begin{array}{l}
z_1^2  + x_1 y_2  = (a^2  - b^2 ) + 2ic = c_1  = {\rm const},\\
z_2^2  + x_2 y_1  = (a^2  - b^2 ) - 2ic = c_2  = {\rm const}.
\end{array}""",
    cites=("eq4",),
)

eq13 = section.display(
    "eq13",
    r"""
U_1  = \frac{x_2 } {x_1 } c_1 (w_1^2  + x_1 ),\qquad U_2  =
\frac{x_1 } {x_2 } c_2 (w_2^2  + x_2 ),\qquad U_2  = \overline {U_1
}""",
)

with_constants = (
    complex_variables.called("complex variables with c1 and c2")
    .having(
        constants=("c_1", "c_2"),
        conjugates=(("c_1", "c_2"),),
        loci=(Locus("$x_1=x_2=0$", ("x_1=0", "x_2=0"), "x_1 x_2"),),
    )
    .solving("z_1", c[1])
    .solving("z_2", c[2])
    .adjoining(r"\sqrt{x_1x_2}")
    .defining(F1, eq13[1], eq13[2])
)

initial = (
    kowalevski.called("initial variables with the constants (4)")
    .adjoining(eq4[1], eq4[2])
    .defining(eq9, eq4[3], c)
    .with_unit(unit[1], tau[1])
)

section.states(Identity, eq12, on=with_constants, says="the derivative of $F_1$")
section.states(Identity, c, on=initial, says="the constants $c_1$ and $c_2$", ids=("c1", "c2"))
section.states(
    Identity,
    eq13[3],
    on=with_constants,
    says="$U_2$ is the conjugate of $U_1$",
    ids=("eq13.conjugate",),
)

U_prime = section.identity(
    "U-prime",
    r"""
\begin{array}{l}
\displaystyle{\frac{dU_1} {d\tau } =\phantom{-}{\frac {c_1 } {x_1^2 }}(w_1^2  + x_1 )[x_1 x_2 \omega _3  - (x_2 z_1 w_1  + x_1 z_2 w_2 )],}\\
\displaystyle{\frac{dU_2} {d\tau } =-{\frac {c_2 } {x_2^2 }}(w_2^2 +
x_2 )[x_1 x_2 \omega _3  - (x_2 z_1 w_1  + x_1 z_2 w_2 )],}
\end{array}""",
    cites=("eq13",),
    on=with_constants,
    says="the derivatives of $U_1$ and $U_2$",
    ids=("U1-prime", "U2-prime"),
)

eq14 = section.identity(
    "eq14",
    r"""
\begin{array}{l}
\displaystyle{\frac {d} {d\tau } (U_1  - U_2 ) = \frac{1} {\sqrt
{x_1 x_2 } }[{\frac {c_1 } {x_1^2 }}(w_1^2  + x_1 ) + {\frac{c_2 }
{x_2^2 }}(w_2^2  + x_2 )] (\sqrt {x_1 x_2 } \omega _3  - {\frac{x_2
z_1 w_1  + x_1 z_2 w_2 } {\sqrt {x_1 x_2 } }}).}
\end{array}""",
    on=with_constants,
    says="the derivative of $U_1-U_2$",
)

F2 = section.inline("F2", r"F_2  = U_1  - U_2")

with_root = with_constants.called("complex variables with the root").defining(F2)

F_prime = section.identity(
    "F-prime",
    r"""
\begin{array}{l}
\displaystyle{\frac {dF_1} {d\tau }   = \frac {1} {2\sqrt {x_1 x_2 }
}\, F_2 , \quad \frac {dF_2} {d\tau }   = \frac {1} {\sqrt {x_1 x_2
} }(U_1  + U_2 )\,F_1.}
\end{array}""",
    cites=("eq12", "eq14"),
    on=with_root,
    says="the derivatives of $F_1$ and $F_2$ are multiples of $F_2$ and $F_1$",
    ids=("F1-prime", "F2-prime"),
)

eq15 = section.display("eq15", r"F_1  = 0,\quad F_2  = 0")

# For statements about sets in the space of all nine variables the constants of (4) are functions.
all_constants = (
    complex_variables.called("complex variables, all constants")
    .having(
        vectors=FRAME,
        loci=(Locus("$a^2=b^2$ and $c=0$", ("c_1=0", "c_2=0"), AS_LARGE.condition),),
        nonzero=NOT_PARALLEL,
    )
    .with_unit(unit[1])
    .adjoining(r"\sqrt{x_1x_2}", eq4[1], eq4[2])
    .defining(eq4[3], c, F1, eq13[1], eq13[2], F2)
)

N4 = InvariantRelations(
    "eq15",
    with_root,
    "the equations $F_1=0$, $F_2=0$ define an invariant manifold",
    relations=(*eq15,),
    sentence=r"defines the invariant submanifold of the phase space of Eqs.~(\ref{eq10})",
)
section.claim(
    N4,
    Dimension(
        "N4-dimension",
        all_constants,
        "with (4), the relations (15) define a four-dimensional manifold $N^4$",
        levels=(*eq4,),
        equations=(*eq15,),
        dimension=4,
        sentence=r"""
Given the geometrical identities~(\ref{eq4}) depending only on the body parameters and the force
fields, this manifold has dimension~4""",
    ),
    Reality(
        "reality",
        with_root,
        r"$\theta$ and $Q_1$ are real, $U_1-U_2$ is purely imaginary",
        real=(r"\theta", "Q_1"),
        imaginary=("U_1-U_2",),
        sentence=r"""
Note that the expressions $\theta$ and $Q_1$ in (\ref{eq11}), (\ref{eq13}) are real, while $U_1-U_2$
is purely imaginary""",
    ),
)

real_form = section.display(
    "real-form",
    r"""
x_1 x_2 \omega _3  - 2{\mathop{\rm Re}\nolimits} (x_2 z_1 w_1 ) =
0,\qquad {\mathop{\rm Im}\nolimits} [x_2^2 c_1 (w_1^2  + x_1 )] = 0.""",
)

with_root_and_unit = with_root.called("complex variables with the root and the unit").with_unit(
    unit[1]
)

section.states(
    Equivalence,
    real_form,
    on=with_root_and_unit,
    says="the equations (15) in real form",
    to=eq15,
    sentence=r"Hence Eqs.~(\ref{eq15}) can be written in the form",
)

eq16 = section.display(
    "eq16",
    r"""
\begin{array}{l}
\displaystyle{(\xi _1^2  + \xi _2^2 )\omega _3  - 2[(\xi _1 \omega
_1 + \xi _2 \omega _2 )\alpha _3  + (\xi _2 \omega _1  - \xi _1
\omega _2 )\beta _3 ] = 0,} \\ [2mm]
 2[c(\xi _1^2  - \xi _2^2
) - (a^2  - b^2 )\xi _1 \xi _2 ](\omega _1^2  - \omega _2^2  + \xi
_1 ) +
\\[2mm]
\qquad+ [(a^2  - b^2 )(\xi _1^2  - \xi _2^2 ) + 4c\xi _1 \xi _2
](2\omega _1 \omega _2  + \xi _2 ) = 0.
\end{array}""",
    cites=("eq9",),
)

xi = section.display(
    "xi",
    r"""
\xi _1  = \alpha _1  - \beta _2 , \quad \xi _2  = \alpha _2  + \beta
_1 .""",
)

with_xi = initial.called("initial variables with ξ1 and ξ2").defining(xi)

INITIAL = r"""
Substitution~(\ref{eq9}) leads to the invariant relations expressed in the initial variables"""

section.states(
    Equivalence,
    eq16,
    on=with_xi,
    says="the relations (15) in the initial variables",
    to=real_form,
    sentence=INITIAL,
)

xi_variables = (
    real_variables.called("initial variables, real, with ξ1 and ξ2")
    .having(
        loci=(Locus(r"$\xi_1=\xi_2=0$", (r"\xi_1=0", r"\xi_2=0"), r"\xi_1^2+\xi_2^2"), AS_LARGE)
    )
    .defining(xi)
)

section.claim(
    InvariantRelations(
        "eq16.invariance",
        xi_variables,
        "the system (16), read literally with (4), defines an invariant set",
        relations=(*eq16,),
        main=((r"\omega_3",),),
        sentence=INITIAL,
    )
)

TWO_INTEGRALS = r"""
The equations of motion restricted to the manifold $N^4$ defined by (\ref{eq16}) have two
independent first integrals"""

eq17 = section.states(
    FirstIntegral,
    section.display(
        "eq17",
        r"""
\begin{array}{l}
\displaystyle{H = \omega _1^2  + \omega _2^2  + \frac{1}{2}\omega
_3^2  - \alpha _1  - \beta _2  \equiv h,}
\\ [2mm]
K = (\omega _1^2  - \omega _2^2  + \alpha _1  - \beta _2 )^2  +
(2\omega _1 \omega _2  + \alpha _2  + \beta _1 )^2  \equiv k.
\end{array}""",
    ),
    on=kowalevski,
    says="two first integrals, on $N^4$ as elsewhere",
    sentence=TWO_INTEGRALS,
)

with_integrals = all_constants.called("complex variables, all constants and integrals").defining(
    eq17
)

over_N4 = section.lemma(
    "over-N4",
    r"""
\omega_3 = \frac{x_2z_1w_1+x_1z_2w_2}{x_1x_2}, \quad
y_2 = \frac{1}{x_1}\left[\frac{x_1^2(z_2^2+x_2y_1)(w_2^2+x_2)}{x_2^2(w_1^2+x_1)}-z_1^2\right]""",
    "the relations (15) solved for two variables",
)

at_rest = kowalevski.called("constants of the fields").having(
    constants=("a", "b", "c"), nonzero=NOT_PARALLEL, loci=(AS_LARGE,)
)

section.claim(
    Independence(
        "N4-independence",
        with_integrals,
        "$H$ and $K$ are independent on $N^4$",
        levels=(*eq4,),
        equations=(*eq15,),
        functions=(*eq17,),
        graph=(*over_N4,),
        sentence=TWO_INTEGRALS,
    ),
    Equilibria(
        "equilibria",
        at_rest,
        "the body has exactly four equilibria",
        fixed=OMEGA,
        levels=(*eq4,),
        count=4,
        sentence=r"""
The singular points of the initial system (\ref{eq2}), (\ref{eq3}) in this problem correspond to the
body equilibria; there exists only four such points""",
    ),
    LastMultiplier(
        "last-multiplier",
        kowalevski,
        "the flow preserves the volume of the space and, with it, a measure on $N^4$",
        relations=N4,
        sentence=r"""
It follows from dynamics theorems that, if the common level~(\ref{eq17}) does not contain any
singular points and the gradients of $H$ and $K$ are linearly independent, then each connected
component of~(\ref{eq17}) is a two-dimensional torus and the trajectories on it satisfy the
differential equations having the last Jacobi multiplier""",
    ),
)
