"""What a report says, before anything is said about how it looks.

A template of any format (LaTeX, and whatever comes later) renders a :class:`Report`. Texts are
plain, with mathematics between dollars; formulas are TeX as they came from the run.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from kowalevski_cas import __version__
from kowalevski_cas.dataclass import dataclass
from kowalevski_cas.proof.outcome import Condition, Outcome, Run, Verdict
from kowalevski_cas.report.alike import alike
from kowalevski_cas.report.graph import Picture, picture
from kowalevski_cas.report.sections import Section, count, sections
from kowalevski_cas.report.sentences import opening

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


def report(run: Run) -> Report:
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
        for ids, ones in alike(needed, lambda one: (one.tex, one.words))
    )
