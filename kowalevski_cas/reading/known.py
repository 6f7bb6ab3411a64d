"""What is known at a place of a paper: its laws, what has been defined, what is supposed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

from kowalevski_cas.notation import Name, NotationError, Number, Power, Product, Quotient
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.jets import Unknown
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.reading.cases import is_told_apart, named_case, proves
from kowalevski_cas.reading.clauses import Clauses
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.letters_of_vectors import bold_letters
from kowalevski_cas.reading.lifted import (
    goes_on,
    has_what_vanishes,
    is_cited_as_condition,
    is_lifted,
    lasts_to_the_end,
    may_lift,
    names_case,
)
from kowalevski_cas.reading.matrices_in_words import matrices_in_words
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, is_numerical

_END = re.compile(r"\\end\s*\{\w+\*?\}")


class StatementRole(NamedTuple):
    """What a statement is for its paper, with the reason in words.

    ``kind`` says what is claimed, or why that is not judged; ``names`` are those that it defines,
    or that it gives values to; ``value`` is that of an integral, among other terms. What is only
    ``found`` may hold with less than it says, as an inequality where nothing moves.
    """

    name: str
    reason: str
    kind: str = ""
    names: tuple[str, ...] = ()
    value: str = ""
    found: bool = False


LAW, DEFINITION, LEVEL, ASSUMPTION, CLAIM, NOTATION, OTHER, UNREAD, CONVENTION = (
    "law", "definition", "level", "assumption", "claim", "notation", "other", "unread",
    "convention",
)  # fmt: skip

MORE = "says more"
"""The kind of what has no verdict since its words say another thing than is judged: it is told."""

CONSTRAINT = "constraint"
"""The kind of an assumption on which all motion is."""

BEGINNING = "beginning"
"""The kind of an assumption that holds at one time only."""

UNKNOWNS = "equations for unknowns"
"""The kind of an assumption that is given where its letters stand, or those of others with it."""

FUNCTION = "function"
"""How the kind of an assumption begins that a function is a special one: to the end of its case."""

NAMED_LEVEL = "set with the name of its value"
"""The kind of an assumption that gives the value of an integral a name of its own.

It is supposed in its sentence, and where this name stands behind it.
"""

NORMALISED = "set by normalisation"
"""The kind of an assumption that fixes the parameter of the motion by the value of an integral.

