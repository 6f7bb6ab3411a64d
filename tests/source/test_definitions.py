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
        (r"\newcommand\ga\alpha $\ga x$", r"$\alpha x$"),
        (r"\edef\a{x} $\a$", "$x$"),
        (r"\def\b{1}\edef\a{\b}\def\b{2} $\a\b$", "$12$"),
        (r"\let\a=\beta $\a$", r"$\beta$"),
        (r"\let\a\alpha \def\alpha{x} $\a\alpha$", r"$\alpha x$"),
        (r"\def\b#1{f(#1)}\let\a\b $\a x$", "$f(x)$"),
        (r"\def\a{1}\providecommand{\a}{2} $\a$", "$1$"),
        (r"\makeatletter\catcode`\@=11 \def\a@b{1} $\a@b$", "$1$"),
        (r"\let\a\relax\newcommand\a{1} $\a$", "$1$"),
        (r"\def\a{\def\b{1}} \a $\b$", "$1$"),
        (r"\expandafter\def\csname b\endcsname{1} $\b$ $\csname b\endcsname$", "$1$ $1$"),
        (r"\makeatletter\@namedef{b}#1{(#1)} $\b x$", "$(x)$"),
        (r"\newcommand\v[1]{(#1)}\newcommand\w[2][\v{a}]{#1#2} $\w b\w[c]d$", "$(a)bcd$"),
    ],
)
def test_a_definition_holds_from_where_it_stands(text, result):
    assert written(text).split() == result.split()
    assert not any(troubles(text)[-1:])


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"{\def\a{1} $\a$} $\a$", r"$1$} $\a$"),
        (r"{\gdef\a{1}} $\a$", "{} $1$"),
        (r"{\global\def\a{1}} $\a$", "{} $1$"),
        (r"$\def\a{1}\a$ $\a$", r"$1$ $\a$"),
        (r"\begin{center}\let\a\beta $\a$\end{center} $\a$", r"\beta$\end{center} $\a$"),
        (r"\begingroup\def\a{1}$\a$\endgroup $\a$", r"$1$ $\a$"),
        (r"\def\a{2}{\def\a{1}{\def\a{0}}$\a$}$\a$", "$1$}$2$"),
    ],
)
def test_a_definition_holds_to_the_end_of_its_group(text, result):
    assert written(text).endswith(result)


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"\def\p(#1,#2){#2-#1} $\p(a,b)$", "$b-a$"),
        (r"\def\p#1 #2;{#2-#1} $\p{a b} c;$", "$c-a b$"),
        (
            r"\NewDocumentCommand\d{s o m}{\IfBooleanTF{#1}{*}{}\IfNoValueTF{#2}{}{#2}#3} $\d*[a]b\d c$",
            "$*abc$",
        ),
        (r"\NewDocumentCommand{\v}{O{x} D(){y} m}{#1#2#3} $\v z\v[a](b)c$", "$xyzabc$"),
        (
            r"\DeclarePairedDelimiter\abs{\lvert}{\rvert} $\abs{x}\abs*{y}\abs[\big]{z}$",
            r"$\lvert x\rvert\lvert y\rvert\lvert z\rvert$",
        ),
        (r"\DeclareMathOperator\tr{tr} $\tr A$", r"$\operatorname{tr} A$"),
        (
            r"\newenvironment{eqn}[1][y]{\begin{equation}#1=}{\end{equation}} \begin{eqn}x\end{eqn}",
            r"\begin{equation}y=x\end{equation}",
        ),
        (r"\newif\ifold $\ifold a\else b\fi$ \oldtrue $\ifold a\else b\fi$", "$b$ $a$"),
        (r"\iffalse $a$ \else $b$ \fi", "$b$"),
        (r"\def\a{x} \ifx\a\undefined $1$ \else $2$ \fi", "$2$"),
        (
            r"\newcommand\pd[2][ ]{\ifx #1 \partial_{#2}\else\partial_{#2}^{#1}\fi} $\pd x\pd[2]y$",
            r"$\partial_{x}\partial_{y}^{2}$",
        ),
        (r"\makeatletter\def\a{\@ifnextchar[{\b}{\b[x]}}\def\b[#1]#2{#1#2} $\a y\a[z]w$", "$xyzw$"),
        (r"\AtBeginDocument{\def\a{1}}\begin{document}$\a$", r"\begin{document}$1$"),
        (r'\catcode`\^=\active \mathcode`\^="8000 \newcommand^[1]{\sp{#1}} $x^2$', "$x^{2}$"),
        (r"\DeclareOption{a}{\def\x{1}}\ProcessOptions $\x$", r"$\x$"),
    ],
)
def test_forms_of_definitions(text, result):
    assert written(text).replace("$ ", "$").endswith(result)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"\ifdraft\def\alpha{\beta}\fi $\alpha$", "defined in a conditional"),
        (r"\newif\ifa \ifdraft\atrue\fi $\ifa x\else y\fi$", "stands in a conditional"),
        (r"\newcommand{\a}{1}\newcommand{\a}{2} $\a$", "new twice"),
        (r"\def\b#1{1}\edef\a{\b x} $\a$", "not understood"),
        (r"\def\alpha(#1){x} $\alpha$", "( is expected here"),
        (r"\mathchardef\alpha=\beta $\alpha$", "not understood"),
        (r"\DeclareMathSymbol{\alpha}{x} $\alpha$", "not understood"),
        (r"\NewDocumentCommand{\alpha}{v}{x} $\alpha y$", "not understood"),
        (
            r"\NewDocumentEnvironment{equation}{v}{}{} \begin{equation}x\end{equation}",
            "not understood",
        ),
        (r"\catcode`\x=13 $y$", "changes what the characters of the source mean"),
        (r"\everymath{x} $y$", "changes what the characters of the source mean"),
        (r"\def\a{\catcode`\x=13 }\a $y$", "changes what the characters of the source mean"),
        (r"\ifdraft $x$ \else $y$ \fi", "stands in a conditional"),
        (r"\ifthenelse{\boolean{a}}{$x$}{$y$}", "stands in a conditional"),
        (r"\mathchoice{$x$}{$y$}{$x$}{$x$}", "stands in a conditional"),
        (r"\NewDocumentCommand\a{o}{#1} $\a$", "an argument is missing"),
    ],
)
def test_what_is_not_understood_makes_a_formula_unclear(text, words):
    assert words in troubles(text)[-1]


def test_what_is_not_understood_spoils_the_formulas_that_use_it_only():
    text = r"\mathchardef\a=1 {\catcode`\x=13 $b$} $\a$ $c$"
    assert [bool(why) for why in troubles(text)] == [True, True, False]
