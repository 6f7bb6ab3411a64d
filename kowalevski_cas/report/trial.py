"""Counterexamples to try: what a page computes when a reader changes the numbers.

The certificate of a refuted claim has a space, two sides and a point. The sides become steps of a
computation with the coordinates, and so does what has to hold for them to be a point of the space.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain
from math import prod
from typing import Any, NamedTuple

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import name_formula, product_of
from kowalevski_cas.algebra.programs import Op, Program, Programs, steps
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, Number, Power, Relation, Vocabulary
from kowalevski_cas.problem.codec import Data, read_evidence, read_problem
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Entailment, Point
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Fails, Follows
from kowalevski_cas.problem.place import MINUS_ONE, PointEvaluation
from kowalevski_cas.problem.space import Adjoined, Raised, all_names
from kowalevski_cas.report.document import Text, Trial, TrialVersion
from kowalevski_cas.report.words import ZERO, nonzero
from kowalevski_cas.verify.outcome import Outcome

Json = Any


def trial_of(outcome: Outcome, vocabulary: Vocabulary) -> Trial | None:
    """The counterexample of an outcome to try; ``None`` where no two sides differ at a point."""
    if outcome.counterexample is None or not outcome.certificate:
        return None
    data = json.loads(outcome.certificate)
    index = data["evidence"][0]["goal"]
    correction = outcome.correction
    texts = [("as printed", data)]
    if correction is not None and correction.certificate:
        texts.append(("as corrected", json.loads(correction.certificate)))
    found = [(label, stated) for label, formula in texts if (stated := _statement(formula, index))]
    if not found or found[0][0] != texts[0][0]:
        return None
    versions = tuple(_Writer(stated, vocabulary).version(label) for label, stated in found)
    return Trial(versions)


class _Stated(NamedTuple):
    """A goal and a point of its space."""

    goal: Follows
    point: Point


def _statement(data: Data, index: int) -> _Stated | None:
    """A goal of a certificate with the point of its evidence, if it compares sides there."""
    denied = data["sign"] == "denied"
    goals = read_problem(data).goals
    if index >= len(goals):
        return None
    found = {k: v for k, v in data["evidence"][0 if denied else index].items() if k != "goal"}
    evidence = read_evidence(found, goals[index], not denied)
    match goals[index], evidence:
        case Follows(conclusions=(_,)) as goal, (
            At(Point() as point) | Entailment(point=Point() as point)
        ):
            return None if isinstance(goal, Fails) else _Stated(goal, point)
    return None


class _Writer:
    """The steps that evaluate a goal at points of its space, each step once."""

    def __init__(self, stated: _Stated, vocabulary: Vocabulary) -> None:
        self.goal, self.point = stated
        self.vocabulary = vocabulary
        self.at = finder_of(self.goal.space)
        names = all_names(self.goal.space)
        self.programs = Programs(names)
        values = {name: self.programs.generator(name) for name in names}
        self.image = Evaluation(self.goal.space, self.at.polynomials, self.programs, values)  # type: ignore[arg-type] # a ring of programs
        self.wanted: list[Program] = []

    def version(self, label: str) -> TrialVersion:
        """The goal as a reader may try it."""
        setting = self.goal.space
        units = [n for n in setting.roots if self._square(n) == MINUS_ONE]
        place = PointEvaluation(self.at, self.point)
        values = {n: _type_number(place.numbers.scalar(v)) for n, v in self.point.values.items()}
        pairs = [[self._step(e) for e in pair] for pair in self.at.pairs(self.goal.conclusions[-1])]
        said: list[Text] = []
        tests: list[tuple[str, list[Program]]] = []
        for kind, programs, words in self._hypotheses(units):
            self.wanted += programs
            tests.append((kind, programs))
            said.append(words)
        roots = [
            (name, self._square_of(name)) for name in setting.roots if self._is_principal(name)
        ]
        order = steps(self.wanted)
        places = {program: k for k, program in enumerate(order)}
        data = {
            "values": values,
            "units": units,
            "pairs": setting.conjugates,
            "roots": [[name, places[square]] for name, square in roots],
            "steps": [self._step_text(program, places) for program in order],
            "sides": [[places[value] for value in pair] for pair in pairs],
            "tests": [[kind, *(places[value] for value in found)] for kind, found in tests],
        }
        names = tuple((n, name_formula(n, self.vocabulary)) for n in values if n not in units)
        return TrialVersion(label, names, tuple(said), json.dumps(data, ensure_ascii=False))

    def _is_principal(self, name: str) -> bool:
        """Whether a name is a printed root, which is real and not negative."""
        return name.startswith(r"\sqrt") and all(name not in p for p in self.goal.space.conjugates)

    def _square_of(self, name: str) -> Program:
        """What a name is a root of, as a step."""
        step = self.goal.space.step(name)
        assert isinstance(step, Adjoined)
        return self._step(self.at.scalar(step.square))

    def _square(self, name: str) -> Formula | None:
        step = self.goal.space.step(name)
        return step.square if isinstance(step, Adjoined) else None

    def _hypotheses(self, units: Sequence[str]) -> Iterator[tuple[str, list[Program], Text]]:
        """What holds at a point of the space where the goal is defined, with the words for it.

        Two values are ``equal``, or each other's ``conjugate``; one is ``nonzero``, or
        ``positive``, which means not negative.
        """
        at, setting, name_of = self.at, self.goal.space, self.programs.generator
        for name in (*setting.roots, *setting.powers):
            yield from self._relation(name)
        for equation in self.goal.given:
            for pair in at.pairs((equation,)):
                yield "equal", [*map(self._step, pair)], (Relation(equation, ("=",)),)
        partner = dict(chain.from_iterable((pair, pair[::-1]) for pair in setting.conjugates))
        for name in all_names(setting):
            other = partner.get(name, name)
            if name in units or name > other:
                continue
            shown, bar = (name_formula(n, self.vocabulary) for n in (name, other))
            real: Text = (shown, " is real")
            words = real if name == other else ("the conjugate of ", shown, " is ", bar)
            yield "conjugate", [name_of(name), name_of(other)], words
            if self._is_principal(name):
                yield "positive", [name_of(name)], (Relation((shown, ZERO), (r"\ge",)),)
        for element in (*at.granted, *at.norms, *self._divisors()):
            words = (nonzero(product_of(element, self.vocabulary)),)
            yield "nonzero", [self._step(element)], words

    def _relation(self, name: str) -> Iterator[tuple[str, list[Program], Text]]:
        """The equations that a root or a power obeys."""
        step, generator = self.goal.space.step(name), self.programs.generator(name)
        if isinstance(step, Adjoined) and step.square != MINUS_ONE:
            equation = step.printed or (Power(Name(name), Number(2)), step.square)
            square = self._step(self.at.scalar(step.square))
            yield "equal", [generator**2, square], (Relation(equation, ("=",)),)
        elif isinstance(step, Raised):
            for formula, value in (
                (Name(name), generator),
                (step.base, self._step(self.at.scalar(step.base))),
            ):
                yield "equal", [value, self.programs.one], (Relation((formula, Number(1)), ("=",)),)

    def _divisors(self) -> Iterator[Element]:
        """What the goal divides by."""
        at, goal = self.at, self.goal
        equations = (*goal.given, *chain.from_iterable(goal.conclusions))
        stated = [*law(goal, at), *chain.from_iterable(at.pairs(equations))]
        for index in dict.fromkeys(k for element in stated for k in element.denominator):
            yield Element(at.ring, {0: at.ring.divisors[index]}, {})

    def _step(self, element: Element) -> Program:
        """An element as a step that is wanted."""
        program = self.image.image(element)
        assert isinstance(program, Program)
        self.wanted.append(program)
        return program

    @staticmethod
    def _step_text(program: Program, places: dict[Program, int]) -> Json:
        """A step: what it does, and to what."""
        args = [places[arg] for arg in program.args]
        match program.op:
            case Op.NUMBER:
                return ["number", str(program.number)]
            case Op.GENERATOR:
                return ["value", program.data]
            case Op.POWER:
                return ["power", *args, program.data]
        return [_OPERATIONS[program.op], *args]


_OPERATIONS = {Op.SUM: "sum", Op.PRODUCT: "product", Op.INVERSE: "inverse"}


def _type_number(number: Element) -> str:
    """A number as a reader types it: ``3/2-1/9√51i``."""
    terms = []
    for mask, part in number.terms().items():
        bits = [bit for bit in range(len(number.ring.roots)) if mask >> bit & 1]
        squares = [rational(number.ring.radicands[bit]) or Fraction(0) for bit in bits]
        root = prod((s for s in squares if s > 0), start=Fraction(1))
        behind = (f"√{root}" if root != 1 else "") + "i" * (
            len(squares) - sum(s > 0 for s in squares)
        )
        for value in part.values():
            many = str(abs(value)) if abs(value) != 1 or not behind else ""
            terms.append(("-" if value < 0 else "+") + many + behind)
    return "".join(terms).removeprefix("+") or "0"
