"""Claims are decided as soon as they are read: of a long paper something is heard soon."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.confirm import receive
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.run import Session


class FirstReferee:
    """Decides claims as they are read, and tells at once which fail, with their lines.

    Why they fail, and whether they were meant otherwise, is known when all is read. The arguments
    are those of the run that follows, which takes over what is decided.
    """

    def __init__(
        self,
        told: Callable[[int], None],
        arithmetics: Sequence[str] = ("flint",),
        explain: bool = False,
        timeout: float | None = None,
        certificates: Mapping[str, Stored] | None = None,
    ) -> None:
        self._told, self._timeout = told, timeout
        self._settings = arithmetics, explain, certificates, timeout

    def begin(self, interpretation: Interpretation) -> Callable[[Claim], Outcome]:
        """What decides a claim, with the scenes as far as they were elaborated to choose it."""
        derivation, texts = interpretation.derivation, interpretation.texts
        session = Session(derivation, *self._settings, texts).under(interpretation)
        session.decider.arithmetics.load()
        return session.outcome

    def receive(self, item: SourceStatement, outcome: Outcome) -> Outcome:
        """The outcome for the claim of a statement, once the checker accepts it here."""
        found = receive(outcome, self._timeout)
        if found.verdict is Verdict.REFUTED:
            self._told(item.span[0])
        return found
