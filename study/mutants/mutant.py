"""Mutants of a source: one token of one formula changed, so that it can still be read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from random import Random

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.places import Correspondence
from kowalevski_cas.notation import (
    Formula,
    NotationError,
    PrintedStatement,
    Vocabulary,
    read_display,
)
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.source.displays import TypedFormula

PATIENCE = 10
"""How often a token is drawn in vain before no other mutant is looked for."""

Change = tuple[str, int, int, str]

_LETTER = re.compile(r"\\[A-Za-z]+|[A-Za-z]")
_PARTS = re.compile(r"^(?:\\(?:boldsymbol|mathbf|mathrm)\{)?(\\?[A-Za-z]+)\}?")


@dataclass(frozen=True)
class Mutant:
    """A changed token: where, what for what, and the source after the change."""

    printed: Printed
    kind: str
    line: int
    old: str
    new: str
    text: str
    before: Formula
    after: Formula

    @property
    def words(self) -> str:
        """The change in words."""
        return f"line {self.line}, {self.printed.place}: {self.new or 'nothing'} for {self.old}"


@dataclass(frozen=True)
class Site:
    """A token of a formula that can be changed."""

    place: Correspondence
    typed: TypedFormula
    tokens: list[Token]
    at: int


def sites(audit: Audit) -> list[Site]:
    """Every token of the formulas that a derivation knows."""
    found = []
    for place in audit.places:
        if place.typed is not None:
            try:
                tokens = scan(place.typed.tex)
            except NotationError:
                continue
            found += [Site(place, place.typed, tokens, at) for at in range(len(tokens))]
    return found


def sample(audit: Audit, size: int, random: Random) -> list[Mutant]:
    """Different mutants, each at a random token and one of its random changes."""
    places, letters = sites(audit), letters_of(audit.session.interpretation.texts.vocabulary)
    found: dict[str, Mutant] = {}
    known = idle = 0
    while len(found) < size and idle < PATIENCE * len(places):
        known, idle = len(found), 0 if len(found) > known else idle + 1
        site = random.choice(places)
        changes = list(changes_at(site.tokens, site.at, site.typed.tex, letters))
        if changes:
            mutant = mutate(audit, site, random.choice(changes))
            if mutant is not None:
                found.setdefault(mutant.text, mutant)
    return list(found.values())


def every(audit: Audit) -> Iterator[Mutant]:
    """Every mutant of every token."""
    letters = letters_of(audit.session.interpretation.texts.vocabulary)
    for site in sites(audit):
        for change in changes_at(site.tokens, site.at, site.typed.tex, letters):
            mutant = mutate(audit, site, change)
            if mutant is not None:
                yield mutant


def letters_of(vocabulary: Vocabulary) -> list[str]:
    """The letters of all declared names, without fonts and indices."""
    found = (_PARTS.match(name) for name in sorted(vocabulary.ranks))
    return sorted({match[1] for match in found if match is not None})


def mutate(audit: Audit, site: Site, change: Change) -> Mutant | None:
    """The mutant, if it can be read and is another formula."""
    kind, start, end, new = change
    typed, vocabulary = site.typed, audit.session.interpretation.texts.vocabulary
    offset = typed.start + start
    begin, stop = audit.expanded.origin(offset, offset + end - start)
    text = audit.source.text
    old = text[begin:stop]
    if old != typed.tex[start:end]:  # a macro prints it
        return None
    try:
        own = _read(typed.tex, vocabulary)
        read = _read(typed.tex[:start] + new + typed.tex[end:], vocabulary)
    except NotationError:
        return None
    number = _difference(own, read)
    if number is None:
        return None
    return Mutant(
        site.place.display[number], kind, audit.source.line(begin), old, new.strip(),
        text[:begin] + new + text[stop:],
        own[number - 1].formula, read[number - 1].formula,
    )  # fmt: skip


@lru_cache(maxsize=1024)
def _read(tex: str, vocabulary: Vocabulary) -> tuple[PrintedStatement, ...]:
    return read_display(tex, vocabulary)


def _difference(old: tuple[PrintedStatement, ...], new: tuple[PrintedStatement, ...]) -> int | None:
    """The number of the statement that differs; ``None`` if none or the whole differs."""
    if len(old) != len(new):
        return None
    pairs = zip(old, new, strict=True)
    return next((k for k, (a, b) in enumerate(pairs, 1) if a.formula != b.formula), None)


def changes_at(tokens: list[Token], at: int, tex: str, letters: list[str]) -> Iterator[Change]:
    """The kind of a change, the interval and what is typed there instead."""
    token = tokens[at]
    if token.kind == "sign":
        yield "sign", token.start, token.end, "-" if token.text == "+" else "+"
    elif token.kind == "number":
        yield from _numbers(tokens, at)
    elif token.kind == "letter":
        yield from _letters(token, tex, letters)
    elif token.kind == "operator" and token.text in ("Re", "Im"):
        yield "letter", token.start, token.end, "Im" if token.text == "Re" else "Re"


def _numbers(tokens: list[Token], at: int) -> Iterator[Change]:
    """Numbers near by, or none in the place of a coefficient."""
    token, kind = tokens[at], _role(tokens, at)
    value = int(token.text) if len(token.text) < 9 else 0
    for other in sorted({value - 1, value + 1, 2 * value, 1, 2, 3} - {value, -1}):
        if (other or kind == "coefficient") and (kind != "index" or other <= 3):
            yield kind, token.start, token.end, str(other)
    if kind == "coefficient" and at + 1 < len(tokens):
        yield kind, token.start, token.end, ""


def _letters(token: Token, tex: str, letters: list[str]) -> Iterator[Change]:
    """Every other letter in the place of the last one of a token."""
    for found in list(_LETTER.finditer(tex, token.start, token.end))[-1:]:
        start, end = found.span()
        for letter in letters:
            if letter != found[0]:
                gap = " " if letter[0] == "\\" and tex[end : end + 1].isalpha() else ""
                yield "letter", start, end, letter + gap


def _role(tokens: list[Token], at: int) -> str:
    """Whether a number is an index, an exponent or a coefficient."""
    depth = 0
    for token in reversed(tokens[:at]):
        if token.kind == "}":
            depth += 1
        elif token.kind == "{":
            depth -= 1
        elif token.kind in ("^", "_") and (depth < 0 or token is tokens[at - 1]):
            return "exponent" if token.kind == "^" else "index"
        elif depth == 0 and token is not tokens[at - 1] and token.kind in ("letter", "close"):
            break
    return "coefficient"
