"""What is said of a claim that is false as it was read: where a misprint may stand."""

import pytest

from kowalevski_cas.audit.audited import OPEN
from kowalevski_cas.audit.doubted import free_letters, needs_words
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Verdict
from tests.reading.test_reading import reading
from tests.sample import sampled

LAW = r"""The equations of motion are
\begin{equation}\label{law}\dot x=y,\qquad \dot y=-x+z,\qquad \dot z=0.\end{equation}
"""


def audited(text):
    source = decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode())
    return audit_reading(ReadingSession(read(source), timeout=20))


def claim(found, label):
    return next(formula for formula in found.formulas if formula.label == label)


@pytest.mark.parametrize(
    ("wrong", "cause"), sampled([("x^2+y^2-2xz", ""), ("x^2+2y^2-2xz", "F=x^2+2y^2")], 1)
)
def test_the_formula_is_named_with_which_a_doubted_claim_would_hold(wrong, cause):
    text = (
        LAW
        + rf"""\begin{{theorem}} Put $F={wrong}$. If $a>0$, then
    \begin{{equation}}\label{{rate}}\dot F=0.\end{{equation}}\end{{theorem}}"""
    )
    found = claim(audited(text), "rate")
    if not cause:
        assert found.verdict == Verdict.PROVED and not found.causes
    else:
        assert found.verdict == Verdict.UNDECIDED
        assert found.message.startswith(FALSE_AS_READ) and "it holds with" in found.message
        assert [one.startswith("F") for one in found.causes] == [True]


def test_a_name_that_is_defined_by_itself_is_named_where_it_stands():
    text = LAW + r"""Put $F=Gx$, $G=Fy$. Then \begin{equation}\label{rate}\dot F=0.\end{equation}"""
    found = claim(audited(text), "rate")
    assert (
        not found.verdict.startswith("proved") and "is defined in terms of itself" in found.message
    )
    assert len(found.causes) == 2


@pytest.mark.slow
def test_a_letter_that_stands_nowhere_else_is_named_where_a_claim_fails_by_it():
    text = (
        LAW
        + r"""Put $F=\kappa x^2+y$. If $z=0$, then
    \begin{equation}\label{rate}\dot F=xy.\end{equation}"""
    )
    found = claim(audited(text), "rate")
    assert found.verdict == Verdict.UNDECIDED and r"$\kappa$ stands nowhere else" in found.message


def test_what_is_supposed_is_named_where_a_claim_fails_on_it():
    text = (
        LAW
        + r"""Let $\kappa>0$. For small $x$ and with $\kappa=2$ we have in the limit
    \begin{equation}\label{rate}\dot x\dot y=\kappa xyz^2+3x^5y^3.\end{equation}"""
    )
    found = claim(audited(text), "rate")
    assert found.verdict in (OPEN, Verdict.UNDECIDED)
    assert r"$\kappa=2$ is supposed" in found.message


@pytest.mark.parametrize(
    ("defining", "words"),
    [
        (r"$\alpha=x^2+y^2$", r"$\alpha$ is defined and stands nowhere after it"),
        (r"$F\kappa=x^2+y^2$", "no equation says how $F$ moves"),
    ],
)
def test_what_should_define_a_name_is_named_where_nothing_does(defining, words):
    found = audited(LAW + rf"The derivative of {defining} is $\dot F=2yz$.").formulas[-1]
    assert found.verdict == OPEN and words in found.message
    assert any("x-2-y-2" in name for name in found.causes)


@pytest.mark.parametrize(
    ("stated", "free"),
    [
        (r"x\cos\psi=y+z", r"$\psi$ was taken as free, since no equation defines it or ties it"),
        (r"x\sin\psi=\pi\rho", r"$\psi$ and $\rho$ were taken as free"),
        (r"x^2+y=\kappa\pi", ""),
        ("x^2+y=z", ""),
    ],
)
def test_letters_are_named_that_nothing_ties_to_the_motion(stated, free):
    """What the law has, or what is supposed, is tied, and π is a number."""
    law = LAW.replace("y,", r"\kappa y,") + r"Denote by $\psi$ an angle and by $\rho$ a length. "
    text = rf"{law}At some moment \begin{{equation}}\label{{here}}{stated}.\end{{equation}}"
    message = claim(audited(text), "here").message
    assert message.startswith(FALSE_AS_READ) and free in message
    assert bool(free) == ("taken as free" in message)


