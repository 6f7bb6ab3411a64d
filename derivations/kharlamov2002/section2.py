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
from kowalevski_cas.paper.derivation import Change, Locus, Scene, Section

from .section1 import ALPHA, BETA, FRAME, KOWALEVSKI, OMEGA, eq2, eq3, eq4, kowalevski

section = Section("2", "New solution with two invariant relations")

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
)

eq11 = section.display(
    "eq11",
    r"""
\theta  = x_1 x_2 ,\quad Q_1  = x_2 z_1 w_1  + x_1 z_2 w_2 , \quad
Q_2 = x_2 z_1 w_1  - x_1 z_2 w_2.""",
)

theta_prime = section.inline("theta-prime", r"\theta ' = Q_2")

Q1_prime = section.inline("Q1-prime", r"Q'_1  = \frac{1}{2}Q_2 \omega _3 + ...")

ansatz = section.display("ansatz", r"\theta ^m \omega _3  - \theta ^n Q_1.")

ansatz_coefficient = section.display(
    "ansatz-coefficient",
    r"""
m\theta ^{m - 1} \theta ' - \frac{1}{2}\theta ^n Q_2  = (m\theta ^{m
- 1}  - \frac{1}{2} \theta ^n )Q_2""",
)

ansatz_exponents = section.inline("ansatz-exponents", r"m = \frac{1}{2},n =  - \frac{1}{2}")

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
)

c = section.display(
    "c",
    r"""
\begin{array}{l}
z_1^2  + x_1 y_2  = (a^2  - b^2 ) + 2ic = c_1  = {\rm const},\\
z_2^2  + x_2 y_1  = (a^2  - b^2 ) - 2ic = c_2  = {\rm const}.
\end{array}""",
)

eq13 = section.display(
    "eq13",
    r"""
U_1  = \frac{x_2 } {x_1 } c_1 (w_1^2  + x_1 ),\qquad U_2  =
\frac{x_1 } {x_2 } c_2 (w_2^2  + x_2 ),\qquad U_2  = \overline {U_1
}""",
)

U_prime = section.display(
    "U-prime",
    r"""
\begin{array}{l}
\displaystyle{\frac{dU_1} {d\tau } =\phantom{-}{\frac {c_1 } {x_1^2 }}(w_1^2  + x_1 )[x_1 x_2 \omega _3  - (x_2 z_1 w_1  + x_1 z_2 w_2 )],}\\
\displaystyle{\frac{dU_2} {d\tau } =-{\frac {c_2 } {x_2^2 }}(w_2^2 +
x_2 )[x_1 x_2 \omega _3  - (x_2 z_1 w_1  + x_1 z_2 w_2 )],}
\end{array}""",
)

eq14 = section.display(
    "eq14",
    r"""
\begin{array}{l}
\displaystyle{\frac {d} {d\tau } (U_1  - U_2 ) = \frac{1} {\sqrt
{x_1 x_2 } }[{\frac {c_1 } {x_1^2 }}(w_1^2  + x_1 ) + {\frac{c_2 }
{x_2^2 }}(w_2^2  + x_2 )] (\sqrt {x_1 x_2 } \omega _3  - {\frac{x_2
z_1 w_1  + x_1 z_2 w_2 } {\sqrt {x_1 x_2 } }}).}
\end{array}""",
)

F2 = section.inline("F2", r"F_2  = U_1  - U_2")

F_prime = section.display(
    "F-prime",
    r"""
\begin{array}{l}
\displaystyle{\frac {dF_1} {d\tau }   = \frac {1} {2\sqrt {x_1 x_2 }
}\, F_2 , \quad \frac {dF_2} {d\tau }   = \frac {1} {\sqrt {x_1 x_2
} }(U_1  + U_2 )\,F_1.}
\end{array}""",
)

eq15 = section.display("eq15", r"F_1  = 0,\quad F_2  = 0")

real_form = section.display(
    "real-form",
    r"""
x_1 x_2 \omega _3  - 2{\mathop{\rm Re}\nolimits} (x_2 z_1 w_1 ) =
0,\qquad {\mathop{\rm Im}\nolimits} [x_2^2 c_1 (w_1^2  + x_1 )] = 0.""",
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
)

xi = section.display(
    "xi",
    r"""
\xi _1  = \alpha _1  - \beta _2 , \quad \xi _2  = \alpha _2  + \beta
_1 .""",
)

eq17 = section.display(
    "eq17",
    r"""
\begin{array}{l}
\displaystyle{H = \omega _1^2  + \omega _2^2  + \frac{1}{2}\omega
_3^2  - \alpha _1  - \beta _2  \equiv h,}
\\ [2mm]
K = (\omega _1^2  - \omega _2^2  + \alpha _1  - \beta _2 )^2  +
(2\omega _1 \omega _2  + \alpha _2  + \beta _1 )^2  \equiv k.
\end{array}""",
)

# -- scenes --------------------------------------------------------------------

X = ("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", "w_1", "w_2")
PAIRS = (("x_1", "x_2"), ("y_1", "y_2"), ("z_1", "z_2"), ("w_1", "w_2"))
CHANGE = dict(zip(X, (eq9[k] for k in range(1, 9)), strict=True))

