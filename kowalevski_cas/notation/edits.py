"""Single-token edits of a statement: misprints to be made, and misprints to be mended."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import count

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Relation,
    Sum,
)
from kowalevski_cas.notation.latex import bracketed, to_latex
from kowalevski_cas.notation.layout import split_display
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.misprints import misprints, only_change
from kowalevski_cas.notation.reader import Path, PrintedStatement, read_statement
from kowalevski_cas.notation.tokens import BRACE
from kowalevski_cas.notation.vocabulary import Vocabulary

_COMMAND = re.compile(r"\\[A-Za-z]+$")


@dataclass(frozen=True)
class Edit:
    """One change of one place.

    ``kind`` is one of sign, index, letter, exponent, coefficient, factor, power, missing, exchange;
    ``replacement`` is the new subtree at ``path``, and ``words`` says what was changed. ``beside``
    is what becomes of statements that are printed together with this one, by their numbers; then
    ``source`` is what is typed.
    """

    kind: str
    path: Path
    replacement: Formula
    words: str
    statement: PrintedStatement = field(repr=False)
    vocabulary: Vocabulary = field(repr=False, compare=False)
    beside: tuple[tuple[int, Formula], ...] = field(default=(), repr=False)
    source: str = field(default="", repr=False)

    @property
    def formula(self) -> Formula:
        """The whole statement after the change."""
        return replace(self.statement.formula, self.path, self.replacement)

    @property
    def tex(self) -> str:
        """The source after the change: as little of it as possible is typed anew."""
        if self.source:
            return self.source
        wanted, before = self.formula, split_display(self.statement.tex)
        place = [start for start, _ in before].index(self.statement.start)
        for source in self._sources(wanted):
            try:
                if len(split_display(source)) != len(before):
                    continue
                found = read_statement(source, place + 1, self.vocabulary)
            except NotationError:
                continue
            if found.formula == wanted:
                return source
        return to_latex(wanted)

    def _sources(self, wanted: Formula) -> Iterator[str]:
        """Candidates for the source: the change in place, then wider and wider around it."""
        if self.kind == "sign":
            yield self._sign_flipped()
        for length in range(len(self.path), -1, -1):
            path = self.path[:length]
            tex = to_latex(subtree(wanted, path))
            yield self._retype(path, tex)
            yield self._retype(path, bracketed(tex))

    def _retype(self, path: Path, new: str) -> str:
        """The source with what printed the node typed anew."""
        tex = self.statement.tex
        start, end = self.statement.spans[path]
        # Braces whose partner stands outside stay where they are.
        opened: list[str] = []
        closed: list[str] = []
        for brace in BRACE.findall(tex, start, end):
            if brace == "{":
                opened.append(brace)
            elif brace == "}" and opened:
                opened.pop()
            elif brace == "}":
                closed.append(brace)
        gap = " " if _COMMAND.search(new) and tex[end : end + 1].isalpha() else ""
        return tex[:start] + new + "".join(closed) + gap + "".join(opened) + tex[end:]

    def _sign_flipped(self) -> str:
        """The source with the sign in front of a term changed, or one set there."""
        tex, spans, path = self.statement.tex, self.statement.spans, self.path
        start = after = spans[path][0]
        before = start
        positive = isinstance(self.replacement, Negative)
        if not positive:
            after = spans[(*path, 0)][0]
        summed = bool(path) and isinstance(subtree(self.statement.formula, path[:-1]), Sum)
        first = not summed or path[-1] == 0
        if not first:
            before = spans[(*path[:-1], path[-1] - 1)][1]
        new = "-" if positive else "" if first else "+"
        # A sign may stand twice, at the end of a row and at the beginning of the next.
        signs = [t for t in scan(tex) if t.kind == "sign" and before <= t.start < after]
        for token in reversed(signs):
            tex = tex[: token.start] + new + tex[token.end :]
        return tex if signs else tex[:start] + new + tex[start:]


def edits(
    statement: PrintedStatement,
    vocabulary: Vocabulary,
    names: frozenset[str] | None = None,
    wanted: Formula | None = None,
) -> Iterator[Edit]:
    r"""Every edit of one place, the likelier kinds first: sign, index, letter, exponent, ...

    ``names`` are the scalars that an edit may bring in, all that are declared if ``None``. If a
    formula is ``wanted``, those are left out that stand where no change can lead to it.

    >>> words = Vocabulary(frozenset({"x_1", "x_2"}))
    >>> statement = read_statement("x_1 - x_2", 1, words)
    >>> [edit.tex for edit in edits(statement, words)][:4]
    ['-x_1 - x_2', 'x_1 + x_2', 'x_2 - x_2', 'x_1 - x_1']
    """
    seen: set[tuple[Path, Formula]] = set()
    offered = vocabulary.scalars if names is None else names
    for slip in misprints(statement.formula, vocabulary, offered, wanted):
        if slip[1:3] not in seen:
            seen.add(slip[1:3])
            yield Edit(*slip, statement, vocabulary)


def subtree(formula: Formula, path: Path) -> Formula:
    """The node at the end of the path."""
    for index in path:
        formula = formula.children()[index]
    return formula


def replace(formula: Formula, path: Path, new: Formula) -> Formula:
    """The formula with another subtree at the end of the path."""
    if not path:
        return new
    first, *rest = path
    if first >= len(formula.children()):
        raise IndexError(f"no child {first} in {type(formula).__name__}")
    places = count()
    return formula.map_children(
        lambda child: replace(child, tuple(rest), new) if next(places) == first else child
    )


def substitute(formula: Formula, values: Mapping[str, Formula]) -> Formula:
    r"""The formula with other formulas in the place of names.

    >>> to_latex(substitute(Sum((Name("s"), Negative(Name("a")))), {"s": Name("s_1")}))
    's_1 - a'
    """
    if isinstance(formula, Name):
        return values.get(formula.name, formula)
    return formula.map_children(lambda child: substitute(child, values))


def changes_subject(edit: Edit) -> bool:
    r"""Whether an edit changes what a statement is about, or explains it by itself.

    That is a lone first member, as in :math:`U=1/6` and :math:`F`, and what is differentiated in
    the first one, as in :math:`A\dot p=(B-C)qr`.

    >>> words = Vocabulary(frozenset({"U", "x"}))
    >>> statement = read_statement("U=2x", 1, words)
    >>> [edit.tex for edit in edits(statement, words) if changes_subject(edit)]
    ['-U=2x', 'x=2x', 'U=2U', 'U^2=2x', '2U=2x', '\\frac{1}{2}U=2x', 'UU=2x', 'Ux=2x', 'U=2xU']
    """
    formula, path = edit.statement.formula, edit.path
    first, moving = formula, False
    if isinstance(formula, Relation):
        first = formula.members[0]
        moving = {*formula.members[1:]} != {Number(0)}
        if path[:1] != (0,):
            alone = isinstance(first, Name) and first not in formula.members[1:]
            return alone and first in edit.replacement.nodes()
        path = path[1:]
        if path and isinstance(first, Product):
            first, path = first.factors[path[0]], path[1:]
            if not isinstance(first, Derivative):
                return False
    if moving and isinstance(first, Derivative) and first in edit.replacement.nodes():
        return False
    while isinstance(first, Derivative):
        first = first.argument
    return isinstance(first, Name)


LARGEST_CHANGE = 4
"""By how many nodes a formula may grow or shrink in one edit."""


def is_small_change(before: Formula, after: Formula) -> bool:
    """Whether formulas differ in one subtree, which has about as many nodes in both.

    >>> words = Vocabulary(frozenset({"x", "y"}))
    >>> texts = ("x+y=1", "x-y=1", "x+y=x^2+y^2")
    >>> formulas = [read_statement(tex, 1, words).formula for tex in texts]
    >>> [is_small_change(formulas[0], other) for other in formulas]
    [False, True, False]
    """
    while (place := only_change(before, after)) is not None:
        before, after = before.children()[place], after.children()[place]
    return before != after and abs(_size(before) - _size(after)) <= LARGEST_CHANGE


def _size(formula: Formula) -> int:
    return sum(1 for _ in formula.nodes())
