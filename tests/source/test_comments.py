"""Comments of authors are attached to the formulas that they are about."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import Source, SourceError


def attached(source: Source) -> dict[str, list[str]]:
    """What is said of each formula."""
    formulas = typed_formulas(source)[1]
    return {f.tex.strip(): [c.words for c in f.comments] for f in formulas if f.comments}


def said(text: str, beside: str = "") -> dict[str, list[str]]:
    source = decode("paper.tex", text.encode())
    file = decode("paper.kc", beside.encode()) if beside else None
    return attached(replace(source, beside=file))


@pytest.mark.parametrize(
    ("text", "result"),
    [
        ("%kc: law\n$x$ $y$", {"x": ["law"]}),
        ("  %kc:  on eq1 \n $x$", {"x": ["on eq1"]}),
        ("%kc: law\n%kc: given\n$$ x $$", {"x": ["law", "given"]}),
        ("$x$\n%kc: law\n$y$", {"y": ["law"]}),
        ("$x$, $y$ %kc: law\n$z$", {"y": ["law"]}),
        ("so %kc: law\n$z$", {"z": ["law"]}),
        ("\\[\nx\n\\] %kc: law\n$z$", {"x": ["law"]}),
        ("\\[ %kc: law\nx\n\\] $z$", {"x": ["law"]}),
        ("$$\nx\n%kc: law\n+y\n$$ $z$", {"x\n         +y": ["law"]}),
        ("\\[\nx\n%kc: law\n\\]\n$z$", {"x": ["law"]}),
        (
            "\\begin{align}\na \\\\ %kc: law\n%kc: given\nb\\end{align}",
            {"a": ["law"], "b": ["given"]},
        ),
        ("\\begin{equation} %kc: law\nx\\end{equation}", {"x": ["law"]}),
        ("%kc: law", {}),
        ("% kc: this is for a co-author\n$x$", {}),
        ("\\begin{verbatim}\n%kc: law\n\\end{verbatim}\n$x$", {}),
        ("\\iffalse\n%kc: law\n\\fi\n$x$", {}),
        ("\\verb|%kc: law| $x$", {}),
        ("5\\%kc: law\n$x$", {}),
        ("\\newcommand\\a{x}\n%kc: law\n$\\a$", {"x": ["law"]}),
    ],
)
def test_a_comment_is_about_the_next_formula_or_the_one_of_its_line(text, result):
    assert said(text) == result


@given(st.lists(st.sampled_from(["text", "$x$", "\\[ y \\]", "% a remark"]), max_size=8), st.data())
def test_a_line_of_comment_changes_no_formula(lines, data):
    at = data.draw(st.integers(0, len(lines)))
    more = [*lines[:at], "%kc: law", *lines[at:]]
    texts = [
        [f.tex for f in typed_formulas(Source("p", "\n".join(one)))[1]] for one in (lines, more)
    ]
    assert texts[0] == texts[1]


def test_a_comment_inside_of_a_paragraph_does_not_end_it():
    (formula,) = typed_formulas(Source("p", "$x\n  %kc: law\n=y$"))[1]
    assert not formula.trouble


def test_a_comment_knows_where_it_is_written():
    (formula,) = typed_formulas(Source("p.tex", "\n\n%kc: law\n$x$"))[1]
    assert [(c.path, c.line, c.words) for c in formula.comments] == [("p.tex", 3, "law")]


PAPER = "\\section{A}\\label{sec}\n$$ x \\label{e} $$ where it\nis  purely $y$ imaginary: $z$."


@pytest.mark.parametrize(
    ("beside", "result"),
    [
        ("e %kc: law", {"x \\label{e}": ["law"]}),
        ("sec %kc: law", {"x \\label{e}": ["law"]}),
        ('"where it is purely" %kc: law', {"y": ["law"]}),
        ('"imaginary" %kc: law\n%kc: given', {"z": ["law", "given"]}),
        ("% remark\n\ne\n%kc: law\n", {"x \\label{e}": ["law"]}),
    ],
)
def test_comments_beside_a_source_stand_after_a_label_or_words(beside, result):
    assert said(PAPER, beside) == result


@pytest.mark.parametrize(
    ("beside", "words"),
    [
        ("f %kc: law", "paper.kc:1: paper.tex has not the label f"),
        ('"no such words" %kc: law', "paper.kc:1: paper.tex has not the words"),
        ('\n"i" %kc: law', 'paper.kc:2: paper.tex has the words "i" several times, in the lines'),
        ("%kc: law", "paper.kc:1: say first of what"),
        ("e: law", "paper.kc:1: paper.tex has not the label e: law"),
        ('"" %kc: law', "has not the words"),
    ],
)
def test_a_comment_of_what_does_not_stand_there_is_an_error(beside, words):
    with pytest.raises(SourceError) as error:
        said(PAPER, beside)
    assert words in str(error.value)


def test_the_file_of_comments_is_found_beside_the_source(tmp_path):
    (tmp_path / "paper.tex").write_text("$x$")
    (tmp_path / "paper.kc").write_text('"$x$" %kc: law')
    assert attached(read_source(tmp_path / "paper.tex")) == {"x": ["law"]}
