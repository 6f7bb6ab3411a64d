from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.source import macros
from kowalevski_cas.source.expanded import MOST_NOTES
from kowalevski_cas.source.files import decode, read_source
from kowalevski_cas.source.macros import expand
from kowalevski_cas.source.text import SourceError
from tests.sample import sampled

PIECES = [
    *"{}$^_[]#x12= \n", "\\a", "\\b", "\\def\\a", "\\newcommand", "#1", "\\begin{eq}", "\\end{eq}", "\\fi",
    "\\else", "\\ifx", "\\iffalse", "\\let", "\\expandafter", "\\csname", "\\endcsname", "\\newif\\ifb",
    "\\NewDocumentCommand", "\\catcode`\\^=13", "\\ifnum", "\\newenvironment{eq}", "\\mathchoice", "@", "*",
]  # fmt: skip


def written(text: str) -> str:
    return expand(decode("paper.tex", text.encode())).text.strip()


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"\newcommand {\bs}{\boldsymbol} ${\bs \alpha}$", r"${\boldsymbol \alpha}$"),
        (r"\newcommand\R{\mathbf R} $\R^9$", r"$\mathbf R^9$"),
        (r"\def\v#1{{\bf #1}} $\v{e}_1+\v x$", r"${\bf e}_1+{\bf x}$"),
        (r"\newcommand{\p}[2][t]{\frac{d#2}{d#1}} $\p{x}=\p[s]{y}$", r"$\frac{dx}{dt}=\frac{dy}{ds}$"),
        (r"\DeclareMathOperator{\diag}{diag} $\diag(a)$", r"$\operatorname{diag}(a)$"),
        (r"\def\be{\begin{equation}}\def\ee{\end{equation}}\be x=1\ee", r"\begin{equation} x=1\end{equation}"),
        (r"\newcommand{\om}{\omega} $\om x$, $\om$", r"$\omega x$, $\omega$"),
        (r"\newcommand{\a}{\b}\newcommand{\b}{x} $\a$", "$x$"),
        (r"\renewcommand{\a}{1}\renewcommand{\a}{2} $\a$", "$2$"),
    ],
)  # fmt: skip
def test_macros_are_written_out(text, result):
    assert written(text) == result


def test_a_macro_stays_apart_from_a_letter():
    assert written(r"\newcommand{\om}{\omega}$\om{}x$") == r"$\omega{}x$"
    assert written(r"\def\m#1{\omega}$\m1x$") == r"$\omega x$"
    assert written(r"\newcommand{\y}{x}$\omega\y$") == r"$\omega x$"
    assert written(r"\newcommand{\y}{x}\newcommand{\o}{\omega\y\y}$\o$") == r"$\omega xx$"


def test_what_is_written_out_knows_where_it_came_from():
    text = "\\newcommand{\\bs}{\\boldsymbol}\n$x+\\bs y$"
    expanded = expand(decode("paper.tex", text.encode()))
    at = expanded.text.index("\\boldsymbol")
    start, end = expanded.origin(at, at + 5)
    assert text[start:end] == "\\bs"
    at = expanded.text.rindex("y")
    assert text[slice(*expanded.origin(at, at + 1))] == "y"
    assert text[slice(*expanded.origin(at - 2, at))] == "\\bs "


def test_a_macro_with_arguments_comes_from_all_of_its_call():
    text = "\\def\\v#1{(#1)}$x+\\v {y}z$"
    expanded = expand(decode("paper.tex", text.encode()))
    at = expanded.text.index("(y)")
    for place in range(at, at + 3):
        assert text[slice(*expanded.origin(place, place + 1))] == "\\v {y}"
    assert text[slice(*expanded.origin(at + 3, at + 4))] == "z"


@given(st.lists(st.sampled_from(PIECES), max_size=30).map("".join))
def test_what_stands_in_the_text_as_it_is_comes_from_there(text):
    source = decode("paper.tex", (text + ".").encode())
    try:
        expanded = expand(source)
    except SourceError:
        return
    assert len(expanded._starts) == len(expanded._pieces)
    for start, (begin, end, literal) in zip(expanded._starts, expanded._pieces, strict=True):
        assert 0 <= begin <= end <= len(source.text)
        assert not literal or expanded.text[start:].startswith(source.visible[begin:end])


