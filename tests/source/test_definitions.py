"""What a source defines is understood where it stands, or makes what it means unclear."""

import pytest

from kowalevski_cas.source.files import decode
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.macros import expand


def written(text: str) -> str:
    return expand(decode("paper.tex", text.encode())).text.strip()


def troubles(text: str) -> list[str]:
    return [formula.trouble for formula in typed_formulas(decode("p.tex", text.encode()))[1]]


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"$\a$ \def\a{1} $\a$ \def\a{2} $\a$", r"$\a$ $1$ $2$"),
        (r"$\alpha$ \renewcommand{\alpha}{\beta} $\alpha$", r"$\alpha$ $\beta$"),
        (r"{\gdef\a{1}} $\a$", "{ } $1$"),
        (r"\edef\a{x} $\a$", "$x$"),
        (r"\let\a=\beta $\a$", r"$\beta$"),
        (r"\def\b#1{f(#1)}\let\a\b $\a x$", "$f(x)$"),
        (r"\def\a{1}\providecommand{\a}{2} $\a$", "$1$"),
        (r"\makeatletter\catcode`\@=11 \def\a@b{1} $\a@b$", r"\makeatletter\catcode`\@=11 $1$"),
    ],
)
def test_a_definition_holds_from_where_it_stands(text, result):
    assert written(text).split() == result.split()
    assert not any(troubles(text)[-1:])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"{\def\alpha{\beta}} $\alpha$", "defined inside a group"),
        (r"$\def\alpha{\beta}\alpha$ $\alpha$", "defined inside a group"),
        (r"\begin{center}\let\alpha\beta\end{center} $\alpha$", "defined inside a group"),
        (r"\ifdraft\def\alpha{\beta}\fi $\alpha$", "defined inside a group"),
        (r"\def\a{\def\alpha{\beta}} \a $\alpha$", "defines names where it is used"),
        (r"\def\a{\let\alpha=\beta} \a $\alpha$", "defines names where it is used"),
        (r"\let\a\alpha \def\alpha{x} $\a$", "before it was defined again"),
        (r"\def\b{1}\edef\a{\b}\def\b{2} $\a$", "before it was defined again"),
        (r"\newcommand{\a}{1}\newcommand{\a}{2} $\a$", "new twice"),
        (r"\def\alpha(#1){x} $\alpha$", "not understood"),
        (r"\mathchardef\alpha=\beta $\alpha$", "not understood"),
        (r"\DeclareMathSymbol{\alpha}{x} $\alpha$", "not understood"),
        (r"\NewDocumentCommand{\alpha}{m}{x} $\alpha$", "not understood"),
        (r"\renewenvironment{equation}{}{} \begin{equation}x\end{equation}", "not understood"),
        (r"\catcode`\x=13 $y$", "changes what the characters of the source mean"),
        (r"\everymath{x} $y$", "changes what the characters of the source mean"),
        (r"\expandafter\def\csname alpha\endcsname{x} $y$", "changes what the characters"),
        (r"\ifdraft $x$ \else $y$ \fi", "stands in a conditional"),
    ],
)
def test_what_is_not_understood_makes_a_formula_unclear(text, words):
    assert words in troubles(text)[-1]


def test_what_is_unclear_spoils_no_other_formula():
    assert troubles(r"{\def\alpha{\beta}} $\alpha$ $\gamma \iff \delta$")[1] == ""
