"""A display to its statements: rows, cells, commas, and rows that run on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.lexer import Token, scan

# Breaks, the stronger the larger: of several in a row the strongest counts.
_BREAKS = {"gap": 1, "cell": 2, "row": 3, "comma": 4}
_OPENING = frozenset({"open", "{", "begin"})
_CLOSING = frozenset({"close", "}", "end"})
_BINARY = frozenset({"sign", "relation", "times", "slash"})


@dataclass
class _Run:
    """Tokens between two breaks, the break before them, and whether they state a relation."""

    before: str
    tokens: list[Token] = field(default_factory=list)
    relation: bool = False


def split_display(tex: str) -> tuple[tuple[int, int], ...]:
    r"""The intervals of the statements in a display; no name needs to be known.

    >>> split_display(r"$$ F_1 = 0,\quad F_2 = 0 $$")
    ((3, 10), (17, 24))
    """
    return tuple((tokens[0].start, tokens[-1].end) for tokens in statements(scan(tex), tex))


def statements(tokens: list[Token], tex: str) -> list[list[Token]]:
    """The tokens of each statement of a display."""
    joined: list[_Run] = []
    for run in _runs(tokens, tex):
        if joined and _continues(joined[-1], run):
            last = joined[-1]
            _append(last.tokens, run.tokens, run.before)
            last.relation |= run.relation
        else:
            joined.append(run)
    return [run.tokens for run in joined]


def _runs(tokens: list[Token], tex: str) -> list[_Run]:
    """What stands between the breaks outside all brackets; empty cells vanish."""
    runs = [_Run("comma")]
    broken = ""  # the last break inside brackets, where a sign may stand on both sides
    for token, depth, matrix in _nested(tokens, tex):
        run, kind = runs[-1], token.kind
        if kind in _BREAKS and not depth:
            if run.tokens:
                runs.append(_Run(kind))
            else:
                run.before = _stronger(run.before, kind)
        elif kind in _BREAKS and kind != "comma" and not matrix:
            broken = _stronger(broken, kind)
        else:
            run.relation |= kind == "relation" and not depth
            _append(run.tokens, [token], broken)
            broken = ""
    for run in runs:
        while run.tokens and run.tokens[-1].kind == "stop":
            run.tokens.pop()
    return [run for run in runs if run.tokens]


def _nested(tokens: list[Token], tex: str) -> Iterator[tuple[Token, int, bool]]:
    """Each token, the number of brackets around it, and whether one of them is a matrix."""
    depth = matrices = 0
    for token in tokens:
        if token.kind in _CLOSING:
            depth -= 1
            matrices -= token.kind == "end"
            if depth < 0:
                raise NotationError("this bracket closes nothing", tex, token.start)
        yield token, depth, matrices > 0
        if token.kind in _OPENING:
            depth += 1
            matrices += token.kind == "begin"


def _stronger(one: str, other: str) -> str:
    return max(one, other, key=lambda kind: _BREAKS.get(kind, 0))


def _append(tokens: list[Token], more: list[Token], before: str) -> None:
    """Join two runs; a sign that is repeated at the break of a row is one sign."""
    if before in ("row", "cell"):
        last, first = tokens[-1], more[0]
        if last.kind in _BINARY and last.text == first.text:
            tokens.pop()
    tokens += more


def _continues(last: _Run, run: _Run) -> bool:
    """Whether the statement before the break runs on behind it."""
    if run.before == "comma":
        return False
    first = run.tokens[0]
    if last.tokens[-1].kind in _BINARY:
        return True
    if first.kind in _BINARY and first.text != "-":
        return True
    if first.text == "-" or run.before == "gap":
        return not (last.relation and run.relation)
    # A row that states no relation of its own is a factor carried over; two expressions,
    # or two equations, are two statements.
    return last.relation != run.relation
