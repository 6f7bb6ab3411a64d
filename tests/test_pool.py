"""Tasks in a pool: the results are those of a serial run, whatever happens to processes."""

import os
import signal
import subprocess
import sys
from functools import partial
from time import sleep

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.limits import ProcessDied
from kowalevski_cas.pool import Pool


def square(number):
    if number < 0:
        raise ValueError(f"{number} is negative")
    return number * number


def noted(file, number):
    """The square, with a line in a file for each time that it is computed."""
    with file.open("a") as stream:
        stream.write(f"{number}\n")
    return square(number)


def mortal(folder, number):
    """The square; 3 kills who computes it for the first time, unless it lives alone."""
    if number == 3 and not (folder / "killed").exists():
        (folder / "killed").touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return noted(folder / "done", number)


def met(folder, number):
    """Each of 1 and 2 waits until the other one has begun."""
    (folder / str(number)).touch()
    for _ in range(3000):
        if (folder / str(3 - number)).exists():
            return number
        sleep(0.02)
    raise TimeoutError(f"{3 - number} has not begun")


@pytest.fixture
def kept_at_once(monkeypatch):
    """The smallest task is worth a batch."""
    monkeypatch.setattr("kowalevski_cas.pool.BATCH", 0)


def deadly(number):
    os.kill(os.getpid(), signal.SIGKILL)


def taken(pool, work, items):
    """The results up to the first error, and that error."""
    found = []
    try:
        for result in pool.map(work, items):
            found.append(result)
    except ValueError as error:
        return found, str(error)
    return found, ""


def failing(numbers):
    """Items that end with an error if there are many."""
    for place, number in enumerate(numbers):
        if place > 5:
            raise ValueError("too many")
        yield number


@settings(max_examples=settings.default.max_examples // 3)
@given(st.lists(st.integers(-2, 100), max_size=9), st.sampled_from([2, 3]))
def test_the_results_are_those_of_a_serial_run(numbers, jobs):
    expected = taken(Pool(), square, failing(numbers))
    assert taken(Pool(jobs), square, failing(numbers)) == expected


def test_small_tasks_share_a_batch():
    pids = [*Pool(jobs=2).map(lambda _: os.getpid(), range(200))]
    assert os.getpid() not in pids and len({*pids}) < 20


def test_two_work_at_once(tmp_path):
    assert [*Pool(jobs=2).map(partial(met, tmp_path), [1, 2])] == [1, 2]


@pytest.mark.usefixtures("kept_at_once")
@pytest.mark.parametrize("jobs", [1, 2])
def test_interrupted_work_goes_on_from_what_is_kept(tmp_path, jobs):
    log, kept, numbers = tmp_path / "log", tmp_path / "kept", [1, 2, 3, -1, 4]
    found, said = taken(Pool(jobs, file=kept), partial(noted, log), numbers)
    assert (found, said) == ([1, 4, 9], "-1 is negative")
    pool = Pool(jobs, file=kept)
    log.write_text("")
    assert [*pool.map(partial(noted, log), [1, 2, 3, 4])] == [1, 4, 9, 16]
    assert {*log.read_text().split()} <= {"4"}
    pool.forget()
    assert not kept.exists()


@pytest.mark.usefixtures("kept_at_once")
def test_what_was_torn_when_it_was_kept_is_done_again(tmp_path):
    log, kept = tmp_path / "log", tmp_path / "kept"
    work = partial(noted, log)
    assert [*Pool(file=kept).map(work, [1, 2])] == [1, 4]
    kept.write_bytes(kept.read_bytes()[:-3])
    assert [*Pool(file=kept).map(work, [1, 2])] == [1, 4]
    assert [*Pool(file=kept).map(work, [1, 2])] == [1, 4]
    assert log.read_text().split() == ["1", "2", "2"]


@pytest.mark.usefixtures("kept_at_once")
def test_what_cannot_be_kept_is_done_all_the_same(tmp_path):
    (tmp_path / "file").touch()
    pool = Pool(file=tmp_path / "file" / "kept")
    assert [*pool.map(partial(noted, tmp_path / "log"), [1, 2])] == [1, 4]


@pytest.mark.usefixtures("kept_at_once")
def test_a_worker_that_dies_costs_its_batch_only(tmp_path):
    assert [*Pool(jobs=2).map(partial(mortal, tmp_path), range(6))] == [0, 1, 4, 9, 16, 25]
    assert sorted((tmp_path / "done").read_text().split()) == [*"012345"]


def test_a_batch_of_which_workers_die_again_is_an_error():
    with pytest.raises(ProcessDied, match="Killed"):
        [*Pool(jobs=2).map(deadly, [1])]


@pytest.mark.slow
def test_a_cluster_that_is_not_there_is_an_error(monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr("kowalevski_cas.pool.PATIENCE", 0.2)
    with pytest.raises(ProcessDied, match=r"no Dask scheduler answers at tcp://127.0.0.1:5"):
        [*Pool(scheduler="tcp://127.0.0.1:5").map(square, [1])]


@pytest.mark.slow
def test_a_cluster_without_workers_or_whose_workers_lack_the_package_says_so(tmp_path, monkeypatch):
    distributed = pytest.importorskip("distributed")
    without = tmp_path / "without.py"
    without.write_text("import sys\nsys.modules['kowalevski_cas'] = None\n")
    with distributed.LocalCluster(n_workers=0, dashboard_address=None) as cluster:
        address = cluster.scheduler_address
        monkeypatch.setattr("kowalevski_cas.pool.PATIENCE", 0.5)
        with pytest.raises(ProcessDied, match="has no workers: begin some with `dask worker tcp:"):
            [*Pool(scheduler=address).map(square, [1])]
        monkeypatch.undo()
        words = [sys.executable, "-m", "dask", "worker", address, "--no-dashboard", "--no-nanny"]
        with subprocess.Popen(
            [*words, "--preload", without], stderr=subprocess.DEVNULL, cwd=tmp_path
        ) as worker:
            with pytest.raises(ProcessDied, match="has no version of kowalevski-cas, not"):
                [*Pool(scheduler=address).map(square, [1])]
            worker.terminate()


@pytest.mark.slow
@pytest.mark.usefixtures("kept_at_once")
def test_a_cluster_of_two_workers_of_which_one_is_killed(tmp_path):
    distributed = pytest.importorskip("distributed")
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with cluster:
        pool = Pool(scheduler=cluster.scheduler_address)
        assert [*pool.map(partial(mortal, tmp_path), range(12))] == [n * n for n in range(12)]
        assert len((tmp_path / "done").read_text().split()) < 24
        assert taken(pool, square, failing([1, 2, -3, 4])) == ([1, 4], "-3 is negative")
        with pytest.raises(ProcessDied, match="workers of the cluster have died"):
            [*pool.map(deadly, [1])]
