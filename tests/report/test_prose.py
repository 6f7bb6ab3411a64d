"""The text of an article around its formulas."""

import sys
from collections import Counter
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pylatexenc.latexwalker import get_default_latex_context_db

from kowalevski_cas.notation import Name
from kowalevski_cas.report.document import (
    Block,
    Code,
    Emphasis,
    Equations,
    Heading,
    Items,
    Link,
    Table,
)
from kowalevski_cas.report.paragraphs import FIRST, FormulaBlocks
from kowalevski_cas.report.prose import ProseError, read_article
from tests.report.test_contents import parts, said

INLINE = [FormulaBlocks((Name(f"x_{k}"),), inline=True) for k in range(3)]
SHOWN = [FormulaBlocks((), (Equations((Name(f"y_{k}"),)),)) for k in range(3)]
PLACED = [*INLINE, *SHOWN]
X, Y = (chr(FIRST + k) for k in (0, 3))


def read(tex: str, **labels: Link) -> tuple[Block, ...]:
    return tuple(read_article(tex, PLACED, labels))


def test_paragraphs_end_at_empty_lines_and_spaces_are_one() -> None:
    one, other = read(f"Let  {X}\nbe\n \t\n  small.")
    assert one.text == ("Let ", Name("x_0"), " be") and other.text == ("small.",)


def test_a_display_stands_between_what_is_before_and_behind_it() -> None:
    before, shown, behind = read(f"Then\n{Y}\nfollows.")
    assert (said(before), shown, said(behind)) == ("Then ", SHOWN[0].blocks[0], " follows.")


def test_blocks_of_an_inline_formula_follow_its_paragraph() -> None:
    told = Equations((Name("z"),))
    placed = [FormulaBlocks((Name("x"),), (told,), inline=True)]
    first, second, third = read_article(f"With {X} we go.\n\nOn.", placed, {})
    assert second is told and said(third) == "On."
    assert first.text == ("With ", Name("x"), " we go.")


@pytest.mark.parametrize("font", [r"\paragraph{Rest.}", r"\bf ", r"\subparagraph*{Rest.}", r"\it "])
def test_what_follows_a_run_in_heading_or_a_font_keeps_its_order(font: str) -> None:
    text = rf"One. {font} Two {Y} three." + "\n\n" + rf"{font} Four {Y} five."
    first, shown, *others = read(text)[-6:]
    told = [said(block) for block in (first, *others) if not isinstance(block, Equations)]
    words = [next(w for w in ("Two", "three", "Four", "five") if w in text) for text in told]
    assert words == ["Two", "three", "Four", "five"] and shown == SHOWN[0].blocks[0]


def test_headings_lists_and_theorems() -> None:
    heading, listing, theorem = read(
        r"\section{One \emph{thing}}\begin{enumerate}\item first\item[b] second\end{enumerate}"
        r"\begin{theorem}It holds.\end{theorem}"
    )
    assert isinstance(heading, Heading) and heading.level == 1 and said(heading.text) == "One thing"
    assert isinstance(listing, Items) and listing.numbered
    assert [said(item).strip() for item in listing.items] == ["first", "b second"]
    assert theorem.text[0] == Emphasis(("Theorem\u00a01. ",), strong=True)


def test_fonts_reach_to_the_end_of_their_group() -> None:
    (one,) = read(r"{\bf Bold \it both} plain \textit{slanted}")
    bold, plain, slanted = (part for part in one.text if part != " ")
    assert bold == Emphasis(("Bold ", Emphasis(("both",))), strong=True)
    assert (plain, slanted) == (" plain ", Emphasis(("slanted",)))


def test_references_citations_and_the_literature() -> None:
    to = Link("claim.eq1", ("1",))
    first, heading, literature = read(
        r"See (\ref{eq}), \eqref{eq}, \ref{no}; \cite{b,none}."
        r"\begin{thebibliography}{9}\bibitem{a} One.\bibitem{b} Two.\end{thebibliography}",
        eq=to,
    )
    assert said(first.text) == "See (claim.eq11), (claim.eq11), no; [bib.b2, none]."
    assert isinstance(heading, Heading) and heading.text == ("References",)
    assert isinstance(literature, Items)
    assert [item[0].anchor for item in literature.items] == ["bib.a", "bib.b"]


