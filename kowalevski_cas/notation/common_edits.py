"""Slips in what is printed once and read several times: for all values of an index, or in a sum."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from kowalevski_cas.notation.edits import Edit, subtree
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import Formula
from kowalevski_cas.notation.layout import split_display
from kowalevski_cas.notation.layout import statements as tokens_of_statements
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.misprints import only_change
from kowalevski_cas.notation.ranges import letters_in_indices
from kowalevski_cas.notation.reader import Path, PrintedStatement, read_display
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.notation.vocabulary import Vocabulary

_Slip = tuple[str, tuple[tuple[Token, str], ...]]
"""Its kind, and what stands in the place of tokens."""


def printed_together(tex: str, number: int) -> tuple[int, ...]:
    r"""The numbers of the statements of a display that are printed with one of them.

    >>> printed_together(r"y=1,\quad \dot x_i=x_i,\quad i=1,2", 2)
    (2, 3)
    """
    spans = split_display(tex)
    return tuple(k for k, span in enumerate(spans, 1) if span == spans[number - 1])


def common_edits(
    statements: tuple[PrintedStatement, ...], number: int, vocabulary: Vocabulary
) -> Iterator[Edit]:
    r"""The edits of a statement of a display by slips in what several of its parts are read from.

    A sign, a number or an index is another one, or two indices are exchanged. What becomes of the
    statements that are printed with it, by their numbers, is ``beside``.

    >>> words = Vocabulary(frozenset({"x_1", "x_2", "a_1", "a_2"}))
    >>> found = read_display(r"\dot x_i=-a_ix_i,\quad i=1,2", words)
    >>> edit = next(common_edits(found, 1, words))
    >>> edit.tex, edit.words, [number for number, _ in edit.beside]
    ('\\dot x_i=+a_ix_i,\\quad i=1,2', 'for $-a_ix_i$ read $+a_ix_i$', [2])
    """
    statement = statements[number - 1]
    together = printed_together(statement.tex, number)
    read = Counter(token.start for token in tokens_of_statements(statement.tex)[number - 1].tokens)
    tokens = [t for t in scan(statement.tex) if statement.start <= t.start < statement.end]
    for kind, changes in _slips(tokens):
        if len(together) == 1 and all(read[token.start] < 2 for token, _ in changes):
            continue  # it is read once
        tex = _with(statement.tex, changes)
        try:
            after = read_display(tex, vocabulary)
        except NotationError:
            continue
        others = [k for k, _ in enumerate(statements, 1) if k not in together]
        same = len(after) == len(statements) and all(
            after[k - 1].formula == statements[k - 1].formula for k in others
        )
        if same and (change := _change(statement.formula, after[number - 1].formula)):
            beside = tuple((k, after[k - 1].formula) for k in together if k != number)
            words = _words(statement, changes)
            yield Edit(kind, *change, words, statement, vocabulary, beside, tex)


def _slips(tokens: list[Token]) -> Iterator[_Slip]:
    indices = letters_in_indices(tokens)
    letters = {token.text for token in indices}
    for token in tokens:
        if token.text in ("+", "-"):
            yield "sign", ((token, "-" if token.text == "+" else "+"),)
    for token in indices:
        yield from (("index", ((token, one),)) for one in sorted(letters - {token.text}))
    for before, token in pairwise(tokens):
        if token.kind == "number" and token.text.isdecimal():
            value, raised = int(token.text), before.kind == "^"
            for other in dict.fromkeys((value - 1, value + 1, 2 * value)):
                if other > raised:
                    text = "" if other == 1 else str(other)  # a factor is left out
                    yield "exponent" if raised else "coefficient", ((token, text),)
    for first, second in pairwise(indices):
        if first.text != second.text:
            yield "exchange", ((first, second.text), (second, first.text))


def _with(tex: str, changes: tuple[tuple[Token, str], ...]) -> str:
    """A source with other signs in the place of tokens."""
    for token, text in reversed(changes):
        tex = tex[: token.start] + text + tex[token.end :]
    return tex


def _change(before: Formula, after: Formula) -> tuple[Path, Formula] | None:
    """The smallest part that holds all in which two formulas differ, as it is in the second."""
    path: Path = ()
    while (place := only_change(subtree(before, path), subtree(after, path))) is not None:
        path = (*path, place)
    return None if before == after else (path, subtree(after, path))


def _words(statement: PrintedStatement, changes: tuple[tuple[Token, str], ...]) -> str:
    """What was changed, with the smallest part around it that is printed."""
    first, last = changes[0][0], changes[-1][0]
    around = (s for s in statement.spans.values() if s[0] <= first.start and last.end < s[1])
    wider = (s for s in statement.spans.values() if s[0] < first.start and last.end <= s[1])
    start, end = min((*around, *wider), key=lambda span: span[1] - span[0])
    new = _with(statement.tex, changes)
    grown = len(new) - len(statement.tex)
    return f"for ${statement.tex[start:end]}$ read ${new[start : end + grown]}$"
