"""TeX files: read within limits, nothing executed, nothing else opened."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from kowalevski_cas.source.text import Source, SourceError

LARGEST = 4_000_000
"""Bytes in a source; the longest papers have a tenth of this."""

COMMENTS = ".kc"
"""The suffix of the file of comments beside a source."""

NOISE = 0.01
"""The share of control characters from which a file is not taken for text."""

_INPUTENC = re.compile(r"\\usepackage\s*\[\s*([\w-]+)\s*\]\s*\{inputenc\}")
_CODECS = {"utf8x": "utf-8", "ansinew": "cp1252", "applemac": "mac-roman"}
"""Encodings that Python calls otherwise than LaTeX."""


def read_source(path: Path, styles: Iterable[Path] = ()) -> Source:
    """The source in a file, with the style files whose macros it uses, and the comments beside it.

    Raises :class:`SourceError` for what is no file of text of a sensible size.
    """
    comments = path.with_suffix(COMMENTS)
    beside = _read(comments) if comments != path and comments.is_file() else None
    return replace(_read(path), styles=tuple(map(_read, styles)), beside=beside)


def _read(path: Path) -> Source:
    """The source in one file."""
    try:
        # Opening a pipe would wait for a writer; so the kind is asked for first.
        kind = path.stat()
        is_file = stat.S_ISREG(kind.st_mode)
        data = path.read_bytes() if is_file and kind.st_size <= LARGEST else b""
    except OSError as error:
        raise SourceError(f"{path} cannot be read: {error.strerror}") from None
    except ValueError as error:
        raise SourceError(f"{os.fspath(path)!r} cannot be read: {error}") from None
    if not is_file:
        raise SourceError(f"{path} is not a file")
    if kind.st_size > LARGEST:
        raise SourceError(
            f"{path} has {kind.st_size:,} bytes; a source of more than {LARGEST:,} is not read"
        )
    return decode(str(path), data)


def decode(path: str, data: bytes) -> Source:
    """The source in these bytes."""
    if not data.strip():
        raise SourceError(f"{path} is empty")
    control = sum(data.count(bytes([code])) for code in (*range(9), 11, *range(14, 32), 127))
    if control > NOISE * len(data):
        raise SourceError(f"{path} is not a text file: it is full of control characters")
    head = data[:20_000].decode("latin-1")
    declared = _INPUTENC.search(head)
    encodings = ["utf-8-sig" if data.startswith(b"\xef\xbb\xbf") else "utf-8"]
    if declared:
        encodings.append(_CODECS.get(declared[1], declared[1]))
    for encoding in (*encodings, "latin-1"):
        try:
            return Source(path, data.decode(encoding), encoding)
        except (UnicodeDecodeError, LookupError):
            continue
    raise SourceError(f"{path} is in no encoding that is known")
