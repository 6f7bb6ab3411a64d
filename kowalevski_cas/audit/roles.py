"""What each place of a paper is for a derivation: claim, definition, vector field, condition."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field

from kowalevski_cas.notation import Formula, Name, NotationError, Relation
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.mentions import mentions

ORDER = ("unit", "vector field", "definition", "claim", "condition")


@dataclass
class PlaceRoles:
    """The roles of one place, the claims that are about it, and those of just this formula."""

    roles: set[str] = field(default_factory=set)
    defines: set[str] = field(default_factory=set)
    claims: dict[str, None] = field(default_factory=dict)
    own: dict[str, None] = field(default_factory=dict)

    @property
    def elsewhere(self) -> str:
        """The role of a place about which nothing is claimed where it stands.

        What is claimed of it with others only is considered there.
        """
        other = next((role for role in ORDER if role in self.roles - {"claim"}), "")
        return other or ("condition" if self.claims and not self.own else self.name)

    @property
    def name(self) -> str:
        """The role by which the place is called: what others rest on comes first."""
        return next((role for role in ORDER if role in self.roles), "none")


class Roles:
    """The roles of all places, by their public names."""

    def __init__(self, derivation: Derivation) -> None:
        self.places: dict[str, PlaceRoles] = {}
        for scene in derivation.scenes():
            for name, printed in scene.roles():
                self.at(printed.place).roles.add(name)
            for name, printed in scene.definitions.items():
                self.at(printed.place).defines.add(name)
            if isinstance(scene.field, Change):
                self.at(scene.field.time.place).defines.add(scene.time)
        for claim in derivation.claims:
            established = set(claim.establishes())
            for printed in established:
                role = self.at(printed.place)
                role.roles.add("claim")
                role.claims[claim.id] = None
                if printed == claim.printed:
                    role.own[claim.id] = None
            for printed in claim.places():
                if printed not in established:
                    self.at(printed.place).roles.add("condition")

    def at(self, place: str) -> PlaceRoles:
        """The role of a place, none if the derivation does not use it."""
        if place not in self.places:
            self.places[place] = PlaceRoles()
        return self.places[place]


def undefined_names(role: PlaceRoles, formula: Formula) -> list[str]:
    """The names that a place should define, and does not print as a member of its equation."""
    is_equality = isinstance(formula, Relation) and formula.is_equality
    members = formula.children() if is_equality else ()
    printed = {member.name for member in members if isinstance(member, Name)}
    return sorted(role.defines - printed)


def unused_constants(
    derivation: Derivation, before: Texts, after: Texts, printed: Printed
) -> list[str]:
    """The constants of scenes that nothing depends on, now that a place has lost them.

    There are none that can be told where a text cannot be read: it may depend on them.
    """
    found: dict[str, None] = {}
    with suppress(NotationError):
        gone = _names(before, printed) - _names(after, printed)
        for scene in derivation.scenes():
            places = set(scene.places)
            if printed in places:
                places.update(*(c.places() for c in derivation.claims if scene in c.scenes()))
                left = {name for place in places for name in _names(after, place)}
                found.update(dict.fromkeys(sorted(gone & set(scene.constants) - left)))
    return list(found)


def _names(texts: Texts, printed: Printed) -> set[str]:
    formula = texts.statement(printed).formula
    return {found.name for found in mentions(formula) if isinstance(found, Name)}