@pytest.mark.parametrize(
    "text", sampled([r"\newcommand{\a}{x\a}", r"\def\a{{\a}}", r"\def\a{\b\b}\def\b{\a}"], 1)
)
def test_a_macro_that_expands_into_itself_is_left_alone(text):
    expanded = expand(decode("paper.tex", rf"{text} $\a$ $y$".encode()))
    assert expanded.text.strip() == r"$\a$ $y$"
    (note,) = (words for _, words in expanded.notes)
    assert "is left alone" in note
    assert "is left alone" in expanded.why(expanded.text.index("\\a"), expanded.text.index("\\a"))


def test_macros_that_double_are_left_alone():
    names = "abcdefghijklmnopqrstuvwxyz"
    lines = [rf"\def\{a}{{\{b}\{b}\{b}}}" for a, b in pairwise(names)]
    assert written("\n".join([*lines, r"\def\z{x}", r"$\a$"])) == r"$\a$"


@pytest.mark.slow
def test_macros_that_grow_stay_within_limits():
    names = "abcdefghij"
    lines = [rf"\def\{a}#1{{\{b}{{#1#1#1#1}}}}" for a, b in pairwise(names)]
    text = "\n".join([*lines, r"\def\j#1{#1}", rf"$\a{{{'x' * 1000}}}$"])
    assert len(written(text)) < macros.LONGEST


@pytest.mark.slow
def test_all_macros_of_a_file_stay_within_limits(monkeypatch):
    monkeypatch.setattr(macros, "LONGEST", 400_000)
    text = rf"\def\a{{{'x' * 5000}}}" + r"$\a$ " * 2000
    with pytest.raises(SourceError, match="too much text"):
        written(text)


def test_definitions_that_are_not_understood_are_noted():
    expanded = expand(decode("paper.tex", rb"\mathchardef\a=1 $x$ \newcommand{\b}"))
    assert len(expanded.notes) == 2
    assert "not understood" in expanded.notes[0][1]


@pytest.mark.slow
def test_unclosed_definitions_take_no_time():
    expanded = expand(decode("paper.tex", rb"\def\a{" * 30_000))
    assert len(expanded.notes) == MOST_NOTES + 1


STYLE = rb"""\ProvidesPackage{own}
\newcommand{\mbf}[1]{\boldsymbol{#1}} \def\pl{\partial} \providecommand{\od}[2]{\frac{d#1}{d#2}}
\DeclareMathOperator*{\Tr}{Tr} \newcommand{\twice}[2][x]{2#1#2}
"""


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"$\mbf{r}\od{x}{t}$", r"$\boldsymbol{r}\frac{dx}{dt}$"),
        (r"$\frac{\pl H}{\pl q}$", r"$\frac{\partial H}{\partial q}$"),
        (r"$\Tr A \twice{y} \twice[z]{y}$", r"$\operatorname{Tr} A 2xy 2zy$"),
        (r"\renewcommand{\pl}{d} $\pl x$", "$d x$"),
        (r"\let\d\pl $\d x$", r"$\partial x$"),
        (r"\newcommand{\pl}{d} $\pl x$", r"$\pl x$"),  # new twice: what holds cannot be told
    ],
)
def test_macros_of_style_files_hold_before_those_of_the_source(text, result, tmp_path):
    assert with_style(tmp_path, STYLE, text).text.strip().endswith(result)


def with_style(folder, style, text):
    (folder / "own.sty").write_bytes(style)
    (folder / "paper.tex").write_text(text)
    return expand(read_source(folder / "paper.tex", [folder / "own.sty"]))


def test_what_a_style_file_says_that_is_not_understood_is_noted(tmp_path):
    expanded = with_style(tmp_path, rb"\mathchardef\a=1 \newcommand{\b}{y}", r"$\a\b$")
    assert expanded.text.strip().endswith(r"$\a y$")
    assert expanded.notes[0][1].startswith("this")
    assert "not understood" in expanded.why(expanded.text.index("$"), len(expanded.text))
