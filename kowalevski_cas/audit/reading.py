"""The audit of a source that is its own derivation.

What fails is refuted only where the reading is sure; else it is undecided, since it may have been
read otherwise than it was meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from time import perf_counter

from kowalevski_cas.audit.assumed import claims_of_numbers
from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import GIVEN, OPEN, UNREADABLE, Audited
from kowalevski_cas.audit.author import AuthorSession
from kowalevski_cas.audit.causes import Causes
from kowalevski_cas.audit.describe import Describer
from kowalevski_cas.audit.doubted import (
    OF_A_PLACE,
    how_read,
    is_false_as_read,
    needs_words,
    point_at,
    repairs_of_doubted,
)
from kowalevski_cas.audit.followed import tell_steps
from kowalevski_cas.audit.places import Correspondence
from kowalevski_cas.audit.scaled import edits_by_scales, tell_scales
from kowalevski_cas.limits import time_limit
from kowalevski_cas.notation import (
    Edit,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Relation,
    edits,
    to_latex,
)
from kowalevski_cas.paper.claims import Claim, Period, RestPoint, RestPoints, Union
from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.paper.texts import Printed, Texts, edited_formulas
from kowalevski_cas.processes import each
from kowalevski_cas.reading import CLAIM, UNREAD, JudgedStatement, Reading
from kowalevski_cas.reading.besides import expressions, leads
from kowalevski_cas.reading.counted import shown_numbers
from kowalevski_cas.reading.doubts import is_of_a_place
from kowalevski_cas.reading.energies import OF_ENERGY
from kowalevski_cas.reading.kinematics import is_free
from kowalevski_cas.reading.known import MORE
from kowalevski_cas.reading.linear_parts import KIND, fewer_eigenvalues
from kowalevski_cas.reading.obey import SAID, SKIPPED
from kowalevski_cas.reading.small_oscillations import CHARACTERISTIC, FREQUENCY
from kowalevski_cas.reading.uncovered import (
    ALL_EIGENVALUES,
    OF_EXPRESSION,
    OF_LAW,
    SAYS_MORE,
    Uncovered,
    passage_at,
    sentences,
)
from kowalevski_cas.source.text import Region
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.counterexamples import CONSTANT
from kowalevski_cas.verify.decider import Decider
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Correction, Outcome, Run, Verdict
from kowalevski_cas.verify.run import Progress, Session, correct_together, decide_together

PATIENCE = 15.0
"""Seconds for what claims share, and for each that is corrected by itself."""
NOT_JUDGED = "no kind of claim states it yet"
BESIDE_MISPRINT = "whether it holds with what the misprint should read was not decided in time"
NOT_ALL = "the points of these equations are states of rest, but there may be others"
BY_UNPROVED = "it holds with what another claim gives, which is not proved: ${}$"
BY_MISPRINT = "it holds with the misprint on which it rests, and not with what that should read"


class ReadingSession:
    """A run over a reading.

    What another formula explains has this formula for its cause, and is decided once more with it
    as it should read.
    """

    def __init__(
        self,
        reading: Reading,
        arithmetics: Sequence[str] = ("flint",),
        explain: bool = False,
        timeout: float | None = None,
        heard: Progress = lambda *_: None,
        certificates: Mapping[str, Stored] | None = None,
    ) -> None:
        self._session = Session(
            reading.derivation, arithmetics, explain, certificates, timeout, patience=PATIENCE
        )
        self._heard = heard
        self.reading = reading
        self.causes = Causes()
        self.repairs: dict[str, Correction] = {}
        """With what claims would hold that are false as they were read."""
        every = (*reading.formulas, *reading.statements)
        self.claiming = {f.claim.id: f for f in every if f.claim is not None}

    @property
    def decider(self) -> Decider:
        """What decides the claims."""
        return self._session.decider

    @property
    def interpretation(self) -> Interpretation:
        """What the claims say."""
        return self.decider.interpretation

    def stands(self, id: str) -> bool:
        """Whether the correction of a claim that its derivation accepts is proved."""
        return self._session.stands(id)

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim; processes share the work."""
        run = self._run(self._session, self.causes)
        found = {outcome.claim: self._blaming(outcome) for outcome in run.outcomes}
        self._mend(found)
        self._doubt(found, self.causes.mended())
        self._leave_exceptions(found)
        self._leave_unproved(found)
        self._leave_places(found)
        explained = {*self.causes.places, *self._searched, *self._told_in_words(found)}
        self.repairs = repairs_of_doubted(self._session, found, explained)
        self._doubt(found, self._shared_repairs())
        self._spare_constants(found)
        return {id: self._told(outcome) for id, outcome in found.items()}

    def _told_in_words(self, found: Mapping[str, Outcome]) -> Iterator[str]:
        """The claims that are false as they were read, and of which no formula is a slip.

        Words alone explain a letter of them, or list what is at rest.
        """
        for id, outcome in found.items():
            formula = self.claiming[id]
            known = self.reading.parts.of(formula.item)
            if isinstance(formula.claim, Union):
                yield id
            elif is_false_as_read(outcome) and needs_words(formula, known):
                yield id

    def _leave_exceptions(self, found: dict[str, Outcome]) -> None:
        """Take the verdict from lists of all states of rest, if some may be left out."""
        for claim in self.interpretation.derivation.claims:
            all_solutions = isinstance(claim, RestPoints) and claim.are_all
            if not (all_solutions or isinstance(claim, Union)):
                continue
            outcome = found[claim.id]
            left = [one.expression for one in outcome.conditions]
            moving = {*claim.scene.variables}
            if outcome.verdict.green and (others := [one for one in left if one.names() & moving]):
                where = " or ".join(f"${to_latex(one)}=0$" for one in others)
                found[claim.id] = outcome._replace(
                    verdict=Verdict.UNDECIDED, message=f"{NOT_ALL}, where {where}", certificate=""
                )

    def _leave_unproved(self, found: dict[str, Outcome]) -> None:
        """Take the verdict from what is true only with something that is not proved.

        That is an eigenvalue, or the linear equation of which a statement gives the frequency. What
        else is claimed is true of names that have their meaning without it.
        """
        proved = {
            place
            for claim in self.interpretation.derivation.claims
            if found[claim.id].verdict.green
            for place in (self.claiming[claim.id].item.printed, *claim.establishes())
        }
        unproved = {
            formula.item.printed: formula.role.kind
            for formula in self.reading.formulas
            if formula.role.name == CLAIM and formula.item.printed not in proved
        }
        values = {place for place, kind in unproved.items() if kind in (KIND, FREQUENCY)}
        for claim in self.interpretation.derivation.claims:
            formula = self.claiming[claim.id]
            cited = {formula.item.printed, *(one.printed for one in formula.on)}
            of = unproved.keys() if formula.role.kind in (FREQUENCY, CHARACTERISTIC) else values
            rests = sorted((claim.reads() & of) - cited, key=lambda one: one.tex)
            if found[claim.id].verdict.green and rests:
                found[claim.id] = found[claim.id]._replace(
                    verdict=Verdict.UNDECIDED, message=BY_UNPROVED.format(rests[0].tex),
                    certificate="",
                )  # fmt: skip

    def _leave_places(self, found: dict[str, Outcome]) -> None:
        """Call nothing false that may be said of one place, or of one time."""
        for id, outcome in found.items():
            item = self.claiming[id].item
            if is_false_as_read(outcome) and is_of_a_place(item, self.reading.parts.of(item)):
                found[id] = outcome._replace(message=OF_A_PLACE)

    def _spare_constants(self, found: dict[str, Outcome]) -> None:
        r"""Leave open what is constant by itself, where more is said than that it is constant.

        For some values of its indices only, as the integrals :math:`\operatorname{tr}L^k` of a
        matrix without a trace; or that it has the value of a constant that was known before.
        """
        green = {self._printed(id) for id, outcome in found.items() if outcome.verdict.green}
        for id, outcome in found.items():
            said = "for these values of indices" if self._printed(id) in green else ""
            said = said or ("a known value is printed, and" if self._has_known_value(id) else "")
            if outcome.message == CONSTANT and said:
                found[id] = outcome._replace(
                    verdict=Verdict.UNDECIDED, message=f"{said} {CONSTANT}",
                    certificate="", divided=(), correction=None, alternatives=(),
                )  # fmt: skip

    def _has_known_value(self, id: str) -> bool:
        """Whether the statement of a claim gives what moves a value by constants seen before."""
        item = self.claiming[id].item
        known = self.reading.parts.of(item)
        values = [one.names() for one in item.members if not known.varying(one.names())]
        seen = {name for name, first in known.seen.items() if first.order < item.order}
        return any(names and names <= seen for names in values)

    def _printed(self, id: str) -> tuple[int, tuple[int, int]]:
        """Where the statement is printed that makes a claim, for all values of its indices."""
        item = self.claiming[id].item
        return item.typed.start, item.span

    def _told(self, outcome: Outcome) -> Outcome:
        """An outcome as it is told: no error, and with the letters that were taken as free."""
        if outcome.verdict is Verdict.ERROR:
            return outcome._replace(verdict=Verdict.UNDECIDED)
        if is_false_as_read(outcome):
            formula = self.claiming[outcome.claim]
            return outcome._replace(message=how_read(formula, self.reading.parts.of(formula.item)))
        return outcome

    def _run(self, session: Session, causes: Causes, only: Sequence[str] = ()) -> Run:
        """The run of a session; what a wrong unit spoils is not corrected otherwise."""
        outcomes = self._decided(session, only)
        self._look_for_unit(session.interpretation, outcomes, causes)
        blame = self._blame(session, outcomes, causes)
        return session.result(correct_together(session, outcomes, blame))

    def _decided(self, session: Session, only: Sequence[str]) -> list[Outcome]:
        """The outcomes for claims; those of the paper as it is may be known since it was read."""
        known = self.reading.outcomes if session is self._session else {}
        claims = [claim.id for claim in session.chosen(only)]
        missing = [id for id in claims if id not in known]
        decided = decide_together([session], missing, self._heard)[0] if missing else []
        found = {**known, **{outcome.claim: outcome for outcome in decided}}
        return [found[id] for id in claims]

    def _blaming(self, outcome: Outcome) -> Outcome:
        """An outcome; what mends another formula makes that the cause, and corrects none of it."""
        if not self.causes.blame(outcome.claim, outcome.correction):
            return outcome
        return outcome._replace(correction=None, alternatives=())

    # -- the imaginary unit ------------------------------------------------------------

    def _look_for_unit(
        self, interpretation: Interpretation, outcomes: Sequence[Outcome], causes: Causes
    ) -> None:
        """Note the edit of a wrong unit as that of a misprint, if claims become true by it."""
        claims = {claim.id: claim for claim in interpretation.derivation.claims}
        for place, edit in self._units(interpretation.texts):
            failing = [
                claims[outcome.claim]
                for outcome in outcomes
                if outcome.verdict is Verdict.REFUTED and place in claims[outcome.claim].reads()
            ]
            texts = interpretation.texts.with_edit(place, edit)

            def holds(number: int, failing: list[Claim] = failing, texts: Texts = texts) -> bool:
                with suppress(TimeoutError), time_limit(PATIENCE):
                    return interpretation.holds(failing[number], texts)
                return False

            if sum(each(holds, range(len(failing)), late=lambda _: False)) > 1:
                causes.misprints[place] = edit

    def _units(self, texts: Texts) -> Iterator[tuple[Printed, Edit]]:
        """The printed squares of the imaginary unit that are not -1, each with what makes it so."""
        for item in self.reading.parts.known[0].units:
            place = item.printed
            right = Relation((Power(Name("i"), Number(2)), Negative(Number(1))), ("=",))
            if texts.formula(place) != right:
                every = edits(texts.statement(place), texts.vocabulary)
                yield from ((place, edit) for edit in every if edit.formula == right)
                return

    @property
    def _in_words(self) -> list[str]:
        """The claims of sentences: nearly any other function would be independent, or at rest."""
        apart = (SAID, OF_ENERGY)
        in_words = (f for f in self.reading.statements if f.role.kind not in apart)
        return [f.claim.id for f in in_words if f.claim is not None]

    @property
    def _searched(self) -> set[str]:
        """The claims for which a repair is sought as for what is refuted: no other one is there."""
        doubts = self.interpretation.derivation.doubts
        certain = {id for id, doubt in doubts.items() if doubt is Doubt.UNLESS_MENDED}
        return certain.difference(self._in_words)

    @property
    def _lost(self) -> dict[str, frozenset[str]]:
        """The names in claims that nothing explains, and that were taken for constants."""
        return {id: f.item.names & {*f.constants} for id, f in self.claiming.items()}

    def _blame(self, session: Session, outcomes: Sequence[Outcome], causes: Causes) -> Blame:
        """The search for what makes claims fail that stand on no misprint that is known."""
        verdicts = {outcome.claim: outcome.verdict for outcome in outcomes}
        misprints = causes.mended().keys()
        waiting = {c.id for c in session.derivation.claims if c.reads() & misprints}
        doubted = {id for id, doubt in session.derivation.doubts.items() if doubt is Doubt.ALWAYS}
        explained = [o.claim for o in outcomes if o.correction or o.claim in waiting | doubted]
        corrected = [*explained, *self._in_words]
        corrector, lost = session.decider.corrector, self._lost
        suspected = edits_by_scales(self.reading, session.interpretation.texts)
        return Blame(
            corrector, verdicts, corrected, PATIENCE, doubted, lost, suspected,
            decides_again=session is self._session,
        )  # fmt: skip

    # -- what is mended elsewhere --------------------------------------------------------

    def _mend(self, found: dict[str, Outcome]) -> None:
        """Decide once more, with what is blamed as it should read, what that has not mended."""
        mended = self.causes.mended()
        rest = [
            claim.id
            for claim in self.interpretation.derivation.claims
            if self._waits(found[claim.id]) and claim.reads() & mended.keys()
        ]
        if not rest:
            return
        texts = self.interpretation.texts.reading(mended)
        again = self._session.under(self.interpretation.under(texts))
        claims = {claim.id: claim for claim in self.interpretation.derivation.claims}
        mending: list[Outcome] = []
        for outcome in self._run(again, Causes(), rest).outcomes:
            own = outcome.correction is not None and not outcome.correction.blamed
            late = found[outcome.claim].verdict is Verdict.TIMEOUT
            if own or (outcome.verdict.green and not late):
                mending.append(outcome)
        standing = [claims[outcome.claim] for outcome in mending]
        needed = each(
            lambda number: self._needed(standing[number]), range(len(standing)),
            late=lambda number: self._under(standing[number]),
        )  # fmt: skip
        for outcome, causes in zip(mending, needed, strict=True):
            self.causes.places[outcome.claim] = causes
            corrections = () if outcome.correction is None else (outcome.correction,)
            if not corrections:
                self.causes.corrections[outcome.claim] = self._of_others(outcome, causes)
            failed = found[outcome.claim]._replace(verdict=Verdict.REFUTED, message="")
            found[outcome.claim] = failed.corrected_by(corrections)

    def _under(self, claim: Claim) -> tuple[Printed, ...]:
        """The misprints on which a claim stands."""
        reads, misprints = claim.reads(), self.causes.misprints.items()
        return tuple(p for p, edit in misprints if not reads.isdisjoint(edited_formulas(p, edit)))

    def _needed(self, claim: Claim) -> tuple[Printed, ...]:
        """The misprints on which a claim stands, without those that need not be mended for it."""
        kept = [*self._under(claim)]
        for place in kept[:]:
            fewer = self.causes.mended([other for other in kept if other != place])
            with suppress(TimeoutError), time_limit(PATIENCE):
                texts = self.interpretation.texts.reading(fewer)
                if fewer and self.interpretation.holds(claim, texts):
                    kept.remove(place)
        return (*kept,)

    def _of_others(self, outcome: Outcome, causes: Sequence[Printed]) -> Correction:
        """The correction of the formulas that are blamed, by which a claim is proved."""
        place, *besides = causes
        edit = self.causes.misprints[place]
        return Correction(
            (edit.formula,), edit.words, outcome.verdict, outcome.conditions, printed=place,
            edit=edit, blamed=(edit.statement.formula,), besides=(*besides,),
        )  # fmt: skip

    def _shared_repairs(self) -> dict[Printed, Formula]:
        """What formulas should read with which several claims would hold that are doubted."""
        places = {id: one.printed for id, one in self.repairs.items() if one.edit is not None}
        found: dict[Printed, Formula] = {}
        for id, place in places.items():
            edit = self.repairs[id].edit
            alike = [one for one in places if places[one] == place]
            if place is not None and edit is not None and len(alike) > 1:
                found |= edited_formulas(place, edit)
        return found

    def _doubt(self, found: dict[str, Outcome], mended: Mapping[Printed, Formula]) -> None:
        """Take the verdict from what is true of a misprint only, and not of what it should read."""
        about = [
            claim
            for claim in self.interpretation.derivation.claims
            if found[claim.id].verdict.green and claim.reads() & mended.keys()
        ]
        texts = self.interpretation.texts.reading(mended)

        def verdict(number: int) -> Verdict:
            with suppress(TimeoutError), time_limit(PATIENCE):
                true = self.interpretation.holds(about[number], texts)
                return found[about[number].id].verdict if true else Verdict.UNDECIDED
            return Verdict.TIMEOUT

        verdicts = each(verdict, range(len(about)), late=lambda _: Verdict.TIMEOUT)
        for claim, now in zip(about, verdicts, strict=True):
            if not now.green:
                found[claim.id] = found[claim.id]._replace(
                    verdict=now, certificate="",
                    message=BY_MISPRINT if now is Verdict.UNDECIDED else BESIDE_MISPRINT,
                )  # fmt: skip

    def _waits(self, outcome: Outcome) -> bool:
        """Whether a claim is false as it was read, or not decided, and nothing explains it."""
        open_ones = (Verdict.REFUTED, Verdict.TIMEOUT)
        failed = outcome.verdict in open_ones or outcome.message == FALSE_AS_READ
        return failed and outcome.correction is None and outcome.claim not in self.causes.places


