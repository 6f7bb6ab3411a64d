"""What does not scale as all the rest of a paper does: a misprint may stand there.

By all else that is printed a name, or a rate, may have a dimension; a formula by which it has none
disagrees with the rest. It is suspected only if one change lets it agree in all its terms: many a
paper takes units in which something is 1. Where the time has none, its law does so.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    Vector,
    to_latex,
)
from kowalevski_cas.notation.edits import replace, subtree
from kowalevski_cas.notation.errors import closeness
from kowalevski_cas.notation.formula import times
from kowalevski_cas.notation.misprints import Misprint, factors_of, misprints
from kowalevski_cas.notation.scales import MODULUS, TIME, Scale, Scales, Span
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.formulas import BY_NO_TIME, tree_of
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, DEFINITION, LAW, LEVEL, Known
from kowalevski_cas.reading.statements import SourceStatement, is_numerical
from kowalevski_cas.reading.text import TextSection
from kowalevski_cas.verify.vacuous import ALIKE, is_trivial

AS_THE_REST = "it would scale as the rest with"
"""The words for repairs."""

SAYING = (CLAIM, DEFINITION, LAW, LEVEL)
"""The roles of statements of which all terms scale alike."""

EVIDENCE = 2
"""How many other sums have to say of what has a dimension how it scales."""

MANY = 8
"""Where more statements than these may each be the one that disagrees, units are chosen."""

MOST = 3
"""How many repairs are told."""

_OF_LAWS = ("exponent", "index", "letter", "power", "factor")
_KINDS = (*_OF_LAWS, "missing", "exchange")
"""The kinds of slips that change how something scales, the likelier ones first.

