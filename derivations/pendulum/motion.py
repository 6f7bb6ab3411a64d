r"""1. The equation of motion, its integral, and half the angle."""

from kowalevski_cas.paper.claims import FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Scene, Section

section = Section("1", "The equation of motion", copied=False)

equation = section.display("equation", r"\dot\theta=w, \quad \dot w=-\omega^2\sin\theta")

energy = section.display("energy", r"\frac12w^2-\omega^2\cos\theta")

half = section.display("half", r"x=\sin\frac{\theta}{2}, \quad y=\cos\frac{\theta}{2}")

halved = section.display(
    "halved",
    r"\dot x=\frac12yw, \quad \dot y=-\frac12xw, \quad \dot w=-2\omega^2xy, \quad x^2+y^2=1",
)

pendulum = Scene("pendulum", variables=(r"\theta", "w"), constants=(r"\omega",)).moving(equation)

section.claim(
    FirstIntegral("energy", pendulum, "the energy, with the mass and length 1", printed=energy[1])
)

section.states(
    Identity,
    halved,
    on=pendulum.defining(half),
    says="the equations of motion in the sine and the cosine of half the angle",
    ids=("half.x", "half.y", "half.w", "half.circle"),
)
