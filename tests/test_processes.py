"""Work in processes that are watched: results in order, errors, limits of time, deaths."""

import os
import signal
import subprocess
import sys
import threading
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic, process_time, sleep

import pytest
from flint import Ordering, fmpq_mpoly_ctx
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas import forkserver
from kowalevski_cas.cli.exits import CommandError
from kowalevski_cas.limits import ProcessDied, is_watched, run_limit, tell, time_limit
from kowalevski_cas.processes import ALONE, GRACE, each

SHORT, LONG = 0.1, 60


pytestmark = pytest.mark.filterwarnings("ignore:This process")


@pytest.fixture(
    autouse=True, params=[pytest.param("alone", marks=pytest.mark.slow), "among threads"]
)
def asking(request):
    """A process without threads makes copies of itself; for one that has them, a fork server does."""
    done = threading.Event()
    if request.param == "alone":
        request.getfixturevalue("copies")
    else:
        threading.Thread(target=done.wait, daemon=True).start()
    yield request.param
    done.set()


def one(work):
    """The result of work in a process of its own."""
    (result,) = each(lambda _: work(), [None])
    return result


def killed():
    os.kill(os.getpid(), signal.SIGKILL)


def late(block, seconds=SHORT):
    """Whether a block under a limit comes to it."""

    def work():
        try:
            with time_limit(seconds):
                block()
        except TimeoutError:
            return True
        return False

    return one(work)


def test_a_process_with_threads_makes_no_copies_of_itself(asking, monkeypatch):
    if asking == "among threads":
        monkeypatch.setattr(os, "fork", lambda: pytest.fail("copied"))
    (parent,) = each(lambda _: os.getppid(), [None])
    assert (parent == os.getpid()) == (asking == "alone")


def test_work_takes_its_surroundings_along(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("KOWALEVSKI_TEST", "here")
    surroundings = [(str(tmp_path), "here")]
    assert [*each(lambda _: (os.getcwd(), os.environ["KOWALEVSKI_TEST"]), [None])] == surroundings


def test_what_is_imported_here_is_imported_there():
    one(lambda: None)
    import_module("kowalevski_cas.motion.units")
    assert one(lambda: "kowalevski_cas.motion.units" in sys.modules)


def test_work_that_is_done_is_not_ended(monkeypatch):
    """The number of its process may be that of another one by now."""
    monkeypatch.setattr(forkserver, "_end", lambda *_: pytest.fail("ended"))
    assert [*each(abs, [-1, -2])] == [1, 2]


def test_work_may_hold_polynomials_and_what_was_computed_of_them(asking):
    context = fmpq_mpoly_ctx.get(("x", "y"), Ordering.degrevlex)
    x, y = context.gens()
    (found,) = each(lambda k: (context.gens()[0] + y) ** k == (x + y) ** 2, [2])
    assert found


def test_a_fork_server_that_was_killed_is_begun_anew(asking):
    if asking == "among threads":
        (server,) = each(lambda _: os.getpgid(os.getppid()), [None])
        assert server != os.getpgid(0)
        os.kill(os.getsid(server), signal.SIGKILL)
        sleep(SHORT)
    assert one(lambda: 1) == 1


WORKER = """
import threading, time
from kowalevski_cas.processes import each

def work(_):
    print("begun", flush=True)
    for _ in range(6000):
        time.sleep(0.01)
    print("done")

if {threads}:
    threading.Thread(target=time.sleep, args=[600], daemon=True).start()
list(each(lambda _: list(each(work, [None])), [None]))
"""


def test_who_works_for_a_process_that_was_killed_ends(asking):
    """What is left to be read comes to an end with the last of them."""
    code = WORKER.format(threads=asking == "among threads")
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE) as asked:
        assert asked.stdout.readline() == b"begun\n"
        asked.kill()
        assert asked.stdout.read() == b""


def test_results_come_in_the_order_of_the_items():
    assert list(each(lambda n: sleep(n / 20) or n * n, [3, 1, 2], jobs=3)) == [9, 1, 4]
    assert list(each(str, [])) == []


def test_items_are_done_in_processes_that_are_watched():
    assert os.getpid() not in each(lambda _: os.getpid(), range(3))
    assert not is_watched() and one(is_watched)


def test_a_process_that_is_done_with_an_item_takes_another():
    by = [*each(lambda n: sleep(4 * ALONE * (n == 0)) or os.getpid(), range(20), jobs=2)]
    assert len(set(by)) == 2 and by.count(by[0]) == 1


def test_neighbours_in_a_sequence_are_done_in_one_process():
    by = [*each(lambda _: sleep(ALONE / 6) or os.getpid(), range(20), jobs=2)]
    assert sum(a != b for a, b in pairwise(by)) == 1


