"""Files are read if they are files, and written whole.

Nobody waits for a pipe that is found in the place of a file, or reads a device without end; and
nobody finds half a file, whatever happens meanwhile.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from errno import EFBIG, EINVAL
from pathlib import Path
from tempfile import mkstemp
from typing import Any

LARGEST = 20_000_000
"""Bytes of a file that is read; the largest certificate has a hundredth of this."""


def read(path: Path) -> str:
    """The text of a file.

    Raises:
        OSError: it cannot be read, is no file (but a pipe, or a device), or is too large.
        ValueError: it is no text in UTF-8.
    """
    if path.exists() and not path.is_file():
        raise OSError(EINVAL, "is no file", str(path))
    if path.stat().st_size > LARGEST:
        raise OSError(EFBIG, f"has more than {LARGEST:,} bytes", str(path))
    return path.read_text(encoding="utf-8")


def read_json(path: Path) -> Any:
    """The data in a file of JSON.

    Raises:
        OSError: it cannot be read.
        ValueError: it is no JSON, or is nested too deeply.
    """
    try:
        return json.loads(read(path))
    except RecursionError:
        raise ValueError("it is nested too deeply") from None


def write(path: Path, contents: str | bytes) -> None:
    """Write a file under another name and move it into place; its folder is made if need be.

    Raises:
        OSError: the file cannot be written; what stood there before is as it was.
    """
    data = contents.encode() if isinstance(contents, str) else contents
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, unfinished = mkstemp(dir=path.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            os.chmod(unfinished, 0o644)
            os.replace(unfinished, path)
        except BaseException:
            Path(unfinished).unlink(missing_ok=True)
            raise
    except OSError as error:
        words = f"cannot be written: {error.strerror}"
        raise OSError(error.errno, words, str(path)) from None


def write_all(files: Mapping[Path, str | bytes]) -> None:
    """Write files so that all of them appear, or none does.

    Raises:
        OSError: one of them cannot be written; all are as they were before.
    """
    before = {path: path.read_bytes() for path in files if path.is_file()}
    try:
        for path, contents in files.items():
            write(path, contents)
    except BaseException:
        for path in filter(Path.is_file, files):
            if path not in before:
                path.unlink()
            elif path.read_bytes() != before[path]:
                write(path, before[path])
        raise
