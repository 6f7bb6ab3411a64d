"""The page of the study."""

from __future__ import annotations

from pathlib import Path

from kowalevski_cas.files import write
from study import STEPS, load


def write_page(folder: Path) -> None:
    """Show the charts that are in a folder with their captions."""
    steps = {name: load(name) for name in STEPS if (folder / f"{name}.png").is_file()}
    charts = (
        f"\n## {step.TITLE}\n\n![{step.TITLE}]({name}.png)\n\n{step.CAPTION}\n"
        for name, step in steps.items()
    )
    write(folder / "README.md", "# The study\n" + "".join(charts))
