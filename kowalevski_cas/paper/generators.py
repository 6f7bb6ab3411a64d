"""The generators of the functions that stand on a scene, and how they move."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import partial

from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Derivative,
    Formula,
    Modulus,
    Name,
    Negative,
    NotationError,
    Number,
    Power,
    Product,
    Quotient,
    times,
)
from kowalevski_cas.notation.functions import CIRCULAR, MEANING
from kowalevski_cas.paper.arguments import Monomial, product_of, single_name
from kowalevski_cas.paper.components import row_components
from kowalevski_cas.paper.differentiate import derivative
from kowalevski_cas.paper.families import Generators, outside, template
from kowalevski_cas.paper.functions import value_of
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.names import head, primitive
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.paper.transcendental import PI, Transcendental
from kowalevski_cas.problem.goals import Follows, Goal, Rank, simple
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import Equation, EquationOfMotion, Meaningless

ONE, ZERO = Number(1), Number(0)


def functions_of(setting: Meaning) -> Transcendental:
    """The functions in what a scene prints, and in what is claimed on it."""
    scene = setting.scene
    if isinstance(scene.field, Change):
        return Transcendental((), (), (), (), "", lambda formula: formula)
    own = [*setting.printed_field, *setting.met, *_conditions(setting)]
    defined = [*_definitions(setting, scene.definitions)]
    known = scene.clock is not None or scene.time in scene.names()  # the letter may be another's
    time = "" if known else scene.time
    paired = {name for pair in scene.conjugates for name in pair}  # of what is complex none is read
    moving = [n for n in (*scene.variables, *setting.velocities.values()) if n not in paired]
    unit = ("i",) if scene.unit is not None and _is_imaginary(setting, scene.unit) else ()
    constants = [*scene.constants, *scene.undefined, *unit]
    radicals: dict[str, frozenset[str]] = {}
    squares = [*_squares(setting)]
    for name, formulas in squares:
        names = (_expand(setting, formula).names() for formula in formulas)
        below = frozenset[str]().union(*names) - {name}
        radicals[name] = below.union(*(radicals.get(letter, ()) for letter in below))
        # in the order of the scene: of a root under another one it is known by then whether it
        # moves
        (constants if radicals[name].issubset(constants) else moving).append(name)
    printed = [formula for _, formulas in squares for formula in formulas]
    free, expanded = free_names(setting, [*own, *printed]), partial(_expand, setting)
    values, formulas = _values(setting), [*own, *defined, *printed]
    formulas += _applied(setting, formulas)
    pairs = {a: b for pair in scene.conjugates for a, b in (pair, pair[::-1])}
    return Transcendental(
        formulas, free, moving, constants, time, expanded, values, radicals, pairs
    )


def _applied(setting: Meaning, formulas: Iterable[Formula]) -> list[Formula]:
    """What defined functions are at the arguments at which they stand in formulas."""
    functions = {function for function, given in map(head, setting.scene.definitions) if given}
    found = dict[Application, Formula]()
    waiting = [*formulas] if functions else []
    while waiting:
        for node in waiting.pop().nodes():
            known = isinstance(node, Application) and primitive(node.function)[0] in functions
            if isinstance(node, Application) and known and node not in found:
                with suppress(Meaningless):
                    found[node] = value_of(node, setting)
                    waiting.append(found[node])
    return [*found.values()]


def _squares(setting: Meaning) -> Iterator[tuple[str, Sequence[Formula]]]:
    """The roots that are no variables, with what is printed of their squares."""
    for name, place in setting.scene.roots.items():
        if name not in setting.scene.variables:
            with suppress(NotationError):
                if place is None:
                    yield name, setting.texts.expression(name).children()
                else:
                    yield name, setting.texts.relation(place).members


def _values(setting: Meaning) -> Iterator[tuple[Application, Formula]]:
    """The values of functions at constants that a scene prints.

    Raises :class:`Meaningless` for an equation that gives no value of a generator.
    """
    for place in setting.scene.values:
        left, right = setting.texts.sides(place)
        if not isinstance(left, Application) or len(MEANING.get(left.function, "  ")) > 1:
            raise Meaningless(f"the equation at {place.place} gives no value of such a function")
        if not left.arguments[0].names() <= {*setting.scene.constants}:
            raise Meaningless(f"the value at {place.place} is taken at no constant")
        yield left, right


def _expand(setting: Meaning, formula: Formula, inside: tuple[str, ...] = ()) -> Formula:
    """A formula in which no name is a defined one, and of names no conjugate and no length."""
    match formula:
        case Conjugate(Name(name)) if (other := _conjugate(setting, name)) is not None:
            return other
        case Power(Modulus(Name(name) as own), Number(2)) if (
            other := _conjugate(setting, name)
        ) is not None:
            return Product((own, other))
    if not isinstance(formula, Name) or formula.name not in setting.scene.definitions:
        return formula.map_children(lambda child: _expand(setting, child, inside))
    if formula.name in inside:
        raise Meaningless(f"{formula.name} is defined by itself", formula.name)
    return _expand(setting, setting.definition(formula.name), (*inside, formula.name))


def _conjugate(setting: Meaning, name: str) -> Name | None:
    """The conjugate of a complex variable, or constant; ``None`` of what is real."""
    pairs = (pair for pair in setting.scene.conjugates if name in pair)
    return next((Name(a if b == name else b) for a, b in pairs), None)


def _is_imaginary(setting: Meaning, unit: Printed) -> bool:
    """Whether the square of the unit is printed as -1."""
    with suppress(NotationError):
        square = Power(Name("i"), Number(2))
        return {*setting.texts.relation(unit).members} == {square, Negative(ONE)}
    return False


def _conditions(setting: Meaning) -> Iterator[Formula]:
    """What a scene takes for granted not to vanish, and where it degenerates."""
    scene = setting.scene
    texts = [
        *scene.nonzero,
        *(tex for locus in scene.loci for tex in (*locus.equations, locus.condition)),
    ]
    for tex in texts:
        with suppress(NotationError):
            yield setting.texts.expression(tex)
    for place in scene.signs:
        with suppress(NotationError):
            yield setting.texts.as_printed(place)


def _definitions(setting: Meaning, names: Iterable[str]) -> Iterator[Formula]:
    for name in names:
        with suppress(NotationError):
            yield setting.texts.formula(setting.scene.definitions[name])


def free_names(setting: Meaning, formulas: Iterable[Formula]) -> frozenset[str]:
    """The names that stand outside of functions in formulas, and in what is defined of them.

    The second derivative of what is defined is computed with its value.
    """
    scene, found, waiting = setting.scene, set[str](), [*formulas]
    heads: dict[str, list[str]] = {}
    for name in scene.definitions:
        heads.setdefault(head(name)[0], []).append(name)
    while waiting:
        formula = waiting.pop()
        applied = {primitive(n.function)[0] for n in formula.nodes() if isinstance(n, Application)}
        rated = {name for n in formula.nodes() if _is_second(n) for name in n.names()}
        new = (outside(formula) | applied | (rated & heads.keys())) - found
        found |= new
        found.update(part for name in new for part in scene.vectors.get(name, ()))
        waiting += _definitions(
            setting, [definition for name in new for definition in heads.get(name, ())]
        )
    return frozenset(found)


def _is_second(formula: Formula) -> bool:
    """Whether a formula derives a derivative."""
    return isinstance(formula, Derivative) and isinstance(formula.argument, Derivative)


def with_generators(
    setting: Meaning, rows: Sequence[EquationOfMotion], complete: bool = True
) -> Iterator[EquationOfMotion]:
    """The rows of a field, with those of generators in the place of what they replace.

    The time moves as well, where it stands in a formula. Raises :class:`Meaningless` for a name in
    an argument of which the rate is not known, if the rows are ``complete``.
    """
    functions, scene = setting.transcendental, setting.scene
    known = {
        name: (factor, force)
        for row in rows
        for name, factor, force in row_components(row, setting)
    }
    if functions.depends_on_time:
        known[scene.time] = ONE, ONE
        rows = [*rows, EquationOfMotion((scene.time,), ONE, ONE)]
    yield from (row for row in rows if not any(name in functions for name in row.names))
    for group in functions.groups if known else ():
        if not functions.moves(group):
            continue
        name = single_name(group.monomial)
        if complete or name is None or name in known:
            factor, force = _rate(group.monomial, known, setting)
            yield from _rows_of(group, factor, force, setting)


def _rows_of(
    group: Generators, factor: Formula, force: Formula, setting: Meaning
) -> Iterator[EquationOfMotion]:
    """The rows of generators by the rate of what they are taken of: the force over the factor."""
    for name, rate in group.rates().items():
        if name in group.moving:
            below, above = (
                (rate.denominator, rate.numerator) if isinstance(rate, Quotient) else (ONE, rate)
            )
            yield EquationOfMotion(
                (name,), times(below, factor), times(setting.plain(above), force)
            )


def angles_of(setting: Meaning) -> dict[str, tuple[str, Formula]]:
    """The generators in the place of a variable: of which, and their derivatives by it."""
    return {
        generator: (name, setting.plain(rate))
        for group in setting.transcendental.groups
        if (name := single_name(group.monomial)) in setting.scene.variables and name is not None
        for generator, rate in group.rates().items()
        if generator in group.moving
    }


def in_generators(row: EquationOfMotion, setting: Meaning) -> Iterator[EquationOfMotion]:
    """A row, or those of the generators in the place of its variable."""
    (name,) = row.names
    groups = [g for g in setting.transcendental.groups if single_name(g.monomial) == name]
    for group in groups:
        yield from _rows_of(group, row.factor, row.force, setting)
    if name in setting.variables:
        yield row


def _rate(
    monomial: Monomial, known: dict[str, tuple[Formula, Formula]], setting: Meaning
) -> tuple[Formula, Formula]:
    """The rate of a product of names: the force, and the factor by which it is divided."""
    name = single_name(monomial)
    if name in known:
        return known[name]
    rates = {
        moving: force if factor == ONE else Quotient(force, factor)
        for moving, (factor, force) in known.items()
    }
    argument = setting.plain(product_of(monomial))
    reach = Reach(setting)
    reach.formula(argument)
    for variable in setting.variables:
        if variable in reach.names and variable not in rates:
            raise Meaningless(f"solve the equations of motion for the rate of {variable}", variable)
    return ONE, derivative(argument, rates, setting.step)


def values_at_zero(given: Iterable[Equation], setting: Meaning) -> Iterator[Equation]:
    r"""What functions are where given equations make their argument vanish, as z = 0 makes |z|².

    So are sines and cosines known at multiples of the right angle.
    """
    zero = {one for pair in given for one, other in (pair, pair[::-1]) if other == ZERO}
    for group in setting.transcendental.groups:
        values, parts = group.kind.family.zero, dict(group.monomial)
        vanishes = any(parts.get(one, 0) > 0 for one in zero)
        if vanishes and values.keys() == group.kind.family.rates.keys():
            yield from ((group.values[one], template(tex)) for one, tex in values.items())
        elif group.kind.family is CIRCULAR:
            yield from _at_angles(group, given, setting)


def _at_angles(
    group: Generators, given: Iterable[Equation], setting: Meaning
) -> Iterator[Equation]:
    r"""The sine and the cosine where an angle is so many right angles by a given equation."""
    name = single_name(group.monomial)
    pairs = (pair for one in given for pair in (one, one[::-1]))
    angles = (b for a, b in pairs if name and a == Name(name) and b.names() == {PI})
    parts = [part for angle in angles if (part := _part_of_pi(angle)) is not None]
    quarters = 2 * parts[0] / group.over if parts else Fraction(1, 2)
    if quarters.denominator == 1:
        values = ((0, 1), (1, 0), (0, -1), (-1, 0))[quarters.numerator % 4]
        for letter, value in zip("sc", values, strict=True):
            yield group.values[letter], Number(value) if value >= 0 else Negative(ONE)


def _part_of_pi(angle: Formula) -> Fraction | None:
    r"""By what number :math:`\pi` is multiplied."""
    match angle:
        case Name():
            return Fraction(1)
        case Negative(inner):
            part = _part_of_pi(inner)
            return None if part is None else -part
        case Quotient(inner, Number(below)):
            part = _part_of_pi(inner)
            return None if part is None else part / below
        case Product((Number(factor), inner)):
            part = _part_of_pi(inner)
            return None if part is None else part * factor
        case Product((Quotient(Number(above), Number(below)), inner)):
            part = _part_of_pi(inner)
            return None if part is None else part * above / below
    return None


def _unknown(given: Sequence[Equation], setting: Meaning) -> list[str]:
    """The names in given equations of which it is not known what these say of functions."""
    reach = Reach(setting)
    for formula in (side for equation in given for side in equation):
        reach.formula(formula)
    zero = {*values_at_zero(given, setting)}
    settled = {name for name, _ in zero}
    known, unknown = set[str](), set[str]()
    for group in setting.transcendental.groups:
        below = (name for parameter in group.kind.parameters for name in parameter.names())
        names = {*group.names.values(), *setting.transcendental.names_under(group), *below}
        is_known = settled.issuperset(group.values.values())
        known, unknown = (known | names, unknown) if is_known else (known, unknown | names)
    found = reach.names & setting.transcendental.dependent
    return [] if zero <= {*given} and found <= known - unknown else sorted(found)


def check_hypotheses(goals: Iterable[Goal]) -> None:
    """Refuse given equations about generators that do not take all values by themselves.

    Nor is anything known of the dependence of several functions of them.
    """
    for goal in (part for whole in goals for part in simple(whole)):
        setting = goal.space
        if not isinstance(setting, Meaning) or not setting.transcendental.dependent:
            continue
        given = goal.given if isinstance(goal, Follows | Rank) else ()
        found = _unknown(given, setting)
        if not found and isinstance(goal, Rank) and len(goal.functions) + len(given) > 1:
            reach = Reach(setting)
            for formula in goal.functions:
                reach.formula(formula)
            found = sorted(reach.names & setting.transcendental.dependent)
        if found:
            raise Meaningless(
                f"{found[0]} stands under functions, and not only in one of them: "
                "what equations say of its values is not known",
                found[0],
            )
