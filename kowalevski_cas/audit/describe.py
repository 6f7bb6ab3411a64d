"""What a run found, place by place."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from kowalevski_cas.audit.audited import GIVEN, MISSING, NEW, SUSPECT, UNREADABLE, WRONG, Audited
from kowalevski_cas.audit.author import AuthorSession
from kowalevski_cas.audit.places import Correspondence
from kowalevski_cas.audit.roles import PlaceRoles, Roles, undefined_names, unused_constants
from kowalevski_cas.notation import Formula, NotationError, split_display, to_latex
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.expanded import Expanded
from kowalevski_cas.source.rewritten import Rewritten
from kowalevski_cas.source.text import Region, Source
from kowalevski_cas.verify.outcome import WORST


class Describer:
    """Says what a run found about each place."""

    def __init__(
        self,
        source: Source,
        expanded: Expanded,
        session: AuthorSession,
        refused: Mapping[Display, str],
    ) -> None:
        self.source = source
        self.expanded = expanded
        self.session = session
        self.outcomes = session.outcomes
        self.texts = session.interpretation.texts
        self.refused = refused
        self.roles = Roles(session.interpretation.derivation)
        self.error_outcome: dict[str, list[str]] = {}
        for claim, causes in session.causes.places.items():
            for printed in causes:
                self.error_outcome.setdefault(printed.place, []).append(claim)

    def formulas(self, place: Correspondence) -> Iterator[Audited]:
        """The statements of one display."""
        display, typed = place.display, place.typed
        if typed is None:
            label = "" if display.inline else display.id
            yield Audited(
                display.id, label, Region(self.source.path), display.tex.strip(),
                self._role(display),
                MISSING, claims=tuple(self._claims(display)), message=self.refused[display],
            )  # fmt: skip
            return
        try:
            if display in self.refused:
                raise NotationError(self.refused[display], typed.tex, 0)
            intervals = split_display(_read_as(typed.tex, display.tex))
            expected = len(split_display(display.tex))
            if len(intervals) == 1 or display.id in self.texts.sources:
                self.texts.statements(display)
        except NotationError as error:
            message = typed.trouble or str(error)
            yield self._entry(display.id, typed, (0, len(typed.tex)), display, UNREADABLE, message)
            return
        for number, interval in enumerate(intervals, 1):
            printed = display[number]
            id = printed.place if len(intervals) > 1 or expected > 1 else display.id
            audited = self._entry(id, typed, interval, display, GIVEN, typed.trouble)
            audited.moved = place.moved
            try:
                self._judge(audited, printed)
            except NotationError as error:  # of those beside it some can be read
                audited.verdict, audited.message = UNREADABLE, str(error)
            yield audited
        for number in range(len(intervals) + 1, expected + 1):
            yield self._entry(
                display[number].place, typed, (0, len(typed.tex)), display, MISSING,
                f"{expected} statements are expected here, {len(intervals)} are found",
            )  # fmt: skip

    def new(
        self, typed: Sequence[TypedFormula], places: Sequence[Correspondence]
    ) -> Iterator[Audited]:
        """Displays of the source for which the derivation has no place."""
        known = {id(place.typed) for place in places}
        for formula in typed:
            if not formula.inline and id(formula) not in known:
                whole = (0, len(formula.tex))
                name = "".join(formula.labels[:1]) or f"line {self._region(formula, *whole).line}"
                yield self._entry(name, formula, whole, None, NEW, "the derivation has none")

    def _entry(
        self,
        id: str,
        typed: TypedFormula,
        interval: tuple[int, int],
        display: Display | None,
        verdict: str,
        message: str,
    ) -> Audited:
        first, last = Rewritten(self.expanded.text[typed.start : typed.end], typed.tex).interval(
            *interval
        )
        start, end = self.expanded.origin(typed.start + first, typed.start + last)
        tex = self.source.text[start:end].strip()
        role = self._role(display) if display else "none"
        label = typed.labels[0] if typed.labels else ""
        region = self._region(typed, first, last)
        return Audited(id, label, region, tex, role, verdict, message=message)

    def _region(self, typed: TypedFormula, start: int, end: int) -> Region:
        """Where in its file a part of a formula stands, without the spaces around it."""
        tex = self.expanded.text[typed.start + start : typed.start + end]
        last = typed.start + start + len(tex.rstrip())
        first = min(last, typed.start + start + len(tex) - len(tex.lstrip()))
        return self.source.region(*self.expanded.origin(first, last))

    def _role(self, display: Display) -> str:
        return self.roles.at(display[1].place).name

    def _claims(self, display: Display) -> Iterator[str]:
        for place, role in self.roles.places.items():
            if place.rpartition(".")[0] == display.id:
                yield from role.claims

    def _judge(self, audited: Audited, printed: Printed) -> None:
        """The verdict on a statement, with its evidence."""
        role = self.roles.at(printed.place)
        audited.place = printed
        audited.formula = self.texts.statement(printed).formula
        audited.role = role.name
        audited.claims = tuple(role.claims)
        outcomes = [self.outcomes[claim] for claim in role.own or role.claims]
        if len(role.own) == 1:
            (audited.id,) = role.own
        if outcomes:
            worst = min(outcomes, key=lambda outcome: WORST.index(outcome.verdict))
            audited.verdict = str(worst.verdict)
            audited.conditions = worst.conditions
            audited.counterexample = worst.counterexample
            audited.correction, audited.alternatives = worst.correction, worst.alternatives
            audited.message = worst.message or audited.message
            causes = self.session.causes.places.get(worst.claim, ())
            audited.causes = tuple(cause.place for cause in causes)
        self._blame(audited, printed, audited.formula, role)

    def _blame(
        self, audited: Audited, printed: Printed, formula: Formula, role: PlaceRoles
    ) -> None:
        """What a statement makes false, and what it no longer defines."""
        session = self.session
        audited.breaks = tuple(self.error_outcome.get(printed.place, ()))
        lost = idle = []
        if printed in session.changed:
            lost = undefined_names(role, formula)
            before = session.base.decider.interpretation
            idle = unused_constants(before.derivation, before.texts, self.texts, printed)
        if lost:
            audited.message = f"it does not define {', '.join(lost)}"
        elif idle:
            audited.message = f"nothing depends on {', '.join(idle)} any more"
        elif audited.breaks and printed in session.causes.misprints:
            mended = to_latex(session.causes.misprints[printed].formula)
            audited.message = f"what rests on it is true with ${mended}$"
        if (lost or idle or audited.breaks) and audited.verdict not in WRONG:
            audited.verdict = SUSPECT


_RANGES = re.compile(r"(?:,\\quad (?:[a-z]=\d(?:,\d)*|\([a-z](?:\\neq?|[<>]) [a-z]\)))*")


def _read_as(typed: str, read: str) -> str:
    """A formula with the ranges of its indices that stand elsewhere, if it was read with them."""
    behind = read.removeprefix(typed)
    return read if behind != read and _RANGES.fullmatch(behind) else typed
