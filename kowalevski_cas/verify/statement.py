"""A claim under given texts: its goals, its problem, and what it rests on."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from kowalevski_cas.paper.addition import addition_theorems
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborate import Elaboration, finder_of
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.generators import check_hypotheses
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.codec import digest
from kowalevski_cas.problem.evidence import At, Denial, Evidence
from kowalevski_cas.problem.goals import Follows, Goal, simple
from kowalevski_cas.problem.prune import pruned
from kowalevski_cas.problem.space import Meaningless, Setting, Space, generators

Verdicts = tuple[Evidence, ...] | Denial
"""Evidence for every goal, or against one."""


class Statement:
    """What a claim says, or other ``goals`` in its settings.

    Raises ``NotationError`` or ``Meaningless`` if it says nothing.
    """

    def __init__(
        self, claim: Claim, on: Elaborations, goals: tuple[Goal, ...] | None = None
    ) -> None:
        self.claim, self.on = claim, claim.settings(on)
        if goals is None:
            own = tuple(claim.goals(self.on))
            goals = (*own, *addition_theorems(own))
        self.goals: tuple[Goal, ...] = goals
        if not self.goals:  # all of them would hold
            raise Meaningless(f"{claim.id} states nothing")
        check_hypotheses(self.goals)
        self.problem = pruned(self.goals)

    @cached_property
    def digest(self) -> str:
        """The digest of the problem."""
        return digest(self.problem)

    @cached_property
    def spaces(self) -> dict[Elaboration, Space]:
        """What is reached of each setting."""
        found: dict[Elaboration, Space] = {}
        for goal, small in zip(self.goals, self.problem.goals, strict=True):
            for one, other in zip(simple(goal), simple(small), strict=True):
                setting, space = one.space, other.space
                while isinstance(setting, Elaboration) and isinstance(space, Space):
                    found[setting] = space
                    if space.change is None or setting.source is None:
                        break
                    setting, space = setting.source, space.change.old
        return found

    def names(self, setting: Setting) -> Sequence[str]:
        """The names to which a point of a setting gives values."""
        space = self.spaces[setting] if isinstance(setting, Elaboration) else setting
        return (*generators(space), *space.roots)

    @cached_property
    def stands_on(self) -> tuple[Printed, ...]:
        """The places of the paper on which the statement stands, its own first."""
        own = dict.fromkeys(self.claim.places())
        found = {**own}
        for setting, space in self.spaces.items():
            named = [place for step in space.steps for place in setting.places.get(step.name, ())]
            moving = [*setting.motion_places()] if space.field or space.change else []
            used = dict.fromkeys([*named, *moving])
            found |= used
            for place in own | used:
                found |= dict.fromkeys(setting.written_out(place))
        return tuple(found)

    def search(self) -> Verdicts | None:
        """Evidence for all goals or against one, with FLINT; ``None`` if it is not found."""
        from kowalevski_cas.search.find import Finder  # most proofs are read, and search nothing

        finder = Finder(finder_of, self.names)
        own = self.claim.search(self.goals, self.on, self.names)
        found: list[Evidence] = []
        missing: list[int] = []
        for place, goal in enumerate(self.goals):
            evidence = own.get(place)
            if evidence is not None and _denies(goal, evidence):
                return Denial(place, evidence)
            evidence = evidence or finder.proof(goal)
            if evidence is None:
                missing.append(place)
            else:
                found.append(evidence)
        for place in missing:
            refutation = finder.refutation(self.goals[place])
            if refutation is not None:
                return Denial(place, refutation)
        return None if missing else tuple(found)

    def holds(self) -> bool:
        """Whether all goals can be proved; nobody looks for points where they fail."""
        from kowalevski_cas.search.find import Finder

        finder = Finder(finder_of, self.names)
        own = self.claim.search(self.goals, self.on, self.names)
        return all(
            not _denies(goal, own[place]) if place in own else finder.proof(goal) is not None
            for place, goal in enumerate(self.goals)
        )


def _denies(goal: Goal, evidence: Evidence) -> bool:
    """Whether evidence of a search of its own is against a goal."""
    return type(goal) is Follows and isinstance(evidence, At)
