"""What does not follow from what is printed before it, and would with one change.

A step of a derivation is looked at by itself: what stands before it in its section is put in, all
other letters, derivatives and unknown functions are free. A step that fails is doubted only if it
follows when one token of it is another one: what else it may rest on is not known.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
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
from kowalevski_cas.notation.edits import subtree
from kowalevski_cas.notation.layout import EITHER_SIGN, statements
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.components import usual_meanings
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.expansions import expansions_of
from kowalevski_cas.reading.free_formulas import (
    arguments,
    free_formulas,
    single_functions,
    with_gradients,
)
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, NOTATION, OTHER, Known
from kowalevski_cas.reading.premises import has_integral, pairs_of
from kowalevski_cas.reading.slips import KINDS, LIKELY, is_integrated, may_be, slips, with_slip
from kowalevski_cas.reading.small_oscillations import FREQUENCY
from kowalevski_cas.reading.statements import SourceStatement, is_numerical
from kowalevski_cas.reading.steps import DerivationStep, PrintedBefore
from kowalevski_cas.reading.variational import rates_behind, says_rates
from kowalevski_cas.verify.vacuous import is_trivial

_ANOTHER = re.compile(
    r"\b(?:instead|replac\w+|without(?!\s+(?:\w+\s+){0,3}(?:comput|calculat)\w+)|twice|double\w*(?![\s-]angle)|half(?![\s-]a(?:x|ngle))|(?<!each\s)other|another|new"
    r"|inverted|upside|opposite|revers\w+"
    r"|(?:second|third)\s+(?:spring|mass|bod(?:y|ies)|force|particle|charge|case))\b"
    r"|\b(?:вместо|замен\w+|друг\w+|нов\w+|вдвое)\b",
    re.IGNORECASE,
)
"""Words that may change what stands before."""

_FORCE = re.compile(r"\b(?:friction|damp\w+|трени\w+)\b", re.IGNORECASE)
"""Words for what may come to what stands before, unless a formula behind them has it."""

_ASKED = re.compile(
    r"\b(?:ask(?:s|ed)?|asking|question|find(?:\s+out)?|determine|see|check|know|conditions?)\s+"
    r"(?:when|whether|if|under|for\s+(?:which|what))\b|\bспрос\w+|\bвопрос",
    re.IGNORECASE,
)
"""Words before what is asked."""

_VANISHES = re.compile(
    r"[\s~]*(?:vanish(?:es)?|is\s+zero|равн[оаы]?\s+нулю)\s*[.,;]", re.IGNORECASE
)
"""Words behind what is zero."""

_ARROW = re.compile(r"\\(?:(?:Long)?(?:[Ll]eft)?[Rr]ightarrow|implies|iff)(?:[\s&]|\\q?quad)*\Z")

_CASE = re.compile(
    r"\\(?:text|mbox)\s*\{\s*(?:if|when|for(?!\s+(?:all|any|every|each)\b)(?!\W*[ijkn]\W*(?:=|\\in)))\b",
    re.IGNORECASE,
)
"""Words behind an equation for when it holds alone."""

MOST = 3
"""How many repairs are told."""

NEXT = 20
"""So many characters behind an equation may say when it holds."""

NEAR = 3
"""In how many displays before a step that fails the reason is looked for."""

_OF_ALL = ("identity", "integral", "solution", "constant", "energy", FREQUENCY)
"""The kinds of claims that are made of no set."""

OF_SENTENCE = "of the sentence"

_STEP = re.compile(
    r"\bor\W*$|\bi\.\s*e\b|\bthat\s+is\b|\bnamely\b|\bsol(?:ved?|utions?|ving)\b|\bsubstitut\w*"
    r"|\badding\s+(?:both|them|these|the\s+(?:two\s+)?equations|up)\b|\bsubtracting\b|\beliminat\w+"
    r"|\b(?:this|which|it|that)\s+(?:reads|says|means)\b|\bthe\s+equation\s+reads\b"
    r"|\bas\s+(?:a\s+)?vectors?\b|\bin\s+(?:vector|component)s?\b|\bby\s+components\b"
    r"|\bas\s+an?\s+(?:matrix|vector)\s+equation\b|\bin\s+matrix\s+(?:form|notation)\b"
    r"|\bconversely\b|\binsert\w*|\binto\b|\bmultipl\w+|\bdivid\w+|\bintegrat\w+|\bdifferentiat\w+|\bor\b"
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
    of: SourceStatement | None = None
    """What is repaired: the step, or what stands before it; nothing rests on it if it is none."""


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
        given = [*_given_elsewhere(items, formulas, known)]
        yield from _Section(items, given, formulas, known).steps(asked, doubted, left)


def _given_elsewhere(
    items: Sequence[SourceStatement], formulas: Mapping[SourceStatement, Formula], known: Known
) -> Iterator[SourceStatement]:
    """What gives, last before a section, the letters of its expansions that nothing gives there."""
    giving: dict[str, list[SourceStatement]] = {}
    for one in (one for one in known.items if one in formulas):
        match pairs_of(formulas[one])[:1]:
            case [(Name(name), _)]:
                giving.setdefault(name, []).append(one)
    expanded = (one for one in items if one in formulas and expansions_of(formulas[one]))
    for name in dict.fromkeys(name for one in expanded for name in sorted(one.names)):
        found = giving.get(name, [])
        if found and not any(one.section is items[0].section for one in found):
            yield from [one for one in found if one.order < items[0].order][-1:]


class _Section:
    """The statements of a section that say something, in their order, behind what is given them."""

    def __init__(
        self,
        own: Sequence[SourceStatement],
        given: Sequence[SourceStatement],
        formulas: Mapping[SourceStatement, Formula],
        known: Known,
    ) -> None:
        self.known = known
        items = [*given, *own]
        self.formulas = {one: formulas[one] for one in items if one in formulas}
        self.said = [one for one in self.formulas if _says(one, self.formulas[one], known)]
        self.own = [one for one in self.said if one not in given]
        self.words: Vocabulary = with_gradients(known.paper.words, self.formulas.values())
        self._arguments = arguments(known.paper, items)

    def steps(
        self,
        asked: frozenset[SourceStatement],
        doubted: frozenset[SourceStatement],
        left: frozenset[SourceStatement],
    ) -> Iterator[Step]:
        """The steps that follow with one change only; what rests on one is read with it.

        Where what words explain behind a step is wrong, the step may be right.
        """
        found: dict[SourceStatement, Step] = {}
        for item in self.own:
            if not (item in doubted or self._is_step(item)):
                continue
            sure = [one for one in self._before(item) if one in _mended(found) or one not in left]
            self._reconsider(item, sure, asked, found)
            if item not in asked:
                continue
            before = self._printed_before(item, sure, _mended(found))
            if repairs := self._repairs(self.formulas[item], before):
                whole = all(one.order < item.order for one in sure)
                found[item] = Step(item, repairs, of=item if whole else None)
            elif item in doubted and _follows(self.formulas[item], before):
                found[item] = Step(item, (), follows=True)
            elif step := self._elsewhere(item, sure, asked, _mended(found)):
                found[item] = step
        yield from found.values()

    def _reconsider(
        self,
        item: SourceStatement,
        sure: Sequence[SourceStatement],
        asked: frozenset[SourceStatement],
        found: dict[SourceStatement, Step],
    ) -> None:
        """Look elsewhere for what is wrong with a step on which another one rests as printed."""
        mended, formula = _mended(found), self.formulas[item]
        doubted = [one for one in sure if one in mended and one in found]
        if not doubted or not _fails(formula, self._printed_before(item, sure, mended)):
            return
        for one in doubted:
            others = {place: other for place, other in mended.items() if place is not one}
            if _follows(formula, self._printed_before(item, sure, others)):
                own = [other for other in self._before(one) if other in sure]
                if step := self._elsewhere(one, own, asked, others):
                    found[one] = step

    def _printed_before(
        self,
        item: SourceStatement,
        sure: Sequence[SourceStatement],
        mended: Mapping[SourceStatement, Formula],
    ) -> PrintedBefore:
        """What a statement may rest on, some of it as it was mended."""
        premises = [mended.get(one, self.formulas[one]) for one in sure]
        ends = [self.formulas[one] for one in sure if _VANISHES.match(one.tail)]
        premises += [
            Relation((pair[1], Number(0)), ("=",)) for one in ends for pair in pairs_of(one)
        ]
        premises += rates_behind(item, sure, self.formulas, self.known)
        premises += self._at_arguments([self.formulas[item], *premises])
        premises += usual_meanings([self.formulas[item], *premises], self.words)
        return PrintedBefore(
            self.formulas[item], premises, self._terms(item), self.words, self._arguments
        )

    def _elsewhere(
        self,
        item: SourceStatement,
        sure: Sequence[SourceStatement],
        asked: frozenset[SourceStatement],
        mended: Mapping[SourceStatement, Formula],
    ) -> Step | None:
        """A step that fails, with the changes of one display before it by which it would follow.

        All that follows from that display as it is has to follow from it then.
        """
        formula = self.formulas[item]
        before = self._printed_before(item, sure, mended)
        with precisely():
            fails = before.has_all_of(formula) and DerivationStep(formula, before).fails()
            if not fails or not before.agrees():
                return None
        given = Counter(map(self._given, self.said))
        own = {name for pair in before.pairs(formula) for one in pair for name in one.names()}
        places = [
            one
            for one in sure
            if one in asked and one not in mended and one.order < item.order
            if not one.typed.inline and given[self._given(one)] == 1
            if pairs_of(self.formulas[one])
            if not own.isdisjoint(self.formulas[one].names())
        ]
        for place in reversed(places[-NEAR:]):
            between = [one for one in sure if place.order < one.order < item.order]
            resting = [one for one in between if self._follows(one, sure, mended)]
            first = pairs_of(self.formulas[place])[0][0]
            subject = first if isinstance(first, Name | Derivative) else None

            def holds(
                edited: Formula,
                place: SourceStatement = place,
                own: Sequence[SourceStatement] = (item, *resting),
                subject: Formula | None = subject,
            ) -> bool:
                if subject not in (None, *(left for left, _ in pairs_of(edited)[:1])):
                    return False  # it would say nothing of it
                changed = {**mended, place: edited}
                return all(self._follows(one, sure, changed) for one in own)

            if found := self._changes(self.formulas[place], before, frozenset(), holds, LIKELY):
                return Step(item, found, of=place)
        return None

    def _follows(
        self,
        item: SourceStatement,
        sure: Sequence[SourceStatement],
        mended: Mapping[SourceStatement, Formula],
    ) -> bool:
        """Whether a statement follows from what is sure before it, some of it as it was mended."""
        own = [one for one in self._before(item) if one in sure]
        return _follows(self.formulas[item], self._printed_before(item, own, mended))

    def _given(self, one: SourceStatement) -> Formula:
        """What a statement gives: where it is given twice there are several cases."""
        pairs = pairs_of(self.formulas[one])
        return pairs[0][0] if pairs else self.formulas[one]

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
        if _FORCE.search(self._behind(item)) or EITHER_SIGN.search(item.printed.tex):
            return False
        pairs = pairs_of(formula)
        derived = pairs[0][0]
        while isinstance(derived, Derivative):
            derived = derived.argument
        given = (self.formulas[one] for one in self.said if one.order < item.order)
        derives = derived != pairs[0][0] and any(
            pair[0] == derived for one in given for pair in pairs_of(one)[:1]
        )
        partial = {node.argument for node in formula.nodes() if isinstance(node, Partial)}
        if _is_varied(formula):
            return False
        told = cue("claim", words) or _STEP.search(words) or says_rates(item) or _is_concluded(item)
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
        """What stands before a statement, and what its sentence says behind it of its letters.

        What it gives may be given behind it once more, and follows from it.
        """
        behind = [
            one
            for one in self.said
            if one.order > item.order
            and one.sentence == item.sentence
            and one.typed is not item.typed
            and cue("where", one.before[-400:])
            and self._given(one) != self._given(item)
        ]
        return [one for one in self.said if one.order < item.order] + behind

    def _terms(self, item: SourceStatement) -> list[Formula]:
        """The terms of the sums before a statement, the shorter ones first."""
        before = (one for other, one in self.formulas.items() if other.order < item.order)
        sums = (node for one in before for node in one.nodes() if isinstance(node, Sum))
        return sorted({term for node in sums for term in node.terms}, key=_length)

    def _repairs(self, formula: Formula, before: PrintedBefore) -> tuple[Formula, ...]:
        """The changes by which a step follows that does not, the likelier ones first.

        Of vectors that stand nowhere before it nobody prints how they are directed.
        """
        if not before.has_vectors_of(formula):
            return ()
        with precisely():
            step = DerivationStep(formula, before)
            solves = step.solving is not None  # with new constants
            lost = frozenset() if solves or step.fails() else self._lost(step)
            if not lost and not step.fails():
                return ()
        return self._changes(
            formula, before, lost, lambda edited: DerivationStep(edited, before).follows()
        )

    def _changes(
        self,
        formula: Formula,
        before: PrintedBefore,
        lost: frozenset[str],
        holds: Callable[[Formula], bool],
        kinds: Collection[str] = KINDS,
    ) -> tuple[Formula, ...]:
        """The changes of a formula with which something holds, the likelier ones first."""
        found: dict[Formula, tuple[object, ...]] = {}
        with precisely():
            own = formula.names()
            offered = {name for name in own | before.names if not before.is_unit(name)}
            offered &= self.words.scalars
            step = DerivationStep(formula, before)
            for place, slip in enumerate(slips(step, self.words, offered)):
                kind, path, new, _ = slip
                if kind not in kinds or is_integrated(formula, path):
                    continue
                if not may_be(formula, slip, lost):
                    continue
                if kind == "sign" and before.squared and _has_root(subtree(formula, path)):
                    continue  # of a square the root may be either
                for edited in with_slip(formula, path, new):
                    if edited in found or edited in before.formulas:
                        continue
                    if is_trivial(edited) and not is_trivial(formula):
                        continue
                    if lost.isdisjoint(edited.names()) and holds(edited):
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


def _is_concluded(item: SourceStatement) -> bool:
    """Whether an arrow in its display lets a statement follow."""
    tex = item.printed.display.tex
    start = statements(tex)[item.printed.number - 1].start
    return _ARROW.search(tex, 0, start) is not None


def _is_varied(formula: Formula) -> bool:
    """Whether it has the form of Lagrange's equations, which follow from no function."""
    nodes = [node for node in formula.nodes() if isinstance(node, Derivative | Partial)]
    members = [one for one in getattr(formula, "members", ()) if one != Number(0)]
    if not any(isinstance(one, Derivative) and one.argument in nodes for one in nodes):
        return False
    return all(any(isinstance(one, Partial) for one in side.nodes()) for side in members)


