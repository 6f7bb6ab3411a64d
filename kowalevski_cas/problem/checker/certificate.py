"""What a certificate proves."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import dataclass

from .evidence import locate
from .polynomials import Ring
from .problem import Problem, Theorem
from .reading import Budget, Json, Rejected, integer, items, need, parse, printable, record, say


@dataclass(frozen=True)
class Failure:
    """What is shown at points where a condition is violated, and the digest of that problem."""

    condition: Json
    digest: str
    theorem: Theorem


@dataclass(frozen=True)
class Certificate:
    """What a file certifies: a claim, the digest of its problem, and theorems.

    ``failures`` are what fails, or does not hold, at a point where a condition is violated.
    """

    claim: str
    digest: str
    sign: str
    theorems: list[Theorem]
    failures: list[Failure]

    def summary(self) -> str:
        """All in a line."""
        return printable(f"{self.claim}: {'; '.join(t.summary() for t in self.theorems)}")

    def lines(self) -> list[str]:
        """All of the theorems: with variables, definitions, field, conditions and points."""
        found = [line for theorem in self.theorems for line in theorem.lines()]
        for failure in self.failures:
            found += [
                f"  at a point where {say(failure.condition)} = 0:",
                *failure.theorem.lines("    "),
            ]
        return [*map(printable, found)]


def check(text: str, budget: Budget | None = None) -> Certificate:
    """What the text of a certificate proves; raises Rejected if it proves nothing."""
    try:
        return _judge(text, budget or Budget())
    except Rejected:
        raise
    except Exception as error:  # whatever goes wrong, nothing is proved
        raise Rejected(f"it is malformed: {type(error).__name__}") from None


def _judge(text: str, budget: Budget) -> Certificate:
    data = parse(text)
    claim = data["claim"]
    named = type(claim) is str and re.fullmatch(r"[\w.-]+", claim, re.ASCII)
    need(named, "the claim has an odd name")
    _, theorems = _show(data, budget)
    failures = [_failure(item, budget) for item in items(data.get("failures", []))]
    return Certificate(claim, data["digest"], data["sign"], theorems, failures)


def _show(data: Json, budget: Budget) -> tuple[Problem, list[Theorem]]:
    """A problem, and what its evidence shows."""
    sign, evidence = data["sign"], items(data["evidence"])
    statement = {key: data[key] for key in ("spaces", "goals")}
    digest = hashlib.sha256(json.dumps(statement, sort_keys=True).encode()).hexdigest()[:16]
    need(data["digest"] == digest, "the digest is another one")
    problem = Problem(data["spaces"], data["goals"], Ring(budget))
    if sign == "holds":
        need(len(evidence) == len(problem.goals), "evidence is missing")
        both = zip(problem.goals, evidence, strict=True)
        return problem, [problem.holds(*pair) for pair in both]
    need(sign == "denied", "it neither holds nor is denied")
    (entry,) = items(evidence, 1)
    need(type(entry) is dict, "evidence is expected")
    goal = problem.goals[integer(entry.get("goal"), 0, len(problem.goals) - 1)]
    rest = {key: value for key, value in entry.items() if key != "goal"}
    return problem, [problem.denied(goal, rest)]


def _failure(data: Json, budget: Budget) -> Failure:
    """A goal that fails, or a count that is denied, by points where a condition is violated."""
    record(data, "condition spaces goals sign evidence digest")
    (goal,), (entry,) = items(data["goals"], 1), items(data["evidence"], 1)
    problem, (theorem,) = _show(data, budget)
    need((goal["goal"], data["sign"]) in FAILURES, "nothing fails")
    space = problem.stage(goal, {})
    with space.statement():
        condition = space.scalar(data["condition"])
    for point in entry["points"] if goal["goal"] == "count" else [entry["point"]]:
        locate(space, point, [condition])
    return Failure(data["condition"], data["digest"], theorem)


FAILURES = ("fails", "holds"), ("count", "denied")
"""What is shown by points: one where a goal fails, or too many solutions."""
