r"""4. The quaternion, and the angle by it, in the article and in the note."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .cases import on_case, separatrix, value_i
from .setting import by_momenta, constants, names

section = Section("4", "Integration of the quaternion")

relations_3 = section.display(
    "relations-3",
    r"""
p_1 = \frac{p_3m_1+p_0m_2}{G+m_3}, \quad p_2 = \frac{p_3m_2-p_0m_1}{G+m_3}, \quad
p_0^2+p_3^2 = \frac{G+m_3}{2G}""",
)
rate_3 = section.display(
    "rate-3",
    r"""
\dot\psi = \frac{2T\mathrm{rad}^2+Gm_3/I_3}{G+m_3}+4G\frac{p_3\dot p_0-p_0\dot p_3}{G+m_3}""",
)
quaternion_3 = section.display(
    "quaternion-3",
    r"""
p_0 = \sqrt\frac{1+m_3/G}{2}, \quad p_1 = \frac{m_2}{\sqrt{2G(G+m_3)}}, \quad
p_2 = \frac{-m_1}{\sqrt{2G(G+m_3)}}, \quad p_3 = 0""",
)
relations_1 = section.display(
    "relations-1",
    r"""
p_2 = \frac{p_1m_2+p_0m_3}{G+m_1}, \quad p_3 = \frac{p_1m_3-p_0m_2}{G+m_1}, \quad
p_0^2+p_1^2 = \frac{G+m_1}{2G}""",
)
quaternion_1 = section.display(
    "quaternion-1",
    r"""
p_0 = \sqrt\frac{1+m_1/G}{2}, \quad p_1 = 0, \quad p_2 = \frac{m_3}{\sqrt{2G(G+m_1)}}, \quad
p_3 = \frac{-m_2}{\sqrt{2G(G+m_1)}}""",
)

momentum = Scene(
    "momentum", constants=("m_1", "m_2", "m_3", "G"), nonzero=(r"\sqrt{G}",)
).adjoining(r"\sqrt{G}")

for axis, relations, quaternion in ((3, relations_3, quaternion_3), (1, relations_1, quaternion_1)):
    m = f"m_{axis}"
    roots = (rf"\sqrt\frac{{1+{m}/G}}{{2}}", rf"\sqrt{{2G(G+{m})}}", rf"\sqrt{{G+{m}}}")
    section.states(
        Identity,
        relations,
        on=momentum.having(nonzero=(roots[2],)).adjoining(*roots).defining(quaternion),
        says="the quaternion satisfies the relations",
    )

section.identity(
    "rate-1",
    r"""
\frac{2T\mathrm{rad}^2+Gm_1/I_1}{G+m_1} = \frac{G^2-\Delta_1+Gm_1}{I_1(G+m_1)}
= \frac{G}{I_1}-\frac{\Delta_1/I_1}{G+m_1}
= \frac{G}{I_1}-\frac{\Delta_1}{GI_1}\frac{1}{1+m_1/G}""",
    on=by_momenta,
    says="the rate of the angle in case (i)",
)
section.states(
    Identity,
    section.lemma(
        "rate-ii-3",
        r"""
\frac{2T\mathrm{rad}^2+Gm_3/I_3}{G+m_3} = \frac{G}{I_3}-\frac{\Delta_3}{GI_3}\frac{1}{1+m_3/G}""",
        "the rate by the quaternion, and its right side in case (ii)",
    ),
    on=by_momenta,
    says="the rate of the angle in case (ii)",
)

# -- the angle as the article has it -----------------------------------------------------

angle_article = section.display(
    "angle-article",
    r"""
\psi = \frac{G}{I_3}t+\frac{GI_{31}}{\lambda I_1I_3}
(\Pi(\operatorname{am}(\lambda t-\nu,k),-(\frac{B_{31}}{B_{13}})^2,k)
-B_{31}\frac{B_{13}}{B_{21}}\arctan(\frac{B_{21}}{B_{13}}\operatorname{sd}(\lambda t-\nu,k)))""",
)
rate_article = section.lemma(
    "rate-article",
    r"\dot\psi = \frac{G}{I_3}-\frac{\Delta_3}{GI_3}\frac{1}{1+\frac{B_{31}}{G}\operatorname{cn}(\lambda t-\nu,k)}",
    "the rate by the quaternion with $m_3$ of case (i)",
)
angle_mended = section.lemma(
    "angle-mended",
    r"""