def _fails(formula: Formula, before: PrintedBefore) -> bool:
    with precisely():
        return DerivationStep(formula, before).fails()


def _follows(formula: Formula, before: PrintedBefore) -> bool:
    with precisely():
        return DerivationStep(formula, before).follows()


def _mended(found: Mapping[SourceStatement, Step]) -> dict[SourceStatement, Formula]:
    """What is to be read with its repair by those that follow."""
    return {one.of: one.repairs[0] for one in found.values() if one.of is not None}


def _has_root(node: Formula) -> bool:
    return any(isinstance(one, Root) for one in node.nodes())


def _says(item: SourceStatement, formula: Formula, known: Known) -> bool:
    """Whether a statement holds wherever its section speaks of its letters."""
    role = known.roles.get(item)
    if role is not None and role.name != NOTATION and expansions_of(formula):
        return True
    if role is None or role.name in (OTHER, NOTATION) or not pairs_of(formula):
        return False
    printed = known.paper.expanded.text[item.typed.start : item.typed.end + NEXT]
    if _ASKED.search(item.before) or (_CASE.search(printed) and not item.typed.inline):
        return False
    if role.name == ASSUMPTION and role.kind not in ("", OF_SENTENCE):
        return False
    if role.name == ASSUMPTION and item.typed.inline and not _gives(item, formula):
        return False
    if role.name == CLAIM and role.kind not in _OF_ALL and not _begins_with_equality(formula):
        return False
    members = getattr(formula, "members", ())
    numbers = any(map(is_numerical, members)) and (item.typed.inline or role.name == CLAIM)
    bare = all(isinstance(one, Name | Number) for one in members)
    return not (numbers and bare) and not (item.typed.inline and numbers)


def _begins_with_equality(formula: Formula) -> bool:
    """Whether an equation stands before an inequality in a chain."""
    return isinstance(formula, Relation) and len(formula.signs) > 1 and formula.signs[0] == "="


def _gives(item: SourceStatement, formula: Formula) -> bool:
    """Whether what is supposed inline gives a name by others, and no words make it a case."""
    names = [one for one in getattr(formula, "members", ()) if isinstance(one, Name)]
    more = formula.names() - {one.name for one in names}
    return bool(names) and len(more) > 1 and not cue("when", f"{item.lead} ")


def _length(formula: Formula) -> tuple[int, str]:
    """Shorter terms come first."""
    tex = to_latex(formula)
    return len(tex), tex
