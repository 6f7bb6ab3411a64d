"""Whose conditions are those of a sentence, as in “F is an integral if a=0, and G if b=0”."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import MARK

_ANEW = re.compile(
    r"(?:[,;:]|\b(?:and|but|while|whereas|и|а|но)\b)[\s~]*(?:\w+[\s~]+){0,5}\w+[\s~]*$"
)
"""How words end that begin another clause with a condition."""

_SAYS_MORE = re.compile(
    r"\b(?:and|but|while|whereas|и|а|но)[\s~]+(?!(?:for|if|when|also|again|even|only|likewise|in|at|where"
    r"|with|remains?|stays?|still|keeps?|(?:is|are)\s+(?:one|so)|при|если|когда|также|в|с|оста\w+)\b)\w+[\s~]+(?:\w+[\s~]+){0,4}\w+[\s~]*$"
)
"""How words end that say something else of what was spoken of, under another condition."""

_GOES_ON = re.compile(r"[\s,~]*(?!(?:and|but|while|whereas|и|а|но)\b)[\w§]")
"""How words begin that go on with what holds under a condition."""

_JOINS = re.compile(r"\b(?:and|but|while|whereas|и|а|но)\b[\s,~]*(?:\w+[\s~]+){0,5}\w+[\s~]*$")
_RIGHT_BEHIND = re.compile(rf"[\s,~]*{MARK}")
"""How words end that join a condition, and begin where what holds under it is right behind."""

_OTHERWISE = re.compile(
    r"\b(?:otherwise|else|if\s+not|in\s+(?:all\s+)?(?:the\s+)?other\s+cases?|иначе|в\s+противном\s+случае"
    r"|в\s+(?:остальных|других)\s+случаях)\b",
    re.IGNORECASE,
)
"""Words for where a condition does not hold."""

_SAYS = re.compile(
    r"[\s,~]*(?:it|they|this|these|we|one|he|она?|они|оно|это|мы)\s+\w+", re.IGNORECASE
)
"""How words begin that say something of what was spoken of before, under a condition."""


def is_in_brackets(statement: SourceStatement) -> bool:
    r"""Whether a statement stands in brackets of its own, behind what holds under it: (a=1)."""
    if statement.typed.inline and _OPENED.search(statement.before):
        return _CLOSED.match(statement.after) is not None
    own = re.sub(r"\s", "", statement.printed.tex).strip(".,;")
    whole = re.sub(r"\s|\\[,;:! ]|\\(?:left|right)(?![A-Za-z])", "", statement.typed.tex)
    return f"({own})" in whole and not whole.startswith("(")


_LISTED = rf"(?:[\s,;~]|{MARK}|\b(?:and|for|if|when|with|case|и|при|если)\b)*"
_OPENED = re.compile(rf"\({_LISTED}$")
_CLOSED = re.compile(rf"{_LISTED}\)")
"""What stands around a condition in brackets, or in a list of several."""


class Clauses:
    """The conditions of a sentence: each belongs to the claims behind it, or to those before.

    Args:
        statements: those of the sentence, in their order.
        claims: whether each is claimed; what is not there is neither claimed nor supposed.
    """

    def __init__(
        self, statements: Iterable[SourceStatement], claims: Mapping[SourceStatement, bool]
    ) -> None:
        self.of: dict[SourceStatement, list[SourceStatement]] = {}
        self.behind: set[SourceStatement] = set()
        self._leading: list[SourceStatement] = []
        self._claims: list[SourceStatement] = []  # those that were spoken of last, together
        self._before: SourceStatement | None = None
        for statement in statements:
            if claims.get(statement):
                self._claim(statement)
            elif statement in claims and self._is_condition(statement):
                self._suppose(statement)
            self._before = statement

    @property
    def conditions(self) -> set[SourceStatement]:
        """Those that belong to claims of the sentence."""
        return {one for conditions in self.of.values() for one in conditions}

    def _claim(self, statement: SourceStatement) -> None:
        if _OTHERWISE.search(statement.lead):
            self._leading = []
        beside = self._before is not None and self._before.typed is statement.typed
        if self._before not in self._claims or not (beside or _is_joined(statement)):
            self._claims = []
        self._claims.append(statement)
        self.of[statement] = [*self._leading]

    def _is_condition(self, statement: SourceStatement) -> bool:
        listed = self._before in self.behind or self._before in self._leading
        said = cue("condition", statement.lead) or (listed and _is_joined(statement))
        return is_in_brackets(statement) or (statement.typed.inline and bool(said))

    def _suppose(self, statement: SourceStatement) -> None:
        anew = _ANEW.search(statement.lead) if not is_in_brackets(statement) else None
        goes_on = MARK in statement.after and _GOES_ON.match(statement.tail)
        goes_on = goes_on or _SAYS.match(statement.tail)
        goes_on = goes_on or (
            _JOINS.search(statement.lead) and _RIGHT_BEHIND.match(statement.after)
        )
        listed = self._before in self.behind and _is_joined(statement)
        before = (one for claim in self._claims for one in self.of[claim])
        other = any(one.names == statement.names for one in before)
        said = other and _SAYS_MORE.search(statement.lead) and not cue("integral", statement.lead)
        if self._claims and (listed or not (anew and (goes_on or said))):
            self.behind.add(statement)
            for claim in self._claims:
                self.of[claim].append(statement)
        else:
            more = not anew or self._before in self._leading
            self._leading = [*self._leading, statement] if more else [statement]
            self._claims = []


def _is_joined(statement: SourceStatement) -> bool:
    """Whether only a comma or “and” stands between a statement and the one before it."""
    return statement.lead.strip(" ,;~\n") in ("", "and", "or", "и", "или")
