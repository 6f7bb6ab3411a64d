"""Nobody ends this process at once: who asked would hear nothing, and take it for success."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache

ENDS = ("_exit", "abort", "execv", "execve")
"""What ends a process at once; another program takes its place by the last two."""

NATIVE = {"_exit", "_Exit", "exit", "quick_exit", "abort"}
"""The functions of C that do."""

_guarding: list[int] = []
"""The processes in which they are refused, in the order in which this was asked for."""


@contextmanager
def no_exit() -> Iterator[None]:
    """Refuse what ends this process at once by a ``ValueError``, in other threads as well.

    A process that is begun meanwhile may end as it likes.
    """
    here, before = os.getpid(), {name: getattr(os, name) for name in ENDS}

    def refuse(name: str) -> Callable[..., None]:
        def end(*arguments: object) -> None:
            if os.getpid() != here:
                before[name](*arguments)
            raise ValueError(f"os.{name} would end the program: leave it out")

        return end

    _watch_native()
    _guarding.append(here)
    try:
        for name in ENDS:
            setattr(os, name, refuse(name))
        yield
    finally:
        _guarding.pop()
        for name, function in before.items():
            setattr(os, name, function)


@cache
def _watch_native() -> None:
    """Refuse to look up what ends a process in a library of C; a hook stays for good."""

    def hook(event: str, arguments: tuple[object, ...]) -> None:
        if event == "ctypes.dlsym" and arguments[1] in NATIVE and os.getpid() in _guarding:
            raise ValueError(f"{arguments[1]} would end the program: leave it out")

    sys.addaudithook(hook)
