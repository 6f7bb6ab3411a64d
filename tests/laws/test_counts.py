"""Linear equations and products of factors, of which it is known how many zeros they have.

A right count is proved, a wrong one refuted; either may stay undecided, with a reason.
"""

from itertools import permutations, product
from math import prod
from random import Random

import pytest

from kowalevski_cas.paper.claims import Equilibria
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.outcome import Verdict
from tests.paper.small import Motion

pytestmark = pytest.mark.usefixtures("uncorrected")

GREEN = {Verdict.PROVED, Verdict.CONDITIONAL}
CONSTANTS = ("h", "k")
MANY = None
"""The count of a continuum, or of no solution at all: no number is right."""


def decided(field, variables, count, constants=CONSTANTS):
    """What becomes of a count; the checker accepts what is decided."""
    motion = Motion(field, *variables, constants=constants)
    found = motion.outcome(Equilibria, fixed=(), levels=(), count=count)
    if found.verdict in GREEN | {Verdict.REFUTED}:
        for text in found.certificates.values():
            checker.check(text)
    return found


def check(field, variables, right, sure=False):
    """Each count gets a verdict that is true of it; one, if it is ``sure``, that decides it."""
    for count in (0, 1, 2):
        found = decided(field, variables, count)
        allowed = GREEN if count == right else {Verdict.REFUTED}
        assert found.verdict in allowed or (
            not sure and found.verdict == Verdict.UNDECIDED and found.message
        ), (field, count, found.verdict, found.message)


def linear(coefficients):
    """Terms of the constants, h and k, and of one."""
    terms = zip(coefficients, (*CONSTANTS, ""), strict=True)
    return "".join(f"{c:+d}{name}" for c, name in terms if c) or "+0"


def written(matrix, right, variables):
    """The field A x + b."""
    rows = (
        "".join(f"+({entry}){x}" for entry, x in zip(row, variables, strict=True)) + b
        for row, b in zip(matrix, right, strict=True)
    )
    return ",".join(rf"\dot {x}={row}" for x, row in zip(variables, rows, strict=True))


def determinant(matrix):
    size = len(matrix)
    return sum(
        prod((-1 if p[i] > p[j] else 1) for i in range(size) for j in range(i + 1, size))
        * prod(matrix[i][p[i]] for i in range(size))
        for p in permutations(range(size))
    )


@pytest.mark.parametrize("seed", range(12))
def test_linear_equations_have_one_solution_if_there_is_a_determinant(seed):
    random = Random(seed)
    variables = "xyz"[: 1 + seed % 3]
    matrix = [[random.randint(-2, 2) for _ in variables] for _ in variables]
    right = [linear([random.choice((0, 0, 1, -1, 2)) for _ in range(3)]) for _ in variables]
    regular = determinant(matrix) != 0
    check(written(matrix, right, variables), variables, 1 if regular else MANY, sure=regular)


@pytest.mark.parametrize("seed", range(12))
def test_a_constant_may_stand_in_the_matrix(seed):
    random = Random(100 + seed)
    variables = "xy"[: 1 + seed % 2]
    entries = [
        [random.choice(("h", "k", "1", "0", "-1", "2")) for _ in variables] for _ in variables
    ]
    right = [linear([random.choice((0, 1, -1)) for _ in range(3)]) for _ in variables]
    values = product((3, 5), (7, 11))
    at = [
        [[int({"h": h, "k": k}.get(one, one)) for one in row] for row in entries] for h, k in values
    ]
    regular = any(map(determinant, at))
    check(written(entries, right, variables), variables, 1 if regular else MANY, sure=regular)


@pytest.mark.parametrize("seed", range(12))
def test_complex_zeros_are_not_counted(seed):
    random = Random(200 + seed)
    real = random.sample(range(-3, 4), random.randint(0, 2))
    factors = [f"(x{-root:+d})" for root in real]
    factors += [f"(x^2+{random.randint(1, 4)})"] * random.randint(0, 1)
    check(rf"\dot x={''.join(factors) or '1'}", "x", len(real) or MANY)


@pytest.mark.parametrize(
    "field", [r"\dot x=0", r"\dot x=0,\dot y=x-h", r"\dot x=x-y+h,\dot y=2x-2y+2h", r"\dot x=h-k"]
)
def test_a_continuum_has_no_number(field):
    variables = [x for x in "xy" if rf"\dot {x}" in field]
    check(field, variables, MANY, sure=True)


@pytest.mark.parametrize(
    "field", [r"\dot x=1", r"\dot x=x^2+1", r"\dot x=\frac1x", r"\dot x=h^2+1"]
)
def test_what_is_not_decided_has_a_reason(field):
    check(field, [x for x in "xy" if rf"\dot {x}" in field], MANY)


@pytest.mark.slow
def test_many_constants_are_no_trouble():
    constants = tuple("abcdefghklmn")
    field = rf"\dot x={'+'.join(constants)}-x"
    assert decided(field, ("x",), 1, constants).verdict == Verdict.PROVED
    assert decided(field, ("x",), 2, constants).verdict == Verdict.REFUTED
