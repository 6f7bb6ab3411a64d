r"""Formulas of two documents of Principia, which stand beside the note on the free rigid body.

P. Leroy, *Rotational Motion of a Rigid Reference Frame*, and R. Leroy, on Hamiltonian mechanics:
documentation/Rotational Motion.tex and documentation/Hamiltonian Mechanics.tex of
https://github.com/mockingbirdnest/Principia at the commit 9ffb8b0c4e75. The formulas are those of
the documents, with their macros written out; what is false in print is said to be.
"""

import pytest

from kowalevski_cas import System
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

TRIHEDRON = [
    (r"\dot{\mathbf F}=\dot{\mathbf r}", r"\dot{\mathbf F}=\mathbf r"),
    (r"\dot{\mathbf B}=\mathbf r\wedge\ddot{\mathbf r}", r"\dot{\mathbf B}=\ddot{\mathbf r}\wedge\mathbf r"),
    (
        r"\dot{\mathbf N}=\dot{\mathbf B}\wedge\mathbf F+\mathbf B\wedge\dot{\mathbf F}",
        r"\dot{\mathbf N}=\dot{\mathbf B}\wedge\mathbf F-\mathbf B\wedge\dot{\mathbf F}",
    ),
    (
        r"\ddot{\mathbf B}=\dot{\mathbf r}\wedge\ddot{\mathbf r}+\mathbf r\wedge\dddot{\mathbf r}",
        r"\ddot{\mathbf B}=2\dot{\mathbf r}\wedge\ddot{\mathbf r}+\mathbf r\wedge\dddot{\mathbf r}",
    ),
    (
        r"\ddot{\mathbf N}=\ddot{\mathbf B}\wedge\mathbf F+2\dot{\mathbf B}\wedge\dot{\mathbf F}"
        r"+\mathbf B\wedge\ddot{\mathbf F}",
        r"\ddot{\mathbf N}=\ddot{\mathbf B}\wedge\mathbf F+\dot{\mathbf B}\wedge\dot{\mathbf F}"
        r"+\mathbf B\wedge\ddot{\mathbf F}",
    ),
    (r"(\mathbf n\wedge\mathbf f)\cdot\mathbf n=0", r"(\mathbf n\wedge\mathbf f)\cdot\mathbf b=0"),
    (r"(\mathbf b\wedge\mathbf f)\cdot\mathbf n=1", r"(\mathbf f\wedge\mathbf b)\cdot\mathbf n=1"),
    (
        r"\boldsymbol\omega\wedge\mathbf f=\dot{\mathbf f}",
        r"\boldsymbol\omega\wedge\mathbf f=\dot{\mathbf n}",
    ),
]  # fmt: skip
SLOW = [r"\boldsymbol\omega\wedge\mathbf n=\dot{\mathbf n}", r"\boldsymbol\omega\wedge\mathbf b=\dot{\mathbf b}"]  # fmt: skip


@pytest.fixture(scope="module")
def frame():
    """The trihedron of a motion of which the third derivative is any vector."""
    motion = System(r"\dddot{\mathbf r}=\mathbf j,\ \mathbf r=(x,y,z),\ \mathbf j=(a,b,c)")
    for formula in (
        r"\mathbf F=\mathbf r", r"\mathbf B=\mathbf r\wedge\dot{\mathbf r}",
        r"\mathbf N=\mathbf B\wedge\mathbf F", r"\mathbf f=\frac{\mathbf F}{|\mathbf F|}",
        r"\mathbf b=\frac{\mathbf B}{|\mathbf B|}", r"\mathbf n=\frac{\mathbf N}{|\mathbf N|}",
        r"\boldsymbol\omega=(\dot{\mathbf n}\cdot\mathbf b)\mathbf f"
        r"+(\dot{\mathbf b}\cdot\mathbf f)\mathbf n+(\dot{\mathbf f}\cdot\mathbf n)\mathbf b",
    ):  # fmt: skip
        motion.define(formula)
    return motion


@pytest.mark.slow
@pytest.mark.parametrize(("true", "false"), TRIHEDRON)
def test_the_trihedron_of_two_bodies_moves_as_is_printed(frame, true, false):
    assert frame.identity(true).verdict.green
    assert frame.identity(false).verdict == "refuted"


@pytest.mark.slow
@pytest.mark.parametrize("equation", SLOW)
def test_the_angular_velocity_is_that_of_the_trihedron(frame, equation):
    assert frame.identity(equation).verdict.green
    assert frame.identity(equation.replace("=", "=-")).verdict == "refuted"


