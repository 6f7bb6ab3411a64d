"""What a report says, before anything is said about how it looks.

A writer of any format renders a :class:`Report`. Formulas are trees, which each format prints
in its own way; words are plain, with mathematics between dollars.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from kowalevski_cas import __version__
from kowalevski_cas.report.alike import alike
from kowalevski_cas.report.graph import Picture, picture
from kowalevski_cas.report.sections import Section, count, sections
from kowalevski_cas.report.sentences import opening
from kowalevski_cas.report.witnesses import Certified, Witness, arithmetics
from kowalevski_cas.verify.outcome import Condition, Outcome, Run, Verdict

_ALWAYS: Final = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)


@dataclass(frozen=True)
class Proviso:
    """A condition that the paper does not state, and the claims that need it."""

    condition: Condition
    ids: tuple[str, ...]


@dataclass(frozen=True)
class Report:
    """Everything a template needs."""

    run: Run
    version: str
    verdict: tuple[str, str]
    verdicts: tuple[Verdict, ...]
    sections: tuple[Section, ...]
    counts: dict[Verdict, int]
    errata: tuple[Outcome, ...]
    provisos: tuple[Proviso, ...]
    picture: Picture
    products: int
    by_verdict: dict[Verdict, tuple[str, ...]]
    certified: Certified
    arithmetics: tuple[Witness, ...]
    programs: tuple[Witness, ...]
    words: tuple[tuple[str, tuple[str, ...]], ...]

    @property
    def witnesses(self) -> tuple[Witness, ...]:
        """All who confirm claims; the checker is one of them if there are certificates."""
        checker = Witness("checker", "", frozenset(self.certified.digests))
        own = (checker,) if checker.claims else ()
        return (*self.arithmetics, *own, *self.programs)


def report(
    run: Run, certified: Certified | None = None, programs: tuple[Witness, ...] = ()
) -> Report:
    """Arrange a run for its readers."""
    present = {outcome.verdict for outcome in run.outcomes}
    return Report(
        run=run,
        version=__version__,
        verdict=opening(run),
        verdicts=tuple(v for v in Verdict if v in _ALWAYS or v in present),
        sections=sections(run),
        counts=count(run.outcomes),
        errata=tuple(
            o for o in run.outcomes if o.verdict is Verdict.REFUTED or o.correction is not None
        ),
        provisos=_provisos(run.outcomes),
        picture=picture(run.outcomes),
        products=sum(outcome.products for outcome in run.outcomes),
        by_verdict={
            verdict: tuple(o.claim for o in run.outcomes if o.verdict is verdict)
            for verdict in Verdict
        },
        certified=certified or Certified(),
        arithmetics=arithmetics(run.outcomes),
        programs=programs,
        words=_words(certified or Certified()),
    )


def _words(certified: Certified) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """What certificates leave to an argument in words, with the claims that rest on it."""
    found: dict[str, list[str]] = {}
    for claim, notes in certified.notes.items():
        for note in notes:
            found.setdefault(note, []).append(claim)
    return tuple((note, tuple(claims)) for note, claims in found.items())


def _provisos(outcomes: Sequence[Outcome]) -> tuple[Proviso, ...]:
    """Each condition once, with a point at which it fails if any claim names one."""
    needed = [
        (outcome.claim, condition)
        for outcome in outcomes
        if outcome.verdict is Verdict.CONDITIONAL
        for condition in outcome.conditions
    ]
    return tuple(
        Proviso(next((one for one in ones if one.witness), ones[0]), ids)
        for ids, ones in alike(needed, lambda one: (one.expression, one.words))
    )