def test_what_is_done_soon_is_done_in_one_process():
    assert len({*each(lambda _: os.getpid(), range(20), jobs=2)}) == 1


def test_items_that_are_made_one_by_one_are_taken_when_they_are_needed():
    taken = []
    items = (taken.append(n) or n for n in range(20))
    answers = each(lambda n: n, items, jobs=2)
    assert next(answers) == 0 and len(taken) <= 5
    assert [*answers] == [*range(1, 20)] == taken[1:]


@pytest.mark.slow
@given(st.lists(st.integers(0, 9)), st.integers(1, 4), st.booleans())
@settings(max_examples=20, deadline=None)
def test_every_item_is_done_once(items, jobs, known):
    results = each(lambda n: n + 1, items if known else iter(items), jobs)
    assert [*results] == [n + 1 for n in items]


def test_a_limit_is_of_one_item_and_the_others_are_not_done_again():
    def work(n):
        tell(n)
        try:
            with time_limit(SHORT):
                sleep(LONG * (n == 2))
        except TimeoutError:
            return "late"
        return n

    begun = []
    found = each(work, range(5), jobs=1, heard=lambda n, _: begun.append(n))
    assert [*found] == [0, 1, "late", 3, 4]
    assert begun == [0, 1, 2, 2, 3, 4]


def test_a_process_that_dies_twice_is_the_error_of_its_item_only():
    answers = each(lambda n: killed() if n == 1 else n, range(3), jobs=1)
    assert next(answers) == 0
    with pytest.raises(ProcessDied, match="Killed"):
        next(answers)


def test_who_waits_for_an_item_ends_when_nobody_asks_any_more():
    """The one who asks is killed, and closes nothing: no process stays behind."""
    code = (
        "import os, time\n"
        "from kowalevski_cas.limits import tell\n"
        "from kowalevski_cas.processes import ALONE, GRACE, each\n"
        "work = lambda seconds: tell(os.getpid()) or time.sleep(seconds)\n"
        "heard = lambda pid, _: print(pid, flush=True)\n"
        "list(each(work, [0.5, 0.5, 0.5], jobs=3, heard=heard))"
    )
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE) as asking:
        pids = [int(asking.stdout.readline()) for _ in range(3)]
        asking.kill()
    until = monotonic() + 5
    while any(map(_runs, pids)):
        assert monotonic() < until
        sleep(0.02)


def test_the_end_of_a_run_ends_work_without_a_limit():
    """What is done by then is kept, and of the rest it is said what that is worth."""
    start = monotonic()
    with run_limit(SHORT):
        found = [*each(lambda n: sleep(LONG * (n > 0)) or n, range(3), late=lambda n: -n)]
    assert found == [0, -1, -2]
    assert monotonic() - start < LONG / 4


def test_behind_the_end_of_a_run_it_is_still_said_what_limits_have_cut_off():
    def work(_):
        try:
            with time_limit(LONG):
                sleep(LONG)
        except TimeoutError as error:
            return str(error)

    with run_limit(SHORT):
        said = {*each(work, range(3), late=lambda _: "late")}
    assert said == {"not decided before the limit of the run"}


def test_a_limit_that_nobody_waits_for_is_late_too():
    def work(n):
        with time_limit(SHORT if n else None):
            sleep(LONG * bool(n))

    assert [*each(work, range(2), late=lambda _: "late")] == [None, "late"]
    with pytest.raises(TimeoutError):
        [*each(work, range(2))]


def test_the_end_of_a_run_does_not_end_what_has_no_other_worth():
    with run_limit(SHORT):
        assert [*each(lambda n: sleep(2 * GRACE) or n, [1])] == [1]


def test_so_many_work_at_once():
    start = monotonic()
    list(each(lambda _: sleep(0.1), range(6), jobs=2))
    assert monotonic() - start >= 0.3


def test_what_is_told_is_heard_with_the_place_of_the_item():
    heard = []
    list(each(lambda n: tell(n, "words"), ["a", "b"], heard=lambda *words: heard.append(words)))
    assert sorted(heard) == [("a", "words", 0), ("b", "words", 1)]


@pytest.mark.parametrize("bad", [0, 2])
def test_the_error_of_an_item_is_raised_with_its_exit_code(bad):
    def work(item):
        if item == bad:
            raise CommandError(f"item {item} is wrong", 6)
        return item

    with pytest.raises(CommandError, match=f"item {bad} is wrong") as caught:
        list(each(work, [0, 1, 2]))
    assert caught.value.code == 6


@pytest.mark.parametrize(
    ("end", "how"),
    [(lambda: os._exit(7), "exit code 7"), (killed, "Killed")],
    ids=["exit", "signal"],
)
def test_a_process_that_dies_is_an_error_and_no_result(end, how):
    with pytest.raises(ProcessDied, match=how):
        one(end)


