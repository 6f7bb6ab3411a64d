"""The generators of the functions that stand on a scene, and how they move."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    NotationError,
    Number,
    Product,
    Quotient,
    Relation,
    times,
    to_latex,
    total,
)
from kowalevski_cas.paper.arguments import Monomial, product_of, single_name
from kowalevski_cas.paper.differentiate import derivative
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.paper.transcendental import Transcendental, outside
from kowalevski_cas.problem.space import Meaningless, Motion

ONE, ZERO = Number(1), Number(0)


def functions_of(setting: Meaning) -> Transcendental:
    """The functions in what a scene prints, and in what is claimed on it."""
    scene = setting.scene
    if isinstance(scene.field, Change):
        return Transcendental((), (), (), ())
    own = [*setting.printed_field, *setting.met, *_conditions(setting)]
    defined = [*_definitions(setting, scene.definitions)]
    time = () if scene.clock is not None or scene.time in scene.variables else (scene.time,)
    moving = (*scene.variables, *setting.velocities.values(), *time)
    roots = (name for name in scene.roots if name not in scene.variables)
    constants = (*scene.constants, *scene.undefined, *roots)
    return Transcendental([*own, *defined], free_names(setting, own), moving, constants)


def _conditions(setting: Meaning) -> Iterator[Formula]:
    """What a scene takes for granted not to vanish, and where it degenerates."""
    scene = setting.scene
    texts = [*scene.nonzero, *(tex for locus in scene.loci for tex in (*locus.equations, locus.condition))]
    for tex in texts:
        with suppress(NotationError):
            yield setting.texts.expression(tex)


def _definitions(setting: Meaning, names: Iterable[str]) -> Iterator[Formula]:
    for name in names:
        with suppress(NotationError):
            yield setting.texts.formula(setting.scene.definitions[name])


def free_names(setting: Meaning, formulas: Iterable[Formula]) -> frozenset[str]:
    """The names that stand outside of functions in formulas, and in what is defined of them."""
    scene, found, waiting = setting.scene, set[str](), [*formulas]
    heads: dict[str, list[str]] = {}
    for name in scene.definitions:
        heads.setdefault(head(name)[0], []).append(name)
    while waiting:
        formula = waiting.pop()
        applied = {one.function for one in formula.nodes() if isinstance(one, Application)}
        new = (outside(formula) | applied) - found
        found |= new
        found.update(part for name in new for part in scene.vectors.get(name, ()))
        waiting += _definitions(setting, [one for name in new for one in heads.get(name, ())])
    return frozenset(found)


def with_generators(setting: Meaning, rows: Sequence[Motion]) -> Iterator[Motion]:
    """The rows of a field, with those of generators in the place of what they replace.

    The time moves as well, where it stands in a formula. Raises :class:`Meaningless` for a name in
    an argument of which the rate is not known.
    """
    functions, scene = setting.transcendental, setting.scene
    known = {name: (factor, force) for row in rows for name, factor, force in setting.components(row)}
    used = {name for group in functions.groups for name in group.argument.names()}
    if scene.time in functions.variables and scene.time in used | functions.free:
        known.setdefault(scene.time, (ONE, ONE))
    if not known:
        return
    yield from (row for row in rows if not any(name in functions for name in row.names))
    if scene.time in setting.variables and scene.time not in {n for row in rows for n in row.names}:
        yield Motion((scene.time,), ONE, ONE)
    for group in functions.groups:
        if not functions.moves(group):
            continue
        factor, force = _rate(group.monomial, known, setting)
        for name, rate in group.rates().items():
            if name in group.moving:
                below, above = (rate.denominator, rate.numerator) if isinstance(rate, Quotient) else (ONE, rate)
                yield Motion((name,), times(below, factor), times(setting.plain(above), force))


def _rate(
    monomial: Monomial, known: dict[str, tuple[Formula, Formula]], setting: Meaning
) -> tuple[Formula, Formula]:
    """The rate of a product of names: the force, and the factor by which it is divided."""
    name = single_name(monomial)
    if name in known:
        return known[name]
    rates = {one: force if factor == ONE else Quotient(force, factor) for one, (factor, force) in known.items()}
    argument = product_of(monomial)
    for one in sorted(argument.names()):
        if one in setting.transcendental.variables and one not in rates:
            raise Meaningless(f"solve the equations of motion for the rate of {one}", one)
    return ONE, derivative(setting.plain(argument), rates, setting.step)
