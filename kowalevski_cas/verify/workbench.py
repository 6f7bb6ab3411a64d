"""Where statements are decided: the texts of a derivation, what they mean, and the arithmetics."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from kowalevski_cas.algebra import POINTS, load, load_points
from kowalevski_cas.notation import Formula, to_plain
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.generators import decides
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.examine import Accepted, Unproved, Vacuous
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.confirm import Disagreement
from kowalevski_cas.verify.outcome import Outcome, Screened, Verdict
from kowalevski_cas.verify.statement import Statement, Verdicts

if TYPE_CHECKING:
    from kowalevski_cas.problem.sampled import Sampled

Result = TypeVar("Result")


class Decided(NamedTuple):
    """A statement with its evidence, and what an arithmetic accepted of it."""

    statement: Statement
    verdicts: Verdicts | None
    accepted: Accepted
    verdict: Verdict
    message: str = ""


class Workbench:
    """Texts, the settings of scenes, and their evaluations, each made once.

    Args:
        derivation: whose claims are decided.
        arithmetics: in which, one after the other.
        explain: whether outcomes tell their steps.
        certificates: save the searches whose results they hold.
        timeout: in seconds, for each claim.
        texts: are read instead of what the derivation prints, or are what it prints.
        seed: chooses the points of the arithmetics that only screen.
        record: says which corrections are tried first.
    """

    def __init__(
        self,
        derivation: Derivation,
        arithmetics: Sequence[str],
        explain: bool = False,
        certificates: Mapping[str, Stored] | None = None,
        timeout: float | None = None,
        texts: Texts | None = None,
        seed: int = 1,
        record: Mapping[str, Mapping[str, object]] | None = None,
    ) -> None:
        self.derivation = derivation
        self.arithmetics = arithmetics
        self.explain = explain
        self.timeout = timeout
        self.stored = dict(certificates or {})
        self.rejected: dict[str, str] = {}
        """What is told of stored evidence that is not used, by the names of certificates."""
        self.record = record or {}
        self.points = {name: load_points(name, seed) for name in arithmetics if name in POINTS}
        self.texts = texts or derivation.texts()
        self.elaborations = Elaborations(self.texts)
        self.evaluations: dict[tuple[str, Setting], Evaluation] = {}
        self.stages: dict[Setting, Sampled] = {}
        self.order = {claim.id: k for k, claim in enumerate(derivation.claims)}
        self.established = derivation.established
        self.accepted = self._accepted()
        self.bases = {base.name: base for base in derivation.bases()}
        self.read_elsewhere: dict[Printed, str] = {}
        """What is read as another derivation accepts it, by the claims there."""
        for name, base in self.bases.items():
            known = base.established
            for place in base.accepted:
                self.read_elsewhere[place] = f"{name}/{known.get(place, place.place)}"
        self.checks = True
        """Whether certificates are checked here; else whoever receives them has that done."""
        self.found: dict[str, Outcome] = {}
        """What is said about the claims that are decided."""

    def _accepted(self) -> dict[Printed, Formula]:
        """What the derivation accepts in place of what is printed."""
        return {
            place: self.texts.expression(tex) for place, tex in self.derivation.accepted.items()
        }

    def on(self, claim: Claim, texts: Texts | None = None) -> Elaborations:
        """The texts for a claim, of the run or others: with the accepted corrections.

        Those that it is about itself are left out.
        """
        own = set(claim.about())
        read = {place: f for place, f in self.accepted.items() if place not in own}
        texts = texts or self.texts
        return self.elaborations.under(texts.reading(read) if read else texts)

    def _evidence(self, statement: Statement, name: str) -> Verdicts | None:
        """The evidence that is stored for a statement, or that a search finds."""
        stored = self.stored.get(name)
        verdicts = None if stored is None else stored.verdicts(statement)
        if verdicts is not None:
            return verdicts
        return statement.search()

    def anew(self, statement: Statement, name: str, work: Callable[[], Result]) -> Result:
        """What comes of stored evidence; if that is rejected, which is told, of what is found."""
        try:
            return work()
        except (FormatError, Unproved, Disagreement) as error:
            stored = self.stored.get(name)
            if stored is None or not stored.concerns(statement):
                raise
            self.rejected[name] = f"{stored.path} is rejected: {error}; it is searched anew"
            del self.stored[name]
            return work()

    def _decide(
        self, statement: Statement, verdicts: Verdicts | None, arithmetic: str
    ) -> Decided | Screened:
        points = self.points.get(arithmetic)
        if points is not None:
            from kowalevski_cas.verify.screen import screen  # proving needs no points

            return screen(statement, verdicts, points, self.stages)
        return self._judged(statement, verdicts, arithmetic)

    def _judged(self, statement: Statement, verdicts: Verdicts | None, arithmetic: str) -> Decided:
        judge = Judge(self.evaluations_in(arithmetic))
        if verdicts is None:
            message = "neither a proof nor a point where it fails was found"
            return Decided(statement, None, judge.accepted, Verdict.UNDECIDED, message)
        try:
            if isinstance(verdicts, Denial):
                judge.denies(statement.goals[verdicts.goal], verdicts.evidence)
                denied = statement.claimed[verdicts.goal]
                if not (statement.claim.refuted_by(verdicts) and decides(denied)):
                    message = "what would prove it is false, which does not refute it"
                    return Decided(statement, None, judge.accepted, Verdict.UNDECIDED, message)
                return Decided(statement, verdicts, judge.accepted, Verdict.REFUTED)
            for goal, evidence in zip(statement.goals, verdicts, strict=True):
                judge.holds(goal, evidence)
        except Vacuous as error:
            from kowalevski_cas.verify.conditions import excluding  # what is decided needs none

            divided = ", ".join(map(to_plain, excluding(statement.goals, statement.legend)))
            nowhere = f"the motion is divided by {divided}, which vanishes on the whole set"
            message = nowhere if divided else str(error)
            return Decided(statement, None, judge.accepted, Verdict.UNDECIDED, message)
        except Unproved as error:
            message = f"the evidence does not prove it ({arithmetic}: {error})"
            raise Unproved(message) from None
        return Decided(statement, verdicts, judge.accepted, Verdict.PROVED)

    def evaluations_in(self, arithmetic: str) -> Callable[[Setting], Evaluation]:
        """The evaluations of settings in an arithmetic, each made once."""

        def of(setting: Setting) -> Evaluation:
            if arithmetic == "flint":
                return finder_of(setting)
            key = (arithmetic, setting)
            if key not in self.evaluations:
                made = Evaluation(setting, load(arithmetic), others=of)
                self.evaluations[key] = made.adjoin_roots()
            return self.evaluations[key]

        return of
