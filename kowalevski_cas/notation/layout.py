"""A display to its statements: rows, cells, commas, and rows that run on.

A row or a cell that states a relation is a statement of its own. It runs on where a sign stands
at the break, or where the first cell of the row is empty and a minus stands in the second. Where
neither is so, what is meant cannot be seen, and is not guessed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from typing import NamedTuple

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.formula import EQUALITIES
from kowalevski_cas.notation.letters import with_stars
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.ranges import Condition, each_value, index_conditions, without_ranges
from kowalevski_cas.notation.sums import Ranges
from kowalevski_cas.notation.tensors import SPACE, permuted
from kowalevski_cas.notation.tokens import BEGINNING, BRACE, ENDING, Token

# Breaks, the stronger the larger: of several in a row the strongest counts.
_BREAKS = {"gap": 1, "cell": 2, "row": 3, "block": 4, "comma": 5}
_BINARY = frozenset({"sign", "plusminus", "relation", "times", "slash"})
EITHER_SIGN = re.compile(r"\\(?:pm|mp)(?![A-Za-z])|±|∓")
"""The signs of what is printed once for two statements."""
_UNCLEAR = "does this belong to what stands before the break? set a comma, or a sign"


_SINGLE = frozenset({"letter", "number"})
"""The kinds of tokens that may be one of two indices."""
_RATES = frozenset({"accent", "frac"})
_ORDERS = frozenset({"<", ">", r"\le", r"\ge", r"\ne"})
_IMPLICATIONS = frozenset(
    {
        r"\Rightarrow",
        r"\Longrightarrow",
        r"\implies",
        r"\Leftrightarrow",
        r"\Longleftrightarrow",
        r"\iff",
    }
)
"""The arrows with which a row may begin that follows from what stands above."""
_ROWS = frozenset({"row", "block"})


def _is_rate(tokens: list[Token]) -> bool:
    """Whether a statement begins with a rate: its indices are those of the tensors beside it."""
    return tokens[0].kind in _RATES


class _Run:
    """Tokens between two breaks, the break before them, and whether they state a relation.

    A run is indented if it stands in a row of which the first cell is empty.
    """

    def __init__(self, before: str) -> None:
        self.before = before
        self.tokens: list[Token] = []
        self.indented = self.relation = False


def split_display(tex: str) -> tuple[tuple[int, int], ...]:
    r"""The intervals of the statements in a display; no name needs to be known.

    >>> split_display(r"$$ F_1 = 0,\quad F_2 = 0 $$")
    ((3, 10), (17, 24))
    """
    return tuple((start, end) for _, start, end in statements(tex))


class StatementTokens(NamedTuple):
    """The tokens of a statement, and where it stands in its display."""

    tokens: list[Token]
    start: int
    end: int


@cache
def statements(tex: str) -> tuple[StatementTokens, ...]:
    """The statements of a display, with both braces of the groups that begin or end in them.

    With a ± in it, it is two statements, and one for each value of an index with a range.
    """
    tokens, ranges = without_ranges(scan(tex), tex)
    printed, conditions = _without_conditions(_statement_of(tokens, tex), ranges)
    known = {**dict.fromkeys(set[str]().union(*map(permuted, printed)), SPACE), **ranges}
    found = list[list[Token]]()
    for formula in printed:
        values = each_value(formula, known if _is_rate(formula) else ranges, tex, conditions)
        if not (every := [*values]) and conditions:
            message = "no values of the indices are left for which this is said"
            raise NotationError(message, tex, formula[0].start)
        found += every
    groups = _groups(tex)
    return tuple(
        StatementTokens(tokens, *_interval(tokens, groups))
        for statement in found
        for tokens in _signs_of(statement)
    )


def printed_statements(tex: str) -> list[list[Token]]:
    """The tokens of each statement as it is printed: with ±, and for all values of its indices."""
    tokens, ranges = without_ranges(scan(tex), tex)
    return _without_conditions(_statement_of(tokens, tex), ranges)[0]


def _without_conditions(
    printed: list[list[Token]], ranges: Ranges
) -> tuple[list[list[Token]], list[Condition]]:
    """The statements beside those that only say for which values of their indices they hold."""
    kept, found = list[list[Token]](), list[Condition]()
    for tokens in printed:
        behind = len(tokens) - 5  # as in “… = 0 (i ≠ j)”
        if conditions := index_conditions(tokens, ranges):
            found += conditions
        elif (
            behind > 0
            and tokens[behind].text == "("
            and (conditions := index_conditions(tokens[behind:], ranges))
        ):
            kept.append(tokens[:behind])
            found += conditions
        else:
            kept.append(tokens)
    return (kept, found) if kept else (printed, [])


def _groups(tex: str) -> list[tuple[int, int]]:
    """Where the groups in braces begin and end, inner ones first."""
    opened: list[int] = []
    found: list[tuple[int, int]] = []
    for brace in BRACE.finditer(tex):
        if brace[0] == "{":
            opened.append(brace.start())
        elif brace[0] == "}" and opened:
            found.append((opened.pop(), brace.end()))
    return found


def _interval(tokens: list[Token], groups: list[tuple[int, int]]) -> tuple[int, int]:
    """From where to where tokens stand, with the groups that begin or end there."""
    start, end = tokens[0].start, tokens[-1].end
    for first, last in groups:
        if first < start < last <= end or start <= first < end < last:
            start, end = min(start, first), max(end, last)
    return start, end


def _statement_of(tokens: list[Token], tex: str) -> list[list[Token]]:
    rows = _join(_runs(tokens, tex), ("gap", "cell"), tex)
    return [run.tokens for run in _join(rows, ("row", "block"), tex)]


def _signs_of(tokens: list[Token]) -> Iterator[list[Token]]:
    r"""A statement with the upper signs of all ±, and with the lower ones; itself without any.

    Of two indices, as in :math:`\lambda_{1,2}=a\pm b`, the first goes with the upper signs.
    """
    if all(token.kind != "plusminus" for token in tokens):
        yield tokens
        return
    pair = _is_pair(tokens[1:7])
    for place, signs in enumerate(({r"\pm": "+", r"\mp": "-"}, {r"\pm": "-", r"\mp": "+"})):
        signed = [
            Token("sign", signs[t.text], t.start, t.end)
            if t.kind == "plusminus"
            else Token(t.kind, t.text, t.start, t.end)
            for t in tokens
        ]
        yield with_stars([*_with_index(signed, place)] if pair else signed)


def _is_pair(tokens: list[Token]) -> bool:
    """Whether tokens are an index of two, with a comma between."""
    kinds = [token.kind for token in tokens]
    return kinds[:2] + kinds[3::2] == ["_", "{", "comma", "}"] and {kinds[2], kinds[4]} <= _SINGLE


def _with_index(tokens: list[Token], place: int) -> Iterator[Token]:
    """Tokens with the first or the second index of each pair."""
    left_out = set[int]()
    for at in range(len(tokens)):
        if _is_pair(tokens[at : at + 6]):
            left_out |= {at + 2, at + 3} if place else {at + 3, at + 4}
    yield from (token for at, token in enumerate(tokens) if at not in left_out)


def _join(runs: list[_Run], breaks: tuple[str, str], tex: str) -> list[_Run]:
    """The runs, with those joined that run on at these breaks."""
    joined: list[_Run] = []
    for run in runs:
        if joined and run.before in (*breaks, "comma") and _continues(joined[-1], run, tex):
            last = joined[-1]
            _append(last.tokens, run.tokens, run.before)
            last.relation |= run.relation
        else:
            joined.append(run)
    return joined


def _runs(tokens: list[Token], tex: str) -> list[_Run]:
    """What stands between the breaks outside all brackets; empty cells vanish."""
    runs = [_Run("comma")]
    broken = ""  # the last break inside brackets, where a sign may stand on both sides
    for token, depth, matrix in _depths(tokens, tex):
        run, kind = runs[-1], token.kind
        if kind in _BREAKS and not depth:
            if run.tokens:
                runs.append(_Run(kind))
            else:
                run.indented = kind == "cell" and (run.indented or run.before in ("row", "block"))
                run.before = _stronger(run.before, kind)
        elif kind in _BREAKS and kind != "comma" and not matrix:
            broken = _stronger(broken, kind)
        else:
            if token.text in _IMPLICATIONS and not run.tokens and run.before in _ROWS:
                run.before = "comma"
                continue
            run.relation |= kind == "relation" and not depth
            if broken:
                if broken != "gap" and not _runs_on(run.tokens[-1], token):
                    raise NotationError(_UNCLEAR, tex, token.start)
                _append(run.tokens, [token], broken)
                broken = ""
            else:
                run.tokens.append(token)
    for run in runs:
        while run.tokens and run.tokens[-1].kind == "stop":
            run.tokens.pop()
    parts = (_conditions(run) if run is not runs[0] else [run] for run in runs)
    found = [*_of_each(part for own in parts for part in own if part.tokens)]
    return [run for run in found if not _says_by_what(run.tokens)] or found


def _says_by_what(tokens: list[Token]) -> bool:
    r"""Whether it is said by what a prime or a dot derives, as :math:`{}'=d/d\tau`."""
    texts = [token.text for token in tokens if token.kind not in "{}"]
    if len(texts) < 5:
        return False
    quotient = texts[2:-1] in ([r"\frac", "d", "d"], ["d", "/", "d"])
    return tokens[0].kind in ("prime", "accent") and texts[1] in EQUALITIES and quotient


def _conditions(run: _Run) -> list[_Run]:
    r"""The relations in brackets that a run is, as :math:`\qquad(x>0)`: each stands by itself.

    The run, if it is anything else.
    """
    if run.relation or not run.tokens or run.tokens[0].text != "(":
        return [run]
    parts, depth = [_Run("comma")], 0
    for token in run.tokens:
        if depth == 0 and token is not run.tokens[0]:
            return [run]
        depth += (token.kind in BEGINNING) - (token.kind in ENDING)
        if depth == 1 and token.kind == "comma":
            parts.append(_Run("comma"))
        else:
            parts[-1].tokens.append(token)
            parts[-1].relation |= depth == 1 and token.kind == "relation"
    del parts[0].tokens[0], parts[-1].tokens[-1]
    whole = depth == 0 and parts[-1].relation
    return parts if whole and all(one.relation or _is_name(one.tokens) for one in parts) else [run]


def _is_name(tokens: Sequence[Token]) -> bool:
    """Whether tokens are a letter, perhaps with an index."""
    kinds = [token.kind for token in tokens]
    return kinds[:1] == ["letter"] and {*kinds[1:]} <= {"_", "{", "}", "letter", "number"}


def _of_each(runs: Iterable[_Run]) -> Iterator[_Run]:
    r"""Runs with what is said of each name in a list before an inequality: :math:`a,b>0`.

    So is the number that a list ends with, as in :math:`a,b=1`.
    """
    names: list[_Run] = []
    runs = [*runs]
    for run in runs:
        first = next((k for k, one in enumerate(run.tokens) if one.kind == "relation"), 0)
        if _is_name(run.tokens) and (run.before == "comma" or not names):
            names.append(run)
            continue
        said = run.tokens[first].text in _ORDERS or (
            run is runs[-1] and _ends_in_number(run, first)
        )
        is_said = run.before == "comma" and first and said
        if is_said and _is_name(run.tokens[:first]):
            for name in names:
                name.tokens += run.tokens[first:]
                name.relation = True
        yield from names
        names = []
        yield run
    yield from names


def _ends_in_number(run: _Run, sign: int) -> bool:
    """Whether a run says that something is a number; the sign of equality stands at a place."""
    *between, last = [token.kind for token in run.tokens[sign + 1 :]] or [""]
    return run.tokens[sign].text == "=" and between in ([], ["sign"]) and last == "number"


def _depths(tokens: list[Token], tex: str) -> Iterator[tuple[Token, int, bool]]:
    """Each token, the number of brackets around it, and whether one of them is a matrix."""
    depth = matrices = 0
    for token in tokens:
        if token.kind in ENDING:
            depth -= 1
            matrices -= token.kind == "end"
            if depth < 0:
                raise NotationError("this bracket closes nothing", tex, token.start)
        yield token, depth, matrices > 0
        if token.kind in BEGINNING:
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


def _runs_on(last: Token, first: Token) -> bool:
    """Whether a sign, a bracket or a comma says how a formula runs on at a break."""
    return last.kind in _BINARY | BEGINNING | {"comma"} or first.kind in _BINARY | ENDING | {
        "comma"
    }


def _continues(last: _Run, run: _Run, tex: str) -> bool:
    """Whether the statement before the break runs on behind it."""
    before, first = last.tokens[-1], run.tokens[0]
    if run.before == "comma":
        if before.kind == first.kind == "number" and tex[before.end : first.start] in (",", "{,}"):
            raise NotationError("a decimal comma? write a fraction", tex, first.start)
        return False
    both, neither = last.relation and run.relation, not (last.relation or run.relation)
    minus, signed = first.text == "-", before.kind in _BINARY or first.kind in _BINARY
    if run.before == "block":
        if signed or not both:
            raise NotationError("no formula runs on into or out of these rows", tex, first.start)
        return False
    if (signed and not minus) or before.kind in _BINARY:
        return True
    if both:
        return minus and run.indented
    if neither and not minus and run.before == "row":
        return False  # an expression a row
    if neither or not minus:
        raise NotationError(_UNCLEAR, tex, first.start)
    return True
