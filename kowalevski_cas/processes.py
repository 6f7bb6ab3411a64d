"""Work in processes of its own, which are watched: limits of time hold wherever they are.

A process tells where a limit begins and where it ends (``limits.py``). If it takes longer, or dies
there, it is ended from outside, and a new one does the work again and gives up where the first one
stood.
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing, suppress
from functools import partial
from io import BufferedReader
from math import inf
from select import select
from time import monotonic
from traceback import format_exc
from typing import Generic, TypeVar

from kowalevski_cas.limits import (
    LENGTH,
    ProcessDied,
    Watched,
    begin,
    early_end,
    end_with,
    is_watched,
    run_end,
    waited,
)

Item = TypeVar("Item")
Result = TypeVar("Result")

CHUNK = 1 << 20
"""Bytes that are read at once."""

ALONE = 0.3
"""Seconds after which a process is given company."""

GRACE = 1.0
"""Seconds that a process has to tidy up, when its work is not wanted any more."""

LONGEST = 3600.0
"""Seconds for which nobody looks at the clock."""


def each(
    work: Callable[[Item], Result],
    items: Iterable[Item],
    jobs: int = os.cpu_count() or 1,
    heard: Callable[..., None] = lambda *words: None,
    ordered: bool = True,
    late: Callable[[Item], Result] | None = None,
) -> Iterator[Result]:
    """The results of ``work`` on every item, in their order; the first error is raised here.

    If they need not be ``ordered``, each comes as soon as it is there. ``late`` gives the results
    of those that are not done when the run ends (``run_limit``); without it they are waited for,
    but for what is done there under limits.

    ``jobs`` copies of this process work at once, where the system makes such copies: a fork costs
    milliseconds, a new start would cost as much as a proof. What is done soon is done by one of
    them: each copies the memory that it touches. Where this process has threads, copies
    are made of a fork server instead (``forkserver.py``). The items are sent, and have to be plain
    data. Who is done with one takes another. Of a sequence every second process takes what
    is left at the end, so that neighbours, which often need the same, are done in one process.
    ``heard`` is called with what is told there and the place of the item. Nothing is left running
    if this ends early.

    Raises:
        ProcessDied: a process died, and not under a limit, and so did one that was begun anew.
    """
    done = dict[int, _WorkResult[Result]]()
    following = 0
    take, answers = _next_items(items), partial(_answers, work, late, jobs, run_end())
    if hasattr(os, "fork") and has_threads():
        from kowalevski_cas import forkserver  # few processes have threads

        answers = partial(forkserver.answers, answers)
    with closing(answers(take, heard)) as found:
        for place, answer in found:
            done[place if ordered else following] = answer
            while following in done:
                yield done.pop(following).result
                following += 1


def has_threads() -> bool:
    """Whether this process has more than one thread that runs Python.

    Threads of compiled libraries do not count: those of BLAS end before a copy is made, and the
    others are told to make none.
    """
    return len(sys._current_frames()) > 1


class _WorkResult(Generic[Result]):
    """What came of an item: a result, or an error."""

    def __init__(self, results: Sequence[Result], error: BaseException | None = None) -> None:
        self.results, self.error = results, error

    @property
    def result(self) -> Result:
        """The result; the error is raised."""
        if self.error is not None:
            raise self.error
        return self.results[0]


def _answers(
    work: Callable[[Item], Result],
    late: Callable[[Item], Result] | None,
    jobs: int,
    until: float,
    take: Callable[[int], tuple[int, Item] | None],
    heard: Callable[..., None],
) -> Generator[tuple[int, _WorkResult[Result]], None, None]:
    """What came of the items at these places; an item is taken when somebody is free."""
    if not hasattr(os, "fork"):
        while (item := take(0)) is not None:
            yield item[0], _WorkResult([work(item[1])])
        return
    running = list[_Process[Item, Result]]()
    alone = monotonic() + ALONE
    try:
        while True:
            others = jobs if monotonic() >= alone else 1
            while len(running) < max(1, others) and (item := take(len(running))) is not None:
                running.append(_Process(work, late, len(running), running, until))
                running[-1].give(*item)
            if not running:
                return
            _listen(running, heard, alone if len(running) < jobs else inf)
            for process in [process for process in running if process.answer is not None]:
                place, answer = process.place, process.answer
                assert answer is not None
                if (item := take(process.number)) is not None:
                    process.give(*item)
                else:
                    running.remove(process)
                    process.end()
                yield place, answer
    finally:
        for process in running:
            process.send(signal.SIGTERM)
        for process in running:
            process.tidy()
            process.end()


def _next_items(items: Iterable[Item]) -> Callable[[int], tuple[int, Item] | None]:
    """What the process with a number takes next, with its place; nothing if nothing is left."""
    if not isinstance(items, Sequence):
        numbered = enumerate(items)
        return lambda _: next(numbered, None)
    left = deque(enumerate(items))
    return lambda number: (left.pop() if number % 2 else left.popleft()) if left else None


class _Process(Generic[Item, Result]):
    """A process that works on one item after the other, seen by the one that watches it.

    ``others`` are those that run beside it. Under limits nothing is worked on after ``until``; the
    rest is ended soon after that if it may be ``late``.
    """

    def __init__(
        self,
        work: Callable[[Item], Result],
        late: Callable[[Item], Result] | None,
        number: int,
        others: Sequence[_Process[Item, Result]],
        until: float,
    ) -> None:
        self.work, self.late, self.number = work, late, number
        self.others, self.until = others, until
        self.start()

    def start(self) -> None:
        """Begin a process that waits for an item."""
        self.limits: dict[int, float] = {}
        """The limits under which it works, and when they end."""
        self.waited: dict[int, float] = {}
        """For how long it had waited for a processor when they began, or were prolonged."""
        self.unread = bytearray()
        sys.stdout.flush()
        sys.stderr.flush()
        self.reading, told = os.pipe()
        asked, self.writing = os.pipe()
        here = os.getpid()
        self.pid = os.fork()
        if self.pid == 0:
            try:
                end_with(here)
                for process in {
                    self,
                    *self.others,
                }:  # who waits has to see that nobody asks any more
                    os.close(process.reading)
                    os.close(process.writing)
                _serve(
                    self.work, os.fdopen(asked, "rb"), Watched(os.fdopen(told, "wb"), self.until)
                )
            finally:
                os._exit(1)  # whatever happens, a copy does not go on with what the original does
        os.close(told)
        os.close(asked)
        if not is_watched():
            os.setpgid(self.pid, self.pid)  # a group of its own, which ends with it

    def give(self, place: int, item: Item) -> None:
        """Let it work on an item."""
        self.place, self.item = place, item
        self.answer: _WorkResult[Result] | None = None
        self.given_up: dict[int, Exception] = {}
        self.again = False
        self.ask()

    def ask(self) -> None:
        """Send it the item, and the limits under which it does not come any more."""
        with suppress(BrokenPipeError):  # it has died: whoever listens hears that
            os.write(self.writing, pickle.dumps((self.item, self.given_up)))

    @property
    def deadline(self) -> float:
        """When the next of its limits ends, or else the time to say what is not done in the run."""
        if self.limits:
            return min(*self.limits.values(), self.until)
        return inf if self.late is None else self.until + GRACE

    def is_late(self) -> bool:
        """Whether it has come to a limit, which does not count its waiting for a processor."""
        if self.deadline <= monotonic():
            now = waited(self.pid)
            for limit, before in self.waited.items():
                self.limits[limit] += now - before
                self.waited[limit] = now
        return self.deadline <= monotonic()

    def hear(self, heard: Callable[..., None]) -> None:
        """Read what it has told; it may have come to its end."""
        data = os.read(self.reading, CHUNK)
        if not data:
            self.give_up(max(self.limits, default=None))
            return
        self.unread += data
        while len(self.unread) >= LENGTH + (size := int.from_bytes(self.unread[:LENGTH])):
            kind, *words = pickle.loads(self.unread[LENGTH : LENGTH + size])
            del self.unread[: LENGTH + size]
            match kind:
                case "begin":
                    self.limits[words[0]], self.waited[words[0]] = words[1], words[2]
                case "end":
                    del self.limits[words[0]], self.waited[words[0]]
                case "words":
                    heard(*words, self.place)
                case "result":
                    self.answer = _WorkResult(words)
                case "error":
                    self.fail(words[0])

    def fail(self, error: BaseException) -> None:
        """Answer with an error, or with what the item is worth that is late."""
        if self.late is not None and isinstance(error, TimeoutError):
            self.answer = _WorkResult([self.late(self.item)])
        else:
            self.answer = _WorkResult([], error)

    def give_up(self, limit: int | None, error: Exception | None = None) -> None:
        """End the process; the next one does not come under this limit, if there is any.

        Without a limit the work is done once more: memory may have been short for a while.
        """
        how = self.end()
        error = error or ProcessDied(f"the process that worked on it has died ({how})")
        if limit is not None:
            self.given_up[limit] = error
        elif self.again or isinstance(error, TimeoutError):
            self.fail(error)
        else:
            self.again = True
        self.start()
        if self.answer is None:
            self.ask()

    def send(self, number: signal.Signals) -> None:
        """Send a signal to the process, and to those that it has begun."""
        with suppress(ProcessLookupError):
            (os.kill if is_watched() else os.killpg)(self.pid, number)

    def tidy(self) -> None:
        """Let the process take away what it has written for the time of its work."""
        until = monotonic() + GRACE
        while select([self.reading], [], [], max(until - monotonic(), 0))[0]:
            if not os.read(self.reading, CHUNK):
                return

    def end(self) -> str:
        """End the process, and those that it has begun; how it has ended."""
        os.close(self.reading)
        os.close(self.writing)
        self.send(signal.SIGKILL)
        code = os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])
        return f"exit code {code}" if code >= 0 else signal.strsignal(-code) or f"signal {-code}"


def _listen(
    running: Sequence[_Process[Item, Result]], heard: Callable[..., None], until: float
) -> None:
    """Hear what is told next, until some moment, or end what has come to a limit."""
    now = monotonic()
    left = min(*(process.deadline for process in running), until if until > now else inf) - now
    ends = early_end()
    ready, _, _ = select(
        [*ends, *(process.reading for process in running)], [], [], min(max(left, 0), LONGEST)
    )
    if {*ends} & {*ready}:
        os.read(ends[0], CHUNK)
        for process in running:
            process.until = run_end()
        return
    for one in running:
        if one.reading in ready:
            one.hear(heard)
        elif not ready and one.is_late():
            one.give_up(min(one.limits, key=lambda n: one.limits[n], default=None), TimeoutError())


def _serve(work: Callable[[Item], Result], asked: BufferedReader, here: Watched) -> None:
    """Work in this process on what is asked, tell the answers, and end when nobody asks."""
    begin(here)
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, signal.default_int_handler)
    try:
        while asked.peek(1):
            item, here.given_up = pickle.load(asked)
            here.limits = 0
            try:
                result = work(item)
                sys.stdout.flush()
                here.tell("result", result)
            except Exception as error:
                error.add_note(format_exc())
                here.tell("error", error)
    except BaseException as error:
        here.tell("error", error)
    finally:
        asked.close()
