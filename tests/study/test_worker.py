from __future__ import annotations

import subprocess

import pytest

from study.race import race
from study.worker import Worker

TOYS = "tests.study.toys"


@pytest.fixture
def worker(request):
    with Worker(f"{TOYS}:{request.param}", seconds=2.0, mebibytes=400) as worker:
        yield worker


@pytest.mark.parametrize("worker", ["double"], indirect=True)
def test_a_process_answers_more_than_once(worker):
    answers = [worker.ask(question) for question in (1, 2)]
    assert [answer["answer"] for answer in answers] == [2, 4]
    assert all(answer["seconds"] >= 0 and answer["memory"] > 2**20 for answer in answers)


@pytest.mark.parametrize("worker", ["sleep"], indirect=True)
def test_a_limit_of_time_is_a_timeout_and_the_next_question_is_answered(worker):
    worker.seconds = 0.5
    late = worker.ask(30)
    assert late["verdict"] == "timeout" and late["reason"] == "0.5 s"
    worker.seconds = 5
    assert worker.ask(0)["verdict"] == "proved"


@pytest.mark.parametrize("worker", ["swell"], indirect=True)
def test_a_limit_of_memory_is_a_timeout_with_that_reason(worker):
    assert worker.ask(1)["verdict"] == "proved"
    assert worker.ask(10_000) | {"seconds": 0, "memory": 0} == {
        "verdict": "timeout", "reason": "400 MiB", "seconds": 0, "memory": 0,
    }  # fmt: skip


@pytest.mark.parametrize("worker", ["fail"], indirect=True)
def test_an_error_is_said(worker):
    assert worker.ask("so it is")["reason"] == "ValueError: so it is"


@pytest.mark.parametrize("worker", ["sleep"], indirect=True)
def test_an_interruption_ends_the_process(worker, monkeypatch):
    worker.ask(0)
    process, pipe = worker._running

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(pipe, "poll", interrupted)
    with pytest.raises(KeyboardInterrupt):
        worker.ask(30)
    assert process.exitcode < 0


@pytest.mark.parametrize("worker", ["end"], indirect=True)
def test_a_process_that_ends_is_an_error_and_the_next_question_is_answered(worker):
    assert worker.ask(7)["reason"] == "the process ended with 7"
    assert worker.ask(0)["verdict"] == "proved"


def test_an_interruption_ends_a_race(tmp_path, monkeypatch):
    started = []
    popen = subprocess.Popen

    def interrupted(*_):
        raise KeyboardInterrupt

    def start(*arguments, **options):
        started.append(popen(*arguments, **options))
        return started[0]

    monkeypatch.setattr("subprocess.Popen", start)
    monkeypatch.setattr("study.race.Timer", interrupted)
    with pytest.raises(KeyboardInterrupt):
        race(["sleep", "30"], tmp_path, 20, 1000)
    assert started[0].wait(5) < 0
