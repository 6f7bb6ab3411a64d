"""Integrals of which the value stands among other terms, as h in T = U + h."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.notation import to_latex
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

PLANE = r"""A particle moves by the equations \[\ddot u=-ku,\qquad \ddot v=-kv .\]
The integrals of energy and of areas are \[ENERGY,\qquad u\dot v=c+v\dot u .\] Hence """
RIGHT = r"\tfrac12(\dot u^2+\dot v^2)=h-\tfrac12k(u^2+v^2)"


@pytest.mark.parametrize(
    ("energy", "green"),
    [
        (RIGHT, True),
        (RIGHT.replace("h-", "h+"), False),
        (r"\dot u^2+\dot v^2-2h=-k(u^2+v^2)", True),
        (r"\dot u^2+\dot v^2-2h=-k(u^2-v^2)", False),
        (r"k(u^2+v^2)=2h-\dot u^2-\dot v^2", True),
    ],
)
def test_the_value_of_an_integral_may_stand_among_other_terms(energy, green):
    found = verdicts(PLANE.replace("ENERGY", energy))
    assert [one.green for one in found.values()] == [green, True]


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"(\dot u^2+\dot v^2)(u^2+v^2)=c^2+(u\dot u+v\dot v)^2", True),
        (r"(\dot u^2+\dot v^2)(u^2+v^2)=c^2-(u\dot u+v\dot v)^2", False),
        (r"\dot u^2+\dot v^2=2h-ku^2-kv^2", True),
        (r"\dot u^2+\dot v^2=2h-ku^2+kv^2", False),
    ],
)
def test_the_value_is_known_from_there_on(claim, green):
    text = PLANE.replace("ENERGY", RIGHT) + rf"\[{claim} .\]"
    assert [*verdicts(text).values()][-1].green is green


def test_without_words_nothing_is_an_integral():
    text = PLANE.replace("The integrals of energy and of areas are", "Let us write")
    assert not any(one.green for one in verdicts(text.replace("ENERGY", RIGHT)).values())


def test_a_name_that_is_defined_elsewhere_is_no_value():
    text = PLANE.replace("ENERGY", RIGHT) + r"Here \[h=\tfrac12(\dot u^2+\dot v^2) .\]"
    assert not any(one.green for tex, one in verdicts(text).items() if tex == RIGHT)


def test_what_is_found_by_an_integral_is_none():
    text = PLANE.partition("The integrals")[0]
    text += r"By the energy integral we find \[\dot u^2=\dot v^2+w ,\] $w$ being small."
    assert not any(one.value == "refuted" for one in verdicts(text).values())


def test_an_audit_says_of_the_printed_formula_what_is_claimed_of_the_value():
    energy = RIGHT.replace("h-", "h+")
    session = ReadingSession(reading(PLANE.replace("ENERGY", energy)), timeout=20)
    found = {one.tex: one.verdict for one in audit_reading(session).formulas}
    assert found[energy] in ("refuted", "undecided")
    assert found[r"u\dot v=c+v\dot u"] == "proved"


RESTRICTED = r"""Let \[ \ddot x-2\dot y=\frac{\partial W}{\partial x},\qquad
\ddot y+2\dot x=\frac{\partial W}{\partial y},\] where $W=\frac12x^2+\frac{k}{s}$, $s^2=x^2+y^2$. """


@pytest.mark.slow
@pytest.mark.parametrize(
    "words", ["The Jacobi integral has the form", "The Jacobian integral reads"]
)
@pytest.mark.parametrize("right", ["2W-C", "2W+x-C"])
def test_a_level_stands_among_functions(words, right):
    claim = rf"\dot x^2+\dot y^2={right}"
    verdict = verdicts(RESTRICTED + words + rf" \[ {claim}. \]")[claim]
    assert verdict.green is (right == "2W-C")


def test_a_value_in_what_gives_something_else_behind_it_is_named():
    text = r"""The equations of motion are \[ A\dot p=(A-C)qr-kq,\qquad A\dot q=(C-A)rp+kp,\qquad C\dot r=0 . \]
    Then $\dot r=0$, that is $r=r_0$, and the first two equations take the form
    \[ \dot p=-nq,\qquad \dot q=np,\qquad n=\frac{(C-A)r_0+k}{A} . \]"""
    assert all(verdicts(text)[row].green for row in (r"\dot p=-nq", r"\dot q=np"))


FIELD = r"""The equations \[\dot u=v,\qquad \dot v=uw,\qquad \dot w=-uv\] have the integrals
$F=\tfrac12(v^2+w^2)$ and $G=\tfrac12u^2+w$. """
SPEED = r"\[\dot u^2=2f-\bigl(g-\tfrac12u^2\bigr)^2 .\]"


@pytest.mark.parametrize(
    "words",
    [
        r"On the level $G=g$ we have $\ddot u=gu-\frac12u^3$. If $F=f$ then",
        r"With $G=g$ one has $\ddot u=gu-\frac12u^3$. If moreover $F=f$ then",
        r"On the level $G=g$ we get \[\ddot u=gu-\frac12u^3,\] that is an oscillator, and if $F=f$ then",
        r"On the level $F=f$, $G=g$ the motion is simple. The velocity follows from",
    ],
)
def test_the_name_that_a_level_gives_to_a_value_is_known_behind_its_sentence(words):
    assert all(one.green for one in verdicts(FIELD + words + SPEED).values())
    wrong = SPEED.replace(r"\bigr)^2", r"\bigr)")
    assert not [*verdicts(FIELD + words + wrong).values()][-1].green


def test_a_letter_that_was_used_before_is_no_name_of_a_value():
    text = FIELD.replace("=uw", "=guw") + r"On the level $G=g$ the motion is simple. We have "
    claim = r"$\ddot u=g^2uw$."
    assert not [*verdicts(text + claim).values()][-1].green


PAIR = r"""Two vectors turn: \[\dot{\mathbf S}=k\mathbf T\times\mathbf S,\qquad \dot{\mathbf T}=k\mathbf S\times\mathbf T .\] """


@pytest.mark.parametrize(
    ("second", "green"),
    [
        (r"|\mathbf T|=\tau", True),
        (r"|\mathbf T-\mathbf S|=\tau", True),
        (r"|\mathbf T|S_1=\tau", False),
    ],
)
@pytest.mark.parametrize("between", [" and ", ", "])
def test_what_is_preserved_is_listed_and_any_letter_names_its_value(second, green, between):
    words = rf"The lengths are preserved, $|\mathbf S|=s${between}${second}$."
    assert [one.green for one in verdicts(PAIR + words).values()] == [True, green]


@pytest.mark.parametrize("right", [r"\tau^2", r"2\tau"])
def test_a_letter_of_a_time_is_a_constant_where_nothing_depends_on_it(right):
    words = rf"Let $|\mathbf T|=\tau$. Then \[(\mathbf T+\mathbf S)^2=s^2+{right}+2\,\mathbf S\cdot\mathbf T\] with $|\mathbf S|=s$."
    assert [*verdicts(PAIR + words).values()][-1].green is (right == r"\tau^2")


DUFFING = r"Consider the equation \[\ddot x=-kx-\beta x^3 .\] "
WAVE = r"The profile satisfies \[f'''+6ff'-cf'=0 .\] Integrating once, \[f''=cf-3f^2+a\] with a constant $a$. "


@pytest.mark.parametrize("constant", [r"2h", r"C", r"-\kappa", r"\tfrac12c_1"])
@pytest.mark.parametrize("behind", ["", ", where {} is a constant of integration"])
def test_a_constant_of_integration_is_the_value_of_an_integral(constant, behind):
    letter = constant.removeprefix("2").removeprefix("-").removeprefix(r"\tfrac12")
    words = DUFFING + "Multiplying by the velocity and integrating we get "
    end = behind.replace("{}", f"${letter}$")
    text = rf"{words}\[\dot x^2={constant}-kx^2-Bx^4\]{end}."
    true, false = text.replace("B", r"\tfrac12\beta "), text.replace("B", r"\beta ")
    assert [one.green for one in verdicts(true).values()] == [True]
    assert not any(one.green for one in verdicts(false).values())


@pytest.mark.parametrize("case", ["Let $a=b=0$. Then", "Let $a=0$ and $b=0$. Then", "For $a=b=0$"])
def test_a_second_integration_rests_on_the_constant_of_the_first(case):
    second = r"Multiplying and integrating again, \[(f')^2=-2f^3+cf^2+2af+2b .\] "
    text = WAVE + second + rf"{case} \[(f')^2=f^2(c-Af) .\]"
    assert [one.green for one in verdicts(text.replace("A", "2")).values()] == [True] * 3
    assert [one.green for one in verdicts(text.replace("A", "3")).values()] == [True, True, False]
    wrong = text.replace("2af", "af")
    assert [one.green for one in verdicts(wrong).values()][1] is False


@pytest.mark.parametrize(
    "words",
    [
        r"The energy is $h=\tfrac12\dot x^2+\tfrac12kx^2+\tfrac14\beta x^4$. Then",
        r"The energy is $E=\tfrac12\dot x^2+\tfrac12kx^2+\tfrac14\beta x^4$. Its value is $h=E$. Then",
        r"Suppose that",
    ],
)
def test_a_letter_of_which_more_is_known_is_no_new_constant(words):
    text = DUFFING + rf"{words} \[\dot x^2=3h-kx^2-\tfrac12\beta x^4 .\]"
    assert not [*verdicts(text).values()][-1:] or not [*verdicts(text).values()][-1].green


@pytest.mark.parametrize("wrong", [r"\dot x^2+x", r"\dot x^2-x^2", r"\dot x^2+x^3"])
@pytest.mark.parametrize("print", ["{}=2h", "{}=h", "h={}", "F={}=h"])
def test_a_slip_beside_the_name_of_the_value_is_mended_on_either_side(wrong, print):
    found = reading(rf"Consider \[\ddot x=-x.\] It has the integral \[{print.format(wrong)}.\]")
    (outcome,) = ReadingSession(found, timeout=20).outcomes.values()
    assert outcome.verdict is Verdict.REFUTED
    assert r"\dot{x}^2 + x^2" in to_latex(outcome.correction.formulas[0])


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_a_value_is_taken_where_the_law_is_defined(sign, green):
    """Where the mass vanishes any energy has this value, and there is no motion."""
    law = r"A point moves by \[m\ddot x=0,\qquad m\ddot y=-mg.\] "
    energy = rf"\frac m2(\dot x^2+\dot y^2){sign}mgy=\frac m2v_0^2-mgl"
    found = verdicts(law + rf"The energy \[{energy}\] is conserved.")
    assert found[energy].green is green
