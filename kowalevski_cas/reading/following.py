"""What does not follow from what is printed before it, and would with one change.

A step of a derivation is looked at by itself: what stands before it in its section is put in, all
other letters, derivatives and unknown functions are free. A step that fails is doubted only if it
follows when one token of it is another one: what else it may rest on is not known.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from kowalevski_cas.algebra.keys import is_initial, variable_of
from kowalevski_cas.algebra.quadrature import INFINITE
from kowalevski_cas.algebra.samples import precisely
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Relation,
    Root,
    Sum,
    Vocabulary,
    to_latex,
)
from kowalevski_cas.notation.edits import replace, subtree
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.expansions import expansions_of
from kowalevski_cas.reading.free_formulas import free_formulas, single_functions
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, NOTATION, OTHER, Known
from kowalevski_cas.reading.premises import has_integral, pairs_of
from kowalevski_cas.reading.slips import KINDS, is_integrated, may_be, slips
from kowalevski_cas.reading.statements import SourceStatement, is_numerical
from kowalevski_cas.reading.steps import DerivationStep, PrintedBefore
from kowalevski_cas.reading.variational import rates_behind, says_rates
from kowalevski_cas.verify.vacuous import is_trivial

_ANOTHER = re.compile(
    r"\b(?:instead|replac\w+|without|twice|double\w*|half(?![\s-]ax)|(?<!each\s)other|another|new"
    r"|inverted|upside|opposite|revers\w+"
    r"|(?:second|third)\s+(?:spring|mass|bod(?:y|ies)|force|particle|charge|case))\b"
    r"|\b(?:вместо|замен\w+|друг\w+|нов\w+|вдвое)\b",
    re.IGNORECASE,
)
"""Words that may change what stands before."""

_FORCE = re.compile(r"\b(?:friction|damp\w+|трени\w+)\b", re.IGNORECASE)
"""Words for what may come to what stands before, unless a formula behind them has it."""

MOST = 3
"""How many repairs are told."""

_OF_ALL = ("identity", "integral", "solution", "constant", "energy")
"""The kinds of claims that are made of no set."""

OF_SENTENCE = "of the sentence"

_STEP = re.compile(
    r"\bor\W*$|\bi\.\s*e\b|\bthat\s+is\b|\bnamely\b|\bsol(?:ved?|utions?|ving)\b|\bsubstitut\w*"
    r"|\badding\s+(?:both|them|these|the\s+(?:two\s+)?equations|up)\b|\bsubtracting\b|\beliminat\w+"
    r"|\b(?:this|which|it|that)\s+(?:reads|says|means)\b|\bthe\s+equation\s+reads\b"
    r"|\binsert\w*|\binto\b|\bmultipl\w+|\bdivid\w+|\bintegrat\w+|\bdifferentiat\w+|\bor\b"
    r"|\bили\b|\bто\s+есть\b|\bреш\w+|\bподстав\w*|\bумнож\w*|\bделя\w*|\bразделив\w*"
    r"|\bскладывая\b|\bвычитая\b|\bисключ\w+",
    re.IGNORECASE,
)
"""Words before a step."""


class Step(NamedTuple):
    """A step that follows, or that does not, with the steps that would, the likelier ones first."""

    item: SourceStatement
    repairs: tuple[Formula, ...]
    follows: bool = False


def steps(
    known: Known,
    asked: frozenset[SourceStatement],
    doubted: frozenset[SourceStatement],
    left: frozenset[SourceStatement],
) -> Iterator[Step]:
    """The steps among those ``asked`` that follow with one change only, or follow though doubted.

    What is doubted is looked at whatever the words are; nothing is built on what is ``left``.
    """
    formulas = free_formulas(known.paper, known.items)
    sections: dict[int, list[SourceStatement]] = {}
    for one in known.items:
        sections.setdefault(id(one.section), []).append(one)
    for items in sections.values():
        yield from _Section(items, formulas, known).steps(asked, doubted, left)


class _Section:
    """The statements of a section that say something, in their order."""

    def __init__(
        self,
        items: Sequence[SourceStatement],
        formulas: Mapping[SourceStatement, Formula],
        known: Known,
    ) -> None:
        self.known = known
        self.formulas = {one: formulas[one] for one in items if one in formulas}
        self.said = [one for one in self.formulas if _says(one, self.formulas[one], known)]
        self.words: Vocabulary = known.paper.words

    def steps(
        self,
        asked: frozenset[SourceStatement],
        doubted: frozenset[SourceStatement],
        left: frozenset[SourceStatement],
    ) -> Iterator[Step]:
        """The steps that follow with one change only; what rests on one is read with it.

        Where what words explain behind a step is wrong, the step may be right.
        """
        mended: dict[SourceStatement, Formula] = {}
        for item in self.said:
            formula = self.formulas[item]
            if item not in asked or not (item in doubted or self._is_step(item)):
                continue
            sure = [one for one in self._before(item) if one in mended or one not in left]
            premises = [mended.get(one, self.formulas[one]) for one in sure]
            premises += rates_behind(item, sure, self.formulas, self.known)
            premises += self._at_arguments([formula, *premises])
            before = PrintedBefore(formula, premises, self._terms(item))
            if repairs := self._repairs(formula, before):
                if all(one.order < item.order for one in sure):
                    mended[item] = repairs[0]
                yield Step(item, repairs)
            elif item in doubted:
                with precisely():
                    if DerivationStep(formula, before).follows():
                        yield Step(item, (), follows=True)

    def _at_arguments(self, formulas: Sequence[Formula]) -> Iterator[Formula]:
        """What unknown functions without an argument are, beside others at one, as F and F(1/u)."""
        nodes = (node for formula in formulas for node in formula.nodes())
        applied = {node.function for node in nodes if isinstance(node, Application)}
        for name, by in single_functions(self.known.paper).items():
            if name in applied:
                yield Relation((Name(name), Application(name, (Name(by),))), ("=",))

    def _is_step(self, item: SourceStatement) -> bool:
        """Whether a statement is a chain, derives what is given, or words let it follow.

        A total derivative by partial ones follows from nothing.
        """
        words, formula = f"{item.before} ", self.formulas[item]
        if expansions_of(formula):
            return not (item.typed.inline or _ANOTHER.search(words))
        if cue("when", words) or cue("place", words) or _ANOTHER.search(words):
            return False
        if _FORCE.search(self._behind(item)):
            return False
        pairs = pairs_of(formula)
        derived = pairs[0][0]
        while isinstance(derived, Derivative):
            derived = derived.argument
        given = (self.formulas[one] for one in self.said if one.order < item.order)
        derives = derived != pairs[0][0] and any(pairs_of(one)[0][0] == derived for one in given)
        partial = {node.argument for node in formula.nodes() if isinstance(node, Partial)}
        told = cue("claim", words) or _STEP.search(words) or says_rates(item)
        said = len(pairs) > 1 or derives or told or any(map(has_integral, pairs[0]))
        return not item.typed.inline and bool(said or derived in partial)

    def _behind(self, item: SourceStatement) -> str:
        """The words of the sentence before a statement, behind the last display in them."""
        ends = (
            one.typed.end for one in self.said if one.order < item.order and not one.typed.inline
        )
        start = max([item.sentence[0], *(end for end in ends if end <= item.typed.start)])
        return self.known.paper.expanded.text[start : item.typed.start]

    def _before(self, item: SourceStatement) -> list[SourceStatement]:
        """What stands before a statement, and what its sentence says behind it of its letters."""
        behind = [
            one
            for one in self.said
            if one.order > item.order
            and one.sentence == item.sentence
            and one.typed is not item.typed
            and cue("where", one.before[-400:])
        ]
        return [one for one in self.said if one.order < item.order] + behind

    def _terms(self, item: SourceStatement) -> list[Formula]:
        """The terms of the sums before a statement, the shorter ones first."""
        before = (one for other, one in self.formulas.items() if other.order < item.order)
        sums = (node for one in before for node in one.nodes() if isinstance(node, Sum))
        return sorted({term for node in sums for term in node.terms}, key=_length)

    def _repairs(self, formula: Formula, before: PrintedBefore) -> tuple[Formula, ...]:
        """The changes by which a step follows that does not, the likelier ones first."""
        found: dict[Formula, tuple[object, ...]] = {}
        with precisely():
            step = DerivationStep(formula, before)
            own = formula.names()
            offered = {name for name in own | before.names if not before.is_unit(name)}
            offered &= self.words.scalars
            lost = frozenset() if step.fails() else self._lost(step)
            tried = slips(step, self.words, offered) if lost or step.fails() else ()
            for place, slip in enumerate(tried):
                kind, path, new, _ = slip
                edited = replace(formula, path, new)
                if edited in found or edited in before.formulas or is_integrated(formula, path):
                    continue
                if lost and not lost.isdisjoint(edited.names()):
                    continue
                if kind == "sign" and before.squared and _has_root(subtree(formula, path)):
                    continue  # of a square the root may be either
                possible = may_be(formula, slip, lost) and not is_trivial(edited)
                if possible and DerivationStep(edited, before).follows():
                    order = not new.names() <= own, path[:1] == (0,), KINDS.index(kind), place
                    found[edited] = order
        return tuple(sorted(found, key=lambda edited: found[edited])[:MOST])

    def _lost(self, step: DerivationStep) -> frozenset[str]:
        """A letter on the right of a step that stands nowhere else, if there is one alone."""
        own = set[str]().union(*(right.names() for _, right in step.pairs))
        left = set[str]().union(*(one.names() for one, _ in step.pairs[:1]))
        others = (one.names for one in self.known.items if one.formula != step.formula)
        lost = own - left - step.before.known - set[str]().union(*others) - {PI, INFINITE}
        alone = lost if len(lost) == 1 and step.before.known else set[str]()
        times = {variable_of(rate.mark, "") for rate in step.before.rates}
        return frozenset(one for one in alone if one not in times and not is_initial(one))


def _has_root(node: Formula) -> bool:
    return any(isinstance(one, Root) for one in node.nodes())


def _says(item: SourceStatement, formula: Formula, known: Known) -> bool:
    """Whether a statement holds wherever its section speaks of its letters."""
    role = known.roles.get(item)
    if role is not None and role.name != NOTATION and expansions_of(formula):
        return True
    if role is None or role.name in (OTHER, NOTATION) or not pairs_of(formula):
        return False
    if role.name == ASSUMPTION and role.kind not in ("", OF_SENTENCE):
        return False
    if role.name == ASSUMPTION and item.typed.inline and not _gives(item, formula):
        return False
    if role.name == CLAIM and role.kind not in _OF_ALL:
        return False
    members = getattr(formula, "members", ())
    numbers = any(map(is_numerical, members)) and (item.typed.inline or role.name == CLAIM)
    bare = all(isinstance(one, Name | Number) for one in members)
    return not (numbers and bare) and not (item.typed.inline and numbers)


def _gives(item: SourceStatement, formula: Formula) -> bool:
    """Whether what is supposed inline gives a name by others, and no words make it a case."""
    names = [one for one in getattr(formula, "members", ()) if isinstance(one, Name)]
    more = formula.names() - {one.name for one in names}
    return bool(names) and len(more) > 1 and not cue("when", f"{item.lead} ")


def _length(formula: Formula) -> tuple[int, str]:
    """Shorter terms come first."""
    tex = to_latex(formula)
    return len(tex), tex
