"""The phrases of a report: lists, links, points, values, conditions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Final

from kowalevski_cas.notation import Formula, Number, Relation, Vocabulary, read_prose
from kowalevski_cas.report.document import Code, Link, Text
from kowalevski_cas.report.names import anchor
from kowalevski_cas.verify.outcome import Condition, Counterexample, Point, Value

ZERO: Final = Number(0)


def listed(items: Sequence[Text], last: str = " and ") -> Text:
    """A list in words.

    >>> listed([("one",), ("two",), ("three",)])
    ('one', ', ', 'two', ' and ', 'three')
    """
    text: Text = ()
    for k, item in enumerate(items):
        text += ((last if k == len(items) - 1 else ", ",) if k else ()) + item
    return text


def in_words(many: int) -> str:
    """A number in words, as far as they are shorter."""
    names = "no one two three four five six seven eight nine ten eleven twelve".split()
    return names[many] if many < len(names) else str(many)


def counted(many: int, one: str, more: str = "") -> str:
    """How many there are.

    >>> counted(1, "misprint"), counted(13, "misprint")
    ('one misprint', '13 misprints')
    """
    return f"{in_words(many)} {one if many == 1 else more or one + 's'}"


def capital(text: str) -> str:
    """The text with a capital at its beginning."""
    return text[:1].upper() + text[1:]


def capitalised(text: Text) -> Text:
    """The text with a capital, where it begins with a word."""
    match text:
        case (str(word), *rest):
            return (capital(word), *rest)
        case (Link() as link, *rest):
            return (replace(link, text=capitalised(link.text)), *rest)
    return text


def chain(members: Sequence[Formula]) -> Formula:
    """An equality of several members."""
    if len(members) == 1:
        return members[0]
    return Relation(tuple(members), ("=",) * (len(members) - 1))


def nonzero(formula: Formula) -> Formula:
    """That a formula is not zero."""
    return Relation((formula, ZERO), (r"\ne",))


class Phrases:
    """Phrases in the vocabulary of a paper; ``names`` has the equations' numbers of claims."""

    def __init__(
        self, vocabulary: Vocabulary, claims: Iterable[str], names: Mapping[str, str]
    ) -> None:
        self.vocabulary, self.claims, self.names = vocabulary, frozenset(claims), names

    def words(self, text: str) -> Text:
        """Words with mathematics between dollars."""
        return read_prose(text, self.vocabulary)

    def sentence(self, text: str, end: str = ".") -> Text:
        """Words that begin with a capital, where they begin with a letter, and come to an end."""
        text = text.strip()
        stop = "" if text.endswith((".", "!", "?", ":")) else end
        return self.words(capital(text) + stop) if text else ()

    def name(self, claim: str) -> Text:
        """What a claim is called: by the number of its equation, if it has one."""
        return (self.names[claim],) if claim in self.names else (Code(claim),)

    def link(self, claim: str) -> Text:
        """The name of a claim, with a link if the report treats it."""
        if claim not in self.claims:
            return self.name(claim)
        return (Link(f"claim.{anchor(claim)}", self.name(claim)),)

    def links(self, claims: Iterable[str]) -> Text:
        """The names of several claims."""
        return listed([self.link(claim) for claim in claims])

    def where(self, conditions: Iterable[Condition]) -> Text:
        """What several conditions say."""
        return listed([(nonzero(condition.expression),) for condition in conditions])

    def values(self, found: Counterexample) -> Text:
        """A point and what fails there, as a sentence."""
        said: Text = ("the left side is ", found.left, ", the right side ", found.right)
        if found.words:
            said = self.words(found.words)
        return capitalised((*self.at(found.point), *said, "."))

    @staticmethod
    def at(at: Point) -> Text:
        """``At`` and the coordinates of a point, equal ones together."""
        equal: dict[Value, list[Formula]] = {}
        for name, value in at.values.items():
            if name != value:
                equal.setdefault(value, []).append(name)
        items: list[Text] = []
        rest = False
        for value, names in equal.items():
            if value == ZERO and len(equal) > 1 and len(names) > 3:
                rest = True
            elif isinstance(value, str):
                items.append((chain(names), f" = {value}"))
            else:
                items.append((chain([*names, value]),))
        if rest:
            items.append(("the other variables ", ZERO))
        return ("At ", *listed(items, ", "), ": ") if items else ()
