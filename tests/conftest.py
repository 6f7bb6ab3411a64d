"""What all tests share: the derivations with one run of each, and how hard Hypothesis looks."""

import gc
import os
import pickle
import signal
import sys
from collections import defaultdict
from fcntl import LOCK_EX, flock
from functools import wraps
from pathlib import Path
from zlib import crc32

import pytest
from hypothesis import HealthCheck, settings

from kowalevski_cas import processes
from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import find, load
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.decider import Decider
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session
from tests.law import is_asked, uphold

ROOMS_OF_EXAMPLES = ("reading", "laws")
"""The folders of tests in which each reads or draws one example of many."""

for profile, examples in (("quick", 6), ("slow", 100)):
    settings.register_profile(
        profile,
        max_examples=examples,
        deadline=None,
        derandomize=True,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
    )


def pytest_configure(config):
    """Without slow tests, Hypothesis looks less hard, too; Ctrl-C interrupts in the background.

    Garbage in circles is rarely looked for: processes end before it matters. The thread of
    pytest-xdist, which waits meanwhile, does not count: work is done in copies of this process as
    at a terminal, with what a test has patched, and the law of verdicts, in it.
    """
    waiting = len(sys._current_frames()) - 1
    processes.has_threads = lambda: len(sys._current_frames()) > 1 + waiting
    gc.set_threshold(100_000)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    settings.load_profile("quick" if _is_quick(config) else "slow")


def _is_quick(config):
    """Whether slow tests are left out."""
    return "not slow" in config.option.markexpr


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    """Of each file of examples but one that is not slow is marked, the same in every run."""
    files = defaultdict(list)
    for item in items:
        if item.path.parent.name in ROOMS_OF_EXAMPLES and not item.get_closest_marker("slow"):
            files[item.path].append(item)
    for tests in files.values():
        tests.remove(min(tests, key=lambda item: crc32(item.nodeid.encode())))
        for item in tests:
            item.add_marker(pytest.mark.example)


def pytest_collection_finish():
    """What is collected stays: no copy of this process looks through it for what is left over."""
    gc.freeze()


@pytest.fixture(autouse=True)
def _law(request, monkeypatch):
    """Whatever is decided in a test obeys the law of verdicts, unless what it says is forged."""
    if request.node.get_closest_marker("forged"):
        return
    decide, slow = Decider.decide, not _is_quick(request.config)

    @wraps(decide)
    def upheld(self, claim, corrections=None):
        outcome = decide(self, claim, corrections)
        if is_asked(outcome, slow):
            uphold(self, claim, outcome)
        return outcome

    monkeypatch.setattr(Decider, "decide", upheld)


@pytest.fixture(params=EXACT)
def name(request):
    """The name of an exact arithmetic."""
    return request.param


@pytest.fixture(scope="session")
def folder() -> Path:
    return find("kharlamov2002")


@pytest.fixture(scope="session")
def derivation():
    return load("kharlamov2002")


@pytest.fixture(scope="session")
def record(folder):
    return load_record(folder)


@pytest.fixture(scope="session")
def certificates(folder):
    return load_certificates(folder)


@pytest.fixture(scope="session")
def run(derivation, certificates, record, tmp_path_factory):
    """The whole paper in all three arithmetics; the first process that asks makes it for all."""
    shared = tmp_path_factory.getbasetemp()
    place = (shared.parent if "PYTEST_XDIST_WORKER" in os.environ else shared) / "run.pickle"
    with place.with_suffix(".lock").open("w") as lock:
        flock(lock, LOCK_EX)
        if not place.exists():
            found = Session(derivation, EXACT, certificates=certificates, record=record).run()
            place.write_bytes(pickle.dumps(found))
    return pickle.loads(place.read_bytes())


@pytest.fixture(scope="session")
def outcomes(run):
    return {outcome.claim: outcome for outcome in run.outcomes}


@pytest.fixture(scope="module")
def uncorrected():
    """No correction is looked for: what is refuted costs no more than its refutation."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Session, "with_corrections", lambda _, outcomes, *__: list(outcomes))
        yield


@pytest.fixture
def copies(monkeypatch):
    """Work is done in copies of this process, also where tests have left threads behind."""
    monkeypatch.setattr(processes, "has_threads", lambda: False)


@pytest.fixture
def here(monkeypatch):
    """All is decided in this process, as where a system makes no copies of one: no limit holds.

    A test of limits or of several processes undoes it.
    """
    monkeypatch.delattr(os, "fork")
