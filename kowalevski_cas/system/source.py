"""Displays from the source of a paper, by their labels."""

from __future__ import annotations

import sys
from pathlib import Path

from kowalevski_cas.library import READ


def display(source: str, label: str) -> str:
    r"""The display with this label in a TeX file, its macros written out: as it stands there now.

    A relative path is one from the folder of the file that asks.

    Raises:
        ValueError: the file cannot be read, or has no display, or several, with this label.
    """
    from kowalevski_cas.source.files import read_source
    from kowalevski_cas.source.formulas import typed_formulas  # seldom asked for

    here = sys._getframe(1).f_globals.get("__file__", "")
    path = Path(here).parent / source
    if path.is_file():
        READ[path] = path.stat().st_mtime_ns
    found = [formula for formula in typed_formulas(read_source(path))[1] if label in formula.labels]
    if len(found) != 1:
        raise ValueError(f"{path} has {len(found) or 'no'} displays with the label {label}")
    if found[0].trouble:
        raise ValueError(f"{path}: the display {label} cannot be read: {found[0].trouble}")
    return found[0].tex
