"""A letter of a claim that nothing behind it has is cancelled by no other formula, but as a factor."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.own_letters import own_letters
from tests.audit.test_doubted import audited

SPRING = r"\dot q=s,\ \dot s=-\kappa q,\ \varrho=q^2"


def own(claim, motion=SPRING):
    """The own letters of a claim about a motion, with three letters that this has not."""
    section = Section("1", "Springs")
    scene = System(motion).scene.having(constants=(r"\mu", r"\nu", r"\beta"))
    section.identity("claimed", claim, on=scene, says="what is claimed")
    derivation = Derivation("springs", "", "", "", (section,))
    return own_letters(Interpretation(derivation).statement(derivation.claims[0]))


@pytest.mark.parametrize(
    ("claim", "letters"),
    [
        (r"\ddot q=-\mu q", {r"\mu"}),
        (r"\varrho\cos\beta=s", {r"\beta"}),
        (r"s=\mu q+\nu", {r"\mu", r"\nu"}),
        # the law has it, or it is a factor: then the law may be to blame
        (r"\ddot q=-\kappa q+\varrho", set()),
        (r"\mu\ddot q=-\mu s", set()),
        (r"\mu\dot q+\nu\dot s=\mu q-\nu s", set()),
        (r"\mu\cos(\beta)\dot q=\mu\cos(\beta)q", {r"\mu", r"\beta"}),
        (r"\dot q=q+s", set()),
    ],
)
def test_letters_that_no_other_formula_cancels(claim, letters):
    assert own(claim) == letters


BESIDE = r"""
The equations of motion are
\[ \dot x = y , \qquad \dot y = -x . \]
Let
\[ F = x^2 %s y^2 . \]
Then
\[ \dot x + aF + bF^2 = y + a(x^2 + y^2) + %s(x^2 + y^2)^2 . \]
"""


def test_what_stands_beside_own_letters_may_be_to_blame():
    *_, definition, claim = audited(BESIDE % ("-", "b")).formulas
    assert (definition.verdict, claim.verdict) == ("suspect", "refuted")
    *_, definition, claim = audited(BESIDE % ("+", "b")).formulas
    assert (definition.verdict, claim.verdict) == ("given", "proved")


def test_no_definition_is_to_blame_for_a_letter_that_it_does_not_cancel():
    *_, definition, claim = audited(BESIDE % ("+", "2b")).formulas
    assert definition.verdict == "given" and claim.verdict in ("refuted", "undecided")
