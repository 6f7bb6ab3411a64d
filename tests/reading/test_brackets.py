"""Poisson brackets as papers define them: by functions, and with any indices."""

import pytest

from kowalevski_cas.reading import DEFINITION
from tests.reading.test_reading import reading, verdicts

OSCILLATOR = r"""The equations of motion are \[\dot u=a,\quad \dot v=b,\quad \dot a=-ku,\quad \dot b=-kv .\]
Let $H=\frac12(a^2+b^2)+\frac k2(u^2+v^2)$ and $L=ub-va$. """
USUAL = (
    r"\[\{f,g\}=\frac{\partial f}{\partial u}\frac{\partial g}{\partial a}"
    r"-\frac{\partial f}{\partial a}\frac{\partial g}{\partial u}"
    r"+\frac{\partial f}{\partial v}\frac{\partial g}{\partial b}"
    r"-\frac{\partial f}{\partial b}\frac{\partial g}{\partial v} .\]"
)
OPPOSITE = USUAL.replace("f}{", "h}{").replace("g}{", "f}{").replace("h}{", "g}{")


@pytest.mark.parametrize(
    ("bracket", "claim", "verdict"),
    [
        (USUAL, r"\{u,H\}=a", "proved"),
        (USUAL, r"\{H,u\}=a", "refuted"),
        (OPPOSITE, r"\{H,u\}=a", "proved"),
        (OPPOSITE, r"\{u,H\}=a", "refuted"),
        (USUAL, r"\{L,u\}=v", "proved"),
        (USUAL, r"\{L,u\}=b", "refuted"),
        (USUAL, r"\{u,a\}=1", "proved"),
        (USUAL, r"\{u,a\}=-1", "undecided"),
    ],
)
def test_the_bracket_of_any_functions_has_its_sign(bracket, claim, verdict):
    text = OSCILLATOR + rf"The bracket of two functions is {bracket} Hence \[{claim} .\]"
    assert [one.value for one in verdicts(text).values()] == [verdict]


def test_what_is_not_skew_is_no_bracket():
    text = OSCILLATOR + USUAL.replace("-", "+") + r" Hence \[\{u,H\}=a .\]"
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\dot z_1=\{z_1,H\}", True),
        (r"\dot z_1=\{H,z_1\}", False),
        (r"\{z_1z_2,w_2\}=z_1", True),
        (r"\{z_1z_2,w_2\}=z_2", False),
    ],
)
def test_brackets_are_read_with_any_indices(claim, green):
    text = (
        r"The equations are \[\dot z_1=w_1,\quad \dot z_2=w_2,\quad \dot z_3=w_3,\quad \dot w_1=-z_1,\quad"
        r"\dot w_2=-z_2,\quad \dot w_3=-z_3 .\] Let $H=\frac12\sum_{m=1}^3(z_m^2+w_m^2)$. The brackets are "
        rf"\[\{{z_m,w_n\}}=\delta_{{mn}} .\] Then \[{claim} .\]"
    )
    assert [one.green for one in verdicts(text).values()] == [green]
    assert DEFINITION in {
        f.role.name for f in reading(text).formulas if r"\delta" in f.item.typed.tex
    }


@pytest.mark.parametrize(
    ("claim", "judged"),
    [
        (r"\{u,B\}=0 \] where \[ B=c^2+s", False),
        (r"\{B,u\}=0 \] where \[ B=\rho", False),
        (r"\{u,c^2\}=0", False),
        (r"\{u,B\}=0 \] where \[ B=cv+s", True),
        (r"\{B,u+v\}=0 \] where \[ B=a-b", True),
    ],
)
def test_a_bracket_with_what_does_not_move_says_nothing(claim, judged):
    """The letters may have been meant to move."""
    found = verdicts(rf"{OSCILLATOR}{USUAL} Then \[ {claim} . \]")
    tex = claim.split(r" \]")[0]
    assert (found.get(tex) is not None) is judged
    assert not judged or found[tex].green


LINEAR = r"""The equations are $$\dot x=yz,\qquad \dot y=-2xz,\qquad \dot z=xy.$$ Let $\{x,y\}=z$, $\{y,z\}=x$,
$\{z,x\}=y$ and $H=\tfrac12(x^2-z^2)$. """


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"Then the equations are $\dot f=\{f,H\}$.", True),
        (r"Then the equations are $$\dot F=-\{H,F\}$$ for every function $F$.", True),
        (r"Then the equations are $\dot f=\{H,f\}$.", False),
        (r"Then the equations are $\dot f=\{f,H+x\}$.", False),
        (r"Then $\{x^2+y^2+z^2,f\}=0$ for all $f$.", True),
        (r"Then $\{f,x^2+y^2+z^2\}=\{f,1\}=0$ for all $f$.", True),
        (r"Then $\{x^2+y^2-z^2,f\}=0$ for all $f$.", False),
        (r"Then $\{f,x^2+y^2+z^2\}=\{H,f\}=0$ for all $f$.", False),
    ],
)
def test_what_is_said_of_any_function_holds_for_every_variable(words, green):
    assert [one.green for one in verdicts(LINEAR + words).values()] == [green]


@pytest.mark.parametrize("words", [r"\dot f=\{f,f\}", r"\dot f=f\{f,H\}", r"\dot g=\{f,H\}"])
def test_what_derives_no_function_or_two_is_said_of_none(words):
    assert not any(one.green for one in verdicts(rf"{LINEAR}Then ${words}$.").values())


