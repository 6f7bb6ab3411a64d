"""The certificate of what FLINT accepts, which the checker has to accept as well.

Here, or where the outcome is received: once.
"""

from __future__ import annotations

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.verify.arithmetics import Decided
from kowalevski_cas.verify.certificate import Stored, Supported, certificate
from kowalevski_cas.verify.confirm import (
    Disagreement,
    Issued,
    confirm,
    divisors_by_goal,
    is_received,
)
from kowalevski_cas.verify.necessary import conditions
from kowalevski_cas.verify.outcome import DECIDED, Condition, Divided


def certify(decided: Decided, stored: Stored | None) -> tuple[tuple[Condition, ...], str, Divided]:
    """The conditions of what FLINT accepts, the text of a certificate, and what FLINT divides by.

    ``stored`` is the one that is known, in which witnesses of the conditions may stand.

    Raises :class:`Disagreement` if the checker rejects the text, or has other conditions.
    """
    statement, verdicts, accepted = decided.statement, decided.verdicts, decided.accepted
    if verdicts is None or decided.verdict not in DECIDED:
        raise Disagreement(f"the arithmetics disagree (flint: {decided.verdict})")
    needed: tuple[Condition, ...] = ()
    divided: Divided = ()
    failing: dict[Formula, Supported | None] = {}
    if not isinstance(verdicts, Denial):
        needed, failing = conditions(statement, accepted, stored)
        divided = divisors_by_goal(accepted)
    text = certificate(statement, verdicts, accepted, failing)
    if not is_received():
        sign = "denied" if isinstance(verdicts, Denial) else "holds"
        confirm(Issued(statement.claim.id, statement.digest, sign, text, divided), statement.goals)
    return needed, text, divided
