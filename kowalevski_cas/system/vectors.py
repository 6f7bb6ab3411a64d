"""The components of names in bold type, as equations of motion print or imply them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.notation import (
    Constant,
    CrossProduct,
    Formula,
    Name,
    NotationError,
    Partial,
    Relation,
    Vector,
    Vocabulary,
    defined_names,
)
from kowalevski_cas.notation.layout import statements
from kowalevski_cas.notation.open import OpenParser, bold_names, matrices_by_use
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.texts import Display, Printed

Parts = tuple[str, ...]
Vectors = Mapping[str, Parts]


def bold(vectors: Vectors) -> dict[str, Parts]:
    r"""Components by the names of vectors as the reader makes them, ``\mathbf{r}`` of ``\bf r``."""
    return {defined_names(f"{name}=0")[0].names[0]: parts for name, parts in vectors.items()}


def vectors_of(display: Display, known: Vectors, words: Vocabulary) -> dict[str, Parts]:
    r"""The vectors of a display with their components, beside those that are known.

    :math:`\mathbf r=(x,y,z)` names them. Those of other vectors that are defined are the letter
    with numbers; so are those of :math:`\mathbf M` if :math:`M_1,M_2` are printed, or if there are
    vector products, which are those of space.
    """
    new = {*bold_names(display.tex)} - known.keys() - words.matrices
    if not new:
        return dict(known)
    matrices = {name for place in display if place.heads.matrix for name in place.heads.names}
    matrices |= new & matrices_by_use(display.tex)
    words = replace(words, matrices=words.matrices | (new & matrices))
    for place in display:
        if not _readable(place, words, new - matrices):
            matrices |= new.intersection(place.heads.names)
    new -= matrices
    words = replace(words, vectors=words.vectors | new, matrices=words.matrices | matrices)
    formulas = [_read(place, words) for place in display if _readable(place, words)]
    found = {**known, **dict(_named_vectors(formulas, new))}
    nodes = [node for formula in formulas for node in formula.nodes()]
    names = {node.name for node in nodes if isinstance(node, Name)}
    numbered = {n: [symbol(n).component(k).name for k in range(1, 10)] for n in new - found.keys()}
    printed = {
        name: next(k for k, one in enumerate(parts) if one not in names)
        for name, parts in numbered.items()
    }
    # Of letters alone [a,b] may be a commutator of matrices.
    are_vectors = bool(found) or any(number > 1 for number in printed.values())
    products = [node for node in nodes if isinstance(node, CrossProduct)]
    spatial = any(are_vectors or node.bracket != "[" for node in products)
    # Those of which components are printed say how many others have.
    for name in sorted(numbered, key=lambda one: (printed[one] < 2, one)):
        rows = (f for f in formulas if isinstance(f, Relation) and Name(name) in f.members)
        size = next((size for row in rows for size in _sizes(row, found)), 3 * spatial)
        if size or printed[name] > 1:
            found[name] = tuple(numbered[name][: size or printed[name]])
    return found


def _readable(place: Printed, words: Vocabulary, vectors: Collection[str] = ()) -> bool:
    """Whether a statement can be read, if these names are vectors."""
    try:
        _read(place, replace(words, vectors=words.vectors.union(vectors)))
    except NotationError:
        return False
    return True


def _read(place: Printed, words: Vocabulary) -> Formula:
    """A statement, for the values that its indices have."""
    tokens = statements(place.display.tex)[place.number - 1].tokens
    return OpenParser(place.display.tex, tokens, words).statement()[0]


def _named_vectors(
    formulas: Sequence[Formula], new: Collection[str]
) -> Iterator[tuple[str, Parts]]:
    """The vectors of which the components are named."""
    for formula in formulas:
        match formula:
            case Relation((Name(name), Vector(entries), *_)) if name in new and names_only(formula):
                yield name, tuple(entry.name for entry in entries if isinstance(entry, Name))


def lengths(
    formulas: Sequence[Formula], vectors: Vectors, moving: Collection[str]
) -> Iterator[str]:
    r"""The equations :math:`r=|\mathbf r|` for the letters of vectors that move and are not bold.

    Raises ``ValueError`` for a capital, which may be a mass beside a moment.
    """
    names = {name for formula in formulas for name in formula.names()}
    firsts = (f.members[0] for f in formulas if isinstance(f, Relation))
    heads = {one.name for one in firsts if isinstance(one, Name)}
    components = {part for parts in vectors.values() for part in parts}
    for name, parts in vectors.items():
        letter = symbol(name).without_type
        known = letter.name in heads | components | {*moving} or letter.name not in names
        if known or {*moving}.isdisjoint((name, *parts)):
            continue
        if letter.letter.isupper():
            raise ValueError(
                f"{letter.name} stands beside {name}: print {letter.name}=|{name}| if it is the "
                "length, or rename it"
            )
        yield f"{letter.name}=|{name}|"


def names_only(formula: Formula) -> bool:
    r"""Whether a statement only names the components of a vector, as :math:`\mathbf r=(x,y,z)`.

    It may say that they are constant.
    """
    match formula:
        case Relation((Name(), Vector(entries)) | (Name(), Vector(entries), Constant())):
            names = {entry.name for entry in entries if isinstance(entry, Name)}
            return len(names) == len(entries) and {*formula.signs} == {"="}
    return False


def _sizes(formula: Formula, known: Vectors) -> Iterator[int]:
    """The sizes of the vectors in a formula."""
    for node in formula.nodes():
        if isinstance(node, Vector):
            yield len(node.components)
        elif isinstance(node, Name) and node.name in known:
            yield len(known[node.name])
        elif isinstance(node, Partial) and node.by in known:
            yield len(known[node.by])
