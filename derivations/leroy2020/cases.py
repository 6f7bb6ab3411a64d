r"""2. The three cases of the solution of Euler's equation."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .setting import MOMENTA, ROOTS, SIGNS, amplitudes, constants, euler, moduli, names

section = Section("2", "Solution of Euler's equation")

ARTICLE = (
    "Note that it differs in sign from the one given by Celledoni et al.: the sign error is visible "
    "in that it does not yield the proper precession direction."
)

sign = section.lemma("sign", r"\sigma^2=1", "the sign of a component of the initial value")

on_case = constants.having(constants=(r"\nu",), vectors={r"\mathbf{m}": MOMENTA})

# -- case (i) ----------------------------------------------------------------------

solution_i = section.display(
    "solution-i",
    r"""
\mathbf m = \begin{pmatrix}\sigma B_{13}\operatorname{dn}(\lambda t-\nu,k)\\
-B_{21}\operatorname{sn}(\lambda t-\nu,k)\\
B_{31}\operatorname{cn}(\lambda t-\nu,k)\end{pmatrix}""",
)

eliminated_i = section.display(
    "solneuleri",
    r"""
-\sigma\lambda k^2B_{13} = -B_{21}B_{31}(1/I_3-1/I_2), \quad
-\lambda B_{21} = \sigma B_{13}B_{31}(1/I_1-1/I_3), \quad
-\lambda B_{31} = -\sigma B_{13}B_{21}(1/I_2-1/I_1)""",
    label="(2)",
)

lambda_i = section.display(
    "lambda-i",
    r"""
\lambda = \sigma\frac{B_{13}B_{21}}{B_{31}}\frac{I_1-I_2}{I_1I_2}
= \sigma\sqrt{\frac{I_1\Delta_3}{I_{13}}\frac{I_2\Delta_1}{I_{21}}\frac{I_{31}}{I_3\Delta_1}}
\frac{I_1-I_2}{I_1I_2}
= \sigma\sqrt{\frac{-\Delta_3}{I_{21}I_1I_2I_3}}(I_1-I_2)
= -\sigma\sqrt{\frac{-\Delta_3I_{21}}{I_1I_2I_3}} = -\sigma\lambda_3""",
)

value_i = section.lemma("value-i", r"\lambda=-\sigma\lambda_3", "the last member of the line above")

case_i = on_case.called("case (i)").adjoining(sign).defining(value_i)
moving_i = case_i.called("motion in case (i)").defining(solution_i)

section.states(
    Identity,
    lambda_i,
    on=case_i.adjoining(
        r"\sqrt{\frac{I_1\Delta_3}{I_{13}}\frac{I_2\Delta_1}{I_{21}}\frac{I_{31}}{I_3\Delta_1}}",
        r"\sqrt{\frac{-\Delta_3}{I_{21}I_1I_2I_3}}",
        r"\sqrt{\frac{-\Delta_3I_{21}}{I_1I_2I_3}}",
    ),
    says=r"in case (i) the third equation of (2) gives $\lambda=-\sigma\lambda_3$",
)
section.states(
    Identity, eliminated_i, on=case_i, says=r"this value of $\lambda$ satisfies the equations"
)
section.states(
    Identity,
    euler,
    on=moving_i,
    says="the motion of case (i) satisfies Euler's equations",
    ids=("euler-i.1", "euler-i.2", "euler-i.3"),
)
section.deny(
    Identity(
        "article-i",
        case_i,
        r"the article's $\lambda=\sigma\lambda_3$ satisfies the third equation of (2)",
        printed=section.lemma(
            "article-i",
            r"\sigma\frac{B_{13}B_{21}}{B_{31}}\frac{I_1-I_2}{I_1I_2} = \sigma\lambda_3",
            "the value that the article gives, by the words of the note",
        )[1],
        sentence=ARTICLE,
    )
)

# -- case (ii) ---------------------------------------------------------------------

solution_ii = section.display(
    "solution-ii",
    r"""
