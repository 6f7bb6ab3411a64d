"""The run of a study: measure what is missing, store each row at once, draw."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from study.machine import machine
from study.step import Measured, Row, Step, Task
from study.store import Store

Progress = Callable[[str, int, int], None]


def data_file(folder: Path, name: str) -> Path:
    """Where the rows of a step are stored."""
    return folder / "data" / f"{name}.jsonl"


def measure(
    name: str, step: Step, folder: Path, quick: bool, progress: Progress, afresh: bool = False
) -> list[Row]:
    """The rows of a step: those that are stored, and those that were missing, measured now.

    ``afresh`` forgets what is stored.
    """
    header = {"step": name, "quick": quick, "machine": machine()}
    store = Store(data_file(folder, name), header)
    if afresh:
        store.rows.clear()
    tasks = list(step.measure(quick))
    keys = [(task.method, task.case) for task in tasks]
    if len(set(keys)) < len(keys):
        raise ValueError(f"two tasks of the step “{name}” have the same method and case")
    store.rows = {key: store.rows[key] for key in keys if key in store.rows}
    store.begin()
    for done, task in enumerate(tasks):
        if (task.method, task.case) not in store.rows:
            progress(f"{name}: {task.method}, {task.case}", done, len(tasks))
            store.add({"method": task.method, "case": task.case, **_measured(task)})
    return stored(name, folder)


def stored(name: str, folder: Path) -> list[Row]:
    """The rows of a step that were measured before."""
    return list(Store(data_file(folder, name)).rows.values())


def _measured(task: Task) -> Measured:
    try:
        return task.run()
    except Exception as error:
        return {
            "seconds": None,
            "verdict": "error",
            "reason": f"{type(error).__name__}: {error}",
        }
