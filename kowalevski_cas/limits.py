"""What a process tells that is watched: words, and the limits of time under which it works.

A limit that it comes to is kept by whoever watches it (``processes.py``): what is computed need not
help, be it compiled code or an import, and whatever had been begun under the limit is gone.
"""

from __future__ import annotations

import os
import pickle
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from math import inf
from threading import current_thread, main_thread
from time import monotonic
from types import FrameType
from typing import BinaryIO

from kowalevski_cas import UserError

LENGTH = 8
"""Bytes before each message that say how long it is."""


RUN_OVER = "not decided before the limit of the run"

LOOK = 1.0
"""Seconds after which a process looks whether it is still waited for."""


class ProcessDied(UserError, RuntimeError):
    """A process ended before its work was done; the message says how."""


class Watched:
    """What a watched process knows: whom it tells, and the limits at which it gives up."""

    def __init__(self, stream: BinaryIO, until: float = inf) -> None:
        self.stream, self.until = stream, until
        self.given_up: dict[int, Exception] = {}
        self.limits = 0

    def tell(self, *message: object) -> None:
        data = pickle.dumps(message)
        self.stream.write(len(data).to_bytes(LENGTH) + data)
        self.stream.flush()


_here: Watched | None = None
_until = inf
"""When the run ends that is begun in this process."""
_ends: tuple[int, int] | None = None
"""A pipe by which whoever waits hears of an end that comes before its time."""


def begin(here: Watched) -> None:
    """Say that this process is watched from now on."""
    global _here, _ends
    _here, _ends = here, None


def end_with(parent: int) -> None:
    """Interrupt this process soon after the one has died that it is a copy of.

    Nobody would wait for what it computes, or end it at a limit. What compiled code has begun is
    done first.
    """

    def look(number: int, frame: FrameType | None) -> None:
        if os.getppid() != parent:
            signal.default_int_handler(number, frame)

    signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, LOOK, LOOK)


def waited(process: int | str = "thread-self") -> float:
    """The seconds for which a process, or this thread, was ready to work and had no processor.

    Linux tells them; elsewhere there are none.
    """
    try:
        with open(f"/proc/{process}/schedstat", "rb", buffering=0) as told:
            return int(told.read().split()[1]) / 1e9
    except (OSError, IndexError, ValueError):
        return 0.0


def clock() -> float:
    """Seconds that pass here, without those of waiting for a processor.

    By it a limit of time means nearly the same on a machine that has other work to do.
    """
    before = waited()
    while True:
        now, after = monotonic(), waited()
        if after == before:  # else it has waited just here
            return now - after
        before = after


def is_watched() -> bool:
    """Whether somebody watches this process, so that limits hold in it."""
    return _here is not None


def tell(*words: object) -> None:
    """Tell the words to whoever watches this process; nobody hears them elsewhere."""
    if _here is not None:
        _here.tell("words", *words)


def run_end() -> float:
    """When the run ends in which this process works; infinity if it has no limit."""
    return _until if _here is None else _here.until


@contextmanager
def run_limit(seconds: float | None) -> Iterator[None]:
    """A limit for all that processes do for a block: behind it every limit of time is over.

    Work without limits of its own is ended soon after that, if it is said what it is worth then.
    """
    global _until
    before = _until
    _until = before if seconds is None else min(before, monotonic() + seconds)
    try:
        yield
    finally:
        _until = before


@contextmanager
def interruptible() -> Iterator[Callable[[], bool]]:
    """An interruption ends the run of a block as its limit would; the second one is raised.

    What is given says whether there was one. Other threads than the main one hear of none.
    """
    global _until, _ends
    if current_thread() is not main_thread():
        yield lambda: False
        return
    before, was_interrupted = _until, False

    def end(*_: object) -> None:
        global _until
        nonlocal was_interrupted
        _until, was_interrupted = monotonic(), True
        signal.signal(signal.SIGINT, handler)
        os.write(writing, b".")

    reading, writing = _ends = os.pipe()
    handler = signal.signal(signal.SIGINT, end)
    try:
        yield lambda: was_interrupted
    finally:
        signal.signal(signal.SIGINT, handler)
        _until, _ends = before, None
        os.close(reading)
        os.close(writing)


def early_end() -> list[int]:
    """What can be read from as soon as the run is ended before its time, if that can be."""
    return [] if _ends is None else [_ends[0]]


@contextmanager
def time_limit(seconds: float | None) -> Iterator[None]:
    """A limit for a block, in a process that is watched; there is none elsewhere or with ``None``.

    Limits nest, and do not count how long the process waits for a processor. The blocks of a
    work have to come in the same order whenever it is done. None reaches beyond the limit of the
    run.

    Raises:
        TimeoutError: the block takes longer; it is not entered.
        ProcessDied: a process has died in the block.
    """
    if seconds is None or _here is None:
        yield
        return
    here = _here
    if here.until <= (now := monotonic()):
        raise TimeoutError(RUN_OVER)
    here.limits += 1
    number = here.limits
    if number in here.given_up:
        raise here.given_up[number]
    here.tell("begin", number, min(now + seconds, here.until), waited())
    try:
        yield
    finally:
        with suppress(BrokenPipeError):  # who waited may be gone
            here.tell("end", number)
