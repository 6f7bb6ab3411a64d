"""What is false by construction is never green in a paper that is read by itself, nor true red."""

from random import Random

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from tests.laws.falsehoods import NAMES, Maker, _rate
from tests.laws.test_falsehoods import value
from tests.reading.test_reading import reading
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

JOINED = (
    r"$${}\qquad\mbox{{and}}\qquad {}$$",
    r"$${}\quad\text{{or}}\quad {}$$",
    r"${}$ and ${}$",
    r"${}$, and ${}$",
)


def outcomes_of(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    claims = [formula for formula in found.formulas if formula.claim is not None]
    return [(f.item.printed.tex.strip(" .,"), outcomes[f.claim.id]) for f in claims]


def law_of(motion):
    rows = (rf"\dot {name}={rate.tex}" for name, rate in zip(NAMES, motion, strict=True))
    return rf"The equations are $${', '.join(rows)}.$$ "


def false_set(make, motion):
    """Two equations, and a point of both at which something moves."""
    while True:
        point = make.point()
        if any(rate(point) for rate in motion):
            return point, [make.zero_at(point), make.zero_at(point)]


def false_plane(make, motion):
    """A function, and a zero of it at which it moves."""
    while True:
        point, one = make.point(), None
        one = make.zero_at(point)
        if _rate(one, motion)(point):
            return point, one


@pytest.mark.parametrize("seed", sampled(range(40), 3))
def test_what_is_claimed_of_a_set_is_no_hypothesis_of_another_claim(seed):
    """Sets of rest, an invariant set, and a rate on this: each false at a point of its own set."""
    make = Maker(seed)
    motion = make.motion()
    while not any(_rate(make.zero_at(make.point()), motion)(make.point()) for _ in range(20)):
        motion = make.motion()
    _, lines = false_set(make, motion)
    _, others = false_set(make, motion)
    at, plane = false_plane(make, motion)
    rate = _rate(plane, motion) + -_rate(plane, motion)(at) + make.not_zero_at(at)
    while _rate(plane, motion)(at) == rate(at):
        rate = rate + 1
    first, second = (", ".join(f"{one.tex}=0" for one in some) for some in (lines, others))
    joined = JOINED[seed % len(JOINED)].format(first, second)
    text = (
        law_of(motion)
        + rf"The points of the sets {joined} are equilibria. "
        + rf"The surface ${plane.tex}=0$ is invariant, and on it $\dot x+{plane.tex}=7x^3+{rate.tex}$."
    )
    wrong = motion[0](at) + plane(at) != 7 * at["x"] ** 3 + rate(at)
    for tex, outcome in outcomes_of(text):
        if r"\dot" in tex and not wrong:
            continue
        assert str(outcome.verdict) != "proved", (text, tex)
        if str(outcome.verdict) == "conditional":
            assert any(value(c.expression, at) == 0 for c in outcome.conditions), (text, tex)


@pytest.mark.parametrize("words", ["and on it", "and there"])
def test_on_it_is_the_set_that_was_spoken_of_last(words):
    text = r"The equations are $$\dot u=vw+u,\quad \dot v=uw+v,\quad \dot w=w.$$ The points of the "
    text += r"lines $$v=0,\ w=1\qquad\mbox{and}\qquad u=0,\ w=-1$$ are equilibria. "
    text += rf"The plane $u=v$ is invariant, {words} $\dot u=uw+u$."
    found = {tex: str(outcome.verdict) for tex, outcome in outcomes_of(text)}
    assert found["u=v"] == found[r"\dot u=uw+u"] == "proved"
    assert "proved" not in {found[tex] for tex in ("v=0", "u=0")}


@pytest.mark.parametrize("seed", sampled(range(20), 2))
def test_two_systems_in_the_same_letters_have_their_own_integrals(seed):
    """Rotations with other factors: the integral of the one is none of the other."""
    random = Random(seed)
    (a, b), (c, d) = random.sample([(1, 2), (2, 1), (3, 1), (1, 3), (3, 2)], 2)
    text = rf"\section{{One}} The equations are $\dot x={a}y$, $\dot y=-{b}xz$, $\dot z=0$. "
    text += rf"Then ${b}x^2z+{a}y^2$ is an integral. \section{{Two}} "
    text += random.choice(["We now consider another system", "Now consider the equations"])
    text += rf" with a constant $n$, $$\dot x={c}nyz,\qquad \dot y=-{d}nx,\qquad \dot z=0.$$ "
    text += rf"Then ${d}x^2+{c}y^2z$ is an integral, and so is ${b}x^2z+{a}y^2+x$."
    found = [str(outcome.verdict) for _, outcome in outcomes_of(text)]
    assert found[:2] == ["proved", "proved"] and "proved" not in found[2:]
