"""The formulas of any article: where they stand, and whether they can be read."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import takewhile

from kowalevski_cas.notation import NotationError, Vocabulary, defined_names, read_display
from kowalevski_cas.notation.cursor import Cursor, is_known
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.open import independent
from kowalevski_cas.notation.symbol import STAR, symbol
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.text import Source
from kowalevski_cas.source.tokens import tokens_of

_LISTED = frozenset({"letter", "number", "comma", "accent", "_", "{", "}"})


@dataclass(frozen=True)
class Listed:
    """A formula, how many statements were read in it, or why none were."""

    line: int
    column: int
    label: str
    kind: str
    inline: bool
    tex: str
    statements: int
    trouble: str


def list_formulas(source: Source) -> tuple[list[Listed], list[tuple[int, str]]]:
    """All formulas of a source, read in the names that they use; and notes by line."""
    expanded, formulas = typed_formulas(source)
    guesses = [*reversed(guess(formulas))]
    # The letter d is that of a derivative, or else a name.
    vocabularies = [
        replace(vocabulary, scalars=vocabulary.scalars - {"d"}) for vocabulary in guesses
    ] + guesses
    found = []
    for formula in formulas:
        start = formula.start + len(formula.tex) - len(formula.tex.lstrip())
        offset = expanded.origin(start, start + 1)[0]
        count, trouble = _read(formula, vocabularies)
        found.append(
            Listed(
                source.line(offset), source.column(offset), ", ".join(formula.labels),
                formula.kind, formula.inline, formula.tex.strip(), count, trouble,
            )
        )  # fmt: skip
    notes = (*source.refused, *expanded.notes)
    return found, [(source.line(offset), words) for offset, words in notes]


def _read(formula: TypedFormula, vocabularies: Iterable[Vocabulary]) -> tuple[int, str]:
    """How many statements can be read in one of the vocabularies, or why none can."""
    troubles = [formula.trouble] if formula.trouble else []
    for vocabulary in () if troubles else vocabularies:
        try:
            if count := len(read_display(formula.tex, vocabulary)):
                return count, ""
            troubles.append("there is no formula here")
        except NotationError as error:
            troubles.append(error.message)
    return 0, troubles[0]


def guess(
    formulas: Iterable[TypedFormula], plain: Collection[str] = ()
) -> tuple[Vocabulary, Vocabulary]:
    """The names in some formulas, and what they may be: with bold capitals as vectors, or matrices.

    Other bold letters are vectors, and so are the ``plain`` ones; a letter with names in brackets
    behind it is a function of them, if its rate stands nowhere alone: what moves is none, though
    words may have it at another time.
    """
    names: set[str] = set()
    functions: set[str] = set()
    rated: set[str] = set()
    formulas = [*formulas]
    for formula in formulas:
        if tokens := tokens_of(formula.tex):
            found = Cursor("", [*tokens], Vocabulary()).letters()
            names.update(
                letter + index for letter, index in found if is_known(letter) or letter in FUNCTIONS
            )
            functions.update(_functions(tokens))
            rated.update(_rated(tokens))
    functions -= _factors(formulas, plain)
    names -= {*_conjugates(names, formulas)}
    bold = {name for name in names if symbol(name).is_bold or name in plain}
    upper = {name for name in bold if symbol(name).letter.isupper() and name not in plain}
    functions = (functions - rated) & names | names & FUNCTIONS
    derived = {by for formula in formulas for by in _independent(formula.tex)}
    primed = any("'" in formula.tex or r"\prime" in formula.tex for formula in formulas)
    others = names & ({"s", "x"} if primed else derived & {"s", "x"})
    vectors = Vocabulary(
        scalars=frozenset(names - bold - FUNCTIONS),
        vectors=frozenset(bold),
        functions=frozenset(functions),
        times=frozenset({"t"} | names & {r"\tau"} | others),
        moving=frozenset(names - (FUNCTIONS - rated)),
    )
    return vectors, replace(vectors, vectors=frozenset(bold - upper), matrices=frozenset(upper))


def _independent(tex: str) -> list[str]:
    """The variables by which a formula derives, if its TeX is sound."""
    with suppress(NotationError):
        return independent(tex)
    return []


def _conjugates(names: Set[str], formulas: Iterable[TypedFormula]) -> Iterator[str]:
    """The names with a star that no formula defines, beside those without it."""
    for name in names:
        parts = symbol(name)
        if parts.raised == STAR and replace(parts, raised="").name in names:
            if not any(name in _heads(formula.tex) for formula in formulas):
                yield name


def _heads(tex: str, first: bool = False) -> Iterator[str]:
    """The names that a display defines, or the first of each statement, if its TeX is sound."""
    with suppress(NotationError):
        for statement in defined_names(tex):
            yield from statement.names[:1] if first else statement.names


def _factors(formulas: Iterable[TypedFormula], plain: Collection[str]) -> set[str]:
    r"""The names before scalar products, as D in :math:`D(\mathbf a,\mathbf b)` beside `D=mr^2`.

    One is given by itself, by an expression without the vectors, and stands before nothing else.
    """
    before: dict[str, list[set[str]]] = {}
    own: dict[str, set[str]] = {}
    for formula in formulas:
        tokens = tokens_of(formula.tex)
        for name, pair in _calls(tokens, plain):
            before.setdefault(name, []).append(pair)
        given = dict.fromkeys(_heads(formula.tex, first=True), _vectors(tokens, plain))
        own |= {name: own.get(name, set()) | bold for name, bold in given.items()}
    return {
        name
        for name, pairs in before.items()
        if all(pairs)
        and own.get(name, {name}).isdisjoint(set[str]().union(*pairs))
        and not any(head.startswith(f"{name}(") for head in own)
    }


def _calls(tokens: Sequence[Token], plain: Collection[str]) -> Iterator[tuple[str, set[str]]]:
    """The names with a bracket behind them, and the vectors of a scalar product in it."""
    cursor = Cursor("", [*tokens], Vocabulary())
    for letter, index in cursor.letters():
        if cursor.tokens[cursor.at].text == "(":
            inner = _inside(tokens, cursor.at)
            commas = [k for k, one in enumerate(inner) if one.kind == "comma"]
            cut = commas[0] if len(commas) == 1 else 0
            sides = [_vectors(side, plain) for side in (inner[:cut], inner[cut:])]
            yield letter + index, sides[0] | sides[1] if all(sides) else set()


def _inside(tokens: Sequence[Token], opening: int) -> Sequence[Token]:
    """What stands in the bracket that is opened at a place."""
    depth = 0
    for k, token in enumerate(tokens[opening:], opening):
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if not depth:
            return tokens[opening + 1 : k]
    return tokens[opening + 1 :]


def _vectors(tokens: Iterable[Token], plain: Collection[str]) -> set[str]:
    letters = (one.text for one in tokens if one.kind == "letter")
    return {letter for letter in letters if letter in plain or symbol(letter).is_bold}


def _functions(tokens: Sequence[Token]) -> Iterator[str]:
    """The names with a list of names in brackets behind them, or with one."""
    cursor = Cursor("", [*tokens], Vocabulary())
    for letter, index in cursor.letters():
        if cursor.tokens[cursor.at].text == "(" and tokens[cursor.at - 1].kind != "prime":
            inner = list(takewhile(lambda t: t.kind in _LISTED, tokens[cursor.at + 1 :]))
            closing = cursor.tokens[cursor.at + 1 + len(inner)]
            letters = sum(t.kind == "letter" for t in inner)
            commas = sum(t.kind == "comma" for t in inner)
            if closing.text == ")" and letters > commas:
                yield letter + index


def _rated(tokens: Sequence[Token]) -> Iterator[str]:
    r"""The names of which rates are printed without arguments, as q by :math:`\ddot q=-q`."""
    for k, token in enumerate(tokens):
        before = [one for one in tokens[max(k - 4, 0) : k] if one.kind not in ("{", "^", "number")]
        if (
            token.kind == "letter"
            and before
            and (before[-1].kind == "accent" or before[-1].text == "d")
        ):
            cursor = Cursor("", [*tokens[k:]], Vocabulary())
            letter, index = next(cursor.letters())
            if cursor.tokens[cursor.at].text != "(":
                yield letter + index