\mathbf m = \begin{pmatrix}B_{13}\operatorname{cn}(\lambda t-\nu,k^{-1})\\
-B_{23}\operatorname{sn}(\lambda t-\nu,k^{-1})\\
\sigma B_{31}\operatorname{dn}(\lambda t-\nu,k^{-1})\end{pmatrix}""",
)

eliminated_ii = section.display(
    "solneulerii",
    r"""
-\lambda B_{13} = -\sigma B_{23}B_{31}(1/I_3-1/I_2), \quad
-\lambda B_{23} = \sigma B_{13}B_{31}(1/I_1-1/I_3), \quad
-\sigma\lambda k^{-2}B_{31} = -B_{13}B_{23}(1/I_2-1/I_1)""",
    label="(3)",
)

lambda_ii = section.display(
    "lambda-ii",
    r"""
\lambda = \sigma\frac{B_{23}B_{31}}{B_{13}}\frac{I_2-I_3}{I_2I_3}
= \sigma\sqrt{\frac{I_2\Delta_3}{I_{23}}\frac{I_3\Delta_1}{I_{31}}\frac{I_{13}}{I_1\Delta_3}}
\frac{I_2-I_3}{I_2I_3}
= \sigma\sqrt{\frac{-\Delta_1}{I_{23}I_1I_2I_3}}(I_2-I_3)
= -\sigma\sqrt{\frac{-\Delta_1I_{23}}{I_1I_2I_3}} = -\sigma\lambda_1""",
)

value_ii = section.lemma(
    "value-ii", r"\lambda=-\sigma\lambda_1", "the last member of the line above"
)

case_ii = on_case.called("case (ii)").adjoining(sign).defining(value_ii)
moving_ii = case_ii.called("motion in case (ii)").defining(solution_ii)

section.states(
    Identity,
    lambda_ii,
    on=case_ii.adjoining(
        r"\sqrt{\frac{I_2\Delta_3}{I_{23}}\frac{I_3\Delta_1}{I_{31}}\frac{I_{13}}{I_1\Delta_3}}",
        r"\sqrt{\frac{-\Delta_1}{I_{23}I_1I_2I_3}}",
        r"\sqrt{\frac{-\Delta_1I_{23}}{I_1I_2I_3}}",
    ),
    says=r"in case (ii) the first equation of (3) gives $\lambda=-\sigma\lambda_1$",
)
section.states(
    Identity, eliminated_ii, on=case_ii, says=r"this value of $\lambda$ satisfies the equations"
)
section.states(
    Identity,
    euler,
    on=moving_ii,
    says="the motion of case (ii) satisfies Euler's equations",
    ids=("euler-ii.1", "euler-ii.2", "euler-ii.3"),
)
section.deny(
    Identity(
        "article-ii",
        case_ii,
        r"the article's $\lambda=\sigma\lambda_1$ satisfies the first equation of (3)",
        printed=section.lemma(
            "article-ii",
            r"\sigma\frac{B_{23}B_{31}}{B_{13}}\frac{I_2-I_3}{I_2I_3} = \sigma\lambda_1",
            "the value that the article gives, by the words of the note",
        )[1],
        sentence="Again, note the change of sign due to the fact that $I_2-I_3 < 0$.",
    )
)

# -- case (iii) --------------------------------------------------------------------

signs = section.lemma("signs", r"\sigma'^2=1, \quad \sigma''^2=1", "the signs of two components")

energy_iii = section.lemma(
    "energy-iii", r"T=\frac{G^2}{2I_2\mathrm{rad}^2}", r"$2TI_2\mathrm{rad}^2=G^2$, solved for $T$"
)

solution_iii = section.display(
    "solution-iii",
    r"""
\mathbf m = \begin{pmatrix}\sigma'B_{13}\operatorname{sech}(\lambda t-\nu)\\
G\tanh(\lambda t-\nu)\\
\sigma''B_{31}\operatorname{sech}(\lambda t-\nu)\end{pmatrix}""",
)

eliminated_iii = section.display(
    "solneuleriii",
    r"""
-\sigma'\lambda B_{13} = \sigma''GB_{31}(1/I_3-1/I_2), \quad
\lambda G = \sigma'\sigma''B_{13}B_{31}(1/I_1-1/I_3), \quad
-\sigma''\lambda B_{31} = \sigma'GB_{13}(1/I_2-1/I_1)""",
    label="(4)",
)

