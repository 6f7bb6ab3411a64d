r"""Maps of a paper: :math:`x_{n+1}=y_n,\; y_{n+1}=-x_n`, or :math:`x'=y,\; y'=-x` by its words.

The images are names that the equations define; those that no equation gives are solved for.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property

from kowalevski_cas.notation import Derivative, Formula, Name, PoissonBracket, Summation, to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.amplitudes import conjugate_images, conjugate_name
from kowalevski_cas.paper.images import images_by_index, solutions
from kowalevski_cas.paper.implied import canonical_brackets, conjugate_pairs
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.compositions import gives_map
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CONVENTION, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

_STEP = re.compile(r"([a-z])(?:\+\d)")


def primed_images(paper: SourcePaper, said: Said) -> frozenset[str]:
    """The names with primes that are images: words, or a comment, say so of their equations.

    They are none if the same names are derived by primes elsewhere. Where a time has a prime, and
    frames are spoken of, all primes are those of another one.
    """
    every = {name for one in paper.items for name in _primed(one.formula)}
    if every & {"t", r"\tau"} and cue("frame", paper.prose.text):
        return frozenset(f"{name}'" for name in every)
    rows = [one for one in paper.items if one in paper.maps or said.verb(one) == "map"]
    rows = [one for one in rows if "prime" in one.marks]
    before = (one for one in paper.items if rows and one.order < rows[0].order)
    elsewhere = {name for one in before if "prime" in one.marks for name in one.rates}
    names = {name for one in rows for name in _primed(one.formula)}
    return frozenset() if names & elsewhere else frozenset(f"{name}'" for name in names)


def _primed(formula: Formula | None) -> Iterator[str]:
    """The names that stand under primes."""
    for node in formula.nodes() if formula is not None else ():
        match node:
            case Derivative(Name(name), "prime"):
                yield name


def find_maps(paper: SourcePaper, names: Names, said: Said) -> list[Law]:
    """The maps of a paper, in its order: closed sets of equations for images."""
    found: list[Law] = []
    finder = _MapFinder(paper, names, said)
    for item in finder.rows:
        known = {name for law in found for pair in law.images for name in pair}
        follows = {*finder.images([item]).values()} <= known or _follows(item, finder, found)
        begins = _begins(item, found)
        if (begins is not None or not follows) and (law := finder.grown(item)) is not None:
            law.begins = begins
            found.append(law)
    return found


_SETS_UP = re.compile(
    r"\b(?:for|consider|take|study|turn\s+to|another|next|second|other|рассмотрим|возьм[её]м)\s[^§.;]*"
    r"(?:\bmap(?:ping)?|отображени[ея])\b(?:\s+of\s+[^§.;,]{1,40})?(?:[\s,:~]|\b(?:given|defined|by)\b)*$"
    r"|\bmap(?:ping)?(?:\s+of\s+[^§.;,]{1,40})?\s+(?:is|reads)\b[\s:]*$",
    re.IGNORECASE,
)
"""How words end behind which a map is printed."""
_MADE = re.compile(
    r"\b(?:inverse|iterat\w+|squared?|linear\w*|this|these|same|our|composition|power|reduced|becom\w+)\b"
    r"|\b(?:обратн|линейн|линеариз|эт[оиу]|тот\s+же|наш)\w*",
    re.IGNORECASE,
)
"""Words for a map that is made of one before, or is that."""


def _begins(item: SourceStatement, maps: Sequence[Law]) -> int | None:
    """Where the section begins in which words set up another map than those before, if they do."""
    if not maps or item.refs or any(item in law.items for law in maps):
        return None
    before = {section for law in maps for section in law.first.sections}
    apart = [section for section in item.sections if section not in before]
    said = _SETS_UP.search(item.before) and not _MADE.search(item.before)
    own = all(law.first.section not in item.sections for law in maps)
    return apart[0].start if apart and own and said else None


def _follows(item: SourceStatement, finder: _MapFinder, maps: Sequence[Law]) -> bool:
    """Whether an equation for images follows from a map before it: it sets up no other one.

    It is derived, or it is for letters of that map, and no words before its display introduce it.
    """
    letters = {symbol(x).letter for law in maps for x, _ in law.images}
    own = {symbol(x).letter for x in finder.images([item])}
    accents = [finder.accents(law.items) for law in maps]
    if finder.is_arrow(item) or (maps and finder.accents([item]) not in accents):
        return False
    if maps and cue("deduced", item.lead):
        return True
    introduced = cue("define", item.lead) or cue("another system", item.before)
    return bool(own & letters) and (item.typed.inline or not introduced)


class _MapFinder:
    """The equations with images of a paper, and which of them belong together."""

    def __init__(self, paper: SourcePaper, names: Names, said: Said) -> None:
        self.paper, self.names, self.primed = paper, names, paper.primed
        self.linked = {symbol(name).index for item in paper.items for name in item.rates}
        """The indices of what is derived: they count links of a chain, and no steps."""
        self.rows = [
            item
            for item in paper.items
            if self._may_be_row(item) and said.verb(item) in ("", "law", "map")
        ]

    @cached_property
    def accented(self) -> dict[str, str]:
        r"""The images that are printed with an accent, as :math:`\tilde x`, with the variables.

        Words of the section speak of a map, and a display has both of them.
        """
        found: dict[str, str] = {}
        for item in self.paper.items:
            words = self.paper.prose.between(item.section.start, item.sentence[1])
            if item.typed.inline or not item.members or item.derives or not cue("map", words):
                continue
            display = (one for one in self.paper.items if one.typed is item.typed)
            beside = {name for one in display for name in one.names}
            for name in sorted(item.names):
                variable = replace(symbol(name), accents=()).name
                if len(symbol(name).accents) == 1 and variable in beside:
                    found[name] = variable
        return found

    def accents(self, items: Sequence[SourceStatement]) -> set[tuple[str, ...]]:
        """With which accents images are printed in statements."""
        return {symbol(n).accents for one in items for n in one.names if n in self.accented}

    def is_arrow(self, item: SourceStatement) -> bool:
        """Whether a statement is printed as what a map takes a point to."""
        text = self.paper.expanded.text[item.typed.start : item.typed.end]
        return gives_map(text) and item.members[:1] == (Name(item.bare[0]),)

    def _may_be_row(self, item: SourceStatement) -> bool:
        """Whether a statement may be an equation for images."""
        images = {*self.images([item]).values()}
        if len(item.members) != 2 or item.derives or not images & item.names:
            return False
        nodes = item.formula.nodes() if item.formula is not None else ()
        return not any(isinstance(node, Summation | PoissonBracket) for node in nodes)

    def images(self, items: Sequence[SourceStatement]) -> dict[str, str]:
        """The variables that stand in statements with their images."""
        names = sorted({name for item in items for name in item.names})
        primed = {name[:-1]: name for name in names if name in self.primed}
        primed |= {name: f"{name}'" for name in names if f"{name}'" in self.primed}
        accents = self.accents(items)
        primed |= {
            x: new
            for new, x in self.accented.items()
            if {x, new} & {*names} and symbol(new).accents in accents
        }
        steps = {step[1] for name in names if (step := _STEP.fullmatch(symbol(name).index))}
        found = [images_by_index(names, n) for n in sorted(steps - self.linked)]
        return primed | {x: new for own in found for x, new in own.items()}

    def grown(self, first: SourceStatement) -> Law | None:
        """A map from an equation on, with those that follow until all its images have one."""
        own = [first]
        while True:
            images = self.images(own)
            new = [name for name in images.values() if name not in images]
            unknown = self._without_image(own, images)
            if len(own) == len(new) and not unknown:
                if self._has_other_steps(own, images):
                    return None
                return Law(tuple(own), self.names, images=(*images.items(),))
            wanted = {*new, *unknown.values()}
            others = [one for one in self.rows if one not in own and one.names & wanted]
            near = sorted(
                others, key=lambda one: (one.typed is not first.typed, abs(one.order - first.order))
            )
            if not near or len(own) > len(new):
                return None
            own = sorted([*own, near[0]], key=lambda one: one.order)

    def _has_other_steps(self, items: Sequence[SourceStatement], images: dict[str, str]) -> bool:
        """Whether a letter with the number of steps stands in equations, and nothing gives it."""
        steps = {
            symbol(x).index for x in images if f"{symbol(x).index}+1" == symbol(images[x]).index
        }
        given = {name for one in self.paper.items if one.members for name in one.bare[:1]}
        names = {name for one in items for name in one.names} - {*images, *images.values()} - given
        return any(symbol(name).index in steps for name in names)

    def _without_image(
        self, items: Sequence[SourceStatement], images: dict[str, str]
    ) -> dict[str, str]:
        """The names in equations of which others have images, with these."""
        accents = self.accents(items)
        every = self.images([row for row in self.rows if self.accents([row]) <= accents])
        names = {name for item in items for name in item.names}
        known = {*images, *images.values()}
        return {name: every[name] for name in names & every.keys() if name not in known}


def enter_maps(parts: Parts) -> None:
    """Solve for the images that no equation gives, and keep canonical brackets."""
    for place, known in enumerate(parts.known):
        for number, law in enumerate((one for one in known.laws if one.images), 1):
            suffix = f"-{place + 1}-{number}"
            try:
                found = [*_solved(law, known, suffix)]
            except (ValueError, Meaningless) as error:
                known.lost |= dict.fromkeys(law.unsolved, str(error))
                found = []
            law.solved = tuple(found)
            brackets = [*_brackets(law, known, suffix)]
            later = [*_later(law, found, known, suffix)]
            found += [*_conjugates(law, known, suffix), *later]
            law.solved = tuple(found)
            for item in (*found, *brackets):
                parts.places[item] = place
                why = "follows from the map" if item in found else "the canonical bracket"
                gives = () if item in later else item.printed.heads.names
                parts.enter(item, StatementRole(CONVENTION, why, "", gives))


def _solved(law: Law, known: Known, suffix: str) -> Iterator[SourceStatement]:
    """What gives the images that no equation gives alone."""
    if not (left := law.unsolved):
        return
    scene = Stage(known).scene(law.items, law=law).scene
    implicit = [one.printed for one in law.items if one not in law.given.values()]
    for number, tex in enumerate(solutions(scene, left, implicit), 1):
        yield unprinted(known.paper, f"image-{number}{suffix}", tex, law.first, "the map gives it")


def _later(
    law: Law, solved: Sequence[SourceStatement], known: Known, suffix: str
) -> Iterator[SourceStatement]:
    """What gives the images of images that the paper prints: the same equations, steps later."""
    given = [one for one in (*law.items, *solved) if one.bare[:1] and len(one.members) == 2]
    given = [one for one in given if one.members[0] == Name(one.bare[0])]
    found = (_STEP.fullmatch(symbol(new).index) for _, new in law.images)
    index = next((step[1] for step in found if step), "")
    printed = {name for one in known.items for name in one.names}
    for one in given if index else ():
        last = max((_steps(n, one.bare[0], index) for n in printed), default=0)
        for k in range(1, last + 1 if index not in one.names else 1):
            tex = "=".join(to_latex(_shifted(member, index, k)) for member in one.members)
            id = re.sub(r"\W+", "-", f"step-{k}-of-{one.bare[0]}{suffix}")
            yield unprinted(known.paper, id, tex, law.first, "the map gives it, steps later")


def _steps(name: str, image: str, index: str) -> int:
    """By how many steps a name comes after an image of the same letter."""
    one, other = symbol(name), symbol(image)
    steps = [re.fullmatch(rf"{index}([+-]\d+)?", parts.index) for parts in (one, other)]
    if replace(one, index="") != replace(other, index="") or not all(steps):
        return 0
    later, first = (int(step[1] or 0) for step in steps if step)
    return later - first


def _shifted(formula: Formula, index: str, k: int) -> Formula:
    """A formula with all its steps a number of steps later."""
    if not isinstance(formula, Name):
        return formula.map_children(lambda child: _shifted(child, index, k))
    parts = symbol(formula.name)
    if not (step := re.fullmatch(rf"{index}([+-]\d+)?", parts.index)):
        return formula
    later = int(step[1] or 0) + k
    return Name(replace(parts, index=f"{index}{later:+}" if later else index).name)


def _conjugates(law: Law, known: Known, suffix: str) -> list[SourceStatement]:
    """The images of the conjugates of what is complex in a map with the imaginary unit."""
    units = [one.formula for one in known.units if one.formula is not None]
    rows = {name: one.formula for name, one in law.given.items() if one.formula is not None}
    try:
        conjugate = conjugate_images([*rows.values(), *units], rows, dict(law.images))
    except ValueError as error:
        known.lost |= dict.fromkeys(rows, str(error))
        return []
    found = [
        unprinted(known.paper, f"conjugate-{number}{suffix}", tex, law.first, "the conjugate")
        for number, tex in enumerate(conjugate, 1)
    ]
    new = {one.bare[0] for one in found}
    pairs = [(conjugate_name(x), conjugate_name(y)) for x, y in law.images]
    law.images = (*law.images, *((x, y) for x, y in pairs if y in new))
    return found


def _brackets(law: Law, known: Known, suffix: str) -> Iterator[SourceStatement]:
    """The canonical brackets of a map of which words speak, if none are printed."""
    printed = any(name.startswith(BRACKET) for name in known.definitions)
    if printed or not cue("symplectic", known.paper.prose.text):
        return
    names = [x for x, _ in law.images]
    try:
        pairs = conjugate_pairs(names)
    except ValueError:
        pairs = [(names[0], names[1])] if len(names) == 2 else []
    for number, tex in enumerate(canonical_brackets(pairs), 1):
        yield unprinted(known.paper, f"bracket-{number}{suffix}", tex, law.first)
