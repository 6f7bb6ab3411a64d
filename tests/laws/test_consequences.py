"""What follows from laws, energies and words: true, and with one number changed."""

from random import Random

import pytest
from sympy import Rational, diff, expand, integrate, latex, symbols

from tests.reading.test_reading import verdicts

x = symbols("x")


def _force(chosen: Random):
    return sum(chosen.choice([-3, -2, -1, 1, 2, 3]) * x**k for k in (1, 2, 3))


def by_the_energy(chosen: Random) -> tuple[str, str, str]:
    """A velocity by the energy, with its coefficient."""
    force = _force(chosen)
    potential = latex(integrate(-force, x))
    text = (
        rf"A point moves by \[\ddot x={latex(force)}.\] The energy is"
        rf" $h=\frac12\dot x^2+({potential})$. Then $\dot x^2=%s h-2({potential})$."
    )
    return text, "2", latex(2 + chosen.choice([-1, Rational(1, 2), 1, 2]))


def of_separation(chosen: Random) -> tuple[str, str, str]:
    """Two equations with one new constant, in a sentence or in two."""
    a, b = chosen.sample([1, 2, 3, 5], 2)
    joined = chosen.choice([", ", " and ", ". Similarly, "])
    text = (
        rf"Two oscillators move by \[\ddot x=-{a}x,\quad\ddot y=-{b}y.\] The energy is"
        rf" $h=\frac12(\dot x^2+\dot y^2+{a}x^2+{b}y^2)$. We have"
        rf" $\dot x^2=\alpha-{a}x^2${joined}$\dot y^2=2h%s\alpha-{b}y^2$."
    )
    return text, "-", chosen.choice(["+", "-2", "-3"])


def near_a_place(chosen: Random) -> tuple[str, str, str]:
    """A linear equation near a point of rest that is not the origin."""
    place = chosen.choice([1, 2, 3])
    force = expand((x - place) * (_force(chosen) + 100))
    slope = diff(force, x).subs(x, place)
    text = (
        rf"A point moves by \[\ddot x={latex(force)}.\] Near $x={place}$ we have"
        rf" $\ddot x=(%s)(x-{place})$."
    )
    return text, latex(slope), latex(slope + chosen.choice([-1, 1, 2]))


def on_a_circle(chosen: Random) -> tuple[str, str, str]:
    """The acceleration of an angle that gives two variables."""
    a = chosen.choice([1, 2, 3])
    pull, by_angle = chosen.choice([(r"\gamma_1", r"\cos\theta"), (r"\gamma_2", r"\sin\theta")])
    text = (
        rf"Consider \[\dot\gamma_1=-{a}r\gamma_2,\quad\dot\gamma_2={a}r\gamma_1,\quad"
        rf"\dot r=k{pull}.\] We put $\gamma_1=\cos\theta$, $\gamma_2=\sin\theta$."
        rf" Then $\ddot\theta=%sk{by_angle}$."
    )
    return text, str(a), str(a + chosen.choice([1, 2]))


def by_a_constant(chosen: Random) -> tuple[str, str, str]:
    """A velocity by a constant of integration, or a letter that words give to the energy."""
    force = _force(chosen)
    potential = latex(integrate(-force, x))
    named = chosen.choice(["Denote the value of $E$ by $h$.", "Let $h$ be the value of $E$.", ""])
    energy = rf"The energy is \[E=\frac12\dot x^2+({potential}).\] {named} Then"
    words = energy if named else "Multiplying by the velocity and integrating we find"
    end = "" if named else chosen.choice(["", ", where $h$ is a constant of integration"])
    text = (
        rf"A point moves by \[\ddot x={latex(force)}.\] {words}"
        rf" \[\dot x^2=2h-%s({potential})\]{end}."
    )
    return text, "2", latex(2 + chosen.choice([-1, Rational(1, 2), 1, 2]))


