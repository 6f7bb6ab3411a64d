"""What reads certificates: the checker, and the programs to which they are exported."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.export import Format, Inexpressible
from kowalevski_cas.export.witness import command
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.certificate import stated
from kowalevski_cas.proof.limits import time_limit
from kowalevski_cas.proof.trees import CertificateError
from study.labelled import Labelled
from study.methods.method import ACCEPTED, NONE, REJECTED, Method
from study.step import Measured

SECONDS = 20

REFUSALS = ("the two sides are not equal", "fails: ")
"""How a reader that decides says no; of others, no proof is no answer."""


def answer(seconds: float, reason: str) -> Measured:
    """The verdict of a reader that has nothing against a certificate, or a reason."""
    refused = any(words in reason for words in REFUSALS)
    verdict = REJECTED if refused else NONE if reason else ACCEPTED
    return {"seconds": seconds, "verdict": verdict, "reason": reason}


def certificate(statement: Labelled) -> str:
    """What the certificate of a statement would be, were it true; made with FLINT."""
    return stated(statement.claim, Bench("flint", statement.texts, refute=False))


class Checker(Method):
    """The independent checker, in pure Python."""

    proves = True

    def decide(self, statement: Labelled) -> Measured:
        try:
            text = certificate(statement)
        except (CertificateError, checker.Rejected) as error:
            return {"seconds": None, "verdict": NONE, "reason": str(error.args[0])}
        start = perf_counter()
        reason = ""
        try:
            with time_limit(SECONDS):
                checker.check(text)
        except checker.Rejected as error:
            reason = str(error.args[0])
        except TimeoutError:
            return {"seconds": SECONDS, "verdict": "timeout", "reason": f"{SECONDS} s"}
        return answer(perf_counter() - start, reason)

    def cold(self, statement: Labelled) -> float:
        with TemporaryDirectory() as folder:
            file = Path(folder) / f"{statement.claim.id}.json"
            file.write_text(certificate(statement), encoding="utf-8")
            start = perf_counter()
            subprocess.run(
                [sys.executable, "-I", "-S", checker.__file__, str(file)],
                stdout=subprocess.DEVNULL,
                check=True,
            )
            return perf_counter() - start


class Program(Method):
    """Another program reads an export; a process for each statement, warm or cold."""

    proves = True

    def __init__(self, name: str, format: Format, share: int | None = None) -> None:
        super().__init__(name, share)
        self.format = format
        self.call = command(format)
        self._folder: TemporaryDirectory[str] | None = None

    @property
    def folder(self) -> Path:
        """Where the files are, with those on which all others rest."""
        if self._folder is None:
            self._folder = TemporaryDirectory()
            for file, text in self.format.shared().items():
                path = Path(self._folder.name) / file
                path.write_text(text, encoding="utf-8")
                self._run(path)
        return Path(self._folder.name)

    def decide(self, statement: Labelled) -> Measured:
        try:
            text = self.format.translate(json.loads(certificate(statement)))
        except (CertificateError, Inexpressible, checker.Rejected) as error:
            return {"seconds": None, "verdict": NONE, "reason": str(error.args[0])}
        path = self.folder / f"claim{self.format.suffix}"
        path.write_text(text, encoding="utf-8")
        start = perf_counter()
        try:
            done = self._run(path)
        except subprocess.TimeoutExpired:
            return {"seconds": SECONDS, "verdict": "timeout", "reason": f"{SECONDS} s"}
        seconds = perf_counter() - start
        said = done.stdout.decode("utf-8", "replace")
        reason = said.strip()[-80:] if done.returncode else self.format.objection(text, said)
        return answer(seconds, reason)

    def _run(self, path: Path) -> subprocess.CompletedProcess[bytes]:
        return subprocess.run(
            [*self.call, *self.format.arguments(path)],
            cwd=path.parent,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=SECONDS,
            check=False,
        )

    def cold(self, statement: Labelled) -> float:
        return float(self.decide(statement)["seconds"])