PAIR = (
    r"\frac{\partial f}{\partial u_K}\frac{\partial g}{\partial v_K}"
    r"-\frac{\partial f}{\partial v_K}\frac{\partial g}{\partial u_K}"
)
WITH_FACTORS = [
    r"\sum_k m_k^{-1}\bigl(" + PAIR.replace("K", "k") + r"\bigr)",
    rf"\frac{{1}}{{m_1}}\left({PAIR.replace('K', '1')}\right)+\frac{{1}}{{m_2}}\left({PAIR.replace('K', '2')}\right)",
    rf"-m_1^{{-1}}\bigl(-{PAIR.replace('K', '1').replace('-', '+')}\bigr)"
    rf"+m_2^{{-1}}\bigl({PAIR.replace('K', '2')}\bigr)",
]
"""A bracket of points with strengths, as it may be printed."""


@pytest.mark.parametrize("bracket", WITH_FACTORS)
@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\{Q,P\}=m_1+m_2", True),
        (r"\{H,Q\}=0", True),
        (r"\{u_1,v_1\}=1/m_1", True),
        (r"\{Q,P\}=m_1-m_2", False),
        (r"\{P,Q\}=m_1+m_2", False),
        (r"\{Q,P\}=m_1m_2", False),
        (r"\{H,Q\}=P", False),
        (r"\{u_1,v_1\}=2/m_1", False),
        (r"\{u_1,v_1\}=m_1", False),
        (r"\{u_1,v_2\}=1/m_1", False),
        (r"\{v_2,u_2\}=1/m_2", False),
    ],
)
def test_a_factor_may_stand_before_the_bracket_of_each_pair(bracket, claim, green):
    text = r"""The equations are \[m_k\dot u_k=\frac{\partial H}{\partial v_k},\qquad
    m_k\dot v_k=-\frac{\partial H}{\partial u_k},\qquad k=1,2,\] with
    \[H=a(u_1-u_2)^2+a(v_1-v_2)^2.\] Let $Q=m_1u_1+m_2u_2$ and $P=m_1v_1+m_2v_2$. """
    text += rf"With the bracket $\{{f,g\}}={bracket}$ one calculates \[{claim} .\]"
    assert [one.green for one in verdicts(text).values()] == [green]


CANONICAL = OSCILLATOR + r"Here $\{u,a\}=\{v,b\}=K$. "


@pytest.mark.parametrize(
    ("value", "claim", "green"),
    [
        ("1", r"\{u,H\}=a", True),
        ("1", r"\{v,H\}=b", True),
        ("1", r"\{L,u\}=v", True),
        ("1", r"\{v,H\}=a", False),
        ("1", r"\{L,H\}=1", False),
        ("2", r"\{v,H\}=2b", True),
        ("2", r"\{v,H\}=b", False),
    ],
)
def test_a_chain_of_brackets_of_variables_gives_each_of_them(value, claim, green):
    text = CANONICAL.replace("K", value) + rf"Hence \[{claim} .\]"
    assert [one.green for one in verdicts(text).values()] == [green]


FREE = r"With $\{u,p_u\}=\{v,p_v\}=1$ let $X=p_u+su$ and $Y=p_v$. "


@pytest.mark.parametrize(
    ("claim", "green"),
    [(r"\{v,Y\}=1", True), (r"\{X,u\}=-1", True), (r"\{X,u\}=1", False), (r"\{X,Y\}=s", False)],
)
def test_a_chain_of_brackets_tells_of_what_they_are(claim, green):
    assert [one.green for one in verdicts(FREE + rf"Hence \[{claim} .\]").values()] == [green]


GROWTH = r"""Consider \[\dot u=uv,\qquad\dot v=v(w-u),\qquad\dot w=-vw .\]
With $u=a^2$, $v=b^2$, $w=c^2$ this becomes \[\dot a=\tfrac12ab^2 .\] Let $H=u+v+w$. """


@pytest.mark.parametrize(
    ("factor", "claim", "green"),
    [
        ("", r"\dot v=\{v,H\}", True),
        ("", r"\dot v=\{H,v\}", False),
        ("2", r"\dot v=\{v,H\}", False),
    ],
)
def test_a_bracket_behind_its_use_is_one_of_what_moves_in_new_variables_too(factor, claim, green):
    bracket = rf"\[\{{u,v\}}=uv,\qquad\{{v,w\}}={factor}vw,\qquad\{{w,u\}}=0 .\]"
    text = GROWTH + rf"The equations are Hamiltonian, ${claim}$, with respect to {bracket}"
    assert verdicts(text)[claim].green is green


@pytest.mark.parametrize(("claim", "green"), [(r"\{u,v\}=uv", True), (r"\{u,v\}=2uv", False)])
def test_a_bracket_of_what_is_given_by_others_with_brackets_is_claimed(claim, green):
    text = (
        GROWTH + r"A bracket is \[ \{a,b\}=\tfrac14ab,\quad\{b,c\}=\tfrac14bc,\quad\{c,a\}=0 . \] "
    )
    assert verdicts(text + rf"Then \[ {claim} . \]")[claim].green is green


@pytest.mark.parametrize(("sign", "true"), [(">", True), ("<", False), (r"\ge", True)])
def test_a_bracket_stands_in_an_inequality(sign, true):
    text = r"Let $H=\frac12(p_1^2+p_2^2)+\frac12(q_1^2+q_2^2)$. With $K=q_1p_1$ we have "
    assert [one.green for one in verdicts(rf"{text}$\{{q_1,p_1\}}{sign}0$.").values()] == [true]
    assert [one.green for one in verdicts(rf"{text}$\{{K,H\}}{sign}0$.").values()] == [False]
