"""What the rows of one method say together: how fast it is, and how often it is wrong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from statistics import median, quantiles

from study.methods.method import ACCEPTED, NONE, REJECTED
from study.step import LEFT_OUT, Row

COLD = "cold"


@dataclass
class Summary:
    """The measurements of one method.

    ``bound`` is the largest chance of accepting a false statement that the method
    itself guarantees; ``reasons`` counts why there was no answer.
    """

    method: str
    proves: bool = False
    seconds: list[float] = field(default_factory=list)
    answers: int = 0
    false_accepts: int = 0
    false_rejects: int = 0
    reasons: Counter[str] = field(default_factory=Counter)
    bound: float | None = None

    def add(self, row: Row) -> None:
        """Count one measurement."""
        verdict = row["verdict"]
        if row["case"].startswith(f"{COLD} "):
            return
        self.proves = self.proves or bool(row.get("proves"))
        if row.get("seconds") is not None:
            self.seconds.append(row["seconds"])
        if row.get("bound") is not None:
            self.bound = max(self.bound or 0.0, row["bound"])
        if verdict in (ACCEPTED, REJECTED):
            self.answers += 1
            self.false_accepts += verdict == ACCEPTED and not row["truth"]
            self.false_rejects += verdict == REJECTED and row["truth"]
        else:
            self.reasons[_reason(row)] += 1

    @property
    def errors(self) -> int:
        """How many answers are wrong."""
        return self.false_accepts + self.false_rejects

    @property
    def is_proof(self) -> bool:
        """Whether the answers are proofs, and none was seen to be wrong."""
        return self.proves and not self.errors and self.answers > 0

    @property
    def rate(self) -> float:
        """The share of wrong answers; if there are none, the guaranteed bound.

        Without either it is three over the number of answers, which an error rate
        exceeds with a chance of 5 % when no error is seen.
        """
        if not self.answers:
            return 1.0
        if self.errors:
            return self.errors / self.answers
        return self.bound if self.bound is not None else min(1.0, 3 / self.answers)

    @property
    def is_estimate(self) -> bool:
        """Whether no error was seen and none is excluded: the rate is only the most it may be."""
        return not self.errors and self.bound is None and not self.is_proof

    @property
    def time(self) -> float:
        """The median time for a statement, in seconds."""
        return median(self.seconds)

    @property
    def spread(self) -> tuple[float, float]:
        """The times between which eight of ten lie."""
        if len(self.seconds) < 2:
            return self.time, self.time
        deciles = quantiles(self.seconds, n=10, method="inclusive")
        return deciles[0], deciles[-1]

    @property
    def words(self) -> str:
        """What went wrong, in a few words; empty if nothing did."""
        counts = (
            (self.false_accepts, "false accepted"),
            (self.false_rejects, "true rejected"),
            *((count, reason) for reason, count in sorted(self.reasons.items())),
        )
        return ", ".join(f"{count} {words}" for count, words in counts if count)


def summaries(rows: Iterable[Row]) -> list[Summary]:
    """One summary a method, in the order in which they were measured."""
    found: dict[str, Summary] = {}
    for row in rows:
        if row["verdict"] == LEFT_OUT:
            continue
        found.setdefault(row["method"], Summary(row["method"])).add(row)
    return list(found.values())


def pareto(found: Sequence[Summary]) -> list[Summary]:
    """The methods than which none is both faster and surer, the fastest first."""
    timed = sorted((s for s in found if s.seconds), key=lambda s: (s.time, _level(s)))
    front: list[Summary] = []
    for summary in timed:
        if not front or _level(summary) < _level(front[-1]):
            front.append(summary)
    return front


def _level(summary: Summary) -> float:
    return 0.0 if summary.is_proof else summary.rate


def _reason(row: Row) -> str:
    if row["verdict"] == NONE:
        return "without answer"
    return f"over {row['reason']}" if row["verdict"] == "timeout" else "failed"
