"""What would cost much is rejected: by its size, or since all work is counted."""

import json

import pytest

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker import certificate as check
from kowalevski_cas.problem.checker import reading
from tests.sample import sampled

from .falsehoods import at, follows
from .tampering import seal

XY = {"variables": ["x", "y"]}
POINT = {"point": at({"x": 1, "y": 1})}
MANY = [f"x_{k}" for k in range(60)]
CUBE = ["^", ["+", *MANY], 3]
STEPS = 200_000
"""Of a check in these tests, to be quick: a certificate of the papers takes fewer."""


def text(goals, evidence, *spaces, sign="holds"):
    data = {"format": checker.FORMAT, "version": checker.VERSION, "claim": "c", "sign": sign}
    spaces = [{"variables": [*XY["variables"]], **space} for space in spaces] or [XY]
    return seal({**data, "spaces": spaces, "goals": goals, "evidence": evidence})


def identity(*equations, evidence=POINT, space=0, **more):
    """Equations as one conclusion, over one space."""
    goal = {**follows([[*equations]]), "space": space}
    return text([goal], [evidence], more)


def primes(below):
    return [p for p in range(3, below, 2) if all(p % q for q in range(3, int(p**0.5) + 1, 2))]


def fractions(many, each):
    """Sums of fractions whose denominators have nothing in common, each of them small."""
    found = primes(60_000)
    return [["+", *(["/", 1, p] for p in found[k : k + each])] for k in range(0, many, each)]


def sums_that_double(terms):
    steps = [["let", "t_0", terms]]
    return [*steps, *(["let", f"t_{k + 1}", ["*", f"t_{k}", f"t_{k}"]] for k in range(20))]


def nested(depth, tree="f"):
    for _ in range(depth):
        tree = ["-", tree]
    return tree


def lets(many):
    return [["let", f"t{k}", 0] for k in range(many)]


def roots(many, tree="x"):
    return [["root", f"r{k}", ["+", tree, k]] for k in range(many)]


COSTLY = {
    "large numbers multiplied": lambda: identity(*[[["*", *[10**40] * 3000], 0]] * 3),
    "a power of a power of a number": lambda: identity([["^", ["^", ["^", 10**40, 64], 64], 64], 0]),
    "a power of a power of a fraction": lambda: identity([["^", ["^", ["^", ["/", 1, 3], 64], 64], 64], 0]),
    "a power of a power": lambda: identity([["^", ["^", ["^", ["+", "x", 10**40], 64], 64], 64], 0]),
    "sums that double": lambda: identity([0, 0], variables=MANY, steps=sums_that_double(["+", *MANY])),
    "fractions with many denominators": lambda: identity([["+", *fractions(6000, 300)], 0]),
    "a vector of such fractions": lambda: identity([["vector", *fractions(6000, 300)], 0]),
    "a product of such fractions": lambda: identity([["*", *fractions(6000, 300)], 0]),
    "a power of such fractions": lambda: identity([["^", ["+", "x", *fractions(6000, 300)], 64], 0]),
    "a polynomial with such fractions": lambda: identity(
        [["+", *(["/", ["^", "x", k % 64], p] for k, p in enumerate(primes(60_000)))], 0]
    ),
    "many conclusions": lambda: text([follows([[["x", k] for k in range(30)]] * 12)], [POINT]),
    "many conclusions that vanish": lambda: text([follows([[[0, 0] for _ in range(30)]] * 12)], [POINT]),
    "many minors": lambda: text(
        [{"goal": "rank", "space": 0, "functions": [["+", *MANY]] * 30, "given": [], "rank": 3}],
        [{"goal": 0, "minors": []}], {"variables": MANY}, sign="denied",
    ),
    "a thousand names": lambda: identity([0, 0], variables=[f"x_{k}" for k in range(1000)]),
    "conditions that wait for names": lambda: identity(
        [0, 0], steps=lets(4000), nonzero=[["+", "x", "t3999"]] * 4000
    ),
    "derivatives of what is constant": lambda: identity(
        *[[["D", "f"], 0]] * 4000, variables=["x"], constants=MANY, steps=[["let", "f", CUBE]], field=[[["x"], 1, 1]]
    ),
    "derivatives by a name in few terms": lambda: identity(
        *[[["D", "f"], 0]] * 30, variables=MANY, constants=["a", "b", "c"], field=[[MANY, ["vector", *[1] * 60], ["vector", *MANY]]],
        steps=[["let", "f", ["+", ["^", ["+", "a", "b", "c"], 30], *MANY]]],
    ),
    "conjugates of long products": lambda: identity(
        [["conj", "v"], "v"], variables=MANY, steps=[["let", "m", ["*", *MANY]], ["let", "v", ["vector", *["m"] * 9000]]]
    ),
    "what vanishes at a point, term by term": lambda: text(
        [follows([[["x_0", "x_0"]]], [["f", 0]] * 900)],
        [{"point": at(dict.fromkeys(MANY, 0))}],
        {"variables": MANY, "steps": [["let", "f", ["^", ["+", *MANY[:12]], 3]]]},
    ),
    "signs": lambda: identity(*[[nested(200), 0]] * 9, variables=MANY, steps=[["let", "f", CUBE]]),
    "inverses of sums of roots": lambda: identity([["/", 1, ["+", *[f"r{k}" for k in range(14)]]], 0], steps=roots(14)),
    "an inverse that is found again": lambda: identity(
        *[[["/", "x_0", "f"], ["/", "x_0", "f"]]] * 20_000,
        variables=MANY, steps=[["let", "f", ["^", ["+", *MANY[:12]], 4]]],
    ),
    "fractions with many divisors": lambda: identity(
        [["+", *[["/", 1, ["+", n, k]] for n in MANY[:20] for k in (0, 1, 2)]], 0],
        variables=MANY, evidence={"point": at({n: k for k, n in enumerate(MANY, 1)})},
    ),
    "roots over divisors": lambda: identity(
        [["^", ["+", *[f"r{k}" for k in range(12)]], 9], 0], steps=[["root", f"r{k}", ["/", ["+", "x", k], ["+", "y", k]]] for k in range(12)]
    ),
    "roots that are looked for": lambda: identity(
        *[[["sqrt", ["+", ["^", "x", 3], 139]], "r139"]] * 900, steps=roots(140, ["^", "x", 3])
    ),
    "goals over many names": lambda: text([follows([[["x", "x"]]])] * 900, [POINT] * 900, {"steps": lets(2000)}),
    "words": lambda: text(
        [follows([[["x_0", "x_0"]]])] * 9, [POINT] * 9, {"variables": MANY, "nonzero": [["+", CUBE, k] for k in range(9)]}
    ),
    "conditions that are said again": lambda: text(
        [follows([[["x", "x"]]])] * 900, [POINT] * 900, {"nonzero": [["+", *["x"] * 99, ["*", k, "y"]] for k in range(1, 40)]}
    ),
    "cases": lambda: identity(
        *[["x", "x"]] * 900, evidence={**POINT, "product": [["x"]] * 900, "cofactors": [[]], "cases": [{}] * 900}
    ),
    "squares": lambda: text(
        [follows([[["f", 0]]])],
        [{**POINT, "product": [["f"] * 9000], "cofactors": [[]], "cases": [{"cofactors": [[1, *[0] * 8999]]}]}],
        {"steps": [["let", "f", ["^", ["+", "x", "y"], 30]]]},
    ),
    "monomials": lambda: text(
        [{"goal": "kernel", "space": 0, "factor": 0, "solutions": [1], "integrals": ["x", "y"], "weights": [1, 1], "degree": 1000}],
        [POINT], {"field": [[["x", "y"], ["vector", 1, 1], ["vector", 0, 0]]]},
    ),
    "long vectors": lambda: identity(
        *[[["+", "v", "v"], ["*", 2, "v"]]] * 30, steps=[["let", "v", ["vector", *["x"] * 5000]]]
    ),
    "long vectors of zeros": lambda: identity(
        *[[["+", "v", "v", "v"], ["-", "v"]]] * 30, steps=[["let", "v", ["vector", *[0] * 5000]]]
    ),
    "a polynomial at a point": lambda: text(
        [follows([[["x_0", 0]]], [["f", 0]])] * 9,
        [{"point": {"roots": [], "values": [[n, 0 if n == "x_0" else ["/", 1, 10**90 + k]] for k, n in enumerate(MANY)]}}] * 9,
        {"variables": MANY, "steps": [["let", "f", CUBE]]},
    ),
    "roots at a point": lambda: text(
        [follows([[["x", 0]]])],
        [{"goal": 0, "point": {"roots": [*range(2, 140)], "values": [["x", ["*", *[["+", 1, ["sqrt", k]] for k in range(2, 30)]]], ["y", 0]]}}],
        sign="denied",
    ),
    "many spaces": lambda: text([follows([[[1, 1]]])], [{"point": at({})}], *[{"variables": []}] * 20_000),
}  # fmt: skip


