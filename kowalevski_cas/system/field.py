"""Equations of motion, what is defined beside them, and how something is stated of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from copy import copy
from dataclasses import replace
from functools import partial
from typing import Any, Self

from kowalevski_cas.library import MADE
from kowalevski_cas.notation import (
    Formula,
    NotationError,
    read,
    read_display,
    split_display,
    to_plain,
)
from kowalevski_cas.paper.claims import Casimir, Claim, FirstIntegral, Identity
from kowalevski_cas.paper.claims.maps import InvariantOfMap
from kowalevski_cas.paper.derivation import Section
from kowalevski_cas.paper.relations import real_ways, solve_for_constant
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import IN_WORDS, Display, Printed
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Contradictory
from kowalevski_cas.system.answers import ClaimInParts, Function, SystemClaim, in_html
from kowalevski_cas.system.cases import LawOfCase, laws_by_cases
from kowalevski_cas.system.kinds import BY_CASES, Stated, stated_of
from kowalevski_cas.system.numbering import Numbering
from kowalevski_cas.system.printed_law import brackets, read_law
from kowalevski_cas.system.refused import check_constant, check_field, check_possible, names_of
from kowalevski_cas.system.roots import with_roots, with_roots_at_images, with_signs_of_moduli
from kowalevski_cas.system.scenes import restrict, with_lengths, with_levels, with_parameters
from kowalevski_cas.system.signs import SIGNS, alternatives, has_both_signs, with_signs
from kowalevski_cas.system.solved import (
    gives_constant,
    simple_relations,
    speaks_of_constants,
    with_new_names,
)
from kowalevski_cas.system.symbols import latex_of
from kowalevski_cas.system.units import with_units
from kowalevski_cas.verify.finding import Finding
from kowalevski_cas.verify.outcome import Verdict, in_latex

OF_MODULI = (FirstIntegral, Identity, InvariantOfMap)
"""What is claimed of absolute values: no inequality, which says itself what is not negative."""

Tex = Any
"""A formula: LaTeX, what was defined, or an expression of SymPy."""

Texs = Any
"""A formula, or a tuple or a list of formulas."""


class Field:
    """A vector field, printed as equations of motion, and the scene of what is said of it."""

    seconds = 60.0
    """For each verdict that is asked for in Python, and for each question.

    How long a command such as ``verify`` may take is for whoever runs it to say: ``--timeout``.
    """

    def __init__(
        self,
        field: str | Mapping[Any, Any],
        name: str = "",
        vectors: Mapping[str, tuple[str, ...]] | None = None,
        map: bool = False,
    ) -> None:
        self.symbols: dict[str, Any] = {}
        """The symbols of SymPy in which the system is written, by their names here."""
        self.special: tuple[Display, ...] = ()
        """What is supposed of the constants."""
        self.signs: dict[str, str] = {}
        """Those that stand here for the upper signs, if it is a system for one of them."""
        self.parts: tuple[Self, ...] = ()
        """The systems for both signs, or by cases, of which what is claimed is claimed."""
        self.section = Section(name or "1", "", copied=None)
        MADE.append(self.section)
        self.numbering = Numbering(self.section, f"{name}-" if name else "")
        laws = laws_by_cases(field) if isinstance(field, str) else ()
        self.by_cases = bool(laws)
        """Whether the equations of motion are printed by cases, of which a motion may leave one."""
        for equations, _ in laws[::-1] or [(field, ())]:
            self._take(equations, name, vectors or {}, map)
        self._take_cases(laws, name, vectors or {}, map)

    def _take_cases(
        self,
        laws: Iterable[LawOfCase],
        name: str,
        vectors: Mapping[str, tuple[str, ...]],
        map: bool,
    ) -> Self:
        """The system itself, with those by cases: equations where their inequalities hold."""
        parts = []
        for law in laws:
            part = copy(self)
            part._take(law.equations, name, vectors, map)
            for condition in law.conditions:
                part = part.supposing(condition)
            parts.append(part)
        self.parts = (*parts,)
        return self

    def _take(
        self,
        field: str | Mapping[Any, Any],
        name: str,
        vectors: Mapping[str, tuple[str, ...]],
        map: bool,
    ) -> None:
        """Stand on the scene of equations of motion, or of a map."""

        def place(tex: str) -> Display:
            return self.numbering.display(f"{self.numbering.prefix}field", tex)

        self.law = read_law(field, name, vectors, map, self.symbols, place)
        self._stand_on(self.law.scene)
        for equality in self.law.equalities:
            self._check_equal(*equality)
        check_field(self.scene)
        self.section.title = self._echo("${}$".format)

    def _check_equal(self, left: str, right: str) -> None:
        """Raise ``ValueError`` if the members of a chain are not seen to be equal."""
        says = "both sides are the same function"
        claim = self._aside().states(Identity, "chain", says, printed=f"{left}={right}")
        if not claim.verdict.green:
            raise ValueError(f"{left} and {right} are not seen to be equal: leave one of them out")

    def _aside(self) -> Self:
        """The system, of which something is asked that is claimed nowhere."""
        aside = copy(self)
        aside.section = Section("1", "", copied=None, scenes={**self.section.scenes})
        aside.numbering = replace(self.numbering, section=aside.section)
        aside.parts = (*(part._aside() for part in self.parts),)
        return aside

    def _each(self, change: Callable[[Self], Self]) -> Self:
        """What becomes of the system, and of its parts."""
        alone = copy(self)
        alone.parts = ()
        whole = change(alone)
        whole.parts = (*map(change, self.parts),)
        return whole

    def __repr__(self) -> str:
        return self._summary(to_plain)

    def _repr_latex_(self) -> str:
        return f"${in_latex(self._formulas(self.section.displays[0]))}$"

    def _repr_html_(self) -> str:
        equations = self._formulas(self.section.displays[0])
        return f"<p>{', '.join(map(in_html, equations))}; {self._summary(in_html)}</p>"

    def _summary(self, shown: Callable[[Formula], str]) -> str:
        """What moves, what is constant, and what is special, in words."""
        echo = self._echo(lambda name: shown(self.read(name)))
        special = " or ".join(
            ", ".join(shown(formula) for one in part.special for formula in self._formulas(one))
            for part in self.parts or [self]
        )
        return f"{echo}; {special}" if special else echo

    def _echo(self, shown: Callable[[str], str]) -> str:
        """What moves, or is mapped, and what does not, in words."""
        jets, fixed = {name for name, _, _ in self.scene.jets}, self.scene.constants
        names = [name for name in self.scene.variables if name not in jets]
        one = len(names) < 2
        moves = ("is mapped" if one else "are mapped") if self.law.images else f"move{'s' * one}"
        still = f"{', '.join(map(shown, fixed))} {'are' if len(fixed) > 1 else 'is'} constant"
        moving = f"{', '.join(map(shown, names))} {moves}"
        any_ = [
            f"{shown(one.name)} is any function of {', '.join(map(shown, one.by))}"
            for one in self.law.conventions.functions
        ]
        return "; ".join([moving, *([still] if fixed else []), *any_])

    # -- scenes ------------------------------------------------------------------

    def _stand_on(self, scene: Scene) -> None:
        """Take this scene for what is said from here on."""
        self.scene = self.section.scenes[scene.name] = scene

    def define(self, formula: Tex) -> Function:
        r"""A name for what is printed, as in ``F=x^2-z``; what is derived from here knows it too.

        A matrix has a bold capital, ``{\bf L}=\begin{pmatrix}…\end{pmatrix}``; the Poisson bracket
        is defined by those of the variables that do not vanish, ``\{x,y\}=z``. Of several names in
        a display the first is returned.

        Raises:
            NotationError: it cannot be read.
            ValueError: it defines no new name.
        """
        tex = self._tex(formula)
        display = self.numbering.display(self.numbering.id("", tex), tex)
        if not [*display]:
            raise ValueError(f"“{tex}” defines no name")
        self.parts = tuple(copy(part) for part in self.parts)
        self._defining(display)
        for part in self.parts:
            part._defining(display)
        heads, formula = display[1].heads, self._formulas(display)[0]
        name = (*heads.names, *heads.multiples)[0]
        return Function(display[1], name, formula, self.symbols)

    def _defining(self, display: Display) -> None:
        """Stand on the scene with what a display defines."""
        scene = with_parameters(self.scene, display)
        if any(brackets(name for statement in display for name in statement.heads.names)):
            # What is printed of a bracket is all of it: none that is implied stands beside.
            left = {n: one for n, one in scene.definitions.items() if n not in self.law.implied}
            scene, self.law = (
                replace(scene, definitions=left),
                replace(self.law, implied=frozenset()),
            )
        self._stand_on(with_roots(with_units(scene, display).defining(display), display))

    def where(self, *relations: Tex) -> Self:
        r"""The system for special constants: ``a+b=2c``, ``r^2=x^2+y^2``, ``\sigma\ne0``.

        Raises:
            NotationError: a relation cannot be read.
            ValueError: a relation gives no constant, or gives it by what moves.
        """
        if self.parts:
            return self._in_each(
                partial(one.where, *with_signs(relations, one.signs)) for one in self.parts
            )
        if has_both_signs(relations):
            return self._with_both_signs(relations)
        special, said = copy(self), ", ".join(map(self._tex, relations))
        special.scene = self.scene.called(f"{self.scene.name} where {said}")
        simple = [one for tex in relations for one in simple_relations(self._tex(tex), self.scene)]
        for k, tex in enumerate(simple):
            scene = with_new_names(tex, special.scene)
            ways: list[tuple[str, ...]] = [(tex,)]
            with suppress(NotationError):  # of an unknown name it is said below what to do
                ways = real_ways(tex, with_roots(scene, Display("", tex, "")))
            if not ways:
                raise Contradictory(f"{tex}: no real constants obey this beside what is supposed")
            if len(ways) > 1:
                rest = simple[k + 1 :]
                return self._in_each(partial(special.where, *way, *rest) for way in ways)
            for one in ways[0]:
                special._specialize(one, scene)
                scene = special.scene
        special._stand_on(special.scene)
        return special

    def _specialize(self, tex: str, scene: Scene) -> None:
        """Stand on a scene where a relation of constants holds, solved for one if it gives none."""
        if speaks_of_constants(tex, scene) and not gives_constant(tex, scene):
            rooted = with_roots(scene, Display("", tex, ""))
            solved, below = solve_for_constant(tex, rooted)
            tex, scene = solved or tex, scene.having(nonzero=below)
        place = self._place("where", tex, IN_WORDS)
        constants = scene.constants
        scene = with_roots(restrict(scene, place), place.display)
        check_constant(scene, place, constants)
        self.scene, self.special = scene, (*self.special, place.display)

    def _with_both_signs(self, relations: tuple[Tex, ...]) -> Self:
        """The systems for the upper and for the lower signs: what is claimed is so for both."""
        return self._in_each(partial(self._with_signs, relations, signs) for signs in SIGNS)

    def _with_signs(self, relations: tuple[Tex, ...], signs: dict[str, str]) -> Self:
        """The system for one of both signs."""
        part = self.where(*with_signs(relations, signs))
        part.signs = signs
        return part

    def _in_each(self, cases: Iterable[Callable[[], Self]]) -> Self:
        """A system of which is claimed what is claimed in each case, if it is not seen to be none.

        Raises :class:`Contradictory` if all contradict what is supposed.
        """
        parts, error = list[Self](), None
        for case in cases:
            try:
                part = case()
                if not part.parts:
                    check_possible(part.scene)
                parts.append(part)
            except Contradictory as contradiction:
                error = contradiction
        if error and not parts:
            raise error
        if len(parts) == 1 and not parts[0].signs:
            return parts[0]
        whole = copy(parts[0])
        whole.signs, whole.parts = {}, (*parts,)
        return whole

    def supposing(self, inequality: str) -> Self:
        """The system where an inequality holds, also one of what moves: a claim is made there."""
        if self.parts:
            return self._each(lambda one: one.supposing(with_signs(inequality, one.signs)))
        there, place = copy(self), self._place("where", inequality, IN_WORDS)
        scene = with_roots(self.scene, place.display).assuming(place)
        there._stand_on(scene.called(f"{self.scene.name} where {inequality}"))
        there.special = (*self.special, place.display)
        return there

    def having(self, *constants: str) -> Self:
        r"""The system with more constants, as ``\rho``, which stand in no equation of motion.

        Raises:
            ValueError: one is no name, or has a meaning already.
        """
        if self.parts:
            return self._each(lambda one: one.having(*constants))
        more, names = copy(self), (*names_of(constants, self.scene.time),)
        scene = self.scene.having(constants=names)
        more._stand_on(scene.called(f"{scene.name} with {', '.join(constants)}"))
        return more

    # -- claims ------------------------------------------------------------------

    def states(
        self,
        kind: type[Claim],
        name: str,
        says: str,
        expect: str = "",
        printed: Tex = "",
        **attributes: Any,
    ) -> SystemClaim:
        """A claim of any kind, called after the name and its first formula.

        Formulas, and tuples of them, are taken for what the kind expects at these attributes;
        numbers stay what they are.

        Raises:
            NotationError: a formula is broken TeX.
            ValueError: a formula is several, or there is no such verdict to expect.
        """
        if self.parts or has_both_signs((printed, *attributes.values())):
            if self.by_cases and kind not in BY_CASES:
                raise ValueError(f"{kind.__name__} is not known of equations by cases: {says}")
            parts: list[tuple[Field, dict[str, str]]] = [(part, part.signs) for part in self.parts]
            return ClaimInParts(
                tuple(
                    part.states(
                        kind, name, with_signs(says, signs), expect, with_signs(printed, signs),
                        **{key: with_signs(value, signs) for key, value in attributes.items()},
                    )
                    for part, signs in parts or [(self, signs) for signs in SIGNS]
                )
            )  # fmt: skip
        kind, says, attributes = stated_of(self.law, Stated(kind, says, attributes))
        id = self.numbering.id(name, self._tex(_first((printed, *attributes.values()))))
        return self._state(id, Finding(kind, self.scene, says, printed, attributes), expect)

    def _alternatives(self, equation: Tex) -> tuple[str, ...]:
        """Two equations of which one holds at each point; none where signs are those supposed."""
        return () if any(part.signs for part in self.parts) else alternatives(equation)

    def _state(self, id: str, finding: Finding, expect: str = "") -> SystemClaim:
        if expect and expect not in {*Verdict}:
            raise ValueError(f"expect “{expect}”: a verdict is one of {', '.join(Verdict)}")

        def put_in(formula: Tex) -> Printed:
            return self._place(id, formula, IN_WORDS if finding.tex not in ("", formula) else "")

        if self.special:
            special = ", ".join(f"${display.tex}$" for display in self.special)
            finding = replace(finding, says=f"for {special}, {finding.says}")
        claim = finding.claim(id, put_in)
        if isinstance(claim, FirstIntegral | Casimir):
            with suppress(ValueError):
                claim = replace(claim, scene=with_levels(claim.scene, claim.own))
        for place in claim.places():
            claim = replace(claim, scene=with_units(claim.scene, place.display))
            with suppress(ValueError):  # what cannot be read is the outcome of the claim
                claim = replace(claim, scene=with_lengths(claim.scene, place.display))
                claim = replace(claim, scene=with_roots(claim.scene, place.display))
        if self.law.images:
            claim = replace(claim, scene=with_roots_at_images(claim.scene, self.law.images))
        if isinstance(claim, OF_MODULI):
            claim = replace(claim, scene=with_signs_of_moduli(claim.scene))
        self.section.claim(claim)
        if expect:
            self.section.expected[id] = expect
        return SystemClaim(claim, self.section, self.symbols, self.seconds)

    # -- formulas ----------------------------------------------------------------

    def read(self, tex: str) -> Formula:
        """A formula in the names of the system; raises ``NotationError`` for any other name."""
        return read(tex, vocabulary((self.scene,)))

    def _formulas(self, display: Display) -> list[Formula]:
        return [s.formula for s in read_display(display.tex, vocabulary((self.scene,)))]

    def _tex(self, formula: Tex) -> str:
        if isinstance(formula, str):
            return self.law.conventions.plain(formula, self.scene)
        if not isinstance(formula, Function):
            return latex_of(formula, self.symbols)
        if self.scene.definitions.get(formula.name) != formula.place:
            raise ValueError(f"{formula!r} is defined elsewhere: define it on this system")
        return formula.name

    def _place(self, id: str, formula: Tex, source: str) -> Printed:
        """Where a formula stands: where it was defined, or in a display of its own.

        With a ``source`` it need not stand in a paper of which this is the derivation.
        """
        tex = self._tex(formula)
        if isinstance(formula, Function):
            return formula.place
        display = self.numbering.display(id, tex, source)
        if len([*display]) != 1:
            raise ValueError(f"“{display.tex}”: one formula is expected; give each by itself")
        return display[1]


def listed(formula: Tex) -> tuple[Tex, ...]:
    r"""The formulas of a list that is printed as one, as :math:`z=0,\ \dot z=0`."""
    if not isinstance(formula, str):
        return (formula,)
    parts = split_display(formula)
    whole = len({*parts}) < len(parts) or not parts  # values of an index are of one statement
    return (formula,) if whole else tuple(formula[start:end] for start, end in parts)


def _first(value: Any) -> Tex:
    """The first formula among values and tuples of them."""
    if not isinstance(value, tuple):
        return "" if isinstance(value, int) else value
    return next((one for one in map(_first, value) if not isinstance(one, str) or one), "")
