"""What defines a name of a scene; each gets its meaning when it is first asked for, once."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Product,
    Quotient,
    Relation,
    Root,
    Vector,
)
from kowalevski_cas.paper.components import component
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.motion import LawOfMotion
from kowalevski_cas.paper.names import head, is_bold
from kowalevski_cas.paper.roots import solve_for_root
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.mentions import mentions
from kowalevski_cas.problem.space import Adjoined, Let, Meaningless, Raised, Step


class Definitions:
    """The definitions of names: by what the scene says, by its motion, by functions and powers."""

    def __init__(self, setting: Meaning, motion: LawOfMotion) -> None:
        self.setting, self.motion = setting, motion
        self._powers = {f"{b}^{{{e}}}": (b, e) for b, e in setting.scene.powers}
        self._steps: dict[str, Step | None] = {}
        self._open: list[str] = []
        """The names that are being defined, each by the next."""

    def step(self, name: str) -> Step | None:
        """What defines a name; raises :class:`Meaningless` if nothing does."""
        if name not in self._steps:
            if name in self._open:
                raise Meaningless(f"{name} is defined by itself", name)
            self._open.append(name)
            try:
                self._steps[name] = self._define(name)
            finally:
                self._open.pop()
        return self._steps[name]

    @contextmanager
    def anew(self) -> Iterator[None]:
        """Let names be defined while others are: what is being defined may stand under a root."""
        opened, self._open = self._open, []
        try:
            yield
        finally:
            self._open = opened

    def _define(self, name: str) -> Step | None:
        scene = self.setting.scene
        if name in self.setting.variables or name in self.setting.constants:
            return None
        if name == "i" and "i" in self.setting.roots:
            return self._unit()
        if name in self.setting.roots:
            return self._root(name)
        if name in self._powers:
            base, exponent = self._powers[name]
            if exponent not in self.setting.constants:
                raise Meaningless(f"{exponent} is an exponent here, and has a value", exponent)
            return Raised(name, Name(base), exponent)
        if name in self.setting.zero:
            return self._let(name, Number(0), *scene.zero)
        if name in self.setting.radicals:
            return self._let(name, self.setting.radicals.value(name))
        return self._definition_of(name)

    def _definition_of(self, name: str) -> Let:
        """What a name stands for."""
        scene = self.setting.scene
        if name in self.setting.transcendental.derived:
            return self._let(name, self.setting.transcendental.derived[name].formula)
        if (whole := self._head(name)) is not None:
            return self._let(name, self.definition(whole), scene.definitions[whole])
        if name in scene.vectors:
            return self._let(name, Vector(tuple(Name(c) for c in scene.vectors[name])))
        if (place := scene.component(name)) is not None:
            vector, index = place
            formula = component(Name(vector), index, self.setting)
            return self._let(name, formula, scene.definitions[vector])
        if self.motion.source is not None and name in self.motion.inverse:
            assert isinstance(scene.field, ChangeOfScene)
            return self._let(name, self.motion.inverse[name], *scene.field.formulas)
        raise self._without_meaning(name)

    def _without_meaning(self, name: str) -> Meaningless:
        what = f"{name} has no meaning on the scene “{self.setting.scene.name}”"
        if name in self.setting.transcendental:
            what = f"{name} stands under functions: by itself it is not known here"
        return Meaningless(what, name)

    def _head(self, name: str) -> str | None:
        """The head in which a name has variables for arguments, as H has in H(q,p)."""
        heads = (
            definition
            for definition in self.setting.scene.definitions
            if head(definition)[0] == name
        )
        return next(filter(self.setting.scene.of_variables, heads), None)

    def _let(self, name: str, formula: Formula, *places: Printed) -> Let:
        self.setting.places[name] = places
        let = Let(name, self.setting.plain(formula))
        for other in mentions(let.formula):  # vectors stay as they are, and may run in a circle
            if (
                isinstance(other, Name)
                and (is_bold(other.name) or other.name in self.setting.scene.vectors)
                and other.name in self.setting.scene.definitions
            ):
                self.setting.step(other.name)
        return let

    def _unit(self) -> Step | None:
        printed = self.setting.scene.unit
        if printed is None:
            source = self.motion.source
            assert source is not None
            step = source.step("i")
            self.setting.places["i"] = source.places.get("i", ())
            return step
        return solve_for_root(self.setting, "i", printed)

    def _root(self, name: str) -> Step:
        if name in self.setting.transcendental.roots:
            self.setting.places[name] = ()
            return Adjoined(
                name, self.setting.plain(self.setting.transcendental.roots[name].square)
            )
        printed = self.setting.scene.roots.get(name)
        if printed is not None:
            return solve_for_root(self.setting, name, printed)
        root = self.setting.texts.expression(name)
        if not isinstance(root, Root):
            raise Meaningless(f"{name} is not printed as a square root", name)
        self.setting.places[name] = ()
        return Adjoined(name, self._without_rates(self.setting.plain(root.argument)))

    def _without_rates(self, radicand: Formula) -> Formula:
        """What stands under a root by what moves: roots are adjoined before anything has a rate."""
        if not any(isinstance(one, Derivative) for one in mentions(radicand)):
            return radicand
        return formula_in(self.setting.finder.scalar(radicand))

    def definition(self, name: str) -> Formula:
        """The expression for which a name stands.

        It is the first member of the printed chain that is not a bare name, or
        else another name, that stands for nothing; a formula that is no equation is the expression
        itself.
        """
        printed = self.setting.scene.definitions.get(name) or self.setting.scene.roots.get(name)
        if printed is None:
            raise Meaningless(f"nothing defines {name}", name)
        formula = self.setting.texts.formula(printed)
        members = formula.members if isinstance(formula, Relation) else (formula,)
        own = self.setting.texts.expression(name)
        others = [m for m in members if m != own and not isinstance(m, Constant)]
        if isinstance(own, PoissonBracket):  # those of a chain have their common value
            others = [m for m in others if not isinstance(m, PoissonBracket)] or others
        for one in others:
            match one:
                case Product((Number() as factor, multiple)) if multiple == own:
                    rest = next((other for other in others if other != one), Number(0))
                    return Quotient(rest, factor)
                case Negative(opposite) if opposite == own:
                    return Negative(next((o for o in others if o != one), Number(0)))
        if not others or (name in printed.heads.names and own not in members):
            raise Meaningless(f"no expression stands for {name} in its definition", name)
        given = (m for m in others if getattr(m, "name", "") not in self.setting.scene.definitions)
        return next((m for m in others if not isinstance(m, Name)), next(given, others[0]))


def zero_names(scene: Scene, texts: Texts) -> Iterator[str]:
    """The names of what a scene sets to zero."""
    for printed in scene.zero:
        members = texts.relation(printed).members
        names = [member.name for member in members if isinstance(member, Name)]
        if members.count(Number(0)) != 1 or len(names) != len(members) - 1:
            raise Meaningless(f"the equation at {printed.place} does not set names to zero")
        for name in names:
            yield from scene.vectors.get(name, (name,))
