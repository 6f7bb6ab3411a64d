import os
import unicodedata
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.source import files as module
from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import SourceError


def visible(text: str) -> str:
    return decode("paper.tex", text.encode()).visible


def test_comments_are_blanked_and_offsets_stay():
    text = "a % $b$\nc \\% d\n"
    assert visible(text) == "a      \nc \\% d\n"


def test_a_line_break_before_a_comment_sign_is_no_escape():
    assert visible("a \\\\% b\n") == "a \\\\   \n"


def test_verbatim_text_and_what_follows_the_end_do_not_print():
    text = "\\begin{verbatim}$x$\\end{verbatim} $y$ \\verb|$z$| \\url{a%b$c$} \\end{document} $w$"
    assert visible(text).split() == ["$y$"]


def test_what_is_never_taken_does_not_print():
    assert visible("\\iffalse $x$ \\ifx a \\fi $y$ \\fi $z$").split() == ["$z$"]
    assert visible("\\iffalse $x$ \\else $y$ \\fi").split() == ["$y$", "\\fi"]
    assert visible("{\\iffalse} $x$ \\fi").split() == ["{\\iffalse}", "$x$", "\\fi"]


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


# -- the files of a paper ----------------------------------------------------------------


def paper(folder, **files):
    """The source of a paper with these files beside it; underscores in names are dots."""
    for name, text in files.items():
        path = folder / name.replace("__", "/").replace("_", ".")
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    return read_source(folder / "paper.tex")


def formulas(source):
    return [formula.tex for formula in typed_formulas(source)[1]]


def test_what_a_paper_inputs_is_read_where_it_is_named(tmp_path):
    found = paper(
        tmp_path,
        paper_tex="$a$ \\input{b} $c$\n\\include{sub/d.tex}$e$",
        b_tex="$b$",
        sub__d_tex="\n$d$",
    )
    assert formulas(found) == ["a", "b", "c", "d", "e"]
    assert [path.rpartition("/")[2] for path in found.files] == ["paper.tex", "b.tex", "d.tex"]
    places = [found.place(found.text.index(f"${name}$")) for name in "abcde"]
    assert [place.rpartition("/")[2] for place in places] == [
        "paper.tex:1", "b.tex:1", "paper.tex:1", "d.tex:2", "paper.tex:2",
    ]  # fmt: skip


def test_styles_and_classes_beside_a_paper_are_found(tmp_path):
    found = paper(
        tmp_path,
        paper_tex="\\documentclass{own}\\usepackage[wide]{mine,amsmath}\\begin{document}$\\a\\b\\c$",
        own_cls="\\LoadClass{article}\\def\\a{1} $z$",
        mine_sty="\\x@z\\def\\x@y{2}\\def\\b{\\x@y}\\def\\c{3}\\DeclareOption{wide}{\\def\\c{4}}\\ProcessOptions",
    )
    assert formulas(found) == ["124"]
    assert not found.refused


def test_what_a_paper_inputs_is_mended_in_its_own_file(tmp_path):
    found = paper(tmp_path, paper_tex="$a$ \\input{b} $c$ $d$", b_tex="$b$")
    changed = found.edited(
        {(k, k + 1): "xyz" for k in (found.text.index(f"${name}$") + 1 for name in "abd")}
    )
    assert [*changed.files.values()] == ["$xyz$ \\input{b} $c$ $xyz$", "$xyz$"]
    assert changed.visible == changed.text


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("/etc/passwd", "folder"),
        ("../other", "folder"),
        ("sub/../../other", "folder"),
        ("~/other", "folder"),
        ("|ls", "folder"),
        ("http://x.y/z", "folder"),
        ("missing", "not there"),
        ("link", "a link"),
        ("linked/b", "a link"),
        ("pipe", "no file"),
        ("sub", "no file"),
    ],
)
def test_what_leads_elsewhere_is_refused_and_listed(tmp_path, name, why):
    folder = tmp_path / "paper"
    (folder / "sub").mkdir(parents=True)
    (tmp_path / "other.tex").write_text("$secret$")
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "b.tex").write_text("$secret$")
    (folder / "link.tex").symlink_to(tmp_path / "other.tex")
    (folder / "linked").symlink_to(tmp_path / "elsewhere")
    os.mkfifo(folder / "pipe.tex")
    found = paper(folder, paper_tex=f"$a$\n\\input{{{name}}}")
    assert formulas(found) == ["a"]
    ((offset, words),) = found.refused
    assert found.line(offset) == 2
    assert name in words and why in words