def audit_reading(session: ReadingSession) -> Audit:
    """All formulas of a source that is its own derivation, with what a run says of each."""
    start, reading = perf_counter(), session.reading
    paper = reading.paper
    places = [Correspondence(display, typed) for display, typed in paper.displays]
    author = AuthorSession(session, {}, {}, {})
    describe = Describer(paper.source, paper.expanded, author, {})
    for formula in reading.formulas:
        claim, printed = formula.claim, formula.item.printed
        if claim is not None and printed not in claim.establishes():
            role = describe.roles.at(
                printed.place
            )  # it is claimed of what the paper does not print
            role.own[claim.id] = role.claims[claim.id] = None
    found = [formula for place in places for formula in describe.formulas(place)]
    by_place = {formula.item.printed: formula for formula in reading.formulas}
    no_formulas = [one for one in reading.formulas if one.item.trouble and one.role.name != UNREAD]
    skipped = {one.item.printed.display.id: one for one in (*no_formulas, *_skipped(reading))}
    for audited in found:
        _as_read(audited, by_place.get(audited.place) if audited.place else skipped.get(audited.id))
    point_at(found, session.repairs, reading)
    _tell_numbers(found, reading)
    tell_scales(found, reading)
    tell_steps(found, session.repairs, reading)
    said = (*paper.source.refused, *paper.expanded.notes)
    notes = [(paper.source.line(offset), reason) for offset, reason in said]
    return Audit(
        paper.source, paper.expanded, places, found, author, notes, _regions(reading),
        perf_counter() - start, reading, uncovered(reading),
    )  # fmt: skip