def test_sections_and_theorems_are_referred_to_by_their_numbers() -> None:
    _, first, second = read(
        r"\section{A}\label{a}See \ref{l} and \ref{a}.\begin{lemma}\label{l} It holds.\end{lemma}"
    )
    assert said(first) == "See 1 and 1." and said(second).split() == ["Lemma", "1.", "It", "holds."]


def test_a_table_has_rows_and_a_caption() -> None:
    table, caption = read(
        r"\begin{table}[h]\centering\begin{tabular}{lr}\toprule case & "
        rf"{X}\\ \midrule one & 2\\ \bottomrule\end{{tabular}}\caption{{Cases.}}\end{{table}}"
    )
    assert isinstance(table, Table) and said(caption) == "Cases."
    assert said(table.head[0]).strip() == "case" and any(isinstance(p, Name) for p in parts(table))
    assert [[said(cell).strip() for cell in row] for row in table.rows] == [["one", "2"]]


def test_accents_dashes_and_footnotes_are_read() -> None:
    (one,) = read(r"Poincar\'e---1--2 ``so''~\ss\footnote{A note.}")
    assert said(one) == "Poincaré—1–2 “so”\u00a0ß (A note.)"


def test_what_is_not_known_stands_as_it_is_typed() -> None:
    one, figure = read(r"A \strange{thing}." "\n" r"\begin{figure}\includegraphics{a}\end{figure}")
    assert Code(r"\strange") in one.text or r"\strange" in said(one)
    assert r"\includegraphics{a}" in said(figure)


@pytest.mark.parametrize(
    "tex", ["{", "}", r"\begin{itemize}", r"\end{x}", "\\", "{" * 3000, "$", "%"]
)
def test_broken_text_is_read_as_far_as_it_goes(tex: str) -> None:
    assert f"{X}" not in said(read(f"Before {X} {tex} behind."))
    assert "Before" in said(read(f"Before {X} {tex} behind."))


PIECES = [
    "word ",
    "\n\n",
    "{",
    "}",
    r"\bf ",
    r"\emph",
    r"\item ",
    r"\section",
    "[",
    "]",
    "~",
    r"\strange",
]
PIECES += [
    rf"\{end}{{{name}}}"
    for end in ("begin", "end")
    for name in ("itemize", "figure", "odd", "lemma")
]


@given(st.lists(st.sampled_from(PIECES), max_size=12), st.data())
def test_no_formula_is_lost_and_none_is_there_twice(pieces: list[str], data: Any) -> None:
    for k in range(len(PLACED)):
        pieces.insert(data.draw(st.integers(0, len(pieces))), chr(FIRST + k))
    blocks = read("".join(pieces))
    names = Counter(part for part in parts(blocks) if isinstance(part, Name))
    assert names == {Name(f"{letter}_{k}"): 1 for letter in "xy" for k in range(3)}


EVERY = sorted(
    spec.macroname
    for category in get_default_latex_context_db().categories()
    for spec in get_default_latex_context_db().iter_macro_specs([category])
)


@given(
    st.lists(
        st.tuples(
            st.sampled_from(EVERY), st.sampled_from(["", "{}", "{}{}", "{a}{}", "[]", "[a]{"])
        ),
        max_size=5,
    )
)
def test_a_macro_may_have_any_arguments(macros: list[tuple[str, str]]) -> None:
    assert isinstance(read(" ".join(f"\\{name}{after}" for name, after in macros)), tuple)


@pytest.mark.parametrize("after", ["{}{}", "{x}{}", "{}{y}", ""])
def test_a_link_that_leads_nowhere_stands_as_it_is_typed(after: str) -> None:
    (block,) = read(rf"word \href{after} word")
    assert said(block).startswith("word ")


def test_without_the_parser_the_reader_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "pylatexenc.latexwalker", None)
    with pytest.raises(ProseError, match=r"pip install 'kowalevski-cas\[page\]'"):
        read("word")
