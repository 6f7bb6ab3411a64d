from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from study.process import race
from tests.sample import sampled


def script(text, seconds=10.0, mebibytes=2048):
    return race([sys.executable, "-c", text], Path.cwd(), seconds, mebibytes, 2)


def test_steps_come_with_their_time_and_memory():
    work = "end = time.process_time() + 0.1\nwhile time.process_time() < end: pass"
    found = script(f"import time; print('step', 1, flush=True)\n{work}\nprint('step', 2)")
    assert (found["verdict"], found["steps"]) == ("reached", [1, 2])
    first, second = found["times"]
    assert first is None or second > first


def test_fewer_steps_are_no_success():
    assert script("print('step', 1)")["verdict"] == "stopped"


@pytest.mark.slow
@pytest.mark.parametrize("idle", sampled(["exec sleep 60", "while :; do :; done"], 1))
def test_time_is_a_limit(idle):
    found = race(["sh", "-c", f"echo step 1; {idle}"], Path.cwd(), 0.3, 2048, 2)
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
        race(["sleep", "30"], Path.cwd(), 20, 1000, 2)
    assert started[0].wait(5) < 0
