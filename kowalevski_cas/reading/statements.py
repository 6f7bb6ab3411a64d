"""The statements of a source: each formula as it is read, with the words around it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property

from kowalevski_cas.notation import (
    Constant,
    Derivative,
    Formula,
    Name,
    NotationError,
    Partial,
    Relation,
    Vocabulary,
)
from kowalevski_cas.notation.symbol import name_of_rate, symbol
from kowalevski_cas.paper.jets import Unknown
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.paper.times import time_change
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.bars import with_bars
from kowalevski_cas.reading.counted import counts, stands_in, with_counts
from kowalevski_cas.reading.cues import cue, cues
from kowalevski_cas.reading.derivations import with_derivations
from kowalevski_cas.reading.elements import with_elements
from kowalevski_cas.reading.ellipses import without_ellipses
from kowalevski_cas.reading.formulas import (
    by_names,
    read_formula,
    vocabulary_of,
    with_printed_arguments,
    without_maps,
)
from kowalevski_cas.reading.free_functions import (
    free_functions,
    names_of,
    told_since,
    with_names_alone,
)
from kowalevski_cas.reading.independent import (
    independent_variable,
    other_variable,
    with_coordinate_time,
    with_time,
    with_time_of_dots,
)
from kowalevski_cas.reading.index_ranges import period_in, with_ranges, with_values
from kowalevski_cas.reading.initially import moving_names, time_of_value, with_initial_values
from kowalevski_cas.reading.links import with_links
from kowalevski_cas.reading.logarithms import with_exponentials
from kowalevski_cas.reading.named_sets import without_set_names
from kowalevski_cas.reading.numbers import numbers_of
from kowalevski_cas.reading.operators import with_operators
from kowalevski_cas.reading.orbits import with_orbits
from kowalevski_cas.reading.own_arguments import with_own_names
from kowalevski_cas.reading.reach import with_reach
from kowalevski_cas.reading.text import MARK, Prose, TextSection, references
from kowalevski_cas.reading.variations import with_variations
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.expanded import Expanded
from kowalevski_cas.source.formulas import typed_formulas
from kowalevski_cas.source.rewritten import Rewritten
from kowalevski_cas.source.text import Source

LONGEST_ID = 32
"""The signs of a formula by which it is called if it has no label."""


@dataclass(eq=False)
class SourceStatement:
    """A statement of a source, as it is read, in its sentence.

    ``lead`` and ``tail`` are the words from the formula before, and to the next one, as far as the
    sentence goes; ``before`` and ``after`` the whole of it, with marks for formulas.
    """

    printed: Printed
    typed: TypedFormula
    formula: Formula | None
    trouble: str
    order: int
    sentence: tuple[int, int]
    lead: str
    tail: str
    before: str
    after: str
    paragraph: int
    sections: tuple[TextSection, ...]
    theorem: tuple[int, int] | None
    refs: tuple[str, ...] = ()
    span: tuple[int, int] = (0, 0)
    """The interval of the file in which it stands."""
    entry: tuple[int, int] | None = None
    """The interval of the item of a list in which it stands."""
    earlier: tuple[str, ...] = ()
    """The sentences before its own, the last one first."""
    implied_by: SourceStatement | None = None
    """The printed statement that says it, if it is not printed itself."""
    begins: str = ""
    """The time at which it says how a motion begins: then it gives no rate along it."""

    @property
    def words(self) -> str:
        """The whole sentence."""
        return f"{self.before} {MARK} {self.after}"

    @property
    def section(self) -> TextSection:
        """The innermost section."""
        return self.sections[-1]

    @cached_property
    def names(self) -> frozenset[str]:
        """The names that stand in the statement."""
        return frozenset(self.formula.names() if self.formula is not None else ())

    @cached_property
    def members(self) -> tuple[Formula, ...]:
        """The members of an equality; none of anything else."""
        formula = self.formula
        return formula.members if isinstance(formula, Relation) and formula.is_equality else ()

    @property
    def is_const(self) -> bool:
        """Whether it says of something only that it is constant: “const” is a member."""
        return any(isinstance(member, Constant) for member in self.members)

    @cached_property
    def rates(self) -> dict[str, int]:
        """The names that are derived by the time here, with the highest order; no other time."""
        found: dict[str, int] = {}
        if self.other_time or self.begins:
            return found
        for name, order in _rates(self.formula) if self.formula is not None else ():
            found[name] = max(order, found.get(name, 0))
        return found

    @cached_property
    def derives(self) -> bool:
        """Whether anything is derived by the time here."""
        return self.formula is not None and any(
            isinstance(node, Derivative) for node in self.formula.nodes()
        )

    @cached_property
    def marks(self) -> frozenset[str]:
        """How derivatives are printed here: with dots, with primes, by a variable."""
        nodes = self.formula.nodes() if self.formula is not None else ()
        return frozenset(node.mark for node in nodes if isinstance(node, Derivative))

    @cached_property
    def other_time(self) -> str:
        """The time that it gives, if it gives another one than t."""
        change = time_change(*self.members) if len(self.members) == 2 else None
        return change.time if change is not None else ""

    @cached_property
    def bare(self) -> tuple[str, ...]:
        """The members that are bare names."""
        return tuple(one.name for one in self.members if isinstance(one, Name))


_NAMED_BY = re.compile(
    r"\b(?:frequenc|period|amplitude|theory|problem|частот|период|амплитуд|теори|задач)\w*"
    r"(?:\s+of(?:\s+(?:the|its|such))?)?\s*$",
    re.IGNORECASE,
)
"""Words right before what is small in the name of something."""
_ABOUT = re.compile(r"\\(?:approx|simeq)(?![A-Za-z])")
"""The signs of an approximation."""
_DOTS = re.compile(r"\s*(?:\\[lcv]?dots[a-z]?|\.\.\.)[\s.,;]*")


def is_ellipsis(item: SourceStatement) -> bool:
    """Whether a statement is an ellipsis: it stands for more statements like those beside it."""
    with suppress(NotationError, IndexError):  # what has no statements is none
        return item.formula is None and _DOTS.fullmatch(item.printed.tex) is not None
    return False


_OF_SMALL = re.compile(
    r"s?\b(?:\s+(?:about|around|near|of|in|вблизи|около|возле)\b[^.;:]*?)?\s+"
    r"(?:ha(?:s|ve)|with|occur\s+with|происходят\s+с|имеют)\s+(?:\w+\s+){0,2}"
    r"(?:frequenc|period|частот|период)",
    re.IGNORECASE,
)
"""Words behind small motions that have what is exact: as “small oscillations have the period”."""


@dataclass(frozen=True)
class SourcePaper:
    """A source with its formulas as displays, and their statements in the order of the text."""

    source: Source
    prose: Prose
    words: Vocabulary
    displays: tuple[tuple[Display, TypedFormula], ...]
    items: tuple[SourceStatement, ...]
    lines: dict[str, int] = field(repr=False)
    """The lines of the displays, by their ids."""
    expanded: Expanded = field(repr=False)
    primed: frozenset[str] = frozenset()
    """The names with primes that are images of a map."""
    period: int = 0
    """By how much indices may be changed; 0 if they may not."""
    sets: Mapping[int, str] = field(default_factory=dict)
    """The names of sets, by the offsets of the formulas that print their equations."""
    functions: tuple[Unknown, ...] = ()
    """The functions of which nothing is said but their arguments."""
    orbits: frozenset[int] = frozenset()
    """The offsets of the formulas that print derivatives along orbits."""
    numbers: Mapping[str, int] = field(default_factory=dict)
    """The letters that count, each with the number for which the paper is read."""
    counted: frozenset[int] = frozenset()
    """The offsets of the formulas that are read for these numbers."""
    told_since: Mapping[str, int] = field(default_factory=dict)
    """Where the section begins that first makes a name a function of the time, by the names."""
    primed_by_time: bool = False
    """Whether it is known that primes derive by the time."""
    primed_by: tuple[str, int] = ("", 0)
    """Another letter by which primes derive, as words say, and where they do."""
    coordinate_time: bool = False
    """Whether t is a coordinate, for which another letter stands."""

    @cached_property
    def functions_by_name(self) -> dict[str, list[Unknown]]:
        """These functions, by the names of their values and derivatives."""
        found: dict[str, list[Unknown]] = {}
        for one in self.functions:
            for name in names_of((one,)):
                found.setdefault(name, []).append(one)
        return found

    @cached_property
    def alike(self) -> dict[Formula | None, list[SourceStatement]]:
        """The statements by what they say, sign for sign."""
        found: dict[Formula | None, list[SourceStatement]] = {}
        for item in self.items:
            found.setdefault(item.formula, []).append(item)
        return found

    @cached_property
    def unfinished(self) -> frozenset[SourceStatement]:
        """The equations of displays in which dots stand for more of them, with these dots."""
        dotted = {id(item.typed) for item in self.items if is_ellipsis(item)}
        return frozenset(item for item in self.items if id(item.typed) in dotted)

    @cached_property
    def approximate(self) -> frozenset[SourceStatement]:
        """The statements behind the words, in the same section, that they hold approximately."""
        return frozenset(one for one in self.items if any(self._approximating(one)))

    @cached_property
    def approximate_here(self) -> frozenset[SourceStatement]:
        """Those of them behind these words in the same paragraph: they may hold in no other way."""
        return frozenset(
            one
            for one in self.approximate
            if any(said > one.paragraph for said in self._approximating(one))
        )

    def _approximating(self, item: SourceStatement) -> Iterator[int]:
        """Where the words stand, in the section of a statement, that it holds approximately.

        What a footnote says reaches to its end; what is said of a name behind “where”, or of what
        is printed as an approximation, no further.
        """
        for said in self._approximations:
            if said > item.typed.end and cue("where", self.prose.between(item.typed.end, said)):
                continue
            sentence = self.prose.sentence(said)
            if sentence in self._approximated and item.sentence != sentence:
                continue
            footnote = self.prose.footnote(said)
            if footnote is None or footnote[0] <= item.typed.start < footnote[1]:
                if item.section.start <= said < item.sentence[1]:
                    yield said

    @cached_property
    def _approximated(self) -> frozenset[tuple[int, int]]:
        """The sentences that print what is approximately equal: their words speak of that."""
        return frozenset(item.sentence for item in self.items if _ABOUT.search(item.typed.tex))

    @cached_property
    def _approximations(self) -> list[int]:
        """Where words say that what follows holds approximately; not those that say it of a model.

        What is small in the name of something, as in “the frequency of small oscillations”, is none
        of them. A model may be approximate itself: so are the equations of motion that come first,
        and those that words set up behind these words in their sentence, for what did not move
        before, and is given by nothing else.
        """
        rows = [item for item in self.items if item.rates and not item.typed.inline]
        model = next((item.typed.end for item in rows), self.prose.start)
        found: list[int] = []
        for said in cues("approximate", self.prose.text, model):
            words = self.prose.between(said.end(), said.end() + 80)
            if _NAMED_BY.search(self.prose.between(said.start() - 60, said.start())):
                continue
            if _OF_SMALL.match(words):
                continue
            sentence = self.prose.sentence(said.start())
            behind = [one for one in rows if one.sentence == sentence]
            row = next((one for one in behind if one.typed.start > said.start()), None)
            words = self.prose.between(said.end(), row.typed.start) if row is not None else ""
            before = [one for one in self.items if one.typed.start < sentence[0]]
            known = {name for one in before for name in one.rates}
            known |= {name for one in self.items if len(one.members) > 1 for name in one.bare}
            if row is None or not cue("system", words) or known & {*row.rates}:
                found.append(said.start())
        return found

    @cached_property
    def maps(self) -> frozenset[SourceStatement]:
        """The statements with primes in a section that speaks of a map: they are images."""
        words = self.prose.between
        return frozenset(
            item
            for item in self.items
            if "prime" in item.marks and cue("map", words(item.section.start, item.sentence[1]))
        )

    @cached_property
    def labels(self) -> dict[str, list[SourceStatement]]:
        """The statements by the labels that cite them."""
        found: dict[str, list[SourceStatement]] = {}
        for item in self.items:
            for label in item.typed.labels:
                found.setdefault(label, []).append(item)
        formulas = [formula for _, formula in self.displays]
        text, start = self.expanded.text, self.prose.start
        for typed, number in numbers_of(formulas, text, start, self.source.text):
            if number not in found:
                found[number] = [item for item in self.items if item.typed is typed]
        return found


def read_statements(source: Source, primed: frozenset[str] = frozenset()) -> SourcePaper:
    """The statements of a source, read in the names that it uses, some of which are ``primed``."""
    expanded, typed = typed_formulas(source)
    numbers = counts(typed, expanded.text)
    counted = [*without_ellipses(with_counts(typed, numbers))]
    several = {one.start for one in typed if any(stands_in(name, one.tex) for name in numbers)}
    typed = [*with_variations([*with_elements([*without_maps(counted)], expanded.text)])]
    typed = [*with_operators([*with_bars(typed, expanded.text)], expanded.text)]
    timed = [*with_coordinate_time(typed, expanded.text)]
    has_coordinate_time, typed = timed != typed, timed
    variable = independent_variable(typed, expanded.text)
    other = other_variable(typed, expanded.text)
    dotted = [*with_time_of_dots(typed, expanded.text)]
    typed = [*with_time(dotted, variable, other[0])]
    typed = [*with_exponentials([*with_own_names(typed)])]
    typed = [*with_printed_arguments([*with_derivations(typed, expanded.text)])]
    named = [*without_set_names(typed)]
    printed = [formula for formula, _ in named]
    functions = free_functions(printed, expanded.text)
    since = told_since(functions, printed, expanded.text)
    printed = [*with_names_alone(printed, functions)]
    moving = moving_names(printed)
    printed = [*with_links(with_reach(printed, moving), moving)]
    along = [*with_orbits(printed, moving)]
    orbits = frozenset(formula.start for formula, is_along in along if is_along)
    begun, starts = with_initial_values([formula for formula, _ in along], moving)
    formulas = [*by_names(begun)]
    prose = Prose(expanded.text, expanded.body, formulas)
    texts = [formula.tex for formula in formulas]
    period = period_in(expanded.text[prose.start :], texts, numbers)
    most = max(numbers.values(), default=0)
    ranged = [*with_ranges(formulas, expanded.text, period, most)]
    words = with_values(vocabulary_of(formulas), ranged)
    others = primed | names_of(functions)
    words = replace(words, scalars=words.scalars | others, moving=words.moving | others)
    displays: list[tuple[Display, TypedFormula]] = []
    items: list[SourceStatement] = []
    lines: dict[str, int] = {}
    ids: Counter[str] = Counter()
    for formula, tex in zip(formulas, ranged, strict=True):
        several |= {formula.start} if numbers and tex != formula.tex else set()
        path = prose.path(formula.start)
        if any(one.title == "thebibliography" for one in path):
            continue
        section = str(prose.sections.index(path[-1]))
        around = _Around(prose, formula)
        display = Display(
            _id(formula, ids),
            tex,
            section,
            formula.inline,
            label=_label(formula),
            cites=references(around.lead),
        )
        displays.append((display, formula))
        sentence = [
            one.tex for one in formulas if around.sentence[0] <= one.start < around.sentence[1]
        ]
        start = formula.start + len(formula.tex) - len(formula.tex.lstrip())
        lines[display.id] = source.line(expanded.origin(start, start + 1)[0])
        typed_as = Rewritten(expanded.text[formula.start : formula.end], formula.tex)
        for number, (tree, trouble, (start, end)) in enumerate(
            read_formula(formula, tex, words), 1
        ):
            first, last = typed_as.interval(start, end)
            span = expanded.origin(formula.start + first, formula.start + last)
            times = [time for place, time in starts[formula.start].items() if start <= place < end]
            said = (around.before, around.after)
            begins = times[0] if times else time_of_value(tree, moving, said, sentence)
            items.append(
                SourceStatement(
                    Printed(display, number), formula, tree, trouble, len(items), around.sentence,
                    around.lead, around.tail, around.before, around.after, around.paragraph,
                    path, prose.theorem(formula.start), around.refs, span,
                    prose.entry(formula.start), around.earlier, begins=begins,
                )
            )  # fmt: skip
    return SourcePaper(
        source, prose, words, tuple(displays), tuple(items), lines, expanded, primed, period,
        {formula.start: name for formula, name in named if name}, functions, orbits,
        numbers, frozenset(several), since, bool(variable), other, has_coordinate_time,
    )  # fmt: skip


class _Around:
    """The words around a formula."""

    def __init__(self, prose: Prose, formula: TypedFormula) -> None:
        start, end = self.sentence = prose.sentence(formula.start)
        self.before = prose.between(start, formula.start)
        self.after = prose.between(formula.end, end)
        self.lead = self.before.rpartition(MARK)[2]
        self.tail = self.after.partition(MARK)[0]
        self.refs = references(prose.text[start:end])
        self.paragraph = prose.text.rfind("\n\n", 0, formula.start)
        self.earlier = prose.earlier(start, 3)


def _label(formula: TypedFormula) -> str:
    return f"({formula.labels[0]})" if formula.labels else ""


def _id(formula: TypedFormula, ids: Counter[str]) -> str:
    """What a formula is called: its label, or its own letters, with a number if they are taken."""
    name = formula.labels[0] if formula.labels else formula.tex
    letters = re.sub(r"[^A-Za-z0-9]+", "-", re.sub(r"\\(?:left|right|displaystyle)\b", "", name))
    letters = letters.strip("-")[:LONGEST_ID].strip("-") or "formula"
    ids[letters] += 1
    return letters if ids[letters] == 1 else f"{letters}_{ids[letters]}"


def is_numerical(formula: Formula) -> bool:
    r"""Whether a formula is a number, as :math:`\\pi/3` is, or a list of numbers."""
    return formula.names() <= {PI}


def is_closing(item: SourceStatement, period: int = 0) -> bool:
    """Whether a statement closes a chain: a link of it is another one, as :math:`u_6=u_1`.

    With a period the indices have to be the same but for it: :math:`u_2=u_0` says something else.
    """
    if not len(item.bare) == len(item.members) == 2:
        return False
    one, other = map(symbol, item.bare)
    if period and one.index.isdecimal() and other.index.isdecimal():
        return one.head == other.head and (int(one.index) - int(other.index)) % period == 0
    return one.head == other.head and one != other


def is_dependence(item: SourceStatement) -> bool:
    """Whether a statement only says on what a name depends, as :math:`q=q(t)`."""
    return len(item.bare) == 2 == len(item.members) and item.bare[0] == item.bare[1]


def derived_names(item: SourceStatement) -> set[str]:
    r"""The names of functions of which partial derivatives are printed, as the energy's."""
    nodes = item.formula.nodes() if item.formula is not None else ()
    partials = (node.argument for node in nodes if isinstance(node, Partial))
    return {argument.name for argument in partials if isinstance(argument, Name)}


def _rates(formula: Formula) -> Iterator[tuple[str, int]]:
    r"""The names that are derived by the time, and how often.

    Those by whose rates something is derived are among them where that is derived by the time, as
    in the equations of Lagrange.
    """
    inner, order = formula, 0
    while isinstance(inner, Derivative):
        inner, order = inner.argument, order + 1
    if order and isinstance(inner, Name):
        yield inner.name, order
    if order and isinstance(inner, Partial) and name_of_rate(inner.by) != inner.by:
        yield name_of_rate(inner.by), order + 1
    for child in inner.children():
        yield from _rates(child)
