"""Which edits of formulas leave a claim false that stands on them: told at a point modulo a prime.

The identities of a claim are programs, in which what a formula says is one step. With another step
in its place only what uses it is computed anew, and nothing is elaborated. That is trusted as
soon as it has come out for some edits as where the claim is elaborated with them: else the
formula enters the claim in another way, too. What holds where equations are given is looked at
where these hold modulo the prime.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random
from typing import NamedTuple

from kowalevski_cas.algebra.modular import primes, residue_point
from kowalevski_cas.algebra.points import NoPoint, Question
from kowalevski_cas.algebra.programs import Op, Program, behind, replaced
from kowalevski_cas.algebra.valuation import Number as Residue
from kowalevski_cas.algebra.valuation import Valuation
from kowalevski_cas.notation import Edit, Formula, Name, NotationError, Number
from kowalevski_cas.notation.misprints import only_change
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborate import finder_of
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.plain import is_arithmetic
from kowalevski_cas.paper.texts import Printed, edited_formulas
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.problem.space import Equation, Meaningless, Setting

TRIALS = 3
"""How many edits of formulas are compared with the claim that is elaborated with them."""

_SAYS_NOTHING = (NotationError, Meaningless, ArithmeticError, NoPoint)

Part = tuple[Formula, Formula]
"""An arithmetic part of a formula, before and after an edit."""


class VanishingAtPoint(NamedTuple):
    """What an identity says to vanish where equations are given, at a point of these."""

    at: Sampled
    program: Program
    given: tuple[Program, ...]
    point: Valuation


class Variations:
    """The identities of a claim under edits of what it stands on, one at a time."""

    def __init__(self, claim: Claim, on: Elaborations) -> None:
        self.claim, self.on = claim, on
        self._known: dict[tuple[int, ...], _Varied] = {}
        try:
            self._differences = [*_differences(claim, on)]
        except _SAYS_NOTHING:
            self._differences = []

    def exclude(self, place: Printed, edit: Edit) -> bool:
        """Whether the claim is false with an edit of a place that it does not name itself.

        Of an edit of what is not arithmetic nothing is said.
        """
        changed = edited_formulas(place, edit)
        if not self._differences or not changed.keys().isdisjoint(self.claim.places()):
            return False
        try:
            parts = [_part(self.on.texts.formula(one), new) for one, new in changed.items()]
            if not all(map(_is_one_step, parts)):
                return False
            key = tuple(id(before) for before, _ in parts)
            if key not in self._known:
                self._known[key] = _Varied([before for before, _ in parts], self._differences)
            varied = self._known[key]
            values = varied.values(parts) if varied.is_separate else []
            if varied.is_separate and varied.trials < TRIALS:
                varied.compare(values, self._elaborated(place, edit))
            return varied.is_separate and any(value != 0 for value in values)
        except _SAYS_NOTHING:
            return False

    def _elaborated(self, place: Printed, edit: Edit) -> list[VanishingAtPoint]:
        """The identities of the claim as it is elaborated with an edit."""
        on = self.on.apart(self.on.texts)
        return [*_differences(self.claim, on.under(on.texts.with_edit(place, edit)))]


class _Varied:
    """Parts of formulas, each of which is one step in the identities of a claim."""

    def __init__(self, parts: Sequence[Formula], differences: Sequence[VanishingAtPoint]) -> None:
        self._parts, self._differences = parts, differences  # they are known by their identity
        self._using: dict[Sampled, list[Program]] = {}
        given = False
        for at in dict.fromkeys(one.at for one in differences):
            sources = {step for part in parts if (step := _step(at, part)) is not None}
            here = [one for one in differences if one.at is at]
            self._using[at] = behind([one.program for one in here], sources)
            given |= bool(behind([one for two in here for one in two.given], sources))
        self.is_separate = any(self._using.values()) and not given
        self.trials = 0

    def values(self, parts: Sequence[Part]) -> list[Residue]:
        """The values of what is to vanish with other formulas in the place of the parts."""
        instead: dict[Program, Program] = {}
        for at, using in self._using.items():
            new: dict[Program, Program] = {}
            for before, after in parts:
                if (step := _step(at, before)) is not None:
                    value = at.scalar(after)
                    assert isinstance(value, Program)
                    new[step] = value
            instead |= replaced(using, new)
        return [one.point(instead.get(one.program, one.program)) for one in self._differences]

    def compare(self, values: Sequence[Residue], elaborated: Sequence[VanishingAtPoint]) -> None:
        """Compare values with those of the claim that is elaborated with the same edit."""
        points = [[one.point.values for one in ones] for ones in (elaborated, self._differences)]
        same = points[0] == points[1]
        self.is_separate = same and [one.point(one.program) for one in elaborated] == values
        self.trials += 1


def _part(before: Formula, after: Formula) -> Part:
    """The largest part that is arithmetic of the formula in which two of them differ."""
    while not is_arithmetic(before) and (place := only_change(before, after)) is not None:
        before, after = before.children()[place], after.children()[place]
    return before, after


def _is_one_step(part: Part) -> bool:
    """Whether a part has a value of its own: what a name stands for may stand elsewhere."""
    return not isinstance(part[0], Name | Number) and all(map(is_arithmetic, part))


def _step(at: Sampled, part: Formula) -> Program | None:
    step = at.step_of(part)
    return None if step is None or step.op in (Op.NUMBER, Op.GENERATOR, Op.ROOT) else step


def _differences(claim: Claim, on: Elaborations) -> Iterator[VanishingAtPoint]:
    """What the identities of a claim say to vanish."""
    stages: dict[Setting, Sampled] = {}
    for goal in claim.goals(claim.settings(on)):
        if type(goal) is Follows and len(goal.conclusions) == 1:
            if goal.space not in stages:
                stages[goal.space] = Sampled(finder_of(goal.space))
            at = stages[goal.space]
            given = tuple(_programs(at, goal.given))
            point = _point(at, given) if given else at.programs.samples[0]
            for program in _programs(at, goal.conclusions[0]):
                yield VanishingAtPoint(at, program, given, point)


def _programs(at: Sampled, equations: Sequence[Equation]) -> Iterator[Program]:
    for difference in at.differences(equations):
        assert isinstance(difference, Program)
        yield difference


def _point(at: Sampled, given: tuple[Program, ...]) -> Valuation:
    """A point at which equations hold, the same in every run."""
    random = Random(0)
    roots = [at.programs.generator(name) for name in at.programs.roots]
    return residue_point(
        Question(at.programs, roots, given=[*given]), next(primes(random, 1)), random
    )
