"""The certificates that are committed with a derivation: checked, and compared with what it prints.

Nothing in a certificate or in the record is believed to say what the paper prints: the problem of
each claim is written anew from the printed formulas, unless a run has just done so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType

from kowalevski_cas.files import read
from kowalevski_cas.limits import tell
from kowalevski_cas.notation import NotationError, print_prose, read_prose, to_plain
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.corrections import formulas_printed_by, recorded_correction
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.loci import goals_where_violated
from kowalevski_cas.verify.outcome import CORRECTED, Run, Verdict
from kowalevski_cas.verify.statement import Statement

Record = Mapping[str, Mapping[str, object]]


@dataclass(frozen=True)
class Checked:
    """What the checker says about certificates.

    ``accepted`` has what it accepts by claim, corrections after a slash; ``rejected`` says why
    for the others, by file; ``without`` lists the recorded claims that have none. They are those of
    a ``derivation``; each is ``said`` as it has them, with the recorded verdict.
    """

    accepted: dict[str, checker.Certificate] = field(default_factory=dict)
    rejected: dict[str, str] = field(default_factory=dict)
    without: tuple[str, ...] = ()
    derivation: str = ""
    said: dict[str, tuple[Verdict, str]] = field(default_factory=dict)

    @property
    def total(self) -> int:
        """The number of certificates that were checked."""
        return len(self.accepted) + len(self.rejected)

    @property
    def digests(self) -> dict[str, str]:
        """The digests of the problems that are proved, or denied."""
        return {name: certificate.digest for name, certificate in self.accepted.items()}


def certificate_files(folder: Path) -> list[Path]:
    """The certificates in the folder of a derivation, by name, with those of corrections."""
    return sorted((folder / FOLDER).glob("*.json")) + sorted(
        (folder / FOLDER / CORRECTED).glob("*.json")
    )


def check_committed(
    folder: Path,
    derivation: Derivation,
    record: Record,
    decided: Mapping[str, str] = MappingProxyType({}),
) -> Checked:
    """Check the certificates in the folder of a derivation, in the order of the record.

    ``decided`` are the :func:`statements` that a run has just written from the print.

    A certificate is rejected if it is about something else than the derivation prints, or the
    record has another statement of the claim, or another sign; so is one that the record asks for
    and that is missing.
    """
    places = {claim: place for place, claim in enumerate(record)}
    files = sorted(certificate_files(folder), key=lambda path: places.get(path.stem, len(places)))
    found = check_files(files, Expected(derivation, record, decided))
    for name in certificates_of(record):
        if not (folder / FOLDER / f"{name}.json").is_file():
            found.rejected[f"{name}.json"] = "it is in the record, and missing"
    without = tuple(claim for claim in record if claim not in certificates_of(record))
    return replace(found, without=without)


def statements(run: Run) -> dict[str, str]:
    """The digests of what a run has decided, by the name of the certificate."""
    digests = {outcome.claim: outcome.digest for outcome in run.outcomes}
    mended = ((outcome.claim, outcome.correction) for outcome in run.outcomes)
    return digests | {
        f"{CORRECTED}/{claim}": statement.digest
        for claim, statement in mended
        if statement is not None
    }


def certificates_of(record: Record) -> list[str]:
    """The names of the certificates that a record asks for."""
    verdicts = ("proved", "conditional", "refuted")
    decided = [claim for claim, entry in record.items() if entry.get("verdict") in verdicts]
    return decided + [f"{CORRECTED}/{c}" for c in decided if record[c].get("correction")]


def check_files(paths: Sequence[Path], about: Expected | None = None) -> Checked:
    """Check certificates; those of a derivation have to be about what is expected."""
    found = Checked(derivation=about.derivation.name if about is not None else "")
    for done, path in enumerate(paths):
        tell(path.stem, done, len(paths))
        corrected = path.parent.name == CORRECTED
        try:
            certificate = checker.check(read(path))
            claim = certificate.claim
            name = f"{CORRECTED}/{claim}" if corrected else claim
            checker.need(path.name == f"{claim}.json", f"it is about the claim {claim}")
            checker.need(name not in found.accepted, "the claim was certified before")
            if about is not None:
                about.compare(name, certificate, corrected)
        except (OSError, ValueError, checker.Rejected) as error:
            said = str(getattr(error, "strerror", None) or error)
            found.rejected[str(path)] = checker.printable(said) or type(error).__name__
            continue
        found.accepted[name] = certificate
        if about is not None and not about.decided:  # a run has words of its own
            divides = any(theorem.divisors for theorem in certificate.theorems)
            mended = Verdict.CONDITIONAL if divides else Verdict.PROVED
            verdict = mended if corrected else Verdict(str(about.record[claim]["verdict"]))
            found.said[name] = verdict, about.said(claim, corrected)
    return found


def equation_numbers(derivation: Derivation) -> dict[str, str]:
    """The claims about what has a number in the paper, each by this number; one by each."""
    found: dict[str, str] = {}
    for claim in derivation.claims:
        printed = claim.printed
        displays = {place.display for place in ([printed] if printed else claim.establishes())}
        label = displays.pop().label if len(displays) == 1 else ""
        if printed and len([*printed.display]) > 1:
            label = f"formula {printed.number} of {label}" if label else ""
        if label:
            found.setdefault(label, claim.id)
    return {claim: number for number, claim in found.items()}


@dataclass(frozen=True)
class Expected:
    """What certificates have to be about: the record, and the statements that are printed.

    ``decided`` are the :func:`statements` that a run has just written from the print; the others
    are written anew.
    """

    derivation: Derivation
    record: Record
    decided: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def interpretation(self) -> Interpretation:
        """What is printed."""
        return Interpretation(self.derivation)

    @cached_property
    def numbers(self) -> dict[str, str]:
        """The numbers of equations, by the claims about them."""
        return equation_numbers(self.derivation)

    def said(self, id: str, corrected: bool) -> str:
        """What is printed of a claim, or its recorded correction: in words and plain formulas."""
        claim, texts = self._claim(id), self.interpretation.texts
        assert claim is not None
        number = self.numbers.get(id, id)
        words, formulas = claim.words, claim.formulas(texts)
        if corrected:
            near = self._correction(claim, self.interpretation.on(claim))
            assert near is not None  # or its certificate was not accepted
            number, words = f"{number}, corrected", "" if near[0].edit else near[0].words
            formulas = formulas_printed_by(near[0]) if near[0].edit else ()
        shown = ", ".join(map(to_plain, formulas))
        told = print_prose(read_prose(words, texts.vocabulary), str, to_plain)
        return f"{number}: {': '.join(filter(None, (told, shown)))}"

    def compare(self, name: str, certificate: checker.Certificate, corrected: bool) -> None:
        """Reject a certificate that is about something else."""
        entry = self.record.get(certificate.claim)
        checker.need(entry, "the record has no such claim")
        assert entry is not None
        stale = "`make record` and `make certificates` write both anew"
        if corrected:
            checker.need(entry.get("correction"), f"the record has no correction of it; {stale}")
            checker.need(certificate.sign == "holds", "a correction has to hold")
        else:
            same = entry.get("statement") == certificate.digest
            checker.need(same, f"the record has another statement of it; {stale}")
            sign = "denied" if entry.get("verdict") == "refuted" else "holds"
            checker.need(certificate.sign == sign, f"the record has another verdict on it; {stale}")
        if self.decided.get(name) == certificate.digest and not certificate.failures:
            return
        statement = self.printed(certificate.claim, corrected)
        same = statement is not None and statement.digest == certificate.digest
        checker.need(same, f"the derivation prints another statement of it; {stale}")
        assert statement is not None
        expected = [*goals_where_violated(statement)] if certificate.failures else []
        about = [(failure.condition, failure.digest) for failure in certificate.failures]
        checker.need(
            all(failure in expected for failure in about),
            f"what fails for a condition is something else; {stale}",
        )

    def printed(self, id: str, corrected: bool) -> Statement | None:
        """What is printed of a claim, or its recorded correction; ``None`` if it says nothing."""
        claim = self._claim(id)
        if claim is None:
            return None
        with suppress(NotationError, Meaningless):  # what says nothing has no certificate
            on = self.interpretation.on(claim)
            if not corrected:
                return Statement(claim, on)
            near = self._correction(claim, on)
            return None if near is None else near[1]
        return None

    def _claim(self, id: str) -> Claim | None:
        return next((claim for claim in self.derivation.claims if claim.id == id), None)

    def _correction(self, claim: Claim, on: Elaborations) -> tuple[Neighbour, Statement] | None:
        """The recorded correction of a claim, and what it says."""
        entry = self.record[claim.id]
        elsewhere = str(entry.get("mended", ""))
        return recorded_correction(claim, on, str(entry.get("correction")), elsewhere)
