"""The page of the study, and the charts that the report of the first paper shows."""

from __future__ import annotations

import json
from pathlib import Path

from kowalevski_cas.files import write
from kowalevski_cas.report.plates import LIST
from study import STEPS, load
from study.paper import FIRST

REPORTED = ("speed-accuracy", "growth")
"""The charts about the ways in which the claims of the first paper are checked."""


def write_page(folder: Path) -> None:
    """Show the charts that are in a folder with their captions, and list those for the report."""
    steps = {name: load(name) for name in STEPS if (folder / f"{name}.png").is_file()}
    charts = (
        f"\n## {step.TITLE}\n\n![{step.TITLE}]({name}.png)\n\n{step.CAPTION}\n"
        for name, step in steps.items()
    )
    write(folder / "README.md", "# The study\n" + "".join(charts))
    plates = [{"name": n, "caption": s.CAPTION} for n, s in steps.items() if n in REPORTED]
    listed = {FIRST: plates}
    write(folder / LIST, json.dumps(listed, indent=1, ensure_ascii=False) + "\n")
