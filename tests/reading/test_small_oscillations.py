"""Characteristic equations and frequencies of small oscillations, at points that are said."""

from itertools import product

import pytest

from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

SWING = (
    r"The equation of motion is \begin{equation}\label{s} \ddot u=-n\sin u-c\dot u .\end{equation} "
)
FREE = r"The equation of motion is \begin{equation}\label{s} \ddot u=-n\sin u .\end{equation} "
WELL = r"The equations of motion are \begin{equation}\label{w} \dot q=p,\quad \dot p=aq-bq^3-cp .\end{equation} "
TWO = r"""The equations of motion are \[ 3\ddot u+\ddot v\cos(u-v)-\dot v^2\sin(u-v)+2u-v=0,\quad
\ddot v+\ddot u\cos(u-v)+\dot u^2\sin(u-v)+v-u=0 .\] """
PREY = r"""The equations are \[ \dot x=x(a-by-ex),\quad \dot y=y(dx-c),\quad a,b,c,d,e>0 .\]
The point of coexistence is \[ x^*=\frac cd,\qquad y^*=\frac{ad-ec}{bd} .\] """
CONVECTION = r"""The equations are \[ \dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-bz \] with positive
parameters. The points of rest are the origin and, for $r>1$, the two points
\[ C_\pm=(\pm\sqrt{b(r-1)},\pm\sqrt{b(r-1)},r-1) .\] """
DAMPED = r"""We study \[ \ddot x-g\dot y=ax,\quad \ddot y+g\dot x=by .\]
The energy \[ E=\frac12(\dot x^2+\dot y^2)-\frac12(ax^2+by^2) \] is an integral.
\section{Friction} With friction the equations are
\[ \ddot x+k\dot x-g\dot y=ax,\quad \ddot y+k\dot y+g\dot x=by .\] Now \[ \dot E=-k(\dot x^2+\dot y^2) \] and """
COUPLED = r"The equations of motion are \[ \ddot u=-nu+n(v-u),\quad \ddot v=-nv+n(u-v) .\] "
TILTED = r"""The equation is \[ \ddot u=m^2\sin u\cos u-k\sin u .\] It rests at the angle $\alpha$ with
\[ \cos\alpha=\frac k{m^2} .\] Put $u=\alpha+\xi$ and neglect the squares of $\xi$,
\[ \ddot\xi=-m^2\sin^2\alpha\,\xi .\] """
KINDS = ("characteristic", "frequency")


def last(text):
    """The verdict on the formula that is printed last before a place; it may be not judged."""
    found = verdicts(text)
    said = [f for f in reading(text).formulas if f.role.kind in KINDS]
    return found.get(said[-1].item.printed.tex.strip(" .,")) if said else None


def is_green(text):
    found = last(text)
    return found is not None and found.green


