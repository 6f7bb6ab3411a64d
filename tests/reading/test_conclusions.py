"""What words conclude of motions: levels on which they lie, orbits, frequencies in lists."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

BODY = r"""\[ I_1\dot u+(I_3-I_2)vw=0,\quad I_2\dot v+(I_1-I_3)wu=0,\quad I_3\dot w+(I_2-I_1)uv=0. \] """
SWING = r"""Consider \[ \frac{dq}{dt}=v,\qquad\frac{dv}{dt}=-\sin q. \] """
DISC = r"""We study \[ u'=v+u(4-u^2-v^2),\qquad v'=-u+v(4-u^2-v^2). \] """
CONE = r"""The Lagrangian is \[ L=\frac m2(\dot s^2+s^2\dot\psi^2)-ks. \] """
CHAIN = r"""Normal modes of \[ \ddot x=-ax+b(y-x),\qquad\ddot y=-ay+b(x-y) \] are studied. """
LINE = r"""Consider $\dot x=y$, $\dot y=(x^2-1)y-kx$. """


@pytest.mark.parametrize(
    ("text", "claim", "wrong"),
    [
        (BODY + "Multiplying them by $u$, $v$, $w$ and adding we find $TEX$.",
         "I_1u^2+I_2v^2+I_3w^2=h", "I_1u^2+I_2v^2-I_3w^2=h"),
        (BODY + "Hence $TEX$.", "I_1^2u^2+I_2^2v^2+I_3^2w^2=g", "I_1^2u^2+I_2^2v^2+I_3w^2=g"),
        (SWING + "The phase curves are $TEX$.", r"\frac12v^2-\cos q=h", r"\frac12v^2+\cos q=h"),
        (SWING + "Фазовые кривые имеют вид $TEX$.", r"\frac12v^2-\cos q=h", r"v^2-\cos q=h"),
        (CONE + r"Since $\psi$ is ignorable, $TEX$.", r"ms^2\dot\psi=c", r"ms\dot\psi=c"),
        (CONE + r"The angle $\psi$ is cyclic and $TEX$.", r"s^2\dot\psi=c", r"s^3\dot\psi=c"),
        (DISC + "The circle $TEX$ is a limit cycle.", "u^2+v^2=4", "u^2+v^2=2"),
        (DISC + "The circle $TEX$ is the only closed orbit.", "u^2+v^2=4", "u^2+v^2=1"),
        (CHAIN + r"The normal frequencies are $\sqrt a$ and $TEX$.", r"\sqrt{a+2b}", r"\sqrt{a+b}"),
        (LINE + r"The only equilibrium is the origin. The characteristic equation there is \[TEX.\]",
         r"\lambda^2+\lambda+k=0", r"\lambda^2-\lambda+k=0"),
        (LINE + r"The origin is the only equilibrium. Its characteristic equation is \[TEX.\]",
         r"\lambda^2+\lambda+k=0", r"\lambda^2+\lambda-k=0"),
        (r"Let \[ H=\frac12(p_x^2+p_y^2)+\frac12(x^2+y^2)+x^2y+\frac13y^3. \] "
         r"In the variables $s=x+y$, $d=y-x$ the equations separate: \[ \ddot s=-s-s^2,\qquad TEX. \]",
         r"\ddot d=-d-d^2", r"\ddot d=-d+d^2"),
    ],
)  # fmt: skip
def test_what_words_conclude_is_claimed(text, claim, wrong):
    assert verdicts(text.replace("TEX", claim))[claim].green
    assert not verdicts(text.replace("TEX", wrong))[wrong].green


@pytest.mark.parametrize(
    "text",
    [
        BODY + "From the geometry of the stand we have $u^2+v^2=c$.",
        BODY + "Hence for such motions $u^2+v^2=c$.",
        BODY + "On the sphere $u^2+v^2+w^2=c$ nothing happens.",
        SWING + "The orbits of the other system are $v^2+q=h$.",
        CONE + r"Since $\psi$ is not cyclic, $s^3\dot\psi=c$ is no integral.",
        DISC + "The circle $u^2+v^2=1$ is not a limit cycle.",
        LINE + r"The only equilibrium is not the origin. The characteristic equation there is "
        r"\[ \lambda^2-\lambda+k=0. \]",
        r"Let \[ H=\frac12(p_x^2+p_y^2)+\frac12(x^2+y^2). \] With friction one has, for $s=x+y$, "
        r"\[ \ddot s=-s. \]",
    ],
)  # fmt: skip
def test_what_is_said_of_something_else_is_not_judged(text):
    assert not {Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED} & {*verdicts(text).values()}


@pytest.mark.parametrize(
    "words",
    [
        "Put $s=2t$ and let $'=d/ds$. We study ",
        "The prime denotes the derivative with respect to $s=2t$. We study ",
        r"Primes are derivatives by the slow time $T=\varepsilon t$. We study ",
        "The arc length $s=2t$ is the independent variable. We study ",
        "Штрих означает производную по $s$. ",
        "We study ",
    ],
)
def test_primes_are_by_a_time_that_is_not_known(words):
    text = words + r"\[ x'=y,\qquad y'=-x. \] A solution is $x=\sin t$, $y=\cos t$."
    assert not any(verdict.green for verdict in verdicts(text).values())


@pytest.mark.parametrize(
    ("value", "then", "greens"),
    [
        (r"\pm ik", "-k^2", [True, True, True]),
        (r"\pm k", "k^2", [False, False, False]),
        (r"\pm ik", "k^2", [True, True, False]),
    ],
)
def test_what_follows_from_a_value_that_is_not_proved_is_not_green(value, then, greens):
    text = rf"The system $\dot x=y$, $\dot y=-k^2x$ has the eigenvalues $\mu={value}$. Hence $\mu^2={then}$."
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    assert [outcomes[f.claim.id].verdict.green for f in found.formulas if f.claim] == greens


def test_what_follows_from_an_eigenvalue_that_is_corrected_is_not_green():
    text = r"The system $\dot x=-kx$ has the eigenvalue $\mu=k$ at the origin. Hence $\mu+k=2k$."
    assert not any(one.green for one in verdicts(text).values())
