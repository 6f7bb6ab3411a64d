"""Spaces in straight-line programs, to be evaluated at points and never expanded.

What has to be derived (squares of roots, the vector field) is taken from an exact evaluation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from kowalevski_cas.algebra.derivation import Field
from kowalevski_cas.algebra.modular import SampledPrograms
from kowalevski_cas.algebra.programs import Program
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.fold import Value
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import Adjoined, Equation, Step


def solved_equations(given: Sequence[Equation], exact: Evaluation) -> dict[str, Formula] | None:
    """The names that equations give by others, of which they give none; ``None`` if they do more.

    No root stands in their values.
    """
    solved: dict[str, Formula] = {}
    reached = set[str]()
    for left, right in given:
        first, value = (left, right) if isinstance(left, Name) else (right, left)
        if not isinstance(first, Name) or first.name not in exact.names or first.name in solved:
            return None
        solved[first.name] = value
        reach = Reach(exact.setting)
        reach.formula(value)
        reached |= reach.names
        if not {*exact.scalar(value).parts} <= {0}:
            return None
    return None if reached & solved.keys() else solved


class Sampled(Evaluation):
    """The space of an exact evaluation, with programs for elements.

    Values of subformulas are remembered, by identity, so that a formula that shares most of its
    tree with earlier ones costs little. Names that are ``given`` by others have these values, in
    what is carried over; nothing is derived then.
    """

    def __init__(
        self, exact: Evaluation, given: Mapping[str, Formula] = MappingProxyType({})
    ) -> None:
        self.exact = exact
        self.programs = SampledPrograms(exact.ring.polynomials.generators)
        super().__init__(exact.setting, exact.polynomials, self.programs, {})  # type: ignore[arg-type] # a ring of programs
        self._memory: dict[tuple[int, bool], tuple[Formula, Value]] = {}
        for name in self.names:
            self._values[name, False] = self.programs.generator(name)
        values = {name: exact.scalar(value) for name, value in given.items()}
        self._values |= {(name, False): self.carry(value) for name, value in values.items()}
        for name, below in zip(exact.ring.roots, exact.ring.below, strict=True):
            square, divisor = self._square(name), self.carry(below or exact.ring.one)
            generator = self.programs.adjoin(name, square * divisor**2)
            self._values[name, False] = generator * divisor.inverse()
        self.roots = {name: self._square(name) for name in exact.roots}

    def _square(self, name: str) -> Program:
        """What a root is taken of, as it is written, which is short where its value is not."""
        step = self.exact.setting.step(name)
        assert isinstance(step, Adjoined)
        square = self.scalar(step.square)
        assert isinstance(square, Program)
        return square

    def _roots_of(self, value: Element, argument: Formula) -> list[str]:
        """Which roots these are tell points as soon as all roots are there."""
        return super()._roots_of(value, argument) if self.roots else self.exact.root_names(argument)

    def __call__(self, formula: Formula, conjugated: bool = False) -> Value:
        key = (id(formula), conjugated)
        if key not in self._memory:
            self._memory[key] = formula, super().__call__(formula, conjugated)
        return self._memory[key][1]

    def step_of(self, formula: Formula) -> Program | None:
        """What a formula has given where it stands itself, if it was evaluated, and is a scalar."""
        if (id(formula), True) in self._memory:
            return None  # its conjugate is another program
        value = self._memory.get((id(formula), False), (formula, None))[1]
        return value if isinstance(value, Program) else None

    def carry(self, element: Element) -> Program:
        """An exact element as a program."""
        if isinstance(element, Program):
            return element
        image = self.image(element, self._generator)
        assert isinstance(image, Program)
        return image

    def _generator(self, name: str) -> Element:
        value = self._values[name, False]
        assert isinstance(value, Element)
        return value

    def _given(self, name: str, step: Step | None, conjugated: bool) -> Value:
        return self.carry(self.exact.scalar(Name(name), conjugated))

    @property
    def rates(self) -> Field:
        """The vector field; after a change, and of roots, as the exact evaluation derives it."""
        if self._is_printed:
            return super().rates
        if self._rates is None:
            self._rates = {name: self.carry(rate) for name, rate in self.exact.rates.items()}
        return self._rates

    @property
    def _is_printed(self) -> bool:
        """Whether equations of motion give all rates, and none of a root."""
        moving = {name for row in self.setting.field for name in row.names}
        return self.setting.change is None and moving == {*self.setting.variables}

    @property
    def time_sign(self) -> int:
        """Whether the time is real, as the exact evaluation finds it."""
        return self.exact.time_sign
