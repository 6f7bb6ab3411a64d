"""What is to be said about the claims of a display: each thing once, with those that have it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kowalevski_cas.notation import Formula, Relation, to_plain
from kowalevski_cas.report.compare import mark_differences
from kowalevski_cas.report.document import Block, Emphasis, Equations, Paragraph, Text
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.trial import trial_of
from kowalevski_cas.report.words import capitalise, group_alike, list_in_words
from kowalevski_cas.tools import title
from kowalevski_cas.verify.outcome import Condition, Outcome, ReportedStep, Verdict

LONG = 150
"""How many letters a formula has at most that stands among sentences; another is folded away."""


class Evidence:
    """What is said about one claim, or about the rows of one display."""

    def __init__(self, phrases: Phrases, rows: Sequence[Outcome]) -> None:
        self.phrases, self.rows = phrases, rows

    def first(self) -> Iterator[Block]:
        """What a reader has to know: why it is false, what was meant, what it lacks."""
        yield from self._counterexamples()
        yield from self._corrections()
        yield from self._missing_hypotheses()
        for row in self.rows:
            whose = self._whose((row.claim,))
            if row.message:
                yield Paragraph((*whose, *self.phrases.sentence(row.message)))
            if len(set(row.verdicts.values())) > 1:
                said = list_in_words([(f"{title(n)} says {v}",) for n, v in row.verdicts.items()])
                yield Paragraph((*whose, "The arithmetics disagree: ", *said, "."))

    def steps(self) -> Iterator[Block]:
        """What the program did: each sentence once, with the displays of all rows it is about."""
        told = [(row.claim, step) for row in self.rows for step in row.steps]
        for claims, ones in group_alike(told, lambda step: (step.words, step.point)):
            told_of = [formula for step in ones for formula in step.formulas]
            formulas = _informative(told_of)
            if told_of and not formulas:
                continue
            said = self._words_of(ones[0], bool(formulas))
            if ones[0].withheld and (file := self.phrases.certificate(claims)):
                said = (*self.phrases.sentence(ones[0].words, ": "), *file, ".")
            yield Paragraph((*self._whose(claims), *said), leads=bool(formulas))
            long = sum(len(to_plain(formula)) for formula in formulas) > LONG
            if formulas:
                yield Equations(formulas, long=long)

    def _words_of(self, step: ReportedStep, leads: bool) -> Text:
        if step.point is not None:
            return capitalise((*self.phrases.at(step.point), *self.phrases.words(step.words)))
        return self.phrases.sentence(step.words, ":" if leads else ".")

    def _missing_hypotheses(self) -> Iterator[Block]:
        """Hypotheses that are missing, those for the same reason together."""
        having = [
            (row.claim, condition)
            for row in self.rows
            for condition in row.conditions
            if condition.witness
        ]
        for claims, (condition, *_) in group_alike(having):
            head = Emphasis(("A hypothesis is missing:",))
            needed = (head, " ", *self.phrases.where((condition,)), ". ")
            yield Paragraph((*self._whose(claims), *needed, *self._fails(condition)))

    def _fails(self, condition: Condition) -> Text:
        """What happens without a hypothesis, and a point where it does."""
        witness = self.phrases.values(condition.witness) if condition.witness else ()
        return (*self.phrases.sentence(condition.words), " ", *witness)

    def _counterexamples(self) -> Iterator[Block]:
        """Each point once, with the values that the first of the rows has there."""
        having = [(row.claim, row.counterexample) for row in self.rows if row.counterexample]
        for claims, (one, *_) in group_alike(having, lambda one: (one.point, one.words)):
            of = (" to ", *self.phrases.links(claims[:1])) if len(self.rows) > 1 else ()
            doubted = all(row.verdict is Verdict.UNDECIDED for row in self.rows)
            head = Emphasis(
                ("Where it fails as it was read" if doubted else "Counterexample", *of, ".")
            )
            yield Paragraph((head, " ", *self.phrases.values(one)))
        for row in self.rows:
            if trial := trial_of(row, self.phrases.vocabulary):
                whose: Text = (" for ", *self.phrases.name((row.claim,)))
                yield trial._replace(of=whose if len(self.rows) > 1 else ())

    def _corrections(self) -> Iterator[Block]:
        """Corrections of the same kind together."""
        having = [
            (
                row.claim,
                one._replace(formulas=mark_differences(one.blamed or row.formulas, one.formulas)[1])
                if one.edit
                else one,
            )
            for row in self.rows
            if (one := row.correction)
        ]
        for claims, ones in group_alike(
            having, lambda one: (one.words, one.verdict, one.conditions, one.besides)
        ):
            one = ones[0]
            formulas = tuple(formula for each in ones for formula in each.formulas)
            what: Text = ("Correction" if one.edit else "The nearest true statement",)
            if one.blamed:
                rows = [row for row in self.rows if row.claim in claims]
                what, formulas = ("Correction of ", *self.phrases.spoilers(rows[0])), ()
            words = (" together",) if one.besides else (": ", *self.phrases.words(one.words))
            said: Text = (Emphasis(what), *self._of(claims), *words)
            if one.conditions:
                said = (*said, "; it holds where ", *self.phrases.where(one.conditions))
            if one.accepted:
                said = (*said, ". What follows is read with it")
            yield Paragraph((*said, "."), leads=bool(formulas))
            if formulas:
                yield Equations(formulas, verdict=one.verdict)
            for condition in one.conditions:
                if condition.witness:
                    yield Paragraph(self._fails(condition))

    def _of(self, claims: Sequence[str]) -> Text:
        whose = self._unless_all(claims)
        return (" in ", *self.phrases.links(whose)) if whose else ()

    def _whose(self, claims: Sequence[str]) -> Text:
        whose = self._unless_all(claims)
        return (*capitalise(self.phrases.links(whose)), ": ") if whose else ()

    def _unless_all(self, claims: Sequence[str]) -> tuple[str, ...]:
        """The claims, each once; none if they are all the rows there are."""
        ids = tuple(dict.fromkeys(claims))
        return () if len(ids) == len(self.rows) else ids


def _informative(formulas: Iterable[Formula]) -> tuple[Formula, ...]:
    """The formulas without equations that say nothing, as 1 = 1, or what another one says."""
    told: dict[object, Formula] = {}
    for formula in formulas:
        said = frozenset(formula.members) if isinstance(formula, Relation) else {formula}
        if len(said) > 1 or not isinstance(formula, Relation):
            told.setdefault(frozenset(said), formula)
    return tuple(told.values())