@pytest.mark.parametrize(("letter", "causes"), [(r"\alpha ", ["law.2"]), ("b", [])])
def test_a_letter_of_one_formula_is_named_if_a_claim_would_hold_with_another_value(letter, causes):
    text = r"""The equations of motion are
    \begin{equation}\label{law}\dot x=y,\qquad \dot y=-LETTERx+kl,\qquad \dot z=0.\end{equation}
    Put $b=kl$ and $F=y^2+bx^2-2bx$. If $c>0$, then
    \begin{equation}\label{rate}\dot F=0.\end{equation} Later, let $\alpha=2$."""
    found = claim(audited(text.replace("LETTER", letter)), "rate")
    assert found.verdict == (Verdict.UNDECIDED if causes else Verdict.PROVED)
    assert [*found.causes] == causes


@pytest.mark.parametrize("letter", ["F", "G"])
def test_the_last_definition_is_named_that_stood_nowhere_where_another_letter_is_derived(letter):
    text = rf"""The momentum is $c=yz$. Put ${letter}=x^2+y^2-2xz$. Then $F$ is constant: $\dot F=0$.
    The level ${letter}=c$ is a curve."""
    (found,) = (one for one in audited(LAW + text).formulas if one.id == "dot-F-0")
    named = r"$G$ is defined there, and stood nowhere since" in found.message
    assert (found.verdict == OPEN) == named == (letter == "G")


def test_an_equation_of_motion_is_named_where_a_name_moves_by_two():
    law = LAW.replace(r"\dot z=0", r"\dot y=0")
    found = claim(
        audited(law + r"Then \begin{equation}\label{rate}\dot x=y.\end{equation}"), "rate"
    )
    assert found.verdict == OPEN and "has another equation of motion too" in found.message
    assert {"law.2", "law.3"} <= {*found.causes}


def test_near_a_set_that_is_no_point_nothing_is_claimed_of_another_point():
    """Else what is true near the point before would be green, and is not what is said."""
    text = r"""The equations of motion are
    \[ \dot x=-x+yz,\qquad \dot y=xz-y,\qquad \dot z=-z+x^2. \] Let $F=xy$. In the first approximation
    we have near $x=y=z=0$ \[ \dot x=-x. \] Near $F=z=0$ in the same way
    \begin{equation}\label{rate} \dot y=-y. \end{equation}"""
    found = claim(audited(text), "rate")
    assert found.verdict == OPEN and any("F-z" in one for one in found.causes)


def test_a_letter_that_is_given_behind_and_stands_nowhere_else_may_be_meant():
    text = r"""The energy is \[ E=\frac{y^2}{2n}+\frac{n\kappa^2x^2}{2} . \] The curve is the ellipse
    \begin{equation}\label{ellipse}\frac{x^2}{a^2}+\frac{y^2}{b^2}=1\end{equation} with the semiaxes
    \[ %s=\sqrt{\frac{2E}{n\kappa^2}},\qquad b=\sqrt{2nE} . \]"""
    wrong = claim(audited(text % "s"), "ellipse")
    assert "$s$ is given there, and stands nowhere else" in wrong.message
    assert claim(audited(text % "a"), "ellipse").verdict in (Verdict.PROVED, Verdict.CONDITIONAL)


DISKS = r"""The equations are \[\dot x=yz+ky,\qquad\dot y=xzSIGNkx,\qquad\dot z=-xy.\]
There are two quadratic integrals, \[A=x^2+y^2+2z^2,\qquad B=x^2-y^2+4kz.\]
The function $A+B$ is an integral, too, and $A-B$ is an integral. The plane $x=y$ is invariant."""


@pytest.mark.parametrize("sign", ["+", "-"])
def test_what_is_true_of_a_law_that_two_doubted_claims_would_have_otherwise_is_not_green(sign):
    """With the sign that makes these integrals the plane is not invariant."""
    found = {f.tex: f.verdict for f in audited(DISKS.replace("SIGN", sign)).formulas if f.claims}
    assert found["x=y"] == Verdict.UNDECIDED
    integrals = {verdict for tex, verdict in found.items() if tex != "x=y"}
    assert ({*integrals} == {Verdict.PROVED}) == (sign == "-")


@pytest.mark.parametrize(("often", "needs"), [(r"$a\psi$, $b\psi$", True), ("", False)])
def test_a_letter_that_a_paper_has_often_is_no_slip(often, needs):
    text = rf"""Let \[ \dot x=y,\qquad\dot y=-x. \] Besides, {often}. We have \[ x\dot x+y\dot y=x\psi. \]"""
    found = reading(text)
    [claim] = [one for one in found.formulas if one.claim is not None]
    known = found.parts.of(claim.item)
    assert free_letters(claim, known) == [r"\psi"]
    assert needs_words(claim, known) == needs
