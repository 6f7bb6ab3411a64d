"""Where what is claimed holds: in a domain, on a set, near a state; and how far words reach."""

import pytest

from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import TOP, reading, roles, verdicts
from tests.sample import sampled

SPECIES = (
    r"""The model is \[ \dot x=x(y-1),\qquad \dot y=y(1-x) . \] We consider it for $x>0$, $y>0$; """
)


def role(text, tex):
    return next(f.role for f in reading(text).formulas if f.item.printed.tex.strip() == tex)


@pytest.mark.slow
def test_a_set_may_bound_the_domain():
    found = verdicts(SPECIES + r"the line $x=0$ is invariant.")
    assert found["x=0"] is Verdict.PROVED
    assert not verdicts(SPECIES + r"the line $x=1$ is invariant.")["x=1"].green


def test_what_a_footnote_neglects_is_neglected_there_only():
    note = r"\footnote{Kepler's law follows if terms of the second order are neglected.}"
    text = TOP + rf"A first thing:{note} \[ \ddot p=a(b\,rp\,r+q\,c\,pq) . \]"
    assert verdicts(text)[r"\ddot p=a(b\,rp\,r+q\,c\,pq)"].green


def test_what_is_approximate_may_hold_exactly():
    text = TOP + r"In the first approximation \[ \dot p=a\,qr,\qquad \dot q=2b\,rp . \]"
    found = verdicts(text)
    assert found[r"\dot p=a\,qr"].green
    assert r"\dot q=2b\,rp" not in found


def test_another_model_may_be_approximate():
    text = (
        TOP
        + r"""\section{A pendulum} Small oscillations are governed by
    \[ \ddot x=-kx . \] Its energy $\dot x^2+kx^2$ is constant."""
    )
    assert verdicts(text)[r"\dot x^2+kx^2"] is Verdict.PROVED


def test_nothing_is_defined_by_what_rests_on_it():
    text = r"""A pendulum obeys $\ddot x=-w^2\sin x$, where $w=\sqrt{g/l}$, so that
    \[ \tfrac12\dot x^2-w^2\cos x=h . \] At the top $h=w^2$, and \[ \dot x^2=2h+2w^2\cos x . \]"""
    assert verdicts(text)[r"\dot x^2=2h+2w^2\cos x"].green


def test_a_set_that_is_claimed_twice_is_claimed():
    text = (
        TOP
        + r"The axis $p=0,\ q=0$ is invariant. \section{Again} The axis $p=0,\ q=0$ is invariant."
    )
    assert [f.role.kind for f in reading(text).formulas].count("invariant") == 4


def test_a_theorem_claims_its_integral_though_the_proof_claims_its_rate():
    theorem = r"""\begin{theorem} There is the integral \[ F=bp^2-aq^2 . \] \end{theorem}
    \begin{proof} Indeed $\dot F=0$. \end{proof}"""
    assert role(TOP + theorem, "F=bp^2-aq^2").kind == "integral"


def test_a_square_that_does_not_change_is_an_integral():
    text = TOP + r"This means that \[ k^2=bp^2-aq^2 \] does not change."
    assert role(text, "k^2=bp^2-aq^2").kind == "integral"


def test_what_there_is_also_is_what_was_spoken_of():
    text = TOP + r"The function $bp^2-aq^2$ is an integral, and there is also \[ F=cp^2-ar^2 . \]"
    assert role(text, "F=cp^2-ar^2").kind == "integral"


def test_what_is_put_together_is_not_supposed():
    text = TOP + r"For reference we put together: \[ (p+q)^2=p^2+2pq+q^2 . \]"
    assert roles(text)["(p+q)^2=p^2+2pq+q^2"] == "claim"


