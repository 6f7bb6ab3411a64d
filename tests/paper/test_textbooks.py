"""Systems as textbooks print them: what is proved of them, and what of their mutants is not."""

from dataclasses import dataclass, field

import pytest

from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.claims import FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Scene, Section
from kowalevski_cas.paper.elaborations import Elaborations
from tests.paper.small import decide, derivation
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

POSITION = {r"\mathbf{r}": ("x", "y", "z")}
MOMENTUM = {r"\mathbf{M}": ("M_1", "M_2", "M_3")}


@dataclass
class Book:
    """Equations of motion with definitions; what is true of them; and what is not."""

    motion: str
    variables: str
    constants: str = ""
    given: tuple[str, ...] = ()
    vectors: dict = field(default_factory=dict)
    roots: tuple[str, ...] = ()
    integrals: tuple[str, ...] = ()
    identities: tuple[str, ...] = ()
    no_integrals: tuple[str, ...] = ()
    no_identities: tuple[str, ...] = ()

    def scene(self, section):
        scene = Scene(
            "textbook", vectors=self.vectors, variables=tuple(self.variables.split()),
            constants=tuple(self.constants.split()),
        ).moving(section.display("motion", self.motion))  # fmt: skip
        for number, tex in enumerate(self.given):
            scene = scene.defining(section.display(f"given-{number}", tex))
        for number, tex in enumerate(self.roots):
            scene = scene.adjoining(section.display(f"root-{number}", tex) if "=" in tex else tex)
        return scene

    def verdicts(self):
        """Of the claims that are true, and of those that are false."""
        section = Section("1", "a textbook")
        scene = self.scene(section)
        true = [(FirstIntegral, tex) for tex in self.integrals]
        true += [(Identity, tex) for tex in self.identities]
        false = [(FirstIntegral, tex) for tex in self.no_integrals]
        false += [(Identity, tex) for tex in self.no_identities]
        claims = [
            kind(f"c{number}", scene, "", printed=section.display(f"d{number}", tex)[1])
            for number, (kind, tex) in enumerate(true + false)
        ]
        found = [
            str(o.verdict) + ": " * bool(o.message) + o.message for o in decide(section, *claims)
        ]
        return found[: len(true)], found[len(true) :]


LAX = {
    "motion": r"\dot a=a(b_2-b_1),\quad \dot b_1=2a^2,\quad \dot b_2=-2a^2",
    "variables": "a b_1 b_2",
}

