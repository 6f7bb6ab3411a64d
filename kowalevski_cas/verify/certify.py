"""The certificate of what FLINT accepts, which the checker has to accept as well."""

from __future__ import annotations

from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.verify.arithmetics import Decided
from kowalevski_cas.verify.certificate import Stored, Supported, certificate
from kowalevski_cas.verify.confirm import Disagreement, confirm
from kowalevski_cas.verify.necessary import conditions
from kowalevski_cas.verify.outcome import DECIDED, Condition


def certify(decided: Decided, stored: Stored | None) -> tuple[tuple[Condition, ...], str]:
    """The conditions of what FLINT accepts, and the text of a certificate.

    ``stored`` is the one that is known, in which witnesses of the conditions may stand.

    Raises :class:`Disagreement` if the checker rejects the text, or has other conditions.
    """
    statement, verdicts, accepted = decided.statement, decided.verdicts, decided.accepted
    if verdicts is None or decided.verdict not in DECIDED:
        raise Disagreement(f"the arithmetics disagree (flint: {decided.verdict})")
    needed: tuple[Condition, ...] = ()
    failing: dict[Formula, Supported | None] = {}
    if not isinstance(verdicts, Denial):
        needed, failing = conditions(statement, accepted, stored)
    text = certificate(statement, verdicts, accepted, failing)
    confirm(statement, verdicts, accepted, text)
    return needed, text
