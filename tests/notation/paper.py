"""The displays of the paper, as they are typed there; and formulas from its running text."""

from kowalevski_cas.notation import Vocabulary

WORDS = Vocabulary(
    scalars=frozenset(
        r"""a b c H h k j m n i \ell \Psi \theta K L A_1 A_2 A_3 u_0 c_1 c_2
        x_1 x_2 y_1 y_2 z_1 z_2 w_1 w_2 w_3 F_1 F_2 U_1 U_2 Q_1 Q_2 J_1 J_2 J_3 \xi_1 \xi_2
        \omega_1 \omega_2 \omega_3 \alpha_1 \alpha_2 \alpha_3 \beta_1 \beta_2 \beta_3""".split()
    ),
    vectors=frozenset(
        r"""\boldsymbol{\omega} \boldsymbol{\alpha} \boldsymbol{\beta}
        \mathbf{e}_1 \mathbf{e}_2""".split()
    ),
    matrices=frozenset([r"\mathbf{I}"]),
    times=frozenset(["t", r"\tau"]),
)

DISPLAYS = {
    "eq1": r"""\begin{equation}\label{eq1}
({\bf e}_1 ,{\bs \alpha}) + ({\bf e}_2 ,{\bs \beta}).
\end{equation}""",
    "eq2-eq3": r"""\begin{eqnarray}
& {\bf I} \dot {\bs \omega} = {\bf I}{\bs \omega } \times {\bs
\omega} + {\bf e}_1 \times {\bs \alpha} + {\bf e}_2 \times {\bs
\beta},\label{eq2}\\
& \dot {\bs \alpha}   = {\bs \alpha} \times {\bs \omega}, \quad \dot
{\bs \beta} = {\bs \beta} \times {\bs \omega} \label{eq3}
\end{eqnarray}""",
    "eq4": r"""\begin{equation}\label{eq4}
({\bs \alpha},{\bs \alpha}) = a^2 , \quad ({\bs \beta},{\bs \beta })
= b^2 , \quad ({\bs \alpha},{\bs \beta}) = c.
\end{equation}""",
    "energy": r"""$$
H = \frac{1}{2} ({\bf I}{\bs \omega},{\bs \omega}) - ({\bf e}_1,
{\bs \alpha}) - ({\bf e}_2, {\bs \beta}).
$$""",
    "inertia": r"""$$
{\bf I}= \mathop{\rm diag}\nolimits(A_1, A_2,A_3).
$$""",
    "kowalevski-case": r"""$$
A_1  = A_2  = 2A_3 , \quad {\bf e}_1  = (1,0,0), \quad {\bf e}_2  =
(0,1,0).
$$""",
    "eq5": r"""\begin{equation}\label{eq5}
2\dot \omega _1 = \omega _2 \omega _3  + \beta _3, \quad 2 \dot
\omega _2 =  - \omega _1 \omega _3  - \alpha _3 , \quad \dot \omega
_3 = \alpha _2  - \beta _1 .
\end{equation}""",
    "eq6": r"""\begin{equation}\label{eq6}
K = J_1^2  + J_2^2 ,
\end{equation}""",
    "J1-J2": r"""$$
J_1  = \omega _1^2  - \omega _2^2  + \alpha _1  - \beta _2, \quad
J_2  = 2\omega _1 \omega _2  + \alpha _2  + \beta _1,
$$""",
    "eq7": r"""\begin{equation}\label{eq7}
J_1  = 0,\quad J_2  = 0,
\end{equation}""",
    "J3": r"""$$
J_3  = (\omega _1^2  + \omega _2^2 )\omega _3 + 2(\omega _1 \alpha
_3  + \omega _2 \beta _3 ),
$$""",
    "eq8": r"""\begin{equation}\label{eq8}
H = h,\quad J_3  = j
\end{equation}""",
    "eq9": r"""\begin{equation}\label{eq9}
\begin{array}{ll}
x_1 = (\alpha_1  - \beta_2) + i(\alpha_2  + \beta_1),&
x_2 = (\alpha_1  - \beta_2) - i(\alpha_2  + \beta_1 ), \\
y_1 = (\alpha_1  + \beta_2) + i(\alpha_2  - \beta_1), & y_2 =
(\alpha_1  + \beta_2) -
i(\alpha_2  - \beta_1), \\
 z_1 = \alpha_3  + i\beta_3, &
z_2 = \alpha_3  - i\beta_3,\\
w_1 = \omega_1  + i\omega_2 , & w_2 = \omega_1  - i\omega_2.
\end{array}
\end{equation}""",
    "eq10": r"""\begin{equation}\label{eq10}
\begin{array}{c}
\begin{array}{ll}
{x'_1  =  - x_1 w_3  + z_1 w_1,} & {x'_2  = x_2 w_3  - z_2 w_2,} \cr
{y'_1  =  - y_1 w_3  + z_2 w_1,} & {y'_2  = y_2 w_3  - z_1 w_2 ,}
\cr {2z'_1  = x_1 w_2  - y_2 w_1,} & {2z'_2  =  - x_2 w_1 + y_1
w_2,}
\end{array} \\
2w'_1  =  - (w_1 w_3  + z_1 ),\quad 2w'_2  = w_2 w_3  + z_2, \quad
2\omega'_3 = y_2  - y_1.
\end{array}
\end{equation}""",
    "eq11": r"""\begin{equation}\label{eq11}
\theta  = x_1 x_2 ,\quad Q_1  = x_2 z_1 w_1  + x_1 z_2 w_2 , \quad
Q_2 = x_2 z_1 w_1  - x_1 z_2 w_2.
\end{equation}""",
    "combination": r"""$$
\theta ^m \omega _3  - \theta ^n Q_1.
$$""",
    "ansatz-coefficient": r"""$$
m\theta ^{m - 1} \theta ' - \frac{1}{2}\theta ^n Q_2  = (m\theta ^{m
- 1}  - \frac{1}{2} \theta ^n )Q_2
$$""",
    "F1": r"""$$
F_1  = \sqrt {x_1 x_2 } \omega _3  - \frac{1} {\sqrt {x_1 x_2 } }
(x_2 z_1 w_1  + x_1 z_2 w_2 ).
$$""",
    "eq12": r"""\begin{equation}\label{eq12}
\frac{d F_1} {d\tau}  = \frac{1} {2\sqrt {x_1 x_2 }} \,[\frac{x_2}
{x_1 } (z_1^2  + x_1 y_2 )(w_1^2  + x_1 ) - \frac{x_1} {x_2 } (z_2^2
+ x_2 y_1 )(w_2^2  + x_2 )].
\end{equation}""",
    "c1-c2": r"""$$
\begin{array}{l}
z_1^2  + x_1 y_2  = (a^2  - b^2 ) + 2ic = c_1  = {\rm const},\\
z_2^2  + x_2 y_1  = (a^2  - b^2 ) - 2ic = c_2  = {\rm const}.
\end{array}
$$""",
    "eq13": r"""\begin{equation}\label{eq13}
U_1  = \frac{x_2 } {x_1 } c_1 (w_1^2  + x_1 ),\qquad U_2  =
\frac{x_1 } {x_2 } c_2 (w_2^2  + x_2 ),\qquad U_2  = \overline {U_1
}
\end{equation}""",
    "U-prime": r"""$$
\begin{array}{l}
\displaystyle{\frac{dU_1} {d\tau } =\phantom{-}{\frac {c_1 } {x_1^2 }}(w_1^2  + x_1 )[x_1 x_2 \omega _3  - (x_2 z_1 w_1  + x_1 z_2 w_2 )],}\\
\displaystyle{\frac{dU_2} {d\tau } =-{\frac {c_2 } {x_2^2 }}(w_2^2 +
x_2 )[x_1 x_2 \omega _3  - (x_2 z_1 w_1  + x_1 z_2 w_2 )],}
\end{array}
$$""",
    "eq14": r"""\begin{equation}\label{eq14}
\begin{array}{l}
\displaystyle{\frac {d} {d\tau } (U_1  - U_2 ) = \frac{1} {\sqrt
{x_1 x_2 } }[{\frac {c_1 } {x_1^2 }}(w_1^2  + x_1 ) + {\frac{c_2 }
{x_2^2 }}(w_2^2  + x_2 )] (\sqrt {x_1 x_2 } \omega _3  - {\frac{x_2
z_1 w_1  + x_1 z_2 w_2 } {\sqrt {x_1 x_2 } }}).}
\end{array}
\end{equation}""",
    "F-prime": r"""$$
\begin{array}{l}
\displaystyle{\frac {dF_1} {d\tau }   = \frac {1} {2\sqrt {x_1 x_2 }
}\, F_2 , \quad \frac {dF_2} {d\tau }   = \frac {1} {\sqrt {x_1 x_2
} }(U_1  + U_2 )\,F_1.}
\end{array}
$$""",
    "eq15": r"""\begin{equation}\label{eq15}
F_1  = 0,\quad F_2  = 0
\end{equation}""",
    "real-form": r"""$$
x_1 x_2 \omega _3  - 2{\mathop{\rm Re}\nolimits} (x_2 z_1 w_1 ) =
0,\qquad {\mathop{\rm Im}\nolimits} [x_2^2 c_1 (w_1^2  + x_1 )] = 0.
$$""",
    "eq16": r"""\begin{equation}\label{eq16}
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
\end{array}
\end{equation}""",
    "xi": r"""$$
\xi _1  = \alpha _1  - \beta _2 , \quad \xi _2  = \alpha _2  + \beta
_1 .
$$""",
    "eq17": r"""\begin{equation}\label{eq17}
\begin{array}{l}
\displaystyle{H = \omega _1^2  + \omega _2^2  + \frac{1}{2}\omega
_3^2  - \alpha _1  - \beta _2  \equiv h,}
\\ [2mm]
K = (\omega _1^2  - \omega _2^2  + \alpha _1  - \beta _2 )^2  +
(2\omega _1 \omega _2  + \alpha _2  + \beta _1 )^2  \equiv k.
\end{array}
\end{equation}""",
    "eq18-eq19": r"""\begin{eqnarray}
& \displaystyle{(\alpha _1^2  + \alpha _2^2 )\omega _3 - 2(\alpha _1
\omega _1  + \alpha _2 \omega _2 )\alpha _3  =
0,}\label{eq18} \\
& \displaystyle{2\alpha _1 \alpha _2 (\omega _1^2  - \omega _2^2  +
\alpha _1 ) - (\alpha _1^2  - \alpha _2^2 )(2\omega _1 \omega _2  +
\alpha _2 ) = 0}\label{eq19}
\end{eqnarray}""",
    "ratio": r"""$$
\displaystyle{ \frac{\omega _1^2 - \omega _2^2 + \alpha _1 }{\alpha
_1^2  - \alpha _2^2}=\frac{2\omega _1 \omega _2 + \alpha _2
}{2\alpha _1 \alpha _2}}
$$""",
    "eq20": r"""\begin{equation}\label{eq20}
\begin{array}{c}
\displaystyle{\omega _1^2  - \omega _2^2  + \alpha _1  = {\frac {\alpha _1^2  - \alpha _2^2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k},}  \\
\displaystyle{2\omega _1 \omega _2  + \alpha _2  = {\frac{2\alpha _1
\alpha _2 } {\alpha _1^2  + \alpha _2^2 }}\sqrt {k}.}
\end{array}
\end{equation}""",
    "area": r"""$$
L = \alpha _1 \omega _1  + \alpha _2 \omega _2  + \frac{1}{2}\alpha
_3 \omega _3  \equiv \ell.
$$""",
    "eq21": r"""\begin{equation}\label{eq21}
\begin{array}{l}
\displaystyle{\Psi  =  - \frac{1}{2} (\alpha _1^2  + \alpha _2^2
)[\omega _3 - 2{\frac{\alpha _1 \omega _1  + \alpha _2 \omega _2 }
{\alpha _1^2  + \alpha _2^2 }}]^2  +}   \\[2mm]
\displaystyle{\phantom{\Psi=} + \frac{1} {\alpha _1^2  + \alpha _2^2
} [(\alpha_1^2 - \alpha _2^2 )(\omega _1^2  - \omega _2^2  + \alpha
_1 ) + 2\alpha _1 \alpha _2 (2\omega _1 \omega _2  + \alpha _2 )].}
\end{array}
\end{equation}""",
    "eq22": r"""\begin{equation}\label{eq22}
2\ell^2  - h = \sqrt {k}.
\end{equation}""",
}

INLINE = [
    r"""{\bs \beta} = 0""",
    r"""{\bs \alpha} \times {\bs \beta} = 0""",
    r"""{\bs \alpha} \times {\bs \beta} \ne 0""",
    r"""\sqrt
{A_3 /u_0 }""",
    r"""A_3=1""",
    r"""i^2=1""",
    r"""\tau=it""",
    r""" \theta ' = Q_2""",
    r"""Q'_1  = \frac{1}{2}Q_2 \omega _3 + ...""",
    r"""m = \frac{1}{2},n =  - \frac{1}{2}""",
    r"""F_2  = U_1  - U_2""",
    r"""U_1-U_2""",
    r"""{( {\bs \alpha},{\bs \alpha}) = 1}""",
    r"""\Psi  = 2L^2  - H""",
    r"""\sqrt k""",
    r"""(2L^2  - H)^2
- K""",
]
