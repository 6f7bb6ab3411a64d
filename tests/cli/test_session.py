"""What the commands share: runs in several processes, and what is kept of an interrupted search."""

import json
import os
import subprocess
import sys
from argparse import Namespace
from functools import partial
from pathlib import Path

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli import main
from kowalevski_cas.cli.session import pool, rejections, runs
from kowalevski_cas.library import available, find, load
from kowalevski_cas.processes import each
from kowalevski_cas.verify.certificate import FOLDER, load_certificates
from kowalevski_cas.verify.committed import certificate_files

PAPER = load_certificates(find("kharlamov2002"))

CIRCLE = """
from kowalevski_cas import System
circle = System(r"\\dot x=y, \\dot y=-x")
circle.integral("x^2+y^2")
"""


@pytest.mark.slow
def test_however_many_processes_decide_the_outcomes_are_the_same(monkeypatch, capsys):
    found = []
    for jobs in (1, 3):
        monkeypatch.setattr("kowalevski_cas.verify.run.each", partial(each, jobs=jobs))
        chosen = [f"--only={id}" for id in ("eq10.1", "eq14", "eq12", "eq21")]
        main(["verify", "kharlamov2002", "--format=json", *chosen])
        found.append(json.loads(capsys.readouterr().out, object_hook=untimed))
    assert found[0] == found[1]


@pytest.mark.slow
def test_outcomes_do_not_depend_on_the_order_of_sets():
    """Strings are hashed differently in each process; two of these seeds once gave two orders."""
    command = [sys.executable, "-m", "kowalevski_cas", "verify", "bobenko_reyman_semenov1989"]
    found = [
        subprocess.run(
            [*command, "--format=json"], env={**os.environ, "PYTHONHASHSEED": seed},
            cwd=Path(__file__).parents[2], capture_output=True, check=True,
        ).stdout
        for seed in "01"
    ]  # fmt: skip
    first, second = (json.loads(text, object_hook=untimed) for text in found)
    assert first == second


def untimed(data):
    return {key: value for key, value in data.items() if key != "seconds"}


def test_what_was_found_of_another_state_of_a_derivation_is_not_taken(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    file, folder = tmp_path / "circle.py", tmp_path / "circle.evidence"
    folder.mkdir()
    file.write_text(CIRCLE)

    def kept():
        return pool(Namespace(jobs=1, scheduler="", seed=1), [folder]).file

    first = kept()
    assert kept() == first
    os.utime(file, ns=(1, 1))
    assert (second := kept()) != first
    (folder / "record.json").write_text("{}")
    assert kept() not in (first, second)


@pytest.mark.slow
@pytest.mark.parametrize("name", available())
def test_what_is_found_anew_is_what_is_committed(name):
    folder = find(name)
    ((run, _),) = runs([(folder, load(name))], EXACT, timeout=600, stored=[{}])
    committed = {
        file.relative_to(folder / FOLDER).with_suffix("").as_posix(): file.read_text("utf-8")
        for file in certificate_files(folder)
    }
    assert run.certificates == committed and not rejections(run)