def test_a_result_that_cannot_be_sent_is_an_error():
    with pytest.raises(AttributeError, match="local object"):
        one(lambda: lambda: None)


def test_a_process_that_is_ended_as_it_begins_does_not_go_on_with_what_the_other_one_does():
    code = """
from kowalevski_cas import processes
def begin(_):
    raise KeyboardInterrupt
processes.begin = begin
try:
    print(list(processes.each(abs, [-1])))
except KeyboardInterrupt:
    print("went on", flush=True)
except processes.ProcessDied:
    print("died")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout == "died\n"


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError])
def test_nothing_is_left_running_when_the_work_ends_early(error):
    pids = []

    def heard(pid, place):
        pids.append(pid)
        if len(pids) == 2:
            raise error

    with pytest.raises(error):
        list(each(lambda _: tell(os.getpid()) or sleep(LONG), range(2), jobs=2, heard=heard))
    for pid in pids:
        with pytest.raises(ProcessLookupError):
            os.kill(pid, 0)


def test_a_process_that_is_not_wanted_any_more_tidies_up(tmp_path, asking, monkeypatch):
    if asking != "alone":
        pytest.skip("nobody can patch how long a fork server waits")
    monkeypatch.setattr("kowalevski_cas.processes.GRACE", LONG)
    begun = []

    def work(_):
        with TemporaryDirectory(dir=tmp_path):
            tell("begun")
            sleep(LONG)

    def heard(*words):
        begun.append(words)
        if len(begun) == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        list(each(work, range(2), jobs=2, heard=heard))
    assert not list(tmp_path.iterdir())


def test_what_a_process_has_begun_ends_with_it():
    pids = []

    def work():
        child = os.fork()
        if child == 0:
            sleep(LONG)
            os._exit(0)
        tell(child)
        sleep(LONG)

    def heard(pid, place):
        pids.append(pid)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        list(each(lambda _: work(), [None], heard=heard))
    until = monotonic() + 5
    while _runs(pids[0]):
        assert monotonic() < until
        sleep(0.02)


def _runs(pid):
    """Whether a process is there, and has not only left its number behind."""
    done = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True)
    return done.stdout.strip()[:1] not in ("", "Z")


class TestLimits:
    @pytest.mark.parametrize(
        "block",
        [
            lambda: sleep(LONG),
            lambda: pow(7, 7**11),
            lambda: signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals()) or sleep(LONG),
        ],
        ids=["asleep", "in compiled code", "deaf to signals"],
    )
    def test_a_limit_ends_what_takes_longer(self, block):
        assert late(block)

    def test_what_ends_in_time_is_left_alone(self):
        assert not late(lambda: None, LONG)
        assert not late(lambda: None, None)

    def test_a_limit_that_passed_is_the_only_one(self):
        def work():
            found = []
            for seconds in (0, LONG, 0, LONG):
                try:
                    with time_limit(SHORT):
                        sleep(seconds)
                        found.append(seconds)
                except TimeoutError:
                    found.append("late")
            return found

        assert one(work) == [0, "late", 0, "late"]

    def test_a_limit_within_another_one_does_not_outlast_it(self):
        def block():
            with time_limit(LONG):
                sleep(LONG)

        assert late(block)

    def test_a_limit_goes_on_after_one_within_it(self):
        def block():
            with time_limit(LONG):
                pass
            sleep(LONG)

        assert late(block)

    def test_what_had_been_begun_under_a_limit_is_gone(self):
        def work():
            begun = []
            try:
                with time_limit(SHORT):
                    begun.append("half")
                    sleep(LONG)
            except TimeoutError:
                return begun

        assert one(work) == []

    def test_a_death_under_a_limit_is_told_there(self):
        def work():
            try:
                with time_limit(LONG):
                    killed()
            except ProcessDied as error:
                return str(error)

        assert "Killed" in one(work)

    def test_processes_of_a_process_are_watched_too(self):
        assert one(lambda: [late(lambda: sleep(LONG)), late(lambda: None)]) == [True, False]


def spin(seconds):
    """Work for so many seconds of a processor."""
    until = process_time() + seconds
    while process_time() < until:
        pass


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="the system does not tell")
def test_a_limit_does_not_count_how_long_a_process_waits_for_a_processor():
    """Else what a machine decides would depend on what else it has to do."""
    if not Path("/proc/self/schedstat").exists():
        pytest.skip("the system does not tell")

    def decided(number):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
        if number:
            spin(1)
            return True
        try:
            with time_limit(0.6):
                spin(0.3)
                return True
        except TimeoutError:
            return False

    assert [*each(decided, range(4), jobs=4)] == [True] * 4
