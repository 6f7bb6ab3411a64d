"""What is true by itself corrects nothing."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.notation import Vocabulary, read
from kowalevski_cas.verify.vacuous import is_trivial
from tests.reading.test_reading import reading

WORDS = Vocabulary(scalars=frozenset("a b c u v".split()))


@pytest.mark.parametrize(
    ("tex", "trivial"),
    [
        ("u=u", True),
        ("u=-u", True),
        ("u+v-u=c", True),
        (r"v=\frac{ua}{a}", True),
        (r"v=u\sqrt{\frac{b}{b}}", True),
        (r"v=-\frac{a(u+c)}{b(u+c)}", True),
        (r"v=\frac{2u}{2a}", False),
        (r"v=\frac{au}{b}+\frac{bu}{a}", False),
        (r"v=\frac{u+a}{a}", False),
        (r"v=\frac{u^2}{u+1}", False),
    ],
)
def test_sides_and_terms_are_not_the_same_and_nothing_cancels(tex, trivial):
    assert is_trivial(read(tex, WORDS)) is trivial


@pytest.mark.parametrize(
    "text",
    [
        r"The equations are \[\dot u=av+bw,\quad\dot v=-au,\quad\dot w=cu.\] Let $b=0$. Then \[u^2+2v^2=\mathrm{const}.\]",
        r"With $\mathbf e=(0,0,1)$ we have \[\dot{\mathbf u}=\mathbf e\times\mathbf u.\] Hence \[\dot u_1+2u_2=0.\]",
    ],
)
def test_a_factor_that_is_zero_repairs_nothing(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    (outcome,) = (outcomes[one.claim.id] for one in found.formulas if one.claim is not None)
    repairs = [one for one in (outcome.correction, *outcome.alternatives) if one is not None]
    assert repairs
    names = {name for one in repairs for formula in one.formulas for name in formula.names()}
    assert not names & {"b", "e_1", "e_2"}
