"""Rows on disk: one JSON a line, written at once, so that an interrupted study loses nothing."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from study.step import Row

Key = tuple[str, str]


class Store:
    """The rows of one step in a file, whose first line says where they were measured.

    Rows of another machine, or of other versions, are no part of this study:
    ``header`` has to be the same for a file to be continued.
    """

    def __init__(self, path: Path, header: Mapping[str, Any] | None = None) -> None:
        self.path = path
        self.header: Mapping[str, Any] = {}
        self.rows: dict[Key, Row] = {}
        self._read()
        self.continued = header is None or self.header == header
        if header is not None and not self.continued:
            self.header, self.rows = header, {}

    def _read(self) -> None:
        try:
            lines = self.path.read_bytes().splitlines()
        except FileNotFoundError:
            return
        for number, line in enumerate(lines):
            try:
                entry = json.loads(line)
                if number == 0:
                    self.header = dict(entry)
                elif entry.keys() >= {"method", "case", "verdict"}:
                    self.rows[entry["method"], entry["case"]] = entry
            except (ValueError, TypeError, AttributeError, RecursionError):
                continue  # torn when the study was interrupted, or damaged: it is measured again

    def begin(self) -> None:
        """Write what is kept, without torn lines, and make ready for more."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        lines = [_line(self.header), *map(_line, self.rows.values())]
        whole = self.path.with_suffix(".new")
        whole.write_text("".join(lines), encoding="utf-8")
        whole.replace(self.path)

    def add(self, row: Row) -> None:
        """Keep a row, on disk at once."""
        self.rows[row["method"], row["case"]] = row
        with self.path.open("a", encoding="utf-8") as file:
            file.write(_line(row))


def _line(entry: Mapping[str, Any]) -> str:
    return json.dumps(_rounded(entry), ensure_ascii=False, separators=(",", ":")) + "\n"


def _rounded(value: Any) -> Any:
    """Measured numbers have four digits: no more of them is ever the same twice."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, Mapping):
        return {key: _rounded(item) for key, item in value.items()}
    return [_rounded(item) for item in value] if isinstance(value, list) else value
