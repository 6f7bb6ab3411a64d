"""The phrases of a report: lists, links, points, values, conditions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Final

from kowalevski_cas.notation import (
    Application,
    Formula,
    Relation,
    Vocabulary,
    equal,
    read_prose,
    split_display,
    to_plain,
)
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.report.document import Code, Emphasis, Inline, Link, Text, anchor
from kowalevski_cas.report.places import ClaimName, PaperSection
from kowalevski_cas.report.words import ZERO, capital, capitalise, list_in_words, runs, violates_no
from kowalevski_cas.verify.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    PrintedPoint,
)

LONG: Final = 80
"""The most signs of a definition that is shown within a sentence."""

_NOTHING: Final[Mapping[str, str]] = MappingProxyType({})


def _sentence(text: str, end: str) -> str:
    """The text with a capital and an end."""
    text = text.strip()
    return capital(text) + ("" if not text or text.endswith((".", "!", "?", ":")) else end)


class Phrases:
    """Phrases in the vocabulary of a paper.

    Args:
        vocabulary: the names in its formulas.
        names: what its claims are called.
        labels: where the numbers of its equations lead.
        certificates: the addresses of certificates, by claim.
        displays: the numbers of displays, by their names.
    """

    def __init__(
        self,
        vocabulary: Vocabulary,
        names: Mapping[str, ClaimName],
        labels: Mapping[str, str] = _NOTHING,
        certificates: Mapping[str, str] = _NOTHING,
        displays: Mapping[str, str] = _NOTHING,
    ) -> None:
        self.vocabulary, self.names = vocabulary, names
        self.labels, self.certificates, self.displays = labels, certificates, displays
        # The equations of another paper are named with their author: (10) of Kharlamov.
        numbers = "|".join(map(re.escape, labels)) or "(?!)"
        self._number = re.compile(f"({numbers})(?! of [A-Z])")

    def words(self, text: str) -> Text:
        """Words with mathematics between dollars, and links from the numbers of equations."""
        found: list[Inline] = []
        labels = self.labels
        for run in read_prose(text, self.vocabulary):
            if isinstance(run, str):
                parts = self._number.split(run)
                found += [Link(labels[p], (p,)) if p in labels else p for p in parts if p]
            else:
                found.append(run)
        return tuple(found)

    def sentence(self, text: str, end: str = ".") -> Text:
        """Words that begin with a capital, where they begin with a letter, and come to an end."""
        return self.words(_sentence(text, end))

    def title(self, section: PaperSection) -> Text:
        """The number and the title of a section, without links."""
        return read_prose(f"{section.number}. {section.title}", self.vocabulary)

    def name(self, claims: Sequence[str]) -> Text:
        """What claims are called that have one number, or what a single one is called."""
        name = self.names.get(claims[0])
        if name is None:
            return (Code(claims[0]),)
        if len(claims) == name.several:
            return (name.number,)
        places = runs(self.names[claim].place for claim in claims)
        return (f"formula{'s' * (len(claims) > 1)} {places} of {name.number}",)

    def links(self, claims: Iterable[str]) -> Text:
        """The names of several claims, with links to those that the report treats."""
        together: dict[str, list[str]] = {}
        for claim in claims:
            name = self.names.get(claim)
            together.setdefault(name.number if name else claim, []).append(claim)
        return list_in_words(
            [
                (Link(f"claim.{anchor(ones[0])}", self.name(ones)),)
                if ones[0] in self.names
                else self.name(ones)
                for ones in together.values()
            ]
        )

    def certificate(self, claims: Iterable[str]) -> Text:
        """Links to the certificates of claims, by the names of the files."""
        return list_in_words(
            [
                (Link(address, (address.rpartition("/")[2],), outside=True),)
                for claim in claims
                if (address := self.certificates.get(claim))
            ]
        )

    def link(self, claim: str, words: str) -> Text:
        """The words of a claim as a sentence that leads to it; its name if there are none."""
        if not words:
            return self.links([claim])
        said = read_prose(_sentence(words, "."), self.vocabulary)
        return (Link(f"claim.{anchor(claim)}", said),)

    def found(self, claims: Sequence[str]) -> Text:
        """Where the paper prints claims: near an equation with a number, or as such."""
        name = self.names.get(claims[0])
        if name is None or not name.near:
            return self.links(claims)
        return (Link(f"claim.{anchor(claims[0])}", (name.near,)),)

    def slip(self, slip: Sequence[Outcome]) -> Text:
        """Where a slip of the pen stands by which claims fail: in them, or in another formula."""
        correction = slip[0].correction
        if correction is None or correction.printed is None or not correction.blamed:
            return self.found([outcome.claim for outcome in slip])
        return self._printed(correction.printed) or ("formula ", *correction.blamed)

    def spoilers(self, outcome: Outcome) -> Text:
        """All misprints by which a claim fails that holds once they are mended."""
        correction = outcome.correction
        besides = [self._printed(place) for place in correction.besides] if correction else []
        return list_in_words(
            [self.slip((outcome,)), *(name or ("a formula without a number",) for name in besides)]
        )

    def _printed(self, place: Printed) -> Text:
        """What a formula is called by the number of its display; nothing if that has none."""
        several = len(split_display(place.display.tex)) > 1
        link = self._number_of(place.display)
        return (f"formula {place.number} of ", *link) if several and link else link

    def _number_of(self, display: Display) -> Text:
        """The number of a display, with a link to it; nothing if it has none."""
        label = self.displays.get(display.id, display.label)
        if not label:
            return ()
        return (Link(self.labels[label], (label,)) if label in self.labels else label,)

    def where(self, conditions: Iterable[Condition]) -> Text:
        """What several conditions say."""
        said = [violates_no(condition) for condition in conditions]
        if len(said) > 1:  # what has an “or” in it is kept together
            said = [("(", *one, ")") if len(one) > 1 else one for one in said]
        return list_in_words(said)

    def valid(self, conditions: Iterable[Condition]) -> Text:
        """Under which conditions something is valid; nothing if it always is."""
        where = self.where(conditions)
        return ("valid for ", *where) if where else ()

    def correct(self, correction: Correction) -> Text:
        """What is true in place of something false, as a sentence behind it."""
        said: Text = (" ", Emphasis(("Correct:",)), " ", *self.words(correction.words))
        where = self.where(correction.conditions)
        return (*said, *((", where ", *where) if where else ()), ".")

    def values(self, found: Counterexample, rate: bool = False) -> Text:
        """A point and what fails there, as a sentence; it says how a rate on the left is found."""
        how = ", computed from the printed equations," * rate
        said: Text = (f"the left side{how} is ", found.left, ", the right side ", found.right)
        if found.words:
            said = self.words(found.words)
        return (*capitalise((*self.at(found.point), *said, ".")), *self._defined(found))

    def _defined(self, found: Counterexample) -> Text:
        """By which definitions values are computed: what is long by the number of its display."""
        items: list[Text] = []
        for formula, place in found.defined:
            label = self._number_of(place.display)
            if len(to_plain(formula)) <= LONG:
                items.append((formula,))
            elif label and isinstance(formula, Relation):
                items.append((formula.members[0], " as in ", *label))
        return (" Here ", *list_in_words(items), ".") if items else ()

    @staticmethod
    def at(at: PrintedPoint) -> Text:
        """``At`` and the coordinates of a point, one by one; of many zeros, that all else is 0."""
        values = {name: value for name, value in at.values.items() if name != value}
        numbers = {name: values.pop(name) for name in [*values] if _is_number(name)}
        zeros = [name for name, value in values.items() if value == ZERO]
        rest = len(zeros) < len(values) and len(zeros) > 3
        items: list[Text] = []
        for name, value in values.items():
            if isinstance(value, str):
                items.append((name, f" = {value}"))
            elif not (rest and value == ZERO):
                items.append((equal(name, value),))
        if rest:
            items.append(("the other variables ", ZERO))
        here: Text = ("At ", *list_in_words(items, ", ")) if items else ()
        for name, value in numbers.items():
            here += (", with " if here else "With ", value, " in place of ", name, _ANY_NUMBER)
        return (*here, ": ") if here else ()


def _is_number(name: Formula) -> bool:
    r"""Whether a name of a point is no coordinate but a number, as :math:`\pi` is."""
    return name.names() <= {PI} and (PI in name.names() or isinstance(name, Application))


_ANY_NUMBER: Final = " (any number may stand for it: no algebraic equation of it is known)"
