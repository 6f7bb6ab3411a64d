"""Rows on disk: one JSON a line, written at once, so that an interrupted study loses nothing."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from kowalevski_cas.files import write
from study.machine import machine
from study.step import Row, Step

Progress = Callable[[str, int, int], None]
Key = tuple[str, str]


def data_file(folder: Path, name: str) -> Path:
    """Where the rows of a step are stored: a first line says where they were measured."""
    return folder / "data" / f"{name}.jsonl"


def measure(
    name: str, step: Step, folder: Path, quick: bool, progress: Progress, afresh: bool = False
) -> list[Row]:
    """The rows of a step: those that are stored, and those that were missing, measured now.

    Rows of another machine, or of other versions, are no part of this study. ``afresh``
    forgets what is stored.
    """
    path = data_file(folder, name)
    found = list(step.measure(quick))
    tasks = {(task.method, task.case): task for task in found}
    if len(tasks) < len(found):
        raise ValueError(f"two tasks of the step “{name}” have the same method and case")
    header: Mapping[str, Any] = {"step": name, "quick": quick, "machine": machine()}
    before, known = _read(path)
    rows = {key: known[key] for key in tasks if key in known and before == header and not afresh}
    write(path, "".join(map(_line, (header, *rows.values()))))
    for done, (key, task) in enumerate(tasks.items()):
        if key not in rows:
            progress(f"{name}: {task.method}, {task.case}", done, len(tasks))
            with path.open("a", encoding="utf-8") as file:
                file.write(_line(task.row()))
    return stored(name, folder)


def stored(name: str, folder: Path) -> list[Row]:
    """The rows of a step that were measured before."""
    return list(_read(data_file(folder, name))[1].values())


def _read(path: Path) -> tuple[Mapping[str, Any], dict[Key, Row]]:
    """The header of a file and its rows; none if there is no file."""
    header: Mapping[str, Any] = {}
    rows: dict[Key, Row] = {}
    lines = path.read_bytes().splitlines() if path.is_file() else []
    for number, line in enumerate(lines):
        try:
            entry = json.loads(line)
            if number == 0:
                header = dict(entry)
            elif entry.keys() >= {"method", "case", "verdict"}:
                rows[entry["method"], entry["case"]] = entry
        except (ValueError, TypeError, AttributeError, RecursionError):
            continue  # torn when the study was interrupted, or damaged: it is measured again
    return header, rows


def _line(entry: Mapping[str, Any]) -> str:
    return json.dumps(_rounded(entry), ensure_ascii=False, separators=(",", ":")) + "\n"


def _rounded(value: Any) -> Any:
    """Measured numbers have four digits: no more of them is ever the same twice."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, Mapping):
        return {key: _rounded(item) for key, item in value.items()}
    return [_rounded(item) for item in value] if isinstance(value, list) else value
