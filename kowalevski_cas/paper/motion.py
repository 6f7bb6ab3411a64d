"""The motion on a scene: by its equations, or by those of another scene and a change."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from kowalevski_cas.notation import Formula, Name, Number, Quotient
from kowalevski_cas.paper.field import field
from kowalevski_cas.paper.inverse import inverse
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.partials import Partials
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.paper.validation import check_time
from kowalevski_cas.problem.space import ChangeOfVariables, EquationOfMotion, Meaningless


class LawOfMotion:
    """What the printed equations of motion say; with a change, that is the motion of the source."""

    def __init__(
        self,
        setting: Meaning,
        partials: Partials,
        source: Meaning | None = None,
        before: LawOfMotion | None = None,
    ) -> None:
        self.setting, self.partials, self.source, self.before = setting, partials, source, before
        self._inverses: dict[object, dict[str, Formula]] = {}
        """What was solved for changes from here."""
        self._is_solved = False
        """Whether the equations of motion are being solved."""

    @cached_property
    def field(self) -> tuple[EquationOfMotion, ...]:
        """The printed equations of motion, solved for the rates where they are not."""
        rows = self.setting.scene.field
        if self.setting.scene.unit is not None:
            _ = self.setting.finder  # it asks for the rates when made, for which conjugates wait
            if "field" in self.__dict__:
                found: tuple[EquationOfMotion, ...] = self.__dict__["field"]
                return found
        if self._is_solved:
            raise Meaningless("the equations of motion rest on rates that they have to give")
        self._is_solved = True
        try:
            if isinstance(rows, ChangeOfScene):
                return ()
            return tuple(field(self.setting, rows, self.partials))
        finally:
            self._is_solved = False

    @cached_property
    def change(self) -> ChangeOfVariables | None:
        """The change of variables that gives the field."""
        scene, source = self.setting.scene, self.source
        change = scene.field
        if not isinstance(change, ChangeOfScene):
            return None
        assert source is not None
        new: dict[str, Formula] = {}
        for printed in change.formulas:
            left, right = self.setting.texts.sides(printed)
            if not isinstance(left, Name):
                raise Meaningless(f"the formula at {printed.place} gives no variable")
            new[left.name] = source.plain(right)
        old_names = (*scene.variables, *scene.definitions)
        formulas = [
            *((n, f) for n, f in new.items() if n in old_names),
            *((n, Name(n)) for n in old_names if n in source.variables and n not in new),
        ]
        check_time(source, change.time)
        time = source.plain(self.setting.texts.time_change(change.time).rate)
        return ChangeOfVariables(source, tuple(formulas), Quotient(Number(1), time))

    @cached_property
    def inverse(self) -> dict[str, Formula]:
        """The old variables of a change through the new ones; solved for once a change."""
        assert self.source is not None and self.before is not None
        known, change = self.before._inverses, self.setting.scene.field
        if change not in known:
            assert self.change is not None
            known[change] = inverse(self.source, self.change.formulas)
        return known[change]

    def places(self) -> Iterator[Printed]:
        """The places on which every derivative rests."""
        scene = self.setting.scene
        if isinstance(scene.field, ChangeOfScene):
            assert self.before is not None
            yield from (*scene.field.formulas, scene.field.time)
            yield from self.before.places()
        else:
            yield from scene.field
        yield from scene.zero
