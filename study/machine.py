"""Where a measurement was made: the machine, and the versions of what took part."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

LIBRARIES = ("python-flint", "symengine", "sympy", "numpy", "scipy", "matplotlib", "heyoka")

PROGRAMS = {
    "coqc": ("coqc", "--print-version"),
    "singular": ("Singular", "--version"),
    "pari": ("gp", "--version-short"),
    "maxima": ("maxima", "--version"),
}
"""The programs that are compared with, and how each tells its version."""


@cache
def machine() -> dict[str, str]:
    """Processor, cores, memory, system, and versions; what is not installed is left out."""
    found = {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "memory": _memory(),
        "system": f"{platform.system()} {platform.machine()}",
        "Python": platform.python_version(),
    }
    for library in LIBRARIES:
        try:
            found[library] = version(library)
        except PackageNotFoundError:
            continue
    for name in PROGRAMS:
        if shown := program_version(name):
            found[name] = shown
    return found


def program_version(name: str) -> str:
    """The version of a program; empty if it is not installed."""
    command = PROGRAMS[name]
    if shutil.which(command[0]) is None:
        return ""
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=20, stdin=subprocess.DEVNULL
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    words = done.stdout.replace("\n", " ").split()
    return next((word for word in words if word[0].isdigit()), "")


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or "unknown"


def _memory() -> str:
    try:
        size = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        return "unknown"
    return f"{size / 2**30:.0f} GiB"
