"""The arithmetics that look at points: what they accept is probable, or enclosed, or hoped for."""

from __future__ import annotations

from time import perf_counter

from kowalevski_cas.arithmetic import load_points
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.proof.limits import time_limit
from kowalevski_cas.proof.outcome import Verdict
from kowalevski_cas.proof.screen import screen
from study.labelled import Labelled
from study.methods.arithmetics import SECONDS, by_process
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.step import Measured

SEED = 2002


class PointArithmetic(Method):
    """Statements are screened as ``verify --arithmetic`` does it."""

    def decide(self, statement: Labelled) -> Measured:
        points = load_points(self.name, SEED)
        start = perf_counter()
        try:
            with time_limit(SECONDS):
                finding = screen(statement.claim, Bench(self.name, statement.texts), points)
        except TimeoutError:
            return {"seconds": SECONDS, "verdict": "timeout", "reason": f"{SECONDS:g} s"}
        seconds = perf_counter() - start
        refuted = finding.verdict is Verdict.REFUTED
        verdict = ACCEPTED if finding.verdict.likely else REJECTED if refuted else NONE
        measured = {"seconds": seconds, "verdict": verdict, "reason": finding.message}
        return measured | ({} if finding.chance is None else {"bound": finding.chance})

    def cold(self, statement: Labelled) -> float:
        return by_process(statement, self.name)
