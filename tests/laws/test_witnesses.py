"""What is said to exist is regular where it is spoken of: singular witnesses show nothing false.

A matrix M with F' = M F is determined up to matrices N with N F = 0. Those that divide by one of
the functions are singular on the set, and give M there whatever trace one likes.
"""

import random
from dataclasses import replace
from itertools import product

import pytest

from kowalevski_cas.paper.claims import InvariantRelations, LastMultiplier, Limit
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.codec import problem_data
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.goals import Exists
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.statement import Statement
from tests.paper.small import Motion, derivation
from tests.problem.judges import judged
from tests.problem.tampering import seal
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

FEW, MANY = 2, 8
DIVISORS = [], ["x"], ["y"], ["x", "y"]
POINTS = [
    {"roots": [], "values": [["x", x], ["y", y], ["z", z]]}
    for x, y, z in ((1, 1, 1), (0, 0, 1), (0, 0, 0))
]


class Linear:
    """A linear motion that keeps the line x = y = 0 and the volume; on the line it need not."""

    def __init__(self, seed):
        choose = random.Random(seed)
        self.A = [[choose.randint(-2, 2) for _ in range(2)] for _ in range(2)]
        self.trace = self.A[0][0] + self.A[1][1]
        self.seed = choose.randint(1, 3)

    def paper(self):
        (a, b), (c, d) = self.A
        rates = rf"\dot x={a}x+({b})y,\quad \dot y={c}x+({d})y,\quad \dot z=({-self.trace})z+x"
        paper = Motion(rates, "x", "y", "z")
        return paper


def existing(paper, claim):
    """The problem of what a claim says to exist."""
    paper.section.claims.clear()
    paper.section.claim(claim)
    statement = Statement(claim, Elaborations(derivation(paper.section).texts()))
    goals = [goal for goal in statement.goals if isinstance(goal, Exists)]
    return problem_data(Statement(claim, statement.on, tuple(goals)).problem)


def none_or_zero(one):
    """Rows for goals that hold identically."""
    return [[]] * len(one["conclusions"][0])


def certificates(problem, values, cofactors=none_or_zero, divisors=DIVISORS):
    """Certificates with these values: points of all kinds, and one divisor or another.

    Points and divisors are chosen for what is given, and for what holds identically.
    """
    (goal,) = problem["goals"]
    bound = [*goal["numbers"], *goal["expressions"]]
    values = [[name, values[name]] for name in bound]
    for points in product(POINTS, repeat=2):
        for away in product(divisors, repeat=2):
            entries = [
                {
                    "point": points[bool(one["given"])],
                    **({"cofactors": cofactors(one)} if one["given"] else {}),
                    **({"away": listed} if (listed := away[bool(one["given"])]) else {}),
                }
                for one in goal["goals"]
            ]
            yield {
                "format": checker.FORMAT, "version": checker.VERSION, "claim": "c", **problem,
                "sign": "holds", "evidence": [{"values": values, "evidence": entries}],
            }  # fmt: skip


def is_certified(data):
    """Whether the checker accepts a certificate."""
    try:
        checker.check(seal(data))
    except checker.Rejected:
        return False
    return True


def is_proved(data):
    """Whether the judge does, who sees by itself what is divided by."""
    try:
        judged(data)
    except (Unproved, FormatError):
        return False
    return True


def accepts(tries):
    """Whether one of some certificates is accepted; checker and judge agree."""
    tries = [*tries]
    certified = any(map(is_certified, tries))
    assert certified == any(map(is_proved, tries))
    return certified


def with_homogeneous(A, a, b):
    """A with the rows (a, −a x/y) and (−b y/x, b) added, which make nothing of (x, y)."""
    N = [[a, ["/", ["*", -a, "x"], "y"]], [["/", ["*", -b, "y"], "x"], b]]
    rows = zip(A, N, (a, b), strict=True)
    return [[["+", m, n] if k else m for m, n in zip(p, q, strict=True)] for p, q, k in rows]


def is_preserved(linear, shares):
    """Whether a measure on the line is found preserved, by a matrix with the trace 0."""
    problem = existing(linear.printed, LastMultiplier("m", linear.scene, "", linear.set))
    M = with_homogeneous(linear.A, *shares)
    values = {f"M_{{{i + 1}{j + 1}}}": M[i][j] for i in range(2) for j in range(2)}
    return accepts(certificates(problem, values))


def motions(many, wanted=lambda linear: linear.trace):
    seeds = iter(range(10_000))
    while many:
        linear = Linear(next(seeds))
        if wanted(linear):
            linear.printed = paper = linear.paper()
            linear.scene = paper.scene
            linear.set = InvariantRelations("set", paper.scene, "", (paper("x=0"), paper("y=0")))
            many -= 1
            yield linear


