r"""Names that equations give together, and names that are used before it is said what they are."""

import random

import pytest

from kowalevski_cas.audit.reading import uncovered
from kowalevski_cas.reading.known import TOGETHER
from kowalevski_cas.verify.outcome import Verdict
from tests.laws.test_prints import FEW
from tests.reading.test_reading import reading, roles, verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")


@FEW
def test_what_is_given_together_moves_and_no_misprint_of_it_is_green(seed):
    """With xy'-yx' and the like as coefficients: a token changed in a rate is never proved."""
    chance = random.Random(seed)
    u, v = chance.choice([("u", "v"), (r"\xi", r"\eta"), ("w_1", "w_2")])
    a, b = chance.sample(range(2, 6), 2)
    law = r"The equations of motion are $$\dot x=y,\quad \dot y=-x.$$ "
    sum_of, product = f"{a}x={u}+{v}", f"{b}y={u}{v}"
    pair = [sum_of, product]
    chance.shuffle(pair)
    text = law + rf"We introduce the variables ${u}$, ${v}$ by $${pair[0]},\quad {pair[1]}.$$ "
    true = [
        rf"\dot{{{u}}}+\dot{{{v}}}={a}y",
        rf"\frac{{d}}{{dt}}({u}{v})=-{b}x",
        rf"({u}-{v})\dot{{{u}}}={a}y{u}+{b}x",
    ]
    false = [
        rf"\dot{{{u}}}+\dot{{{v}}}={b}y",
        rf"\frac{{d}}{{dt}}({u}{v})={b}x",
        rf"({u}+{v})\dot{{{u}}}={a}y{u}+{b}x",
    ]
    found = verdicts(text + "Then " + " and ".join(f"$${one}$$" for one in (*true, *false)))
    assert all(found[one].green for one in true), (text, found)
    assert not any(found[one].green for one in false), (text, found)


@pytest.mark.parametrize(
    "text",
    [
        r"Let $\alpha x+\beta y=0$ and $\alpha y=\beta$.",
        r"We introduce $c$ by $x^2+y^2=c^2$.",
        r"We introduce the variable $u$ by $u=x+y$.",
    ],
)
def test_nothing_else_is_given_together(text):
    law = r"The equations of motion are $$\dot x=y,\quad \dot y=-x.$$ "
    assert TOGETHER not in {one.role.kind for one in reading(law + text).formulas}


def test_what_is_claimed_of_a_name_is_said_of_what_is_printed_behind_it():
    law = r"The equations of motion are $$\dot x=xy,\quad \dot y=x-y^2.$$ For $p=x^2$ we have "
    text = (
        law + r"\[\dot p=2sp,\] where $s$ is the second coordinate: \[s=y.\] Then \[\dot s=x-s^2.\]"
    )
    assert roles(text.replace("s=y", "s=y+0x"))["s=y+0x"] == "definition"
    found = verdicts(text.replace("s=y", "s=y+0x"))
    assert found[r"\dot p=2sp"].green
    assert not verdicts(text.replace("s=y", "s=y+x"))[r"\dot p=2sp"].green


def test_what_is_called_a_constant_is_claimed_to_be_one():
    law = r"The equations of motion are $$\dot x=y,\quad \dot y=-x.$$ "
    text = law + r"With a constant $c$ we have \[y^2=c-x^2.\] It is \[c=y^2+x^2.\]"
    found = verdicts(text)
    assert found["c=y^2+x^2"].green and found["y^2=c-x^2"].green
    assert not verdicts(text.replace("c=y^2+x^2", "c=y^2+2x^2"))["c=y^2+2x^2"].green


def test_another_time_is_no_variable():
    law = r"\section{A} The equations of motion are $$\dot x=xy,\quad \dot y=-x^2.$$ A new time is \[dt=x\,d\tau.\]"
    other = (
        r"\section{B} Another system is $$\ddot z=-z.$$ Its energy \[h=\dot z^2+z^2\] is constant."
    )
    assert verdicts(law + other)["h=\\dot z^2+z^2"].green


def test_a_law_of_momenta_may_have_the_letters_of_another_section():
    first = r"\section{A} The body moves by $$A\dot\omega_1=a\omega_2\omega_3,\ B\dot\omega_2=b\omega_3\omega_1,\ C\dot\omega_3=c\omega_1\omega_2.$$ "
    ball = r"\section{B} The ball has $$\mathbf M=\mathbf I\boldsymbol\omega+D\boldsymbol\gamma\times(\boldsymbol\omega\times\boldsymbol\gamma),$$ where $\mathbf I=\operatorname{diag}(A,B,C)$, and moves by $$\dot{\mathbf M}=\mathbf M\times\boldsymbol\omega,\quad \dot{\boldsymbol\gamma}=\boldsymbol\gamma\times\boldsymbol\omega.$$ "
    found = verdicts(first + ball + r"The function $(\mathbf M,\boldsymbol\gamma)$ is an integral.")
    assert found[r"(\mathbf M,\boldsymbol\gamma)"].green


@pytest.mark.parametrize("time", [r"t=\frac{a}{b}s", r"s=\frac{b}{a}t", r"s=\frac{bt}{a}"])
def test_a_multiple_of_the_time_is_another_time(time):
    """It is s by letter, beside τ; a wrong factor is not proved."""
    law = r"The equation of motion is $$\ddot x=-b^2x.$$ With $\tau=bt$ it is $$\frac{d^2x}{d\tau^2}=-x,$$ "
    text = (
        law
        + rf"and if time is measured by $s$ with ${time}$, we have $$\frac{{d^2x}}{{ds^2}}=-a^2x.$$"
    )
    found = verdicts(text)
    assert found[r"\frac{d^2x}{d\tau^2}=-x"].green
    assert found[r"\frac{d^2x}{ds^2}=-a^2x"].green
    false = verdicts(text.replace("-a^2x", "-ax"))
    assert not false[r"\frac{d^2x}{ds^2}=-ax"].green


def test_the_square_of_a_new_constant_defines_it():
    law = (
        r"The equation of motion is $$\ddot x=-\frac gl x.$$ Put $c^2=g/l$. Then $$\ddot x=-c^2x.$$"
    )
    assert roles(law)["c^2=g/l"] == "definition"
    assert verdicts(law)[r"\ddot x=-c^2x"].green
    assert not verdicts(law.replace("-c^2x", "-cx"))[r"\ddot x=-cx"].green
    assert roles(law.replace("Put", "If"))["c^2=g/l"] == "assumption"


def test_a_prime_before_an_argument_derives_by_it_beside_another_time():
    """By the number π nothing is derived."""
    law = r"The equation of motion is $$\ddot x=-k\sin x\cos x.$$ With $$W(x)=\frac k2\sin^2x$$ "
    text = law + r"we have $\ddot x=-W'(x)$, and $$c^2x''=-W'(x)$$ with $\tau=ct$."
    found = verdicts(text)
    assert found[r"\ddot x=-W'(x)"].green
    assert not verdicts(text.replace("=-W'(x)$,", "=-2W'(x)$,"))[r"\ddot x=-2W'(x)"].green
    assert not any(one.green for one in verdicts(law + r"we have $W''(\pi)=2k$.").values())


def test_what_holds_in_a_limit_is_not_refuted():
    law = r"The equation of motion is $$\ddot x=-k\dot x-x.$$ For $k\to0$ only $$\ddot x=-x$$ remains."
    assert r"\ddot x=-x" not in verdicts(law) and uncovered(reading(law))
    assert (
        verdicts(law.replace(r"For $k\to0$ only", "We have"))[r"\ddot x=-x"] is not Verdict.PROVED
    )
