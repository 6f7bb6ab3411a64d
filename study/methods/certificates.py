"""What reads certificates: the checker, the programs to which they are exported, SymPy by hand."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import Any

from kowalevski_cas.export import Format
from kowalevski_cas.export.polynomials import Polynomials
from kowalevski_cas.problem import checker
from study.labelled import Labelled
from study.methods.method import ACCEPTED, NONE, REJECTED, Method, certificate
from study.step import Measured
from study.worker import Worker, asked

REFUSALS = ("the two sides are not equal", "fails: ")
"""How a reader that decides says no; of others, no proof is no answer."""

TARGET = "study.methods.typed:decide"
CALLS = ("simplify", "expand", "cancel", "ratsimp", "equals")
SECONDS, MEBIBYTES = 10.0, 2048
"""The limits of SymPy, for a statement."""


def answer(reason: str) -> Measured:
    """The verdict of a reader that has nothing against a certificate, or a reason."""
    refused = any(words in reason for words in REFUSALS)
    return {"verdict": REJECTED if refused else NONE if reason else ACCEPTED, "reason": reason}


class Checker(Method):
    """The independent checker, in pure Python."""

    proves = True

    def prepare(self, one: Labelled) -> str:
        return certificate(one)

    def answer(self, prepared: str) -> Measured:
        try:
            checker.check(prepared)
        except checker.Rejected as error:
            return answer(str(error.args[0]))
        return answer("")

    def cold(self, one: Labelled) -> float:
        with TemporaryDirectory() as folder:
            file = Path(folder) / f"{one.statement.claim.id}.json"
            file.write_text(certificate(one), encoding="utf-8")
            start = perf_counter()
            subprocess.run(
                [sys.executable, "-I", "-S", checker.__path__[0], str(file)],
                stdout=subprocess.DEVNULL,
                check=True,
            )
            return perf_counter() - start


class Program(Method):
    """Another program reads an export; a process for each statement, warm or cold.

    Raises ``MissingSystem`` if the program is not installed.
    """

    proves = True

    def __init__(self, name: str, format: Format, share: int | None = None) -> None:
        super().__init__(name, share)
        self.format = format
        if isinstance(format, Polynomials):
            format.trusting = True
        self.call = format.system.call()
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

    def prepare(self, one: Labelled) -> str:
        text = self.format.translate(json.loads(certificate(one)))
        self._path.write_text(text, encoding="utf-8")
        return text

    def answer(self, prepared: str) -> Measured:
        done = self._run(self._path)
        said = done.stdout.decode("utf-8", "replace")
        failed = said.strip()[-80:]
        return answer(failed if done.returncode else self.format.objection(prepared, said))

    @property
    def _path(self) -> Path:
        return self.folder / f"claim{self.format.suffix}"

    def _run(self, path: Path) -> subprocess.CompletedProcess[bytes]:
        return subprocess.run(
            [*self.call, *self.format.arguments(path)],
            cwd=path.parent,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            check=False,
        )

    def cold(self, one: Labelled) -> float:
        return float(self.decide(one)["seconds"])


class ByHand(Method):
    """One of the calls with which people ask SymPy whether something is zero."""

    def __init__(self, call: str, share: int | None = None) -> None:
        super().__init__(f"SymPy {call}", share)
        self.call = call
        self._worker = Worker(TARGET, SECONDS, MEBIBYTES)

    def prepare(self, one: Labelled) -> dict[str, Any]:
        return {"method": self.call, "certificate": json.loads(certificate(one))}

    def answer(self, prepared: dict[str, Any]) -> Measured:
        return self._worker.ask(prepared)

    def cold(self, one: Labelled) -> float:
        start = perf_counter()
        asked(TARGET, 4 * SECONDS, MEBIBYTES, self.prepare(one))
        return perf_counter() - start