def by_a_quadrature(chosen: Random) -> tuple[str, str, str]:
    """A quadrature by the time, with a factor before it or behind."""
    force = _force(chosen)
    square = rf"2h-2({latex(integrate(-force, x))})"
    factor = chosen.choice([1, 2, 3])
    integral = rf"\int\frac{{%s\,dx}}{{\sqrt{{{square}}}}}"
    form = chosen.choice([rf"{factor}t={integral}", rf"{integral}={factor}(t-t_0)"])
    form = rf"t-t_0=\frac1{factor}{integral}" if form.startswith(f"{factor}t") else form
    text = (
        rf"A point moves by \[\ddot x={latex(force)}.\] Integrating, \[\dot x^2={square}.\]"
        rf" Hence \[{form}.\]"
    )
    return text, str(factor), str(factor + chosen.choice([1, 2]))


def of_roots(chosen: Random) -> tuple[str, str, str]:
    """A root of a quadratic equation, which may be a double one, with a letter in it."""
    a, shift = chosen.choice([1, 2, 3]), chosen.choice([0, 0, 1, 4])
    words = chosen.choice(["It has the roots", "whence", "Solving it we find"])
    start = ", " if words == "whence" else ". "
    text = (
        rf"The points of rest of $\ddot x={a}x^2-2bx+c$ satisfy ${a}x^2-2bx+c=0${start}{words}"
        rf" \[x_{{1,2}}=\frac{{b\pm\sqrt{{b^2-%s c}}}}{{{a}}}.\]"
    )
    if not shift:
        return text, str(a), str(a + chosen.choice([1, 2]))
    double = rf"For $u$ we have \[{a}(u-k)^2=0.\] It has the double root \[u_0=%sk.\] Here $\ddot y=-ky$."
    return double, "", str(1 + shift)


def on_a_circular_orbit(chosen: Random) -> tuple[str, str, str]:
    """The velocity on a circular orbit of a force that is a power of the distance."""
    n = chosen.choice([-1, 1, 2, 3, 4])
    force = rf"-\frac{{\mu}}{{r^{n}}}" if n > 0 else r"-\mu r"
    words = chosen.choice(["On a circular orbit", "For circular orbits we have"])
    below = rf"r^{n + 1}" if n > 0 else "1"
    text = (
        rf"A particle moves by \[\ddot r-r\dot\varphi^2={force},\qquad"
        rf" r\ddot\varphi+2\dot r\dot\varphi=0.\] {words} $\dot\varphi^2=%s\frac{{\mu}}{{{below}}}$."
    )
    return text, "", chosen.choice(["2", "3", "-"])


def of_an_amplitude(chosen: Random) -> tuple[str, str, str]:
    """The phase of a complex variable, by real letters."""
    a, n = chosen.choice([1, 2, 3]), chosen.choice([1, 2])
    modulus, power = ("|z|^2", r"r^2") if n == 1 else ("|z|^4", r"r^4")
    text = (
        rf"The amplitude obeys \[\dot z=i\omega z+{a}i{modulus}z.\] Put $z=re^{{i\varphi}}$."
        rf" Then \[\dot r=0,\qquad\dot\varphi=\omega+%s{power}.\]"
    )
    return text, str(a), str(a + chosen.choice([-4, 1, 2]))


def in_new_coordinates(chosen: Random) -> tuple[str, str, str]:
    """A Hamiltonian in scaled coordinates, or in polar ones, with the momenta of these."""
    a, k = chosen.choice([2, 3]), chosen.choice([1, 2, 3])
    hamiltonian = rf"Let $H=\frac12(p_x^2+p_y^2)+\frac{k}2(x^2+y^2)$."
    if chosen.random() < 0.5:
        text = (
            rf"{hamiltonian} Put $x={a}u$, $y=2v$. Then \[H=\frac12\left(\frac{{p_u^2}}{{%s}}"
            rf"+\frac{{p_v^2}}4\right)+\frac{k}2({a * a}u^2+4v^2).\]"
        )
        return text, str(a * a), str(a * a + chosen.choice([-a, 1]))
    text = (
        rf"{hamiltonian} In polar coordinates, $x=r\cos\varphi$, $y=r\sin\varphi$, it is"
        rf" \[H=\frac12\left(p_r^2+\frac{{p_\varphi^2}}{{r^%s}}\right)+\frac{k}2r^2.\]"
    )
    return text, "2", chosen.choice(["1", "3", "4"])


