"""Pictures that other commands left beside a report, to be shown in it.

A folder below that of the reports has a list of them, ``plates.json``::

    {"derivation": "kharlamov2002", "plates": [{"name": "torus", "caption": "A torus."}]}

and each picture as ``torus.pdf`` and ``torus.svg``.
"""

from __future__ import annotations

import json
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Final

LIST: Final = "plates.json"

_SUFFIXES: Final = (".pdf", ".svg")


@dataclass(frozen=True)
class Plate:
    """A picture: where it is, relative to the report and without suffix, and what it shows.

    ``caption`` is plain text with mathematics between dollars.
    """

    place: str
    caption: str


def plates(folder: Path, derivation: str) -> tuple[Plate, ...]:
    """The pictures of a derivation that are there, in the folder of its report.

    A list that cannot be read, or a picture that is not there as a whole, is passed over.
    """
    found = []
    for file in sorted(folder.glob(f"*/{LIST}")):
        try:
            content = json.loads(file.read_text(encoding="utf-8"))
            if content["derivation"] != derivation:
                continue
            listed = [(str(entry["name"]), str(entry["caption"])) for entry in content["plates"]]
        except (OSError, ValueError, KeyError, TypeError):
            continue
        found += [
            Plate(f"{file.parent.name}/{name}", caption)
            for name, caption in listed
            if all((file.parent / f"{name}{suffix}").is_file() for suffix in _SUFFIXES)
        ]
    return tuple(found)


def copy_plates(found: tuple[Plate, ...], source: Path, target: Path) -> None:
    """Copy pictures from the folder of a report to where it is typeset."""
    for plate in found:
        for suffix in _SUFFIXES:
            copy = target / f"{plate.place}{suffix}"
            copy.parent.mkdir(exist_ok=True)
            shutil.copyfile(source / f"{plate.place}{suffix}", copy)
