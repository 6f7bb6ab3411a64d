r"""Complex amplitudes: what moves by equations with the imaginary unit, and its conjugates.

In :math:`i\dot a=\bar ab` the letter i is the imaginary unit: it stands before a rate, beside a
bar, or its square is printed. What moves is complex then, unless its equation is its own conjugate,
as in :math:`\dot r=a\bar a-r`; the conjugate of a is a variable :math:`a^*` with an equation of its
own.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.algebra import load
from kowalevski_cas.notation import (
    Conjugate,
    Derivative,
    Formula,
    ImaginaryPart,
    Modulus,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Sum,
    to_latex,
)
from kowalevski_cas.notation.symbol import STAR, symbol
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Adjoined, Space

UNIT = "i"
SQUARE = Relation((Power(Name(UNIT), Number(2)), Negative(Number(1))), ("=",))


def conjugate_name(name: str) -> str:
    r"""The name of a conjugate.

    >>> conjugate_name("a_1")
    'a^*_1'
    """
    return replace(symbol(name), raised=STAR).name


def _without_bar(name: str) -> str:
    return replace(symbol(name), raised="").name


def _other(name: str) -> str:
    """The name of the conjugate, which may be that without a star."""
    return conjugate_name(name) if _without_bar(name) == name else _without_bar(name)


def with_conjugates(scene: Scene, formulas: Iterable[Formula]) -> Scene:
    """A scene on which what stands beside its conjugate, or under a bar, has a conjugate."""
    conjugate = {*_under_bars(formulas)} & {*scene.constants}
    names = (*scene.variables, *scene.constants, *sorted(map(conjugate_name, conjugate)))
    pairs = ((name, conjugate_name(name)) for name in names)
    return replace(
        scene,
        constants=tuple(dict.fromkeys(n for n in names if n not in scene.variables)),
        conjugates=tuple((a, b) for a, b in pairs if a != b and b in names),
    )


def conjugate_equations(formulas: Sequence[Formula], moving: Collection[str]) -> list[str]:
    """The conjugates of equations of motion with the imaginary unit; none if it is not there."""
    if UNIT in moving or not _has_unit(formulas, moving):
        return []
    laws = [one for one in formulas if isinstance(one, Relation) and _rates(one)]
    complex_names = _complex_names(laws, formulas, moving)
    rows = [one for one in laws if not complex_names.isdisjoint(map(_without_bar, _rates(one)))]
    links = [one for one in formulas if _is_link(one) and not complex_names.isdisjoint(one.names())]
    printed = {name for one in laws for name in _rates(one)}
    new = [
        to_latex(conjugate_of(row, complex_names))
        for row in (*rows, *links)
        if printed.isdisjoint(map(_other, _rates(row)))
    ]
    return [*new, *([] if SQUARE in formulas else [to_latex(SQUARE)])]


def conjugate_images(
    formulas: Sequence[Formula], rows: Mapping[str, Formula], images: Mapping[str, str]
) -> list[str]:
    r"""The conjugates of the equations of a map with :math:`i^2=-1` that are not their own.

    Args:
        formulas: all that is printed.
        rows: the equations, by the images that they give.
        images: the variables with their images.

    Raises ``ValueError`` if one is printed.
    """
    if SQUARE not in formulas:
        return []
    starred = [new for new in rows if _without_bar(new) != new]
    if starred:
        raise ValueError(f"{starred[0]}: the image of the conjugate follows: leave it out")
    found, before = {*_under_bars(formulas)} & {*images}, -1
    while before != len(found):
        before = len(found)
        found |= {one for pair in images.items() if not found.isdisjoint(pair) for one in pair}
        found |= {new for new, row in rows.items() if not _is_real(row, found)}
    return [to_latex(conjugate_of(row, found)) for new, row in rows.items() if new in found]


def _has_unit(formulas: Sequence[Formula], moving: Collection[str]) -> bool:
    """Whether what moves is complex: by its bars, and by what i can only be the unit in."""
    laws = [one for one in formulas if isinstance(one, Relation) and _rates(one)]
    before = (node.factors for one in laws for node in one.nodes() if isinstance(node, Product))
    beside = any(Name(UNIT) in factors and any(map(_is_rate, factors)) for factors in before)
    signs = [
        any(UNIT in one.names() for one in laws),
        not {*_under_bars(formulas)}.isdisjoint(map(_without_bar, moving)),
        SQUARE in formulas,
        any(_moduli(one) & {*moving} for one in laws),
    ]
    return beside or sum(signs) > 1


def _moduli(formula: Formula) -> set[str]:
    """The names of which a formula has the modulus."""
    nodes = (node.argument for node in formula.nodes() if isinstance(node, Modulus))
    return {one.name for one in nodes if isinstance(one, Name)}


def _under_bars(formulas: Iterable[Formula]) -> Iterator[str]:
    """The names of which conjugates are printed."""
    for node in (node for formula in formulas for node in formula.nodes()):
        if isinstance(node, Conjugate):
            yield from node.names()
        elif isinstance(node, Name) and symbol(node.name).raised == STAR:
            yield _without_bar(node.name)


def _is_link(formula: Formula) -> bool:
    """Whether two names are said to be one, as where a chain is closed."""
    match formula:
        case Relation((Name(), Name()), ("=",)):
            return True
    return False


def _is_rate(formula: Formula) -> bool:
    return isinstance(formula, Derivative)


def _rates(formula: Formula) -> set[str]:
    """The names that are derived by the time."""
    derived = [node.argument for node in formula.nodes() if isinstance(node, Derivative)]
    plain = {node.name for node in derived if isinstance(node, Name)}
    barred = (node.argument for node in derived if isinstance(node, Conjugate))
    return plain | {conjugate_name(node.name) for node in barred if isinstance(node, Name)}


def _complex_names(
    laws: Sequence[Relation], formulas: Sequence[Formula], moving: Collection[str]
) -> set[str]:
    """What is conjugated, and what moves by an equation that is not its own conjugate."""
    found = {one for one in _under_bars(formulas) if one != UNIT}
    while True:
        mixed = (row for row in laws if not _is_real(row, found))
        new = {name for row in mixed for name in _rates(row) if name in moving}
        linked = (one.names() for one in formulas if _is_link(one))
        new = new.union(*(names for names in linked if names & found)) - found
        new -= {*map(conjugate_name, found | new)}
        if not new:
            return found
        found |= new


def _is_real(row: Formula, complex_names: Collection[str]) -> bool:
    """Whether an equation is its own conjugate, where some names are complex."""
    there, other = (
        minus((one.children()[0], one.children()[-1]))
        for one in (row, conjugate_of(row, complex_names))
    )
    there, other = _arithmetic(there, complex_names), _arithmetic(other, complex_names)
    names = tuple(sorted((there.names() | other.names()) - {UNIT}))
    space = Space(names, steps=(Adjoined(UNIT, Negative(Number(1))),))
    at = Evaluation(space, load("flint")).adjoin_roots()
    left, right = at.scalar(there), at.scalar(other)
    return (left - right).is_zero or (left + right).is_zero


def conjugate_of(formula: Formula, complex_names: Collection[str]) -> Formula:
    """The conjugate of a formula, where some names are complex, and all others are real."""
    match formula:
        case Conjugate(argument):
            return argument
        case Name(name) if name == UNIT:
            return Negative(formula)
        case Name(name) if name in complex_names:
            return Name(conjugate_name(name))
        case Name(name) if conjugate_name(plain := _without_bar(name)) == name:
            return Name(plain)
        case Modulus() | RealPart() | ImaginaryPart():
            return formula
    return formula.map_children(lambda child: conjugate_of(child, complex_names))


def _arithmetic(formula: Formula, complex_names: Collection[str]) -> Formula:
    """A formula with a name for whatever is no operation of arithmetic."""
    match formula:
        case Conjugate(Name() as name):
            return conjugate_of(name, complex_names)
        case Name() | Number():
            return formula
        case Sum() | Negative() | Product() | Quotient() | Power(_, Number()):
            return formula.map_children(lambda child: _arithmetic(child, complex_names))
    return Name(to_latex(formula))
