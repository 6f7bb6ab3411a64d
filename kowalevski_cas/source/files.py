r"""TeX files: read within limits, nothing executed, nothing outside of the paper's folder opened.

``\input`` and the styles and classes that stand beside the paper are read where they are named: by
names that lead into the paper's folder or below, to files that are no links, and no files twice
within each other. What is refused is kept with its place and the reason.
"""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

from kowalevski_cas.source.text import Part, Source, SourceError, blank_out

LARGEST = 4_000_000
"""Bytes in a file; the longest papers have a tenth of this."""
TOTAL = 16_000_000
"""Characters in all files of a paper."""
MOST = 500
"""Files of a paper."""
COMMENTS = ".kc"
"""The suffix of the file of comments beside a source."""

NOISE = 0.01
"""The share of control characters from which a file is not taken for text."""

_INPUTENC = re.compile(
    r"^[^%\n]*\\(?:(?:usepackage|RequirePackage)\s*\[\s*(?:[\w-]+\s*,\s*)*([\w-]+)\s*\]\s*\{inputenc\}"
    r"|inputencoding\s*\{([\w-]+)\})",
    re.MULTILINE,
)
_CODECS = {"utf8x": "utf-8", "ansinew": "cp1252", "applemac": "mac-roman", "koi8-ru": "koi8-u",
           "maccyr": "mac-cyrillic", "cp866av": "cp866", "iso88595": "iso8859-5"}  # fmt: skip
"""Encodings that Python calls otherwise than LaTeX."""
_UNSEEN = re.compile(
    "[\x00-\x08\x0b\x0e-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
)
"""What no terminal and no page is to be given: it prints as nothing, or turns what is printed."""
_NAMED = re.compile(
    r"\\(?:(?P<input>input|include|subfile)(?![A-Za-z])\s*(?:\{(?P<name>[^{}]*)\}|(?P<bare>[^\s{}\\%]+))"
    r"|(?P<use>usepackage|RequirePackage|documentclass|LoadClass)(?![A-Za-z])\s*(?:\[[^\]]*\])?\s*\{(?P<styles>[^{}]*)\})"
)
_SUFFIX = {"documentclass": ".cls", "LoadClass": ".cls"}


def read_source(path: Path, styles: Iterable[Path] = (), data: bytes | None = None) -> Source:
    """The source in a file, with all that it reads, and the comments beside it.

    ``styles`` are files of macros that are read before it; ``data`` is what the file contains where
    that is not saved.

    Raises:
        SourceError: for what is no file of text of a sensible size, or reads itself.
    """
    reader = _Reader(path)
    for style in styles:
        if style.is_symlink():
            raise SourceError(f"{style} is a link; name the file itself")
        reader.read(decode(str(style), _bytes(style)), True, (style,))
    data = _bytes(path) if data is None else data
    main, reader.declared = decode(str(path), data), _declared_encodings(data)
    reader.read(main, False, (path,))
    comments = path.with_suffix(COMMENTS)
    beside = None
    if comments != path and comments.is_symlink():
        reader.refused.append((0, f"{comments.name} is not read: it is a link"))
    elif comments != path and comments.is_file():
        beside = decode(str(comments), _bytes(comments))
    return Source(
        str(path), "".join(reader.text), main.encoding, tuple(reader.parts), beside,
        tuple(reader.refused),
    )  # fmt: skip