def test_a_style_that_is_a_link_is_refused(tmp_path):
    paper(tmp_path, paper_tex="$a$", own_sty="\\def\\a{1}")
    (tmp_path / "link.sty").symlink_to(tmp_path / "own.sty")
    with pytest.raises(SourceError, match="is a link"):
        read_source(tmp_path / "paper.tex", [tmp_path / "link.sty"])


def test_comments_that_are_a_link_are_refused_and_listed(tmp_path):
    (tmp_path / "other").write_text("secret words\n")
    (tmp_path / "paper.kc").symlink_to(tmp_path / "other")
    found = paper(tmp_path, paper_tex="$a$")
    assert found.beside is None and found.refused == ((0, "paper.kc is not read: it is a link"),)


@pytest.mark.parametrize(
    "files",
    [{"paper_tex": "\\input{paper}"}, {"paper_tex": "\\input b ", "b_tex": "\n\\input{paper}"}],
)
def test_a_file_that_reads_itself_is_an_error(tmp_path, files):
    with pytest.raises(SourceError, match=r"paper\.tex.*without an end"):
        paper(tmp_path, **files)


def test_files_that_double_are_too_many(tmp_path):
    names = "bcdefghijklmnopq"
    files = {f"{a}_tex": f"\\input{{{b}}}" * 2 for a, b in pairwise(names)}
    with pytest.raises(SourceError, match="too many"):
        paper(tmp_path, paper_tex="\\input{b}", q_tex="$x$", **files)


def test_a_file_that_a_macro_names_is_not_read(tmp_path):
    found = paper(tmp_path, paper_tex="\\newcommand\\get[1]{\\input{#1}} \\get{b} $a$", b_tex="$b$")
    expanded, _ = typed_formulas(found)
    assert formulas(found) == ["a"]
    assert [words for _, words in expanded.notes] == ["b is named by a macro; it is not read"]


@pytest.mark.parametrize("hidden", ["%\\input{b}", "\\iffalse\\input{b}\\fi", "\\verb|\\input{b}|"])
def test_what_does_not_print_reads_nothing(tmp_path, hidden):
    assert formulas(paper(tmp_path, paper_tex=f"$a$ {hidden}\n", b_tex="$b$")) == ["a"]


# -- encodings ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("head", "codec"),
    [
        ("\\usepackage[cp1251]{inputenc}", "cp1251"),
        ("\\usepackage[koi8-r]{inputenc}", "koi8-r"),
        ("%\\usepackage[utf8]{inputenc}\n\\RequirePackage[cp1251]{inputenc}", "cp1251"),
        ("\\usepackage[utf8,cp1251]{inputenc}", "cp1251"),
        ("\\inputencoding{cp866}", "cp866"),
        ("", "utf-8"),
    ],
)
def test_cyrillic_text_is_read_as_it_is_declared(head, codec):
    text = "Пусть движение задано уравнениями $x=y$."
    found = decode("p.tex", f"{head}\n{text}".encode(codec))
    assert found.text.endswith(text)


def test_what_is_input_has_the_encoding_of_the_paper(tmp_path):
    (tmp_path / "paper.tex").write_bytes(
        "\\usepackage[cp1251]{inputenc}\\input{b}".encode("cp1251")
    )
    (tmp_path / "b.tex").write_bytes("интеграл".encode("cp1251"))
    assert "интеграл" in read_source(tmp_path / "paper.tex").text


@given(st.text(max_size=40))
def test_no_control_character_of_a_source_is_kept(text):
    data = f"$x$ {text} a long line of ordinary words, so that it is taken for a text".encode(
        errors="ignore"
    )
    try:
        found = decode("p.tex", data * 3).text
    except SourceError:
        return
    kinds = {unicodedata.category(sign) for sign in found if sign not in "\n\r\t"}
    assert not kinds & {"Cc", "Cs"}
    assert not any("\u202a" <= sign <= "\u202e" or "\u2066" <= sign <= "\u2069" for sign in found)
