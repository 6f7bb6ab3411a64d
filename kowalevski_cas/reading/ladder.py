"""The claims that a statement may make, in the order in which they are tried.

A hypothesis is an assumption in force, or it is cited in the sentence, or it stands just before
and words say “on it”. No other one is ever tried.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from itertools import chain
from typing import Any

from kowalevski_cas.notation import Name, Number, Root, Unwritten, to_latex
from kowalevski_cas.notation.edits import substitute
from kowalevski_cas.notation.layout import EITHER_SIGN
from kowalevski_cas.paper.claims import (
    Claim,
    Coefficient,
    FirstIntegral,
    Identity,
    Implication,
    Inequality,
    InvariantRelations,
    OfAllFunctions,
    RestPoints,
)
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.reading.angles_at_rest import up_to_turns
from kowalevski_cas.reading.brackets import any_function, refuse_idle_brackets
from kowalevski_cas.reading.canonical import meant
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.flow_rungs import OF_FIELD, of_field
from kowalevski_cas.reading.formulas import are_differentials
from kowalevski_cas.reading.hypotheses import EQUATIONS, hypotheses, normalisations
from kowalevski_cas.reading.kept import constancy
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.momenta_of_energies import OF_COORDINATE, equation_of_momentum
from kowalevski_cas.reading.motion_rungs import along_solution, of_motion, solutions, to_some_order
from kowalevski_cas.reading.named_roots import IS_ROOT, equation_with_root
from kowalevski_cas.reading.parameters import held_fixed
from kowalevski_cas.reading.phrases import solved_by
from kowalevski_cas.reading.places_of_rest import velocities_at_rest
from kowalevski_cas.reading.roots_in_words import OF_ROOTS, equation_of_roots
from kowalevski_cas.reading.rung import Rung, RungMaker, places, stronger
from kowalevski_cas.reading.sets import SetOfEquations, sets_of
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

ZERO = Number(0)
_OF_SETS: dict[str, tuple[type[Claim], str]] = {
    "invariant": (InvariantRelations, "no motion leaves the set of these equations"),
    "rest": (RestPoints, "nothing moves where these equations hold"),
}
"""The claims that are made of a set, by the kind of its role."""


def rungs(item: SourceStatement, id: str, stage: Stage) -> Iterator[Rung]:
    """The claims that a statement may make, the likeliest first; none if it is not judged.

    Raises ``ValueError`` where names have no meaning together.
    """
    if are_differentials(item.members):
        raise ValueError("an equation between differentials is not judged")
    ladder = _Ladder(item, id, stage)
    name = any_function(item, stage.known)
    return iter([ladder.of_all_functions(name)]) if name else ladder.rungs()


class _Ladder(RungMaker):
    def rungs(self) -> Iterator[Rung]:
        refuse_idle_brackets(self.item, self.known)
        match self.role.kind:
            case "identity" | "constant":
                yield from self.identities()
                yield from () if self._levels else chain(along_solution(self), of_motion(self))
            case "inequality":
                yield from self.inequalities()
            case "integral":
                yield from self.integrals()
            case "invariant" | "rest":
                yield from self.of_set()
            case kind if kind in OF_FIELD:
                yield from of_field(self)
            case kind if kind in _BY_WORDS:
                yield from _BY_WORDS[kind](self)
            case "solution":
                yield from self.identities() if self._is_constant else ()
                yield from solutions(self)
            case "approximate":
                yield from map(stronger, self.identities())
                yield from to_some_order(self)
            case "somewhere":
                yield from map(stronger, (*self.values(), *along_solution(self)))
                yield from of_motion(self)
        yield from self.of_unit_vectors()
        yield from self.of_what_is_kept()
        yield from self.elsewhere()

    def of_all_functions(self, name: str) -> Rung:
        """What is printed of any function, whose name stands for every variable."""
        law = next(law for law in self.known.laws if not law.images)
        assert self.item.formula is not None
        tex = to_latex(substitute(self.item.formula, {name: Name(law.variables[0])}))
        one = unprinted(self.known.paper, f"{self.id}-of-one", tex, self.item, "for one variable")
        says = "this is so for all functions"
        return self.rung(OfAllFunctions, says, self.supposed, items=(one,), law=law, of=name)

    def of_what_is_kept(self) -> Iterator[Rung]:
        """The claim along motions that keep what has letters for its constant value."""
        given = constancy(self.item, self.known) if self.role.kind in EQUATIONS else []
        if given and not self._levels:
            says = "both sides are equal along motions on which this is constant"
            rung = self.rung(Implication, says, self.supposed, given, given=places(given))
            yield replace(rung, idle=None)  # what is constant is not all that moves

    def of_unit_vectors(self) -> Iterator[Rung]:
        """The claim where vectors have the length that is printed of them: one."""
        given = normalisations(self.item, self.known)
        if not given or {*given} & {*self.known.bound} or self.role.kind not in EQUATIONS:
            return
        if self._levels:  # they are constant where the function is derived
            return
        says = "both sides are equal, of unit vectors"
        kind: type[Claim] = Implication
        if self.role.kind == "integral" and not self._is_rate:
            kind, says = FirstIntegral, "this is constant along every motion, of unit vectors"
        yield self.rung(kind, says, self.supposed, given, given=places(given))

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
            case "identity" if self._levels:
                yield self._at_levels(assumptions)
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
        root has either sign if the sentence speaks of it, or prints both.
        """
        says = "both sides are equal"
        if self._leaves_out():
            yield from self.coefficients()
            return
        given_there = hypotheses(self.item, self.known)
        yield from self._of_coefficients()
        for assumptions in self.suppositions():
            if self._levels:
                yield self._at_levels(assumptions)
                continue
            if not given_there or ZERO not in self.item.members:
                yield self.rung(Identity, says, assumptions)
            told = cue("either root", self.item.words) or EITHER_SIGN.search(self.item.printed.tex)
            if (root := self._root()) and told:
                chosen = f"{says}, for one value of ${root}$"
                yield self.rung(Implication, chosen, assumptions, given=(), root=root)
            if self._is_constant:
                yield from self._constant_on_sets(assumptions)
                continue
            for given in given_there:
                said = "both sides are equal where the cited equations hold"
                yield self.rung(Implication, said, assumptions, given, given=places(given))
                if root:
                    chosen = f"{said}, for one value of ${root}$"
                    beside = tuple(one for one in self._beside() if root in self._roots(one))
                    yield self.rung(
                        Implication, chosen, assumptions, given, (self.item, *beside),
                        given=places(given), root=root, together=places(beside),
                    )  # fmt: skip

    def _constant_on_sets(self, assumptions: list[SourceStatement]) -> Iterator[Rung]:
        """A function that does not move where the cited equations hold."""
        for given in hypotheses(self.item, self.known):
            said = "this is constant along every motion on the set"
            yield self.rung(FirstIntegral, said, assumptions, given, given=places(given))

    def _of_coefficients(self) -> Iterator[Rung]:
        """What is said of roots, whatever values the integrals in the coefficients have."""
        given = self.known.rooted_at(self.item)
        if not given or self.item.derives:
            return
        names = frozenset().union(self.item.names, *(one.names for one in given))
        law = Law((), self.known.names, levels=frozenset(self.known.varying(names)))
        says = "both sides are equal by what the coefficients of a polynomial say of its roots"
        yield stronger(
            self.rung(Implication, says, self.supposed, given, law=law, given=places(given))
        )

    @cached_property
    def _levels(self) -> tuple[SourceStatement, ...]:
        """What gives the parameters of the functions that are derived in the statement."""
        return tuple(dict.fromkeys(held_fixed(self.item, self.known)))

    def _at_levels(self, assumptions: list[SourceStatement]) -> Rung:
        r"""The claim where a function that is derived has parameters, as :math:`U(r)=\ell^2/2r^2`.

        These stand for what moves, and are constant in the function that is derived: it is another
        claim if they are put in before.
        """
        found = self.stage.scene((self.item, *self._levels), assumptions)
        own = places([*self._levels])
        says = "both sides are equal, with these parameters in the function that is derived"
        scene = found.scene.fixing(own)  # a set on which each is some value, of any functions
        claim = Implication(self.id, scene, says, printed=self.item.printed, given=own)
        return Rung(claim, (*found.assumptions, *self._levels), found.constants)

    def inequalities(self) -> Iterator[Rung]:
        """A chain at all real points, and where cited equations hold."""
        says = "this is so at all real points"
        yield self.rung(Inequality, says, self.supposed)
        for given in hypotheses(self.item, self.known):
            said = f"{says} where the cited equations hold"
            yield self.rung(Inequality, said, self.supposed, given, given=places(given))

    def values(self) -> Iterator[Rung]:
        """A value where the equations hold that its words name."""
        for given in hypotheses(self.item, self.known):
            says = "this is so where the equations before hold"
            yield self.rung(Implication, says, self.supposed, given, given=places(given))

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
        """The other statements of the same display, but for the one with the other sign of a ±."""
        items = self.known.paper.items
        own = [one for one in items if one.typed is self.item.typed and one is not self.item]
        either = EITHER_SIGN.search(self.item.typed.tex) is not None
        return [one for one in own if not (either and one.span == self.item.span)]

    # -- integrals -------------------------------------------------------------------

    def integrals(self) -> Iterator[Rung]:
        """A function that does not move: everywhere, under the assumptions, or on a set."""
        if not self.known.varying(self.item.names):
            raise ValueError("it is called an integral, and nothing says how its names move")
        for assumptions in self.ways():
            yield self._integral(assumptions)
        if not self._is_rate:
            yield from self._constant_on_sets(self.supposed)
        for given in hypotheses(self.item, self.known) if self._is_rate else ():
            said = "this rate vanishes along every motion on the set"
            yield self.rung(Implication, said, self.supposed, given, given=places(given))
        fixed = [one for one in self.item.members if not self.known.varying(one.names())]
        if self.item.derives and fixed and not self._is_rate:
            for assumptions in self.suppositions():  # what is derived may be this by the law
                says = "this has its constant value along every motion"
                yield self.rung(Identity, says, assumptions)

    def _integral(self, assumptions: list[SourceStatement]) -> Rung:
        """That a function does not move, under some assumptions."""
        if (value := self.known.apart.get(self.item)) is not None:
            says = "this is constant along every motion"
            return self.rung(FirstIntegral, says, assumptions, (), (value,), printed=value.printed)
        kind = Identity if self._is_rate else FirstIntegral
        return self.rung(kind, "this is constant along every motion", assumptions)

    @property
    def _is_constant(self) -> bool:
        """Whether what moves is said to be constant."""
        constant = self.item.is_const
        return constant and "t" not in self.item.names

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
        ways = self.ways()
        yield from self._of_set(ways if everywhere in ways else [everywhere, *ways])

    def _of_set(self, ways: list[list[SourceStatement]]) -> Iterator[Rung]:
        relations = self._set()
        if relations[0] is not self.item:
            return
        kind, says = _OF_SETS[self.role.kind]
        bound, about = self.known.bound, dict[str, Any]()
        own = places((*relations, *bound))
        if kind is RestPoints:
            if law := self.stage.law(self.item, relations):
                bound = [*bound, *velocities_at_rest(relations, law, self.known)]
                relations = up_to_turns(relations, law, self.known)
            own = places(relations)
            about = {"given": places(bound)} if bound else {}
            if solved_by(self.item, "equilibrium"):
                about["are_all"], says = True, f"{says}, and only there"
        for assumptions in ways:
            yield self.rung(kind, says, assumptions, bound, relations, relations=own, **about)
        if along := self._along(relations) if kind is InvariantRelations else []:
            says, more = "no motion that begins along this set leaves it", places(along)
            for assumptions in ways:
                both = (*relations, *along)
                yield self.rung(kind, says, assumptions, bound, both, relations=(*own, *more))

    def _along(self, relations: SetOfEquations) -> list[SourceStatement]:
        """The derivatives of the equations of a set of places, where velocities move as well."""
        law = self.stage.law(self.item, relations)
        moving = {x for row in law.rows for x, n in row.rates.items() if n > 1} if law else set()
        beside = self.known.of_sentence(self.item.sentence)  # of velocities, where these are there
        if not moving or any(one.derives for one in (*beside, *relations)):
            return []
        if any(len(one.members) != 2 for one in relations):
            return []
        found = []
        for number, one in enumerate(relations, 1):
            if one.names & moving:
                function = to_latex(minus((one.members[0], one.members[1])))
                tex, id = rf"\frac{{d}}{{dt}}\left({function}\right)=0", f"along-{number}-{self.id}"
                found.append(unprinted(self.known.paper, id, tex, one, "as a motion along it has"))
        return found

    def _set(self) -> SetOfEquations:
        """The equations of the set that the statement defines, with others or alone.

        Raises ``ValueError`` if it cannot be seen which belong together.
        """
        roles = self.known.roles
        own = [one for one, role in roles.items() if role.kind == self.role.kind]
        sets = sets_of(own, self.known.paper.source.text)
        found = next((items for items in sets if self.item in items), None)
        if found is None:
            raise ValueError("which of these equations define one set?")
        return found

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

    def of_momentum(self) -> Iterator[Rung]:
        """That a momentum is the one of its coordinate."""
        by = equation_of_momentum(self.item, self.known)
        says = "this is the momentum of its coordinate"
        for assumptions in self.suppositions():
            items = (self.item, by)
            yield self.rung(Identity, says, assumptions, (), items, printed=by.printed)

    def of_named_root(self) -> Iterator[Rung]:
        """That a letter with an index is a root of the equation before it."""
        by = equation_with_root(self.item, self.known)
        if by is None:
            raise ValueError("the equation of which it is a root is not seen")
        for assumptions in self.suppositions():
            says, items = "this is a root of the equation before it", (self.item, by)
            yield self.rung(Identity, says, assumptions, (), items, printed=by.printed)

    # -- roots -----------------------------------------------------------------------

    def of_roots(self) -> Iterator[Rung]:
        """That an equation for a letter holds for each of the roots that words name."""
        by = equation_of_roots(self.item, self.known)
        says = "this has the roots of which words speak"
        own, given = (self.item, by), places([by])
        yield self.rung(Implication, says, self.supposed, (), own, given=given)


_BY_WORDS = {
    "energy": _Ladder.of_energy,
    OF_ROOTS: _Ladder.of_roots,
    OF_COORDINATE: _Ladder.of_momentum,
    IS_ROOT: _Ladder.of_named_root,
}
"""What is claimed of what words name, by the kind of its role."""
