"""A process that answers one question after the other, under a limit of time and memory.

A question that takes too long ends the process; the next one starts another. So
no method can stop the study, and what it costs is measured where it runs.
"""

from __future__ import annotations

import json
import os
import resource
import select
import subprocess
import sys
from importlib import import_module
from time import perf_counter
from typing import Any, Self

from study.step import Measured

MEBIBYTE = 2**20


class Worker:
    """A process in which ``target``, as ``module:function``, answers questions given as JSON.

    The function takes one value and returns a mapping, to which the time that it
    took (``seconds``) and the most memory that the process has had (``memory``,
    bytes) are added. Limits are in seconds and mebibytes.
    """

    def __init__(self, target: str, seconds: float, mebibytes: int) -> None:
        self.target = target
        self.seconds = seconds
        self.mebibytes = mebibytes
        self._process: subprocess.Popen[str] | None = None

    def ask(self, question: Any) -> Measured:
        """The answer; a limit that is reached is the verdict ``timeout``, with its reason."""
        process = self._process or self._start()
        assert process.stdin is not None and process.stdout is not None
        start = perf_counter()
        try:
            process.stdin.write(json.dumps(question) + "\n")
            process.stdin.flush()
            ready = select.select([process.stdout], [], [], self.seconds)[0]
            line = process.stdout.readline() if ready else None
        except BrokenPipeError:
            line = ""
        except BaseException:
            self.close()  # an interruption reaches the process only if it comes from a terminal
            raise
        if line:
            answer: Measured = json.loads(line)
            return answer
        waited = perf_counter() - start
        code = self.close()
        if line is None:
            return {"seconds": waited, "verdict": "timeout", "reason": f"{self.seconds:g} s"}
        return {"seconds": waited, "verdict": "error", "reason": f"the process ended with {code}"}

    def close(self) -> int | None:
        """End the process, if there is one; its exit code."""
        process, self._process = self._process, None
        if process is None:
            return None
        process.kill()
        assert process.stdin is not None and process.stdout is not None
        for stream in (process.stdin, process.stdout):
            try:
                stream.close()
            except BrokenPipeError:
                continue
        return process.wait()

    def _start(self) -> subprocess.Popen[str]:
        command = [sys.executable, "-m", __name__, self.target, str(self.mebibytes)]
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)},
        )
        return self._process

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def peak() -> int:
    """The most memory that this process has had, in bytes."""
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else 1024 * most


def serve(target: str, mebibytes: int) -> None:
    """Answer questions from standard input until it ends."""
    resource.setrlimit(resource.RLIMIT_AS, (mebibytes * MEBIBYTE, mebibytes * MEBIBYTE))
    name, _, attribute = target.partition(":")
    answer = getattr(import_module(name), attribute)
    answers, sys.stdout = sys.stdout, sys.stderr  # what a library prints is no answer
    for line in sys.stdin:
        question = json.loads(line)
        start = perf_counter()
        try:
            found = dict(answer(question))
        except MemoryError:
            found = {"verdict": "timeout", "reason": f"{mebibytes} MiB"}
        except Exception as error:
            found = {"verdict": "error", "reason": f"{type(error).__name__}: {error}"[:300]}
        found.setdefault("seconds", perf_counter() - start)
        found["memory"] = peak()
        print(json.dumps(found), file=answers, flush=True)


if __name__ == "__main__":
    serve(sys.argv[1], int(sys.argv[2]))