Units are chosen so that constants of a law are 1: nothing is missing there.
"""


class Misscaled(NamedTuple):
    """A statement that scales as nothing else does, and what would have no dimension by it."""

    item: SourceStatement
    formula: Formula
    atom: Scale
    repairs: tuple[tuple[Misprint, Formula], ...]
    """The likeliest slips, each with the formula without it, which scales as all the rest."""


def misscaled(known: Known) -> list[Misscaled]:
    """The statements of a part that scale as nothing else does in their section, and by the laws.

    In another section a letter may be another quantity.
    """
    rows = {row for law in known.laws for row in law.rows}
    sections: dict[TextSection | None, list[SourceStatement]] = {}
    for one in known.items:
        sections.setdefault(next(iter(one.sections[1:2]), None), []).append(one)
    found: list[Misscaled] = []
    for items in sections.values():
        beside = [one for one in known.items if one in rows and one not in items]
        strange = _Dimensions(known, [*items, *beside]).misscaled()
        found += [one for one in strange if one.item in items]
    return found


def _says_several_rates(item: SourceStatement) -> bool:
    """Whether a statement gives the rates of a column: it says as much as several others."""
    nodes = item.formula.nodes() if item.formula is not None else ()
    return item.derives and any(isinstance(node, Vector) for node in nodes)


class _Dimensions:
    """What some statements of a part say of how their names scale."""

    def __init__(self, known: Known, items: Sequence[SourceStatement]) -> None:
        self.known = known
        marks = {mark for one in known.items for mark in one.marks}
        waves = (one for one, role in known.roles.items() if role.name == DEFINITION)
        # not the time, where that has dots, or a travelling variable is given by it
        other = marks - {"prime"} or any(TIME in one.names and not one.derives for one in waves)
        self.primed = "prime" if other else TIME
        self.formulas = {
            one: tree for one in known.items if (tree := _said(one, known)) is not None
        }
        self.said = {one: Scales(tree, self.primed) for one, tree in self.formulas.items()}
        roles = known.roles
        self.supposed = {one for one in self.said if roles[one].name == ASSUMPTION}
        self.counts = Counter(name for scales in self.said.values() for name in scales.names)
        displays: dict[int, list[SourceStatement]] = {}
        for one in self.said:
            displays.setdefault(id(one.typed), []).append(one)
        self.groups = [
            [[one] for one in self.said],
            [own for own in displays.values() if len(own) > 1 and all(map(self._defines, own))],
        ]

    def _defines(self, one: SourceStatement) -> bool:
        return self.known.roles[one].name == DEFINITION

    def misscaled(self) -> Iterator[Misscaled]:
        """What scales as nothing else, taken by itself, or with all that its display says."""
        found: set[SourceStatement] = set()
        whole = self._span(self.said)
        several = {
            frozenset(atom.items()): atom for own in self.said.values() for atom in own.atoms
        }
        killed = [atom for atom in several.values() if atom and atom in whole]
        for groups in self.groups:
            lost: dict[SourceStatement, list[Scale]] = {}
            spans: dict[SourceStatement, Span] = {}
            inside = {one for group in groups for one in group}
            base = self._span([one for one in self.said if one not in inside | found])
            for group, others in self._without_each(groups, base):
                for one in group:
                    spans[one] = self._with_pure(one, others)
                    atoms = [atom for atom in killed if atom not in spans[one]]
                    if (
                        atoms
                        and one not in self.supposed
                        and not any(map(is_numerical, one.members))
                        and not _says_several_rates(one)
                        and not (self.known.roles[one].name == LAW and {TIME: 1} in spans[one])
                    ):
                        lost[one] = self._lost(one, atoms, spans[one])
            if len(lost) > MANY:
                continue
            mended = {one: self._repairs(one, spans[one]) for one in lost}
            lost = {one: atoms for one, atoms in lost.items() if atoms and mended[one]}
            for one in [one for one in lost if one not in found]:
                if self._evidence(one, lost[one]) >= EVIDENCE and not self._is_rivalled(one, lost):
                    found.add(one)
                    yield Misscaled(one, self.formulas[one], lost[one][0], mended[one])

    def _span(self, items: Iterable[SourceStatement], base: Span | None = None) -> Span:
        """All that some statements say, beside what was said."""
        found = base.copy() if base is not None else Span()
        for one in items:
            for scale in self.said[one].all:
                found.add(scale)
        return found

    def _with_pure(self, item: SourceStatement, others: Span) -> Span:
        """What is said, with the arguments of a statement: nobody forgets these."""
        found = others.copy()
        for scale in self.said[item].pure:
            found.add(scale)
        return found

    def _lost(self, item: SourceStatement, atoms: Sequence[Scale], others: Span) -> list[Scale]:
        """Of what has a dimension by others that which has none by a statement."""
        with_it, own = self._span([item], others), self.said[item].names
        new = {name for name in own if self.counts[name] == 1}
        if others.explains(self.said[item].all, new):
            return []  # it says no more than how these scale
        alike = self._with_alike(own, others)
        found = [
            one for one in atoms if one in with_it and one not in alike and not one.keys() <= new
        ]
        beside = _beside_numbers(item)  # as an angle and its deviation from π
        if any({name: 1} in others for name in beside):
            found = [atom for atom in found if not atom.keys() <= beside | {TIME}]
        return sorted(found, key=lambda atom: own.isdisjoint(atom))

    def _with_alike(self, names: Collection[str], others: Span) -> Span:
        """What is said, if letters with several indices scale alike where others say no more."""
        found = others.copy()
        for one, other in combinations(sorted(names), 2):
            if symbol(one).letter == symbol(other).letter:
                ratio = {one: 1, other: -1}
                if others.rest(ratio).keys() <= ratio.keys():
                    found.add(ratio)
        return found

    def _without_each(
        self, groups: Sequence[list[SourceStatement]], base: Span
    ) -> Iterator[tuple[list[SourceStatement], Span]]:
        """Each of some groups of statements, with what all the others say."""
        if len(groups) < 2:
            yield from ((group, base) for group in groups)
            return
        half = len(groups) // 2
        for part, rest in ((groups[:half], groups[half:]), (groups[half:], groups[:half])):
            more = self._span((one for group in rest for one in group), base)
            yield from self._without_each(part, more)

    def _evidence(self, item: SourceStatement, lost: Sequence[Scale]) -> int:
        """How many other sums say how that scales which would have no dimension."""
        names = {name for atom in lost for name in atom}
        several = (
            scale for one, own in self.said.items() if one is not item for scale in own.alike
        )
        return sum(not names.isdisjoint(scale) for scale in several)

    def _is_rivalled(
        self, item: SourceStatement, lost: Mapping[SourceStatement, list[Scale]]
    ) -> bool:
        """Whether another statement may be the wrong one as well: the rest agrees with neither."""
        rivals = [
            one
            for one in lost
            if one is not item
            and one.typed is not item.typed
            and any(atom in lost[item] for atom in lost[one])
        ]
        rest = self._span(one for one in self.said if one not in (item, *rivals))
        agreeing = [
            sum(bool(scale) and scale in rest for scale in self.said[one].alike)
            for one in (item, *rivals)
        ]
        return bool(rivals) and agreeing[0] >= min(agreeing[1:])

    def _repairs(self, item: SourceStatement, others: Span) -> tuple[tuple[Misprint, Formula], ...]:
        """The changes by which a statement scales as all the rest, the likelier ones first."""
        formula = self.formulas[item]
        others_names = {
            name for one in self.said if one is not item for name in self.said[one].names
        }
        new = self.said[item].names - others_names
        scalars = self.known.paper.words.scalars - {*item.bare[:1]} - self.known.times
        own, near = scalars & formula.names(), scalars & others_names
        kinds = _OF_LAWS if self.known.roles[item].name == LAW else _KINDS
        for offered in (own, near - own) if self._defines(item) else (own,):
            found: dict[Formula, tuple[tuple[object, ...], Misprint]] = {}
            slips = misprints(formula, self.known.paper.words, offered)
            for slip in (*slips, *_missing(formula, sorted(offered))):
                kind, path, replacement, _ = slip
                if kind in kinds and path != (0,) and _may_be(formula, path, replacement):
                    edited = replace(formula, path, replacement)
                    scales = Scales(edited, self.primed)
                    if others.explains(scales.all, new) and not is_trivial(edited):
                        lines = sum(isinstance(node, Quotient) for node in edited.nodes())
                        order = kinds.index(kind), path[:1] == (0,), lines
                        found.setdefault(edited, (order, slip))
            if found:
                best = sorted(found, key=lambda edited: found[edited][0])[:MOST]
                return tuple((found[edited][1], edited) for edited in best)
        return ()


def _beside_numbers(item: SourceStatement) -> set[str]:
    """The letters that an equation adds to a number, and to which it makes that equal."""
    found = {*item.bare}
    for one in item.members:
        if isinstance(one, Sum) and any(map(is_numerical, one.terms)):
            bare = (t.argument if isinstance(t, Negative) else t for t in one.terms)
            found |= {term.name for term in bare if isinstance(term, Name)}
    return found if len(found) > len(item.bare) else set()


def _said(one: SourceStatement, known: Known) -> Formula | None:
    """A formula of which all terms scale alike; what derives by no time is not read otherwise.

    A number is a value of what moves at a place, but of a constant in chosen units.
    """
    role = known.roles.get(one)
    if one.trouble == BY_NO_TIME:
        return tree_of(one.printed.display.tex, one.printed.number, known.paper.words)
    numbers = any(map(is_numerical, one.members))
    if (
        role is None
        or role.kind == "another-law"
        or (numbers and one.bare and known.varying(one.names))
    ):
        return None
    return one.formula if role.name in SAYING or (role.name == ASSUMPTION and one.members) else None


def _may_be(formula: Formula, path: tuple[int, ...], new: Formula) -> bool:
    """Whether a change puts no name for one of another kind, nor raises or derives by one more.

    No sum, and no rate, is left out as a factor.
    """
    old = subtree(formula, path)
    lost = {*old.nodes()} - {*new.nodes(), old}
    if isinstance(old, Product) and any(isinstance(node, Sum | Derivative) for node in lost):
        return False
    above = ((subtree(formula, path[:k]), index) for k, index in enumerate(path))
    if new.names() and any(isinstance(node, Power) and index == 1 for node, index in above):
        return False
    if isinstance(old, Name) and isinstance(new, Name):
        return closeness(old.name, new.name) >= ALIKE
    return not isinstance(new, Derivative) or new in old.nodes()


def _missing(formula: Formula, names: Sequence[str]) -> Iterator[Misprint]:
    """What is missing: the square of a name as a factor, or a name or its square as a divisor."""
    waiting: list[tuple[tuple[int, ...], Formula, Formula | None]] = [((), formula, None)]
    while waiting:
        path, node, parent = waiting.pop()
        waiting += [((*path, k), child, node) for k, child in enumerate(node.children())]
        is_term = isinstance(parent, Sum | Relation | Negative) and not isinstance(node, Sum)
        if isinstance(node, Partial) and not isinstance(parent, Partial):
            words = f"derive ${to_latex(node)}$ once more by ${node.by}$"
            yield "missing", path, Partial(node, node.by), words
        if isinstance(node, Number | Negative | Quotient) and not isinstance(parent, Quotient):
            continue
        for name in names if is_term or isinstance(parent, Quotient) else ():
            square, shown_node = Power(Name(name), Number(2)), to_latex(node)
            words = f"insert the factor ${name}^2$ in ${shown_node}$"
            yield "missing", path, times(*factors_of(node), square), words
            for by in (Name(name), square) if is_term and name not in node.names() else ():
                words = f"divide ${shown_node}$ by ${to_latex(by)}$"
                yield "missing", path, Quotient(node, by), words


def shown(scale: Scale) -> str:
    """A product of powers as it is told: the rate of a name has a dot."""
    (name, power), *more = [(n, e) for n, e in scale.items() if n != TIME] or [(TIME, 1)]
    order = -scale.get(TIME, 0) % MODULUS
    if not more and power == 1 and order in (0, 1, 2):
        return (name, rf"\dot{{{name}}}", rf"\ddot{{{name}}}")[order]
    return name