TRUE = [
    r"The equation of motion is \[ \ddot u=0 .\] The characteristic equation is \[ \mu^2=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ \mu^2+c\mu+n=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ 2n+2\mu^2=-2c\mu .\]",
    SWING + r"In the neighbourhood of $u=0$ we get the characteristic polynomial \[ -n-c\mu-\mu^2 .\]",
    SWING + r"При $u$ вблизи $u=0$ характеристическое уравнение имеет вид \[ \mu^2+c\mu+n=0 .\]",
    WELL + r"The characteristic equation at the origin is \[ s(s+c)=a .\]",
    WELL + r"Let $a=b$. The characteristic equation at the point $q=1$, $p=0$ is \[ s^2+cs+2a=0 .\]",
    WELL + r"At the origin the characteristic polynomial is \[ s^2+cs-a ,\] and at $(\sqrt{a/b},0)$ the"
    r" characteristic equation is \[ s^2+cs+2a=0 .\]",
    WELL + r"The characteristic equation is $s^2+cs-a=0$ at the origin, and $s^2+cs+2a=0$ at $(\sqrt{a/b},0)$.",
    PREY + r"The characteristic equation at this point is \[ s^2+\frac{ec}ds+\frac{c(ad-ec)}d=0 .\]",
    DAMPED + r"the characteristic equation becomes \[ s^4+2ks^3+(g^2+k^2-a-b)s^2-k(a+b)s+ab=0 .\]",
    TWO + r"For small angles, inserting $u,v\sim e^{\mu t}$ we find \[ 2\mu^4+7\mu^2+1=0 .\]",
    FREE + r"The frequency of the small oscillations near $u=0$ is \[ \nu^2=n .\]",
    FREE + r"The frequency of small oscillations is \[ \nu_0=\sqrt n \] near $u=0$.",
    FREE + r"The frequency of small oscillations about $u=0$ is $\sqrt n$.",
    FREE + r"Квадрат частоты малых колебаний около $u=0$ равен \[ \nu^2=n .\]",
    r"The equation of motion is \[ \ddot u=-nu .\] The frequency of the small oscillations is \[ \nu^2=n .\]",
    COUPLED + r"The normal modes have the frequencies \[ \nu_1=\sqrt n,\qquad \nu_2=\sqrt{3n} .\]",
    COUPLED + r"The normal frequencies are \[ \nu_1=\sqrt n,\qquad \nu_2=\sqrt{3n} .\]",
    TILTED + r"The frequency of small oscillations is therefore $\nu$, where \[ \nu^2=m^2-\frac{k^2}{m^2} .\]",
    TILTED + r"Hence the frequency is \[ \nu=\sqrt{m^2-\frac{k^2}{m^2}} .\]",
    TILTED + r"The characteristic equation is \[ \mu^2=\frac{k^2}{m^2}-m^2 .\]",
]  # fmt: skip
FALSE = [
    r"Let \[ \dot x=y,\quad \dot y=(x-1)(x+1)(x+3) .\] At $(\pm1,0)$ the characteristic equation is $\mu^2=8$.",
    WELL + r"At the origin the characteristic polynomial is \[ s^2+cs-a ,\] and at $(\sqrt{a/b},0)$ the"
    r" characteristic equation is \[ s^2+cs-a=0 .\]",
    WELL + r"The characteristic equation is $s^2+cs+2a=0$ at the origin, and $s^2+cs-a=0$ at $(\sqrt{a/b},0)$.",
    WELL + r"At the origin and at $(\sqrt{a/b},0)$ the characteristic equation is \[ s^2+cs+2a=0 .\]",
    WELL.replace("-bq^3", "-bq^3+kq^2") + r"At $(\pm1,0)$ the characteristic equation is \[ s^2+cs-a+3b-2k=0 .\]",
    PREY + r"The characteristic equation at this point is \[ s^2+\frac{ed}cs+\frac{c(ad-ec)}d=0 .\]",
    CONVECTION + r"At $C_\pm$ the characteristic equation is \[ m^3+(s+b+1)m^2+b(r-s)m+2sb(r-1)=0 .\]",
    DAMPED + r"the characteristic equation becomes \[ s^4+ks^3+(g^2+k^2-a-b)s^2-k(a+b)s+ab=0 .\]",
    DAMPED + r"without it the characteristic equation is \[ s^4+2ks^3+(g^2+k^2-a-b)s^2-k(a+b)s+ab=0 .\]",
    TILTED + r"The frequency of small oscillations is therefore $\nu$, where \[ \nu^2=m^2+\frac{k^2}{m^2} .\]",
    TILTED + r"Hence the frequency is \[ \nu=\sqrt{m^2-k^2} .\]",
    TILTED + r"The frequency of the driving force is \[ \nu=\sqrt{m^2-k^2} .\]",
    TILTED.replace(r"=-m^2", "=-2m^2") + r"Hence the frequency is \[ \nu=\sqrt{2m^2-2\frac{k^2}{m^2}} .\]",
    COUPLED + r"The normal modes have the frequencies \[ \nu_1=\sqrt n,\qquad \nu_2=\sqrt{2n} .\]",
    COUPLED + r"The normal modes have the frequencies \[ \nu=3n .\]",
    COUPLED + r"The normal frequencies are \[ \nu_1=\sqrt n,\qquad \nu_2=3\sqrt n .\]",
    r"The equation of motion is \[ \ddot u=0 .\] The frequency of the small oscillations is \[ \nu^2=0 .\]",
    r"The equation of motion is \[ \ddot u=u .\] The frequency of the small oscillations is \[ \nu^2=-1 .\]",
    r"The equation of motion is \[ \ddot u=0 .\] The characteristic equation is \[ \frac1\mu=0 .\]",
    r"The equation of motion is \[ \ddot u=0 .\] The characteristic equation is \[ \mu^2+\frac1\mu=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ \mu^2-c\mu+n=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ \mu^2+c\mu-n=0 .\]",
    SWING + r"Near $u=\pi$ the characteristic equation is \[ \mu^2+c\mu+n=0 .\]",
    SWING + r"Near $u=1$ the characteristic equation is \[ \mu^2+c\mu+n=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ 0\mu=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ \mu(\mu^2+c\mu+n)=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ \mu+c=0 .\]",
    SWING + r"Near $u=0$ the characteristic equation is \[ (n-n)(\mu^2+\mu)=0 .\]",
    WELL + r"The characteristic equation at the point $q=1$, $p=0$ is \[ s^2+cs+2a=0 .\]",
    WELL + r"The characteristic equation at the origin is \[ s^2+cs+2a=0 .\]",
    TWO + r"For small angles, inserting $u,v\sim e^{\mu t}$ we find \[ 2\mu^4+7\mu^2-1=0 .\]",
    FREE + r"The frequency of small oscillations near $u=0$ is \[ \nu^2=-n .\]",
    FREE + r"The frequency of small oscillations near $u=0$ is \[ \nu=n .\]",
    SWING + r"The frequency of small oscillations near $u=0$ is \[ \nu^2=n .\]",
]  # fmt: skip