def diagonal(**entries):
    """Matrices of two rows, of letters with the entries of their diagonals."""
    return {
        f"{letter}_{{{i}{j}}}": entries[letter][i - 1] if i == j else 0
        for letter in entries
        for i in (1, 2)
        for j in (1, 2)
    }


def limits(rate, k, m):
    """That the set of xᵏ and yᵐ goes over into that of x and y, in a time that runs twice as fast."""
    rates = rf"\dot x=-2x,\quad \dot y={2 * rate}y,\quad \dot z={2 - 2 * rate}z"
    paper = Motion(rates, "x", "y", "z")
    slow = paper.all(rf"\dot x=-x,\quad \dot y={rate}y,\quad \dot z={1 - rate}z")
    scene = replace(paper.scene, constants=(r"\tau",), clock=paper(r"\tau=2t"))
    general, special = (
        InvariantRelations("set", on, "", tuple(map(paper, tex)))
        for on, tex in (
            (replace(scene, field=slow), (f"x^{k}=0", f"y^{m}=0")),
            (scene, ("x=0", "y=0")),
        )
    )
    over = [["^", "x", k - 1], ["^", "y", m - 1]]
    inverses = [["/", 1, over[0]] if k > 1 else 1, ["/", 1, over[1]] if m > 1 else 1]
    values = diagonal(M=[-k, m * rate], N=[-2, 2 * rate], T=over, S=inverses)
    return certificates(existing(paper, Limit("l", scene, "", general, special)), values)


MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]


@pytest.mark.parametrize("many", MARKS)
def test_a_matrix_that_is_singular_on_the_set_preserves_no_measure_there(many):
    for linear in motions(many):
        for shares in ((-linear.trace, 0), (0, -linear.trace), (linear.seed, -linear.trace - linear.seed)):  # fmt: skip
            assert not is_preserved(linear, shares)


@pytest.mark.parametrize("many", MARKS)
def test_a_matrix_that_is_regular_on_the_set_does(many):
    for linear in motions(many, lambda linear: not linear.trace):
        assert is_preserved(linear, (0, 0))


POWERS = [(2, 1), (1, 2), (3, 1), (2, 2)]


@pytest.mark.parametrize("powers", POWERS)
def test_a_change_of_basis_that_is_singular_on_the_set_is_no_limit(powers):
    """The functions xᵏ, yˡ are xᵏ⁻¹x, yˡ⁻¹y, by a matrix that has no inverse where x = y = 0."""
    assert not accepts(limits(3, *powers))


def test_one_that_is_regular_there_is():
    assert accepts(limits(3, 1, 1))


@pytest.mark.parametrize("square", [("x^2=0", "y=0"), ("x=0", "2x=0"), ("x=0", "y=0", "x+y=0")])
def test_a_set_of_dependent_differentials_has_no_measure_of_its_own(square):
    """Of such functions the matrix M has no trace of its own, or there is no form dV/dF."""
    paper = Motion(r"\dot x=-x,\quad \dot y=2y,\quad \dot z=-z", "x", "y", "z")
    relations = InvariantRelations("set", paper.scene, "", tuple(map(paper, square)))
    assert paper.verdict(LastMultiplier, relations=relations) in ("refuted", "undecided")


RATES = [("1", "y"), ("y+1", "x"), ("x", "z"), ("y+z", "-x+z")]
SHARES = [(1, 1), (0, 0), (1, 0), (0, 1), (2, -1)]


@pytest.mark.parametrize(("rates", "shares"), sampled([*product(RATES, SHARES)], 1))
def test_a_matrix_that_is_singular_on_the_set_makes_no_set_invariant(rates, shares):
    """Over the fractions any derivative is a combination of functions, as F′ = (F′/x) x."""
    left = rf"\dot x={rates[0]},\quad \dot y={rates[1]},\quad \dot z=x"
    paper = Motion(left, "x", "y", "z")
    claim = InvariantRelations("set", paper.scene, "", (paper("x=0"), paper("y=0")))
    problem = existing(paper, claim)
    forces = [row[2] for row in problem["spaces"][0]["field"]]
    values = {}
    for i, (force, share) in enumerate(zip(forces, shares, strict=False), 1):
        values[f"M_{{{i}1}}"] = ["/", ["*", share, force], "x"]
        values[f"M_{{{i}2}}"] = ["/", ["*", 1 - share, force], "y"]
    assert not accepts(certificates(problem, values))
    assert paper.verdict(InvariantRelations, relations=claim.relations) == "refuted"
