"""Where a measurement was made: the machine, and the versions of what took part."""

from __future__ import annotations

import os
import platform
import re
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from kowalevski_cas.cli.session import installed_versions
from kowalevski_cas.export.witness import answer
from kowalevski_cas.tools import TOOLS, MissingTool, Tool

LIBRARIES = ("python-flint", "symengine", "sympy", "numpy", "scipy", "matplotlib", "heyoka")

GIAC = Tool("Giac", (("giac",),), "xcas", "polynomials")
"""A system that confirms no certificates, and is measured beside those that do."""


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
    every = {**TOOLS, "giac": GIAC}
    tools = {name: number for name, tool in every.items() if (number := _number(tool))}
    return known | installed_versions(*LIBRARIES) | tools


def _number(tool: Tool) -> str:
    """The number of a system's version; empty if it is not installed."""
    try:
        with TemporaryDirectory() as folder:  # Giac leaves a protocol there
            _, said = answer([*tool.call(), *tool.version], Path(folder))
    except MissingTool:
        return ""
    number = re.search(r"(?<!\w)\d+\.\d[\w.]*", said)
    return number[0] if number else ""


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
