"""Work on several derivations at once, each in a process of its own."""

from __future__ import annotations

import os
import pickle
import signal
import sys
from collections.abc import Callable, Sequence
from typing import BinaryIO, TypeVar

from kowalevski_cas.cli.exits import CommandError

Item = TypeVar("Item")
Result = TypeVar("Result")

forked = False
"""Whether this process works for another one, which alone speaks to the terminal."""


def each(work: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    """The results of ``work`` on every item, in their order; the first error is raised here.

    The first item is worked on here and each other one in a copy of this process,
    where the system makes such copies: a fork costs milliseconds, a new start
    would cost as much as a proof.
    """
    if not hasattr(os, "fork") or (os.cpu_count() or 1) < 2:
        return [work(item) for item in items]
    children = [_forked(work, item) for item in items[1:]]
    try:
        results = [work(item) for item in items[:1]]
        for _, answer in children:
            with answer:
                told = answer.read()
            if not told:
                raise CommandError(f"the process that worked on {items[len(results)]} has died")
            succeeded, result = pickle.loads(told)
            if not succeeded:
                raise result
            results.append(result)
        return results
    except BaseException:
        for child, _ in children:
            os.kill(child, signal.SIGKILL)
        raise
    finally:
        for child, _ in children:
            os.waitpid(child, 0)


def _forked(work: Callable[[Item], Result], item: Item) -> tuple[int, BinaryIO]:
    """The number of a process that works on an item, and where it writes its answer."""
    sys.stdout.flush()
    sys.stderr.flush()
    reading, writing = os.pipe()
    child = os.fork()
    if child:
        os.close(writing)
        return child, os.fdopen(reading, "rb")
    global forked
    forked = True
    answer: tuple[bool, object]
    try:
        answer = True, work(item)
    except BaseException as error:
        answer = False, error
    with os.fdopen(writing, "wb") as stream:
        pickle.dump(answer, stream)
    sys.stderr.flush()
    os._exit(0)
