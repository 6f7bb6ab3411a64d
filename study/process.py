"""Processes under a limit of time and memory: asked again and again, or watched as they go on.

No method can stop the study, and what it costs is measured where it runs. A limit that is
reached is the verdict ``timeout`` with its reason, never a success.
"""

from __future__ import annotations

import json
import os
import re
import resource
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from threading import Timer
from time import perf_counter
from typing import Any

from study.step import Measured

MEBIBYTE = 2**20

_MEMORY = ("MemoryError", "out of memory", "not enough memory", "stack overflows")
"""What programs say when there is no more memory."""

_PATIENCE = 2.0
"""How many seconds a program has to say all that is wrong."""

_STEP = re.compile(r"^step (\d+) (\S+)$")


def start(
    command: Sequence[str], folder: Path | None, mebibytes: int, stdin: int = subprocess.DEVNULL
) -> subprocess.Popen[str]:
    """Start a command that may take so much memory; Python finds there what it finds here."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (mebibytes * MEBIBYTE, mebibytes * MEBIBYTE))

    unbuffered = ["stdbuf", "-oL"] if shutil.which("stdbuf") else []
    return subprocess.Popen(
        [*unbuffered, *command],
        cwd=folder,
        stdin=stdin,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        encoding="utf-8",
        errors="replace",
        preexec_fn=limit,
    )


def end(process: subprocess.Popen[str]) -> None:
    """End a process, and wait for its end."""
    with process:
        process.kill()


@contextmanager
def killed_after(process: subprocess.Popen[str], seconds: float) -> Iterator[None]:
    """Kill a process if the body takes longer."""
    timer = Timer(seconds, process.kill)
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


# -- asked again and again -----------------------------------------------------------


class Worker:
    """A process that answers questions by :func:`serve`; after a limit another one is started."""

    def __init__(self, command: Sequence[str], seconds: float, mebibytes: int) -> None:
        self.command, self.seconds, self.mebibytes = command, seconds, mebibytes
        self._process: subprocess.Popen[str] | None = None

    def ask(self, question: Any) -> Measured:
        """The answer, with the ``seconds`` that it took."""
        if self._process is None:
            self._process = start(self.command, None, self.mebibytes, subprocess.PIPE)
            self._said()  # it is ready: what the limit counts begins here
        began = perf_counter()
        try:
            with killed_after(self._process, self.seconds):
                said = self._said(question)
        except BaseException:
            self.close()  # an interruption reaches the process only if it comes from a terminal
            raise
        if said.endswith("\n"):
            answer: Measured = json.loads(said)
            return answer
        code, spent = self._process.wait(), perf_counter() - began
        self.close()
        if code < 0 and spent >= self.seconds:
            return {"verdict": "timeout", "reason": f"{self.seconds:g} s", "seconds": spent}
        return {"verdict": "error", "reason": f"the process ended with {code}", "seconds": spent}

    def _said(self, question: Any = None) -> str:
        """The next line, after a question; empty if the process has ended."""
        assert self._process and self._process.stdin and self._process.stdout
        try:
            if question is not None:
                self._process.stdin.write(json.dumps(question) + "\n")
                self._process.stdin.flush()
        except BrokenPipeError:
            return ""
        said = (line for line in self._process.stdout if line.startswith(("{", "ready")))
        return next(said, "")

    def close(self) -> None:
        """End the process, if there is one."""
        if self._process is not None:
            end(self._process)
            self._process = None


def serve(answer: Callable[[Any], Measured]) -> None:
    """Answer questions, a line of JSON each, until there are no more."""
    print("ready", flush=True)
    for line in sys.stdin:
        began = perf_counter()
        try:
            with redirect_stdout(None):  # a library may print
                found = dict(answer(json.loads(line)))
        except MemoryError:
            most = resource.getrlimit(resource.RLIMIT_AS)[0] // MEBIBYTE
            found = {"verdict": "timeout", "reason": f"{most} MiB"}
        except Exception as error:
            found = {"verdict": "error", "reason": f"{type(error).__name__}: {error}"[:300]}
        print(json.dumps({"seconds": perf_counter() - began, **found}), flush=True)


# -- watched as it goes on -----------------------------------------------------------


def race(command: Sequence[str], folder: Path, seconds: float, mebibytes: int) -> Measured:
    """Run a command that says ``step k seconds`` each time that it has come further.

    The lists ``steps``, ``times`` (as the process tells them) and ``memory`` (the most
    that it has had so far, in bytes, where the system tells it) have an entry for each
    step that was reached; ``reason`` says what stopped it: a limit, or nothing.
    """
    found: dict[str, list[Any]] = {"steps": [], "times": [], "memory": []}
    began = perf_counter()
    process = start(command, folder, mebibytes)
    try:
        with killed_after(process, seconds):
            wrong = _followed(process, found)
            code = process.wait()
    finally:
        end(process)
    spent = perf_counter() - began
    if any(word in line for word in _MEMORY for line in wrong):
        verdict, reason = "timeout", f"{mebibytes} MiB"
    elif code and not wrong and spent >= seconds:
        verdict, reason = "timeout", f"{seconds:g} s"
    else:
        reason = wrong[0][:100] if wrong else f"exit code {code}" if code else ""
        verdict = "stopped" if reason else "reached"
    return {"seconds": spent, "verdict": verdict, "reason": reason, **found}


def _followed(process: subprocess.Popen[str], found: dict[str, list[Any]]) -> list[str]:
    """Keep what is reached; the lines from the first that is no step, which mean an error."""
    assert process.stdout
    for line in map(str.strip, process.stdout):
        if step := _STEP.match(line):
            found["steps"].append(int(step[1]))
            found["times"].append(float(step[2]))
            found["memory"].append(_peak(process.pid))
        elif line and "Warning: " not in line:
            with killed_after(process, _PATIENCE):
                return [line, *process.stdout]
    return []


def _peak(pid: int) -> int | None:
    """The most memory that a process has had, in bytes; ``None`` where it cannot be asked."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    except OSError:
        return None
    lines = (line.split() for line in status.splitlines() if line.startswith("VmHWM:"))
    return next((1024 * int(words[1]) for words in lines), None)
