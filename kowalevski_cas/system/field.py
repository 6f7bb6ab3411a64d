"""Equations of motion, what is defined beside them, and how something is stated of them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from contextlib import suppress
from copy import copy
from dataclasses import fields, replace
from typing import Any, Self

from kowalevski_cas.library import MADE
from kowalevski_cas.notation import (
    Formula,
    defined_names,
    read,
    read_display,
    split_display,
    to_plain,
)
from kowalevski_cas.paper.applied import collective_arguments, printed_arguments, without_arguments
from kowalevski_cas.paper.chains import without_chains
from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    FirstIntegral,
    Identity,
    Implication,
    Inequality,
    Involution,
    Jacobi,
)
from kowalevski_cas.paper.claims.maps import OF_MAPS
from kowalevski_cas.paper.constraints import equations_on
from kowalevski_cas.paper.derivation import Section
from kowalevski_cas.paper.initial_values import without_initial_values
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.paper.relations import solve_for_constant
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.subscripts import derived_in_index, with_derivatives, with_rates
from kowalevski_cas.paper.texts import IN_WORDS, Display, Printed
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.system.answers import ClaimInParts, Function, SystemClaim, in_html
from kowalevski_cas.system.beside import columns, with_columns_in_bold, with_upright_unit
from kowalevski_cas.system.cases import LawOfCase, laws_by_cases
from kowalevski_cas.system.equations import (
    components,
    constraints_in,
    restrict,
    scene_by,
    with_levels,
    with_motion,
    with_parameters,
    with_roots,
    with_time,
)
from kowalevski_cas.system.indices import (
    chain_ends,
    counts,
    has_permutation,
    with_counts,
    with_length,
    with_range_of_names,
    with_ranges,
    with_symmetry,
)
from kowalevski_cas.system.inverses import without_inverses
from kowalevski_cas.system.maps import (
    Map,
    has_bars,
    index_of_map,
    with_images,
    with_primes,
    without_steps,
)
from kowalevski_cas.system.partials import moving_names, with_partials
from kowalevski_cas.system.real_parts import with_real_parts
from kowalevski_cas.system.refused import check_constant, check_field, names_of
from kowalevski_cas.system.signs import SIGNS, alternatives, has_both_signs, with_signs
from kowalevski_cas.system.solved import (
    gives_constant,
    simple_relations,
    speaks_of_constants,
    with_new_names,
)
from kowalevski_cas.system.symbols import latex_of
from kowalevski_cas.system.units import with_unit_matrices, with_units
from kowalevski_cas.system.unknown import (
    TIMES,
    Unknown,
    check_said,
    said_functions,
    unknown_functions,
    with_jets,
    with_rates_of_functions,
    without_argument,
    without_said_functions,
)
from kowalevski_cas.verify.finding import Finding
from kowalevski_cas.verify.outcome import Verdict, in_latex

Tex = Any
"""A formula: LaTeX, what was defined, or an expression of SymPy."""

Texs = Any
"""A formula, or a tuple or a list of formulas."""

STATIC = (Identity, Implication, Jacobi, Casimir, Involution)
"""What is claimed of functions, whatever moves."""

OF_FUNCTIONS = (Identity, FirstIntegral, Jacobi)
"""What is claimed where a function may be any one: no dependence of several, and no set."""

BY_CASES = (Identity, Implication, Inequality, FirstIntegral)
"""What is claimed where equations of motion are printed by cases: nothing of what leaves one."""

LONGEST = 24
"""The signs of a formula by which a claim is called."""


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
        self.prefix = f"{name}-" if name else ""
        self.section = Section(name or "1", "", copied=None)
        MADE.append(self.section)
        self.shown = set[str]()
        """The ids of displays."""
        self.numbers = Counter[tuple[str, int]]()
        """How often an id was known, among displays or also among claims."""
        laws = laws_by_cases(field) if isinstance(field, str) else ()
        for equations, _ in laws[::-1] or [(field, ())]:
            self._take(equations, name, vectors or {}, map)
        self._take_cases(laws, name, vectors or {}, map)

    def _take_cases(
        self,
        laws: tuple[LawOfCase, ...],
        name: str,
        vectors: Mapping[str, tuple[str, ...]],
        map: bool,
    ) -> Self:
        """The system itself, with the parts by cases: equations where inequalities hold."""
        parts = []
        for law in laws:
            one = copy(self)
            one._take(law.equations, name, vectors, map)
            for condition in law.conditions:
                one = one.supposing(condition)
            parts.append(one)
        self.parts = (*parts,)
        return self

    def _take(
        self,
        field: str | Mapping[Any, Any],
        name: str,
        vectors: Mapping[str, tuple[str, ...]],
        map: bool,
    ) -> None:
        """Read equations of motion, or a map."""
        self.scene = Scene(name)  # of which nothing is known yet
        self._convention = False
        self.counts: dict[str, str] = {}
        self.applied: dict[str, str] = {}
        self._by_index = ""
        self.columns: dict[str, tuple[str, ...]] = {}
        self.functions: list[Unknown] = []
        self._barred = False
        self._ends: set[str] = set()
        if isinstance(field, str):
            tex = with_rates_of_functions(with_upright_unit(with_rates(field)))
            tex = with_real_parts(tex)
        else:
            tex = self._rows(field)
        self.columns = columns(tex)
        """The vectors that are printed in italics, with their components."""
        tex = with_columns_in_bold(tex, self.columns)
        rows = (rf"\mathbf{{{one}}}=({','.join(parts)})" for one, parts in self.columns.items())
        tex = r",\quad ".join((tex, *rows))
        self._by_index = derived_in_index([tex])
        """The variable by which indices derive, if they do."""
        self._barred = map and has_bars(tex)
        """Whether bars stand over images of a map."""
        tex = without_inverses(without_steps(tex) if self._barred else tex)
        self.counts = counts(tex)
        """The letters that say how far indices run, with their numbers."""
        tex = with_counts(tex, self.counts)
        moving = () if map else moving_names(tex)
        chains = without_chains(tex if map else without_initial_values(tex, moving), moving)
        tex = chains.tex
        if not map:
            tex = with_range_of_names(with_symmetry(with_length(tex)))
            tex = with_partials(tex, moving_names(tex))
        self.applied = printed_arguments([tex], vectors)
        """The arguments of names that are defined; they are called by their names alone."""
        self.functions = unknown_functions(tex)
        """The functions of which nothing is known; they are called by their names alone."""
        said, tex = said_functions(tex), without_said_functions(tex)
        self._convention = has_permutation(tex)
        """Whether indices that stand twice are summed over, though no sums are printed."""
        tex, words = self._tex(tex), [*self.symbols, *(one.name for one in self.functions)]
        parts = components(tex, vectors, words)
        jets = [jet for one in self.functions for jet in one.jets(parts)]
        words += dict.fromkeys(name for *both, _ in jets for name in both)
        printed = {name for statement in defined_names(tex) for name in statement.names}
        index = index_of_map(tex)
        self.images: tuple[tuple[str, str], ...] = ()
        """The variables of a map with their images; none if it is a motion."""
        self.constraints: tuple[str, ...] = ()
        """On what the motion is: constraints with multipliers, and their derivatives."""
        if map or index:
            tex = with_images(tex, parts, words, index)
        else:
            arguments = [by for one in self.functions for by in one.by if by not in TIMES]
            tex = with_unit_matrices(tex, parts, words)
            tex = with_time(with_motion(tex, parts, words, arguments), parts, words)
        display = self.section.display(self._new(f"{self.prefix}field", self.shown), tex)
        self.shown.add(display.id)
        if map or index:
            found = Map(display, parts, words, index)
            self.images = (*found.images.items(),)
            self._stand_on(found.scene(name, parts))
        else:
            self._stand_on(scene_by(display, name, parts, words))
            bound = constraints_in(display, parts, words)
            self.constraints = (*equations_on(self.scene, bound),)
        if jets:
            self._stand_on(with_jets(self.scene, jets))
        given = zip(display, self._formulas(display), strict=True)
        by_name = {n: one for place, one in given for n in place.heads.names}
        self._ends = chain_ends(tex, by_name) & {*self.scene.definitions}
        check_said(said, self.scene.constants)
        for equality in chains.equalities:
            self._check_equal(*equality)
        self.implied = frozenset(_brackets(self.scene.definitions)) - printed
        """The canonical brackets, which equations of Hamilton imply and nobody has printed."""
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
        aside.parts = (*(part._aside() for part in self.parts),)
        return aside

    def _each(self, change: Callable[[Self], Self]) -> Self:
        """What becomes of the system, and of its parts."""
        alone = copy(self)
        alone.parts = ()
        whole = change(alone)
        whole.parts = (*map(change, self.parts),)
        return whole

    def _rows(self, field: Mapping[Any, Any]) -> str:
        """Equations of motion by their right sides."""
        if not isinstance(field, Mapping):
            raise TypeError(f"LaTeX, or right sides by the variables of SymPy, and not {field!r}")
        rows = [rf"\dot{{{self._tex(x)}}}={self._tex(force)}" for x, force in field.items()]
        tex = r",\quad ".join(rows)
        if len(defined_names(tex)) != len(rows):
            raise ValueError(f"{tex}: give each variable one right side")
        return tex

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
        moves = ("is mapped" if one else "are mapped") if self.images else f"move{'s' * one}"
        still = f"{', '.join(map(shown, fixed))} {'are' if len(fixed) > 1 else 'is'} constant"
        moving = f"{', '.join(map(shown, names))} {moves}"
        any_ = [
            f"{shown(one.name)} is any function of {', '.join(map(shown, one.by))}"
            for one in self.functions
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
        display = self.section.display(self._id("", tex), tex)
        self.shown.add(display.id)
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
        if any(_brackets(name for statement in display for name in statement.heads.names)):
            # What is printed of a bracket is all of it: none that is implied stands beside.
            left = {n: one for n, one in scene.definitions.items() if n not in self.implied}
            scene, self.implied = replace(scene, definitions=left), frozenset()
        self._stand_on(with_roots(with_units(scene, display).defining(display), display))

    def where(self, *relations: Tex) -> Self:
        r"""The system for special constants: ``a+b=2c``, ``r^2=x^2+y^2``, ``\sigma\ne0``.

        Raises:
            NotationError: a relation cannot be read.
            ValueError: a relation gives no constant, or gives it by what moves.
        """
        if self.parts:
            return self._each(lambda one: one.where(*with_signs(relations, one.signs)))
        if has_both_signs(relations):
            return self._with_both_signs(relations)
        special, said = copy(self), ", ".join(map(self._tex, relations))
        scene = self.scene.called(f"{self.scene.name} where {said}")
        simple = (one for tex in relations for one in simple_relations(self._tex(tex), scene))
        for tex in simple:
            scene = with_new_names(tex, scene)
            if speaks_of_constants(tex, scene) and not gives_constant(tex, scene):
                rooted = with_roots(scene, Display("", tex, ""))
                solved, below = solve_for_constant(tex, rooted)
                tex, scene = solved or tex, scene.having(nonzero=below)
            place = self._place("where", tex, IN_WORDS)
            constants, scene = scene.constants, with_roots(restrict(scene, place), place.display)
            check_constant(scene, place, constants)
            special.special += (place.display,)
        special._stand_on(scene)
        return special

    def _with_both_signs(self, relations: tuple[Tex, ...]) -> Self:
        """The systems for the upper and for the lower signs: what is claimed is so for both."""
        parts = []
        for signs in SIGNS:
            part = self.where(*with_signs(relations, signs))
            part.signs = signs
            parts.append(part)
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
        if self.parts:
            return self._of_parts(kind, name, says, expect, printed, attributes)
        if has_both_signs((printed, *attributes.values())):
            return ClaimInParts(
                tuple(
                    self.states(
                        kind, name, with_signs(says, signs), expect, with_signs(printed, signs),
                        **{key: with_signs(value, signs) for key, value in attributes.items()},
                    )
                    for signs in SIGNS
                )
            )  # fmt: skip
        if self.functions and (kind not in OF_FUNCTIONS or any(attributes.values())):
            names = ", ".join(one.name for one in self.functions)
            raise ValueError(f"{kind.__name__} is not known where {names} may be any function")
        if self.images:
            kind, says, attributes = self._of_map(kind, says, attributes)
        elif "images" in {field.name for field in fields(kind)}:
            raise ValueError(f"this is no map, but a motion; {kind.__name__} is not known of it")
        if self.constraints:
            kind, says, attributes = self._bound(kind, says, attributes)
        id = self._id(name, self._tex(_first((printed, *attributes.values()))))
        return self._state(id, Finding(kind, self.scene, says, printed, attributes), expect)

    def _of_parts(
        self,
        kind: type[Claim],
        name: str,
        says: str,
        expect: str,
        printed: Tex,
        attributes: dict[str, Any],
    ) -> SystemClaim:
        """A claim of both signs, or of all cases; signs in it are those of the part."""
        if kind not in BY_CASES and not all(part.signs for part in self.parts):
            raise ValueError(f"{kind.__name__} is not known of equations by cases: {says}")
        return ClaimInParts(
            tuple(
                part.states(
                    kind, name, with_signs(says, part.signs), expect,
                    with_signs(printed, part.signs),
                    **{key: with_signs(one, part.signs) for key, one in attributes.items()},
                )
                for part in self.parts
            )
        )  # fmt: skip

    def _alternatives(self, equation: Tex) -> tuple[str, ...]:
        """Two equations of which one holds at each point; none where signs are those supposed."""
        return () if any(part.signs for part in self.parts) else alternatives(equation)

    def _of_map(
        self, kind: type[Claim], says: str, attributes: dict[str, Any]
    ) -> tuple[type[Claim], str, dict[str, Any]]:
        """What is claimed of a map; raises ``ValueError`` for a kind that is about motions."""
        kind = OF_MAPS.get(kind, kind)
        own = {field.name for field in fields(kind)}
        attributes = {key: value for key, value in attributes.items() if value or key in own}
        unknown = attributes.keys() - own
        if unknown or (kind not in STATIC and "images" not in own):
            raise ValueError(f"{kind.__name__} is not known of maps: {says}")
        images = {"images": self.images} if "images" in own else {}
        for motion, map_ in (("along every motion", "under the map"), ("no motion", "no step")):
            says = says.replace(motion, map_)
        return kind, says, {**attributes, **images}

    def _bound(
        self, kind: type[Claim], says: str, attributes: dict[str, Any]
    ) -> tuple[type[Claim], str, dict[str, Any]]:
        """What is claimed on the constraints; raises ``ValueError`` if the kind knows no set."""
        kind = Implication if kind is Identity else kind
        of = next((f.name for f in fields(kind) if f.name in ("given", "relations")), "")
        if not of:
            raise ValueError(f"{kind.__name__} is not known on constraints: {says}")
        where = ", ".join(f"${one}$" for one in self.constraints)
        known = several(attributes.get(of, ()))
        return kind, f"{says}, where {where}", {**attributes, of: (*known, *self.constraints)}

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
                claim = replace(claim, scene=with_roots(claim.scene, place.display))
        self.section.claim(claim)
        if expect:
            self.section.expected[id] = expect
        return SystemClaim(claim, self.section, self.symbols, self.seconds)

    # -- formulas ----------------------------------------------------------------

    def read(self, tex: str) -> Formula:
        """A formula in the names of the system; raises ``NotationError`` for any other name."""
        return read(tex, vocabulary((self.scene,)))

    @property
    def _names(self) -> tuple[str, ...]:
        """The names that stand in the equations of motion, or were defined beside them.

        Those are left out that only close a chain: a sum over all links has each of them once.
        """
        names = (*self.scene.names(), *self.scene.vectors)
        return tuple(name for name in names if name not in self._ends)

    def _formulas(self, display: Display) -> list[Formula]:
        return [s.formula for s in read_display(display.tex, vocabulary((self.scene,)))]

    def _tex(self, formula: Tex) -> str:
        if isinstance(formula, str):
            jets = {name for name, _, _ in self.scene.jets}
            moving = {*self.scene.variables} - jets - {self.scene.time}
            plain = with_columns_in_bold(with_rates(formula), self.columns)
            plain = with_partials(with_counts(plain, self.counts), moving)
            plain = with_derivatives(plain, self._by_index)
            applied = {**collective_arguments([plain]), **self.applied}
            plain = without_arguments(without_argument(plain, self.functions), applied)
            plain = with_primes(plain) if self._barred else plain
            return with_ranges(plain, self._names, self._convention)
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
        id = self._new(id, self.shown)
        display = self.section.lemma(id, tex, source) if source else self.section.display(id, tex)
        self.shown.add(id)
        if len([*display]) != 1:
            raise ValueError(f"“{display.tex}”: one formula is expected; give each by itself")
        return display[1]

    def _id(self, kind: str, tex: str) -> str:
        """A new id, after the label or the letters of a formula."""
        label = re.search(r"\\label\{([^}]*)\}", tex)
        tex = label[1] if label else tex
        letters = re.sub(r"[^A-Za-z0-9]+", "-", re.sub(r"=\s*0\b", "", tex))[:LONGEST].strip("-")
        id = self.prefix + "-".join(filter(None, (kind, letters)))
        return self._new(id, self.shown, self.section.lines)

    def _new(self, id: str, *known: Container[str]) -> str:
        """An id, with a number if it is known; all smaller numbers are."""
        new = id
        while any(new in ids for ids in known):
            self.numbers[id, len(known)] += 1
            new = f"{id}.{self.numbers[id, len(known)] + 1}"
        return new


def several(formulas: Texs) -> tuple[Tex, ...]:
    """Formulas as a tuple, also if it is one."""
    return tuple(formulas) if isinstance(formulas, tuple | list) else (formulas,)


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


def _brackets(names: Iterable[str]) -> Iterator[str]:
    """The names that are Poisson brackets of variables."""
    return (name for name in names if name.startswith(BRACKET))
