"""Pictures that other commands left beside a report, to be shown in it.

A folder below that of the reports has a list of them, ``figures.json``::

    {"format": "kowalevski-cas figures", "version": 1,
     "derivations": {"kharlamov2002": [{"name": "torus", "caption": "A torus."}]}}

and each picture as ``torus.png``, and as ``torus.svg`` too where it is a drawing of few lines.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kowalevski_cas.files import read_json

LIST: Final = "figures.json"

SUFFIX: Final = ".png"


@dataclass(frozen=True)
class FigureFile:
    """A picture: where it is, relative to the report and without suffix, and what it shows.

    ``caption`` is plain text with mathematics between dollars.
    """

    place: str
    caption: str

    def file(self, folder: Path) -> Path:
        """The picture below the folder of the report."""
        return folder / f"{self.place}{SUFFIX}"

    def drawing(self, folder: Path) -> str:
        """The picture as an element of a page, if it is a drawing of lines; else nothing."""
        file = self.file(folder).with_suffix(".svg")
        return file.read_text(encoding="utf-8") if file.is_file() else ""


def figures_of(folder: Path, derivation: str) -> tuple[FigureFile, ...]:
    """The pictures of a derivation that are there, in the folder of its report.

    A list that cannot be read, or a picture that is not there, is passed over.
    """
    found = []
    for file in sorted(folder.glob(f"*/{LIST}")):
        try:
            content = read_json(file)
            entries = content["derivations"].get(derivation, ())
            listed = [(str(entry["name"]), str(entry["caption"])) for entry in entries]
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            continue
        found += [
            FigureFile(f"{file.parent.name}/{name}", caption)
            for name, caption in listed
            if (file.parent / f"{name}{SUFFIX}").is_file()
        ]
    return tuple(found)


def copy_figures(found: tuple[FigureFile, ...], source: Path, target: Path) -> None:
    """Copy pictures from the folder of a report to where it is typeset."""
    for figure in found:
        copy = figure.file(target)
        copy.parent.mkdir(exist_ok=True)
        shutil.copyfile(figure.file(source), copy)
