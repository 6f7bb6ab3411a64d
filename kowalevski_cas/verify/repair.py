"""The corrections of what a run has refuted: what claims share first, then one by one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from math import inf
from typing import Any

from kowalevski_cas.limits import tell, time_limit
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import edited_formulas
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.decider import PROVING, Decider
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.suspects import Repairs

Work = Callable[[Callable[[Any], Any], Sequence[Any], Callable[[Any], Any]], Iterable[Any]]
"""How something is done for each of several items: here, or in processes of their own.

What is given last says what comes of an item when the run ends before that is done.
"""


def blame_of(decider: Decider, outcomes: Sequence[Outcome]) -> Blame:
    """The search for what makes claims fail, of which these are the outcomes so far."""
    verdicts = {outcome.claim: outcome.verdict for outcome in outcomes}
    needs = decider.corrector.needs_search
    explained = [o.claim for o in outcomes if o.verdict is Verdict.REFUTED and not needs(o)]
    seconds = decider.patience or (decider.timeout or inf) / 2
    return Blame(decider.corrector, verdicts, explained, seconds)


def repair(
    decider: Decider, outcomes: Sequence[Outcome], work: Work, blame: Blame
) -> list[Outcome]:
    """The outcomes with the corrections that are found in time."""
    found = {outcome.claim: outcome for outcome in outcomes}
    if failing := blame.open():
        clusters = blame.clusters()

        def together(place: int) -> Repairs:
            return _common_repair(blame, clusters[place], decider)

        shared: Repairs = {}
        for repairs in work(together, range(len(clusters)), lambda _: {}):
            shared |= repairs
        for id, corrections in shared.items():
            found[id] = found[id].corrected_by(corrections)
        waiting = _waiting(blame, failing, shared)
        left = [claim for claim in failing if claim.id not in {*shared, *waiting}]

        def alone(place: int) -> Outcome:
            claim = left[place]
            tell(claim.id)
            try:
                with time_limit(inf):
                    return decider.correct(claim, found[claim.id], lambda: blame.alone(claim))
            except TimeoutError:  # the run is over: the verdict stays as it is
                return found[claim.id]
            except (Exception, SystemExit) as error:
                return decider.error_outcome(claim, error)

        for outcome in work(alone, range(len(left)), lambda place: found[left[place].id]):
            found[outcome.claim] = outcome
    return [*found.values()]


def _waiting(blame: Blame, failing: Sequence[Claim], shared: Repairs) -> set[str]:
    """The claims that are decided again with what is mended for others, on which they stand."""
    if not blame.decides_again:
        return set()
    repairs = [(first.printed, first.edit) for first, *_ in shared.values() if first.blamed]
    mended = {p for place, edit in repairs if place and edit for p in edited_formulas(place, edit)}
    statement = blame.corrector.interpretation.statement
    return {claim.id for claim in failing if mended & {*statement(claim).stands_on}}


def _common_repair(blame: Blame, cluster: Sequence[Claim], decider: Decider) -> Repairs:
    """What mends several claims, if it is found in the time in which it is to be proved as well."""
    patience = decider.patience
    longest = decider.timeout if patience is None else PROVING * patience
    # the outer limit never comes: it is there for a process that dies, as in each claim
    with suppress(Exception), time_limit(inf), time_limit(longest):
        return blame.shared(cluster)
    return {}  # what goes wrong with one of the claims is told where it is by itself
