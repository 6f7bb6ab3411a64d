"""Evidence about nothing: whatever point it comes with, judge and checker reject it."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.trees import FormatError

from .judges import judged
from .tampering import seal

SQUARES = ["+", ["^", "x", 2], ["^", "y", 2]]


def minus(tree):
    return ["-", tree]


def follows(given, conclusion=("y", 7), **space):
    """The goal that y = 7 follows, on x, y and what else there is."""
    conclusions = [[[*conclusion]]] if conclusion else []
    goal = {"goal": "follows", "space": 0, "given": given, "conclusions": conclusions}
    return {"spaces": [{"variables": ["x", "y"], **space}], "goals": [goal]}


def contradictory(n):
    """Problems about nothing, and proofs that are right but for what they are about.

    The conclusion is y - 7 = 0; where something that is n or -n vanishes, it follows. In the last
    ones it is said that there is nothing, and divided by what is zero there.
    """
    far = ["+", "y", -7]
    root = {"steps": [["root", "r", minus(["+", SQUARES, n])]]}
    return [
        (follows([[1, 0]]), {"cofactors": [[far]]}),
        (follows([["x", 0], ["x", n]]), {"cofactors": [[["/", far, n], ["/", minus(far), n]]]}),
        (follows([["x", 0]], nonzero=["x"]), {"cofactors": [[["/", far, "x"]]]}),
        (follows([["x", 0]]), {"cofactors": [[["/", far, "x"]]], "away": ["x"]}),
        (follows([["x", 0], [["/", n, "x"], 1]]), {"cofactors": [[["/", far, "x"], 0]]}),
        (follows([[SQUARES, -n], ["y", 7]]), {"cofactors": [[0, 1]]}),
        (follows([], ("r", "r"), **root), {}),
        (follows([["y", 7]], **root), {"cofactors": [[1]]}),
        (follows([["r", "r"], [1, 0]], None, **root), {"cofactors": [[0, 1]]}),
        (follows([], ("r", "r"), steps=[["root", "r", -n]]), {}),
        (follows([], (["*", "x", "r"], ["*", "r", "x"]), steps=[["root", "r", minus(["^", "x", 2])]],
                 nonzero=["x"]), {}),
        (follows([["x", 0]], None), {"cofactors": [[["/", 1, "x"]]]}),
        (follows([[SQUARES, 0]], None), {"cofactors": [[["/", 1, SQUARES]]]}),
        (follows([[["*", "x", "y"], 0]], None, nonzero=["x"]),
         {"cofactors": [[["/", 1, ["*", "x", "y"]]]]}),
    ]  # fmt: skip


numbers = st.integers(-7, 7)
values = st.one_of(
    numbers,
    numbers.map(lambda n: ["/", n, 3]),
    st.sampled_from([["sqrt", 2], ["sqrt", 3], "i", ["-", "i"], ["*", 2, "i"], ["*", "i", ["sqrt", 2]],
                     ["+", 1, "i"], 7, 0]),
)  # fmt: skip
points = st.fixed_dictionaries({"x": values, "y": values}, optional={"r": values, "i": values})


def certificate(problem, entry):
    head = {"format": checker.FORMAT, "version": 2, "claim": "c", "sign": "holds"}
    return {**head, **problem, "evidence": [entry]}


@pytest.mark.parametrize("case", range(len(contradictory(1))))
@given(st.data(), st.integers(1, 3))
def test_no_point_is_one_of_nothing(case, data, n):
    problem, entry = contradictory(n)[case]
    found = data.draw(points)
    roots = sorted({k for k in (2, 3) if str(["sqrt", k]) in str(found)})
    entry = {**entry, "point": {"roots": roots, "values": [[a, v] for a, v in found.items()]}}
    with pytest.raises((Unproved, FormatError)):
        judged(certificate(problem, {k: tree for k, tree in entry.items() if k != "away"}))
    with pytest.raises(checker.Rejected):
        checker.check(seal(certificate(problem, entry)))


SIGNS = st.sampled_from([1, -1, 2, -3])


@given(SIGNS, SIGNS, st.booleans())
def test_nothing_is_shown_by_a_norm(sign, other, stated):
    """Where x + r is not zero, x - r may be."""
    assume(sign != other)
    one, less = (["+", "x", ["*", n, "r"]] for n in (sign, other))
    space = {"steps": [["root", "r", "y"]], "nonzero": [one]}
    given = ["/", less, one] if stated else less
    problem = follows([[given, 0]], None, **space)
    entry = {"cofactors": [[["/", 1, given]]]}
    entry["point"] = {"roots": [], "values": [["x", 7], ["y", 1], ["r", 1]]}
    with pytest.raises((Unproved, FormatError)):
        judged(certificate(problem, entry))
    with pytest.raises(checker.Rejected):
        checker.check(seal(certificate(problem, entry)))


def test_the_same_proof_is_accepted_where_there_is_a_point():
    point = {"roots": [], "values": [["x", 0], ["y", 7]]}
    data = certificate(follows([["y", 7]]), {"cofactors": [[1]], "point": point})
    judged(data)
    assert checker.check(seal(data))


@pytest.mark.parametrize("exponent", [65, 10**9, 10**30, -1, True, 2.0, "x", None])
def test_evidence_with_huge_powers(exponent):
    for base in ("x", ["+", "x", "y"], 2, ["^", ["+", "x", 1], 64]):
        entry = {"cofactors": [[["^", base, exponent]]]}
        entry["point"] = {"roots": [], "values": [["x", 0], ["y", 7]]}
        with pytest.raises(FormatError):
            judged(certificate(follows([["y", 7]]), entry))


def test_evidence_with_powers_of_powers():
    tree = ["+", "x", "y"]
    for _ in range(3):
        tree = ["^", tree, 64]
    entry = {"cofactors": [[tree]], "point": {"roots": [], "values": [["x", 0], ["y", 7]]}}
    with pytest.raises(FormatError, match="too large"):
        judged(certificate(follows([["y", 7]]), entry))
