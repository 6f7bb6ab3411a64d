import os

import pytest

from kowalevski_cas.source import files as module
from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.text import SourceError


def visible(text: str) -> str:
    return decode("paper.tex", text.encode()).visible


def test_comments_are_blanked_and_offsets_stay():
    text = "a % $b$\nc \\% d\n"
    assert visible(text) == "a      \nc \\% d\n"


def test_a_line_break_before_a_comment_sign_is_no_escape():
    assert visible("a \\\\% b\n") == "a \\\\   \n"


def test_verbatim_text_and_what_follows_the_end_do_not_print():
    text = "\\begin{verbatim}$x$\\end{verbatim} $y$ \\verb|$z$| \\end{document} $w$"
    assert visible(text).split() == ["$y$"]


def test_what_is_never_taken_does_not_print():
    assert visible("\\iffalse $x$ \\ifx a \\fi $y$ \\fi $z$").split() == ["$z$"]


def test_lines_and_columns_count_from_one():
    found = decode("paper.tex", b"ab\ncd\n")
    assert [(found.line(k), found.column(k)) for k in (0, 1, 3, 4)] == [
        (1, 1),
        (1, 2),
        (2, 1),
        (2, 2),
    ]


def test_other_encodings_are_read():
    assert decode("p", "é".encode("latin-1")).text == "é"
    declared = b"\\usepackage[koi8-r]{inputenc}\n" + "ж".encode("koi8-r")
    assert decode("p", declared).text.endswith("ж")


def test_noise_is_no_text():
    with pytest.raises(SourceError, match="full of control characters"):
        decode("noise.tex", bytes(range(256)) * 40)


def test_an_empty_file_is_refused():
    with pytest.raises(SourceError, match=r"p\.tex is empty"):
        decode("p.tex", b" \n")


def test_a_large_file_is_not_read(tmp_path):
    path = tmp_path / "large.tex"
    with path.open("wb") as file:
        file.truncate(100_000_000)
    with pytest.raises(SourceError, match="100,000,000 bytes"):
        read_source(path)


def test_only_files_are_read(tmp_path):
    with pytest.raises(SourceError, match="is not a file"):
        read_source(tmp_path)
    pipe = tmp_path / "pipe.tex"
    os.mkfifo(pipe)
    with pytest.raises(SourceError, match="is not a file"):
        read_source(pipe)
    with pytest.raises(SourceError, match="cannot be read"):
        read_source(tmp_path / "missing.tex")


def test_unclosed_things_take_no_time():
    size = module.LARGEST // 32
    for piece in ("\\verb|", "\\iffalse", "\\begin{verbatim}", "\\\\%"):
        visible(piece * (size // len(piece)))