FIRST = (
    r"\frac{d}{dt}\frac{\mathbf V}{|\mathbf V|}="
    r"\frac{\dot{\mathbf V}}{|\mathbf V|}-\mathbf V\frac{\mathbf V\cdot\dot{\mathbf V}}{|\mathbf V|^3}"
)
SECOND = (
    r"\frac{d^2}{dt^2}\frac{\mathbf V}{|\mathbf V|}=\frac{\ddot{\mathbf V}}{|\mathbf V|}"
    r"-2\dot{\mathbf V}\frac{\mathbf V\cdot\dot{\mathbf V}}{|\mathbf V|^3}"
    r"-\mathbf V\frac{|\dot{\mathbf V}|^2+\mathbf V\cdot\ddot{\mathbf V}}{|\mathbf V|^3}"
    r"+3\mathbf V\frac{(\mathbf V\cdot\dot{\mathbf V})^2}{|\mathbf V|^5}"
)


@pytest.mark.parametrize("formula", sampled([FIRST, SECOND], 1))
def test_a_normalized_vector_has_the_derivatives_that_are_printed(formula):
    vector = System(r"\ddot{\mathbf V}=\mathbf A,\ \mathbf V=(x,y,z),\ \mathbf A=(a,b,c)")
    assert vector.identity(formula).verdict.green
    assert vector.identity(formula.replace("|^3}", "|^2}")).verdict == "refuted"
    sign = formula.rindex("-")
    assert vector.identity(f"{formula[:sign]}+{formula[sign + 1 :]}").verdict == "refuted"


@pytest.mark.slow
def test_the_second_derivatives_on_the_surface_of_a_body_are_misprinted():
    r"""With :math:`\ddot{\mathbf r}=-\omega^2\mathbf r` before, the factor is left out behind."""
    surface = System(r"\ddot{\mathbf r}=-\omega^2\mathbf r,\ \mathbf r=(x,y,z)")
    (
        surface.define(r"\mathbf f=\mathbf r"),
        surface.define(r"\mathbf n=\frac{\dot{\mathbf r}}{\omega}"),
    )
    assert surface.identity(r"\dddot{\mathbf r}=-\omega^2\dot{\mathbf r}").verdict == "proved"
    assert surface.identity(
        r"\dot{\mathbf n}=\frac{\ddot{\mathbf r}}{\omega}=-\omega\mathbf r"
    ).verdict.green
    printed = r"\ddot{\mathbf f}=\ddot{\mathbf r}=-\mathbf r"
    assert surface.identity(printed).verdict == "refuted"
    assert surface.identity(printed.replace("-", r"-\omega^2")).verdict == "proved"
    printed = r"\dot{\mathbf n}=-\omega\dot{\mathbf r}"
    assert surface.identity(printed).verdict == "refuted"
    assert surface.identity(printed.replace(r"\dot{\mathbf n}", r"\ddot{\mathbf n}")).verdict.green


def test_the_energy_of_separate_variables_is_conserved():
    law = System(
        r"H=T(p)+V(q),\ \dot q=\frac{\partial H}{\partial p},\ \dot p=-\frac{\partial H}{\partial q}"
    )
    assert law.integral("H").verdict == "proved"
    assert law.integral("T(p)-V(q)").verdict == "refuted"


@pytest.mark.slow
def test_the_potential_of_the_pendulum_is_misprinted():
    """The length of the rod is left out: it is 1 in a picture only."""
    pendulum = System(
        r"\dot\theta=\omega,\ mr^2\dot\omega=-mrg_0\sin\theta,\ L=mr^2\omega,\ v=r\omega,\ h=r-r\cos\theta"
    )
    kinetic = r"\frac{1}{2}mv^2=\frac{1}{2}m(r\omega)^2=\frac{L^2}{2mr^2}"
    assert pendulum.identity(kinetic).verdict.green
    assert pendulum.identity(r"mg_0h=-mg_0(\cos\theta-1)").verdict == "refuted"
    assert pendulum.identity(r"mg_0h=-mg_0r(\cos\theta-1)").verdict == "proved"
    assert pendulum.integral(r"\frac{L^2}{2mr^2}-mg_0r(\cos\theta-1)").verdict.green
    assert pendulum.integral(r"\frac{L^2}{2mr^2}-mg_0(\cos\theta-1)").verdict == "refuted"
