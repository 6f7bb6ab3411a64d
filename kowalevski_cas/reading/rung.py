"""A rung of a ladder: a claim that a statement may make, and on what it would rest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from kowalevski_cas.paper.claims import Claim, RestPoints
from kowalevski_cas.paper.claims.maps import OF_MAPS
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.reading.hypotheses import sets_in_force
from kowalevski_cas.reading.jets import refuse_of_functions
from kowalevski_cas.reading.known import FUNCTION, NORMALISED
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.stage import Stage, Supposed
from kowalevski_cas.reading.statements import SourceStatement


@dataclass(frozen=True)
class Rung:
    """A claim that a statement may make, and the statements on which it would rest."""

    claim: Claim
    on: tuple[SourceStatement, ...]
    constants: tuple[str, ...]
    given: tuple[SourceStatement, ...] = ()
    """Those of them that hold on a part of the phase space only."""
    in_force: bool = False
    """Whether these are what is supposed there, and no more."""
    idle: Claim | None = None
    """That nothing moves where these hold: then what is said of rates there says nothing."""
    is_stronger: bool = False
    """Whether it says more than the statement: where it fails nothing is said of that."""
    elsewhere: bool = False
    """Whether it rests on what is supposed in other places only: it is not claimed so."""


class RungMaker:
    """A statement of which rungs are made, on its stage."""

    def __init__(self, item: SourceStatement, id: str, stage: Stage) -> None:
        self.item, self.id, self.stage, self.known = item, id, stage, stage.known
        self.role = self.known.roles[item]
        self.supposed = stage.understood(self.known.supposed(item))

    def ways(self) -> list[list[SourceStatement]]:
        """Without assumptions, and with those in force; what is not zero is never left aside."""
        kept = [
            one
            for one in self.supposed
            if self.known.roles[one].kind == "inequality" or self._is_needed(one)
        ]
        return [kept, self.supposed] if len(kept) < len(self.supposed) else [kept]

    def suppositions(self) -> list[list[SourceStatement]]:
        """The assumptions with which a claim is tried: those in force, and fewer.

        Where the statement itself has a constant that is specialised, it may be meant in general.
        """
        kept = [
            one
            for one in self.supposed
            if not {*self.known.roles[one].names} & self.item.names or self._is_needed(one)
        ]
        return [kept, self.supposed] if len(kept) < len(self.supposed) else [self.supposed]

    def _leaves_velocities(self, on: Sequence[SourceStatement]) -> bool:
        """Whether something has an equation of the second order, and its rate is not given there.

        A point of rest has velocities that vanish; where they need not vanish, something moves.
        """
        rates = [row.rates for law in self.known.laws for row in law.rows]
        moving = {name for own in rates for name, order in own.items() if order > 1}
        given = {name for one in on for name, order in one.rates.items() if order == 1}
        scalars = self.known.names.scalars
        return bool({*scalars(moving)} - {*scalars(given)})

    def _is_of_all_motion(self, one: SourceStatement) -> bool:
        """Whether what is given is a constraint, or a normalisation of the motion."""
        role = self.known.roles.get(one)
        return one in self.known.bound or (role is not None and role.kind == NORMALISED)

    def _is_needed(self, assumption: SourceStatement) -> bool:
        """Whether it gives a function of which nothing says on what it depends else."""
        role = self.known.roles[assumption]
        any_values = self.known.functions
        return role.kind.startswith(FUNCTION) and any_values.keys().isdisjoint(role.names)

    def rung(
        self,
        kind: type[Claim],
        says: str,
        assumptions: Sequence[SourceStatement],
        on: Sequence[SourceStatement] = (),
        items: Sequence[SourceStatement] = (),
        law: Law | None = None,
        **attributes: object,
    ) -> Rung:
        own = [*(items or (self.item,)), *on]
        found: Supposed = self.stage.scene(own, assumptions, law)
        if "relations" not in attributes:
            attributes.setdefault("printed", self.item.printed)
        if found.images and kind in OF_MAPS:
            if attributes.get("given"):
                raise ValueError("an invariant of a map on a set is not known")
            kind, attributes["images"] = OF_MAPS[kind], found.images
        claim = claim_of_kind(kind, self.id, found.scene, says, attributes)
        in_force = bool(on) and (*on,) == sets_in_force(self.item, self.known)
        idle = None
        if (
            not found.images
            and any(not self._is_of_all_motion(one) for one in on)
            and not self._leaves_velocities(on)
            and (self.item.derives or self.role.kind == "integral")
        ):
            idle = RestPoints(self.id, found.scene, "", relations=places(on))
        return Rung(claim, (*found.assumptions, *on), found.constants, (*on,), in_force, idle)


def claim_of_kind(
    kind: type[Claim], id: str, scene: Scene, words: str, attributes: Mapping[str, object]
) -> Claim:
    """A claim of a kind with its attributes.

    Raises ``ValueError`` where functions of its scene may be any, and this kind does not know them.
    """
    refuse_of_functions(kind, attributes, scene)
    return kind(id, scene, words, **attributes)  # type: ignore[arg-type] # each kind has its own


def stronger(rung: Rung) -> Rung:
    """A claim that says more than its statement."""
    return replace(rung, is_stronger=True)


def places(items: Sequence[SourceStatement]) -> tuple[Printed, ...]:
    """Where some statements are printed."""
    return tuple(item.printed for item in items)
