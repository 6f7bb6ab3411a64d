"""Certificates for Rocq, formerly Coq: it differentiates and proves, this only prints.

Every space becomes a module with its definitions as expressions, every equation that
holds a theorem over any field in which 2 is not zero, every refuted one a theorem about
two numbers that Rocq computes. Each theorem has to be closed under the global context.
"""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import ClassVar

from kowalevski_cas.export.format import Format, Json
from kowalevski_cas.export.rocq.theorems import Theorems

CLOSED = "Closed under the global context"


class Program(Format):
    """Rocq 9, or Coq since 8.16."""

    commands: ClassVar = (("coqc",), ("rocq", "compile"))
    package: ClassVar = "coq"
    suffix: ClassVar = ".v"
    omits: ClassVar = (
        "dimension and independence are left out: that a rank makes a set a manifold is analysis"
    )

    def shared(self) -> dict[str, str]:
        name = "Derivation.v"
        return {name: (files(__name__) / name).read_text(encoding="utf-8")}

    def translate(self, certificate: Json) -> str:
        return Theorems(certificate).text()

    def arguments(self, file: Path) -> list[str]:
        return ["-q", "-Q", ".", "", file.name]

    def objection(self, text: str, output: str) -> str:
        theorems, closed = text.count("\nPrint Assumptions "), output.count(CLOSED)
        if not theorems or closed != theorems or "Axioms:" in output:
            return f"{closed} of {theorems} theorems are closed under the global context"
        return ""
