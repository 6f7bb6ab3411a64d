from __future__ import annotations

import sys
from pathlib import Path

import pytest

from study import process
from study.process import Worker, race

TOYS = [sys.executable, "-m", "tests.study.toys"]


@pytest.fixture
def worker():
    worker = Worker(TOYS, seconds=2.0, mebibytes=400)
    yield worker
    worker.close()


def test_a_process_answers_more_than_once(worker):
    answers = [worker.ask(["double", number]) for number in (1, 2)]
    assert [answer["answer"] for answer in answers] == [2, 4]
    assert all(answer["seconds"] >= 0 for answer in answers)


def test_a_limit_of_time_is_a_timeout_and_the_next_question_is_answered(worker):
    worker.seconds = 0.5
    late = worker.ask(["sleep", 30])
    assert (late["verdict"], late["reason"]) == ("timeout", "0.5 s")
    worker.seconds = 5
    assert worker.ask(["sleep", 0])["verdict"] == "proved"


def test_a_limit_of_memory_is_a_timeout_with_that_reason(worker):
    assert worker.ask(["swell", 1])["verdict"] == "proved"
    much = worker.ask(["swell", 10_000])
    assert (much["verdict"], much["reason"]) == ("timeout", "400 MiB")


def test_an_error_is_said_whatever_a_library_prints(worker):
    assert worker.ask(["fail", "so it is"])["reason"] == "ValueError: so it is"


def test_a_process_that_ends_is_an_error_and_the_next_question_is_answered(worker):
    assert worker.ask(["end", 7])["reason"] == "the process ended with 7"
    assert worker.ask(["end", 7])["verdict"] == "error"
    assert worker.ask(["double", 1])["verdict"] == "proved"


@pytest.mark.parametrize("run", [
    lambda: Worker(TOYS, 20, 1000).ask(["sleep", 30]),
    lambda: race(["sleep", "30"], Path.cwd(), 20, 1000),
])  # fmt: skip
def test_an_interruption_ends_the_process(run, monkeypatch):
    started, start = [], process.start

    def kept(*arguments):
        started.append(start(*arguments))
        return started[-1]

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(process, "Timer", interrupted)
    monkeypatch.setattr(process, "start", kept)
    with pytest.raises(KeyboardInterrupt):
        run()
    assert started[0].wait(5) < 0


def script(text, seconds=10.0, mebibytes=2048):
    return race([sys.executable, "-c", text], Path.cwd(), seconds, mebibytes)


def test_steps_come_with_their_time_and_memory():
    found = script("for k in (1, 2): print('step', k, 0.5 * k)")
    assert (found["verdict"], found["steps"], found["times"]) == ("reached", [1, 2], [0.5, 1.0])


def test_time_is_a_limit():
    found = script("import time; print('step 1 0', flush=True); time.sleep(60)", seconds=1.0)
    assert (found["verdict"], found["reason"], found["steps"]) == ("timeout", "1 s", [1])


def test_memory_is_a_limit():
    found = script("x = bytearray(10**9)", mebibytes=300)
    assert (found["verdict"], found["reason"]) == ("timeout", "300 MiB")


def test_an_error_is_no_success():
    assert script("import sys; sys.exit(3)")["reason"] == "exit code 3"
    assert script("print('fails')")["verdict"] == "stopped"
