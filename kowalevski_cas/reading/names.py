"""The names of a paper: vectors with their components, and which names belong together."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from kowalevski_cas.notation import CrossProduct, Formula, Name, Vector
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.letters_of_vectors import members_of_spaces
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement

AXES = ("x", "y", "z")
_SECOND = r"\breve"
POINTS = ("r", "x")
"""The letters of vectors that are points with these coordinates."""


def vectors_of(paper: SourcePaper) -> dict[str, tuple[str, ...]]:
    r"""The vectors of a paper with their components.

    :math:`\mathbf r=(x,y,z)` names them; other vectors have as many, called after the letter with
    numbers, as are printed of any of them, and three if there are vector products. Where
    :math:`p_x` is printed, it is a component of :math:`\mathbf p`; a point has its coordinates.
    The distance :math:`r_{12}` of two points is no component of :math:`\mathbf r_1`.
    """
    found = dict(_components_in_words(paper))
    lengths: dict[str, int] = {}
    for item in paper.items:
        lengths |= members_of_spaces(item.typed.tex)
    nodes = [n for item in paper.items if item.formula is not None for n in item.formula.nodes()]
    names = {node.name for node in nodes if isinstance(node, Name)}
    apart = _of_pairs(paper, names)
    names -= apart
    for item in paper.items:
        match item.members:
            case (Name(name), Vector(entries)) if name in paper.words.vectors:
                listed = tuple(one.name for one in entries if isinstance(one, Name))
                if len({*listed}) == len(entries):
                    found.setdefault(name, listed)
                lengths.setdefault(name, len(entries))
    indices = range(1, 1 + (paper.period or 9))
    size = 3 if any(isinstance(node, CrossProduct) for node in nodes) else 0
    for name in sorted(paper.words.vectors - found.keys()):
        may_be = _may_be_point(name, paper)
        if along := _along_axes(name, names - paper.words.vectors, may_be, size == 3):
            found[name] = along
    for name in paper.words.vectors:
        printed = (k for k in indices if symbol(name).component(k).name in names)
        size = max([size, *printed])
    sizes = {len(one) for one in found.values()} or {size or 3}
    for name in sorted(paper.words.vectors - found.keys()):
        size = lengths.get(name, max(sizes))
        found[name] = tuple(symbol(name).component(k).name for k in range(1, 1 + size))
    return _each_with_its_own(found, apart)


def _of_pairs(paper: SourcePaper, names: Collection[str]) -> set[str]:
    r"""The names with two numbers that belong to two vectors with one: their distances, or others.

    So is :math:`r_{12}` beside :math:`\mathbf r_1,\mathbf r_2` where it is given by both of them,
    is the length of :math:`\mathbf r_{12}`, or where no :math:`r_{11}` is printed.
    """
    printed = {name: symbol(name) for name in paper.words.vectors & {*names}}
    numbers = {parts.index for parts in printed.values() if len(parts.index) == 1}
    letters = {replace(own, index="").without_type for own in printed.values()}
    pairs = {
        name: [replace(parts, index=one) for one in parts.index]
        for name, parts in ((name, symbol(name)) for name in names)
        if len(parts.index) == 2 and {*parts.index} <= numbers
        and replace(parts, index="") in letters
    }  # fmt: skip

    def vectors(name: str) -> set[str]:
        return {one for one, own in printed.items() if own.without_type in pairs[name]}

    given = {
        name
        for item in paper.items
        if pairs and item.members
        for name in pairs.keys() & {*item.printed.heads.names, *item.printed.heads.squares}
        if vectors(name) <= item.names
    }
    lengths = {name for name in pairs if symbol(name) in {o.without_type for o in printed.values()}}
    used = {n for item in paper.items if not isinstance(item.formula, Name) for n in item.names}
    alike = any(symbol(name).index[0] == symbol(name).index[1] for name in pairs.keys() & used)
    return {*pairs} if given or lengths or not alike else set()


def _each_with_its_own(
    vectors: Mapping[str, tuple[str, ...]], apart: Collection[str]
) -> dict[str, tuple[str, ...]]:
    r"""The vectors, of which none has a component of another one, or a name that stands apart.

    A list that shares names with one before defines its vector; a letter in a second type of print
    has components with an accent.
    """
    taken = {*apart}
    found: dict[str, tuple[str, ...]] = {}
    for name, parts in vectors.items():
        own = [symbol(name).component(k) for k in range(1, 1 + len(parts))]
        accented = (replace(one, accents=(*one.accents, _SECOND)).name for one in own)
        ways = (parts, tuple(one.name for one in own), tuple(accented))
        found[name] = next((way for way in ways if taken.isdisjoint(way)), ())
        taken |= {*found[name]}
    return {name: parts for name, parts in found.items() if parts}


_ANOTHER = (
    r"(?:of|to|from|by|and|with|in|on|for|opposite|derivatives?|rates?|means?|averaged?"
    r"|и|к|от|на|в|производн\w*|средн\w*|приращени\w*)\b"
)
"""Words for another vector than the one behind them."""
_OF = re.compile(
    r"[\s,~]*(?:[-—–]+|are|be|denote)?\s*(?:the\s+)?(?:components?|projections?|проекци[ияй]|компонент[ыа]?)"
    rf"(?:\s+of)?(?:\s+the)?(?:\s+(?!{_ANOTHER})\w+){{0,4}}[\s~]*",
    re.IGNORECASE,
)
_WITH = re.compile(
    r"[\s,~]*(?:with|has|having|of|имеет|с)\s+(?:the\s+)?(?:components?|projections?|проекци(?:и|ями)|компонент(?:ы|ами))"
    r"(?:\s+(?:on|along|in|на)\s+(?:\w+\s+){0,4}(?:axes|frame|оси|осях))?[\s~]*",
    re.IGNORECASE,
)
"""The words between letters and the vector of which they are components."""
_AND = re.compile(r"[\s,~]*(?:and|и)?[\s~]*")


def _components_in_words(paper: SourcePaper) -> Iterator[tuple[str, tuple[str, ...]]]:
    r"""The vectors of which words call letters the components: :math:`p,q,r` those of the rotation.

    Each letter is printed by itself.
    """
    formulas: list[list[SourceStatement]] = []
    for _, group in groupby(paper.items, key=lambda one: one.typed.start):
        listed = [*group]
        joined = formulas and _AND.fullmatch(listed[0].lead)
        if joined and formulas[-1][0].sentence == listed[0].sentence:
            formulas[-1] += listed
        else:
            formulas.append(listed)
    for first, second in pairwise(formulas):
        words = second[0].lead
        of, having = _OF.fullmatch(words), _WITH.fullmatch(words)
        vector, listed = (second, first) if of else (first, second)
        if (of or having) and len(vector) == 1 and first[0].sentence == second[0].sentence:
            name = getattr(vector[0].formula, "name", "")
            letters = tuple(one.formula.name for one in listed if isinstance(one.formula, Name))
            plain = len({*letters}) == len(listed) and not paper.words.vectors & {*letters}
            if name in paper.words.vectors and plain and len(letters) in (2, 3):
                yield name, letters


def _may_be_point(name: str, paper: SourcePaper) -> bool:
    """Whether a vector may have the usual coordinates: words write out, or deduce, its equations.

    What moves by equations of its own may be another one.
    """
    rows = [item for item in paper.items if name in item.rates]
    if not rows:
        return True
    having = [item for item in paper.items if {*AXES} & item.names]
    rated = [item for item in having if {*AXES} & {*item.rates}]
    first = next((item for item in rated if item.order > rows[0].order), None)
    before = [item for item in having if item.order < rows[0].order]
    if first is None or before:
        return False
    said = any(cue(name, first.before) for name in ("restated", "deduced"))
    said = said or bool(cue("that is", f"{first.lead} ") or _THIS_IS.search(first.before))
    return said or bool(first.sentence == rows[0].sentence and _GIVES.search(first.lead))


_GIVES = re.compile(r"\b(?:gives?|becomes?|yields?|да[её]т)\b", re.IGNORECASE)
_THIS_IS = re.compile(
    r"\bthis\s+(?:is|reads|means|gives|becomes)\b|\bэто\s+да[её]т\b", re.IGNORECASE
)
"""Words that write vector equations out: in their sentence, or in another one."""


def _along_axes(
    name: str, names: Collection[str], may_be_point: bool, in_space: bool
) -> tuple[str, ...]:
    """The components of a vector along the axes, if some are printed; empty if none are.

    Those of a point are its coordinates: what moves by equations of its own may be another one.
    """
    own = symbol(name)
    if own.component(1).name in names:
        return ()
    along = tuple(own.component(axis).name for axis in AXES)
    if not {*along} & {*names}:
        point = own.without_type.name in POINTS and {*AXES[:2]} <= {*names}
        along = AXES if point and may_be_point else ()
    return along if in_space or {*along[2:]} & {*names} else along[:2]


class Names:
    """What belongs to the names of a paper: vectors and components."""

    def __init__(self, vectors: Mapping[str, tuple[str, ...]]) -> None:
        self.vectors = vectors
        self.owner = {part: name for name, parts in vectors.items() for part in parts}

    def scalars(self, names: Iterable[str]) -> tuple[str, ...]:
        """The names with vectors by their components, each once."""
        parts = (part for name in names for part in self.vectors.get(name, (name,)))
        return tuple(dict.fromkeys(parts))

    def are_components(self, members: Sequence[Formula]) -> bool:
        r"""Whether an equation names the components of a vector: :math:`x=(x_1,x_2,x_3)`."""
        match members:
            case (Name(name), Vector(entries)):
                return self.vectors.get(name) == tuple(getattr(e, "name", "") for e in entries)
        return False

    def whole(self, name: str) -> str:
        """The vector of which a name is a component, or the name itself."""
        return self.owner.get(name, name)
