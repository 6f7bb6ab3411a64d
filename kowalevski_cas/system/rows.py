"""The statements of a display of equations of motion, in which any letter is a name."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from kowalevski_cas.notation import (
    Conjugate,
    Derivative,
    Formula,
    Name,
    Partial,
    Sum,
    Summation,
    Vector,
    Vocabulary,
    read_display,
)
from kowalevski_cas.notation.cursor import is_word
from kowalevski_cas.notation.open import OpenParser, independent, words_that_move
from kowalevski_cas.notation.primed import primed_names
from kowalevski_cas.notation.symbol import name_of_rate
from kowalevski_cas.paper.amplitudes import conjugate_name
from kowalevski_cas.paper.names import head, is_bold
from kowalevski_cas.paper.summation import expand_sum
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.system.vectors import Vectors

Names = Collection[str]


def vocabulary_of(display: Display, vectors: Vectors, declared: Names) -> Vocabulary:
    """What is a vector, a matrix, a function or the independent variable in a display."""
    words = vocabulary(())
    names = [name for place in display for name in place.heads.names]
    functions = frozenset(function for function, arguments in map(head, names) if arguments)
    matrices = {name for place in display if place.heads.matrix for name in place.heads.names}
    matrices |= {name for name in names if is_bold(name)}
    dots = ["t"] if r"\dot" in display.tex or r"\ddot" in display.tex else []
    times = [*dict.fromkeys([*dots, *independent(display.tex)])] or ["t"]
    if len(times) > 1:
        by = " and by ".join(times)
        raise ValueError(f"derivatives by {by}: print one independent variable, or partial ones")
    scalars = functions.union(declared, words_that_move(display.tex), filter(is_word, names))
    words = replace(
        words, scalars=scalars, functions=words.functions | functions, vectors=frozenset(vectors),
        matrices=frozenset(matrices - vectors.keys()), times=frozenset(times),
        moving=frozenset(sorted(vectors)[:1]),  # by what a gradient is, does not matter yet
    )  # fmt: skip
    return replace(words, scalars=scalars.union(primed_names(display.tex, words)))


def read_rows(display: Display, words: Vocabulary) -> dict[Printed, Formula]:
    """The statements of a display, where any letter is a name; sums are written out."""

    def print_row(formula: Formula) -> Formula:
        formula = expand_sum(formula) if isinstance(formula, Summation) else formula
        return formula.map_children(print_row)

    found = read_display(display.tex, words, OpenParser)
    return {place: print_row(one.formula) for place, one in zip(display, found, strict=True)}


def moving_names(formula: Formula) -> list[str]:
    """The names that stand under a derivative, or by whose rates something is derived."""
    if isinstance(formula, Derivative) and isinstance(formula.argument, Name | Vector | Sum):
        return [node.name for node in formula.argument.nodes() if isinstance(node, Name)]
    if isinstance(formula, Derivative) and isinstance(formula.argument, Conjugate):
        return [conjugate_name(name) for name in sorted(formula.argument.names())]
    found = [name for child in formula.children() for name in moving_names(child)]
    by = formula.by if isinstance(formula, Partial) else ""
    return [name_of_rate(by), *found] if name_of_rate(by) != by else found
