r"""The equations of motion of a scene: what they are equations for, and their solution.

An equation :math:`f\,\dot x=g` is a row of the vector field as it stands. All others, as those of
Lagrange, are solved together for the highest derivatives, in which they have to be linear: by
Cramer's rule, so that the determinant is all that is divided by. A variable of which higher
derivatives are printed has velocities, which are variables too: with :math:`\ddot x=-x` the pair
:math:`x,\dot x` moves.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property, reduce
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
    NotationError,
    Number,
    Partial,
    Product,
    Quotient,
    Vector,
    times,
    to_latex,
    total,
)
from kowalevski_cas.notation.symbol import name_of_rate, rate_name
from kowalevski_cas.paper.components import component, sides
from kowalevski_cas.paper.generators import angles_of, functions_of, in_generators, with_generators
from kowalevski_cas.paper.inverse import inverse
from kowalevski_cas.paper.matrices import by_rows
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.radicals import Radicals
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.paper.transcendental import Transcendental
from kowalevski_cas.paper.validation import check_time
from kowalevski_cas.problem.space import (
    ChangeOfVariables,
    Equation,
    EquationOfMotion,
    Let,
    Meaningless,
)


def velocities(
    equations: Sequence[Formula],
    variables: Sequence[str],
    vectors: Mapping[str, tuple[str, ...]],
    given: Mapping[str, Formula],
) -> dict[str, str]:
    """The variables of which equations print higher derivatives, and those derivatives' names.

    What is ``given`` by a formula is derived as often as the names in this are.
    """
    found: dict[str, str] = {}
    for equation in equations:
        for name, order in _orders(equation, given=given):
            for variable in vectors.get(name, (name,)):
                rate = variable
                if variable in variables and order > 3:
                    raise Meaningless(
                        f"{variable} is derived {order} times: at most three are read"
                    )
                for _ in range(order - 1 if variable in variables else 0):
                    # targets are assigned from left to right: the key is still the name before
                    found[rate] = rate = rate_name(rate)
    return found


def _orders(
    formula: Formula, above: int = 0, given: Mapping[str, Formula] | None = None
) -> Iterator[tuple[str, int]]:
    """The names in a formula, and how often they are derived by the time, there and above it."""
    if isinstance(formula, Name):
        yield formula.name, above
        if above and given and formula.name in given:
            rest = {name: one for name, one in given.items() if name != formula.name}
            yield from _orders(given[formula.name], above, rest)
    elif isinstance(formula, Partial) and (name := name_of_rate(formula.by)) != formula.by:
        yield name, above + 1
    for child in formula.children():
        yield from _orders(child, above + isinstance(formula, Derivative), given)


def field(setting: Meaning, places: Sequence[Printed]) -> Iterator[EquationOfMotion]:
    """The rows of the field of a scene; raises :class:`Meaningless` if there is no such field."""
    _check_marks(setting)
    # a row may use the rates of angles that stand before it: they are known as they come
    setting.turning = turning = dict[str, Formula]()
    velocities = setting.velocities.items()
    rows = [EquationOfMotion((x,), Number(1), Name(rate)) for x, rate in velocities]
    found: dict[str, Printed] = {}
    others: list[Equation] = []
    for printed in places:
        left, right = setting.texts.ends(printed)
        row, force = _row(left, setting), setting.plain(right)
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
        solved = [*_solve(others, unknown, rows, setting)]
        turning |= {row.names[0]: Quotient(row.force, row.factor) for row in solved}
        rows += [row for one in solved for row in in_generators(one, setting)]
    yield from rows
    yield from _rows_of_jets(rows, setting)


def _rows_of_jets(rows: Sequence[EquationOfMotion], setting: Meaning) -> Iterator[EquationOfMotion]:
    """The rows of the values of functions, which move as their arguments do."""
    known = {
        name: (factor, force) for row in rows for name, factor, force in setting.components(row)
    }
    known[setting.scene.time] = Number(1), Number(1)
    for jet in setting.slopes_of_jets:
        slopes = setting.slopes_of_jets[jet]
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


def _row(left: Formula, setting: Meaning) -> EquationOfMotion | None:
    """The left side of a row of the field, with 0 on the right; ``None`` if it is none."""
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


def marks(equations: Sequence[Formula]) -> set[str]:
    """How the derivatives in equations are printed: with dots, with primes, by a variable."""
    nodes = (node for formula in equations for node in formula.nodes())
    return {node.mark for node in nodes if isinstance(node, Derivative)}


def _solve(
    equations: Sequence[Equation],
    unknown: Sequence[str],
    known: Sequence[EquationOfMotion],
    setting: Meaning,
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
        for jet, slopes in setting.slopes_of_jets.items()
        if slopes.keys() <= generators.keys()
    }
    given = [*known, *_rows_of_jets(known, setting)]
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


class Moving(Meaning):
    """What the printed equations of motion of a scene say.

    With a change of variables the motion is that of the ``source``; ``inverses`` has what was
    solved for changes from here.
    """

    source: Moving | None
    inverses: dict[object, dict[str, Formula]]

    @cached_property
    def printed_field(self) -> list[Formula]:
        """The equations of motion, as far as they can be read; who needs them is told the rest."""
        rows = self.scene.field
        found: list[Formula] = []
        for place in () if isinstance(rows, ChangeOfScene) else rows:
            with suppress(NotationError):
                found.append(self.texts.relation(place))
        return found

    @cached_property
    def transcendental(self) -> Transcendental:
        """The functions at the arguments that stand in what the scene and the claim print."""
        return functions_of(self)

    @cached_property
    def radicals(self) -> Radicals:
        """The fractional powers in what the scene and the claim print."""
        if isinstance(self.scene.field, ChangeOfScene):
            return Radicals((), ())
        places = [place for place in self.scene.places if place not in self.scene.field]
        printed = [*self.printed_field, *self.met]
        for place in places:
            with suppress(NotationError):
                printed.append(self.texts.formula(place))
        for name in self.scene.roots:
            if name.startswith(r"\sqrt"):
                printed.append(self.texts.expression(name))
        names = {*self.scene.variables, *self.scene.constants}
        functions = self.transcendental
        under = {name for group in functions.groups for name in functions.names_under(group)}
        return Radicals(printed, names, under)

    @property
    def together(self) -> tuple[tuple[str, ...], ...]:
        return self.transcendental.together

    @property
    def own_variables(self) -> tuple[str, ...]:
        if self.transcendental.groups:
            what = f"{to_latex(self.transcendental.groups[0].argument)} stands under a function"
            raise Meaningless(f"{what}: degrees, volumes and numbers of solutions are not known")
        return self.variables

    @cached_property
    def velocities(self) -> dict[str, str]:
        """The variables of which higher derivatives are printed, and those derivatives' names."""
        scene = self.scene
        given = {name: self.definition(name) for name in self._derived_twice()}
        return velocities(self.printed_field, scene.variables, scene.vectors, given)

    def _derived_twice(self) -> list[str]:
        """The names with a definition that the equations of motion derive more than once."""
        derived = {name for one in self.printed_field for name, order in _orders(one) if order > 1}
        return [name for name in self.scene.definitions if name in derived]

    _is_solved = False
    """Whether the equations of motion are being solved."""

    @cached_property
    def field(self) -> tuple[EquationOfMotion, ...]:
        """The printed equations of motion, solved for the rates where they are not."""
        rows = self.scene.field
        if self.scene.unit is not None:
            _ = self.finder  # it asks for the rates when it is made, which conjugates wait for
            if "field" in self.__dict__:
                found: tuple[EquationOfMotion, ...] = self.__dict__["field"]
                return found
        if self._is_solved:
            raise Meaningless("the equations of motion rest on rates that they have to give")
        self._is_solved = True
        try:
            return () if isinstance(rows, ChangeOfScene) else tuple(field(self, rows))
        finally:
            self._is_solved = False

    @cached_property
    def change(self) -> ChangeOfVariables | None:
        """The change of variables that gives the field."""
        change = self.scene.field
        if not isinstance(change, ChangeOfScene):
            return None
        assert self.source is not None
        new: dict[str, Formula] = {}
        for printed in change.formulas:
            left, right = self.texts.sides(printed)
            if not isinstance(left, Name):
                raise Meaningless(f"the formula at {printed.place} gives no variable")
            new[left.name] = self.source.plain(right)
        old_names = (*self.scene.variables, *self.scene.definitions)
        formulas = [
            *((n, f) for n, f in new.items() if n in old_names),
            *((n, Name(n)) for n in old_names if n in self.source.variables and n not in new),
        ]
        check_time(self.source, change.time)
        time = Quotient(Number(1), self.source.plain(self.texts.time_change(change.time).rate))
        return ChangeOfVariables(self.source, tuple(formulas), time)

    @cached_property
    def inverse(self) -> dict[str, Formula]:
        """The old variables of a change through the new ones; solved for once a change."""
        assert self.source is not None
        known = self.source.inverses
        if self.scene.field not in known:
            change = self.change
            assert change is not None
            known[self.scene.field] = inverse(self.source, change.formulas)
        return known[self.scene.field]

    def motion_places(self) -> Iterator[Printed]:
        """The places on which every derivative rests."""
        field = self.scene.field
        if isinstance(field, ChangeOfScene):
            assert self.source is not None
            yield from (*field.formulas, field.time)
            yield from self.source.motion_places()
        else:
            yield from field
        yield from self.scene.zero

    def components(self, row: EquationOfMotion) -> Iterator[tuple[str, Formula, Formula]]:
        if len(row.names) == 1:
            yield row.names[0], row.factor, row.force
            return
        for index, name in enumerate(row.names):
            yield name, component(row.factor, index, self), component(row.force, index, self)
