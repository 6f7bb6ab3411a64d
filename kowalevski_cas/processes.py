"""Work in processes of its own, which are watched: limits of time hold wherever they are.

A process tells where a limit begins and where it ends. If it takes longer, or dies there, it is
ended from outside, and a new one does the work again and gives up where the first one stood. So a
limit needs no help from what is computed, be it compiled code or an import, and whatever had been
begun under it is gone.
"""

from __future__ import annotations

import os
import pickle
import signal
import sys
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from math import inf
from select import select
from time import monotonic
from typing import BinaryIO, Generic, NoReturn, TypeVar

from kowalevski_cas import UserError

Item = TypeVar("Item")
Result = TypeVar("Result")

LENGTH = 8
"""Bytes before each message that say how long it is."""

CHUNK = 1 << 20
"""Bytes that are read at once."""

GRACE = 1.0
"""Seconds that a process has to tidy up, when its work is not wanted any more."""

LONGEST = 3600.0
"""Seconds for which nobody looks at the clock."""


class ProcessDied(UserError, RuntimeError):
    """A process ended before its work was done; the message says how."""


class _Watched:
    """What a watched process knows: whom it tells, and the limits at which it gives up."""

    def __init__(self, stream: BinaryIO, given_up: dict[int, Exception]) -> None:
        self.stream, self.given_up = stream, given_up
        self.limits = 0

    def tell(self, *message: object) -> None:
        data = pickle.dumps(message)
        self.stream.write(len(data).to_bytes(LENGTH) + data)
        self.stream.flush()


_here: _Watched | None = None


def watched() -> bool:
    """Whether somebody watches this process, so that limits hold in it."""
    return _here is not None


def tell(*words: object) -> None:
    """Tell the words to whoever watches this process; nobody hears them elsewhere."""
    if _here is not None:
        _here.tell("words", *words)


@contextmanager
def time_limit(seconds: float | None) -> Iterator[None]:
    """A limit for a block, in a process that is watched; there is none elsewhere or with ``None``.

    Limits nest. The blocks of a work have to come in the same order whenever it is done.

    Raises:
        TimeoutError: the block takes longer; it is not entered.
        ProcessDied: a process has died in the block.
    """
    if seconds is None or _here is None:
        yield
        return
    here = _here
    here.limits += 1
    number = here.limits
    if number in here.given_up:
        raise here.given_up[number]
    here.tell("begin", number, monotonic() + seconds)
    try:
        yield
    finally:
        here.tell("end", number)


def each(
    work: Callable[[Item], Result],
    items: Iterable[Item],
    jobs: int = os.cpu_count() or 1,
    heard: Callable[..., None] = lambda *words: None,
    ordered: bool = True,
) -> Iterator[Result]:
    """The results of ``work`` on every item, in their order; the first error is raised here.

    If they need not be ``ordered``, each comes as soon as it is there.

    Each item is worked on in a copy of this process, where the system makes such copies, and
    ``jobs`` of them at once: a fork costs milliseconds, a new start would cost as much as a proof.
    ``heard`` is called with what is told there and the place of the item. Nothing is left running
    if this ends early.

    Raises:
        ProcessDied: a process died, and not under a limit, and so did one that was begun anew.
    """
    done = dict[int, _Process[Item, Result]]()
    following = 0
    with closing(_as_done(work, items, jobs, heard)) as finished:
        for process in finished:
            done[process.place if ordered else following] = process
            while following in done:
                yield done.pop(following).result
                following += 1


def _as_done(
    work: Callable[[Item], Result], items: Iterable[Item], jobs: int, heard: Callable[..., None]
) -> Generator[_Process[Item, Result], None, None]:
    """The processes, when their work is done or has failed; an item is taken when one is free."""
    waiting = (_Process(work, item, place) for place, item in enumerate(items))
    if not hasattr(os, "fork"):
        for process in waiting:
            process.results = [work(process.item)]
            yield process
        return
    running = list[_Process[Item, Result]]()
    try:
        while True:
            while len(running) < max(1, jobs) and (more := next(waiting, None)) is not None:
                more.start()
                running.append(more)
            if not running:
                return
            _listen(running, heard)
            finished = [one for one in running if one.done]
            running = [one for one in running if not one.done]
            yield from finished
    finally:
        left = [process for process in running if process.runs]
        for process in left:
            process.send(signal.SIGTERM)
        for process in left:
            process.tidy()
            process.end()


