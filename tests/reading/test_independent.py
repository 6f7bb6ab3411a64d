"""The independent variable by any letter: what is derived by it alone moves with it."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

LETTERS = ["x", r"\tau", r"\xi", "s", r"\varphi", "z"]


@pytest.mark.parametrize("by", LETTERS)
@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"\frac{d^2u}{dX^2}=X-u^2", True),
        (r"\frac{d^2u}{dX^2}=X+u^2", False),
        (r"\frac{d}{dX}(uv)=v^2-u^3+X u", True),
        (r"\frac{d}{dX}(uv)=v^2-u^3", False),
    ],
)
def test_a_law_by_another_letter_is_one(by, claim, verdict):
    law = r"The equations are \[ \frac{du}{dX}=v,\qquad \frac{dv}{dX}=X-u^2 . \] Then \[ %s . \]"
    found = verdicts((law % claim).replace("dX", f"d{by} ").replace("X", f"{by} "))
    assert [one.green for one in found.values()] == [verdict]


@pytest.mark.parametrize(
    "words",
    [
        "A prime is the derivative with respect to $x$.",
        "For a function $u=u(x)$ we have the following.",
        "Put $'=d/dx$.",
        "Let us denote the derivative by $x$ with a prime.",
        "Штрих означает производную по $x$.",
    ],
)
@pytest.mark.parametrize(
    ("value", "green"), [("-2/x^2", True), ("-6/x^2", True), ("-3/x^2", False)]
)
def test_solutions_by_it_are_decided(words, value, green):
    text = rf"{words} The equation is \[ u''''+10uu''+5u'^2+10u^3=0 . \] A solution is $u={value}$."
    assert [one.green for one in verdicts(text).values()] == [green]


@pytest.mark.parametrize(
    "text",
    [
        r"The equation is \[ u''+u=0 . \] With $x=kt$ a solution is $u=\sin t$.",
        r"A prime is the derivative by $x$. \[ u''+u=0 . \] A solution is $u=\sin t$.",
        r"The equation is \[ \frac{d^2u}{dx^2}=-u . \] A solution is $u=\sin t$.",
    ],
)
def test_nothing_is_a_time_beside_t(text):
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(("side", "green"), [("+", True), ("-", False)])
def test_a_constant_alone_on_the_right_is_a_force(side, green):
    law = r"The equation \[ \ddot x+\omega^2x^3=F \] with constant $F$ "
    law += rf"has the integral $E=\frac12\dot x^2{side}\frac14\omega^2x^4-Fx$."
    assert [one.green for one in verdicts(law).values()] == [green]


@pytest.mark.parametrize(("value", "green"), [(r"\frac12", True), (r"-\frac12", False)])
def test_four_derivatives_are_read(value, green):
    law = r"The beam obeys \[ \ddddot y+y=0 . \] "
    law += rf"The quantity \[ I=\dot y\dddot y-\frac12\ddot y^2+{value}y^2 \] is an integral."
    found = [*verdicts(law).values()]
    assert found == [Verdict.PROVED if green else Verdict.REFUTED]


KEPLER = r"""The equations are \[ \ddot r-r\dot\varphi^2=-\frac{\mu}{r^2},\qquad
r\ddot\varphi+2\dot r\dot\varphi=0 . \] Let $u=1/r$ and $h=r^2\dot\varphi$. """
BELETSKY = r"""The equations of motion are \[ \dot\nu=k(1+e\cos\nu)^2,\qquad
\ddot\theta+\ddot\nu+\frac{\mu\dot\nu^2}{1+e\cos\nu}\sin\theta\cos\theta=0 . \] """


@pytest.mark.parametrize(
    "words",
    [
        r"Taking $\varphi$ as the independent variable we obtain",
        r"Let a prime denote the derivative with respect to $\varphi$. Then",
        r"Обозначим штрихом производную по $\varphi$. Тогда",
    ],
)
@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_what_moves_may_be_it_beside_the_time(words, sign, green):
    found = verdicts(KEPLER + words + rf" \[ u''{sign}u=\frac{{\mu}}{{h^2}} . \]")
    assert [one.green for one in found.values()] == [green]


BY_THE_ANGLE = [
    r"A prime on $u$ denotes $d/d\varphi$.",
    r"Primes stand for $\frac{\mathrm d}{\mathrm d\varphi}$.",
    r"We denote $\mathrm{d}/\mathrm{d}\varphi$ by a prime.",
    r"We write $'$ for $d/d\varphi$.",
    r"Let $u'=\frac{du}{d\varphi}$.",
    r"Let $u'\equiv du/d\varphi$.",
    r"Differentiation with respect to the polar angle $\varphi$ is denoted by a prime.",
    r"Let a prime on $u$ denote the derivative with respect to $\varphi$.",
    r"We regard $u$ as a function of $\varphi$.",
    r"Штрих означает $d/d\varphi$.",
]


@pytest.mark.parametrize("words", sampled(BY_THE_ANGLE, 4))
def test_a_prime_stands_for_a_quotient_of_differentials(words):
    rows = (r"\dot r=-hu'", r"\dot r=hu'", r"u''+u=\frac{\mu}{h^2}", r"u''-u=\frac{\mu}{h^2}")
    found = verdicts(KEPLER + words + " Then " + "".join(rf" \[ {row} . \]" for row in rows))
    assert [one.green for one in found.values()] == [True, False, True, False]
    assert not {*found.values()} & {Verdict.UNDECIDED}


@pytest.mark.parametrize(
    "words",
    [
        r"A prime denotes $d/d\tau$.",
        r"The potential is $V=-\mu/r$, $V'=dV/dr$.",
        r"A prime denotes $d/d\varphi$; from now on a prime denotes $d/dr$.",
        r"We regard $V$ as a function of $r$.",
    ],
)
def test_primes_by_another_variable_are_none_by_the_angle(words):
    found = verdicts(KEPLER + words + r" Then \[ u''+u=\frac{\mu}{h^2} . \]")
    assert not any(one.green or one is Verdict.REFUTED for one in found.values())


@pytest.mark.parametrize(("factor", "green"), [("2", True), ("", False)])
def test_an_angle_that_is_given_by_its_rate_may_be_it(factor, green):
    words = (
        r"Take $\nu$ as the independent variable and denote by a prime the derivative by $\nu$. "
    )
    claim = rf"(1+e\cos\nu)\theta''-{factor}e\sin\nu\,\theta'+\mu\sin\theta\cos\theta=2e\sin\nu"
    found = verdicts(BELETSKY + words + rf"Then \[ {claim} . \]")
    assert [one.green for one in found.values()] == [green]


def test_beside_dots_primes_derive_by_what_words_say_alone():
    assert not verdicts(KEPLER + r"Then \[ u''+u=\frac{\mu}{h^2} . \]")


@pytest.mark.parametrize(
    "words",
    [
        r"The function $W$ satisfies $\frac12\left(\frac{dW}{dx}\right)^2+V=E$.",
        r"At equilibrium $\frac{dV}{dx}=0$.",
    ],
)
def test_a_coordinate_is_none(words):
    law = r"Let $H=\frac12p^2+V$ be the Hamiltonian, where $V=\frac14x^4$. "
    found = verdicts(law + words + " The function $xp$ is an integral.")
    assert found["xp"] is Verdict.REFUTED


def test_a_constant_is_none():
    law = r"The equations are \[ x'=y,\qquad y'=-x^3 . \] The period obeys $\frac{dT}{da}=-\frac Ta$. "
    found = verdicts(law + r"The function $y^2+\frac12x^4$ is an integral.")
    assert [*found.values()] == [Verdict.PROVED]


@pytest.mark.parametrize(("factor", "verdict"), [("2", "conditional"), ("", "refuted")])
def test_a_rate_among_words_is_the_ground_of_what_is_deduced(factor, verdict):
    text = r"""The body obeys \[ \ddot\theta=-\sin\theta . \] By the law of areas