with_unit = Scene(
    "initial variables",
    "the Kowalevski case with the imaginary unit, and the complex variables (9) as abbreviations",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions={**KOWALEVSKI, **CHANGE},
    unit=unit[1],
    clock=tau[1],
    undefined=("w_3",),
)

change = Change(with_unit, tuple(eq9[k] for k in range(1, 9)), tau[1])

complex_variables = Scene(
    "complex variables",
    "the variables (9) in the time (10), with the field derived through the change",
    variables=(*X, r"\omega_3"),
    field=change,
    time=r"\tau",
    undefined=("w_3",),
    conjugates=PAIRS,
    definitions={r"\theta": eq11[1], "Q_1": eq11[2], "Q_2": eq11[3]},
)

symbolic_exponents = Scene(
    "symbolic exponents",
    "the complex variables with two undetermined exponents of $\\theta$",
    variables=(*X, r"\omega_3"),
    constants=("m", "n"),
    field=change,
    time=r"\tau",
    conjugates=PAIRS,
    definitions=complex_variables.definitions,
    powers=((r"\theta", "m"), (r"\theta", "n")),
)

with_root = Scene(
    "complex variables with the root",
    "the complex variables and $\\sqrt{x_1x_2}$, where $c_1$ and $c_2$ are the constants (4)",
    variables=(*X, r"\omega_3"),
    constants=("c_1", "c_2"),
    field=change,
    time=r"\tau",
    conjugates=(*PAIRS, ("c_1", "c_2")),
    roots={"z_1": c[1], "z_2": c[2], r"\sqrt{x_1x_2}": None},
    definitions={
        **complex_variables.definitions,
        "F_1": F1[1],
        "U_1": eq13[1],
        "U_2": eq13[2],
        "F_2": F2[1],
    },
    loci=(Locus("$x_1=x_2=0$", ("x_1=0", "x_2=0"), "x_1 x_2"),),
)

with_root_and_unit = Scene(
    "complex variables with the root and the unit",
    "the same with $i$, for imaginary parts",
    variables=with_root.variables,
    constants=with_root.constants,
    field=change,
    time=r"\tau",
    unit=unit[1],
    conjugates=with_root.conjugates,
    roots=with_root.roots,
    definitions=with_root.definitions,
)

# For statements about sets in the space of all nine variables the constants of (4) are functions.
all_constants = Scene(
    "complex variables, all constants",
    "the complex variables, $\\sqrt{x_1x_2}$ and $i$, where $c_1$, $c_2$ abbreviate the integrals (4)",
    vectors=FRAME,
    variables=(*X, r"\omega_3"),
    field=change,
    time=r"\tau",
    unit=unit[1],
    conjugates=PAIRS,
    roots={r"\sqrt{x_1x_2}": None},
    definitions={**with_root.definitions, "c_1": c[1], "c_2": c[2], "H": eq17[1], "K": eq17[2]},
    loci=(Locus("$c_1=c_2=0$, that is $a=b$, $c=0$", ("c_1=0", "c_2=0"), "c_1 c_2"),),
)

initial = Scene(
    "initial variables with the constants (4)",
    "the Kowalevski case with $a$, $b$, $c$, the abbreviations (9) and the imaginary unit",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    constants=("a", "b"),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions={
        **KOWALEVSKI,
        **CHANGE,
        "c": eq4[3],
        "c_1": c[1],
        "c_2": c[2],
        r"\xi_1": xi[1],
        r"\xi_2": xi[2],
    },
    roots={"a": eq4[1], "b": eq4[2]},
    unit=unit[1],
    clock=tau[1],
)

real_variables = Scene(
    "initial variables, real",
    "the Kowalevski case with $a$, $b$, $c$ and the abbreviations $\\xi_1$, $\\xi_2$",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    constants=("a", "b"),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions={
        **KOWALEVSKI,
        "c": eq4[3],
        r"\xi_1": xi[1],
        r"\xi_2": xi[2],
        "K": eq17[2],
    },
    roots={"a": eq4[1], "b": eq4[2]},
    loci=(
        Locus(r"$\xi_1=\xi_2=0$", (r"\xi_1=0", r"\xi_2=0"), r"\xi_1^2+\xi_2^2"),
        Locus("$a=b$, $c=0$", ("a^2-b^2=0", "c=0"), "(a^2-b^2)^2+4c^2"),
    ),
)

at_rest = Scene(
    "constants of the fields",
    "the Kowalevski case with $a$, $b$, $c$ as numbers, for fields that are not parallel",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    constants=("a", "b", "c"),
    field=(eq2[1], eq3[1], eq3[2]),
    definitions=KOWALEVSKI,
    nonzero=("a^2 b^2-c^2",),
    loci=(Locus("$a=b$, $c=0$", ("a^2-b^2=0", "c=0"), "(a^2-b^2)^2+4c^2"),),
)

# -- claims --------------------------------------------------------------------

