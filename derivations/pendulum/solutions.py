r"""2. The motions: oscillation, rotation, and the one between them."""

from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene, Section

from .motion import halved

section = Section("2", "The motions in elliptic functions", copied=False)

swing = section.display(
    "swing",
    r"""
x = k\operatorname{sn}(\omega(t-t_0),k), \quad
y = \operatorname{dn}(\omega(t-t_0),k), \quad
w = 2k\omega\operatorname{cn}(\omega(t-t_0),k)""",
)

turn = section.display(
    "turn",
    r"""
x = \operatorname{sn}(\frac{\omega(t-t_0)}{k},k), \quad
y = \operatorname{cn}(\frac{\omega(t-t_0)}{k},k), \quad
w = \frac{2\omega}{k}\operatorname{dn}(\frac{\omega(t-t_0)}{k},k)""",
)

between = section.display(
    "between",
    r"""
x = \tanh(\omega(t-t_0)), \quad
y = \frac{1}{\cosh(\omega(t-t_0))}, \quad
w = \frac{2\omega}{\cosh(\omega(t-t_0))}""",
)

levels = section.display(
    "levels",
    r"""
\frac12w^2-\omega^2(y^2-x^2)=\omega^2(2k^2-1), \quad
\frac12w^2-\omega^2(y^2-x^2)=\omega^2(\frac{2}{k^2}-1), \quad
\frac12w^2-\omega^2(y^2-x^2)=\omega^2""",
)

scene = Scene(constants=(r"\omega", "t_0"), nonzero=(r"\omega",))
with_modulus = scene.having(constants=("k",), nonzero=("k",))
MOTIONS = {
    "swing": (with_modulus.called("oscillation").defining(swing), "it oscillates, with $k<1$"),
    "turn": (with_modulus.called("rotation").defining(turn), "it turns round, with $k<1$"),
    "between": (scene.called("between").defining(between), "it goes up for ever"),
}

for number, (name, (on, words)) in enumerate(MOTIONS.items(), start=1):
    section.states(
        Identity,
        halved,
        on=on,
        says=f"the motion where {words}, satisfies the equations of motion",
        ids=tuple(f"{name}.{letter}" for letter in ("x", "y", "w", "circle")),
    )
    section.states(
        Identity,
        levels[number],
        on=on,
        says=f"the energy of the motion where {words}",
        ids=(f"{name}.energy",),
    )

amplitude = section.display(
    "amplitude", r"\theta=2\operatorname{am}(\frac{\omega(t-t_0)}{k},k), \quad \dot\theta=w"
)
section.states(
    Identity,
    amplitude[2],
    on=MOTIONS["turn"][0].defining(amplitude[1]),
    says="the angle of the pendulum that turns round",
    ids=("amplitude",),
)

quarter = section.lemma(
    "quarter",
    r"\operatorname{sn}(K,k)=1, \quad \operatorname{cn}(K,k)=0, \quad \operatorname{dn}(K,k)=k'",
    "https://dlmf.nist.gov/22.5.T1: the values at the quarter period",
)
complementary = section.lemma(
    "complementary", "k^2+k'^2=1", "https://dlmf.nist.gov/22.2: the moduli"
)
later = section.display(
    "later",
    r"""
k\operatorname{sn}(\omega(t-t_0)+2K,k)=-x, \quad
\operatorname{dn}(\omega(t-t_0)+2K,k)=y, \quad
2k\omega\operatorname{cn}(\omega(t-t_0)+2K,k)=-w""",
)
section.states(
    Identity,
    later,
    on=MOTIONS["swing"][0].having(constants=("K",)).solving("k'", complementary[1]).taking(quarter),
    says=r"after the time $2K/\omega$ it is on the other side: the period is $4K/\omega$",
    ids=("later.x", "later.y", "later.w"),
)