It is in force to the end of the paper, or to another one about the same names.
"""

TOGETHER = "together"
"""The kind of a definition that gives names with others: it is supposed where these are used."""

UNIT_MATRIX = "unit matrix"
"""The kind of a convention that a name is one."""

SETS = ("invariant", "rest")
"""The kinds of claims of which the equations define a set."""

NAMING = (DEFINITION, LEVEL, CLAIM, CONVENTION)
"""The roles by which a name gets a meaning."""


def called(name: str) -> str:
    """A head without its arguments; that of a bracket is itself."""
    return name if name.startswith(BRACKET) else head(name)[0]


@dataclass(eq=False)
class Known:
    """What a part of a paper has said, as far as it has been read; the roles are of all parts."""

    paper: SourcePaper
    names: Names
    laws: list[Law]
    items: list[SourceStatement]
    restated: list[Law] = field(default_factory=list)
    roles: dict[SourceStatement, StatementRole] = field(default_factory=dict)
    definitions: dict[str, list[SourceStatement]] = field(default_factory=dict)
    assumptions: list[SourceStatement] = field(default_factory=list)
    units: list[SourceStatement] = field(default_factory=list)
    clocks: list[SourceStatement] = field(default_factory=list)
    seen: dict[str, SourceStatement] = field(default_factory=dict)
    """The equations in which names have been used first."""
    apart: dict[SourceStatement, SourceStatement] = field(default_factory=dict)
    """Integrals with their value among other terms, and the same with the value by itself."""
    lost: dict[str, str] = field(default_factory=dict)
    """The names that are to follow from what is printed, and why they do not."""
    rooted: list[tuple[frozenset[str], list[SourceStatement]]] = field(default_factory=list)
    """The names of roots, with the equations that give them."""
    elsewhere: frozenset[str] = frozenset()
    """What moves by the laws of other parts."""
    said: Said = field(default_factory=Said)
    """What comments say of statements."""

    @cached_property
    def times(self) -> frozenset[str]:
        r"""The names of times: of x and s only where something is derived by them.

        So it is, by primes, where differentials give another time. The letter :math:`\tau` is one
        where anything is its function, or it is given, or called so.
        """
        marks = frozenset().union(*(item.marks for item in self.items))
        given = {one.other_time for one in self.items if "d" in one.names}
        own = {r"\tau"} if _IS_TIME.search(self.paper.expanded.text) else set[str]()
        return (frozenset({"t"}) | own | marks | given) & self.paper.words.times

    @cached_property
    def unread_matrices(self) -> frozenset[str]:
        """The letters that are matrices, and were read as numbers: nothing gives their elements."""
        return frozenset(n for n in matrices_in_words(self.paper) if n not in self.later)

    @cached_property
    def later(self) -> dict[str, list[SourceStatement]]:
        """The statements that have a name alone on their left, by this name: they may define it."""
        found: dict[str, list[SourceStatement]] = {}
        for item in self.items:
            if item.bare and item.members[0] == Name(item.bare[0]) and not item.derives:
                if not any(map(is_numerical, item.members)):
                    found.setdefault(item.bare[0], []).append(item)
        return found

    @cached_property
    def functions(self) -> dict[str, list[Unknown]]:
        """The functions of which nothing gives the values, by the names of these and derivatives.

        What is called a function of the time for a later system only is a constant here.
        """
        end = max((item.typed.end for item in self.items), default=0)
        since, every = self.paper.told_since, self.paper.functions_by_name
        return {name: own for name, own in every.items() if since.get(name, 0) <= end}

    @cached_property
    def special_numbers(self) -> list[SourceStatement]:
        """The statements that give a number to a letter that counts."""
        return [
            one
            for one in self.items
            if len(one.members) == 2
            and one.members[0] in {Name(name) for name in self.paper.numbers}
            and isinstance(one.members[1], Number)
        ]

    @cached_property
    def unreadable(self) -> frozenset[str]:
        """The names that stand alone on a side of what cannot be read.

        Where it gives what moves, the vectors by which it does so are not known either.
        """
        found: set[str] = set()
        for item in self.items:
            if item.formula is None:
                with suppress(NotationError, IndexError):
                    heads = {called(name) for name in item.printed.heads.names}
                    found |= heads
                    if any(map(self.moves, heads)):
                        bold = {*bold_letters(item.printed.tex)}
                        found |= {
                            v for v in self.names.vectors if v.rpartition("{")[2][:-1] in bold
                        }
        return frozenset(found - {one.other_time for one in self.clocks} - {*self.functions})

    def enter(self, item: SourceStatement, role: StatementRole) -> None:
        """Keep what a statement says."""
        self.roles[item] = role
        self.borrow(item, role)
        if role.name == ASSUMPTION:
            self.assumptions.append(item)
        if role.kind == "unit" or (role.name == CLAIM and item.printed.heads.squares[:1] == ("i",)):
            self.units.append(item)
        if role.kind == "clock":
            self.clocks.append(item)
        used = item.members or role.name == LAW
        if item.formula is not None and used and role.name != CONVENTION:
            for name in item.names:
                self.seen.setdefault(name, item)

    def borrow(self, item: SourceStatement, role: StatementRole) -> None:
        """Let a statement define its names."""
        for name in role.names if role.name in NAMING else ():
            found = self.definitions.setdefault(called(name), [])
            found += [item] if item not in found else []

    # -- names ---------------------------------------------------------------------

    @property
    def levels(self) -> set[str]:
        """The names of the values of integrals: they stand for what moves, and are constant."""
        own = (one for one in self.roles.values() if one.kind == "integral" or one.name == LEVEL)
        return {name for role in own for name in (*role.names, role.value) if name}

    def law_of(self, item: SourceStatement) -> Law | None:
        """The law of which a statement is a part."""
        return next((law for law in self.laws if item in law.printed), None)

    def moves(self, name: str) -> bool:
        """Whether a name is a variable of a law, an image of one, or a vector of such."""
        parts = self.names.vectors.get(name, (name,))
        images = (new for law in self.laws for _, new in law.images)
        return any({*parts} & {*law.variables} for law in self.laws) or name in images

    def is_step(self, name: str) -> bool:
        """Whether a name is that of a term of a sequence that a map gives, as :math:`x_{n+5}`."""
        images = (new for law in self.laws for _, new in law.images)
        own = _sequence(name)
        return own is not None and any(_sequence(new) == own for new in images)

    def definition(self, name: str, item: SourceStatement) -> SourceStatement | None:
        """What defines a name where it stands in a statement: the last before it, or the next."""
        found = self.definitions.get(name, [])
        before = [one for one in found if one.order <= item.order]
        return before[-1] if before else found[0] if found else None

    def is_defined(self, name: str) -> bool:
        """Whether a name stands for something, itself or as a component."""
        return name in self.definitions or self.names.whole(name) in self.definitions

    def is_known(self, name: str) -> bool:
        """Whether a name has been used, or moves."""
        return name in self.seen or self.is_defined(name) or self.moves(name)

    def below(self, name: str) -> set[str]:
        """A name, and all names that it stands for, in the end."""
        found: set[str] = set()
        waiting = [name]
        while waiting:
            one = waiting.pop()
            if one in found:
                continue
            found.add(one)
            if self.moves(one):
                continue
            whole = self.names.whole(one)
            by = self.definitions.get(one) or self.definitions.get(whole) or self.later.get(one, [])
            waiting += [other for item in by for other in item.names]
            waiting += [x for own in self.functions.get(one, ()) for x in own.by]
        return found

    def has_velocities(self, name: str) -> bool:
        """Whether rates stand in what defines a name, or in what defines names in that."""
        by = (one for below in self.below(name) for one in self.definitions.get(below, ()))
        return not self.moves(name) and any(one.derives for one in by)

    def is_explained(self, name: str) -> bool:
        """Whether a law, a definition, a supposition, or words say anything of a name."""
        named = any(item.formula == Name(name) for item in self.items)
        named = named or any(name in self.roles[one].names for one in self.assumptions)
        mentioned = any(name in law.mentions for law in self.laws)
        used = named or mentioned or self.is_length(name) or name in self.later
        return used or self.moves(name) or self.is_defined(name)

    def is_length(self, name: str) -> bool:
        r"""Whether a vector has this letter that moves, is given, or has its square beside it.

        Where the letter gives the vector, as in :math:`\mathbf B=B\mathbf e_z`, it has either sign.
        """
        own = (one for one in self.names.vectors if symbol(one).without_type.name == name)
        return any(
            name not in self.below(one)
            and (self.is_defined(one) or self.moves(one) or self._is_divided(one, name))
            for one in own
        )

    def _is_divided(self, vector: str, letter: str) -> bool:
        r"""Whether a vector is divided by the square of its letter, which stands nowhere else.

        So :math:`\mathbf E\times\mathbf B/B^2` is a velocity of drift.
        """
        formulas = [item.formula for item in self.items if item.formula is not None]
        nodes = [node for formula in formulas for node in formula.nodes()]
        square = Power(Name(letter), Number(2))
        return nodes.count(Name(letter)) == nodes.count(square) and any(
            isinstance(node, Quotient)
            and vector in node.numerator.names()
            and square in (node.denominator, *node.denominator.children())
            for node in nodes
        )

    def untied(self, constants: Iterable[str]) -> list[str]:
        """The constants that no law has, and nothing for which a name of a law stands."""
        mentioned = {name for law in self.laws for name in self.names.scalars(law.mentions)}
        below = {name for own in mentioned for name in self.names.scalars(self.below(own))}
        return [name for name in constants if name not in mentioned | below]

    def varies(self, name: str) -> bool:
        """Whether a name moves, or stands for something that does."""
        return any(map(self.moves, self.below(name)))

    # -- suppositions ----------------------------------------------------------------

    def supposed(self, item: SourceStatement) -> list[SourceStatement]:
        """The assumptions about constants that are in force at a statement, the latest first.

        They hold to the end of their section, or of their theorem with its proof; a later one
        about the same constants takes the place of an earlier one. One that stands behind a claim
        of its sentence, as in “F is an integral if a=0”, is of this claim only. A case that words
        name comes before all.
        """
        found = self._named(item)
        taken = {name for one in found for name in self.roles[one].names}
        for one in sorted(self.assumptions, key=lambda one: -one.order):
            if not self._is_in_force(one, item):
                continue
            names, kind = {*self.roles[one].names}, self.roles[one].kind
            if kind == "inequality":
                mates = {other for other in found if self.roles[other].kind == kind}
                anew = any(
                    other.names == one.names and other.sentence != one.sentence for other in mates
                )
                found += [] if anew or names & taken else [one]
                continue
            if not names & taken:
                found.append(one)
            taken |= names
        return found

    def _named(self, item: SourceStatement) -> list[SourceStatement]:
        """What is supposed of constants in the case that the words before a statement name."""
        about = ("", "of the sentence", FUNCTION)
        fixed = [one for one in self.assumptions if self.roles[one].kind in about]
        named = named_case(item, fixed, self.paper.prose)
        words = self._conditions_at(item)
        cited = [one for one in fixed if one not in named and is_cited_as_condition(one, words)]
        return [*named, *cited]

    def _conditions_at(self, item: SourceStatement) -> str:
        """The words before a statement in its sentence, or all of one that the proof is of."""
        prose, (start, _) = self.paper.prose, item.theorem or item.sentence
        words = prose.text[item.sentence[0] : item.typed.start]
        proof = prose.text.find(r"\begin{proof", start, item.typed.start)
        behind = (prose.text[stop:proof] for stop in prose.stops if start < stop < proof)
        if proof < 0 or any(re.search(r"\w", _END.sub("", one)) for one in behind):
            return words  # of several sentences it is not seen which one the proof is of
        return f"{prose.text[start:proof]} {words}"

    def _is_in_force(self, one: SourceStatement, item: SourceStatement) -> bool:
        clauses = self._clauses(one.sentence)
        if one in clauses.conditions and one.sentence == item.sentence and item in clauses.of:
            return one in clauses.of[item] and self.reaches(one, item)
        if one.sentence == item.sentence and self._introduces(one):
            return True
        if one.sentence != item.sentence and self._is_told_apart(one):
            return False
        before = one.order < item.order and one not in clauses.behind
        before = before and not has_what_vanishes(item, one)
        over = not self._has_length(one, item) and self._is_lifted(one, item)
        return before and self.reaches(one, item) and not over

    def _introduces(self, one: SourceStatement) -> bool:
        """Whether a display says what a letter is that its sentence prints first: “at a with …”."""
        if one.typed.inline or not _WITH.fullmatch(one.lead):
            return False
        before = (other for other in self.items if other.sentence[1] <= one.sentence[0])
        return not one.names <= {name for other in before for name in other.names}

    def _is_told_apart(self, one: SourceStatement) -> bool:
        return is_told_apart(one, self.of_sentence(one.sentence))

    def _is_lifted(self, one: SourceStatement, item: SourceStatement) -> bool:
        return is_lifted(one, item, self._lifting, self.assumptions, self.paper.prose)

    @cached_property
    def _lifting(self) -> list[SourceStatement]:
        return [one for one in self.items if may_lift(one)]

    def _clauses(self, sentence: tuple[int, int]) -> Clauses:
        claims = {
            one: self.roles[one].name == CLAIM
            for one in self.of_sentence(sentence)
            if one in self.roles and self.roles[one].name in (CLAIM, ASSUMPTION)
        }
        return Clauses(claims, claims)

    def of_sentence(self, sentence: tuple[int, int]) -> Sequence[SourceStatement]:
        """The statements of a sentence, in their order; what a comment supposes stands in none."""
        return self._sentences.get(sentence, ())

    @cached_property
    def _sentences(self) -> dict[tuple[int, int], list[SourceStatement]]:
        """The statements of each sentence, in their order."""
        found: dict[tuple[int, int], list[SourceStatement]] = {}
        for one in sorted(self.paper.items, key=lambda one: one.order):
            found.setdefault(one.sentence, []).append(one)
        return found

    @property
    def bound(self) -> list[SourceStatement]:
        """The constraints of the motion, with their derivatives."""
        return [one for one in self.assumptions if self.roles[one].kind == CONSTRAINT]

    def _together(self, item: SourceStatement) -> list[SourceStatement]:
        """The equations that give names of a statement together."""
        giving = [(law.new, law.together) for law in self.laws if law.together]
        names = {inner for name in item.names for inner in self.below(name)} if giving else set()
        return [
            one for given, equations in giving for one in equations if not names.isdisjoint(given)
        ] + self.rooted_at(item)

    def rooted_at(self, item: SourceStatement) -> list[SourceStatement]:
        """What the coefficients of polynomials say of the roots that have names in a statement.

        These are those that were named last, if some were named several times.
        """
        found: dict[str, list[SourceStatement]] = {}
        for names, equations in self.rooted:
            own = equations[0].order
            here = own <= item.order or any(
                one.order == own for one in self.of_sentence(item.sentence)
            )
            found |= dict.fromkeys(names, equations) if here else {}
        below = {inner for name in item.names for inner in self.below(name)} if found else set()
        every = [one for name, own in found.items() if name in below for one in own]
        return [*dict.fromkeys(every)]

    def supposed_elsewhere(self, item: SourceStatement) -> list[list[SourceStatement]]:
        """The assumptions about constants, by sentences, that are not in force at a later place."""
        found: dict[tuple[int, int, int], list[SourceStatement]] = {}
        here = self.supposed(item)
        for one in self.assumptions:
            role = self.roles[one]
            brief = role.kind in ("", "of the sentence") or role.kind.startswith(FUNCTION)
            brief = brief or self._is_told_apart(one)
            near = one.order < item.order or one.sentence == item.sentence
            if near and one not in here and brief:
                case = 0  # of a list of values each is another one
                while any(
                    self.roles[o].names == role.names for o in found.get((*one.sentence, case), ())
                ):
                    case += 1
                found.setdefault((*one.sentence, case), []).append(one)
        return [*found.values()]

    def sets(self, item: SourceStatement) -> list[SourceStatement]:
        """The sets of the phase space that are supposed, to the end of their section.

        A later assumption about the same one name, as x > 0 after x = 0, takes the place of one.
        """
        bound = [one for one in self.bound if one.order < item.order or one.section is item.section]
        bound += self._together(item)
        before = [one for one in self.assumptions if one.order < item.order and one not in bound]
        last = {one.names: one for one in sorted(before, key=lambda one: one.order)}
        return [one for one in bound if one is not item] + [
            one
            for one in before
            if (
                self.roles[one].kind == "set in force"
                and self.is_within(one, item)
                and not self._is_lifted(one, item)
                and (len(one.names) != 1 or last[one.names] is one)
            )
            or (self.roles[one].kind == "set of the sentence" and one.sentence == item.sentence)
            or (self.roles[one].kind == NAMED_LEVEL and self._has_value(one, item))
            or (
                self.roles[one].kind == NORMALISED
                and last[one.names] is one
                and self._has(one, item)
            )
        ]

    def _has(self, normalised: SourceStatement, item: SourceStatement) -> bool:
        """Whether a statement has all names of a normalisation that no law has."""
        mentioned = {name for law in self.laws for name in law.mentions}
        if normalised.rates or not any("'" in name for name in normalised.names):
            return True
        below = {inner for name in item.names for inner in self.below(name)}
        return normalised.names - mentioned <= below

    def _has_value(self, level: SourceStatement, item: SourceStatement) -> bool:
        """Whether the value that a level gives to an integral is spoken of in a statement."""
        if level.sentence == item.sentence:
            return True
        (value,) = level.names - {*self.roles[level].names}
        named = any(value in self.below(name) for name in item.names)
        return named and self.is_within(level, item)

    def reaches(self, one: SourceStatement, item: SourceStatement) -> bool:
        """Whether what is said at a statement is in force at another one."""
        kind = self.roles[one].kind
        if kind.startswith("set") or kind in (CONSTRAINT, BEGINNING, UNKNOWNS):
            return False
        if kind.endswith("of the sentence"):
            here = one.sentence == item.sentence or names_case(one, item)
            return here or proves(one, item, self.items, self.paper.prose)
        if kind == FUNCTION and one.section is not item.section:
            return False
        return self.is_within(one, item) and goes_on(
            one, item, self._is_special(one), self.paper.prose
        )

    def _is_special(self, one: SourceStatement) -> bool:
        """Whether an equation is one between constants of laws, or makes one of them zero.

        An inequality is one where its sentence says what is stable.
        """
        if not one.members:
            return self.roles[one].kind == "inequality" and bool(cue("stable", one.words))
        mentioned = {name for law in self.laws for name in self.names.scalars(law.mentions)}
        compared = len(one.names) > 1 or Number(0) in one.members
        return len(one.members) > 1 and compared and {*one.names} <= mentioned

    def is_within(self, one: SourceStatement, item: SourceStatement) -> bool:
        """Whether a statement stands where another one holds: in its item of a list, or theorem.

        Outside of theorems that is its section, or all that follows, as words say; what is said in
        a footnote is said there.
        """
        aside = self.paper.prose.footnote(one.typed.start)
        for place in filter(None, (one.entry, aside)):
            if not place[0] <= item.typed.start < place[1]:
                return False
        if one.theorem is not None:
            return one.theorem == item.theorem
        if len(one.sections) == 1 and cue("in this part", one.before):
            return one.section is item.section  # what stands before the first heading is a part
        lasting = lasts_to_the_end(one) or self._has_length(one, item)
        return one.section in item.sections or (one.order < item.order and lasting)

    def _has_length(self, one: SourceStatement, item: SourceStatement) -> bool:
        r"""Whether a letter stands in a statement by which, along an axis, its vector was given.

        So does :math:`\mathbf B=B\mathbf e_z`: of another field the letter is not that.
        """
        match one.members:
            case (Name(vector), Product() as given) if vector in self.names.vectors:
                letter = symbol(vector).without_type.name
                along = Name(letter) in given.factors and letter not in self.names.vectors
                return along and any(letter in self.below(name) for name in item.names)
        return False

    def special(self, law: Law) -> list[SourceStatement]:
        """The assumptions about the constants of a law for which it is printed anew."""
        first = law.items[-1]
        assert law.restates is not None
        below = {one for name in law.restates.mentions for one in self.below(name)}
        mentioned = {*self.names.scalars(below)} | below
        supposed = (one for one in self.supposed(first) if one.members)
        return [one for one in supposed if {*self.roles[one].names} & mentioned]

    def cited(self, item: SourceStatement) -> Iterator[SourceStatement]:
        """The statements that are cited in a sentence."""
        for label in item.refs:
            yield from (one for one in self.paper.labels.get(label, ()) if one is not item)

    def varying(self, names: Iterable[str]) -> list[str]:
        """The names that move, or stand for something that does."""
        return [name for name in names if self.varies(name)]


_IS_TIME = re.compile(
    r"(?:(?<![A-Za-z])d|\{\s*d\s*\}|\\mathrm\s*d)\s*\\tau|\((?:\\tau|[-+]?\s*t?\s*[-+]\s*\\tau)\s*\)|(?<![A-Za-z\d})])\\tau\s*&?=|\\tau\s*[-+]\s*(?:\\tau|t)_?0"
    r"|\b(?:times?|врем\w+)[\s~,]*(?:\w+\s+){0,2}\$?\s*\\tau|\\(?:sin|cos|tan|sinh|cosh|exp|ln)\s*(?:\w|\\[a-z]+)?\s*\\tau"
)
"""What makes a time of this letter."""
_STEP = re.compile(r"([a-z])(?:[+-]\d+)?")
_WITH = re.compile(
    r"[\s,;~]*(?:with|where|for\s+which|such\s+that|где|для\s+котор\w+)[\s:~]*", re.IGNORECASE
)
"""Words behind which a display says what a letter before it is."""


def _sequence(name: str) -> tuple[str, str] | None:
    """The letter and the index of a term of a sequence; ``None`` if a name is none."""
    parts = symbol(name)
    step = _STEP.fullmatch(parts.index)
    return (replace(parts, index="").name, step[1]) if step else None
