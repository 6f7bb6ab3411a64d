"""SymPy's general simplifiers on formulas with roots, each in a process under a limit."""

from __future__ import annotations

import json
from time import perf_counter

from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import CertificateError
from study.labelled import Labelled
from study.methods.certificates import certificate
from study.methods.method import NONE, Method
from study.step import Measured
from study.worker import Worker

TARGET = "study.methods.typed:decide"
CALLS = ("simplify", "expand", "cancel", "ratsimp", "equals")
SECONDS = 10.0
MEBIBYTES = 2048


class ByHand(Method):
    """One of the calls with which people ask SymPy whether something is zero."""

    def __init__(self, call: str, share: int | None = None) -> None:
        super().__init__(f"SymPy {call}", share)
        self.call = call
        self._worker = Worker(TARGET, SECONDS, MEBIBYTES)

    def decide(self, statement: Labelled) -> Measured:
        try:
            data = json.loads(certificate(statement))
        except (CertificateError, checker.Rejected) as error:
            return {"seconds": None, "verdict": NONE, "reason": str(error.args[0])}
        return self._worker.ask({"method": self.call, "certificate": data})

    def cold(self, statement: Labelled) -> float:
        data = json.loads(certificate(statement))
        with Worker(TARGET, 4 * SECONDS, MEBIBYTES) as worker:
            start = perf_counter()
            worker.ask({"method": self.call, "certificate": data})
            return perf_counter() - start
