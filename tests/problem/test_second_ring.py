"""The ring of the checker and FLINT's polynomials: two rings agree on whatever is checked."""

import json
import random
from pathlib import Path
from unittest.mock import patch

import pytest

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker import Budget
from kowalevski_cas.problem.checker.polynomials import Element, Ring
from tests.problem.second_ring import compared
from tests.problem.tampering import seal, twisted

HANDWRITTEN = sorted((Path(__file__).parent / "handwritten").glob("*.json"))
FORGED = 4


def said(text):
    """What the checker says of a certificate."""
    try:
        return checker.check(text).sign
    except checker.Rejected as error:
        return str(error)


@pytest.mark.parametrize("path", HANDWRITTEN, ids=lambda path: path.stem)
def test_of_what_is_certified_and_of_what_is_forged_both_say_the_same(path):
    data = json.loads(path.read_text(encoding="utf-8"))
    choose = random.Random(path.stem)
    forged = (seal(twisted(data, choose)) for _ in range(FORGED))
    for text in (path.read_text(encoding="utf-8"), *forged):
        alone = said(text)
        with compared() as done:
            assert said(text) == alone
        assert done.asked or alone not in ("holds", "denied")


def ring():
    """Polynomials in x and r, where r² = 3 x, and the inverse of (x + 1)³."""
    found = Ring(Budget(10**9))
    x, _, _ = (found.adjoin(name) for name in "xvr")
    found.invert("v", (x + found.number(1)) ** 3)
    found.relate("r", x * found.number(3))
    return found


def without_squares(self):
    """An element of which what has a square of a root in it is forgotten."""
    return self.with_terms({m: c for m, c in self.terms.items() if not m & self.ring.squares})


WRONG = {
    "reduced": (Element, without_squares),
    "partial": (Element, lambda self, name: self),
    "combination": (Ring, lambda self, parts, below=1: parts[0][1]),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_ring_that_is_wrong_is_noticed(name):
    here = ring()
    x, v, r = map(here.generator, "xvr")
    owner, wrong = WRONG[name]
    with patch.object(owner, name, wrong), compared(), pytest.raises(AssertionError, match="other"):
        ((r + x) * (r + v)).partial("x")


def test_a_ring_that_is_right_agrees():
    here = ring()
    x, v, r = map(here.generator, "xvr")
    with compared() as done:
        element = (r + x) * (r + v) * (r - x)
        assert not (element.partial("x") - element.partial("x")).terms
        assert (v * (x + here.number(1)) ** 3 - here.number(1)).vanishes()
    assert done.asked == done.done > 5