BOOKS = {
    "the oscillator, of the second order": Book(
        r"\ddot x = -\omega^2x", "x", r"\omega",
        integrals=(r"\frac{1}{2}\dot x^2+\frac12\omega^2x^2",),
        identities=(r"\dddot x=-\omega^2\dot x", r"\frac{d}{dt}(x\dot x)=\dot x^2-\omega^2x^2"),
        no_integrals=(r"\dot x^2-\omega^2x^2", "x"), no_identities=(r"\dddot x=\omega^2\dot x",),
    ),
    "the oscillator, with primes": Book(
        "x'=y,\\quad y'=-x", "x y", integrals=("x^2+y^2",), identities=("(x^2)'=2xy",),
        no_integrals=("x^2-y^2",),
    ),
    "the oscillator, as quotients": Book(
        r"\frac{dx}{dt}=y,\quad dy/dt=-x(t)", "x y", integrals=("x^2+y^2",),
        identities=(r"\frac{d}{dt}(x^2)=2xy", "d^2x/dt^2=-x"), no_identities=("dx/dt=-y",),
    ),
    "a double well, with its mass": Book(
        r"m\ddot x=ax-bx^3", "x", "m a b",
        integrals=(r"\frac{m}{2}\dot x^2-\frac{a}{2}x^2+0.25bx^4",),
        no_integrals=(r"\frac{m}{2}\dot x^2-\frac{a}{2}x^2+0.5bx^4",),
    ),
    "a changing momentum": Book(
        r"\frac{d}{dt}(m\dot x)=-kx", "x", "m k", integrals=(r"m\dot x^2+kx^2",),
        no_integrals=(r"\dot x^2+kx^2",),
    ),
    "Hénon and Heiles, by Hamilton": Book(
        r"""\begin{align} \dot x &= \frac{\partial H}{\partial p_x}, & \dot p_x &=
        -\frac{\partial H}{\partial x} \\ \dot y &= \frac{\partial H}{\partial p_y}, & \dot p_y &=
        -\frac{\partial H}{\partial y} \end{align}""",
        "x y p_x p_y",
        given=(r"H(x,y,p_x,p_y)=\frac12(p_x^2+p_y^2)+\frac12(x^2+y^2)+x^2y-\frac13y^3",),
        integrals=("H", "H(x,y,p_x,p_y)"), identities=(r"\ddot x=-x-2xy",),
        no_integrals=("p_x^2+x^2",), no_identities=(r"\ddot y=-y-x^2-y^2",),
    ),
    "Hénon and Heiles, by Newton": Book(
        r"\ddot x=-\frac{\partial U}{\partial x},\quad \ddot y=-\partial U/\partial y", "x y",
        given=(r"U(x,y)=\frac12(x^2+y^2)+x^2y-\frac13y^3",),
        integrals=(r"\frac12(\dot x^2+\dot y^2)+U",), no_integrals=(r"\frac12(\dot x^2+\dot y^2)-U",),
    ),
    "Lagrange's equations": Book(
        r"""\frac{d}{dt}\frac{\partial L}{\partial\dot q_1}-\frac{\partial L}{\partial q_1}=0,\quad
        \frac{d}{dt}\left(\frac{\partial L}{\partial\dot q_2}\right)=\frac{\partial L}{\partial q_2}""",
        "q_1 q_2", "m k",
        given=(r"T=\frac{m}{2}(\dot q_1^2+\dot q_1\dot q_2+\dot q_2^2),\quad V=k(q_1^2+q_2^2)",
               r"L(q_1,q_2,\dot q_1,\dot q_2)=T-V"),
        integrals=("T+V",), identities=(r"m\ddot q_1=\frac{k}{3}(4q_2-8q_1)\cdot 1",),
        no_integrals=("T-V", "L"), no_identities=(r"m\ddot q_1=-2kq_1",),
    ),
    "coupled masses": Book(
        r"m_1\ddot x+\ddot y=-x,\quad \ddot x+m_2\ddot y=-y", "x y", "m_1 m_2",
        integrals=(r"m_1\dot x^2+2\dot x\dot y+m_2\dot y^2+x^2+y^2",),
        no_integrals=(r"m_1\dot x^2+\dot x\dot y+m_2\dot y^2+x^2+y^2",),
    ),
    "Kepler, in a plane": Book(
        r"\ddot x=-\frac{kx}{r^3},\quad \ddot y=-\frac{ky}{r^3}", "x y", "k",
        roots=("r^2=x^2+y^2",),
        integrals=(r"\frac12(\dot x^2+\dot y^2)-\frac kr", r"x\dot y-y\dot x"),
        no_integrals=(r"\frac12(\dot x^2+\dot y^2)+\frac kr",),
    ),
    "Kepler, with vectors": Book(
        r"\ddot{\mathbf r}=-\frac{k\mathbf r}{|\mathbf r|^3}", "x y z", "k", vectors=POSITION,
        roots=(r"\sqrt{x^2+y^2+z^2}",),
        integrals=(
            r"\frac12\dot{\mathbf r}^2-\frac{k}{|\mathbf r|}", r"\mathbf r\times\dot{\mathbf r}",
        ),
        no_integrals=(r"\frac12\dot{\mathbf r}^2-\frac{k}{|\mathbf r|^2}", r"\dot{\mathbf r}"),
    ),
    "the top of Euler, by a gradient": Book(
        r"\dot{\mathbf M}=\mathbf M\times\frac{\partial H}{\partial\mathbf M}", "M_1 M_2 M_3",
        "a_1 a_2 a_3", vectors=MOMENTUM, given=(r"H=\frac12\sum_{i=1}^3 a_iM_i^2",),
        integrals=("H", r"\mathbf M^2", r"|\mathbf M|^2", r"\langle\mathbf M,\mathbf M\rangle"),
        identities=(r"\dot M_1=(a_3-a_2)M_2M_3",),
        no_integrals=(r"\sum_{i=1}^2 M_i^2",), no_identities=(r"\dot M_1=(a_2-a_3)M_2M_3",),
    ),
    "a Poisson bracket": Book(
        r"\dot q=\{q,H\},\quad \dot p=\{p,H\}", "q p", given=(r"H=\frac12p^2+q^4", r"\{q,p\}=1"),
        integrals=("H",), identities=(r"\dot p=-4q^3",), no_identities=(r"\dot p=4q^3",),
    ),
    "an open chain, by its Lax pair": Book(
        **LAX,
        given=(
            r"L=\begin{pmatrix} b_1 & a \\ a & b_2 \end{pmatrix}",
            r"M=\begin{bmatrix} 0 & a \\ -a & 0 \end{bmatrix}",
        ),
        integrals=(r"\operatorname{tr}L^2", r"\det L", r"\begin{vmatrix} b_1 & a \\ a & b_2 \end{vmatrix}"),
        identities=(r"\dot L=[M,L]", r"\frac{dL}{dt}=ML-LM", r"L^2-L\operatorname{tr}L+\det L=0"),
        no_identities=(r"\dot L=[L,M]", r"L^2=L\operatorname{tr}L"),
    ),
    "a pendulum": Book(
        r"\ddot\theta=-\frac g\ell\sin\theta", r"\theta", r"g \ell",
        integrals=(r"\frac12\dot\theta^2-\frac{g}{\ell}\cos\theta",),
        identities=(
            r"\frac{d}{dt}\cos\theta=-\dot\theta\sin\theta", r"\cos 2\theta=1-2\sin^2\theta",
            r"\sin 3\theta=3\sin\theta-4\sin^3\theta", r"\tan\theta\cos\theta=\sin\theta",
        ),
        no_integrals=(r"\frac12\dot\theta^2+\frac g\ell\cos\theta", r"\sin\theta"),
        no_identities=(r"\cos 2\theta=1+2\sin^2\theta", r"\sin(-\theta)=\sin\theta"),
    ),
    "a pendulum, by Hamilton": Book(
        r"\dot\theta=\frac{\partial H}{\partial p},\quad\dot p=-\frac{\partial H}{\partial\theta}",
        r"\theta p", "g", given=(r"H(\theta,p)=\frac12p^2-g\cos\theta",), integrals=("H",),
        identities=(r"\dot p=-g\sin\theta", r"\dot\theta=p"), no_identities=(r"\dot p=g\sin\theta",),
    ),
    "a pendulum, by brackets": Book(
        r"\dot\theta=\{\theta,H\},\quad\dot p=\{p,H\}", r"\theta p",
        given=(r"H=\frac12p^2-\cos\theta", r"\{\theta,p\}=1"), integrals=("H",),
        identities=(r"\{p,\cos\theta\}=\sin\theta",), no_identities=(r"\{p,\cos\theta\}=-\sin\theta",),
    ),
    "a spherical pendulum": Book(
        r"""\frac{d}{dt}\frac{\partial L}{\partial\dot\theta}=\frac{\partial L}{\partial\theta},\quad
        \frac{d}{dt}\frac{\partial L}{\partial\dot\phi}=\frac{\partial L}{\partial\phi}""",
        r"\theta \phi", "g",
        given=(r"L=\frac12(\dot\theta^2+\sin^2\theta\,\dot\phi^2)-g\cos\theta",),
        integrals=(
            r"\frac12(\dot\theta^2+\sin^2\theta\,\dot\phi^2)+g\cos\theta", r"\dot\phi\sin^2\theta",
        ),
        no_integrals=(r"\dot\phi\sin\theta", r"\dot\phi"),
    ),
    "a double pendulum": Book(
        r"""\frac{d}{dt}\frac{\partial L}{\partial\dot\theta_1}=\frac{\partial L}{\partial\theta_1},\quad
        \frac{d}{dt}\frac{\partial L}{\partial\dot\theta_2}=\frac{\partial L}{\partial\theta_2}""",
        r"\theta_1 \theta_2", "g",
        given=(
            r"T=\dot\theta_1^2+\frac12\dot\theta_2^2+\dot\theta_1\dot\theta_2\cos(\theta_1-\theta_2)",
            r"V=-2g\cos\theta_1-g\cos\theta_2", "L=T-V",
        ),
        integrals=("T+V",), no_integrals=("T-V",),
    ),
    "Toda's chain of three": Book(
        r"""\begin{aligned} \dot q_1 &= p_1, & \dot p_1 &= e^{q_3-q_1}-e^{q_1-q_2}, \\
        \dot q_2 &= p_2, & \dot p_2 &= e^{q_1-q_2}-e^{q_2-q_3}, \\
        \dot q_3 &= p_3, & \dot p_3 &= e^{q_2-q_3}-e^{q_3-q_1} \end{aligned}""",
        "q_1 q_2 q_3 p_1 p_2 p_3",
        integrals=(
            r"\frac12\sum_{i=1}^3p_i^2+e^{q_1-q_2}+e^{q_2-q_3}+e^{q_3-q_1}", "p_1+p_2+p_3",
            "p_1p_2p_3-p_1e^{q_2-q_3}-p_2e^{q_3-q_1}-p_3e^{q_1-q_2}",
        ),
        identities=(r"\frac{d}{dt}e^{q_1-q_2}=(p_1-p_2)e^{q_1-q_2}",),
        no_integrals=("p_1p_2p_3-p_1e^{q_2-q_3}-p_2e^{q_3-q_1}+p_3e^{q_1-q_2}", "p_1-p_2"),
    ),
    "a hyperbolic force": Book(
        r"\dot x=p,\quad\dot p=-\sinh x", "x p", integrals=(r"\frac12p^2+\cosh x",),
        identities=(r"\cosh^2x-\sinh^2x=1",), no_integrals=(r"\frac12p^2-\cosh x",),
    ),
    "two branches": Book(
        r"\dot x=y,\quad \dot y=x", "x y", integrals=("(x\\pm y)(x\\mp y)",),
        identities=(r"\frac{d}{dt}(x\pm y)=\pm(x\pm y)",), no_identities=(r"\dot x\pm\dot y=x",),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", sampled(BOOKS, 3))
def test_what_a_textbook_says_is_proved_and_what_it_does_not_say_is_refuted(name):
    true, false = BOOKS[name].verdicts()
    assert {*true} <= {"proved", "conditional"}
    assert {*false} <= {"refuted"}


@pytest.mark.parametrize("name", BOOKS)
def test_the_field_is_what_the_printed_equations_say(name):
    section = Section("1", "a textbook")
    book = BOOKS[name]
    scene = book.scene(section)
    on = Elaborations(derivation(section).texts(None, scene))(scene)
    for place in scene.field:
        left, right = on.texts.sides(place)
        assert all(
            entry.is_zero for entry in on.finder.differences([(on.plain(left), on.plain(right))])
        )


def test_velocities_are_variables():
    section = Section("1", "a textbook")
    scene = Scene(variables=("x_1",)).moving(section.display("motion", r"\dddot x_1=-\dot x_1"))
    on = Elaborations(derivation(section).texts(None, scene))(scene)
    assert on.variables == ("x_1", r"\dot{x}_1", r"\ddot{x}_1")
    assert to_latex(on.formula(r"\ddot x_1+\dddot x_1")) == r"\ddot{x}_1 + \dot{\ddot{x}}_1"


@pytest.mark.parametrize(
    ("motion", "message"),
    [
        (r"\dot x^2=y,\quad \dot y=x", "are not linear in the highest derivatives"),
        (r"\dot x+\dot y=x,\quad 2\dot x+2\dot y=y", "do not determine the rates of x, y"),
        (r"\dot x+\dot y=x", "1 equations of motion for the 2 rates of x, y"),
        (r"\dot x=y,\quad \dot y=x,\quad \dot x=2y", "x moves by two equations"),
        (r"\dot x=y,\quad y'=x", "dots and primes in the same equations"),
        (r"x'''''=y,\quad y'=x", "x is derived 5 times"),
        (r"\dot x=\sum_{i=1}^n y,\quad \dot y=x", "print both limits as numbers"),
    ],
)
def test_what_is_no_field_is_an_error_that_says_so(motion, message):
    section = Section("1", "a textbook")
    scene = Scene(variables=("x", "y"), constants=("n",)).moving(section.display("m", motion))
    [outcome] = decide(
        section, FirstIntegral("c", scene, "", printed=section.display("d", "x^2")[1])
    )
    assert str(outcome.verdict) == "error"
    assert message in outcome.message


@pytest.mark.parametrize(
    ("sum_", "value"),
    [
        (r"\sum_{i=1}^3\sum_{i=1}^2 i", 9),
        (r"\sum_{i=1}^3\sum_{i=1}^i i", 10),
        (r"\sum_{i=1}^3 i\cdot\sum_{i=2}^3 i", 30),
        (r"\sum_{i=1}^3\sum_{k=i}^3 i", 10),
        (r"\sum_{i=2}^3(x_i-x_{i-1})", "x_3-x_1"),
    ],
)
def test_the_index_of_a_sum_is_the_one_of_the_innermost(sum_, value):
    assert str(_of_sums(f"{sum_}={value}").verdict) == "proved"


@pytest.mark.parametrize("index", ["2i-1", "i+1i", "ii-1", "2i", "3i0", "12i"])
def test_an_index_that_may_be_a_product_is_not_computed(index):
    outcome = _of_sums(rf"\sum_{{i=1}}^2x_{{{index}}}=x_1+x_3")
    assert "write the terms out" in outcome.message


def test_two_indices_of_one_sign_each_are_no_product():
    assert str(_of_sums(r"\sum_{i=0}^1x_{1i}=x_{10}+x_{11}").verdict) == "proved"
    assert "write the terms out" in _of_sums(r"\sum_{i=10}^{10}x_{1i}=x_1").message


def _of_sums(equation):
    section = Section("1", "a textbook")
    names = ("x_1", "x_2", "x_3", "x_{20}", "x_{21}", "x_{22}", "x_{10}", "x_{11}")
    scene = Scene(variables=names)
    [outcome] = decide(section, Identity("c", scene, "", printed=section.display("d", equation)[1]))
    return outcome


@pytest.mark.parametrize(
    ("motion", "integral", "mass"),
    [
        (r"m\dot x=0,\quad \dot y=1", "x", "m"),
        (r"m\ddot x=0", r"\dot x", "m"),
        (r"y\dot x=0,\quad \dot y=0", "x", "y"),
        (r"m\dot x=0,\quad \dot y=0", "y", "m"),
        (r"m\ddot x+\ddot y=0,\quad \ddot x+m\ddot y=0", r"\dot x", "m^2 - 1"),
    ],
)
def test_a_mass_that_may_vanish_is_a_condition_also_where_nothing_acts(motion, integral, mass):
    section = Section("1", "a textbook")
    names = ("x", "y") if "y" in motion else ("x",)
    scene = Scene(variables=names, constants=("m",)).moving(section.display("m", motion))
    claim = FirstIntegral("c", scene, "", printed=section.display("d", integral)[1])
    [outcome] = decide(section, claim)
    assert str(outcome.verdict) == "conditional"
    assert [to_latex(one.expression) for one in outcome.conditions] == [mass]
