"""Certificates for Rocq, formerly Coq: it differentiates and proves, this only prints.

Every space becomes a module with its definitions as expressions, every equation that
holds a theorem over any field in which what it divides by is not zero, every point a
theorem about numbers that Rocq computes. What is proved may rest on no axiom.
"""

from __future__ import annotations

from collections.abc import Iterable
from copy import deepcopy
from importlib.resources import files
from pathlib import Path
from typing import ClassVar

from kowalevski_cas.export.format import Format, Inexpressible, Json, identifier
from kowalevski_cas.export.rocq.space import Space
from kowalevski_cas.export.rocq.theorems import KINDS, Theorems, foundations, instances
from kowalevski_cas.problem import checker
from kowalevski_cas.tools import TOOLS

HEAD = """\
(** {title}: the formulas as they are printed, and what holds of them.

    Generated from a certificate. Before it, coqc has to read {shared}.

    Where something is claimed to exist, theorems are about the values found for it. Where one
    of several conclusions holds, products of their differences vanish. *)

From Coq Require Import ZArith QArith Field_theory List.
Require Import {modules}.
Import ListNotations.
Open Scope expr_scope.
"""

FIELD = """\
(** Values are taken in any field. *)

Section Claims.

Variable R : Type.
Variables zero one : R.
Variables add mul sub : R -> R -> R.
Variable opp : R -> R.
Variable div : R -> R -> R.
Variable inv : R -> R.
Variable R_field : field_theory zero one add mul sub opp div inv (@eq R).
Variable v : nat -> R.
Notation val := (value R zero one add mul opp div v).
"""

END = """\
End Claims.

Definition proved := ({names}).
Print Assumptions proved.
"""

SHARED = ("Expressions", "Values", "Identities", "Points")


class Program(Format):
    """Rocq 9, or Coq since 8.16.

    Where something exists, the theorems are about the values found for it; of several
    conclusions, of which one holds, they say that products of their differences vanish.

    It leaves out points whose coordinates are no Gaussian rational numbers, since their
    roots would have to be numbers that can be computed with, and what rests on them, but for
    identities, which are said without their point; and what needs an order or
    real numbers: numbers of solutions, and splits into cases, since
    squares that add up to zero vanish for real numbers only. Nor does it compute ranks modulo a
    prime.
    """

    tool: ClassVar = TOOLS["rocq"]
    suffix: ClassVar = ".v"

    def shared(self) -> dict[str, str]:
        names = [f"{name}.v" for name in SHARED]
        return {name: (files(__name__) / name).read_text(encoding="utf-8") for name in names}

    def project(self, names: Iterable[str]) -> dict[str, str]:
        options = ['-Q . ""', "-arg -w", "-arg none"]
        return {"_CoqProject": "\n".join([*options, *names, ""])}

    def translate(self, certificate: Json) -> str:
        try:
            return self._text(deepcopy(certificate))
        except checker.Rejected as error:
            raise Inexpressible(f"the checker says: {error.args[0]}") from None

    def _text(self, certificate: Json) -> str:
        ring = checker.Ring(checker.Budget(10 * checker.WORK))
        problem = checker.Problem(certificate["spaces"], certificate["goals"], ring)
        spaces: list[Space] = []
        for k, checked in enumerate(problem.spaces):
            spaces.append(Space(checked, k, spaces))
        sections = [*map(foundations, spaces)]
        for number, (goal, evidence, values, holds) in enumerate(instances(certificate), 1):
            staged = problem.stage(goal, evidence)
            space = spaces[goal["space"]].local(staged, f"goal_{number}", values)
            sections.append(section := Theorems(space))
            prove, deny = KINDS[goal["goal"]]
            (prove if holds else deny)(section, f"claim_{number}", goal, evidence)
        head = HEAD.format(
            title=identifier(certificate["claim"]),
            shared=", ".join(self.shared()),
            modules=" ".join(SHARED),
        )
        bodies = [section.text() for section in sections if section.names]
        modules = [space.module() for space in spaces]
        proved = ", ".join(name for section in sections for name in section.names)
        return "\n".join([head, *modules, FIELD, *bodies, END.format(names=proved)])

    def arguments(self, file: Path) -> list[str]:
        return ["-q", "-w", "none", "-Q", ".", "", file.name]

    def objection(self, text: str, output: str) -> str:
        closed = output.split() == "Closed under the global context".split()
        return "" if closed else f"the theorems are not closed: {' '.join(output.split())[:200]}"
