"""The arithmetics of this program: exact ones, and those that look at points."""

from __future__ import annotations

import subprocess
import sys
from time import perf_counter

from kowalevski_cas.arithmetic import load
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.proof.limits import time_limit
from study.labelled import Labelled, holds
from study.methods.method import ACCEPTED, REJECTED, Method
from study.step import Measured

SECONDS = 20.0


def by_process(statement: Labelled, arithmetic: str) -> float:
    """How long the command line takes for one claim, and what it rests on."""
    name, claim = statement.id.split("/")[:2]
    start = perf_counter()
    command = [sys.executable, "-m", "kowalevski_cas", "verify", name]
    subprocess.run(
        [*command, "--only", claim, "--arithmetic", arithmetic],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=False,
    )
    return perf_counter() - start


class ExactArithmetic(Method):
    """Polynomials: the residual of a statement is brought to its only form."""

    proves = True

    def decide(self, statement: Labelled) -> Measured:
        load(self.name)
        start = perf_counter()
        try:
            with time_limit(SECONDS):
                true = holds(statement, Bench(self.name, statement.texts, refute=False))
        except TimeoutError:
            return {"seconds": SECONDS, "verdict": "timeout", "reason": f"{SECONDS:g} s"}
        seconds = perf_counter() - start
        return {"seconds": seconds, "verdict": ACCEPTED if true else REJECTED, "reason": ""}

    def cold(self, statement: Labelled) -> float:
        return by_process(statement, self.name)
