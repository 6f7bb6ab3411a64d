"""A process that goes on from step to step until a limit stops it."""

from __future__ import annotations

import os
import re
import resource
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from threading import Timer
from time import perf_counter

from study.step import Measured

MEBIBYTE = 2**20

_MEMORY = ("MemoryError", "out of memory", "not enough memory", "stack overflows")
"""What programs say when there is no more memory."""

_PATIENCE = 2.0
"""How many seconds a program has to say all that is wrong."""

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
    wrong: list[str] = []
    start = perf_counter()
    unbuffered = ["stdbuf", "-oL"] if shutil.which("stdbuf") else []
    process = subprocess.Popen(
        [*unbuffered, *command],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=None if environment is None else {**os.environ, **environment},
        encoding="utf-8",
        errors="replace",
        preexec_fn=limit,
    )
    ends: list[Timer] = []
    try:
        ends += [Timer(seconds, process.kill), Timer(_PATIENCE, process.kill)]
        ends[0].start()
        assert process.stdout is not None
        for line in map(str.strip, process.stdout):
            if wrong:
                wrong.append(line)
            elif found := _STEP.match(line):
                steps.append(int(found[1]))
                times.append(float(found[2]))
                memory.append(_peak(process.pid))
            elif line and "Warning: " not in line:
                wrong.append(line)
                ends[1].start()  # what it says after an error, or a limit, means nothing
        code = process.wait()
    finally:
        for end in ends:
            end.cancel()
        process.kill()
        process.communicate()
    spent = perf_counter() - start
    if any(word in line for word in _MEMORY for line in wrong):
        verdict, reason = "timeout", f"{mebibytes} MiB"
    elif code and not wrong and spent >= seconds:
        verdict, reason = "timeout", f"{seconds:g} s"
    else:
        reason = wrong[0][:100] if wrong else f"exit code {code}" if code else ""
        verdict = "stopped" if reason else "reached"
    return {
        "seconds": spent,
        "verdict": verdict,
        "reason": reason,
        "steps": steps,
        "times": times,
        "memory": memory,
    }


def _peak(pid: int) -> int | None:
    """The most memory that a process has had, in bytes; ``None`` where it cannot be asked."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    except OSError:
        return None
    lines = (line.split() for line in status.splitlines() if line.startswith("VmHWM:"))
    return next((1024 * int(words[1]) for words in lines), None)
