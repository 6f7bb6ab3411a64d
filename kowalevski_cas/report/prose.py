"""The text of an article around its formulas: what cannot be read stands as its source.

The formulas are taken out before, so that the parser, pylatexenc, meets words only; it executes
nothing and opens no file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import Any, Final

from kowalevski_cas import UserError
from kowalevski_cas.report.counters import THEOREM, numbers
from kowalevski_cas.report.document import (
    Block,
    Code,
    Emphasis,
    Heading,
    Inline,
    Items,
    Link,
    Table,
    Text,
    anchor,
)
from kowalevski_cas.report.paragraphs import FormulaBlocks, Paragraphs, says

_LEVELS: Final = {"part": 1, "chapter": 1, "section": 1, "subsection": 2, "subsubsection": 2}
_FONTS: Final = {
    **dict.fromkeys(("bf", "bfseries", "textbf"), True),
    **dict.fromkeys(("it", "em", "sl", "itshape", "textit", "emph", "textsl"), False),
}
_SILENT: Final = frozenset(
    """maketitle title author date thanks label noindent indent smallskip medskip bigskip vspace
    hspace newpage clearpage pagebreak thispagestyle pagestyle centering raggedright
    small large normalsize footnotesize protect looseness sloppy hfill tableofcontents
    bibliographystyle toprule midrule bottomrule hline""".split()
)
_SPECIALS: Final = {"--": "–", "---": "—", "``": "“", "''": "”", "~": "\u00a0", "&": " "}
_RUN_IN: Final = ("paragraph", "subparagraph")
"""Headings on the line of what they head."""

_LISTS: Final = {"itemize": False, "enumerate": True, "description": False}
_PLAIN: Final = frozenset(
    "document abstract center quote quotation flushleft minipage table figure".split()
)


class ProseError(UserError):
    """The text cannot be read; the message says why and what to do."""


def read_article(
    tex: str, placed: Sequence[FormulaBlocks], labels: Mapping[str, Link]
) -> list[Block]:
    """The blocks of an article.

    Args:
        tex: its body, with the letter ``FIRST + k`` for the formula number k.
        placed: what stands for each formula.
        labels: what a reference to a label shows, and where it leads.

    Raises:
        ProseError: if pylatexenc is not installed.
    """
    try:
        from pylatexenc.latexwalker import LatexWalker, get_default_latex_context_db
        from pylatexenc.macrospec import std_environment, std_macro
    except ImportError:
        raise ProseError(
            "the page around the formulas needs pylatexenc: pip install 'kowalevski-cas[page]'"
        ) from None
    article = _Article(tex, placed, labels)
    known = get_default_latex_context_db()
    known.add_context_category(
        "literature",
        macros=[
            *(std_macro(name, "[{") for name in ("bibitem", "caption")),
            *(std_macro(name, "*[{") for name in _RUN_IN),
        ],
        environments=[std_environment("thebibliography", "{")],
        prepend=True,
    )
    try:
        walker = LatexWalker(tex, latex_context=known, tolerant_parsing=True)
        article.read(walker.get_latex_nodes()[0])
    except Exception:  # whatever the parser stumbles over, all words are there
        article = _Article(tex, placed, labels)
        article.words(tex)
    article.end()
    return article.blocks


class _Article(Paragraphs):
    """Reads nodes one after the other into blocks."""

    def __init__(
        self, tex: str, placed: Sequence[FormulaBlocks], labels: Mapping[str, Link]
    ) -> None:
        super().__init__(placed)
        self.tex, self.labels = tex, labels
        keys = re.findall(r"\\bibitem\s*(?:\[[^\]]*\])?\s*\{([^{}]*)\}", tex)
        self.cited = {key: number for number, key in enumerate(keys, 1)}
        self.numbers = numbers(tex)
        self.theorems = 0
        self.headings = 0

    def _inner(self, nodes: Iterable[Any]) -> Text:
        """Nodes within the line; what they display follows the paragraph."""
        kept, self.line = self.line, []
        blocks, self.blocks = self.blocks, []
        self.read(nodes)
        text, self.line = tuple(self.line), kept
        self.after, self.blocks = [*self.after, *self.blocks], blocks
        return text

    # -- nodes ----------------------------------------------------------------------

    def read(self, nodes: Iterable[Any]) -> None:
        """Nodes of pylatexenc, each by its kind; a font changes the rest of a group in a line."""
        nodes = [node for node in nodes if node is not None]
        for k, node in enumerate(nodes):
            name = getattr(node, "macroname", None)
            if name not in _FONTS or _arguments(node):
                self._node(node)
            elif self.stays_in_line("".join(one.latex_verbatim() for one in nodes[k + 1 :])):
                self.line.append(Emphasis(self._inner(nodes[k + 1 :]), strong=_FONTS[name]))
                return

    def _node(self, node: Any) -> None:
        match type(node).__name__:
            case "LatexCharsNode":
                self.words(node.chars)
            case "LatexGroupNode":
                self.line += self._inner(node.nodelist)
            case "LatexSpecialsNode":
                self.line.append(_SPECIALS.get(node.specials_chars, node.specials_chars))
            case "LatexMacroNode":
                self._macro(node)
            case "LatexEnvironmentNode":
                self._environment(node)
            case "LatexMathNode":
                self.source(node.latex_verbatim())

    def _macro(self, node: Any) -> None:
        name, arguments = node.macroname, _arguments(node)
        known: dict[str, Callable[[], None]] = {
            "ref": lambda: self._reference(arguments),
            "eqref": lambda: self._reference(arguments, "({})"),
            "cite": lambda: self._cite(arguments),
            "footnote": lambda: self._footnote(arguments),
            "par": self.end,
            "includegraphics": lambda: self.source(node.latex_verbatim()),
            "caption": lambda: self._caption(arguments),
            "texttt": lambda: self.line.append(Code(_verbatim(arguments).replace("\\", ""))),
            "\\": lambda: self.line.append(" "),
            "S": lambda: self.line.append("§"),
        }
        if name in _LEVELS and arguments:
            self._heading_of(_LEVELS[name], self._inner([arguments[-1]]))
        elif name in _RUN_IN and arguments:
            self.end()
            self.line += [Emphasis(self._inner(arguments[-1:]), strong=True), " "]
        elif name in _FONTS and arguments:
            self.line.append(Emphasis(self._inner(arguments), strong=_FONTS[name]))
        elif name in known:
            known[name]()
        elif name not in _SILENT:
            self._letter(node)

    def _letter(self, node: Any) -> None:
        """A macro for letters, as an accent; any other stands as its source."""
        from pylatexenc.latex2text import LatexNodes2Text, get_default_latex_context_db

        if get_default_latex_context_db().get_macro_spec(node.macroname):
            with suppress(Exception):  # it stumbles over arguments that are missing or empty
                self.words(LatexNodes2Text().node_to_text(node) or " ")
                return
        self.source(node.latex_verbatim())

    def _heading_of(self, level: int, text: Text) -> None:
        self.end()
        self.headings += 1
        self.blocks.append(Heading(text, f"text.{self.headings}", level))

    def _reference(self, arguments: Sequence[Any], form: str = "{}") -> None:
        label = _verbatim(arguments)
        if label in self.labels:
            before, _, behind = form.partition("{}")
            self.line += [before, self.labels[label], behind]
        else:
            self.line.append(self.numbers.get(label) or Code(label))

    def _cite(self, arguments: Sequence[Any]) -> None:
        parts: list[Inline] = []
        for key in (key.strip() for key in _verbatim(arguments).split(",")):
            number = self.cited.get(key)
            shown: Inline = Link(f"bib.{anchor(key)}", (str(number),)) if number else Code(key)
            parts += [", " if parts else "[", shown]
        self.line += [*parts, "]"]

    def _count(self) -> str:
        self.theorems += 1
        return f"\u00a0{self.theorems}"

    def _caption(self, arguments: Sequence[Any]) -> None:
        self.end()
        self.line.append(Emphasis(self._inner(arguments)))
        self.end()

    def _footnote(self, arguments: Sequence[Any]) -> None:
        self.line += [" (", Emphasis(self._inner(arguments)), ")"]

    # -- environments ---------------------------------------------------------------

    def _environment(self, node: Any) -> None:
        name = node.environmentname
        if name in _PLAIN:
            if name == "abstract":
                self._heading_of(2, ("Abstract",))
            elif name in ("table", "figure"):
                self.end()
            self._apart(node.nodelist)
        elif name == "tabular":
            self._table(node)
        elif name.rstrip("*") in _LISTS or name == "thebibliography":
            self._list(node)
        elif name == "proof" or THEOREM.fullmatch(name):
            self.end()
            number = "" if name == "proof" or name.endswith("*") else self._count()
            self.line.append(Emphasis((f"{name.rstrip('*').capitalize()}{number}. ",), strong=True))
            self._apart(node.nodelist)
        else:
            self.end()
            self.source(node.latex_verbatim())
            self.end()

    def _table(self, node: Any) -> None:
        """A table; its first row is the head."""
        self.end()
        cells: list[list[list[Any]]] = [[[]]]
        for inner in node.nodelist:
            if getattr(inner, "macroname", "") == "\\":
                cells.append([[]])
            elif getattr(inner, "specials_chars", "") == "&":
                cells[-1].append([])
            else:
                cells[-1][-1].append(inner)
        rows = [tuple(map(self._inner, row)) for row in cells]
        head, *others = [row for row in rows if any(map(says, row))] or [((),)]
        self.blocks.append(Table((1 / len(head),) * len(head), head, tuple(others)))
        self.end()

    def _apart(self, nodes: Iterable[Any]) -> None:
        self.read(nodes)
        self.end()

    def _list(self, node: Any) -> None:
        """A list, or the literature, which citations lead to."""
        self.end()
        parts: list[list[Any]] = [[]]
        for inner in node.nodelist:
            if getattr(inner, "macroname", "") in ("item", "bibitem"):
                parts.append([])
            parts[-1].append(inner)
        self._apart(parts[0])
        if node.environmentname == "thebibliography":
            self._heading_of(1, ("References",))
        kept, self.blocks = self.blocks, []
        items: list[tuple[Block, ...]] = []
        for first, *rest in parts[1:]:
            if first.macroname == "bibitem":
                self.place = f"bib.{anchor(_verbatim(_arguments(first)))}"
            elif _arguments(first):
                self.line += [Emphasis(self._inner(_arguments(first)), strong=True)]
            self._apart(rest)
            items.append(tuple(self.blocks))
            self.blocks = []
        self.blocks = kept
        numbered = _LISTS.get(node.environmentname.rstrip("*"), True)
        self.blocks.append(Items(tuple(items), numbered))


def _arguments(node: Any) -> list[Any]:
    """The arguments of a macro that are there."""
    found = getattr(node, "nodeargd", None)
    return [
        argument for argument in (found.argnlist if found else None) or () if argument is not None
    ]


def _verbatim(arguments: Sequence[Any]) -> str:
    """The last argument as it is typed, without its braces."""
    return arguments[-1].latex_verbatim().strip("{} \n") if arguments else ""
