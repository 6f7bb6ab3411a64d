"""What a certificate proves."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import dataclass

from .polynomials import Ring
from .problem import Problem, Theorem
from .reading import Budget, Rejected, integer, items, need, parsed, printable


@dataclass(frozen=True)
class Certificate:
    """What a file certifies: a claim, the digest of its problem, and theorems."""

    claim: str
    digest: str
    sign: str
    theorems: list[Theorem]

    def summary(self) -> str:
        """All in a line."""
        return printable(f"{self.claim}: {'; '.join(t.summary() for t in self.theorems)}")

    def lines(self) -> list[str]:
        """All of the theorems: with variables, definitions, field, conditions and points."""
        return [printable(line) for theorem in self.theorems for line in theorem.lines()]


def check(text: str) -> Certificate:
    """What the text of a certificate proves; raises Rejected if it proves nothing."""
    try:
        return _judged(text)
    except Rejected:
        raise
    except Exception as error:  # whatever goes wrong, nothing is proved
        raise Rejected(f"it is malformed: {type(error).__name__}") from None


def _judged(text: str) -> Certificate:
    data = parsed(text)
    claim, sign, evidence = data["claim"], data["sign"], items(data["evidence"])
    named = type(claim) is str and re.fullmatch(r"[\w.-]+", claim, re.ASCII)
    need(named, "the claim has an odd name")
    statement = {key: data[key] for key in ("spaces", "goals")}
    digest = hashlib.sha256(json.dumps(statement, sort_keys=True).encode()).hexdigest()[:16]
    need(data["digest"] == digest, "the digest is another one")
    problem = Problem(data["spaces"], data["goals"], Ring(Budget()))
    if sign == "holds":
        need(len(evidence) == len(problem.goals), "evidence is missing")
        both = zip(problem.goals, evidence, strict=True)
        return Certificate(claim, digest, sign, [problem.holds(*pair) for pair in both])
    need(sign == "denied", "it neither holds nor is denied")
    (entry,) = items(evidence, 1)
    need(type(entry) is dict, "evidence is expected")
    goal = problem.goals[integer(entry.get("goal"), 0, len(problem.goals) - 1)]
    rest = {key: value for key, value in entry.items() if key != "goal"}
    return Certificate(claim, digest, sign, [problem.denied(goal, rest)])
