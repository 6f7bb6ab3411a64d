"""What an author says of formulas in comments: it goes before all rules."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches

from kowalevski_cas.notation import NotationError
from kowalevski_cas.notation.layout import statements
from kowalevski_cas.reading.grammar import BESIDE, NAMING, Directive, parse, wrong
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.text import Prose
from kowalevski_cas.reading.unprinted import unprinted
from kowalevski_cas.source.comments import Comment, find_comments
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.tokens import words


@dataclass(eq=False)
class Said:
    """The comments of a paper: by the statements that they are about, and claims of their own."""

    of: dict[SourceStatement, list[Directive]] = field(default_factory=dict)
    claims: list[Directive] = field(default_factory=list)
    supposed: dict[SourceStatement, list[SourceStatement]] = field(default_factory=dict)
    """What is supposed from a statement on, though the paper does not print it."""
    unprinted: list[SourceStatement] = field(default_factory=list)
    """What stands between dollars in comments, and not in the paper."""
    places: dict[Directive, TypedFormula | None] = field(default_factory=dict)
    """The formulas by which all this is said."""
    sentences: list[int] = field(default_factory=list)
    """The places in the text of the sentences that are skipped."""

    def role(self, item: SourceStatement) -> Directive | None:
        """What says which role a statement has."""
        return next((one for one in self.of.get(item, ()) if one.verb not in BESIDE), None)

    def accepted(self, item: SourceStatement) -> list[str]:
        """The formulas that should stand in the place of a statement."""
        return [one.tex for one in self.of.get(item, ()) if one.verb == "accept"]

    @property
    def rows(self) -> list[SourceStatement]:
        """The rates that are supposed."""
        return [one for own in self.supposed.values() for one in own if one.rates]

    def verb(self, item: SourceStatement) -> str:
        """The verb of what says which role a statement has; empty if nothing does."""
        found = self.role(item)
        return found.verb if found is not None else ""

    def on(self, item: SourceStatement) -> tuple[SourceStatement, ...] | None:
        """On which statements a claim rests, if that is said."""
        found = [one.on for one in self.of.get(item, ()) if one.on is not None]
        return found[-1] if found else None

    def skipped(self, prose: Prose) -> list[tuple[int, int]]:
        """The intervals of the sentences that comments skip."""
        return [prose.sentence(one) for one in self.sentences]

    def span(self, found: Directive, paper: SourcePaper) -> tuple[int, int]:
        """The interval of the text from a comment to the end of the sentence there."""
        start = paper.expanded.behind(found.comment.offset)
        return start, max(start, paper.prose.sentence(start)[1])

    @property
    def directives(self) -> list[Directive]:
        """All of them, each once, in the order of the text."""
        of_formulas = (one for own in self.of.values() for one in own)
        found = dict.fromkeys([*of_formulas, *self.claims])
        return sorted(found, key=lambda one: (one.comment.offset, one.comment.line))


def read_comments(paper: SourcePaper) -> Said:
    """What the comments of a paper say.

    Raises:
        SourceError: a comment cannot be obeyed: a word is not known, or there is no such formula.
    """
    said = Said()
    attached = {comment: typed for _, typed in paper.displays for comment in typed.comments}
    for comment in find_comments(paper.source):
        typed = attached.get(comment)
        items = [one for one in paper.items if one.typed is typed]
        for found in parse(comment, _Places(comment, items, paper, said)):
            said.places[found] = typed
            if found.is_of_formula:
                _enter(found, items, typed, paper, said)
            else:
                said.claims.append(found)
    return said


def _enter(
    found: Directive,
    items: Sequence[SourceStatement],
    typed: TypedFormula | None,
    paper: SourcePaper,
    said: Said,
) -> None:
    """Enter what a comment says of the formula by which it stands."""
    comment = found.comment
    if found.verb == "skip" and found.names == ("sentence",):
        said.sentences.append(_sentence(comment, paper))
        return
    if typed is None:
        raise wrong(comment, "no formula follows")
    chosen = [one for one in items if found.number in (0, one.printed.number)]
    if not chosen:
        raise wrong(comment, f"the formula has no statement {found.number}")
    for item in chosen:
        if item.formula is None and found.verb != "skip":
            raise wrong(comment, f"the formula cannot be read: {item.trouble}")
        _check_names(found, item)
        said.of.setdefault(item, []).append(found)
        if found.verb == "suppose":
            own = said.supposed.setdefault(item, [])
            for tex in _statements(found):
                id = f"supposed-at-{item.printed.place}-{len(own) + 1}"
                own.append(_unprinted(comment, tex, id, [item], paper))
                own[-1].order -= 1  # it is in force at the statement itself


@dataclass(frozen=True)
class _Places:
    """The statements that the words of a comment name, or that stand between dollars there."""

    comment: Comment
    beside: Sequence[SourceStatement]
    paper: SourcePaper
    said: Said

    def __call__(self, word: str) -> Sequence[SourceStatement]:
        if not word.startswith("$"):
            return places(word, self.paper)
        found, id = self.said.unprinted, f"unprinted-{len(self.said.unprinted) + 1}"
        found.append(_unprinted(self.comment, word.strip("$"), id, self.beside, self.paper))
        return found[-1:]


def _statements(found: Directive) -> Iterator[str]:
    """The formulas that a comment lists."""
    try:
        yield from (found.tex[start:end] for _, start, end in statements(found.tex))
    except NotationError as error:
        raise wrong(found.comment, error.message) from None


def _unprinted(
    comment: Comment, tex: str, id: str, beside: Sequence[SourceStatement], paper: SourcePaper
) -> SourceStatement:
    """The statement that a comment gives, beside those at which it stands."""
    place = f"{comment.path}:{comment.line}"
    try:
        found = unprinted(paper, id, tex, next(iter(beside), None), place)
    except NotationError as error:
        raise wrong(comment, error.message) from None
    paper.lines[id] = paper.source.line(comment.offset)
    return found


def _sentence(comment: Comment, paper: SourcePaper) -> int:
    """The place in the text with macros written out of the words behind a comment."""
    return paper.expanded.behind(comment.offset)


def _check_names(found: Directive, item: SourceStatement) -> None:
    if found.verb in NAMING:
        known = {_bare(name) for name in (*item.printed.heads.names, *item.names)}
        for name in found.names:
            if _bare(name) not in known:
                raise wrong(found.comment, f"the formula has no name {name}", name, known)


def _bare(name: str) -> str:
    return name.replace(" ", "")


def names_of(found: Directive, item: SourceStatement) -> tuple[str, ...]:
    """The names that a comment gives, as they are called in a statement."""
    called = {_bare(name): name for name in (*item.names, *item.printed.heads.names)}
    return tuple(called.get(_bare(name), name) for name in found.names)


def _printed(item: SourceStatement) -> tuple[tuple[str, ...], ...]:
    """The tokens of a statement, and of its display."""
    whole = words(item.typed.tex)
    return (whole,) if item.formula is None else (words(item.printed.tex), whole)


def places(word: str, paper: SourcePaper) -> Sequence[SourceStatement]:
    """The statements of a label, or of TeX in quotes.

    Raises:
        LookupError: there is none, or there are several formulas of this TeX.
    """
    if word.startswith('"'):
        wanted = words(word.strip('"'))
        found = [one for one in paper.items if wanted in _printed(one)]
        if len({id(one.typed) for one in found}) > 1:
            raise LookupError("stands there several times")
        if found:
            return found
        raise LookupError("is no formula of the paper")
    known: dict[str, list[SourceStatement]] = {}
    for one in paper.items:
        names = (*one.typed.labels, one.printed.display.id)
        numbered = (f"{name}.{one.printed.number}" for name in names)
        for name in dict.fromkeys((*names, *numbered)):
            known.setdefault(name, []).append(one)
    if word in known:
        return known[word]
    close = get_close_matches(word, known, 1, 0.5)
    raise LookupError(f"is no label of a formula{f'; did you mean {close[0]}?' if close else ''}")
