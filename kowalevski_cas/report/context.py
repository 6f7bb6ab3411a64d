"""What a report says, before anything is said about how it looks.

A writer of any format renders a :class:`Report`. Formulas are trees, which each format prints
in its own way; words are plain, with mathematics between dollars.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from kowalevski_cas import __version__
from kowalevski_cas.report.alike import alike
from kowalevski_cas.report.graph import Picture, picture
from kowalevski_cas.report.sections import Section, count, sections
from kowalevski_cas.report.sentences import opening
from kowalevski_cas.report.witnesses import Witness, arithmetics
from kowalevski_cas.verify.outcome import Condition, Outcome, Run, Verdict

_ALWAYS: Final = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)


@dataclass(frozen=True)
class Proviso:
    """A condition that the paper does not state, and the claims that need it."""

    condition: Condition
    ids: tuple[str, ...]


@dataclass(frozen=True)
class Report:
    """Everything a template needs; ``certified`` has the digests of accepted certificates."""

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
    certified: Mapping[str, str]
    arithmetics: tuple[Witness, ...]
    programs: tuple[Witness, ...]

    @property
    def witnesses(self) -> tuple[Witness, ...]:
        """All who confirm claims; the checker is one of them if there are certificates."""
        checker = Witness("checker", "", frozenset(self.certified))
        own = (checker,) if checker.claims else ()
        return (*self.arithmetics, *own, *self.programs)


def report(
    run: Run, certified: Mapping[str, str] | None = None, programs: tuple[Witness, ...] = ()
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
        certified=certified or {},
        arithmetics=arithmetics(run.outcomes),
        programs=programs,
    )


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