\psi = \frac{G}{I_3}t+\frac{GI_{31}}{\lambda I_1I_3}
(\Pi(\operatorname{am}(\lambda t-\nu,k),-(\frac{B_{31}}{B_{13}})^2,k)
-\frac{B_{31}}{G}\frac{B_{13}}{B_{21}}\arctan(\frac{B_{21}}{B_{13}}\operatorname{sd}(\lambda t-\nu,k)))""",
    "the same with $B_{31}/G$, a number, for $B_{31}$",
)
positive = on_case.having(nonzero=(r"\sqrt{G}",)).adjoining(r"\sqrt{G}")
by_amplitudes = section.lemma(
    "by-amplitudes",
    r"""
G^2 = B_{31}^2+B_{13}^2, \quad B_{21}^2 = k^2G^2+(1-k^2)B_{31}^2, \quad
\Delta_3 = -\frac{B_{13}^2I_{31}}{I_1}""",
    "relations between the quantities of case (i)",
)
section.states(
    Identity,
    by_amplitudes,
    on=constants,
    says="relations between the quantities of case (i)",
    ours=True,
)

light = (
    Scene(
        "case (i), by the amplitudes",
        constants=("I_1", "I_3", "B_{13}", "B_{31}", "k", r"\lambda", r"\nu"),
        nonzero=("I_1", "I_3", "B_{13}", "B_{31}", r"\lambda"),
    )
    .defining(names[7])
    .adjoining(by_amplitudes[1], by_amplitudes[2])
    .defining(by_amplitudes[3])
)

for printed, ours, words in (
    (angle_article, False, r"the derivative of $\psi$ is $\dot\psi$ with $m_3$ of case (i)"),
    (angle_mended, True, r"with $B_{31}/G$ for $B_{31}$ the derivative of $\psi$ is $\dot\psi$"),
):
    section.claim(
        Identity(
            printed.id,
            light.called(f"case (i), {printed.id}").defining(printed),
            words,
            printed=rate_article[1],
            ours=ours,
        )
    )

# -- two integrals ---------------------------------------------------------------------

dn = section.display(
    "integraldn",
    r"""
J = \frac{1}{1-a^2}\left[\Pi(\operatorname{am}(u,k),\frac{a^2k^2}{a^2-1},k)
-a\sqrt\frac{1-a^2}{a^2(k^2-1)+1}
\arctan(\sqrt\frac{a^2(k^2-1)+1}{1-a^2}\operatorname{sc}(u,k))\right]""",
    label="(5)",
)
sech = section.display(
    "integralsech",
    r"""
J = u+\frac{2a}{\sqrt{1-a^2}}\arctan(\frac{a-1}{\sqrt{1-a^2}}\tanh\frac u2)""",
    label="(6)",
)
integrands = section.lemma(
    "integrands",
    r"""
\frac{dJ}{du} = \frac{1}{1+a\operatorname{dn}(u,k)}, \quad
\frac{dJ}{du} = \frac{1}{1+a\operatorname{sech}u}""",
    "the integrands, which the note has under the sign of the integrals $J$",
)
in_u = (
    Scene(constants=("a",), time="u").adjoining(r"\sqrt{1-a^2}").having(nonzero=(r"\sqrt{1-a^2}",))
)

section.claim(
    Identity(
        "integraldn",
        in_u.called("first integral")
        .having(constants=("k",))
        .adjoining(r"\sqrt\frac{1-a^2}{a^2(k^2-1)+1}", r"\sqrt\frac{a^2(k^2-1)+1}{1-a^2}")
        .defining(dn),
        "the integral that is useful for cases (i) and (ii)",
        printed=integrands[1],
    ),
    Identity(
        "integralsech",
        in_u.called("second integral").defining(sech),
        "the integral that is useful for case (iii)",
        printed=integrands[2],
    ),
)

# -- the angle as the note has it --------------------------------------------------------

plus = section.lemma("plus", r"\sigma=1", "with the preferred axes all signs are 1")

angles = section.display(
    "angles",
    r"""