@pytest.mark.slow
def test_a_solution_of_several_equations_solves_that_of_its_highest_rate():
    law = r"The equations are \[ \ddot x=2\dot y,\qquad \ddot y=-2\dot x . \] "
    found = verdicts(law + r"A solution is \[ x=\sin 2t,\qquad y=\cos 2t . \]")
    assert [one.green for one in found.values()] == [True, True]
    found = verdicts(law + r"A solution is \[ x=\sin 2t,\qquad y=\sin 2t . \]")
    assert not any(one.green for one in found.values())


def test_the_imaginary_unit_needs_no_words():
    text = r"""The equations are \[ \dot x=y,\qquad \dot y=-x . \] Put $w=x+iy$. Then
    \[ \dot w=-iw,\qquad \dot w=iw . \]"""
    found = verdicts(text)
    assert found[r"\dot w=-iw"].green and not found[r"\dot w=iw"].green


@pytest.mark.slow
def test_what_is_said_with_the_constants_of_a_solution_holds_along_it():
    law = r"The equations are \[ \dot x=y,\qquad \dot y=-x . \] Let $E=x^2+y^2$. "
    found = reading(law + r"It is solved by \[ x=c\sin t,\qquad y=c\cos t . \] Then $E=c^2$.")
    assert found.formulas[-1].claim is not None
    assert [one.printed.tex for one in found.formulas[-1].on] == [r"x=c\sin t", r"y=c\cos t"]
    claims = r"\[ x=c\sin t,\qquad y=c\cos t . \] Then $E=c^2$ and $2E=c^2$, and $E+c=y^2+c$."
    found = verdicts(law + "It is solved by " + claims)
    assert found["E=c^2"].green and not found["2E=c^2"].green and not found["E+c=y^2+c"].green


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            "We come to the equilibria. They are the solutions of",
            "An equilibrium is a point at which",
            "The states of rest are the points where",
        ],
        1,
    ),
)
def test_equations_that_states_of_rest_satisfy_are_claimed_of_them(words):
    law = r"The equations are \[ \ddot x=-x-xy,\qquad \ddot y=-y-x^2 . \] "
    found = reading(law + words + r" \[ x(1+y)=0,\qquad y+x^2=0 . \]").formulas
    assert [f.role.kind for f in found[-2:]] == ["rest", "rest"]
    text = law + words
    assert verdicts(text + r" \[ x(1+y)=0,\qquad y+x^2=0 . \]")["x(1+y)=0"].green
    assert not verdicts(text + r" \[ x(1+y)=0,\qquad y+2=0 . \]")["x(1+y)=0"].green


def test_states_of_rest_are_counted_for_the_constants_of_their_sentence():
    law = r"The equation is \[ \dot x=x^2-a . \] "
    found = reading(law + "For $a=1$ there are exactly two equilibria.").statements
    assert [[one.printed.tex for one in found.on] for found in found] == [["a=1"]]


@pytest.mark.slow
def test_what_stands_below_a_set_that_cannot_be_read_is_not_refuted():
    unread = r"Below we consider the level \[ {\cal M}=\{p,q,r:\ p=0\} . \] "
    claim = r"Put $F=p^3q+3pr^2-q^5$. Then $\dot F=0$."  # near which nothing is true
    assert verdicts(TOP + claim)[r"\dot F=0"] is Verdict.REFUTED
    assert verdicts(TOP + unread + claim)[r"\dot F=0"] is Verdict.UNDECIDED


def test_a_name_that_is_defined_by_what_is_supposed_is_defined_once():
    text = TOP + r"Let $c>0$. Put \[ F=(p^2+cr)^2 . \] With $w=p^2+cr$ we have $F=2w^2$."
    assert role(text, "F=2w^2").kind == "identity"


