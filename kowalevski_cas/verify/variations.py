"""Which edits of a formula leave a claim false that stands on it: told at a point modulo a prime.

The identities of a claim are programs, in which what the formula says is one step. With another
step in its place only what uses it is computed anew, and nothing is elaborated. That is trusted as
soon as it has come out twice as where the claim is elaborated with an edit: else the formula
enters the claim in another way, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kowalevski_cas.algebra.points import NoPoint
from kowalevski_cas.algebra.programs import Op, Program, behind, replaced
from kowalevski_cas.algebra.valuation import Number as Residue
from kowalevski_cas.notation import Edit, Formula, Name, NotationError, Number
from kowalevski_cas.notation.edits import replace
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborate import finder_of
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.plain import is_arithmetic
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.problem.space import Meaningless, Setting

TRIALS = 3
"""How many edits of a formula are compared with the claim that is elaborated with them."""

Difference = tuple[Sampled, Program]
"""What an identity says to vanish, and where it is evaluated."""

_SAYS_NOTHING = (NotationError, Meaningless, ArithmeticError, NoPoint)


class Variations:
    """The identities of a claim under edits of what it stands on, one at a time."""

    def __init__(self, claim: Claim, on: Elaborations) -> None:
        self.claim, self.on = claim, on
        self._parts: dict[int, _Part] = {}
        try:
            self._differences = [*_differences(claim, on)]
        except _SAYS_NOTHING:
            self._differences = []

    def exclude(self, place: Printed, edit: Edit) -> bool:
        """Whether the claim is false with an edit of a place that it does not name itself.

        Of an edit of what is not arithmetic nothing is said.
        """
        printed, edited = _arithmetic_parts(edit)
        if not self._differences or place in {*self.claim.places()}:
            return False
        if isinstance(printed, Name | Number):
            return False  # what it stands for may stand elsewhere
        if not is_arithmetic(printed) or not is_arithmetic(edited):
            return False
        try:
            if id(printed) not in self._parts:
                self._parts[id(printed)] = _Part(printed, self._differences)
            part = self._parts[id(printed)]
            values = part.values(edited) if part.is_separate else []
            if part.is_separate and part.trials < TRIALS:
                part.compare(values, self._elaborated(place, edit))
            return part.is_separate and any(value != 0 for value in values)
        except _SAYS_NOTHING:
            return False

    def _elaborated(self, place: Printed, edit: Edit) -> list[Difference]:
        """The identities of the claim as it is elaborated with an edit."""
        on = self.on.apart(self.on.texts)
        return [*_differences(self.claim, on.under(on.texts.with_edit(place, edit)))]


class _Part:
    """A part of a printed formula, which is one step in the identities of a claim."""

    def __init__(self, printed: Formula, differences: Sequence[Difference]) -> None:
        self.printed, self._differences = printed, differences
        self._steps: dict[Sampled, tuple[Program, list[Program]]] = {}
        for at in dict.fromkeys(at for at, _ in differences):
            step = at.step_of(printed)
            if step is not None and step.op not in (Op.NUMBER, Op.GENERATOR, Op.ROOT):
                programs = [program for other, program in differences if other is at]
                self._steps[at] = step, behind(programs, step)
        self.is_separate = any(using for _, using in self._steps.values())
        self.trials = 0

    def values(self, edited: Formula) -> list[Residue]:
        """The values of what is to vanish with another formula in the place of the part."""
        instead: dict[Program, Program] = {}
        for at, (step, using) in self._steps.items():
            value = at.scalar(edited)
            assert isinstance(value, Program)
            instead |= replaced(using, step, value)
        return _values((at, instead.get(program, program)) for at, program in self._differences)

    def compare(self, values: Sequence[Residue], elaborated: Sequence[Difference]) -> None:
        """Compare values with those of the claim that is elaborated with the same edit."""
        same = _points(elaborated) == _points(self._differences)
        self.is_separate = same and _values(elaborated) == values
        self.trials += 1


def _arithmetic_parts(edit: Edit) -> tuple[Formula, Formula]:
    """The largest arithmetic part of a formula around an edit, before and after it."""
    printed, path = edit.statement.formula, edit.path
    while path and not is_arithmetic(printed):
        printed, path = printed.children()[path[0]], path[1:]
    return printed, replace(printed, path, edit.replacement)


def _differences(claim: Claim, on: Elaborations) -> Iterator[Difference]:
    """What the identities of a claim that hold everywhere say to vanish."""
    stages: dict[Setting, Sampled] = {}
    for goal in claim.goals(claim.settings(on)):
        if type(goal) is Follows and len(goal.conclusions) == 1 and not goal.given:
            at = stages.setdefault(goal.space, Sampled(finder_of(goal.space)))
            for difference in at.differences(goal.conclusions[0]):
                assert isinstance(difference, Program)
                yield at, difference


def _values(differences: Iterable[Difference]) -> list[Residue]:
    return [at.programs.samples[0](program) for at, program in differences]


def _points(differences: Iterable[Difference]) -> list[object]:
    return [at.programs.samples[0].values for at, _ in differences]