\psi = \frac{G}{I_1}t+\frac{GI_{13}}{\lambda I_1I_3}
\Pi(\operatorname{am}(\lambda t-\nu,k),\frac{I_1I_{32}}{I_3I_{12}},k)
-\arctan(\sqrt\frac{I_2I_{31}}{I_3I_{21}}\operatorname{sc}(\lambda t-\nu,k)), \quad
\psi = \frac{G}{I_3}t+\frac{GI_{31}}{\lambda I_1I_3}
\Pi(\operatorname{am}(\lambda t-\nu,k^{-1}),\frac{I_3I_{21}}{I_1I_{23}},k^{-1})
+\arctan(\sqrt\frac{I_2I_{31}}{I_1I_{32}}\operatorname{sc}(\lambda t-\nu,k^{-1}))""",
)
rates = section.lemma(
    "rates-by-solutions",
    r"""
\dot\psi = \frac{G}{I_1}-\frac{\Delta_1}{GI_1}
\frac{1}{1+\frac{B_{13}}{G}\operatorname{dn}(\lambda t-\nu,k)}, \quad
\dot\psi = \frac{G}{I_3}-\frac{\Delta_3}{GI_3}
\frac{1}{1+\frac{B_{31}}{G}\operatorname{dn}(\lambda t-\nu,k^{-1})}, \quad
\dot\psi = \frac{G}{I_1}-\frac{\Delta_1}{GI_1}
\frac{1}{1+\frac{B_{13}}{G}\operatorname{sech}(\lambda t-\nu)}, \quad
\dot\psi = \frac{G}{I_3}-\frac{\Delta_3}{GI_3}
\frac{1}{1+\frac{B_{31}}{G}\operatorname{sech}(\lambda t-\nu)}""",
    "the rates, with the coordinate that does not change its sign as it is in each case",
)

# The angle in case (ii), which stands with the modulus 1/k, is not decided in a minute.
section.claim(
    Identity(
        "angle.1",
        positive.called("angle by the quaternion in case (i)")
        .adjoining(r"\sqrt\frac{I_2I_{31}}{I_3I_{21}}")
        .defining(plus, value_i, angles[1]),
        r"$\psi$ in case (i), by the quaternion about $\mathbf e_1$",
        printed=rates[1],
    )
)

both_plus = section.lemma(
    "both-plus", r"\lambda=\lambda_2", "with the preferred axes all signs are 1"
)

angles_iii = section.display(
    "angles-iii",
    r"""
\psi = (\frac{G}{I_1}-\frac{\Delta_1}{GI_1})t-\frac{2B_{13}\Delta_1}{\lambda GB_{31}I_1}
\arctan(\frac{B_{13}-G}{B_{31}}\tanh(\frac{\lambda t-\nu}{2})), \quad
\psi = \frac{G}{I_2}t
-2\arctan(\frac{B_{13}-G}{B_{31}}\tanh(\frac{\lambda t-\nu}{2})), \quad
\psi = \frac{G}{I_2}t
+2\arctan(\frac{B_{31}-G}{B_{13}}\tanh(\frac{\lambda t-\nu}{2}))""",
)

for number, (of, words) in enumerate(
    (
        (1, r"$\psi$ in case (iii), by the quaternion about $\mathbf e_1$"),
        (1, r"$\psi$ in case (iii), by the quaternion about $\mathbf e_1$, simplified"),
        (3, r"$\psi$ in case (iii), by the quaternion about $\mathbf e_3$"),
    ),
    start=1,
):
    section.claim(
        Identity(
            f"angle-iii.{number}",
            separatrix.called(f"angle by the quaternion in case (iii), {number}")
            .naming(r"\lambda", both_plus[1])
            .defining(angles_iii[number]),
            words,
            printed=rates[3 if of == 1 else 4],
        )
    )
