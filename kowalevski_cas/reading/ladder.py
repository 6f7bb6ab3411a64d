"""The claims that a statement may make, in the order in which they are tried.

A hypothesis is an assumption in force, or it is cited in the sentence, or it stands just before
and words say “on it”. No other one is ever tried.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from kowalevski_cas.notation import Name, Number, Root, Unwritten, to_latex
from kowalevski_cas.paper.claims import (
    CharacteristicEquation,
    Claim,
    Coefficient,
    Divergence,
    DoubleZero,
    Eigenvalue,
    FirstIntegral,
    Frequency,
    Identity,
    Implication,
    Inequality,
    InvariantRelations,
    PreservedMeasure,
    RestPoints,
    Solution,
)
from kowalevski_cas.paper.claims.maps import OF_MAPS
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.reading.brackets import refuse_idle_brackets
from kowalevski_cas.reading.canonical import ENERGY, meant
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.hypotheses import EQUATIONS, hypotheses, near, normalisations
from kowalevski_cas.reading.jets import refuse_of_functions
from kowalevski_cas.reading.kinematics import is_free
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.linear_parts import point_of
from kowalevski_cas.reading.sets import SetOfEquations, sets_of
from kowalevski_cas.reading.small_oscillations import places_of, prints_square, variable_of
from kowalevski_cas.reading.solutions import solution_of
from kowalevski_cas.reading.stage import Stage, Supposed
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

ZERO = Number(0)
_OF_SETS: dict[str, tuple[type[Claim], str]] = {
    "invariant": (InvariantRelations, "no motion leaves the set of these equations"),
    "rest": (RestPoints, "nothing moves where these equations hold"),
}
"""The claims that are made of a set, by the kind of its role."""


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


def rungs(item: SourceStatement, id: str, stage: Stage) -> Iterator[Rung]:
    """The claims that a statement may make, the likeliest first; none if it is not judged.

    Raises ``ValueError`` where names have no meaning together.
    """
    return _Ladder(item, id, stage).rungs()


class _Ladder:
    def __init__(self, item: SourceStatement, id: str, stage: Stage) -> None:
        self.item, self.id, self.stage, self.known = item, id, stage, stage.known
        self.role = self.known.roles[item]
        self.supposed = stage.understood(self.known.supposed(item))
        if self.role.kind == "solution":  # at one time it says nothing
            at_time = [one for one in self.supposed if one.names <= self.known.times]
            self.supposed = [one for one in self.supposed if one not in at_time]

    def rungs(self) -> Iterator[Rung]:
        refuse_idle_brackets(self.item, self.known)
        match self.role.kind:
            case "identity" | "constant":
                yield from self.identities()
                yield from self.along_solution()
            case "inequality":
                yield from self.inequalities()
            case "integral":
                yield from self.integrals()
            case "invariant" | "rest":
                yield from self.of_set()
            case "eigenvalue" | "frequency" | "characteristic":
                yield from self.of_linear_part()
            case "solution":
                yield from self.solutions()
            case "divergence" | "measure" | "energy":
                yield from self.of_energy() if self.role.kind == ENERGY else self.of_flow()
            case "approximate":
                yield from map(_stronger, self.identities())
                yield from self.first_order()
            case "somewhere":
                yield from map(_stronger, (*self.values(), *self.along_solution()))
        yield from self.of_unit_vectors()
        yield from self.elsewhere()

    def of_unit_vectors(self) -> Iterator[Rung]:
        """The claim where vectors have the length that is printed of them: one."""
        given = normalisations(self.item, self.known)
        if not given or {*given} & {*self.known.bound} or self.role.kind not in EQUATIONS:
            return
        says = "both sides are equal, of unit vectors"
        kind: type[Claim] = Implication
        if self.role.kind == "integral" and not self._is_rate:
            kind, says = FirstIntegral, "this is constant along every motion, of unit vectors"
        yield self.rung(kind, says, self.supposed, given, given=_places(given))

    def elsewhere(self) -> Iterator[Rung]:
        """The claim with what is supposed in other places: one that then holds may be meant so."""
        moving = not self.item.derives and not self.known.varying(self.item.names)
        for group in [] if moving else self.known.supposed_elsewhere(self.item):
            names = {name for one in group for name in self.known.roles[one].names}
            other = [one for one in self.supposed if names & {*self.known.roles[one].names}]
            if any(one.sentence == self.item.sentence for one in other):
                continue
            kept = [one for one in self.supposed if one not in other]
            for rung in self._under([*kept, *group]):
                if {*group} <= {*rung.on}:
                    yield replace(rung, elsewhere=True)

    def _under(self, assumptions: list[SourceStatement]) -> Iterator[Rung]:
        """The claim under some assumptions, and on no set that is given besides."""
        match self.role.kind:
            case "identity":
                yield self.rung(Identity, "both sides are equal", assumptions)
            case "integral":
                yield self._integral(assumptions)
            case "invariant" | "rest":
                yield from self._of_set([assumptions])
            case "inequality":
                yield self.rung(Inequality, "this is so at all real points", assumptions)

    # -- identities ------------------------------------------------------------------

    def identities(self) -> Iterator[Rung]:
        """An equation by itself, and where cited equations hold.

        What vanishes where others are cited is one of a set: nobody says that it always does. A
        root has either sign if the sentence speaks of it.
        """
        says = "both sides are equal"
        if self._leaves_out():
            yield from self.coefficients()
            return
        given_there = hypotheses(self.item, self.known)
        for assumptions in self.suppositions():
            if not given_there or ZERO not in self.item.members:
                yield self.rung(Identity, says, assumptions)
            if (root := self._root()) and cue("either root", self.item.words):
                chosen = f"{says}, for one value of ${root}$"
                yield self.rung(Implication, chosen, assumptions, given=(), root=root)
            for given in given_there:
                said = "both sides are equal where the cited equations hold"
                yield self.rung(Implication, said, assumptions, given, given=_places(given))
                if root:
                    chosen = f"{said}, for one value of ${root}$"
                    beside = tuple(one for one in self._beside() if root in self._roots(one))
                    yield self.rung(
                        Implication, chosen, assumptions, given, (self.item, *beside),
                        given=_places(given), root=root, together=_places(beside),
                    )  # fmt: skip

    def inequalities(self) -> Iterator[Rung]:
        """A chain at all real points, and where cited equations hold."""
        says = "this is so at all real points"
        yield self.rung(Inequality, says, self.supposed)
        for given in hypotheses(self.item, self.known):
            said = f"{says} where the cited equations hold"
            yield self.rung(Inequality, said, self.supposed, given, given=_places(given))

    def values(self) -> Iterator[Rung]:
        """A value where the equations hold that its words name."""
        for given in hypotheses(self.item, self.known):
            says = "this is so where the equations before hold"
            yield self.rung(Implication, says, self.supposed, given, given=_places(given))

    def _leaves_out(self) -> bool:
        """Whether terms are not printed."""
        nodes = self.item.formula.nodes() if self.item.formula is not None else ()
        return any(isinstance(node, Unwritten) for node in nodes)

    def coefficients(self) -> Iterator[Rung]:
        """An equation up to terms of which the words say of what they are free."""
        after = [one for one in self.known.items if one.order > self.item.order]
        for one in after:
            if one.sentence == self.item.sentence and isinstance(one.formula, Name):
                if cue("free of", one.lead[-40:]):
                    name = one.formula.name
                    says = f"both sides are equal up to terms without ${name}$"
                    yield self.rung(Coefficient, says, self.supposed, variable=name)
                    return
        raise ValueError("terms are left out, and no words say of what these are free")

    def _root(self) -> str:
        """The first square root that the statement prints."""
        return next(iter(self._roots(self.item)), "")

    def _roots(self, item: SourceStatement) -> list[str]:
        nodes = item.formula.nodes() if item.formula is not None else ()
        return [to_latex(node) for node in nodes if isinstance(node, Root)]

    def _beside(self) -> list[SourceStatement]:
        """The other statements of the same display."""
        items = self.known.paper.items
        return [one for one in items if one.typed is self.item.typed and one is not self.item]

    def suppositions(self) -> list[list[SourceStatement]]:
        """The assumptions with which a claim is tried: those in force, and fewer.

        Where the statement itself has a constant that is specialised, it may be meant in general.
        """
        kept = [
            one for one in self.supposed if not {*self.known.roles[one].names} & self.item.names
        ]
        return [kept, self.supposed] if len(kept) < len(self.supposed) else [self.supposed]

    # -- integrals -------------------------------------------------------------------

    def integrals(self) -> Iterator[Rung]:
        """A function that does not move: everywhere, under the assumptions, or on a set."""
        if not self.known.varying(self.item.names):
            raise ValueError("it is called an integral, and nothing says how its names move")
        for assumptions in self._ways():
            yield self._integral(assumptions)
        for given in hypotheses(self.item, self.known):
            said = "this is constant along every motion on the set"
            kind = Implication if self._is_rate else FirstIntegral
            yield self.rung(kind, said, self.supposed, given, given=_places(given))

    def _integral(self, assumptions: list[SourceStatement]) -> Rung:
        """That a function does not move, under some assumptions."""
        if (value := self.known.apart.get(self.item)) is not None:
            says = "this is constant along every motion"
            return self.rung(FirstIntegral, says, assumptions, (), (value,), printed=value.printed)
        kind = Identity if self._is_rate else FirstIntegral
        return self.rung(kind, "this is constant along every motion", assumptions)

    def _ways(self) -> list[list[SourceStatement]]:
        """Without assumptions, and with those in force; what is not zero is never left aside."""
        kept = [one for one in self.supposed if self.known.roles[one].kind == "inequality"]
        return [kept, self.supposed] if len(kept) < len(self.supposed) else [kept]

    @property
    def _is_rate(self) -> bool:
        """Whether a rate is said to vanish."""
        return ZERO in self.item.members and self.item.derives

    # -- sets ------------------------------------------------------------------------

    def of_set(self) -> Iterator[Rung]:
        """That no motion leaves a set, or that nothing moves there; its equations are one claim.

        The set may bound the domain of which inequalities say that it is the space.
        """
        everywhere = [one for one in self.supposed if not self.known.varying(one.names)]
        ways = self._ways()
        yield from self._of_set(ways if everywhere in ways else [everywhere, *ways])

    def _of_set(self, ways: list[list[SourceStatement]]) -> Iterator[Rung]:
        relations = self._set()
        if relations[0] is not self.item:
            return
        kind, says = _OF_SETS[self.role.kind]
        bound = self.known.bound
        places = _places((*relations, *bound))
        for assumptions in ways:
            yield self.rung(kind, says, assumptions, bound, relations, relations=places)

    def _set(self) -> SetOfEquations:
        """The equations of the set that the statement defines, with others or alone."""
        roles = self.known.roles
        own = [one for one, role in roles.items() if role.kind == self.role.kind]
        sets = sets_of(own, self.known.paper.source.text)
        return next(items for items in sets if self.item in items)

    # -- energies --------------------------------------------------------------------

    def of_energy(self) -> Iterator[Rung]:
        """That an energy in other letters is what it was before."""
        law = self.stage.law(self.item, [self.item])
        if law is None:
            raise ValueError("no equations of motion are read by which this is an energy")
        name = f"{self.item.printed.display.id}-{self.item.printed.number}-meant"
        by = unprinted(self.known.paper, name, meant(self.item, self.known), self.item)
        there = replace(law, change=(*law.change, by))
        for assumptions in self.suppositions():
            says = "this is the energy in these letters"
            yield self.rung(Identity, says, assumptions, (), (self.item, by), there)

    # -- the linear part -------------------------------------------------------------

    def of_linear_part(self) -> Iterator[Rung]:
        """What is said of the linear part at the point of which the words speak."""
        item, known = self.item, self.known
        about: dict[str, Any] = {}
        kind: type[Claim] = Eigenvalue
        says = "this is an eigenvalue of the linear part at this point"
        match self.role.kind:
            case "frequency":
                kind, about = Frequency, {"is_square": prints_square(item)}
                says = "this is the frequency of small oscillations near this point"
            case "characteristic":
                kind, about = CharacteristicEquation, {"variable": variable_of(item, known)}
                says = "this is the characteristic equation of the linear part at this point"
        point = point_of(item, known) if kind is Eigenvalue else places_of(item, known)
        law = next(law for law in known.laws if not law.images)
        for assumptions in self._ways():
            yield self.rung(
                kind, says, assumptions, (), (item, *law.rows, *point),
                printed=item.printed, relations=_places(point), **about,
            )  # fmt: skip

    # -- the flow --------------------------------------------------------------------

    def of_flow(self) -> Iterator[Rung]:
        """What the divergence of the field is, or that the flow preserves a measure.

        The measure is one in the variables of which the rates are printed.
        """
        laws = [law for law in self.known.laws if not law.change]
        law = self.stage.law(self.item, [self.item]) or (laws[0] if len(laws) == 1 else None)
        if law is None or is_free(law):
            raise ValueError("of which of the equations of motion is this said?")
        for assumptions in self._ways():
            if self.role.kind == "divergence":
                says = "this is the divergence of the field"
                yield self.rung(Divergence, says, assumptions, law=law)
                continue
            rated = (name for row in law.rows for name in row.rates)
            coordinates = dict.fromkeys(law.names.scalars(rated)) if law.momenta else ()
            says = "the flow preserves the measure with this density"
            items = (self.item, *law.momenta)
            yield self.rung(
                PreservedMeasure, says, assumptions, (), items, law, coordinates=(*coordinates,)
            )

    # -- solutions -------------------------------------------------------------------

    def solutions(self) -> Iterator[Rung]:
        """That a function of the time, with those beside it, solves its equations of motion.

        What the law does not move solves the equations of its rate that are claimed: they are
        claimed once more.
        """
        beside = [
            one
            for one, role in self.known.roles.items()
            if role.kind == "solution" and one.sentence == self.item.sentence
        ]
        moves = any(map(self.known.moves, self.item.bare))
        law = self.stage.law(self.item, beside) if moves else None
        found = solution_of(self.item, beside, law, self.known)
        still = Law((), (law or self.known.laws[-1]).names, change=found.given)
        says = "this solves its equation of motion"
        for assumptions in self._ways():
            on_law = [self.stage.scene([row], assumptions).scene for row in found.rows]
            claimed = () if moves else zip(found.rows, on_law, strict=True)
            yield self.rung(
                Solution, says, assumptions, (), (*found.given, *found.rows), still,
                printed=self.item.printed, equations=_places(found.rows),
                resting=tuple(
                    Identity(self.id, scene, "", printed=row.printed) for row, scene in claimed
                ),
            )  # fmt: skip

    def along_solution(self) -> Iterator[Rung]:
        """An equation with the constants of a solution, where the solution before it is put in."""
        before = [
            one
            for one, role in self.known.roles.items()
            if role.kind == "solution" and one.order < self.item.order
            and one.section is self.item.section and one.bare
        ]  # fmt: skip
        solution = [one for one in before if one.sentence == before[-1].sentence]
        law = self.stage.law(solution[0], solution) if solution else None
        own = {name for one in solution for name in one.names - {*one.bare[:1], "t"}}
        if law is None or not (own - law.mentions) & self.item.names:
            return
        along = Law((), law.names, change=tuple(solution))
        says = "both sides are equal along the solution before"
        for assumptions in self.suppositions():
            rung = self.rung(Identity, says, assumptions, (), (self.item, *solution), along)
            yield replace(rung, on=(*rung.on, *solution), given=tuple(solution))

    # -- approximations --------------------------------------------------------------

    def first_order(self) -> Iterator[Rung]:
        """That a rate is right up to what vanishes twice at the point, or on the set, before it."""
        given = near(self.item, self.known)
        if self.item.derives and given:
            says = "up to small quantities of the second order both sides are equal"
            rung = self.rung(DoubleZero, says, self.supposed, given, given=_places(given))
            yield replace(rung, idle=None)  # it is said of what is near

    # -- all -------------------------------------------------------------------------

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
        refuse_of_functions(kind, attributes, found.scene)
        claim = kind(self.id, found.scene, says, **attributes)  # type: ignore[arg-type]
        in_force = bool(on) and [*on] == self.known.sets(self.item)
        idle = None
        if (
            not found.images
            and {*on} - {*self.known.bound}
            and (self.item.derives or self.role.kind == "integral")
        ):
            idle = RestPoints(self.id, found.scene, "", relations=_places(on))
        return Rung(claim, (*found.assumptions, *on), found.constants, (*on,), in_force, idle)


def _stronger(rung: Rung) -> Rung:
    """A claim that says more than its statement."""
    return replace(rung, is_stronger=True)


def _places(items: Sequence[SourceStatement]) -> tuple[Printed, ...]:
    return tuple(item.printed for item in items)