def of_named_roots(chosen: Random) -> tuple[str, str, str]:
    """A relation of Vieta for the roots of a cubic in the velocity, which may coincide."""
    a, b = chosen.choice([1, 2, 3]), chosen.choice([1, 2, 5])
    named = chosen.choice(
        [r"Let $u_1,u_2,u_3$ be the roots of", r"Denote by $u_1$, $u_2$, $u_3$ the zeros of"]
    )
    said, value = chosen.choice(
        [("u_1+u_2+u_3", rf"\frac p{{{2 * a}}}"), ("u_1u_2u_3", rf"\frac h{{{a}}}"),
         ("u_1u_2+u_2u_3+u_3u_1", rf"\left(-\frac{{{b}q}}{{{a}}}\right)")]
    )  # fmt: skip
    text = (
        rf"A point moves by \[\ddot u=-{3 * a}u^2+pu+{b}q.\] The energy gives"
        rf" \[\dot u^2=-{2 * a}u^3+pu^2+{2 * b}qu+2h.\] {named} the polynomial on the right."
        rf" Then \[{said}=%s{value}.\]"
    )
    return text, "", chosen.choice(["2", "3", "-"])


def of_moving_roots(chosen: Random) -> tuple[str, str, str]:
    """A product, or a sum, of roots of an equation of which the coefficients move."""
    a, b = chosen.sample([2, 3, 5], 2)
    said = chosen.choice([rf"u+v=%s\frac{{{b}x}}{{{a}}}", rf"uv=%s\frac y{{{a}}}"])
    text = (
        r"Consider \[\dot x=y,\qquad\dot y=-x.\] Let $u$ and $v$ be the roots of the equation"
        rf" \[{a}z^2-{b}xz+y=0.\] Then ${said}$."
    )
    return text, "", chosen.choice(["2", "3", "-"])


def of_an_effective_potential(chosen: Random) -> tuple[str, str, str]:
    """The radial equation, with the momentum constant in the potential that is derived."""
    force, n = chosen.choice([("-V'(r)", "V(r)"), ("-kr", r"\frac k2r^2")]), chosen.choice([1, 2])
    constant = chosen.choice([r"$\ell=r^2\dot\varphi=\mathrm{const}$", r"$\ell=r^2\dot\varphi$"])
    conserved = "" if "const" in constant else " is conserved"
    text = (
        rf"A point moves by \[\ddot r-r\dot\varphi^2={force[0]},\qquad r\ddot\varphi"
        rf"+2\dot r\dot\varphi=0.\] The momentum {constant}{conserved}. With the potential"
        rf" \[U(r)={force[1]}+%s\frac{{{n}\ell^2}}{{{2 * n}r^2}}\] we have \[\ddot r=-\frac{{dU}}{{dr}}.\]"
    )
    return text, "", chosen.choice(["2", "3", "-"])


def by_the_angle(chosen: Random) -> tuple[str, str, str]:
    """A quadrature by an angle, or the equation of an orbit, with primes by it."""
    text = (
        r"The orbit obeys \[\ddot r-r\dot\varphi^2=-\frac k{r^2},\qquad r^2\dot\varphi=\ell.\]"
        r" The energy is $h=\frac12\dot r^2+\frac{\ell^2}{2r^2}-\frac kr$. "
    )
    if chosen.random() < 0.5:
        root = r"\sqrt{2h+\frac{2k}r-\frac{\ell^2}{r^2}}"
        integral = rf"\int\frac{{%s\ell\,dr}}{{r^2{root}}}"
        return rf"{text}Hence \[\varphi-\varphi_0={integral}.\]", "", chosen.choice(["2", "3"])
    prime = chosen.choice(["a prime denotes $d/d\\varphi$", "$u'=du/d\\varphi$"])
    orbit = rf"With $u=1/r$, where {prime}, we have \[u''+u=%s\frac k{{\ell^2}}.\]"
    return text + orbit, "", chosen.choice(["2", "3", "-"])


