"""Nothing is called complete that lacks an integral, at whatever constants and whatever is listed.

A field is the product of the gradients of two polynomials F and G in three variables, which are its
integrals then: there are as many as the powers of both, at least, up to a degree. Whoever forges a
certificate may choose the constants of its point, also such that coefficients vanish there or
modulo the prime.
"""

import random

import pytest

from kowalevski_cas.algebra.elimination import PRIME
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.trees import FormatError
from tests.problem.judges import judged
from tests.problem.tampering import seal
from tests.sample import sampled

XYZ = ("x", "y", "z")
MOST = 6
"""The largest degree."""


def polynomial(chosen, degree):
    """A few monomials of a degree, with coefficients in which constants stand."""
    terms = []
    for _ in range(chosen.randint(2, 3)):
        factors = [chosen.choice(XYZ) for _ in range(degree)]
        terms.append((chosen.choice([1, 2, -3, "a", "b", ["+", "a", -1]]), factors))
    return terms


def tree(terms):
    return ["+", 0, 0, *(["*", 1, coefficient, *factors] for coefficient, factors in terms)]


def partial(terms, name):
    found = []
    for coefficient, factors in terms:
        if count := factors.count(name):
            left = [*factors]
            left.remove(name)
            found.append((["*", count, coefficient], left))
    return tree(found)


def product(F, G):
    """The components of the vector product of two gradients."""
    pairs = [("y", "z"), ("z", "x"), ("x", "y")]
    return [
        ["+", ["*", partial(F, m), partial(G, n)], ["*", -1, partial(F, n), partial(G, m)]]
        for m, n in pairs
    ]


def value(chosen):
    """Of a constant: small, or zero modulo the prime, or a fraction."""
    number = chosen.choice([0, 1, 1, 2, 5, -7, PRIME, PRIME + 1, 3 * PRIME - 2])
    return ["/", number, chosen.choice([2, 3, PRIME])] if chosen.random() < 0.2 else number


def certificate(chosen, F, G, integrals, degree, factor=0, solutions=(1,)):
    field = [[[name], 1, rate] for name, rate in zip(XYZ, product(F, G), strict=True)]
    values = [[name, value(chosen)] for name in "ab"] + [
        [name, chosen.randint(1, 9)] for name in XYZ
    ]
    goal = {
        "goal": "kernel", "space": 0, "factor": factor, "solutions": [*solutions],
        "integrals": integrals, "weights": [1, 1, 1], "degree": degree,
    }  # fmt: skip
    return {
        "format": checker.FORMAT, "version": checker.VERSION, "claim": "kernel", "sign": "holds",
        "spaces": [{"variables": [*XYZ], "constants": ["a", "b"], "field": field}],
        "goals": [goal], "evidence": [{"point": {"roots": [], "values": values}}],
    }  # fmt: skip


def is_accepted(data):
    """Whether the checker, or the judge, accepts a certificate."""
    found = []
    for program, refused in (
        (lambda: checker.check(seal(data)), checker.Rejected),
        (lambda: judged(data), (Unproved, FormatError)),
    ):
        try:
            program()
            found.append(True)
        except refused:
            found.append(False)
    return found


@pytest.mark.parametrize("seed", sampled(range(300), 12))
def test_a_list_that_lacks_an_integral_is_not_complete(seed):
    chosen = random.Random(seed)
    F, G = polynomial(chosen, chosen.randint(1, 2)), polynomial(chosen, 2)
    both = [tree(F), tree(G)]
    listed = chosen.choice(
        [
            [], both[:1], both[1:], [["^", both[0], 2], both[1]], [["*", *both]],
            [both[0], ["*", 3, both[0]]], [both[0], ["*", *both]],
            [both[0], ["+", both[1], ["*", ["^", both[1], 2], chosen.choice(["a", "b", PRIME])]]],
        ]
    )  # fmt: skip
    degree = chosen.randint(2, MOST)
    assert not any(is_accepted(certificate(chosen, F, G, listed, degree)))
    one_less = certificate(chosen, F, G, both[:1], degree, solutions=[both[1]])
    assert not any(is_accepted(one_less))


def test_both_are_complete_somewhere():
    """So that what is refused above is not refused for another reason."""
    complete = 0
    for seed in range(12):
        chosen = random.Random(seed)
        F, G = polynomial(chosen, 2), polynomial(chosen, 2)
        both = is_accepted(certificate(random.Random(seed), F, G, [tree(F), tree(G)], 3))
        assert both[0] == both[1]
        complete += both[0]
    assert complete > 2