def _tell_numbers(found: Sequence[Audited], reading: Reading) -> None:
    """Say of what is decided for a number alone for which one, as :math:`N=3`."""
    counted = {*claims_of_numbers(reading)}
    for audited in found:
        if not audited.message and not counted.isdisjoint(audited.claims):
            audited.message = f"for ${shown_numbers(reading.paper.numbers)}$"


def _regions(reading: Reading) -> dict[str, Region]:
    """Where the words stand that make claims."""
    source, expanded = reading.paper.source, reading.paper.expanded
    return {
        statement.claim.id: source.region(*expanded.origin(*statement.span))
        for statement in reading.statements
        if statement.claim is not None and statement.span is not None
    }


def uncovered(reading: Reading) -> list[Uncovered]:
    """The sentences that claim something, and by which no claim is made that is judged."""
    paper, said = reading.paper, reading.parts.said
    judged = [f for f in (*reading.formulas, *reading.statements) if f.claim is not None]
    kinds = {(f.item.sentence, f.role.kind) for f in judged if f.span is None}
    rests = [f for f in judged if isinstance(f.claim, RestPoint | RestPoints)]
    kinds |= {(f.item.sentence, "rest") for f in rests}
    kinds |= {(f.item.sentence, "period") for f in judged if isinstance(f.claim, Period)}
    integrals = (f for f in judged if f.role.kind == "integral")
    kinds |= {(f.item.sentence, "invariant") for f in integrals if "nvarian" in f.role.reason}
    kinds |= {
        (f.item.sentence, "all rest")
        for f in rests
        if isinstance(f.claim, RestPoints) and f.claim.are_all
    }
    covered = [*said.skipped(paper.prose), *(f.span for f in judged if f.span is not None)]
    ends = [0, *(typed.end for _, typed in paper.displays)]
    for one in (formula.item.typed for formula in _skipped(reading)):  # and what leads up to them
        covered.append((max(end for end in ends if end <= one.start), one.end))
    led = leads(reading.parts)
    stated = sentences(paper.prose, paper.source, paper.expanded, covered, led)
    left = [(span, passage) for span, kind, passage in stated if (span, kind) not in kinds]
    left += [
        (row.sentence, passage_at(row.sentence, OF_LAW, paper.source, paper.expanded))
        for row in reading.parts.deduced()
    ]
    left += [
        (span, passage_at(span, ALL_EIGENVALUES, paper.source, paper.expanded))
        for span in fewer_eigenvalues(
            [f.item for f in judged if f.role.kind == KIND], reading.parts.of
        )
    ]
    more = (one for one, role in reading.parts.roles.items() if role.kind == MORE)
    left += [
        (one.sentence, passage_at(one.sentence, SAYS_MORE, paper.source, paper.expanded))
        for one in more
    ]
    left += [
        (one.sentence, passage_at(one.sentence, OF_EXPRESSION, paper.source, paper.expanded))
        for one in expressions(reading.parts)
    ]
    left.sort(key=lambda one: one[0])
    return [*dict(reversed(left)).values()][::-1]


