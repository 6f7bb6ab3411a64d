"""What every kind of claim has in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any, NamedTuple, dataclass_transform

from kowalevski_cas.notation import Edit, Formula, NotationError, Relation, Root, edits, to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts, check_attributes
from kowalevski_cas.problem.evidence import Denial, Evidence
from kowalevski_cas.problem.goals import Goal
from kowalevski_cas.problem.space import Meaningless


class Neighbour(NamedTuple):
    """A statement that differs a little: a mutant, or a candidate for a correction.

    It is that of a claim under texts in which, with an ``edit``, the formula at the place
    ``printed`` is changed.
    """

    words: str
    claim: Claim
    base: Texts
    printed: Printed | None = None
    edit: Edit | None = None

    @property
    def texts(self) -> Texts:
        """The texts under which the claim says what the neighbour does."""
        if self.edit is None or self.printed is None:
            return self.base
        return self.base.with_edit(self.printed, self.edit)


@dataclass_transform(eq_default=False, frozen_default=True, field_specifiers=(field,))
class _Kind:
    """A dataclass of the attributes that a kind declares; no type checker lets them be changed."""

    def __init_subclass__(cls, kw_only: bool = False) -> None:
        dataclass(eq=False, repr=False, kw_only=kw_only)(cls)

    def is_kind(self, *names: str) -> bool:
        """Whether it is of one of these kinds; none of them is loaded for this."""
        return any(kind.__name__ in names for kind in type(self).__mro__)

    @cached_property
    def _stands_on(self) -> list[Printed | Scene]:
        """The attributes, and what is in tuples and in claims that are attributes, in its order."""
        return [*_places_and_scenes(vars(self).values())]


def _places_and_scenes(values: Iterable[object]) -> Iterator[Printed | Scene]:
    for value in values:
        if isinstance(value, Printed | Scene):
            yield value
        elif isinstance(value, tuple):
            yield from _places_and_scenes(value)
        elif isinstance(value, _Kind):
            yield from value._stands_on


class Claim(_Kind, ABC):
    """One statement of the paper, on its scene.

    ``printed`` is the place of the formula, if the claim is one formula;
    ``words`` says what is claimed, and ``sentence`` is the author's sentence that claims it, word
    for word, where the formula alone does not. A claim that the paper does not make is ``ours``.
    Whatever else a claim is about, its places, scenes and neighbours, follows from the types of its
    attributes. A kind is a subclass with more attributes.
    """

    id: str
    scene: Scene
    printed: Printed | None = field(default=None, kw_only=True)
    words: str
    sentence: str = field(default="", kw_only=True)
    ours: bool = field(default=False, kw_only=True)

    def __post_init__(self) -> None:
        """Refuse displays and single values where tuples are expected."""
        check_attributes(self, f"the claim {self.id}")

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.id}>"

    @property
    def own(self) -> Printed:
        """The place of the one formula; raises :class:`Meaningless` if there is none."""
        if self.printed is None:
            raise Meaningless("the claim is about a formula, and names none")
        return self.printed

    def settings(self, on: Elaborations) -> Elaborations:
        """The settings of scenes, in which the functions of the claim's formulas are known."""
        met: list[Formula] = []
        for place in dict.fromkeys(self.places()):
            with suppress(NotationError):
                met.append(on.texts.formula(place))
        return on.meeting(tuple(met))

    @abstractmethod
    def goals(self, on: Elaborations) -> Iterator[Goal]:
        """What is stated, in the settings that the scenes mean."""

    def search(self, goals: Sequence[Goal]) -> Mapping[int, Evidence]:
        """Evidence for or against goals, by their places, where the kind has a search of its own.

        They are those of the problem, over plain spaces; it is made with FLINT.
        """
        return {}

    def remark(self, on: Elaborations) -> str:
        """What is told of the claim where it is proved."""
        return ""

    def refuted_by(self, denial: Denial) -> bool:
        """Whether what denies a goal denies the claim; a goal may be more than what is claimed."""
        return True

    def places(self) -> Iterator[Printed]:
        """The places of the paper that the claim names, its own first; not those of its scenes."""
        yield from (object for object in self._stands_on if isinstance(object, Printed))

    def scenes(self) -> Iterator[Scene]:
        """The scenes on which the claim stands."""
        yield from (object for object in self._stands_on if isinstance(object, Scene))

    def reads(self) -> frozenset[Printed]:
        """Every place on which a verdict can depend: those that it names, and of its scenes."""
        return frozenset(self.places()).union(*(scene.places for scene in self.scenes()))

    def establishes(self) -> Iterator[Printed]:
        """The places that are right if the claim is."""
        if self.printed is not None:
            yield self.printed

    def about(self) -> Iterator[Printed]:
        """The places that the claim reads as they are printed, whatever the derivation accepts."""
        yield from self.establishes()

    def shown(self) -> tuple[Printed, ...]:
        """The places of the formulas of the claim."""
        return tuple(self.establishes()) or tuple(filter(None, [self.printed]))

    def formulas(self, texts: Texts) -> tuple[Formula, ...]:
        """The formulas of the claim, as the paper prints them."""
        return tuple(map(texts.as_printed, self.shown()))

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        """Statements one edit away, the most plausible corrections first.

        Of edits, only those are needed that may lead to a formula that is ``wanted``.
        """
        names = frozenset(self.scene.names()) - {*self.scene.undefined}
        for printed in self.establishes():
            statement = texts.statement(printed)
            given = {name for name, by in self.scene.definitions.items() if by == printed}
            for edit in edits(statement, texts.vocabulary, names, wanted):
                before, after = (_defined(one.formula, given) for one in (statement, edit))
                if not given or before == after:
                    yield self.edited(texts, printed, edit)
        for attribute in fields(self):
            value = getattr(self, attribute.name)
            # not isinstance: a bool is an int too, and no number to be misprinted
            if type(value) is int:
                for number in dict.fromkeys((value - 1, value + 1, 2 * value)):
                    words = f"{attribute.name} {number} instead of {value}"
                    changed: dict[str, Any] = {attribute.name: number}
                    yield Neighbour(words, replace(self, **changed), texts)

    def edited(self, texts: Texts, printed: Printed, edit: Edit) -> Neighbour:
        """The claim under an edit of a place, on a scene with the roots that the edit prints."""
        before, scene = {*edit.statement.formula.nodes()}, self.scene
        for node in edit.formula.nodes():
            if isinstance(node, Root) and node not in before:
                with suppress(ValueError):  # it is known
                    scene = scene.adjoining(to_latex(node))
        claim = self if scene is self.scene else replace(self, scene=scene)
        return Neighbour(edit.words, claim, texts, printed, edit)


def _defined(formula: Formula, given: Collection[str]) -> Formula:
    """What a definition of names defines: it stays, and is no slip of what is defined."""
    members = formula.members if isinstance(formula, Relation) else (formula,)
    alone = (member for member in members if (names := {*member.names()}) and names <= {*given})
    return next(alone, members[0])
