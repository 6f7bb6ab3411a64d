"""Small certificates of every kind, written by hand, and what becomes of them if they are changed."""

import json
import random
from pathlib import Path

import pytest

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker.command import main

from .judges import judged
from .oracle import is_true
from .tampering import changed, names_in, others, places, seal

FILES = sorted((Path(__file__).parent / "handwritten").glob("*.json"))
TEXTS = {path.stem: path.read_text(encoding="utf-8") for path in FILES}
SHARES = (0.05, pytest.param(1, marks=pytest.mark.slow))
"""How many of all changes are tried."""
KINDS = ("follows", "fails", "rank", "exists", "count", "kernel", "along")


def accepted(data):
    try:
        checker.check(seal(data))
    except checker.Rejected:
        return False
    return True


def test_all_are_certified(capsys):
    assert main([*map(str, FILES)]) == 0
    assert capsys.readouterr().out.endswith(f"CERTIFIED {len(FILES)} of {len(FILES)}\n")
    assert len(FILES) >= 30


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("sign", ["holds", "denied"])
def test_every_kind_of_goal_is_there_with_both_signs(kind, sign):
    found = [json.loads(text) for text in TEXTS.values()]
    goals = [
        data["goals"][k]["goal"]
        for data in found
        if data["sign"] == sign
        for k in ([e["goal"] for e in data["evidence"]] if sign == "denied" else range(len(data["goals"])))
    ]  # fmt: skip
    inner = [one["goal"] for data in found for g in data["goals"] for one in g.get("goals", [])]
    assert kind in goals or (sign == "holds" and kind in inner)


@pytest.mark.parametrize("claim", TEXTS)
def test_the_judge_and_the_oracle_agree(claim):
    judged(json.loads(TEXTS[claim]))
    assert is_true(json.loads(TEXTS[claim])) == (True, "")


@pytest.mark.parametrize("share", SHARES)
@pytest.mark.parametrize("claim", TEXTS)
def test_a_change_of_the_evidence_is_rejected_or_still_a_proof(claim, share):
    tampered(claim, {"evidence", "sign"}, share, most=0.35)


@pytest.mark.parametrize("share", SHARES)
@pytest.mark.parametrize("claim", TEXTS)
def test_a_change_of_the_problem_is_rejected_or_still_proved(claim, share):
    tampered(claim, {"spaces", "goals"}, share, most=0.6)


def tampered(claim, keys, share, most):
    data = json.loads(TEXTS[claim])
    names, through = sorted(names_in([data["spaces"], data["goals"]])), 0
    changes = [(p, v) for p in places(data) if p[0] in keys for v in others(data, p, names)]
    assert len(changes) > 10
    changes = random.Random(claim).sample(changes, max(10, int(share * len(changes))))
    for path, value in changes:
        other = changed(data, path, value)
        if accepted(other):
            through += 1
            true, why = is_true(other)
            assert true, f"{path} = {str(value)[:80]} got through: {why}"
    assert through < (most if share == 1 else 1) * len(changes)


@pytest.mark.parametrize("coefficient", ["a", ["+", "a", ["*", "a", "a"]], 2**61 - 1, ["*", 2**61 - 1, "a"]])  # fmt: skip
@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_kernel_is_not_complete_by_what_vanishes_at_the_point_or_modulo_the_prime(
    coefficient, degree
):
    """Of x' = 0, y' = 1 the integrals are the polynomials in x; x + c x^2 does not give x."""
    listed = ["+", "x", ["*", coefficient, ["^", "x", 2]]]
    data = {
        "format": "kowalevski-cas certificate",
        "version": 2,
        "claim": "kernel",
        "spaces": [
            {"variables": ["x", "y"], "constants": ["a"], "field": [[["x"], 1, 0], [["y"], 1, 1]]}
        ],
        "goals": [
            {"goal": "kernel", "space": 0, "factor": 0, "solutions": [1], "integrals": [listed],
             "weights": [1, 1], "degree": degree}
        ],
        "sign": "holds",
        "evidence": [{"point": {"roots": [], "values": [["a", 0], ["x", 1], ["y", 2]]}}],
    }  # fmt: skip
    with pytest.raises(checker.Rejected, match="one may be missing"):
        checker.check(seal(data))
    data["goals"][0]["integrals"] = ["x"]
    assert checker.check(seal(data)).sign == "holds"
