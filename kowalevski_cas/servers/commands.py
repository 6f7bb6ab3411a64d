"""Commands of this program in processes of their own: no stranger's file ends a server."""

from __future__ import annotations

import asyncio
import json
import sys
from contextlib import suppress
from typing import Any, NamedTuple

LONGEST = 600.0
"""Seconds that a command has at most."""

GRACE = 2.0
"""Seconds in which a command that is not wanted any more ends by itself."""


class CommandAnswer(NamedTuple):
    """What a command printed, and its exit code."""

    code: int
    output: str
    errors: str

    @property
    def document(self) -> dict[str, Any] | None:
        """The document of JSON that it printed, if it came to one."""
        with suppress(ValueError):
            found: dict[str, Any] = json.loads(self.output)
            return found
        return None


async def run_command(*words: str, text: str | None = None) -> CommandAnswer:
    """What a command prints, with a text as its standard input; it ends if this is cancelled.

    Raises:
        TimeoutError: it takes too long.
    """
    process = await asyncio.create_subprocess_exec(
        sys.executable, "-m", "kowalevski_cas", *words,
        stdin=asyncio.subprocess.DEVNULL if text is None else asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE,
    )  # fmt: skip
    try:
        async with asyncio.timeout(LONGEST):
            data = None if text is None else text.encode()
            output, errors = await process.communicate(data)
    finally:
        if process.returncode is None:
            await _end(process)
    assert process.returncode is not None
    return CommandAnswer(
        process.returncode, output.decode(), errors.decode(errors="replace").strip()
    )


async def _end(process: asyncio.subprocess.Process) -> None:
    """End a command with the processes that it has begun."""
    with suppress(ProcessLookupError):
        process.terminate()
    try:
        async with asyncio.timeout(GRACE):
            await process.communicate()
    except TimeoutError:
        with suppress(ProcessLookupError):
            process.kill()
        await process.communicate()
