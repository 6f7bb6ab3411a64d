"""The formulas of any article: where they stand, and whether they can be read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from kowalevski_cas.audit.audit import typed_formulas
from kowalevski_cas.audit.displays import Typed
from kowalevski_cas.audit.source import Source
from kowalevski_cas.audit.tokens import scanned
from kowalevski_cas.notation import NotationError, Vocabulary, read_display
from kowalevski_cas.notation.lexer import Token
from kowalevski_cas.notation.macros import FUNCTIONS, GREEK

_BOLD = (r"\mathbf{", r"\boldsymbol{", r"\vec{")


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


def listing(source: Source) -> tuple[list[Listed], list[tuple[int, str]]]:
    """All formulas of a source, read in the names that they use; and notes by line."""
    expanded, formulas = typed_formulas(source)
    vocabulary = guessed(formulas)
    found = []
    for formula in formulas:
        start = formula.start + len(formula.tex) - len(formula.tex.lstrip())
        offset = expanded.origin(start, start + 1)[0]
        count, trouble = 0, formula.trouble
        if not trouble:
            try:
                count = len(read_display(formula.tex, vocabulary))
                trouble = "" if count else "there is no formula here"
            except NotationError as error:
                trouble = error.message
        found.append(
            Listed(
                source.line(offset), source.column(offset), ", ".join(formula.labels),
                formula.kind, formula.inline, formula.tex.strip(), count, trouble,
            )
        )  # fmt: skip
    return found, [(source.line(offset), words) for offset, words in expanded.notes]


def guessed(formulas: Iterable[Typed]) -> Vocabulary:
    """The names in some formulas: bold letters as vectors, bold capitals as matrices."""
    names: set[str] = set()
    for formula in formulas:
        names.update(_names(scanned(formula.tex)))
    bold = {name for name in names if name.startswith(_BOLD)}
    matrices = {name for name in bold if name[name.index("{") + 1].isupper()}
    functions = names & FUNCTIONS
    return Vocabulary(
        scalars=frozenset(names - bold - functions),
        vectors=frozenset(bold - matrices),
        matrices=frozenset(matrices),
        functions=frozenset(functions),
        times=frozenset({"t", r"\tau"} | (names & {"s", "x"})),
        moving=frozenset(names - functions),
    )


def _names(tokens: Sequence[Token]) -> Iterator[str]:
    for at, token in enumerate(tokens):
        if token.kind != "letter":
            continue
        known = not token.text.startswith("\\") or token.text in GREEK.keys() | FUNCTIONS
        if not known and "{" not in token.text:
            continue
        following = at + 1
        while following < len(tokens) and tokens[following].kind in ("prime", "}"):
            following += 1
        if following < len(tokens) and tokens[following].kind == "^":
            after = following + 2
            if tokens[following + 1 : following + 2] and tokens[following + 1].kind == "{":
                while after < len(tokens) and tokens[after - 1].kind != "}":
                    after += 1
            if after < len(tokens) and tokens[after].kind == "_":
                following = after
        yield token.text + _index(tokens, following)


def _index(tokens: Sequence[Token], at: int) -> str:
    """The index that begins here, as the reader of formulas writes it."""
    if at + 1 >= len(tokens) or tokens[at].kind != "_":
        return ""
    first = tokens[at + 1]
    if first.kind == "number":
        return f"_{first.text[0]}"
    if first.kind != "{":
        text = first.text
    else:
        text = ""
        for token in tokens[at + 2 :]:
            if token.kind == "}":
                break
            gap = " " if text[-1:].isalpha() and "\\" in text and token.text[:1].isalpha() else ""
            text += gap + token.text
    return f"_{text}" if len(text) == 1 else f"_{{{text}}}"