def _skipped(reading: Reading) -> Iterator[JudgedStatement]:
    """What the author does not want to be judged."""
    return (formula for formula in reading.formulas if formula.role.kind == SKIPPED)


def _as_read(audited: Audited, formula: JudgedStatement | None) -> None:
    """Give a formula the role that it was read in."""
    audited.message = audited.message.removeprefix(f"{audited.id}: ")
    if formula is None:
        audited.role, audited.reason = "unread", audited.message
        audited.verdict = OPEN if audited.verdict == UNREADABLE else audited.verdict
        return
    audited.role, audited.reason = formula.role.name, formula.role.reason
    if audited.verdict == UNREADABLE:  # and it need not be read
        audited.verdict, audited.message = GIVEN, ""
    audited.on = tuple(item.printed.place for item in formula.on)
    if formula.role.name == UNREAD:
        audited.verdict = OPEN
    if audited.message == FALSE_AS_READ and formula.message:
        audited.message = f"{FALSE_AS_READ}: {formula.message}"
    if formula.role.name == CLAIM and formula.claim is None and not audited.claims:
        audited.verdict = OPEN
        audited.message = formula.message or NOT_JUDGED


def is_read(audit: Audit) -> bool:
    """Whether there are equations of motion, if only a Hamiltonian gives them, and a claim."""
    assert audit.reading is not None
    has_law = not all(map(is_free, audit.reading.parts.laws))
    return has_law and any(formula.role == CLAIM for formula in audit.formulas)
