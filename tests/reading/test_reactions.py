"""Tensions, frictions and other reactions: what binds the motion determines them."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

ROLLING = [
    r"\begin{align} m\ddot s&=mg\sin\alpha-f,\\ I\dot\omega&=fR,\\ \dot s&=R\omega, \end{align}"
    r" where $I=\frac12mR^2$. ",
    r"\begin{align} m\ddot s&=mg\sin\alpha-f,\\ I\dot\omega&=fR, \end{align} where $I=\frac12mR^2$."
    r" The cylinder rolls without slipping, $\dot s=R\omega$. ",
    r"The equations are $m\ddot s=mg\sin\alpha-f$ and $I\dot\omega=fR$ with $\dot s=R\omega$,"
    r" where $I=\frac12mR^2$. ",
]
ATWOOD = [
    r"Two bodies hang on a thread: \[m_1\ddot x=m_1g-T,\qquad m_2\ddot x=T-m_2g.\] ",
    r"Two bodies hang on a thread: \[m_1\ddot x=m_1g-T,\qquad m_2\ddot y=m_2g-T,\] where $x+y=l$. ",
    r"Let $m_1\ddot x=m_1g-T$, $m_2\ddot y=m_2g-T$, $x+y=l$. ",
]
PULLEY = r"""Let the pulley have a moment of inertia: \begin{align} m_1\ddot x&=m_1g-T_1,\\
m_2\ddot x&=T_2-m_2g,\\ J\ddot\varphi&=(T_1-T_2)R,\\ x&=R\varphi. \end{align} """


@pytest.mark.parametrize("law", ROLLING)
@pytest.mark.parametrize(
    ("claim", "true"),
    sampled(
        [
            (r"\ddot s=\tfrac23g\sin\alpha", True),
            (r"\ddot s=\tfrac13g\sin\alpha", False),
            (r"f=\tfrac13mg\sin\alpha", True),
            (r"f=\tfrac23mg\sin\alpha", False),
            (r"\frac{d}{dt}(\tfrac12m\dot s^2+\tfrac12I\omega^2-mgs\sin\alpha)=0", True),
            (r"\frac{d}{dt}(\tfrac12m\dot s^2-\tfrac12I\omega^2-mgs\sin\alpha)=0", False),
        ],
        3,
    ),
)
def test_a_body_that_rolls(law, claim, true):
    assert [one.green for one in verdicts(rf"{law}Hence \[{claim}.\]").values()] == [true]


@pytest.mark.parametrize("law", ATWOOD)
@pytest.mark.parametrize(
    ("claim", "true"),
    [
        (r"\ddot x=\frac{m_1-m_2}{m_1+m_2}g", True),
        (r"\ddot x=\frac{m_1+m_2}{m_1-m_2}g", False),
        (r"T=\frac{2m_1m_2}{m_1+m_2}g", True),
        (r"T=\frac{m_1m_2}{m_1+m_2}g", False),
    ],
)
def test_bodies_on_a_thread(law, claim, true):
    assert [one.green for one in verdicts(rf"{law}Hence \[{claim}.\]").values()] == [true]


@pytest.mark.parametrize(("sign", "true"), [("-", True), ("+", False)])
def test_two_tensions_and_two_constraints(sign, true):
    text = rf"Then \[ \ddot x=\frac{{m_1{sign}m_2}}{{m_1+m_2+J/R^2}}g. \]"
    assert [one.green for one in verdicts(PULLEY + text).values()] == [true]


def test_a_force_that_binds_nothing_is_any_constant():
    text = r"The equations of motion are \[m\ddot x=F,\qquad M\ddot y=-F.\] Hence "
    true, false = r"$m\dot x+M\dot y$ is conserved.", r"$m\dot x-M\dot y$ is conserved."
    assert all(one.green for one in verdicts(text + true).values())
    assert [*verdicts(text + false).values()] == [Verdict.REFUTED]


ON_TABLE = (
    r"A ball rolls on a table that turns: $m\ddot x=F_1$, $m\ddot y=F_2$, $kma\dot\omega_1=F_2$,"
    r" $kma\dot\omega_2=-F_1$, and $\dot x-a\omega_2=-\Omega y$, $\dot y+a\omega_1=\Omega x$. "
)
PUSHED = r"A wheel rolls by $m\ddot x=R$, $I\ddot\varphi=M-aR$ with $\dot x=a\dot\varphi$. "


@pytest.mark.parametrize(
    ("law", "claim", "true"),
    [
        (ON_TABLE, r"Hence $(1+1/k)\ddot x=-\Omega\dot y$.", True),
        (ON_TABLE, r"Hence $(1-1/k)\ddot x=-\Omega\dot y$.", False),
        (PUSHED, r"Hence $(I+ma^2)\ddot x=aM$.", True),
        (PUSHED, r"Hence $(I-ma^2)\ddot x=aM$.", False),
        (PUSHED, r"The function $\frac12(I+ma^2)\dot x^2-aMx$ is an integral.", True),
        (PUSHED, r"The function $\frac12(I-ma^2)\dot x^2-aMx$ is an integral.", False),
        (PUSHED, r"The reaction is $R=\frac{maM}{I+ma^2}$.", True),
        (PUSHED, r"The reaction is $R=\frac{maM}{I-ma^2}$.", False),
    ],
)
def test_a_reaction_alone_on_a_side_is_no_value(law, claim, true):
    found = [*verdicts(law + claim).values()]
    assert found[-1].green == true


@pytest.mark.slow
def test_what_is_at_rest_by_words_is_another_case():
    found = [*verdicts(rf"{ON_TABLE}For a table at rest we have $\ddot x=\ddot y=0$.").values()]
    assert found == [Verdict.UNDECIDED]