N4 = InvariantRelations(
    "eq15",
    with_root,
    None,
    "$F_1=0$, $F_2=0$ defines an invariant manifold",
    relations=(eq15[1], eq15[2]),
    names=("F_1", "F_2"),
)

section.claim(
    Degree(
        "linear-in-w3",
        kowalevski,
        None,
        r"the derivative of any expression free of $\omega_3$ is at most linear in $\omega_3$",
        variable=r"\omega_3",
        degree=1,
    ),
    Unit(
        "eq9.i",
        with_unit,
        unit[1],
        "the square of the unit for which the change (9) leads to (10)",
        rows=tuple(eq10[k] for k in range(1, 10)),
    ),
    InvertibleChange(
        "eq9",
        complex_variables,
        None,
        "the change (9) is invertible, and the variables come in conjugate pairs",
        old=with_unit,
        pairs=PAIRS,
    ),
    *(
        ChangedEquation(
            f"eq10.{k}",
            complex_variables,
            eq10[k],
            "an equation of motion in the complex variables",
            old=with_unit,
        )
        for k in range(1, 10)
    ),
    Identity("theta-prime", complex_variables, theta_prime[1], r"the derivative of $\theta$"),
    Coefficient(
        "Q1-prime",
        complex_variables,
        Q1_prime[1],
        r"the derivative of $Q_1$ up to terms free of $\omega_3$",
        variable=r"\omega_3",
    ),
    Coefficient(
        "ansatz-coefficient",
        symbolic_exponents,
        ansatz_coefficient[1],
        r"the coefficient of $\omega_3$ in the derivative of $\theta^m\omega_3-\theta^nQ_1$",
        variable=r"\omega_3",
        derivative_of=ansatz[1],
    ),
    SolvedExponents(
        "ansatz-exponents",
        symbolic_exponents,
        None,
        "the coefficient vanishes for these exponents and for no others",
        values=(ansatz_exponents[1], ansatz_exponents[2]),
        ansatz=ansatz[1],
        variable=r"\omega_3",
    ),
    Identity("eq12", with_root, eq12[1], "the derivative of $F_1$"),
    Identity("c1", initial, c[1], "the constant $c_1$"),
    Identity("c2", initial, c[2], "the constant $c_2$"),
    Identity("eq13.conjugate", with_root, eq13[3], "$U_2$ is the conjugate of $U_1$"),
    Identity("U1-prime", with_root, U_prime[1], "the derivative of $U_1$"),
    Identity("U2-prime", with_root, U_prime[2], "the derivative of $U_2$"),
    Identity("eq14", with_root, eq14[1], "the derivative of $U_1-U_2$"),
    Identity("F1-prime", with_root, F_prime[1], "the derivative of $F_1$ through $F_2$"),
    Identity("F2-prime", with_root, F_prime[2], "the derivative of $F_2$ through $F_1$"),
    N4,
    Dimension(
        "N4-dimension",
        all_constants,
        None,
        "with (4), the relations (15) define a four-dimensional manifold",
        levels=(eq4[1], eq4[2], eq4[3]),
        equations=(eq15[1], eq15[2]),
        dimension=4,
    ),
    Reality(
        "reality",
        with_root,
        None,
        r"$\theta$ and $Q_1$ are real, $U_1-U_2$ is purely imaginary",
        real=(r"\theta", "Q_1"),
        imaginary=("U_1-U_2",),
    ),
    Equivalence(
        "real-form.1",
        with_root_and_unit,
        real_form[1],
        "the first of the equations (15) in real form",
        to=eq15[1],
    ),
    Equivalence(
        "real-form.2",
        with_root_and_unit,
        real_form[2],
        "the second of the equations (15) in real form",
        to=eq15[2],
    ),
    Equivalence(
        "eq16.1", initial, eq16[1], "the first relation in the initial variables", to=real_form[1]
    ),
    Equivalence(
        "eq16.2", initial, eq16[2], "the second relation in the initial variables", to=real_form[2]
    ),
    InvariantRelations(
        "eq16.invariance",
        real_variables,
        None,
        "the system (16), read literally with (4), is an invariant set",
        relations=(eq16[1], eq16[2]),
        names=("E_1", "E_2"),
        main=((r"\omega_3",),),
    ),
    FirstIntegral("eq17.1", kowalevski, eq17[1], "the energy integral on $N^4$"),
    FirstIntegral("eq17.2", kowalevski, eq17[2], "the integral $K$ on $N^4$"),
    Independence(
        "N4-independence",
        all_constants,
        None,
        "$H$ and $K$ are independent on $N^4$",
        levels=(eq4[1], eq4[2], eq4[3]),
        equations=(eq15[1], eq15[2]),
        functions=(eq17[1], eq17[2]),
    ),
    Equilibria(
        "equilibria",
        at_rest,
        None,
        "the body has exactly four equilibria",
        fixed=OMEGA,
        levels=(eq4[1], eq4[2], eq4[3]),
        count=4,
    ),
    LastMultiplier(
        "last-multiplier",
        kowalevski,
        None,
        "the flow preserves the volume of the space and, with it, a measure on $N^4$",
        relations=N4,
    ),
)