@pytest.mark.parametrize("text", TRUE)
def test_true(text):
    assert is_green(text)


@pytest.mark.parametrize("text", FALSE)
def test_false(text):
    assert not is_green(text)


OTHERS = (
    "With stronger friction $\\ddot u=-n\\sin u-2c\\dot u$. ",
    "For the deviation $\\xi$ one has \\[ \\ddot\\xi=-n\\xi-2c\\dot\\xi .\\] ",
    "The linear equation is \\[ \\ddot w=-n w-2c\\dot w .\\] ",
)
SAID = (
    r"Near $u=0$ the characteristic equation is \[ POLYNOMIAL .\]",
    r"Near $u=0$, seeking $u=e^{\mu t}$, we find \[ POLYNOMIAL .\]",
)
POLYNOMIALS = (r"\mu^2+c\mu+n=0", r"n+\mu^2=-c\mu")


@pytest.mark.parametrize(
    ("other", "said", "equation"), sampled(product(OTHERS, SAID, POLYNOMIALS), 5)
)
def test_the_equation_of_the_law_is_not_proved_where_another_one_is_spoken_of(
    other, said, equation
):
    assert not is_green(SWING + other + said.replace("POLYNOMIAL", equation))


@pytest.mark.parametrize(
    "words",
    [
        r"The characteristic equation of the matrix $A$ is \[ \mu^2+c\mu+n=0 .\]",
        r"The characteristic equation is \[ \mu^2+c\mu+n=0 .\]",
        r"Near $u=0$ and $u=\pi$ the characteristic equation is \[ \mu^2+c\mu+n=0 .\]",
        r"Near $u=0$ the characteristic equation is not \[ \mu^2+c\mu+n=0 .\]",
        r"Near $u=0$ the characteristic equation is known, and $\mu=0$ is a root.",
        r"Near $u=0$ the frequencies satisfy \[ \mu^2+c\mu+n=0 .\]",
        r"Near $u=0$ the number of small oscillations is \[ \nu=\frac{\sqrt n}{2\pi} .\]",
    ],
)
def test_what_is_said_of_something_else_is_no_such_claim(words):
    kinds = [one.role.kind for one in reading(SWING + words).formulas]
    assert not {*kinds} & {*KINDS}


@pytest.mark.parametrize(
    "text",
    [
        SWING + r"Without damping, near $u=0$, the characteristic equation is \[\mu^2+c\mu+n=0 .\]",
        SWING
        + r"With a stronger damping the characteristic equation near $u=0$ is \[\mu^2+c\mu+n=0 .\]",
        SWING
        + r"If the time is reversed, the characteristic equation near $u=0$ is \[\mu^2+c\mu+n=0 .\]",
        WELL
        + r"The characteristic equation of the reduced system at the origin is \[ s^2+cs-a=0 .\]",
        FREE
        + r"Near $u=0$ the frequency of small oscillations of a pendulum twice as long is $\sqrt n$.",
        FREE + r"Let $\nu=2n$. The frequency of small oscillations near $u=0$ is \[\nu^2=n .\]",
    ],
)
def test_words_of_another_case_are_not_judged_by_the_law(text):
    assert not is_green(text)


