"""Programs under a limit of time and memory, which are watched as they go on.

No method can stop the study, and what it costs is measured where it runs. A limit that is
reached is the verdict ``timeout`` with its reason, never a success.
"""

from __future__ import annotations

import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from threading import Event, Thread
from time import perf_counter
from typing import Any

from study.step import Measured

MEBIBYTE = 2**20

_MEMORY = ("MemoryError", "out of memory", "not enough memory", "stack overflows")
"""What programs say when there is no more memory."""

_WAITING = 10
"""So many times as long as it may work a program is waited for: the machine has other work."""

_LOOKS = 0.05
"""After so many seconds it is looked at again what a program has worked."""

FAILS = "fails"
"""What a program says that has come to something else."""

_STEP = re.compile(r"^step (\d+)$")


def limit_memory(mebibytes: int) -> None:
    """Limit the memory of this process, and of those that it begins."""
    resource.setrlimit(resource.RLIMIT_AS, (mebibytes * MEBIBYTE, mebibytes * MEBIBYTE))


def processor_seconds() -> float:
    """What this process, and those that it began and that have ended, have worked so far."""
    used = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(one.ru_utime + one.ru_stime for one in used)


@contextmanager
def kill_after(process: subprocess.Popen[str], seconds: float) -> Iterator[None]:
    """Kill a process that works longer while the body runs, or waits many times as long."""
    ended, latest = Event(), perf_counter() + _WAITING * seconds

    def watch() -> None:
        while not ended.wait(_LOOKS):
            if (_worked(process.pid) or 0.0) >= seconds or perf_counter() >= latest:
                process.kill()

    Thread(target=watch, daemon=True).start()
    try:
        yield
    finally:
        ended.set()


def race(
    command: Sequence[str], folder: Path, seconds: float, mebibytes: int, most: int
) -> Measured:
    """Run a command that says ``step k`` each time that it has come further, up to ``most``.

    It may work for so many ``seconds``, by the clock of the processor.

    The lists ``steps``, ``times`` (what it has worked since it was started) and ``memory`` (the
    most that it has had so far, in bytes; both where the system tells it) have an entry for each
    step that was reached; ``reason`` says what stopped it: a limit, or nothing.
    """
    found: dict[str, list[Any]] = {"steps": [], "times": [], "memory": []}
    began = perf_counter()
    process = subprocess.Popen(
        [*(["stdbuf", "-oL"] if shutil.which("stdbuf") else []), *command],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        encoding="utf-8",
        errors="replace",
        preexec_fn=partial(limit_memory, mebibytes),
    )
    with process:
        try:
            with kill_after(process, seconds):
                said = _follow(process, found)
                code = process.wait()
        finally:
            process.kill()
    spent = perf_counter() - began
    if found["steps"][-1:] == [most] and not code:
        verdict, reason = "reached", ""
    elif any(word in line for word in _MEMORY for line in said):
        verdict, reason = "timeout", f"{mebibytes} MiB"
    elif code == -signal.SIGKILL:
        verdict, reason = "timeout", f"{seconds:g} s"
    else:
        verdict = "stopped"
        last = said[-1][:100] if said else f"exit code {code}"
        reason = FAILS if FAILS in said else last
    return {"seconds": spent, "verdict": verdict, "reason": reason, **found}


def _follow(process: subprocess.Popen[str], found: dict[str, list[Any]]) -> list[str]:
    """Keep what is reached; the lines that are no steps."""
    assert process.stdout
    said = []
    for line in map(str.strip, process.stdout):
        if step := _STEP.match(line):
            found["steps"].append(int(step[1]))
            found["times"].append(_worked(process.pid))
            found["memory"].append(_peak(process.pid))
        elif line:
            said.append(line)
    return said


def _worked(pid: int) -> float | None:
    """The seconds that a process has worked; ``None`` where the system does not tell."""
    try:
        return time.clock_gettime((~pid << 3) | 2)  # the clock of that process, for Linux
    except (AttributeError, OSError):
        return None


def _peak(pid: int) -> int | None:
    """The most memory that a process has had, in bytes; ``None`` where it cannot be asked."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    except OSError:
        return None
    lines = (line.split() for line in status.splitlines() if line.startswith("VmHWM:"))
    return next((1024 * int(words[1]) for words in lines), None)
