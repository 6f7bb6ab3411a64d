"""Certificates in the languages of other programs."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.export import Inexpressible, load
from kowalevski_cas.tools import TOOLS

PAPER = "bobenko_reyman_semenov1989"
"""A paper whose certificates have several roots of numbers."""

HANDWRITTEN = Path(__file__).parents[1] / "problem" / "handwritten"


@pytest.mark.slow
def test_each_claim_has_a_file_and_what_is_left_out_is_named(tmp_path, capsys):
    assert main(["export", "rocq", "kharlamov2002", "-o", str(tmp_path)]) == 0
    out, err = capsys.readouterr()
    files = {path.name for path in (tmp_path / "kharlamov2002").iterdir()}
    shared = load("rocq").shared().keys()
    assert shared | {"eq14.v", "F1_prime.v", "corrected_eq21.v", "_CoqProject"} <= files
    left_out = [line for line in err.splitlines() if ": left out: " in line]
    told = len(files - shared - {"_CoqProject"})
    assert f"kharlamov2002: {told} of {told + len(left_out)} certificates" in out


def test_an_export_is_always_the_same_and_rocq_is_told_how_to_build_all_its_files(small, tmp_path):
    first, second = folders = [tmp_path / name / "kharlamov2002" for name in "ab"]
    for folder in folders:
        main(["export", "rocq", str(small), "-o", str(folder.parent)])
    files = {path.name: path.read_bytes() for path in first.iterdir()}
    assert files == {path.name: path.read_bytes() for path in second.iterdir()}
    *options, last = (first / "_CoqProject").read_text(encoding="utf-8").partition("Expressions.v")
    assert options == ['-Q . ""\n-arg -w\n-arg none\n', "Expressions.v"]
    assert {"Expressions.v", *last.split()} == {name for name in files if name.endswith(".v")}


@pytest.mark.slow
def test_an_export_is_the_same_whatever_the_order_of_sets(tmp_path):
    found = []
    for seed in "12":
        command = (sys.executable, "-m", "kowalevski_cas", "export", "pari", PAPER, "-o", seed)
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.getcwd()}
        subprocess.run(command, cwd=tmp_path, env=environment, check=True, capture_output=True)
        files = (tmp_path / seed / PAPER).iterdir()
        found.append({path.name: path.read_text(encoding="utf-8") for path in files})
    assert found[0] == found[1]


@pytest.mark.parametrize("name", TOOLS)
@pytest.mark.parametrize("file", ["kernel", "denied-kernel"])
def test_ranks_modulo_a_prime_are_left_out_by_all(name, file):
    text = (HANDWRITTEN / f"{file}.json").read_text(encoding="utf-8")
    with pytest.raises(Inexpressible, match="ranks modulo a prime"):
        load(name).translate(json.loads(text))