$\dot\nu=k(1+e\cos\nu)^2$, $k=\mathrm{const}$, and therefore """
    text += rf"\[ \ddot\nu=-\frac{{{factor}e\sin\nu}}{{1+e\cos\nu}}\dot\nu^2 . \]"
    assert [one.value for one in verdicts(text).values()] == [verdict]


def test_what_it_gives_defines_nothing():
    text = BELETSKY + r"Take $\nu$ as the independent variable with $'=d/d\nu$. For small $e$ "
    text += r"\[ \theta''+\mu\theta=3e\sin\nu \] has the solution \[ \theta=\frac{3e}{\mu-1}\sin\nu . \]"
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (
            r"The curve $y(x)$ obeys \[ \frac{d^2y}{dx^2} = \kappa y . \] Therefore"
            r" \[ y'' = %s\kappa y . \]",
            "",
            "-",
        ),
        (
            r"We want the solutions of \[ (4z - 2y)\frac{dz}{dy} + 2y - 2z = 0 . \] The solution is"
            r" \[ y^2 %s yz + 2z^2 = K . \]",
            "-2",
            "-3",
        ),
    ],
)
def test_an_equation_of_a_curve_is_a_law_of_its_own(text, right, wrong):
    assert [one.green for one in verdicts(text % right).values()] == [True]
    assert [*verdicts(text % wrong).values()] == [Verdict.REFUTED]


GEODESIC = r"""The geodesics of a surface of revolution obey \[ \begin{cases} \ddot u=f(u)f'(u)\dot v^2,\\[4pt]
\ddot v+\dfrac{2f'(u)}{f(u)}\dot u\dot v=0. \end{cases} \] %s Hence """


@pytest.mark.parametrize(
    "words",
    [
        "The dot stands for the derivative with respect to the arc length $s$ of the geodesic.",
        "Dots denote derivatives with respect to $s$.",
        "Here the dot means $d/ds$.",
        "Точка обозначает производную по длине дуги $s$.",
    ],
)
def test_dots_derive_by_what_words_say_and_so_do_quotients(words):
    for factor, green in (("f^2", True), ("f", False)):
        claim = rf"\[ \frac{{\mathrm{{d}}}}{{\mathrm{{d}}s}}\left({factor}\dot v\right)=0. \]"
        assert [one.green for one in verdicts(GEODESIC % words + claim).values()] == [green]


@pytest.mark.parametrize("words", ["", "Dots denote derivatives with respect to the time $t$."])
def test_quotients_by_another_letter_are_no_dots(words):
    claim = r"\[ \frac{d}{ds}\left(f^2\dot v\right)=0. \]"
    assert not any(one.green for one in verdicts(GEODESIC % words + claim).values())
