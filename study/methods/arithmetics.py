"""The arithmetics of this program: exact ones, and those that look at points."""

from __future__ import annotations

import subprocess
import sys
from time import perf_counter

from kowalevski_cas.algebra import load, load_points
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.proof.screen import screen
from study.labelled import Labelled, holds
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.step import Measured

SEED = 2002


class ExactArithmetic(Method):
    """Polynomials: the residual of a statement is brought to its only form."""

    proves = True

    def prepare(self, statement: Labelled) -> Labelled:
        load(self.name)
        return statement

    def answer(self, prepared: Labelled) -> Measured:
        true = holds(prepared, Bench(self.name, prepared.texts, refute=False))
        return {"verdict": ACCEPTED if true else REJECTED}

    def cold(self, statement: Labelled) -> float:
        """How long the command line takes for one claim, and what it rests on."""
        name, claim = statement.id.split("/")[:2]
        command = [sys.executable, "-m", "kowalevski_cas", "verify", name, "--only", claim]
        start = perf_counter()
        subprocess.run(
            [*command, "--arithmetic", self.name],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            check=False,
        )
        return perf_counter() - start


class PointArithmetic(ExactArithmetic):
    """Statements are screened as ``verify --arithmetic`` does it: what is accepted is likely."""

    proves = False

    def prepare(self, statement: Labelled) -> Labelled:
        load_points(self.name, SEED)
        return statement

    def answer(self, prepared: Labelled) -> Measured:
        points = load_points(self.name, SEED)
        finding = screen(prepared.claim, Bench(self.name, prepared.texts), points)
        refuted = finding.verdict is Verdict.REFUTED
        verdict = ACCEPTED if finding.verdict.likely else REJECTED if refuted else NONE
        measured = {"verdict": verdict, "reason": finding.message}
        return measured | ({} if finding.chance is None else {"bound": finding.chance})
