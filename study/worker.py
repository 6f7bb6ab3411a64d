"""A process that answers one question after the other, under a limit of time and memory.

A question that takes too long ends the process; the next one starts another. So
no method can stop the study, and what it costs is measured where it runs.
"""

from __future__ import annotations

import os
import resource
import sys
from importlib import import_module
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from time import perf_counter
from typing import Any, Self

from study.step import Measured

MEBIBYTE = 2**20


class Worker:
    """A process in which ``target``, as ``module:function``, answers questions.

    The function takes one value and returns a mapping, to which the time that it
    took (``seconds``) and the most memory that the process has had (``memory``,
    bytes) are added. Limits are in seconds and mebibytes.
    """

    def __init__(self, target: str, seconds: float, mebibytes: int) -> None:
        self.target = target
        self.seconds = seconds
        self.mebibytes = mebibytes
        self._running: tuple[SpawnProcess, Connection] | None = None

    def ask(self, question: Any) -> Measured:
        """The answer; a limit that is reached is the verdict ``timeout``, with its reason."""
        fresh = self._running is None
        process, pipe = self._running = self._running or self._start()
        start = perf_counter()
        try:
            if fresh:
                pipe.recv()  # it is ready: what the limit counts begins here
                start = perf_counter()
            pipe.send(question)
            if pipe.poll(self.seconds):
                answer: Measured = pipe.recv()
                return answer
            found = {"verdict": "timeout", "reason": f"{self.seconds:g} s"}
        except (EOFError, ConnectionError):
            process.join()
            reason = f"the process ended with {process.exitcode}"
            found = {"verdict": "error", "reason": reason}
        except BaseException:
            self.close()  # an interruption reaches the process only if it comes from a terminal
            raise
        self.close()
        return {"seconds": perf_counter() - start, **found}

    def close(self) -> None:
        """End the process, if there is one."""
        if self._running is not None:
            process, pipe = self._running
            self._running = None
            process.kill()
            process.join()
            pipe.close()

    def _start(self) -> tuple[SpawnProcess, Connection]:
        context = get_context("spawn")
        pipe, other = context.Pipe()
        process = context.Process(
            target=serve, args=(other, self.target, self.mebibytes), daemon=True
        )
        process.start()
        other.close()
        return process, pipe

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def asked(target: str, seconds: float, mebibytes: int, question: Any) -> Measured:
    """The answer of a process of its own."""
    with Worker(target, seconds, mebibytes) as worker:
        return worker.ask(question)


def peak() -> int:
    """The most memory that this process has had, in bytes."""
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else 1024 * most


def serve(pipe: Connection, target: str, mebibytes: int) -> None:
    """Answer questions until there are no more."""
    resource.setrlimit(resource.RLIMIT_AS, (mebibytes * MEBIBYTE, mebibytes * MEBIBYTE))
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # a library may print
    name, _, attribute = target.partition(":")
    answer = getattr(import_module(name), attribute)
    pipe.send("ready")
    while True:
        try:
            question = pipe.recv()
        except EOFError:
            return
        start = perf_counter()
        try:
            found = dict(answer(question))
        except MemoryError:
            found = {"verdict": "timeout", "reason": f"{mebibytes} MiB"}
        except Exception as error:
            found = {"verdict": "error", "reason": f"{type(error).__name__}: {error}"[:300]}
        found.setdefault("seconds", perf_counter() - start)
        pipe.send({**found, "memory": peak()})
