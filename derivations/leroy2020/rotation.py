r"""3. The angle of the rotation about the momentum, as the article has it."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .cases import case_i, case_ii
from .setting import by_momenta, constants

section = Section("3", "Integration of the rotation matrix")

rate = section.display(
    "rate",
    r"""
\dot\psi = \frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1+\frac{I_{12}I_{23}G^2}{I_2^2\Delta_1\Delta_3}m_2^2}\right)
= \frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1-\frac{G^2}{B_{21}^2B_{23}^2}m_2^2}\right)""",
)

section.states(
    Identity,
    section.lemma(
        "rates",
        r"""
\frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1+\frac{I_{12}I_{23}G^2}{I_2^2\Delta_1\Delta_3}m_2^2}\right)
= \frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1-\frac{G^2}{B_{21}^2B_{23}^2}m_2^2}\right)""",
        "both right sides above",
    ),
    on=constants.having(constants=("m_2",)),
    says="the two forms of the rate are equal",
)

section.claim(
    Identity(
        "rate-of-frame",
        by_momenta,
        "the first form is the rate about the momentum of the frame of the momentum and its rate",
        printed=section.lemma(
            "rate-of-frame",
            r"""
\frac{2T\mathrm{rad}^2}{G}+\frac{\ddot{\mathbf m}\cdot(\mathbf m\times\dot{\mathbf m})}
{G\dot{\mathbf m}^2}
= \frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1+\frac{I_{12}I_{23}G^2}{I_2^2\Delta_1\Delta_3}m_2^2}\right)""",
            "the frame turns about the momentum by the angular velocity and in the body",
        )[1],
        ours=True,
    )
)

angle_i = section.display(
    "angle-i",
    r"""
\psi = \frac{2T\mathrm{rad}^2}{G}t+\frac{\Delta_2}{\lambda GI_2}
\Pi(\operatorname{am}(\lambda t-\nu,k),\frac{G^2}{B_{23}^2},k)""",
)
rate_i = section.display(
    "rate-i",
    r"""
\dot\psi = \frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1-\frac{G^2}{B_{23}^2}\operatorname{sn}^2(\lambda t-\nu,k)}\right)""",
)
section.states(
    Identity,
    rate_i,
    on=case_i.called("angle in case (i)").defining(angle_i),
    says="the integral of the rate in case (i)",
)

angle_ii = section.display(
    "angle-ii",
    r"""
\psi = \frac{2T\mathrm{rad}^2}{G}t+\frac{\Delta_2}{\lambda GI_2}
\Pi(\operatorname{am}(\lambda t-\nu,k^{-1}),\frac{G^2}{B_{21}^2},k^{-1})""",
)
rate_ii = section.display(
    "rate-ii",
    r"""
\dot\psi = \frac{2T\mathrm{rad}^2}{G}+\frac{\Delta_2}{GI_2}
\left(\frac{1}{1-\frac{G^2}{B_{21}^2}\operatorname{sn}^2(\lambda t-\nu,k^{-1})}\right)""",
)
section.states(
    Identity,
    rate_ii,
    on=case_ii.called("angle in case (ii)").defining(angle_ii),
    says="the integral of the rate in case (ii)",
)

section.states(
    Identity,
    section.lemma(
        "tanh",
        r"""
\frac{d}{dt}\left(\frac{t}{1-n}
-\frac{\sqrt{n}}{(1-n)\lambda}\operatorname{artanh}(\sqrt{n}\tanh(\lambda t-\nu))\right)
= \frac{1}{1-n\tanh^2(\lambda t-\nu)}""",
        "the note prints it as an indefinite integral",
    ),
    on=Scene("integral of case (iii)", constants=("n", r"\lambda", r"\nu")).adjoining(r"\sqrt{n}"),
    says="the integral that is useful in case (iii)",
)
