"""What a report says, from its title to its last section."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from textwrap import shorten
from types import MappingProxyType
from typing import Final

from kowalevski_cas.notation import print_prose, read_prose, to_plain
from kowalevski_cas.report.dependence import graph
from kowalevski_cas.report.document import (
    Block,
    Code,
    Document,
    Figure,
    Heading,
    Link,
    Paragraph,
    Sign,
    Table,
    Text,
    anchor,
)
from kowalevski_cas.report.erratum import erratum
from kowalevski_cas.report.figures import FigureFile
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.made import written_by
from kowalevski_cas.report.marks import MARKS, shown_as
from kowalevski_cas.report.passages import Passages
from kowalevski_cas.report.places import PaperSection, displays, labels, names
from kowalevski_cas.report.results import main_results
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.tally import tally, wrong_places
from kowalevski_cas.report.trust import trust
from kowalevski_cas.report.witnesses import Witness, arithmetics
from kowalevski_cas.report.words import group_alike, list_in_words, nonzero, supposed
from kowalevski_cas.verify.outcome import Run, Verdict


class Contents:
    """The report of a run, and its parts.

    Args:
        run: what was decided.
        sections: the paper in its order, with the same outcomes.
        certified: the digests of the certificates that the checker accepts, by claim.
        programs: which programs confirm which certificates.
        evidence: where the certificates are, as an address.
        command: by which it is written, if it is no report on a derivation.
    """

    def __init__(
        self,
        run: Run,
        sections: Sequence[PaperSection],
        certified: Mapping[str, str] = MappingProxyType({}),
        programs: Sequence[Witness] = (),
        evidence: str = "",
        command: str = "",
    ) -> None:
        self.command = command or f"kowalevski-cas report {run.derivation}"
        self.run, self.sections, self.certified, self.programs = (
            run,
            sections,
            certified,
            programs,
        )
        files = {claim: f"{evidence}/{claim}.json" for claim in certified} if evidence else {}
        self.phrases = Phrases(
            run.vocabulary, names(sections), labels(sections), files, displays(sections)
        )
        copied = any(section.copied for section in sections)
        self.findings = Findings(self.phrases, run.outcomes, copied, run.expected)
        self.passages = Passages(self.findings, certified, programs)

    def document(self, figures: Sequence[FigureFile] = ()) -> Document:
        """The report, with the pictures of the derivation."""
        run = self.run
        blocks = [
            *self.verdict(),
            *(block for section in self.sections for block in self.passages.section(section)),
            *trust(self.phrases),
            *graph(self.findings),
            *self._figures(figures),
        ]
        title = print_prose(read_prose(run.title, run.vocabulary), str, to_plain)
        origin = ", ".join(filter(None, (run.author, run.source)))
        return Document(
            self._title(title),
            self._title(shorten(title, 60, placeholder=" …")),
            ((*self.phrases.words(origin), "."), *self._read(), *self._origins()),
            tuple(blocks),
        )

    def erratum(self) -> Document | None:
        """What author and journal would print: the misprints and what is false, and why.

        Nothing, if there is nothing, or if no author has printed the formulas.
        """
        blocks, run = tuple(erratum(self.findings)), self.run
        if not blocks or not self.findings.copied or not run.author:
            return None
        title = print_prose(read_prose(run.title, run.vocabulary), str, to_plain)
        origin = ", ".join(filter(None, (run.author, run.source)))
        return Document(
            f"Erratum to “{title}”",
            f"Erratum to “{shorten(title, 60, placeholder=' …')}”",
            ((*self.phrases.words(origin), "."), *self._read()),
            blocks,
        )

    def _read(self) -> list[Text]:
        """Which text was read."""
        edition = self.run.edition
        return [(*self.phrases.words(f"Text read: {edition}"), ".")] if edition else []

    def _title(self, title: str) -> str:
        """What the report is of a paper with this title: only what is printed can be verified."""
        if any(section.copied for section in self.sections) or not self.sections:
            return f"Verification report on “{title}”"
        if any(section.copied is False for section in self.sections):
            return f"Results of “{title}”, derived anew"
        return title

    def _origins(self) -> Iterator[Text]:
        """Of which formulas nobody can say that they are those of a print."""
        for copied, words in _ORIGINS.items():
            found = [section.number for section in self.sections if section.copied is copied]
            if found:
                every = len(found) == len(self.sections)
                which = "All formulas" if every else f"The formulas of section {', '.join(found)}"
                yield (f"{which} are {words}.",)

    # -- the verdict ------------------------------------------------------------------

    def verdict(self) -> Iterator[Block]:
        """What is wrong, what holds, and who says so."""
        run, findings = self.run, self.findings
        results = [*main_results(findings, run.main)]
        if results:
            yield from (*results, *wrong_places(findings))
        yield Paragraph((tally(findings),), "" if results else "lead")
        if not findings.copied:
            yield from self._granted()
        if findings.copied:
            yield Paragraph((_JUDGED,), "note")
        yield from self._legend()
        yield from self.findings.blocks()
        yield Heading(("How the statements were checked",), "holds", 2)
        yield Paragraph(self._confirmations())
        yield Paragraph(
            (
                *written_by(self.command),
                "; digest of the statements ", Code(run.digest[:16]), ".",
            ),
            "note",
        )  # fmt: skip
        if sum(bool(section.outcomes) for section in self.sections) > 1:
            yield self._signs()

    def _signs(self) -> Table:
        """The signs of all statements, section by section."""
        rows = []
        for section in (section for section in self.sections if section.outcomes):
            links = (
                Link(f"claim.{anchor(o.claim)}", (Sign(shown_as(o)),)) for o in section.outcomes
            )
            signs = tuple(part for link in links for part in (" ", link))[1:]
            link = Link(f"section.{anchor(section.number)}", self.phrases.title(section))
            rows.append(((link,), signs))
        return Table((0.36, 0.6), (("Section",), ("Its formulas and statements",)), tuple(rows))

    def _granted(self) -> Iterator[Block]:
        """What the sections assume not to vanish, those of one assumption together."""
        assumed = [
            (section.number, tuple(dict.fromkeys(f for o in section.outcomes for f in o.granted)))
            for section in self.sections
        ]
        said: Text = ()
        for numbers, (formulas, *_) in group_alike([pair for pair in assumed if pair[1]]):
            where = ", ".join(numbers)
            said += (
                *("; " if said else "We assume ",),
                *supposed(formulas),
                f" in section{'s' * (len(numbers) > 1)} {where}",
            )
        if said:
            yield Paragraph((*said, "."), "note")

    def _legend(self) -> Iterator[Block]:
        """What the marks mean, and “valid for”."""
        outcomes = self.run.outcomes
        corrections = [o.correction for o in outcomes if o.correction]
        used = {*map(shown_as, outcomes), *(c.verdict for c in corrections)}
        used |= {Verdict.REFUTED} if any(c.blamed for c in corrections) else set()
        present = [shown for shown in MARKS if shown in used]
        means = list_in_words([(Sign(shown), f" {MARKS[shown].meaning}") for shown in present])
        divided = [c.expression for o in outcomes for c in o.conditions if not c.witness]
        valid: Text = ()
        if divided:
            valid = (
                " “Valid for ", nonzero(divided[0]), "” means that the formula, or a definition "
                "or equation that it uses, has this denominator: it is proved wherever this does "
                "not vanish, and elsewhere nothing is proved here.",
            )  # fmt: skip
        if self.findings.missing:
            valid = (*valid, _WITHOUT, _SINGULAR if self.findings.singular else "", ".")
        names = self.phrases.names.values()
        ours = next((name.number for name in names if not name.number.startswith("(")), "")
        if ours and any(name.number.startswith("(") for name in names):
            valid = (*valid, f" A number such as {ours} is this report's, (1) is the paper's.")
        if valid or present != [Verdict.PROVED]:
            yield Paragraph((*means, ".", *valid), "note")

    def _confirmations(self) -> Text:
        run = self.run
        deciding = arithmetics(run.outcomes)
        programs = list_in_words([(witness.name,) for witness in deciding])
        each = ", each by itself" if len(deciding) > 1 else ""
        text: Text = (
            *programs,
            f" decided every statement{each}: as an identity of polynomials, or by a point "
            "with exact coordinates. Floating-point numbers are not used.",
        )
        if self.certified:
            known = sum(outcome.claim in self.certified for outcome in run.outcomes)
            many = f"{known} of {len(run.outcomes)} have certificates"
            if known == len(run.outcomes):
                many = "Each statement has a certificate"
            text = (
                *text, f" {many}, accepted by a checker that shares no line of code with the "
                "program: ", Code(f"kowalevski-cas check {run.derivation}"), " runs it. "
                "What is too long to be shown here is in the certificates.",
            )  # fmt: skip
        if self.programs:
            named = list_in_words([(f"{w.name} confirms {len(w.claims)}",) for w in self.programs])
            text = (*text, " Of these certificates, ", *named, ".")
        if not run.versions:  # an audit, which leaves no table
            return text
        table = Link(f"{run.derivation}.json", (f"{run.derivation}.json",), outside=True)
        which = (
            "Which program confirms which statement"
            if self.programs
            else "Which arithmetic decided which statement"
        )
        return (*text, f" {which}, with all digests, is in ", table, ".")

    # -- the rest ---------------------------------------------------------------------

    def _figures(self, figures: Sequence[FigureFile]) -> Iterator[Block]:
        if figures:
            yield Heading(("Pictures",), "section.pictures")
        for figure in figures:
            yield Figure(figure, self.phrases.words(figure.caption))


_JUDGED: Final = (
    "Only formulas and the statements below were judged: no other sentence, and no picture."
)

_WITHOUT: Final = " Without a missing hypothesis the statement fails at the point that is given"

_SINGULAR: Final = (
    "; of a manifold, what fails there is that the differentials of its equations are independent, "
    "by which it is proved, and whether it is one all the same is not said"
)

_ORIGINS: Final = {
    False: "restated, or derived anew: nobody has compared them with a print",
    None: "those of this derivation: there is no print of them",
}
