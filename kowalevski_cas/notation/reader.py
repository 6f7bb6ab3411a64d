r"""LaTeX to formula: what the author typed, as a tree.

>>> from kowalevski_cas.notation.vocabulary import Vocabulary
>>> read(r"x'_1 = -2x_1", Vocabulary(frozenset({"x_1"}))).signs
('=',)
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from kowalevski_cas.notation.cursor import Piece
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Formula
from kowalevski_cas.notation.layout import StatementTokens, printed_statements, statements
from kowalevski_cas.notation.parser import Parser
from kowalevski_cas.notation.vocabulary import Vocabulary

Path = tuple[int, ...]


@dataclass(frozen=True)
class PrintedStatement:
    """One statement of a display and where it stands in the source."""

    formula: Formula
    tex: str = field(repr=False)
    start: int
    end: int
    piece: Piece = field(repr=False, compare=False)

    @property
    def source(self) -> str:
        """The source of this statement alone."""
        return self.tex[self.start : self.end]

    @cached_property
    def spans(self) -> dict[Path, tuple[int, int]]:
        """The interval that printed each node, brackets around it included.

        A node is addressed by the indices of the children that lead to it.
        """
        spans: dict[Path, tuple[int, int]] = {}
        waiting: list[tuple[Path, Piece]] = [((), self.piece)]
        while waiting:
            path, (_, start, end, below) = waiting.pop()
            spans[path] = (start, end)
            waiting.extend(((*path, index), child) for index, child in enumerate(below))
        return spans


def read(tex: str, vocabulary: Vocabulary, parser: type[Parser] = Parser) -> Formula:
    r"""The one statement, or expression, in the source.

    >>> read(r"\frac12 x", Vocabulary(frozenset({"x"}))).factors[1]
    Name(name='x')
    """
    found = printed_statements(tex)
    if not found:
        raise NotationError("there is no formula here", tex, 0)
    if len(found) > 1:
        count = f"{len(found)} statements stand here; read_display reads them all"
        raise NotationError(count, tex, found[1][0].start)
    return parser(tex, found[0], vocabulary).statement()[0]


def read_display(
    tex: str, vocabulary: Vocabulary, parser: type[Parser] = Parser
) -> tuple[PrintedStatement, ...]:
    r"""Every statement of a display, in the order of the page.

    >>> words = Vocabulary(frozenset({"F_1", "F_2"}))
    >>> [statement.source for statement in read_display(r"$$ F_1=0,\quad F_2=0 $$", words)]
    ['F_1=0', 'F_2=0']
    """
    found = statements(tex)
    return tuple(_statement(tex, one, vocabulary, parser) for one in found)


def read_statement(tex: str, number: int, vocabulary: Vocabulary) -> PrintedStatement:
    r"""The statement of a number of a display, of which others may not be readable.

    >>> words = Vocabulary(frozenset({"F_1", "F_2"}))
    >>> read_statement(r"\lim_{t\to\infty}F_1=0,\quad F_2=0", 2, words).source
    'F_2=0'
    """
    return _statement(tex, statements(tex)[number - 1], vocabulary, Parser)


def _statement(
    tex: str, printed: StatementTokens, vocabulary: Vocabulary, parser: type[Parser]
) -> PrintedStatement:
    tokens, start, end = printed
    piece = parser(tex, tokens, vocabulary).statement()
    return PrintedStatement(piece[0], tex, start, end, piece)
