"""Bodies that attract each other: each pair cancels by itself, and no common denominator is made."""

from itertools import combinations

import pytest

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.codec import read_problem
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.verify.certificate import certificate
from kowalevski_cas.verify.statement import Posed, find_evidence

BODIES = (1, 2, 3)
STEPS = 500_000
"""Of the checker: a common denominator takes more than all that it has."""


def plus(trees):
    return ["+", *trees] if len(trees) > 1 else trees[0]


def minus(one, other):
    return ["+", one, ["-", other]]


def problem(axes, claim, order=3, mass="m_{}"):
    """That something stays, where accelerations are G m_j (x_j - x_i) / r^order."""
    pairs = [*combinations(BODIES, 2)]
    distance = {frozenset(pair): "r_{}{}".format(*pair) for pair in pairs}
    squares = [plus([["^", minus(f"{c}_{i}", f"{c}_{j}"), 2] for c in axes]) for i, j in pairs]
    places = [f"{c}_{i}" for c in axes for i in BODIES]

    def force(c, i):
        return plus(
            [
                ["/", ["*", "G", mass.format(j), f"m_{i}", minus(f"{c}_{j}", f"{c}_{i}")],
                 ["^", distance[frozenset((i, j))], order]]
                for j in BODIES if j != i
            ]
        )  # fmt: skip

    space = {
        "variables": [*places, *(f"v{place}" for place in places)],
        "constants": ["G", *(f"m_{i}" for i in BODIES)],
        "nonzero": [f"m_{i}" for i in BODIES],
        "steps": [["root", r, s] for r, s in zip(distance.values(), squares, strict=True)],
        "field": [
            *([[place], 1, f"v{place}"] for place in places),
            *([[f"v{c}_{i}"], f"m_{i}", force(c, i)] for c in axes for i in BODIES),
        ],
    }
    goal = {"goal": "follows", "space": 0, "given": [], "conclusions": [[[["D", claim], 0]]]}
    return {"spaces": [space], "goals": [goal]}


def energy(axes, sign=-1, power=1, factor=2):
    twice = [["*", f"m_{i}", ["^", f"v{c}_{i}", 2]] for c in axes for i in BODIES]
    pairs = combinations(BODIES, 2)
    over = [["/", ["*", "G", f"m_{i}", f"m_{j}"], ["^", f"r_{i}{j}", power]] for i, j in pairs]
    potential = plus(over)
    return plus([["/", plus(twice), factor], ["-", potential] if sign < 0 else potential])


def momentum(sign=-1):
    first, second = (
        [["*", f"m_{i}", f"{a}_{i}", f"v{b}_{i}"] for i in BODIES] for a, b in ("xy", "yx")
    )
    return minus(plus(first), plus(second)) if sign < 0 else plus(first + second)


def decided(data):
    """Whether a claim holds: the judge and the checker, within its steps, say so."""
    posed = Posed("bodies", read_problem(data))
    found, judge = find_evidence(posed.goals, {}), Judge(finder_of)
    assert found is not None
    if isinstance(found, Denial):
        judge.denies(posed.goals[found.goal], found.evidence)
    else:
        judge.holds(posed.goals[0], found[0])
    text = certificate(posed, found, judge.accepted)
    sign = checker.check(text, checker.Budget(STEPS)).sign
    assert sign == ("denied" if isinstance(found, Denial) else "holds")
    return sign == "holds"


@pytest.mark.parametrize("axes", ["x", "xy", "xyz"])
def test_the_energy_stays(axes):
    assert decided(problem(axes, energy(axes)))
    assert decided(problem(axes, energy(axes, power=2, factor=1), order=4))


@pytest.mark.parametrize("axes", ["xy", "xyz"])
def test_the_angular_momentum_stays_whatever_the_force_is(axes):
    assert decided(problem(axes, momentum()))
    assert decided(problem(axes, momentum(), order=5))


FALSE = {
    "sign": problem("xyz", energy("xyz", sign=1)),
    "power": problem("xyz", energy("xyz", power=2)),
    "factor": problem("xyz", energy("xyz", factor=1)),
    "force": problem("xyz", energy("xyz"), order=2),
    "mass": problem("xy", energy("xy"), mass="m_1"),
    "sign of the momentum": problem("xyz", momentum(sign=1)),
}


@pytest.mark.parametrize("name", FALSE)
def test_what_does_not_stay_is_refuted(name):
    assert not decided(FALSE[name])
