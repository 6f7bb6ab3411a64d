"""Certificates as programs over polynomials: what the checker computes, computed once more.

The checker reads the certificate with a ring that writes down each operation: sums, products,
partial derivatives, substitutions, and each test whether something vanishes. So the program
differentiates and reduces by itself, and nothing counts as confirmed but what it found to
vanish. Divisors are generators v with v n = 1; a root is a generator with a square.

What has to be tested is the checker's to say, and so is what follows over the real numbers (that
a sum of squares vanishes only with each of them, Hermite's theorem), which names occur in a
formula, and which rational numbers are positive.
"""

from __future__ import annotations

from abc import ABC
from copy import deepcopy

from kowalevski_cas.export.format import RANKS, SOLUTIONS, Format, Inexpressible, Json
from kowalevski_cas.export.polynomials.language import Language
from kowalevski_cas.export.polynomials.space import Space
from kowalevski_cas.export.polynomials.trace import Traced, Writer
from kowalevski_cas.problem import checker

UNSAID = {"kernel": RANKS, "along": SOLUTIONS}


class Polynomials(Language, Format, ABC):
    """A format that is made of the words of a language.

    With ``trusting``, equations that do not hold are put to the program all the same: it has to
    find out.
    """

    trusting = False

    def translate(self, certificate: Json) -> str:
        writer = Writer(self)
        writer.comment(f"{certificate['claim']}, certificate {certificate['digest']}")
        spaces, goals = (deepcopy(certificate[key]) for key in ("spaces", "goals"))
        try:
            problem = checker.Problem(
                spaces, goals, Traced(writer, checker.Budget(5 * checker.WORK)), Space
            )
            for space in problem.spaces:
                assert isinstance(space.ring, Traced)
                space.ring.trusting = self.trusting
            denied = certificate["sign"] == "denied"
            for k, evidence in enumerate(deepcopy(certificate["evidence"])):
                goal = goals[evidence.pop("goal") if denied else k]
                if goal["goal"] in UNSAID:
                    raise Inexpressible(UNSAID[goal["goal"]])
                writer.comment(checker.sentence(goal, not denied))
                (problem.denied if denied else problem.holds)(goal, evidence)
        except checker.Rejected as error:
            raise Inexpressible(f"the checker says: {error.args[0]}") from None
        return writer.text

    def objection(self, text: str, output: str) -> str:
        wanted = [line.split('"')[1] for line in text.splitlines() if line.startswith('holds("')]
        found = [line.strip() for line in output.splitlines() if line.strip()]
        for line, words in zip(found, wanted, strict=False):
            if line != f"holds: {words}":
                return line
        if not wanted or len(found) != len(wanted):
            return f"{len(found)} of {len(wanted)} statements are confirmed"
        return ""
