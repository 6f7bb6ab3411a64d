"""What differs between two states of a paper's files."""

from __future__ import annotations

from difflib import unified_diff
from io import StringIO

from kowalevski_cas.source.text import Source


def difference(source: Source, changed: Source) -> str:
    """A unified diff of the files of a source, file by file."""
    texts = changed.files
    pieces: list[str] = []
    for path, text in source.files.items():
        before, after = ([*StringIO(one, "\n")] for one in (text, texts[path]))
        name = path.lstrip("/")
        pieces += unified_diff(before, after, f"a/{name}", f"b/{name}", n=2)
    return "".join(pieces)
