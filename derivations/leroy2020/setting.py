r"""1. The equations of motion in principal axes, the integrals, and the note's quantities."""

from kowalevski_cas.paper.claims import FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Scene, Section

section = Section("1", "The equations of motion, and notation")

MOMENTA = ("m_1", "m_2", "m_3")

jacobi = section.display(
    "jacobi",
    r"""
\frac{d}{du}\operatorname{sn}u = \operatorname{cn}u\operatorname{dn}u, \quad
\frac{d}{du}\operatorname{cn}u = -\operatorname{sn}u\operatorname{dn}u, \quad
\frac{d}{du}\operatorname{dn}u = -k^2\operatorname{sn}u\operatorname{cn}u""",
)

hyperbolic = section.display(
    "hyperbolic",
    r"""
\frac{d}{du}\tanh u = \operatorname{sech}^2u, \quad
\frac{d}{du}\operatorname{sech}u = -\operatorname{sech}u\tanh u""",
)

functions = Scene("functions", constants=("k",), time="u")

for printed in (jacobi, hyperbolic):
    section.states(Identity, printed, on=functions, says="derivatives that the note recalls")

in_axes = section.display(
    "in-axes",
    r"""
\dot{\mathbf m} = \begin{pmatrix}m_1\\m_2\\m_3\end{pmatrix}\times
\begin{pmatrix}m_1/I_1\\m_2/I_2\\m_3/I_3\end{pmatrix}""",
)

euler = section.display(
    "eqneuler",
    r"""
\dot m_1 = m_2m_3(1/I_3-1/I_2), \quad \dot m_2 = m_3m_1(1/I_1-1/I_3), \quad
\dot m_3 = m_1m_2(1/I_2-1/I_1)""",
    label="(1)",
)

body = Scene(
    "free body",
    vectors={r"\mathbf{m}": MOMENTA},
    variables=MOMENTA,
    constants=("I_1", "I_2", "I_3", r"\mathrm{rad}"),
    nonzero=("I_1", "I_2", "I_3", r"\mathrm{rad}"),
).moving(euler)

section.states(Identity, in_axes, on=body, says="Euler's equation, by coordinates")

integrals = section.display(
    "integrals",
    r"""
G^2 = m_1^2+m_2^2+m_3^2, \quad
2T\mathrm{rad}^2 = \frac{m_1^2}{I_1}+\frac{m_2^2}{I_2}+\frac{m_3^2}{I_3}""",
)

for number, what in enumerate(("the sphere is invariant", "the kinetic energy is constant"), 1):
    section.states(
        FirstIntegral,
        integrals[number],
        on=body.having(constants=("G", "T")),
        says=what,
        ids=(f"integral.{number}",),
    )

names = section.display(
    "names", r"I_{jh} = I_j-I_h, \quad \Delta_j = G^2-2TI_j\mathrm{rad}^2, \quad j,h=1,2,3"
)

amplitudes = section.lemma(
    "amplitudes",
    r"""
B_{13} = \sqrt{\frac{I_1\Delta_3}{I_{13}}}, \quad B_{21} = \sqrt{\frac{I_2\Delta_1}{I_{21}}}, \quad
B_{23} = \sqrt{\frac{I_2\Delta_3}{I_{23}}}, \quad B_{31} = \sqrt{\frac{I_3\Delta_1}{I_{31}}}""",
    r"$B_{jh}=\sqrt{\pm\frac{I_j\Delta_h}{I_{jh}}}$, with the sign that the note gives in words",
)

moduli = section.display(
    "moduli",
    r"""
k = \sqrt{-\frac{\Delta_1I_{32}}{\Delta_3I_{21}}}, \quad
\lambda_1 = \sqrt{\frac{\Delta_1I_{32}}{I_1I_2I_3}}, \quad
\lambda_3 = \sqrt{\frac{\Delta_3I_{12}}{I_1I_2I_3}}""",
)

by_momenta = (
    body.called("free body, with its integrals")
    .solving("G", integrals[1])
    .defining(
        section.lemma(
            "energy",
            r"T=\frac{1}{2\mathrm{rad}^2}(\frac{m_1^2}{I_1}+\frac{m_2^2}{I_2}+\frac{m_3^2}{I_3})",
            "the line above, solved for the energy",
        ),
        names,
    )
)

section.states(
    Identity,
    section.inline("energy-by-Delta", r"T = \frac{G^2-\Delta_2}{2I_2\mathrm{rad}^2}"),
    on=by_momenta,
    says="values of the energy determine the modes",
)

section.identity(
    "Delta",
    r"""
\Delta_2 = m_1^2(1-\frac{I_2}{I_1})+m_3^2(1-\frac{I_2}{I_3})
= m_1^2\frac{I_{12}}{I_1}+m_3^2\frac{I_{32}}{I_3}, \quad
\Delta_1 = m_2^2\frac{I_{21}}{I_2}+m_3^2\frac{I_{31}}{I_3}, \quad
\Delta_3 = m_1^2\frac{I_{13}}{I_1}+m_2^2\frac{I_{23}}{I_2}""",
    on=by_momenta,
    says="without cancellations",
    ids=("Delta.2", "Delta.1", "Delta.3"),
)

SIGNS = tuple(
    rf"\sqrt{{{one}}}" for one in ("I_1", "I_2", "I_3", "I_2-I_1", "I_3-I_1", "I_3-I_2")
)  # the moments of inertia are positive, and increase
CASES = (*SIGNS, r"\sqrt{\Delta_1}", r"\sqrt{-\Delta_3}")

ROOTS = (
    r"\sqrt{\frac{I_1\Delta_3}{I_{13}}}",
    r"\sqrt{\frac{I_2\Delta_1}{I_{21}}}",
    r"\sqrt{\frac{I_2\Delta_3}{I_{23}}}",
    r"\sqrt{\frac{I_3\Delta_1}{I_{31}}}",
    r"\sqrt{-\frac{\Delta_1I_{32}}{\Delta_3I_{21}}}",
    r"\sqrt{\frac{\Delta_1I_{32}}{I_1I_2I_3}}",
    r"\sqrt{\frac{\Delta_3I_{12}}{I_1I_2I_3}}",
)

constants = (
    Scene(
        "constants of a motion",
        constants=("I_1", "I_2", "I_3", "G", "T", r"\mathrm{rad}"),
        nonzero=(*CASES, "G", r"\mathrm{rad}"),
    )
    .defining(names)
    .adjoining(*CASES, *ROOTS)
    .defining(amplitudes, moduli)
)

section.identity(
    "norm",
    r"B_{31}^2+B_{13}^2 = \frac{\Delta_1I_3-\Delta_3I_1}{I_{31}} = G^2",
    on=constants,
    says="the amplitudes and the norm",
)
