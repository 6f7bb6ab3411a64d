r"""The formulas of a source: displays with their labels and rows, and inline formulas.

Numbered rows of ``eqnarray``, ``align`` and their like are formulas of their own, unless one runs
on in the next.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from kowalevski_cas.source.comments import Comment

DISPLAYS = (
    "equation displaymath eqnarray align alignat flalign gather multline dmath math subequations"
).split()
ROWS = frozenset({"eqnarray", "align", "alignat", "flalign", "gather", "gather*"})
"""Environments in which every row is a formula of its own."""

LONGEST = 50_000
"""Characters in one formula."""
PATIENCE = 1_000_000
"""Characters that are looked through for the ends of formulas that have none."""

_MARK = re.compile(
    r"\\\\(?:\s*\*?\s*\[[^\]\n]{0,20}\])?"  # the end of a row: no bracket of a display
    r"|\\begin\s*\{\s*(?P<begin>[A-Za-z]+)(?P<star>\*?)\s*\}"
    r"|\\end\s*\{\s*(?P<end>[A-Za-z]+)\*?\s*\}"
    r"|(?P<open>\\[\[(])|(?P<close>\\[\])])"
    r"|\\."
    r"|(?P<dollar>\$\$?)"
    r"|(?P<paragraph>\n[ \t\r]*\n\s*)",
    re.DOTALL,
)
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_UNNUMBERED = re.compile(r"\\(?:nonumber|notag)(?![A-Za-z])")
_ROW = re.compile(
    r"\\begin(?![A-Za-z])|\\end(?![A-Za-z])|\\\\\s*\*?(?:\s*\[[^\]\n]{0,20}\])?|\\.|[{}]", re.DOTALL
)
_INLINE = ("$", r"\(")
_PARTNERS = {r"\[": r"\]", r"\(": r"\)"}
_COLUMNS = re.compile(r"\s*\{\s*\d+\s*\}")


@dataclass(frozen=True)
class TypedFormula:
    """A formula as the author typed it, with its interval in the text."""

    tex: str
    start: int
    end: int
    kind: str
    """The environment, or the mark that opens the formula."""
    labels: tuple[str, ...] = ()
    inline: bool = False
    trouble: str = ""
    """Why this is no whole formula, if it is none."""
    comments: tuple[Comment, ...] = ()
    """What the author says of it to this program."""


def find_formulas(text: str, start: int = 0) -> Iterator[TypedFormula]:
    """All formulas of a text from an offset on, in their order.

    Where too many have no end, the rest is not looked at.
    """
    at, patience = start, PATIENCE
    while (match := _MARK.search(text, at)) is not None:
        at = inside = match.end()
        begun, mark = match["begin"], match["dollar"] or match["open"]
        if begun in DISPLAYS and begun != "subequations":
            group, partner, kind = "end", begun, begun + match["star"]
            if begun == "alignat" and (columns := _COLUMNS.match(text, at)) is not None:
                inside = columns.end()
        elif mark:
            group, partner = "close" if match["open"] else "dollar", _PARTNERS.get(mark, mark)
            begun = kind = mark
        else:
            continue
        closing = _closing_mark(text, inside, group, partner)
        if closing is not None:
            yield from _rows(text, inside, closing[0], kind)
            at = closing[1]
            continue
        yield _break(text, match.start(), inside, begun)
        paragraph = -1 if group == "end" else text.find("\n\n", inside, inside + LONGEST)
        patience -= (paragraph if paragraph >= 0 else min(inside + LONGEST, len(text))) - inside
        if patience < 0:
            return


def _closing_mark(text: str, at: int, group: str, partner: str) -> tuple[int, int] | None:
    """The interval of the mark that closes a formula, before the paragraph ends."""
    depth = 0
    for match in _MARK.finditer(text, at, min(len(text), at + LONGEST)):
        if match["paragraph"] and group != "end":
            return None
        if group == "end" and match["begin"] == partner:
            depth += 1
        found = match[group]
        if found == partner or (found == "$$" and partner == "$"):
            if depth == 0:
                # Two dollars in a row close one inline formula and open the next.
                short = found != partner
                return match.start(), match.start() + 1 if short else match.end()
            depth -= 1
    return None


def _break(text: str, start: int, inside: int, kind: str) -> TypedFormula:
    head = text[inside : inside + 60].partition("\n\n")[0]
    end, trouble = inside + len(head), f"{kind} is never closed"
    return TypedFormula(head, start, end, kind, (), kind in _INLINE, trouble)


def _labels(tex: str) -> tuple[str, ...]:
    return tuple(label.strip() for label in _LABEL.findall(tex))


def _rows(text: str, start: int, end: int, kind: str) -> Iterator[TypedFormula]:
    """The formulas of an environment: one, or one for each number."""
    tex = text[start:end]
    if kind not in ROWS:
        yield TypedFormula(tex, start, end, kind, _labels(tex), kind in _INLINE)
        return
    first = 0
    ends = [*row_ends(tex)]
    for (last, following), (after, _) in zip(ends, [*ends[1:], ends[-1]], strict=True):
        row = tex[first:last]
        if following < len(tex) and (
            _UNNUMBERED.search(row) or _runs_on(row, tex[following:after])
        ):
            continue
        if row.strip(" \t\r\n&"):
            yield TypedFormula(row, start + first, start + last, kind, _labels(row))
        first = following


_RELATION = re.compile(r"=|<|>|\\(?:[lg]eq?|equiv|approx|simeq|sim|neq?)(?![A-Za-z])")
_SIGN = r"(?P<sign>[-+])|/|\\(?:pm|mp|times|cdot|wedge)(?![A-Za-z])"
_SPACES = (
    r"(?:[\s&~]|\{\}|\\(?:q?quad(?![A-Za-z])|left\s*\.|[,;:!\s]"
    r"|(?:hspace|phantom|label)\*?\s*\{[^{}]*\}))*"
)
_JOINS = re.compile(rf"{_SPACES}(?:{_SIGN}|{_RELATION.pattern})")
_OPEN = re.compile(rf"(?:{_SIGN}|{_RELATION.pattern}|\()\s*$")
_SCRIPT = re.compile(r"[_^]\s*\{[^{}]*\}")


def _runs_on(row: str, following: str) -> bool:
    """Whether the formula of a row runs on in the next one: a sign stands at the break.

    A row that begins with a plus or a minus, and states a relation, is a formula of its own; so is
    one behind a row that states none, or ends with a mark.
    """
    before, behind = (
        _SCRIPT.sub("", _LABEL.sub("", one)).strip(" \t\r\n&") for one in (row, following)
    )
    if _OPEN.search(before):
        return True
    joins = _JOINS.match(behind)
    if joins is None or not before or before.endswith((",", ".", ";")):
        return False
    states, anew = (_RELATION.search(one) is not None for one in (before, behind))
    return joins["sign"] is None or (states and not anew)


def row_ends(tex: str) -> Iterator[tuple[int, int]]:
    """The interval of each break between rows outside braces and inner environments."""
    depth = 0
    for match in _ROW.finditer(tex):
        mark = match[0]
        if mark in ("{", r"\begin"):
            depth += 1
        elif mark in ("}", r"\end"):
            depth -= 1
        elif mark.startswith("\\\\") and depth == 0:
            yield match.span()
    yield len(tex), len(tex)
