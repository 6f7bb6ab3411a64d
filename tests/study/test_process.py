from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from study.process import race


def script(text, seconds=10.0, mebibytes=2048):
    return race([sys.executable, "-c", text], Path.cwd(), seconds, mebibytes)


def test_steps_come_with_their_time_and_memory():
    found = script("for k in (1, 2): print('step', k, 0.5 * k)")
    assert (found["verdict"], found["steps"], found["times"]) == ("reached", [1, 2], [0.5, 1.0])


@pytest.mark.parametrize("idle", ["exec sleep 60", "while :; do :; done"])
def test_time_is_a_limit(idle):
    found = race(["sh", "-c", f"echo step 1 0; {idle}"], Path.cwd(), 0.3, 2048)
    assert (found["verdict"], found["reason"], found["steps"]) == ("timeout", "0.3 s", [1])


def test_memory_is_a_limit():
    found = script("x = bytearray(10**9)", mebibytes=300)
    assert (found["verdict"], found["reason"]) == ("timeout", "300 MiB")


def test_an_error_is_no_success():
    assert script("import sys; sys.exit(3)")["reason"] == "exit code 3"
    assert script("print('fails')")["verdict"] == "stopped"


def test_an_interruption_ends_the_process(monkeypatch):
    started, popen = [], subprocess.Popen

    def kept(*arguments, **options):
        started.append(popen(*arguments, **options))
        return started[0]

    def interrupted(*_, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr("subprocess.Popen", kept)
    monkeypatch.setattr("study.process.Thread", interrupted)
    with pytest.raises(KeyboardInterrupt):
        race(["sleep", "30"], Path.cwd(), 20, 1000)
    assert started[0].wait(5) < 0
