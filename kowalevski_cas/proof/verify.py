"""The run: every claim of a derivation, in the order of the paper, in every arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from time import perf_counter

from kowalevski_cas.arithmetic import POINTS, load_points
from kowalevski_cas.claims import Claim, Finding
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.derivation import Derivation
from kowalevski_cas.notation import Formula, NotationError, is_small_change
from kowalevski_cas.proof.dependencies import Dependencies
from kowalevski_cas.proof.digest import Digester, combined
from kowalevski_cas.proof.evidence import Evidence, Mended
from kowalevski_cas.proof.limits import time_limit
from kowalevski_cas.proof.outcome import Correction, Outcome, Run, Verdict
from kowalevski_cas.search.corrections import correction
from kowalevski_cas.stage import Stage, StageError
from kowalevski_cas.paper.texts import Printed, Texts

Progress = Callable[[str, int, int], None]


def verify(
    derivation: Derivation,
    arithmetics: Sequence[str],
    only: Sequence[str] = (),
    explain: bool = False,
    progress: Progress = lambda claim, done, total: None,
    evidence: dict[str, Evidence] | None = None,
    timeout: float | None = None,
    sources: Mapping[str, str] | None = None,
    seed: int = 1,
) -> Run:
    """Decide the claims of a derivation.

    A formula that is refuted and corrected stands corrected for the claims that
    come after it. With ``only``, the claims before a chosen one are decided
    where it rests on them, but not reported. With ``explain``, findings tell
    their steps and outcomes what they rest on. ``evidence`` saves the searches
    whose results it holds; what is found anew is added to it. ``timeout`` is in
    seconds, for each claim in each arithmetic. ``sources`` holds displays, by id,
    that are to be read instead of what the derivation prints. ``seed`` chooses the
    points of the arithmetics that only screen.
    """
    kept = {} if evidence is None else evidence
    session = Session(derivation, arithmetics, explain, kept, timeout, sources, seed)
    return session.run(only, progress)


DECIDED = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)
ANSWERED = (*DECIDED, Verdict.PROBABLE, Verdict.ENCLOSED)


def disagreement(verdicts: Mapping[str, Verdict]) -> bool:
    """Whether two arithmetics decided differently; an undecided one disagrees with none."""
    return len({verdict for verdict in verdicts.values() if verdict in DECIDED}) > 1


class Session:
    """The state of a run: the texts as corrected so far, stages, and found evidence."""

    def __init__(
        self,
        derivation: Derivation,
        arithmetics: Sequence[str],
        explain: bool,
        evidence: dict[str, Evidence],
        timeout: float | None = None,
        sources: Mapping[str, str] | None = None,
        seed: int = 1,
    ) -> None:
        self.derivation = derivation
        self.arithmetics = arithmetics
        self.explain = explain
        self.timeout = timeout
        self.points = {name: load_points(name, seed) for name in arithmetics if name in POINTS}
        self.evidence = evidence
        self.texts = derivation.texts(sources)
        self.dependencies = Dependencies(self.texts)
        self.digester = Digester()
        self.stages: dict[object, Stage] = {}
        self.shelf: dict[str, object] = {}
        self.order = {claim.id: k for k, claim in enumerate(derivation.claims)}
        self.established: dict[Printed, str] = {}
        for claim in derivation.claims:
            for printed in claim.establishes():
                self.established.setdefault(printed, claim.id)

    def run(self, only: Sequence[str] = (), progress: Progress = lambda *_: None) -> Run:
        """Decide the chosen claims, and before them those on which they rest."""
        derivation = self.derivation
        chosen = [c for c in derivation.claims if not only or c.id in only]
        needed = self.needed(chosen) if only else chosen
        outcomes = []
        for done, claim in enumerate(needed):
            progress(claim.id, done, len(needed))
            outcome = self.decide(claim)
            if claim in chosen:
                outcomes.append(outcome)
        return Run(
            derivation=derivation.name,
            title=derivation.title,
            author=derivation.author,
            source=derivation.source,
            sections=tuple((s.number, s.title) for s in derivation.sections),
            outcomes=tuple(outcomes),
            arithmetics=tuple(self.arithmetics),
            versions={},
            digest=combined(f"{o.claim} {o.digest}" for o in outcomes),
            vocabulary=self.texts.vocabulary,
        )

    def rests_on(self, claim: Claim) -> tuple[str, ...]:
        """The claims before this one that establish the places on which it stands."""
        try:
            places = self.dependencies.foundations(claim)
        except NotationError:
            places = dict.fromkeys(claim.places())
        ids = dict.fromkeys(self.established.get(place) for place in places)
        before = self.order[claim.id]
        return tuple(i for i in ids if i is not None and self.order[i] < before)

    def needed(self, chosen: Sequence[Claim]) -> list[Claim]:
        """The chosen claims and those on which they rest, in the order of the paper."""
        ids = {claim.id for claim in chosen}
        by_id = {claim.id: claim for claim in self.derivation.claims}
        waiting = list(chosen)
        while waiting:
            for id in self.rests_on(waiting.pop()):
                if id not in ids:
                    ids.add(id)
                    waiting.append(by_id[id])
        return [claim for claim in self.derivation.claims if claim.id in ids]

    def decide(self, claim: Claim) -> Outcome:
        """The outcome for one claim; its correction becomes part of the texts."""
        digest, kept = self._digest(claim)
        self.shelf.update(kept.found)
        known = set(self.shelf) - set(kept.found)
        seconds: dict[str, float] = {}
        findings: dict[str, Finding] = {}
        before = self._products()
        for arithmetic in self.arithmetics:
            start = perf_counter()
            findings[arithmetic] = self._find(claim, arithmetic, kept)
            seconds[arithmetic] = perf_counter() - start
        products = self._products() - before
        first = findings[self.arithmetics[0]]
        verdicts = {name: finding.verdict for name, finding in findings.items()}
        verdict, message = first.verdict, first.message
        if disagreement(verdicts):
            shown = ", ".join(f"{name}: {v}" for name, v in verdicts.items())
            verdict, message = Verdict.ERROR, f"the arithmetics disagree ({shown})"
        else:
            open_ones = [f for f in findings.values() if f.verdict not in ANSWERED]
            if open_ones:
                verdict, message = open_ones[0].verdict, open_ones[0].message
        kept.found = {label: value for label, value in self.shelf.items() if label not in known}
        formulas, source = self._printed(claim) if digest else ((), "")
        mended = first.correction
        if verdict is Verdict.REFUTED and mended is None:
            start = perf_counter()
            mended = self._correct(claim, kept)
            seconds[self.arithmetics[0]] += perf_counter() - start
        if digest:
            self.evidence[claim.id] = kept
        return Outcome(
            claim=claim.id,
            section=self.derivation.section_of(claim).number,
            scene=claim.scene.name,
            formulas=formulas,
            source=source,
            words=claim.words,
            verdict=verdict,
            conditions=first.conditions,
            steps=first.steps,
            counterexample=first.counterexample,
            correction=mended,
            rests_on=self.rests_on(claim) if self.explain else (),
            digest=digest,
            message=message,
            products=products,
            seconds=seconds,
            verdicts=verdicts,
            chance=first.chance,
            radius=first.radius,
            granted=self._granted(claim) if digest else (),
        )

    def _digest(self, claim: Claim) -> tuple[str, Evidence]:
        """The digest of a claim, and the evidence for it that was kept."""
        try:
            digest = self.digester.statement(claim, self.texts)
        except NotationError:
            return "", Evidence("")
        kept = self.evidence.get(claim.id)
        return digest, kept if kept is not None and kept.digest == digest else Evidence(digest)

    def _bench(self, arithmetic: str, texts: Texts) -> Bench:
        explain = self.explain and arithmetic == self.arithmetics[0]
        return Bench(arithmetic, texts, explain, self.shelf, self.stages)

    def _decide(self, claim: Claim, bench: Bench) -> Finding:
        try:
            with time_limit(self.timeout):
                points = self.points.get(bench.arithmetic)
                if points is None:
                    return claim.decide(bench)
                from kowalevski_cas.proof.screen import screen

                return screen(claim, bench, points)
        except TimeoutError:
            message = f"not decided within {self.timeout:g} s by {bench.arithmetic}"
            return Finding(Verdict.TIMEOUT, message=message)
        except (NotationError, StageError) as error:
            return Finding(Verdict.ERROR, message=str(error))
        except Exception as error:
            # Evidence of the wrong shape, or a claim that makes no sense: said, never a traceback.
            shown = f"{type(claim).__name__} {claim.id}: {type(error).__name__}: {error}"
            return Finding(Verdict.ERROR, message=shown)

    def _find(self, claim: Claim, arithmetic: str, kept: Evidence) -> Finding:
        """The finding in one arithmetic; evidence that does not help is searched for anew."""
        finding = self._decide(claim, self._bench(arithmetic, self.texts))
        if finding.verdict in DECIDED or not kept.found or arithmetic in POINTS:
            return finding
        for label in kept.found:
            self.shelf.pop(label, None)
        kept.found = {}
        return self._decide(claim, self._bench(arithmetic, self.texts))

    def _correct(self, claim: Claim, kept: Evidence) -> Correction | None:
        """The nearest true statement, decided in every arithmetic."""
        if kept.hopeless:
            return None
        found = self._kept_correction(claim, kept) or self._new_correction(claim, kept)
        if found is None or kept.correction is None:
            return None
        place, texts = found
        self.shelf = {}
        findings = [
            self._decide(claim, self._bench(arithmetic, texts)) for arithmetic in self.arithmetics
        ]
        verdicts = {finding.verdict for finding in findings}
        verdict = findings[0].verdict if len(verdicts) == 1 else Verdict.ERROR
        if verdict.likely:
            self.texts = texts
        return Correction(
            formulas=(texts.formula(place),),
            words=kept.correction.words,
            verdict=verdict,
            conditions=findings[0].conditions,
        )

    def _new_correction(self, claim: Claim, kept: Evidence) -> tuple[Printed, Texts] | None:
        """The place and the texts of a correction that is searched for, and then kept."""
        neighbour = correction(claim, self._bench(self.arithmetics[0], self.texts))
        if neighbour is None or neighbour.printed is None or neighbour.edit is None:
            kept.hopeless = True
            return None
        place, tex = neighbour.printed, neighbour.edit.tex
        kept.correction = Mended(place.place, tex, neighbour.words)
        return place, self.texts.with_source(place.display, tex)

    def _kept_correction(self, claim: Claim, kept: Evidence) -> tuple[Printed, Texts] | None:
        """The same for a kept one, if it is what it has to be: one small change of one formula."""
        mended = kept.correction
        if mended is None:
            return None
        place = next((p for p in claim.establishes() if p.place == mended.place), None)
        if place is None:
            return None
        texts = self.texts.with_source(place.display, mended.tex)
        try:
            before, after = self.texts.statements(place.display), texts.statements(place.display)
        except NotationError:
            return None
        old, new = ([statement.formula for statement in side] for side in (before, after))
        own = place.number - 1
        small = (
            len(old) == len(new)
            and all(a == b for k, (a, b) in enumerate(zip(old, new, strict=True)) if k != own)
            and is_small_change(old[own], new[own])
        )
        return (place, texts) if small else None

    def _printed(self, claim: Claim) -> tuple[tuple[Formula, ...], str]:
        """The formulas of a claim, and how the paper prints them."""
        places = [claim.printed] if claim.printed else list(claim.establishes())
        statements = [self.texts.statement(place) for place in places]
        source = r",\quad ".join(statement.source for statement in statements)
        return tuple(statement.formula for statement in statements), source

    def _granted(self, claim: Claim) -> tuple[Formula, ...]:
        """What the scenes of a claim suppose not to vanish."""
        sources = dict.fromkeys(tex for scene in claim.scenes() for tex in scene.nonzero)
        return tuple(map(self.texts.expression, sources))

    def _products(self) -> int:
        return sum(stage.ring.products for stage in self.stages.values())
