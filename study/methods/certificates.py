"""What reads certificates: the checker, and the programs to which they are exported."""

from __future__ import annotations

import json
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory

from kowalevski_cas.export import Format, witness
from kowalevski_cas.export.polynomials import Polynomials
from kowalevski_cas.problem import checker
from kowalevski_cas.processes import each
from study.labelled import Labelled
from study.methods.method import ACCEPTED, NONE, REJECTED, Method, certificate
from study.step import Measured

STARTED = "started"
"""The verdict of a measurement that asks for nothing but the start of a program."""

TAUTOLOGY = {
    "claim": "start",
    "digest": "",
    "spaces": [{"variables": ["x"], "steps": []}],
    "goals": [{"goal": "follows", "space": 0, "given": [], "conclusions": [[["x", "x"]]]}],
    "sign": "holds",
    "evidence": [{"point": {"roots": [], "values": [["x", 1]]}}],
}
"""A certificate that x = x."""

REFUSALS = ("the two sides are not equal", "fails: ")
"""How a reader that decides says no; of others, no proof is no answer."""


def answer(reason: str) -> Measured:
    """The verdict of a reader that has nothing against a certificate, or a reason."""
    if not reason:
        return {"verdict": ACCEPTED}
    if any(words in reason for words in REFUSALS):
        return {"verdict": REJECTED}
    return {"verdict": NONE, "reason": reason}


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


class ExportProgram(Method):
    """Another program reads an export, in a process for each statement.

    Raises ``MissingTool`` if the program is not installed.
    """

    proves = True

    def __init__(self, name: str, format: Format, share: int | None = None) -> None:
        super().__init__(name, share)
        self.format = format
        if isinstance(format, Polynomials):
            format.trusting = True
        self.call = format.tool.call()

    @cached_property
    def _folder(self) -> TemporaryDirectory[str]:
        """Where the files are, with those on which all others rest."""
        folder = TemporaryDirectory()
        for file, text in self.format.shared().items():
            path = Path(folder.name) / file
            path.write_text(text, encoding="utf-8")
            self._run(path)
        return folder

    @property
    def _path(self) -> Path:
        return Path(self._folder.name) / f"claim{self.format.suffix}"

    def prepare(self, one: Labelled) -> str:
        text = self.format.translate(json.loads(certificate(one)))
        self._path.write_text(text, encoding="utf-8")
        return text

    def start(self) -> Measured:
        """What the start of the program takes: the time for x = x."""
        self._path.write_text(self.format.translate(TAUTOLOGY), encoding="utf-8")
        (measured,) = each(self._time, [self._path.read_text(encoding="utf-8")])
        if measured["verdict"] != ACCEPTED:
            raise RuntimeError(f"{self.name} does not know that x = x: {measured.get('reason')}")
        return {**measured, "verdict": STARTED}

    def answer(self, prepared: str) -> Measured:
        code, said = self._run(self._path)
        return answer(said.strip()[-80:] if code else self.format.objection(prepared, said))

    def _run(self, path: Path) -> tuple[int, str]:
        return witness.answer([*self.call, *self.format.arguments(path)], path.parent)
