import pytest

from kowalevski_cas.source.displays import LONGEST, find_formulas
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import Source


def found(text: str):
    return [(f.tex.strip(), f.labels, f.inline) for f in find_formulas(text)]


@pytest.mark.parametrize(
    ("text", "result"),
    [
        ("$$ x $$", [("x", (), False)]),
        (r"\[ x \]", [("x", (), False)]),
        (r"\( x \)", [("x", (), True)]),
        ("$x$ and $y$", [("x", (), True), ("y", (), True)]),
        ("$x$$y$", [("x", (), True), ("y", (), True)]),
        (r"costs 5\$ and $x$", [("x", (), True)]),
        (r"\begin{equation}\label{a}x\end{equation}", [(r"\label{a}x", ("a",), False)]),
        (r"\begin{equation*}x\end{equation*}", [("x", (), False)]),
        (r"\begin{multline}a\\+b\end{multline}", [(r"a\\+b", (), False)]),
        (r"\begin{alignat}{2}a&=b\end{alignat}", [("a&=b", (), False)]),
    ],
)  # fmt: skip
def test_formulas_are_found(text, result):
    assert found(text) == result


def test_a_row_with_a_number_is_a_formula():
    text = r"\begin{eqnarray}a&=&b,\label{a}\\[2mm] c&=&d\nonumber\\&&+e.\label{b}\end{eqnarray}"
    assert [(tex, labels) for tex, labels, _ in found(text)] == [
        (r"a&=&b,\label{a}", ("a",)),
        (r"c&=&d\nonumber\\&&+e.\label{b}", ("b",)),
    ]


@pytest.mark.parametrize(
    ("rows", "number"),
    [
        (r"a&=b\\&\quad+c", 1),
        (r"a&=b\\&\quad{}-c_{i=1}", 1),
        (r"a&=b+\\&\quad c", 1),
        (r"a\label{x}\\&=b\\&=c", 1),
        (r"a&=b(c\\&\quad+d)\\e&=f", 2),
        (r"a&=b\\-c&=d", 2),
        (r"a&=b,\\&-c", 2),
        (r"a\\-b", 2),
        (r"a&=b\\c&=d\\&\times e", 2),
    ],
)
def test_a_row_that_runs_on_is_one_with_the_next(rows, number):
    for name in ("align", "eqnarray", "gather"):
        assert len(found(rf"\begin{{{name}}}{rows}\end{{{name}}}")) == number


def test_rows_of_inner_environments_are_no_rows():
    text = r"\begin{align}x&=\begin{cases}a\\b\end{cases}\\y&=1\end{align}"
    assert len(found(text)) == 2


def test_a_starred_environment_is_one_formula():
    assert len(found(r"\begin{align*}a&=b\\c&=d\end{align*}")) == 1
    assert len(found(r"\begin{gather*}a=b\\c=d\end{gather*}")) == 2


def test_the_end_of_a_row_with_a_length_opens_no_display():
    text = r"\begin{equation}\begin{array}{l}a\\[2mm]b\end{array}\end{equation}"
    assert len(found(text)) == 1


def test_what_is_never_closed_says_so_and_the_rest_is_found():
    formulas = list(find_formulas("$x\n\nand $y$ \\begin{equation} z\n\n$w$"))
    assert [f.tex for f in formulas if not f.trouble] == ["y", "w"]
    assert [f.trouble for f in formulas if f.trouble] == [
        "$ is never closed",
        "equation is never closed",
    ]


@pytest.mark.slow
def test_unclosed_formulas_take_no_time():
    # Where too many are never closed, the rest is not looked at.
    for piece in ("\\begin{equation}", "\\[", "\\begin{align}x\\\\", "$ x \n\n"):
        assert list(find_formulas(piece * (4 * LONGEST // len(piece))))


def test_what_is_cited_is_no_formula_of_the_paper():
    text = "$a$ \\begin{thebibliography}{9}\\bibitem{b} On $H=5$.\\end{thebibliography} $c$"
    assert [f.tex for f in typed_formulas(Source("p.tex", text))[1]] == ["a", "c"]


def test_footnotes_captions_tables_and_appendices_are_read():
    text = """\\footnote{See $a$.} \\begin{table}\\caption{Of $b$}\\begin{tabular}{c}$c$ & $d$\\end{tabular}
    \\end{table} \\appendix \\section{On $e$} \\[ f=\\begin{cases}1\\\\2\\end{cases} \\]"""
    found = [f.tex.strip() for f in typed_formulas(Source("p.tex", text))[1]]
    assert found[:5] == [*"abcde"] and found[5].startswith("f=")
