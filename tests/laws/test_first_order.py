"""What holds to the first order near a state of rest is the linear part, and nothing else."""

from itertools import product
from random import Random

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.laws.test_readings import outcomes_of
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

WORDS = (
    r"To the first order near the state of rest $x=y=0$ we have",
    r"The state $x=y=0$ is at rest. For small deviations from it",
    r"Near the state of rest $x=0$, $y=0$ we find in the first approximation",
)


def linear(x, y):
    return rf"{x}x{y:+}y"


def of_higher_order(random):
    found = []
    for i, j in product(range(4), repeat=2):
        if 2 <= i + j <= 3 and (factor := random.randint(-2, 2)):
            found.append(rf"{factor:+}x^{i}y^{j}")
    return "".join(found) or "+x^2"


@pytest.mark.parametrize("seed", sampled(range(30), 3))
def test_the_linear_part_is_proved_and_another_one_is_not(seed):
    """Rates and second rates of a field with known linear part; each factor changed by one."""
    random = Random(seed)
    a, b, c, d = (random.choice([-3, -2, -1, 1, 2, 3]) for _ in range(4))
    law = (
        rf"The equations of motion are $$\dot x={linear(a, b)}{of_higher_order(random)},\quad "
        rf"\dot y={linear(c, d)}{of_higher_order(random)}.$$ "
    )
    second = a * a + b * c, a * b + b * d
    words = WORDS[seed % len(WORDS)]
    for wrong in (0, 1):
        first = rf"\dot x={linear(a, b + wrong)}"
        again = rf"\ddot x={linear(second[0] + wrong, second[1])}"
        found = dict(outcomes_of(rf"{law} \par {words} $${first},\qquad {again}.$$"))
        judged = {tex: one.verdict for tex, one in found.items() if r"\d" in tex}
        assert Verdict.REFUTED not in judged.values()  # another point may be meant
        greens = {tex for tex, verdict in judged.items() if verdict.green}
        assert greens == (set() if wrong else {first, again}), (law, words)


def test_the_first_order_is_not_the_second():
    text = r"""The equations are $$\dot x=y+x^2,\qquad \dot y=-x.$$ Near the state of rest $x=y=0$,
    neglecting terms of the third order, we have $$\dot x=y.$$"""
    assert not dict(outcomes_of(text))[r"\dot x=y"].verdict.green
