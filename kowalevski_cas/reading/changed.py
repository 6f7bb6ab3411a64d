"""Scenes in other variables: those that a display of the paper gives by the old ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.notation import Formula, Name, Negative, Number, Power, Relation
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import Adjoined, Space
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.statements import SourceStatement

UNIT = Relation((Power(Name("i"), Number(2)), Negative(Number(1))), ("=",))


def in_new_variables(scene: Scene, change: Sequence[SourceStatement], known: Known) -> Scene:
    """A scene in the variables that a display gives, and in those that do not stand there.

    The motion is that of the old scene, by the other time of the paper; variables whose formulas
    are conjugates are conjugates.

    Raises:
        ValueError: the paper prints no other time, or the change says too little.
    """
    printed = change[0].printed.display
    clock = next(reversed(known.clocks), None)
    if clock is None:
        raise ValueError("the paper prints no other time, in which the new variables would move")
    if scene.zero or scene.signs or scene.values:
        raise ValueError("what is supposed is not carried over to other variables: leave it out")
    given = frozenset().union(*(one.names for one in change))
    kept = tuple(name for name in scene.variables if name not in given)
    new = scene.changed(printed, clock.printed, kept).having(
        vectors=scene.vectors, constants=scene.constants, undefined=scene.undefined,
        conjugates=tuple(_conjugates(change, known)) if scene.unit is not None else (),
        nonzero=scene.nonzero, loci=scene.loci,
    )  # fmt: skip
    new = new.with_unit(scene.unit) if scene.unit is not None else new
    for root, by in scene.roots.items():
        new = new.solving(root, by)
    places = {*printed}
    rest = {name: by for name, by in scene.definitions.items() if by not in places}
    return replace(new, definitions=rest)


def _conjugates(change: Sequence[SourceStatement], known: Known) -> Iterator[tuple[str, str]]:
    """The pairs of names whose formulas are conjugates, where the old variables are real."""
    unit = known.units[0]
    if UNIT != unit.formula and not _accepted_as_unit(unit, known):
        raise ValueError(f"i is no imaginary unit by ${unit.printed.tex}$: accept i^2=-1")
    formulas = dict(map(_given, change))
    names = sorted({name for formula in formulas.values() for name in formula.names()} - {"i"})
    at = finder_of(Space(tuple(names), steps=(Adjoined("i", Negative(Number(1))),)))
    values = {name: at.scalar(formula) for name, formula in formulas.items()}
    left = dict.fromkeys(formulas)
    while left:
        name = next(iter(left))
        bar = at.scalar(formulas[name], True)
        other = next((one for one in left if (values[one] - bar).is_zero), None)
        if other is None:
            raise ValueError(f"no row of the change gives the conjugate of {name}")
        if other != name:
            yield name, other
        for one in {name, other}:
            del left[one]


def _accepted_as_unit(unit: SourceStatement, known: Known) -> bool:
    return any(tex.replace(" ", "") == "i^2=-1" for tex in known.said.accepted(unit))


def _given(row: SourceStatement) -> tuple[str, Formula]:
    """The name that a row of a change gives, with what it stands for."""
    name = next(iter(row.printed.heads.names), None)
    rest = [one for one in row.members if one != Name(name or "")]
    if name is None or len(rest) != 1:
        raise ValueError(f"${row.printed.tex}$ gives no new variable")
    return name, rest[0]
