"""Where a measurement was made: the machine, and the versions of what took part."""

from __future__ import annotations

import os
import platform
from functools import cache
from pathlib import Path

from kowalevski_cas.cli.session import installed_versions
from kowalevski_cas.export.witness import version
from kowalevski_cas.tools import TOOLS, MissingTool, Tool

LIBRARIES = ("python-flint", "symengine", "sympy", "numpy", "scipy", "matplotlib", "heyoka")


@cache
def machine() -> dict[str, str]:
    """Processor, cores, memory, system, and versions; what is not installed is left out."""
    known = {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "memory": _memory(),
        "system": f"{platform.system()} {platform.machine()}",
        "Python": platform.python_version(),
    }
    tools = {name: number for name, tool in TOOLS.items() if (number := _number(tool))}
    return known | installed_versions(*LIBRARIES) | tools


def _number(tool: Tool) -> str:
    """The number of a system's version; empty if it is not installed."""
    try:
        words = version(tool).split()
    except MissingTool:
        return ""
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