lambda_2 = section.display(
    "lambda-2", r"\lambda_2 = \frac{1}{G}\sqrt{-\frac{\Delta_1\Delta_3}{I_1I_3}}"
)

value_iii = section.display("value-iii", r"\lambda=\sigma'\sigma''\lambda_2")

lambda_iii = section.display(
    "lambda-iii",
    r"""
\lambda = \sigma'\sigma''\frac{B_{13}B_{31}}{G}\frac{I_3-I_1}{I_1I_3}
= \sigma'\sigma''\frac{1}{G}\sqrt{\frac{I_1\Delta_3}{I_{13}}\frac{I_3\Delta_1}{I_{31}}}
\frac{I_3-I_1}{I_1I_3}
= \sigma'\sigma''\frac{1}{G}\sqrt{-\frac{\Delta_1\Delta_3}{I_1I_3}}""",
)

first_iii = section.display(
    "first-iii",
    r"""
\lambda = -\sigma'\sigma''G\frac{B_{31}}{B_{13}}\frac{I_2-I_3}{I_2I_3}
= -\sigma'\sigma''G\sqrt{\frac{I_3\Delta_1}{I_{31}}\frac{I_{13}}{I_1\Delta_3}}
\frac{I_2-I_3}{I_2I_3}
= -\sigma'\sigma''G\sqrt{-\frac{\Delta_1}{I_1I_3\Delta_3}}\frac{I_2-I_3}{I_2}
= \sigma'\sigma''G\sqrt{-\frac{\Delta_1}{I_1I_3\Delta_3}}(\frac{I_3}{I_2}-1)""",
)

last_iii = section.display(
    "last-iii",
    r"""
\lambda = \sigma'\sigma''G\sqrt{-\frac{\Delta_1}{I_1I_3\Delta_3}}(\frac{2TI_3\mathrm{rad}^2}{G^2}-1)
= \sigma'\sigma''\frac{1}{G}\sqrt{-\frac{\Delta_1\Delta_3}{I_1I_3}}""",
)

on_separatrix = section.display(
    "on-separatrix", r"2TI_3\mathrm{rad}^2-G^2 = -\Delta_3 = 2T\mathrm{rad}^2(I_3-I_2)"
)

separatrix = (
    Scene(
        "separatrix",
        vectors={r"\mathbf{m}": MOMENTA},
        constants=("I_1", "I_2", "I_3", "G", r"\mathrm{rad}", r"\nu"),
        nonzero=(*SIGNS, r"\sqrt{G}", r"\mathrm{rad}"),
    )
    .adjoining(*SIGNS, r"\sqrt{G}")
    .solving(r"\sigma'", signs[1])
    .solving(r"\sigma''", signs[2])
    .defining(energy_iii, names)
    .adjoining(*ROOTS[:4], *ROOTS[5:], r"\sqrt{-\frac{\Delta_1\Delta_3}{I_1I_3}}")
    .defining(amplitudes[1], amplitudes[4], moduli[2], moduli[3], lambda_2)
)
case_iii = separatrix.called("case (iii)").defining(value_iii)

section.states(Identity, on_separatrix, on=case_iii, says="where $\\Delta_2=0$")
section.states(
    Identity,
    lambda_iii,
    on=case_iii.adjoining(r"\sqrt{\frac{I_1\Delta_3}{I_{13}}\frac{I_3\Delta_1}{I_{31}}}"),
    says=r"in case (iii) the second equation of (4) gives $\lambda$",
)
section.states(
    Identity,
    first_iii,
    on=case_iii.adjoining(
        r"\sqrt{\frac{I_3\Delta_1}{I_{31}}\frac{I_{13}}{I_1\Delta_3}}",
        r"\sqrt{-\frac{\Delta_1}{I_1I_3\Delta_3}}",
    ),
    says="the first equation of (4) gives the same value",
)
section.states(
    Identity,
    last_iii,
    on=case_iii.adjoining(r"\sqrt{-\frac{\Delta_1}{I_1I_3\Delta_3}}"),
    says="the first equation of (4) gives the same value",
)
section.states(
    Identity, eliminated_iii, on=case_iii, says=r"this value of $\lambda$ satisfies the equations"
)
section.states(
    Identity,
    euler,
    on=case_iii.called("motion in case (iii)").defining(solution_iii),
    says="the motion of case (iii) satisfies Euler's equations",
    ids=("euler-iii.1", "euler-iii.2", "euler-iii.3"),
)
section.identity(
    "common",
    r"\lambda_2 = \lambda_1 = \lambda_3",
    on=case_iii,
    says=r"in case (iii) $\lambda_2$ is the common value of $\lambda_1$ and $\lambda_3$",
)

