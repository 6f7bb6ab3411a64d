r"""The equations of motion of a scene: what they are equations for, and their solution.

An equation :math:`f\,\dot x=g` is a row of the vector field as it stands. All others, as those of
Lagrange, are solved together for the highest derivatives, in which they have to be linear: by
Cramer's rule, so that the determinant is all that is divided by. A variable of which higher
derivatives are printed has velocities, which are variables too: with :math:`\ddot x=-x` the pair
:math:`x,\dot x` moves.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from itertools import pairwise
from operator import add, mul

from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Vector,
    times,
    total,
)
from kowalevski_cas.notation.symbol import rate_name
from kowalevski_cas.paper.components import row_components, sides
from kowalevski_cas.paper.generators import angles_of, in_generators, with_generators
from kowalevski_cas.paper.matrices import by_rows
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.partials import Partials
from kowalevski_cas.paper.rates import marks
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Equation, EquationOfMotion, Let, Meaningless


def field(
    setting: Meaning, places: Sequence[Printed], partials: Partials
) -> Iterator[EquationOfMotion]:
    """The rows of the field of a scene; raises :class:`Meaningless` if there is no such field."""
    _check_marks(setting)
    # a row may use the rates of angles that stand before it: they are known as they come
    setting.turning = turning = dict[str, Formula]()
    changed = not {*setting.scene.variables} <= partials.coordinates
    velocities = setting.velocities.items()
    rows = [EquationOfMotion((x,), Number(1), Name(rate)) for x, rate in velocities]
    found: dict[str, Printed] = {}
    others: list[Equation] = []
    for printed in places:
        left, right = setting.texts.ends(printed)
        row, force = _row(left, setting, changed), setting.plain(right)
        if row is None or _rests_on_rates(force, setting):
            others += pairwise(sides((left, right), setting))
            continue
        if force == Number(0) and len(row.names) > 1:
            force = Vector((force,) * len(row.names))
        row = EquationOfMotion(row.names, setting.plain(row.factor), force)
        turning[row.names[0]] = Quotient(row.force, row.factor)
        rows.append(row)
        for name in row.names:
            if found.setdefault(name, printed) != printed:
                raise Meaningless(
                    f"on the scene “{setting.scene.name}” {name} moves by two equations, at "
                    f"{found[name].place} and at {printed.place}: leave one out",
                    name,
                )
    whole = with_generators(setting, rows, complete=not others)
    rows = [*map(setting.radicals.row, whole)]
    jets = [jet for jet, _, _ in setting.scene.jets]
    if others:
        known = {name for row in rows for name in row.names}.union(jets)
        unknown = [name for name in setting.variables if name not in known]
        solved = [*_solve(others, unknown, rows, setting, partials)]
        turning |= {row.names[0]: Quotient(row.force, row.factor) for row in solved}
        rows += [row for one in solved for row in in_generators(one, setting)]
    yield from rows
    yield from _rows_of_jets(rows, setting, partials)


def _rows_of_jets(
    rows: Sequence[EquationOfMotion], setting: Meaning, partials: Partials
) -> Iterator[EquationOfMotion]:
    """The rows of the values of functions, which move as their arguments do."""
    known = {
        name: (factor, force)
        for row in rows
        for name, factor, force in row_components(row, setting)
    }
    known[setting.scene.time] = Number(1), Number(1)
    for jet in partials.slopes:
        slopes = partials.slopes[jet]
        if slopes.keys() <= known.keys():
            yield EquationOfMotion((jet,), *_along(slopes, known))


def _along(
    slopes: Mapping[str, Formula], known: Mapping[str, tuple[Formula, Formula]]
) -> tuple[Formula, Formula]:
    """The factor of a rate, and the rest, by the derivatives along what moves by known rows."""
    if len(slopes) == 1:
        ((name, slope),) = slopes.items()
        factor, force = known[name]
        return factor, times(slope, force)
    terms = (Quotient(times(slope, known[n][1]), known[n][0]) for n, slope in slopes.items())
    return Number(1), total(terms)


def _check_marks(setting: Meaning) -> None:
    """Refuse equations in which derivatives by the time are printed in more than one way."""
    scene, printed = setting.scene, marks(setting.printed_field)
    if scene.clock is not None:
        return
    if others := sorted(printed - {"dot", "prime", scene.time}):
        raise Meaningless(f"the time of “{scene.name}” is {scene.time}, and not {others[0]}")
    if {"dot", "prime"} <= printed:
        raise Meaningless("dots and primes in the same equations: print one of them")


def _row(left: Formula, setting: Meaning, changed: bool) -> EquationOfMotion | None:
    """The left side of a row of the field, with 0 on the right; ``None`` if it is none.

    Where variables are ``changed``, new ones move of which no row gives the rate.
    """
    factors = left.factors if isinstance(left, Product) else (left,)
    rates = [factor for factor in factors if isinstance(factor, Derivative)]
    others = [factor for factor in factors if factor not in rates]
    if len(rates) != 1 or any(_has_rate(other) or by_rows(other, setting) for other in others):
        return None
    inner, order = rates[0].argument, 0
    while isinstance(inner, Derivative):
        inner, order = inner.argument, order + 1
    if not isinstance(inner, Name):
        return None
    names = setting.scene.vectors.get(inner.name, (inner.name,))
    if inner.name in setting.scene.definitions and {*names}.isdisjoint(setting.scene.variables):
        return None  # what it stands for moves
    if changed and len(names) > 1 and not setting.scene.definitions.keys().isdisjoint(names):
        return None  # what some of its components stand for moves
    for _ in range(order):
        if not {*names} <= setting.velocities.keys():
            return None
        names = tuple(setting.velocities[name] for name in names)
    ones: Formula = Vector((Number(1),) * len(names)) if len(names) > 1 else Number(1)
    rest = tuple(ones if factor is rates[0] else factor for factor in factors)
    return EquationOfMotion(names, Product(rest) if len(rest) > 1 else ones, Number(0))


def _has_rate(formula: Formula) -> bool:
    """Whether something is derived by the time in a formula."""
    return any(isinstance(node, Derivative) for node in formula.nodes())


def _rests_on_rates(formula: Formula, setting: Meaning) -> bool:
    """Whether something is derived in a formula, or in what its names stand for."""
    found, waiting = set[str](), [formula]
    while waiting:
        formula = waiting.pop()
        if _has_rate(formula):
            return True
        defined = formula.names() & setting.scene.definitions.keys() - found
        found |= defined
        steps = (setting.step(name) for name in defined)
        waiting += [step.formula for step in steps if isinstance(step, Let)]
    return False


def _solve(
    equations: Sequence[Equation],
    unknown: Sequence[str],
    known: Sequence[EquationOfMotion],
    setting: Meaning,
    partials: Partials,
) -> Iterator[EquationOfMotion]:
    """The rows for variables whose rates stand in equations, with those that are known.

    Raises :class:`Meaningless` for equations that are not linear in the rates, or do not determine
    them.
    """
    angles = {name: angle for name, angle in angles_of(setting).items() if name in unknown}
    unknown = [*dict.fromkeys(angles[name][0] if name in angles else name for name in unknown)]
    rates = {name: rate_name(name) for name in unknown}
    at = setting.free([*rates.values()])
    generators = {name: at.ring.generator(rate) for name, rate in rates.items()}
    turned = {one: at.scalar(by) * generators[name] for one, (name, by) in angles.items()}
    jets = {
        jet: reduce(add, (at.scalar(slope) * generators[by] for by, slope in slopes.items()))
        for jet, slopes in partials.slopes.items()
        if slopes.keys() <= generators.keys()
    }
    given = [*known, *_rows_of_jets(known, setting, partials)]
    moving = {**generators, **turned, **jets}
    # the rates are generators here: derivatives by them say how they enter
    values = at.moving(moving, given).differences(equations)
    if len(values) != len(unknown):
        raise Meaningless(
            f"{len(values)} equations of motion for the {len(unknown)} rates of "
            f"{', '.join(unknown)}: print one for each"
        )
    matrix = [[_partial(value, rate) for rate in rates.values()] for value in values]
    constant = [
        value - reduce(add, map(mul, line, generators.values()))
        for value, line in zip(values, matrix, strict=True)
    ]
    # what is left has no rate in it only if the equation is linear: a square leaves its double
    # slope
    for entry in (*constant, *(entry for line in matrix for entry in line)):
        if not all(_partial(entry, rate).is_zero for rate in rates.values()):
            raise Meaningless("the equations of motion are not linear in the highest derivatives")
    whole = determinant(matrix)
    if whole.is_zero:
        raise Meaningless(f"the equations do not determine the rates of {', '.join(unknown)}")
    for k, name in enumerate(unknown):
        pairs = zip(matrix, constant, strict=True)
        changed = [[*line[:k], -value, *line[k + 1 :]] for line, value in pairs]
        row = formula_in(whole), formula_in(determinant(changed))
        left = {index for entry in row for index in at.scalar(entry).denominator}
        gone = sorted({index for value in values for index in value.denominator} - left)
        below = [formula_in(Element(at.ring, {0: at.ring.divisors[n]}, {})) for n in gone]
        yield EquationOfMotion(
            (name,), *(times(*below, entry) for entry in row)
        )  # what cancels is remembered


def _partial(element: Element, name: str) -> Element:
    return along(element, {name: element.ring.one})