class _Process(Generic[Item, Result]):
    """A process that works on an item, seen by the one that watches it."""

    def __init__(self, work: Callable[[Item], Result], item: Item, place: int) -> None:
        self.work, self.item, self.place = work, item, place
        self.given_up: dict[int, Exception] = {}
        self.results: list[Result] = []
        self.error: BaseException | None = None
        self.runs = self.again = False

    def start(self) -> None:
        """Begin the work, or begin it anew."""
        self.limits: dict[int, float] = {}
        """The limits under which it works, and when they end."""
        self.unread = bytearray()
        sys.stdout.flush()
        sys.stderr.flush()
        self.reading, writing = os.pipe()
        self.pid = os.fork()
        if self.pid == 0:
            os.close(self.reading)
            _do(self.work, self.item, _Watched(os.fdopen(writing, "wb"), self.given_up))
        os.close(writing)
        if _here is None:
            os.setpgid(self.pid, self.pid)  # a group of its own, which ends with it
        self.runs = True

    @property
    def done(self) -> bool:
        """Whether the work is done, or has failed."""
        return bool(self.results) or self.error is not None

    @property
    def result(self) -> Result:
        """What the work has given; its error is raised."""
        if self.error is not None:
            raise self.error
        return self.results[0]

    @property
    def deadline(self) -> float:
        """When the next of its limits ends."""
        return min(self.limits.values(), default=inf)

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
                    self.limits[words[0]] = words[1]
                case "end":
                    del self.limits[words[0]]
                case "words":
                    heard(*words, self.place)
                case "result":
                    self.results = words
                case "error":
                    self.error = words[0]
        if self.done:
            self.end()

    def give_up(self, limit: int | None, error: Exception | None = None) -> None:
        """End the process; the next one does not come under this limit, if there is any.

        Without a limit the work is done once more: memory may have been short for a while.
        """
        how = self.end()
        error = error or ProcessDied(f"the process that worked on it has died ({how})")
        if limit is not None:
            self.given_up[limit] = error
        elif self.again:
            self.error = error
            return
        else:
            self.again = True
        self.start()

    def send(self, number: signal.Signals) -> None:
        """Send a signal to the process, and to those that it has begun."""
        with suppress(ProcessLookupError):
            (os.kill if _here else os.killpg)(self.pid, number)

    def tidy(self) -> None:
        """Let the process take away what it has written for the time of its work."""
        until = monotonic() + GRACE
        while select([self.reading], [], [], max(until - monotonic(), 0))[0]:
            if not os.read(self.reading, CHUNK):
                return

    def end(self) -> str:
        """End the process, and those that it has begun; how it has ended."""
        os.close(self.reading)
        self.send(signal.SIGKILL)
        self.runs = False
        code = os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])
        return f"exit code {code}" if code >= 0 else signal.strsignal(-code) or f"signal {-code}"


def _listen(running: Sequence[_Process[Item, Result]], heard: Callable[..., None]) -> None:
    """Hear what is told next, or end what has come to a limit."""
    left = min(one.deadline for one in running) - monotonic()
    ready, _, _ = select([one.reading for one in running], [], [], min(max(left, 0), LONGEST))
    for one in running:
        if one.reading in ready:
            one.hear(heard)
        elif not ready and one.deadline <= monotonic():
            one.give_up(min(one.limits, key=lambda n: one.limits[n]), TimeoutError())


def _do(work: Callable[[Item], Result], item: Item, here: _Watched) -> NoReturn:
    """Work on an item in this process, tell the answer, and end."""
    global _here
    _here = here
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        try:
            result = work(item)
            sys.stdout.flush()
            here.tell("result", result)
        except BaseException as error:
            here.tell("error", error)
    finally:
        os._exit(1)