# -- phases -------------------------------------------------------------------------

initial = section.lemma(
    "initial",
    r"""
m_{01} = \sigma B_{13}\operatorname{dn}(-\nu,k), \quad m_{02} = -B_{21}\operatorname{sn}(-\nu,k), \quad
m_{03} = B_{31}\operatorname{cn}(-\nu,k)""",
    "the vector $\\mathbf m_0$ of case (i), by its components",
)
initial_ii = section.lemma(
    "initial-ii",
    r"""
m_{01} = B_{13}\operatorname{cn}(-\nu,k^{-1}), \quad
m_{02} = -B_{23}\operatorname{sn}(-\nu,k^{-1}), \quad
m_{03} = \sigma B_{31}\operatorname{dn}(-\nu,k^{-1})""",
    "the vector $\\mathbf m_0$ of case (ii), by its components",
)
section.states(
    Identity,
    section.lemma(
        "phase",
        r"\frac{m_{02}}{m_{03}} = \frac{B_{21}}{B_{31}}\operatorname{sc}(\nu,k)",
        "the note has the tangent of the amplitude, which is sc",
    ),
    on=case_i.defining(initial),
    says="the quotient that gives the phase",
)
section.states(
    Identity,
    section.lemma(
        "phase-ii",
        r"\frac{m_{02}}{m_{01}} = \frac{B_{23}}{B_{13}}\operatorname{sc}(\nu,k^{-1})",
        "the note has the tangent of the amplitude, which is sc",
    ),
    on=case_ii.defining(initial_ii),
    says="the quotient that gives the phase",
)

# -- the complementary parameter --------------------------------------------------------

complementary = section.display(
    "complementary",
    r"""
m_c = 1-k^2 = 1+\frac{\Delta_1I_{32}}{\Delta_3I_{21}}, \quad
m_c = \frac{\Delta_3I_{21}+\Delta_1I_{32}}{\Delta_3I_{21}}
= \frac{(G^2-2TI_3)(I_2-I_1)+(G^2-2TI_1)(I_3-I_2)}{\Delta_3I_{21}}
= \frac{G^2(I_3-I_1)+2TI_2(I_1-I_3)}{\Delta_3I_{21}}
= \frac{\Delta_2I_{31}}{\Delta_3I_{21}}""",
)
with_m_c = section.lemma("m-c", "m_c=1-k^2", "the first equality above")
section.states(
    Identity,
    complementary,
    on=constants.called("parameter in case (i)").defining(with_m_c),
    says="the complementary parameter in case (i)",
)
section.identity(
    "complementary-ii",
    r"""
1-k^{-2} = 1+\frac{\Delta_3I_{21}}{\Delta_1I_{32}}
= \frac{\Delta_1I_{32}+\Delta_3I_{21}}{\Delta_1I_{32}} = \frac{\Delta_2I_{31}}{\Delta_1I_{32}}""",
    on=constants,
    says="the complementary parameter in case (ii)",
)
section.states(
    Identity,
    section.lemma(
        "complementary-mended",
        r"""
m_c = \frac{(G^2-2TI_3\mathrm{rad}^2)(I_2-I_1)+(G^2-2TI_1\mathrm{rad}^2)(I_3-I_2)}{\Delta_3I_{21}}
= \frac{G^2(I_3-I_1)+2TI_2\mathrm{rad}^2(I_1-I_3)}{\Delta_3I_{21}}""",
        "the same with the unit of the angle, which the note drops here",
    ),
    on=constants.called("parameter in case (i)").defining(with_m_c),
    says="with the unit of the angle the parameter is right",
    ours=True,
)
