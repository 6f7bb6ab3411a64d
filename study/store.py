"""Rows on disk: one JSON a line, written in their order, so that an interrupted study goes on."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from kowalevski_cas.files import write
from kowalevski_cas.pool import HERE, Pool
from study import load
from study.machine import machine
from study.step import Row, StudyStep, Task

Progress = Callable[[str, int, int], None]
Key = tuple[str, str]


def data_file(folder: Path, name: str) -> Path:
    """Where the rows of a step are stored: a first line says where they were measured."""
    return folder / "data" / f"{name}.jsonl"


def measure(
    name: str,
    step: StudyStep,
    folder: Path,
    quick: bool,
    progress: Progress,
    afresh: bool = False,
    pool: Pool = HERE,
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
    _TASKS[name, quick] = tasks
    missing = [key for key in tasks if key not in rows]
    for done, row in enumerate(pool.map(partial(_row, name, quick), missing), 1):
        with path.open("a", encoding="utf-8") as file:
            file.write(_line(row))
        progress(f"{name}: {row['method']}, {row['case']}", len(rows) + done, len(tasks))
    measured = _read(path)[1]
    write(path, "".join(map(_line, (header, *(measured[key] for key in tasks)))))
    return load_rows(name, folder)


_TASKS: dict[tuple[str, bool], Mapping[Key, Task]] = {}
"""The tasks of steps, as far as this process knows them."""


def _row(name: str, quick: bool, key: Key) -> Row:
    """Measure one task of a step."""
    if (name, quick) not in _TASKS:
        found = load(name).measure(quick)
        _TASKS[name, quick] = {(task.method, task.case): task for task in found}
    return _TASKS[name, quick][key].row()


def load_rows(name: str, folder: Path) -> list[Row]:
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
    return json.dumps(_round(entry), ensure_ascii=False, separators=(",", ":")) + "\n"


def _round(value: Any) -> Any:
    """Measured numbers have four digits: no more of them is ever the same twice."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, Mapping):
        return {key: _round(item) for key, item in value.items()}
    return [_round(item) for item in value] if isinstance(value, list) else value
