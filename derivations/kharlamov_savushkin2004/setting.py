r"""1. The problem: two constant fields in the Kowalevski case, and N^4 (Kharlamov 2002)."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Change, Scene, Section

section = Section("1", "The problem")

OMEGA = (r"\omega_1", r"\omega_2", r"\omega_3")
ALPHA = (r"\alpha_1", r"\alpha_2", r"\alpha_3")
BETA = (r"\beta_1", r"\beta_2", r"\beta_3")
GAMMA = (r"\gamma_1", r"\gamma_2", r"\gamma_3")
FRAME = {
    r"\boldsymbol{\omega}": OMEGA,
    r"\boldsymbol{\alpha}": ALPHA,
    r"\boldsymbol{\beta}": BETA,
}
X = ("x_1", "x_2", "y_1", "y_2", "z_1", "z_2", "w_1", "w_2")
PAIRS = (("x_1", "x_2"), ("y_1", "y_2"), ("z_1", "z_2"), ("w_1", "w_2"))
PAPER = "Kharlamov (2002)"

eq3 = section.lemma(
    "eq3",
    r"""
\dot {\bs \alpha} = {\bs \alpha} \times {\bs \omega}, \quad
\dot {\bs \beta} = {\bs \beta} \times {\bs \omega}""",
    f"{PAPER}, equation (3)",
)

eq4 = section.lemma(
    "eq4",
    r"""
({\bs \alpha},{\bs \alpha}) = a^2, \quad ({\bs \beta},{\bs \beta}) = b^2, \quad
({\bs \alpha},{\bs \beta}) = c""",
    f"{PAPER}, equation (4)",
)

eq5 = section.lemma(
    "eq5",
    r"""
2\dot\omega_1 = \omega_2\omega_3 + \beta_3, \quad
2\dot\omega_2 = -\omega_1\omega_3 - \alpha_3, \quad
\dot\omega_3 = \alpha_2 - \beta_1""",
    f"{PAPER}, equation (5)",
)

integrals = section.lemma(
    "integrals",
    r"""
H = \omega_1^2 + \omega_2^2 + \frac12\omega_3^2 - \alpha_1 - \beta_2 \equiv h, \quad
K = (\omega_1^2 - \omega_2^2 + \alpha_1 - \beta_2)^2
+ (2\omega_1\omega_2 + \alpha_2 + \beta_1)^2 \equiv k""",
    f"{PAPER}, equations (17)",
)

unit = section.lemma("unit", r"i^2=-1", f"{PAPER}, above (9), corrected")

eq9 = section.lemma(
    "eq9",
    r"""
\begin{array}{ll}
x_1 = (\alpha_1 - \beta_2) + i(\alpha_2 + \beta_1), &
x_2 = (\alpha_1 - \beta_2) - i(\alpha_2 + \beta_1), \\
y_1 = (\alpha_1 + \beta_2) + i(\alpha_2 - \beta_1), &
y_2 = (\alpha_1 + \beta_2) - i(\alpha_2 - \beta_1), \\
z_1 = \alpha_3 + i\beta_3, & z_2 = \alpha_3 - i\beta_3, \\
w_1 = \omega_1 + i\omega_2, & w_2 = \omega_1 - i\omega_2
\end{array}""",
    f"{PAPER}, equation (9)",
)

tau = section.lemma("tau", r"\tau=it", PAPER)

c = section.lemma(
    "c",
    r"c_1 = z_1^2 + x_1y_2, \quad c_2 = z_2^2 + x_2y_1",
    f"{PAPER}, above (13)",
)

F = section.lemma(
    "F",
    r"""
F_1 = \sqrt{x_1x_2}\,\omega_3 - \frac{1}{\sqrt{x_1x_2}}(x_2z_1w_1 + x_1z_2w_2), \quad
F_2 = U_1 - U_2""",
    f"{PAPER}, above (12) and (15)",
)

U = section.lemma(
    "U",
    r"""
U_1 = \frac{x_2}{x_1}c_1(w_1^2 + x_1), \quad U_2 = \frac{x_1}{x_2}c_2(w_2^2 + x_2)""",
    f"{PAPER}, equation (13)",
)

N4 = section.lemma("N4", r"F_1=0, \quad F_2=0", f"{PAPER}, equations (15)")

p = section.display("p", r"p^2 = ({\bs \alpha},{\bs \alpha}) + ({\bs \beta},{\bs \beta})")

r = section.display("r", r"r^4 = c_1c_2 = (a^2-b^2)^2 + 4c^2")

root_of_c = section.lemma("root-of-c", r"r^2=\sqrt{c_1c_2}", "the positive root of the line above")

complex_integrals = section.lemma(
    "complex-integrals",
    r"""
h = w_1w_2 + \frac12\omega_3^2 - \frac12(y_1+y_2), \quad
k = (w_1^2+x_1)(w_2^2+x_2), \quad
p^2 = \frac12(x_1x_2+y_1y_2) + z_1z_2""",
    "the integrals in the variables (9)",
)

inverse = section.lemma(
    "inverse",
    r"""
\begin{array}{l}
\alpha_1 = \frac14(x_1+x_2+y_1+y_2), \quad \alpha_2 = \frac{1}{4i}(x_1-x_2+y_1-y_2), \quad
\alpha_3 = \frac12(z_1+z_2), \\
\beta_1 = \frac{1}{4i}(x_1-x_2-y_1+y_2), \quad \beta_2 = \frac14(y_1+y_2-x_1-x_2), \quad
\beta_3 = \frac{1}{2i}(z_1-z_2), \\
\omega_1 = \frac12(w_1+w_2), \quad \omega_2 = \frac{1}{2i}(w_1-w_2)
\end{array}""",
    "equations (9) solved for the initial variables",
)

# -- scenes --------------------------------------------------------------------

CHANGE = dict(zip(X, (eq9[k] for k in range(1, 9)), strict=True))
INTEGRALS = {"H": integrals[1], "h": integrals[1], "K": integrals[2], "k": integrals[2]}
COMPLEX = {
    "c_1": c[1],
    "c_2": c[2],
    "U_1": U[1],
    "U_2": U[2],
    "F_1": F[1],
    "F_2": F[2],
}
LENGTHS = {"a": eq4[1], "b": eq4[2]}
FIELD = (eq5[1], eq5[2], eq5[3], eq3[1], eq3[2])

initial = Scene(
    "initial variables",
    "the equations (3), (5), with the imaginary unit and the complex variables as abbreviations",
    vectors=FRAME,
    variables=(*OMEGA, *ALPHA, *BETA),
    field=FIELD,
    definitions={**INTEGRALS, **CHANGE, "c": eq4[3], "c_1": c[1], "c_2": c[2]},
    roots={**LENGTHS, "p": p[1], r"\sqrt{c_1c_2}": None, "r": root_of_c[1]},
    unit=unit[1],
    clock=tau[1],
)

change = Change(initial, tuple(eq9[k] for k in range(1, 9)), tau[1])

# -- claims --------------------------------------------------------------------

section.claim(
    Identity("r", initial, r[1], "the constant $r$"),
    *(
        Identity(f"inverse.{k}", initial, inverse[k], "an initial variable by the complex ones")
        for k in range(1, 9)
    ),
    Identity("complex-energy", initial, complex_integrals[1], "the energy in complex variables"),
    Identity("complex-K", initial, complex_integrals[2], "the integral $K$ in complex variables"),
    Identity("complex-p", initial, complex_integrals[3], "the constant $p$ in complex variables"),
)
