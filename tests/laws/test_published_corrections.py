"""Misprints in public lecture notes are noticed, and what their authors read instead is proposed."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.notation.errors import NotationError, Undeclared
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.verify.run import Session
from tests.laws.published import SEEN, UNSEEN
from tests.sample import sampled

OWN = (
    r"W=\frac{q_1q_1}{4\pi\varepsilon R}",
    r"V=\frac{q_3}{4\pi\varepsilon}(\frac{q_1}S-\frac{q_2}U)",
)
"""Definitions by which one claim fails, which is corrected itself then."""

BEYOND = {
    r"\frac{\dot x^2+\dot y^2}2-\frac{mu}r": "two letters were printed for a command",
    r"\frac{\dot x^2+\dot y^2}2+(C-\frac{mu}r)": "two letters were printed for a command",
    r"\gamma^2(x^2+y^2+z^2)=(\gamma^2-1)x^2+s": "a pair of brackets is too much",
    r"u=\frac{qEs}{\sqrt{m^2q^2E^2s^2/c^2}}": "a sign between terms is missing",
    r"\dot{\mathbf L}=m+\mathbf r\times\ddot{\mathbf r}": "it cannot be read",
}
"""What no edit of one token mends."""


def declaring(system, formulas):
    """A system where names are constants that nothing defines."""
    for tex in formulas:
        while True:
            try:
                system.read(tex)
                break
            except Undeclared as error:
                system = system.having(error.name)
            except NotationError:
                break
    return system


def stated(entry, formula):
    """The system of an entry, with one formula as it was printed, or as it was mended."""
    own = () if entry.printed in entry.display else (formula,)
    system = System(entry.display.replace(entry.printed, formula))
    system = declaring(system, (*entry.claims, *own))
    for claim in (*entry.claims, *own):
        (system.identity if "=" in claim else system.integral)(claim)
    return system


def outcomes(system):
    return Session(Derivation("own", "", "", "", (system.section,)), ["flint"]).run().outcomes


@pytest.mark.parametrize("place", sampled(range(len(SEEN + UNSEEN)), 1, seed=2))
def test_what_an_author_has_mended(place):
    entry = (SEEN + UNSEEN)[place]
    right, wrong = stated(entry, entry.mended), stated(entry, entry.printed)
    assert all(o.verdict.green for o in outcomes(right))
    bad = [o for o in outcomes(wrong) if not o.verdict.green]
    assert bad  # it is noticed
    proposed = [one for o in bad for one in (o.correction, *o.alternatives) if one]
    meant = right.read(entry.mended)
    found = any(meant in one.formulas for one in proposed)
    assert found != (entry.printed in (*BEYOND, *OWN))
