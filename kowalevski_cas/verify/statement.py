"""A claim under given texts: its goals, its problem, and what it rests on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.paper.addition import addition_theorems
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.generators import check_hypotheses
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.codec import digest
from kowalevski_cas.problem.evidence import At, Denial, Evidence
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Follows, Goal, Problem, simple
from kowalevski_cas.problem.prune import prune
from kowalevski_cas.problem.space import Meaningless, Setting, Space

Verdicts = tuple[Evidence, ...] | Denial
"""Evidence for every goal, or against one."""


class Statement:
    """What a claim says, or other goals on its scenes: a problem, and the legend to it.

    The ``legend`` tells of each space the scene that it comes from, which has the words for it: the
    names as they are printed, and the places. ``claimed`` are the goals over these scenes.

    Raises ``NotationError`` or ``Meaningless`` if it says nothing.
    """

    def __init__(
        self, claim: Claim, on: Elaborations, goals: tuple[Goal, ...] | None = None
    ) -> None:
        self.claim, self.on = claim, claim.settings(on)
        if goals is None:
            claimed = tuple(claim.goals(self.on))
            goals = (*claimed, *addition_theorems(claimed))
        self.claimed: tuple[Goal, ...] = goals
        if not self.claimed:  # all of them would hold
            raise Meaningless(f"{claim.id} states nothing")
        check_hypotheses(self.claimed)
        self.problem = prune(self.claimed)
        self.goals = self.problem.goals
        for setting in self.legend.values():
            _ = setting.finder  # a scene that contradicts itself is refused

    @property
    def name(self) -> str:
        """The name under which the problem is known."""
        return self.claim.id

    @cached_property
    def digest(self) -> str:
        """The digest of the problem."""
        return digest(self.problem)

    @cached_property
    def legend(self) -> dict[Setting, Elaboration]:
        """What the spaces of the problem are elaborations of, those behind a change too."""
        found: dict[Setting, Elaboration] = {}
        for claimed, goal in zip(self.claimed, self.goals, strict=True):
            for one, other in zip(simple(claimed), simple(goal), strict=True):
                setting, space = one.space, other.space
                while isinstance(setting, Elaboration):
                    found[space] = setting
                    if space.change is None or setting.source is None:
                        break
                    setting, space = setting.source, space.change.old
        return found

    @cached_property
    def stands_on(self) -> tuple[Printed, ...]:
        """The places of the paper on which the statement stands, its own first."""
        places = dict.fromkeys(self.claim.places())
        found = {**places}
        for space, setting in self.legend.items():
            steps = space.steps if isinstance(space, Space) else ()
            named = [place for step in steps for place in setting.places.get(step.name, ())]
            moving = [*setting.motion.places()] if space.field or space.change else []
            used = dict.fromkeys([*named, *moving])
            found |= used
            for place in places | used:
                found |= dict.fromkeys(setting.inlined_places(place))
        return tuple(found)

    def search(self) -> Verdicts | None:
        """Evidence for all goals or against one, with FLINT; ``None`` if it is not found."""
        return find_evidence(self.goals, self.claim.search(self.goals))

    def holds(self) -> bool:
        """Whether all goals can be proved; nobody looks for points where they fail."""
        from kowalevski_cas.search.find import Finder

        finder = Finder(finder_of)
        searched = self.claim.search(self.goals)
        return all(
            not _denies(goal, searched[place])
            if place in searched
            else finder.proof(goal) is not None
            for place, goal in enumerate(self.goals)
        )


@dataclass(frozen=True)
class Posed:
    """A problem by itself, under a name: nobody has to know of a claim that states it."""

    name: str
    problem: Problem

    @property
    def goals(self) -> tuple[Goal, ...]:
        """The goals of the problem."""
        return self.problem.goals

    @property
    def digest(self) -> str:
        """The digest of the problem."""
        return digest(self.problem)


def find_evidence(goals: Sequence[Goal], searched: Mapping[int, Evidence]) -> Verdicts | None:
    """Evidence for all goals or against one, with FLINT; ``None`` if it is not found.

    ``own`` is what another search has for some, by their places.
    """
    from kowalevski_cas.search.find import Finder  # most proofs are read, and search nothing

    finder = Finder(finder_of)
    found: list[Evidence] = []
    missing: list[int] = []
    for place, goal in enumerate(goals):
        evidence = searched.get(place)
        if evidence is not None and _denies(goal, evidence):
            return Denial(place, evidence)
        evidence = evidence or finder.proof(goal)
        if evidence is None:
            missing.append(place)
        else:
            found.append(evidence)
    # points are looked for last: most claims are true, and then none is found in a long search
    for place in missing:
        refutation = finder.refutation(goals[place])
        if refutation is not None:
            return Denial(place, refutation)
    return None if missing else tuple(found)


def _denies(goal: Goal, evidence: Evidence) -> bool:
    """Whether evidence of a search of its own is against a goal."""
    return type(goal) is Follows and isinstance(evidence, At)