@pytest.mark.parametrize("name", sampled(COSTLY, 1))
def test_what_costs_much_is_rejected(name, monkeypatch):
    monkeypatch.setattr(check, "Budget", lambda: checker.Budget(STEPS))
    certificate = COSTLY[name]()
    assert len(certificate) < checker.SIZE
    with pytest.raises(checker.Rejected, match=r"too much|too large|too many"):
        checker.check(certificate)


@pytest.mark.slow
@pytest.mark.parametrize("made", COSTLY.values(), ids=COSTLY)
def test_with_all_steps_it_is_rejected_or_ends(made):
    try:
        checker.check(made())
    except checker.Rejected as error:
        assert "malformed" not in str(error)


@pytest.mark.parametrize("depth", [900, 20_000, 200_000])
@pytest.mark.parametrize(("left", "right"), [("[", "]"), ('["-", ', "]"), ('{"point": ', "}")])
def test_depth(left, right, depth):
    deep = identity(["x", "x"]).replace('"x"', f'{left * depth}"x"{right * depth}', 1)
    with pytest.raises(checker.Rejected):
        checker.check(deep)


def test_the_length_of_a_file():
    good = identity(["x", "x"])
    assert checker.check(good + " " * (checker.SIZE - len(good) - 1)).claim == "c"
    with pytest.raises(checker.Rejected, match="too long"):
        checker.check(good + " " * (checker.SIZE - len(good)))


@pytest.mark.parametrize("digits", [reading.BITS // 3, 5000, 400_000])
def test_the_length_of_a_number(digits):
    long = identity(["x", 7]).replace("7", "7" * digits)
    with pytest.raises(checker.Rejected, match="number is too large"):
        checker.check(long)


def test_the_budget_is_for_one_file():
    fits = identity(*[[["^", ["+", "x", "y"], 40], ["^", ["+", "y", "x"], 40]]] * 3)
    for _ in range(5):
        assert checker.check(fits)
    assert json.loads(fits)["claim"] == "c"
