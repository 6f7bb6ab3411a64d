"""How a motion is written: one file for each format."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kowalevski_cas.motion.result import Result

FORMATS = ("json", "csv", "npz")


def load_format(name: str) -> Callable[[Result], bytes]:
    """The function that turns a motion into the contents of a file."""
    render: Callable[[Result], bytes] = import_module(f"{__name__}.{name}").render
    return render