@pytest.mark.slow
def test_vectors_e_with_a_number_are_those_of_the_basis():
    text = r"""The equations of motion are \[ \dot{\boldsymbol x}=\boldsymbol x\times\boldsymbol e_3 \]
    for $\boldsymbol x=(x_1,x_2,x_3)$. Then \[ \dot x_1=x_2,\qquad \dot x_1=x_3 . \]"""
    found = verdicts(text)
    assert found[r"\dot x_1=x_2"] is Verdict.PROVED
    assert found[r"\dot x_1=x_3"] is not Verdict.PROVED


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            "A point moves without friction on the inner side of the paraboloid",
            "A bead slides on a smooth surface",
            "Точка движется без трения по внутренней стороне параболоида",
        ],
        1,
    ),
)
def test_what_a_point_moves_on_is_a_constraint(words):
    law = r"\[ \ddot x=\lambda x,\qquad \ddot y=\lambda y,\qquad \ddot z=-g-\lambda p . \]"
    text = (
        rf"{words} \[ x^2+y^2=2pz . \] The equations are {law} Then $x\dot y-y\dot x$ is constant."
    )
    assert role(text, "x^2+y^2=2pz").kind == "constraint"


@pytest.mark.parametrize(
    "heading", [r"\emph{Second case.}", r"\emph{Second case}---", r"\noindent\emph{Second case:}"]
)
def test_what_is_emphasised_at_the_head_of_a_paragraph_is_a_heading(heading):
    text = r"\begin{document} Let $a=1$." + "\n\n" + heading + r" Now $b=2$. \end{document}"
    source = decode("paper.tex", text.encode())
    assert read(source).formulas[-1].item.section.title.startswith("Second case")


@pytest.mark.parametrize(
    "words", [r"\emph{Hence} we have", r"\emph{Proof.} Now", r"and \emph{now.}"]
)
def test_other_words_that_are_emphasised_are_none(words):
    gap = "" if words.startswith("and") else "\n\n"
    text = r"\begin{document} Let $a=1$." + gap + words + r" $b=2$. \end{document}"
    source = decode("paper.tex", text.encode())
    assert not read(source).formulas[-1].item.section.title


@pytest.mark.parametrize(
    "rate, found",
    [(r"-c\dot x^2", "undecided"), (r"c\dot x^2", "undecided"), (r"-2\dot x^4", "refuted")],
)
def test_what_is_below_zero_for_some_constants_only_is_not_red(rate, found):
    text = r"The equation of motion is \[ m\ddot x+c\dot x+kx=0 .\] Put $E=\frac12m\dot x^2+\frac12kx^2$. "
    verdict = verdicts(text + rf"Hence \[ \dot E={rate}\le0 .\]")[rf"\dot E={rate}\le0"]
    assert verdict.value in (found, "undecided") and not verdict.green


TRIPLE = r"""The motion is $$\dot x=xy-xz,\quad \dot y=yz-yx,\quad \dot z=zx-zy.$$
{} {} \[ \dot x=xy,\quad \dot y={}. \] {}"""
BECOMES = [
    (on, becomes, rate, more, green)
    for on, becomes in (
        ("On the invariant plane $z=0$", "the system becomes"),
        ("On the plane $z=0$", "the equations of motion reduce to"),
        ("On the invariant plane $z=0$", "our equations take the form"),
        ("На инвариантной плоскости $z=0$", "система принимает вид"),
    )
    for rate, more, green in (
        ("-yx", "", True),
        ("yx", "", False),
        ("-yx", "They have the integral $x+y$.", True),
        ("-yx", "They have the integral $x-y$.", False),
    )
]


@pytest.mark.parametrize(("on", "becomes", "rate", "more", "green"), sampled(BECOMES, 5))
def test_where_the_equations_become_others_more_is_said_of_these(on, becomes, rate, more, green):
    found = verdicts(TRIPLE.format(on, becomes, rate, more))
    assert all(one.green for one in found.values()) == green and len(found) == 2 + bool(more)


def test_where_the_equations_are_no_others_it_is_for_the_sentence():
    text = r"On the plane $z=0$ we have $\dot z=0$. In general $x+y$ is an integral."
    found = verdicts(TRIPLE.partition("{}")[0] + text)
    assert not found["x+y"].green
