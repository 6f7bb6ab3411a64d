"""Proving loads no library that the chosen arithmetic does not need."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from kowalevski_cas.arithmetic import EXACT, POINTS
from kowalevski_cas.library import available

LIBRARIES = {"flint", "symengine", "sympy", "numpy", "scipy", "matplotlib"}

NEEDED = {
    "flint": {"flint"},
    "symengine": {"symengine", "numpy"},  # its wrapper imports NumPy by itself
    "sympy": {"sympy"},
    "modular": {"flint"},
    "ball": {"flint"},
    "floating": {"flint", "numpy"},
}
"""Points take what the scene says from FLINT, which derives it."""

ONLY = ["eq6", "eq12", "F2-prime", "eq18", "eq21"]

PROVE = """
import sys
from kowalevski_cas.library import find, load
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.proof.verify import verify
kept = load_evidence(find("kharlamov2002"))
run = verify(load("kharlamov2002"), (sys.argv[1],), sys.argv[2:], evidence=kept)
assert all(o.verdict.likely or o.correction is not None for o in run.outcomes), run.outcomes
print(*sys.modules)
"""


def modules(script, *arguments):
    """The top names of the modules that a script has loaded in a process of its own."""
    root = Path(__file__).parents[1]
    done = subprocess.run(
        [sys.executable, "-c", script, *arguments],
        capture_output=True, text=True, cwd=root, check=True,
    )  # fmt: skip
    return {name.split(".")[0] for name in done.stdout.split()}


def test_importing_loads_no_library():
    loaded = modules(
        "import sys, kowalevski_cas.cli, kowalevski_cas.claims, kowalevski_cas.proof.verify,"
        "study, kowalevski_cas.pictures; print(*sys.modules)"
    )
    assert "kowalevski_cas" in loaded and not loaded & LIBRARIES


@pytest.mark.parametrize("name", [*EXACT, *POINTS])
def test_proving_loads_what_its_arithmetic_needs_and_nothing_else(name):
    assert modules(PROVE, name, *ONLY) & LIBRARIES == NEEDED[name]


def test_the_package_names_no_derivation():
    named = [
        (file.name, node.lineno)
        for file in (Path(__file__).parents[1] / "kowalevski_cas").rglob("*.py")
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant) and node.value in available()
    ]
    assert named == []