class _Reader:
    """The text of a paper as it is put together."""

    def __init__(self, path: Path) -> None:
        self.folder = path.parent
        self.declared: list[str] = []
        """The encodings that the paper says it has."""
        self.text: list[str] = []
        self.size = 0
        self.parts: list[Part] = []
        self.refused: list[tuple[int, str]] = []

    def read(self, file: Source, style: bool, above: tuple[Path, ...]) -> None:
        """Add the text of a file, and where it names others, theirs."""
        if len(self.parts) > 3 * MOST or self.size + len(file.text) > TOTAL:
            raise SourceError(f"{above[0]}: its files are too many, or too large")
        at, visible = 0, blank_out(file.text)[0]
        for match in _NAMED.finditer(visible):
            if match.start() < at:
                continue
            names = [match["name"] or match["bare"] or ""]
            suffixes: tuple[str, ...] = ("", ".tex")
            if match["use"]:
                names = match["styles"].split(",")
                suffixes = (_SUFFIX.get(match["use"], ".sty"),)
            for name in (part.strip() for part in names):
                if found := self.find(name, suffixes, self.size + match.start() - at, match):
                    self.add(file, at, match.end(), style)
                    at = match.end()
                    if found in above:
                        chain = " reads ".join(str(file) for file in (*above, found))
                        raise SourceError(f"{self.where()}: {chain}, without an end")
                    inner = decode(str(found), _bytes(found), self.declared)
                    self.read(inner, style or bool(match["use"]), (*above, found))
        self.add(file, at, len(file.text), style)

    def where(self) -> str:
        """The file and the line that have been read last."""
        part = self.parts[-1]
        return f"{part.path}:{1 + ''.join(self.text).count(chr(10))}"

    def add(self, file: Source, start: int, end: int, style: bool) -> None:
        """Add a stretch of a file."""
        text = file.text[start:end]
        self.parts.append(Part(file.path, self.size, self.size + len(text), start, style))
        self.text.append(text)
        self.size += len(text)

    def find(
        self, name: str, suffixes: Iterable[str], offset: int, match: re.Match[str]
    ) -> Path | None:
        """The file of this name, if it may be read; styles that are not there are the system's."""
        pure = PurePosixPath(name)
        if not name or "\\" in name or "#" in name:
            return None
        why = ""
        if pure.is_absolute() or ".." in pure.parts or name[0] in "~|" or ":" in name:
            why = "it does not lead into the paper's folder"
        else:
            paths = [self.folder / f"{name}{suffix}" for suffix in suffixes]
            for path in paths:
                if os.path.lexists(path):
                    why = self.unfit(path)
                    if not why:
                        return path
                    break
            else:
                why = "" if match["use"] else "it is not there"
        if why:
            self.refused.append((offset, f"{name} is not read: {why}"))
        return None

    def unfit(self, path: Path) -> str:
        """Why a path of the paper's folder is not read; empty if it is."""
        for part in [path, *path.parents]:
            if part == self.folder:
                break
            if part.is_symlink():
                return "it is a link"
        return "" if stat.S_ISREG(path.lstat().st_mode) else "it is no file"


def _bytes(path: Path) -> bytes:
    """What a file contains, if it is a file of a sensible size."""
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
    return data


def _declared_encodings(data: bytes) -> list[str]:
    """The encodings that a file says it has, as Python calls them."""
    found = _INPUTENC.finditer(data[:20_000].decode("latin-1"))
    names = (match[1] or match[2] for match in found)
    return [_CODECS.get(name, name) for name in names]


def decode(path: str, data: bytes, declared: Iterable[str] = ()) -> Source:
    """The source in these bytes; ``declared`` are the encodings of the paper that reads it."""
    if not data.strip():
        raise SourceError(f"{path} is empty")
    control = sum(data.count(bytes([code])) for code in (*range(9), 11, *range(14, 32), 127))
    if control > NOISE * len(data):
        raise SourceError(f"{path} is not a text file: it is full of control characters")
    first = "utf-8-sig" if data.startswith(b"\xef\xbb\xbf") else "utf-8"
    for encoding in (first, *_declared_encodings(data), *declared, "latin-1"):
        try:
            text = data.decode(encoding).replace("\f", " ")
            return Source(path, _UNSEEN.sub("\ufffd", text), encoding)
        except (UnicodeDecodeError, LookupError):
            continue
    raise SourceError(f"{path} is in no encoding that is known")
