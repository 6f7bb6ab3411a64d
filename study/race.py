"""A process that goes on from step to step until a limit stops it."""

from __future__ import annotations

import os
import re
import resource
import select
import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter

from study.step import Measured

MEBIBYTE = 2**20
_MEMORY = (b"MemoryError", b"out of memory", b"not enough memory", b"stack overflows")
"""What programs say when there is no more memory."""

_PATIENCE = 2.0
"""How many seconds a program may be silent before what it said is taken for all of it."""

_STEP = re.compile(r"^step (\d+) (\S+)$")


def race(
    command: Sequence[str],
    folder: Path,
    seconds: float,
    mebibytes: int,
    environment: Mapping[str, str] | None = None,
) -> Measured:
    """Run a command that says ``step k seconds`` each time that it has come further.

    The lists ``steps``, ``times`` (as the process tells them) and ``memory`` (the most
    that it has had so far, in bytes, where the system tells it) have an entry for each
    step that was reached; ``reason`` says what stopped it: a limit, or nothing.
    """

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (mebibytes * MEBIBYTE, mebibytes * MEBIBYTE))

    steps: list[int] = []
    times: list[float] = []
    memory: list[int | None] = []
    start = perf_counter()
    unbuffered = ["stdbuf", "-oL"] if shutil.which("stdbuf") else []
    with (
        subprocess.Popen(
            [*unbuffered, *command],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env=None if environment is None else {**os.environ, **environment},
            preexec_fn=limit,
        ) as process,
        _ended(process),
    ):
        assert process.stdout is not None
        chunk, text, verdict, reason = b"", b"", "reached", ""
        while verdict == "reached":
            left = seconds - (perf_counter() - start)
            ready = select.select([process.stdout], [], [], max(0.0, left))[0]
            if not ready:
                verdict, reason = "timeout", f"{seconds:g} s"
                break
            chunk = os.read(process.stdout.fileno(), 65536)
            if not chunk:
                break
            *lines, text = (text + chunk).split(b"\n")
            for line in lines:
                words = line.decode("utf-8", "replace").strip()
                if found := _STEP.match(words):
                    steps.append(int(found[1]))
                    times.append(float(found[2]))
                    memory.append(_peak(process.pid))
                elif words and "Warning: " not in words:
                    verdict, reason = "stopped", words[:100]
                    break
        while verdict == "stopped":
            if any(word in chunk for word in _MEMORY):
                verdict, reason = "timeout", f"{mebibytes} MiB"
            elif not select.select([process.stdout], [], [], _PATIENCE)[0]:
                break
            elif more := os.read(process.stdout.fileno(), 65536):
                chunk += more
            else:
                break
        if verdict != "reached":
            process.kill()  # what it says after an error, or a limit, means nothing
        code = process.wait()
    if verdict == "reached" and code:
        verdict, reason = "stopped", f"exit code {code}"
    return {
        "seconds": perf_counter() - start,
        "verdict": verdict,
        "reason": reason,
        "steps": steps,
        "times": times,
        "memory": memory,
    }


@contextmanager
def _ended(process: subprocess.Popen[bytes]) -> Iterator[None]:
    """End a process if its race is interrupted; only a terminal would interrupt it as well."""
    try:
        yield
    except BaseException:
        process.kill()
        raise


def _peak(pid: int) -> int | None:
    """The most memory that a process has had, in bytes; ``None`` where it cannot be asked."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    except OSError:
        return None
    lines = (line.split() for line in status.splitlines() if line.startswith("VmHWM:"))
    return next((1024 * int(words[1]) for words in lines), None)