def test_an_equation_for_frequencies_is_never_red():
    text = FREE + r"Near $u=0$ the characteristic equation is \[ \omega^2-FACTOR n=0 .\]"
    assert last(text.replace("FACTOR", "")).value == "proved"
    assert last(text.replace("FACTOR", "2")).value == "undecided"


def test_eigenvalues_of_accelerations_are_never_red():
    text = r"The equation of motion is \[\ddot u=-nu .\] The eigenvalues at the origin are $-n$."
    assert [one.value for one in verdicts(text).values()] == ["undecided"]


@pytest.mark.parametrize("words", ["The frequency of small oscillations is", "The frequency is"])
def test_of_damped_oscillations_another_frequency_may_be_meant(words):
    linear = SWING + r"Near $u=0$ we have to the first order \[ \ddot u+c\dot u+nu=0 .\] "
    assert last(linear + words + r" \[ \nu=\sqrt{n-\frac{c^2}4} .\]") is None


VELOCITIES = r"Let \[\dot x=u,\quad \dot y=v,\quad \dot u=x-x^3+yv,\quad \dot v=-2y .\] "


@pytest.mark.parametrize(("rate", "green"), [("-2(x-1)", True), ("2(x-1)", False), ("-2x", False)])
def test_velocities_vanish_at_a_place_of_which_words_give_the_coordinates(rate, green):
    text = rf"Near $x=1$, $y=0$ the linear equation is \[\ddot x={rate} .\]"
    assert [one.green for one in verdicts(VELOCITIES + text).values()] == [green]


FAMILIES = r"The equations are \[\dot x=y,\qquad \dot y=xz,\qquad \dot z=-xy .\] "


@pytest.mark.parametrize(
    "words",
    [
        r"The characteristic polynomial of the linear part at $(0,0,k)$ is $-\lambda(\lambda^2-k)$.",
        r"At the points $(0,0,k)$ the characteristic equation is $\lambda^3-k\lambda=0$.",
        r"The points $(0,0,k)$ are equilibria for every $k$. Their characteristic polynomial is $\lambda(\lambda^2-k)$.",
        r"The characteristic polynomial of the matrix of the linear part at $(0,0,k)$ is $-\mu(\mu^2-k)$.",
        r"Характеристический многочлен линеаризованной системы в точке $(0,0,k)$ равен $-\mu(\mu^2-k)$.",
        r"The matrix of the linearisation at $(0,0,k)$ is \[\begin{pmatrix}0&1&0\\k&0&0\\0&0&0\end{pmatrix},\]"
        r" and its characteristic polynomial is $-\lambda(\lambda^2-k)$.",
        r"The characteristic polynomials of the linear part are"
        r"\[-\lambda(\lambda^2+k^2)\quad\text{at }(k,0,0),\qquad -\lambda(\lambda^2-k)\quad\text{at }(0,0,k) .\]",
    ],
)
def test_a_characteristic_polynomial_is_printed_without_an_equation(words):
    assert all(one.green for one in verdicts(FAMILIES + words).values())
    wrong = words.replace("2-k)", "2-k^2)").replace(r"-k\lambda", r"+k\lambda")
    assert not [*verdicts(FAMILIES + wrong).values()][-1].green


def test_each_polynomial_of_a_display_has_its_own_place():
    words = r"The characteristic polynomials are \[-\lambda(\lambda^2+k^2)\quad\text{at }(0,0,k),\qquad "
    words += r"-\lambda(\lambda^2-k)\quad\text{at }(k,0,0) .\]"
    assert not any(one.green for one in verdicts(FAMILIES + words).values())


@pytest.mark.parametrize(("value", "green"), [(r"\frac{3l}{2g}", True), (r"\frac{2l}{3g}", False)])
def test_a_period_in_russian_words(value, green):
    law = r"Уравнение движения имеет вид \[\ddot\varphi+\frac{2g}{3l}\sin\varphi=0 .\] "
    said = rf"Период малых колебаний около $\varphi=0$ равен \[T=2\pi\sqrt{{{value}}} .\]"
    assert [one.green for one in verdicts(law + said).values()] == [green]
