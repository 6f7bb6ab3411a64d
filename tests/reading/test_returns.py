"""A text may come back to an earlier system, and name what is small without being approximate."""

from itertools import product

import pytest

from tests.reading.test_reading import reading, verdicts

PLANE = r"""\section{Polar} The equations are
$$\ddot r=r\dot\theta^2-\frac{k}{r^2},\qquad r\ddot\theta=-2\dot r\dot\theta .$$
\section{Cartesian} Now consider another system: in the plane
$$\ddot x=-ax,\qquad \ddot y=-ay .$$ Then $x\dot y-y\dot x$ is constant."""


def test_a_section_that_derives_what_moved_before_is_read_by_the_earlier_law():
    text = rf"{PLANE} \section{{Areas}} Let $C=r^2\dot\theta$. Then $$\dot C=0.$$"
    assert verdicts(text)[r"\dot C=0"].green
    assert not verdicts(text.replace(r"C=r^2", "C=r^3"))[r"\dot C=0"].green


def test_a_section_that_derives_what_moves_by_both_stays_with_the_later_law():
    text = rf"{PLANE} \section{{Both}} Now $$\dot x=\dot r.$$"
    found = reading(text)
    known = found.parts.of(found.formulas[-1].item)
    assert known is found.parts.of(found.formulas[2].item)


def test_the_frequency_of_small_oscillations_makes_no_law_approximate():
    text = r"""The pendulum moves by $$\ddot\varphi=-\omega^2\sin\varphi,\qquad \ddot z=-g,$$
    where $\omega$ is the frequency of the small oscillations. Hence
    $$\frac{d}{dt}(\dot\varphi^2-2\omega^2\cos\varphi)=0.$$"""
    assert [one.green for one in verdicts(text).values()] == [True]
    false = text.replace("-2", "+2")
    assert [one.green for one in verdicts(false).values()] == [False]


def test_a_function_that_is_given_behind_names_no_constant():
    text = r"""The motion is $$\ddot u=1-6u^2.$$ Let $h=\tfrac12\dot u^2-u+2u^3$. Then
    $$\dot u^2=f(u),\qquad f(u)=2h+2u-4u^3.$$"""
    found = verdicts(text)
    assert found[r"\dot u^2=f(u)"].green
    assert not verdicts(text.replace("-4u", "-3u"))[r"\dot u^2=f(u)"].green


def test_a_function_without_its_argument_is_a_name():
    text = r"""The motion is $$\dot u=-u.$$ Let $f(u)=u^2$. The function $f$ tends to zero for
    $u\to+\infty$."""
    roles = {one.item.typed.tex: one.role.name for one in reading(text).formulas}
    assert roles["f"] == "notation"
    assert roles[r"u\to+\infty"] == "other"


FORCED = r"""\section{Free} The point moves by $$\ddot x+ax+bx^3=0 .$$
Let $H=\tfrac12\dot x^2+\tfrac12ax^2+\tfrac14bx^4$. Then $\dot H=0$.
\section{A constant force} Let us add a constant $f$ on the right: $$\ddot x+ax+bx^3=f.$$
The energy changes to $K=H-fx$, and $\dot K=0$."""


def test_what_is_added_to_the_forces_is_no_name_of_zero():
    assert [one.green for one in verdicts(FORCED).values()] == [True, True]
    for wrong in ("K=H-2fx", "K=H+fx", "K=H"):
        first, second = verdicts(FORCED.replace("K=H-fx", wrong)).values()
        assert (first.green, second.green) == (True, False)


def test_what_was_named_before_keeps_its_name_where_a_force_is_added():
    text = r"""\section{Free} The point moves by $$\ddot x+ax+bx^3=0 .$$ Write $y=\dot x$. The energy is
    $$H=\tfrac12y^2+\tfrac12ax^2+\tfrac14bx^4,$$ i.e. $\dot H=0$.
    \section{Friction} Real springs are not ideal: $$\ddot x+2c\dot x+ax+bx^3=0,\qquad c>0.$$
    With the same $H$ we obtain $$\dot H=-2cy^2.$$"""
    assert verdicts(text)[r"\dot H=-2cy^2"].green
    assert not verdicts(text.replace("-2cy^2", "-2cy"))[r"\dot H=-2cy"].green


BOOST = r"""The coordinates in the {word} $S'$ are \[ x'=\gamma(x-vt),\qquad t'=\gamma\Bigl(t-\frac{{vx}}{{c^2}}\Bigr),
\qquad \gamma=\frac1{{\sqrt{{1-v^2/c^2}}}} . \] Hence \[ c^2t'^2-x'^2=c^2t^2-{factor}x^2 . \]"""


@pytest.mark.parametrize(("factor", "green"), [("", True), ("2", False)])
def test_primes_of_another_frame_are_no_derivatives(factor, green):
    found = verdicts(BOOST.format(word="frame", factor=factor))
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize(
    "text",
    [
        r"A first integral is $$\ddot x+3ax=c.$$ Hence $$\dot x^2+3ax^2-2cx$$ is constant.",
        r"The quantity $$x\ddot x+\dot x^2=c$$ is constant. Hence $$\frac{d}{dt}(x\ddot x+\dot x^2)=0.$$",
        r"From this we obtain $$\ddot x+2ax=c.$$ Hence $$\frac{d}{dt}(\dot x^2+2ax^2-2cx)=0.$$",
    ],
)
def test_what_is_called_an_integral_or_is_deduced_is_no_law(text):
    law = r"\section{Free} The point moves by $$\ddot x+ax=0.$$"
    found = verdicts(rf"{law} \section{{More}} {text}")
    assert found
    assert not any(verdict.green for verdict in found.values())


FRICTION = r"""The point moves by \begin{equation}\label{free}\ddot x+ax+bx^3=0.\end{equation} The energy is
\[ H=\frac12\dot x^2+\frac12ax^2+\frac14bx^4 .\] \section{Friction} Real springs are not ideal:
\begin{equation}\label{damped}\ddot x+2c\dot x+ax+bx^3=0 .\end{equation} We obtain $\dot H=-2c\dot x^2$. """
CITES = [
    r"Let $z=x^2$, $x$ being any solution of \eqref{LAW}. Then",
    r"Let $z=x^2$, where $x$ is a solution of \eqref{LAW}. Prove that",
    r"Let us go back to \eqref{LAW}. With $z=x^2$ we have",
    r"We return to \eqref{LAW} and put $z=x^2$. We have",
    r"Let $z=x^2$. For the solutions of \eqref{LAW} we have",
]


@pytest.mark.parametrize(("words", "law"), [*product(CITES, ("free", "damped"))])
def test_what_is_defined_for_the_motions_of_a_cited_law_moves_by_this_law(words, law):
    rate = r" \[ \ddot z=4H-4az-3bz^2 .\]"
    found = verdicts(FRICTION + words.replace("LAW", law) + rate)
    assert found[r"\ddot z=4H-4az-3bz^2"].green is (law == "free")


def test_what_cannot_be_read_is_no_hindrance_to_another_system():
    first = r"\section{First} Consider $\ddot x+ax=0$. Then $\dot x^2+ax^2$ is constant. "
    other = r"\section{More} The equation is $\ddot x+2m\dot x+ax=0$. "
    unread = r"Here $x=1,2,3$ and $\dot x\le0\text{ unless }a$."
    assert [one.green for one in verdicts(first + other + unread).values()] == [True]
