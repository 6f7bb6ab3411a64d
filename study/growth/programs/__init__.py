"""The growing work as a program, in the best words of each that is compared."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

from kowalevski_cas.tools import TOOLS
from study.machine import GIAC

if TYPE_CHECKING:
    from study.growth.formulation import Formulation

_HERE = Path(__file__).parent

LIBRARIES = ("python-flint", "sympy", "symengine")


@dataclass(frozen=True)
class ProgramFile:
    """How a program is called with a file, and the file, where names stand for polynomials."""

    template: str
    call: Callable[[str], Sequence[str]]


def _maxima(file: str) -> Sequence[str]:
    run = f'errcatch(batchload("{file}"))$ quit()$'
    return *TOOLS["maxima"].call(), "--very-quiet", "--run-string", run


PROGRAMS = {
    "singular": ProgramFile(
        "singular.sing",
        lambda file: (*TOOLS["singular"].call(), "--quiet", "--no-rc", "--no-warn", file),
    ),
    "pari": ProgramFile(
        "pari.gp",
        lambda file: (*TOOLS["pari"].call(), "--quiet", "--fast", "--default", "parisize=2G", file),
    ),
    "maxima": ProgramFile("maxima.mac", _maxima),
    "giac": ProgramFile("giac.xws", lambda file: (*GIAC.call(), file)),
}


def write_program(name: str, work: Formulation, most: int, folder: Path) -> Sequence[str]:
    """Write the work of so many steps for a program, or a library, and return the command.

    Raises:
        MissingTool: the program is not installed.
    """
    if name in LIBRARIES:
        file = folder / "growth.json"
        file.write_text(json.dumps(work.words("**") | {"most": str(most)}), encoding="utf-8")
        return sys.executable, str(_HERE / "libraries.py"), name, file.name
    program = PROGRAMS[name]
    file = folder / program.template
    template = Template((_HERE / program.template).read_text(encoding="utf-8"))
    file.write_text(template.substitute(work.words("^"), most=most), encoding="utf-8")
    return program.call(file.name)