def with_a_changing_frequency(chosen: Random) -> tuple[str, str, str]:
    """The rate of an energy, and an invariant, where the frequency is any function of the time."""
    a = chosen.choice([1, 2, 3])
    law = rf"Consider \[\ddot q+{a}\omega^2(t)q=0"
    if chosen.random() < 0.5:
        energy = rf"{law}.\] With $H=\frac12(\dot q^2+{a}\omega^2q^2)$ we have"
        return rf"{energy} $\dot H=%s\omega\dot\omega q^2$.", str(a), str(a + chosen.choice([1, 2]))
    text = (
        rf"{law},\qquad\ddot\rho+{a}\omega^2(t)\rho=\rho^{{-3}}.\] Then"
        r" \[I=\frac12\left[%s\frac{q^2}{\rho^2}+(\rho\dot q-\dot\rho q)^2\right]\] is an integral."
    )
    return text, "", chosen.choice(["2", "3", "-"])


def beside_what_cannot_be_read(chosen: Random) -> tuple[str, str, str]:
    """A rate that stands in a display with something else."""
    a = chosen.choice([2, 3, 5])
    both = [r"\oint y\,dx=J", r"\frac{d}{dt}(%sx^2+y^2)=0"]
    chosen.shuffle(both)
    text = rf"Consider \[\dot x=y,\qquad\dot y=-{a}x.\] Then \[{both[0]},\qquad {both[1]}.\]"
    return text, str(a), str(a + chosen.choice([-1, 1, 2]))


def on_a_wire(chosen: Random) -> tuple[str, str, str]:
    """The energy of a bead on a parabola, in a text that has another system before it."""
    before = (
        r"\section{Pendulum} Consider \[m\ddot x=-\lambda x,\quad m\ddot y=-mg-\lambda y,\quad"
        r" x^2+y^2=l^2.\] "
    )
    text = (
        rf"{chosen.choice(['', before])}\section{{Bead}} A bead slides on a parabola by"
        r" \[m\ddot x=-\frac{\lambda x}p,\quad m\ddot z=\lambda-mg,\quad z=\frac{x^2}{2p}.\]"
        r" Then \[\frac m2(\dot x^2+\dot z^2)+%smgz=\mathrm{const}.\]"
    )
    return text, "", chosen.choice(["2", "3", "-"])


def of_a_constant_of_an_integral(chosen: Random) -> tuple[str, str, str]:
    """What follows from an integral that words cite, for the letter of its constant."""
    a = chosen.choice([1, 2, 3])
    text = (
        rf"Consider \[\dot x=y,\qquad\dot y=-{a}x.\] The function"
        rf" \begin{{equation}}\label{{F}}F={a}x^2+y^2\end{{equation}} is an integral."
        r" Let $f$ be the constant of the integral \eqref{F}. Then \[y^2=f-%sx^2.\]"
    )
    return text, str(a), str(a + chosen.choice([-1, 1, 2]) or 7)


def of_another_value(chosen: Random) -> tuple[str, str, str]:
    """A value of a name of constants in another section, and what it makes of an integral."""
    a = chosen.choice([1, 2, 3])
    text = (
        r"Consider \[\dot x=y,\qquad\dot y=-cx.\] \section{A} Here $D=1-c$. \section{B}"
        rf" Let $c={a}$. Then $D=%s$, and \[{a}x^2+y^2=\mathrm{{const}}.\]"
    )
    return text, str(1 - a), str(1 - a + chosen.choice([-1, 1, 2]))


KINDS = [
    by_the_energy, of_separation, near_a_place, on_a_circle, by_a_constant, by_a_quadrature,
    of_roots, on_a_circular_orbit, of_an_amplitude, in_new_coordinates, of_named_roots,
    of_moving_roots, of_an_effective_potential, by_the_angle, with_a_changing_frequency,
    beside_what_cannot_be_read, on_a_wire, of_a_constant_of_an_integral, of_another_value,
]  # fmt: skip


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("kind", KINDS)
def test_a_consequence_is_green_as_it_is_and_not_with_another_number(kind, seed):
    text, right, wrong = kind(Random(seed))
    assert all(one.green for one in verdicts(text % right).values()), text % right
    assert not all(one.green for one in verdicts(text % wrong).values()), text % wrong
