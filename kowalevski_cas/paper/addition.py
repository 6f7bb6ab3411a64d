r"""The addition theorems of the functions that a problem uses, as goals of their own.

With v there move the functions of :math:`u+v` and those of v, by one system; where v is zero, those
of :math:`u+v` are those of u. So do their expressions by the functions of u and v. Those of iv
are known in the same way by others of v.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache

from kowalevski_cas.notation import Formula, Name, Negative, Number, Product, Sum
from kowalevski_cas.notation.functions import Family
from kowalevski_cas.paper.arguments import multiple
from kowalevski_cas.paper.families import (
    By,
    Generators,
    Imaginary,
    Kind,
    complementary,
    rotated,
    template,
)
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.goals import Along, Exists, Goal, simple
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import Adjoined, EquationOfMotion, Space

U, V = Name("u"), Name("v")
ARGUMENTS = {
    By.SUM: Sum((U, V)),
    By.DIFFERENCE: Sum((U, Negative(V))),
    By.OPPOSITE: Negative(V),
    By.DOUBLE: Product((Number(2), V)),
}
FACTORS = {By.SUM: 1, By.DIFFERENCE: -1, By.OPPOSITE: -1, By.DOUBLE: 2}
"""Their derivatives by v."""


def addition_theorems(goals: Iterable[Goal]) -> Iterator[Along]:
    """The theorems by which the functions in some goals are written out."""
    used: dict[tuple[Family, By], None] = {}
    for setting in dict.fromkeys(part.space for goal in goals for part in simple(goal)):
        if isinstance(setting, Meaning) and setting.transcendental.groups:
            reach = Reach(setting)
            for goal in goals:
                reach.bound |= {*(goal.bound if isinstance(goal, Exists) else ())}
                for part in simple(goal):
                    if part.space is setting:
                        reach.goal(part)
            derived = setting.transcendental.derived
            met = [derived[name] for name in sorted(reach.names & derived.keys())]
            used |= dict.fromkeys((group.family, group.by) for group in met)
    for family, by in used:
        yield rotation(family) if by is By.IMAGINARY else theorem(family, by)


@cache
def rotation(family: Family) -> Along:
    """The functions of a family at iv, by those of another one at v, or with another modulus."""
    unit, kind = Name("i"), Kind(family, tuple(map(Name, family.parameters)))
    real = Generators(rotated(kind), ((V, 1),), family.argument)
    imaginary = Imaginary(kind, real, 1)
    names, conjugates = kind.names(Product((unit, V))), kind.names(Negative(Product((unit, V))))
    rates: dict[str, Formula] = {**real.rates()}
    rates |= {name: Product((unit, rate)) for name, rate in kind.rates(names).items()}
    rates |= {n: Negative(Product((unit, rate))) for n, rate in kind.rates(conjugates).items()}
    moving = (*real.moving, *names.values(), *conjugates.values())
    initial = {real.names[g]: tex for g, tex in real.kind.family.zero.items()}
    initial |= {name[g]: tex for name in (names, conjugates) for g, tex in family.zero.items()}
    moduli = (
        Adjoined(complementary(modulus).name, kind.formula("1-k^2", {}))
        for modulus in kind.parameters
    )
    space = Space(
        variables=moving,
        constants=family.parameters,
        nonzero=tuple(real.values[n] for n in real.kind.family.nonzero),
        steps=(Adjoined("i", Negative(Number(1))), *moduli, *real.roots()),
        field=tuple(EquationOfMotion((name,), Number(1), rates[name]) for name in moving),
        conjugates=tuple((names[g], conjugates[g]) for g in names),
    )
    begin = tuple((name, template(tex)) for name, tex in initial.items())
    values = imaginary.values(real.values)
    return Along(space, begin, tuple((names[g], values[g]) for g in names))


@cache
def theorem(family: Family, by: By) -> Along:
    """The functions of a family at a sum of u and v, or a multiple of v, by those at u and v."""
    kind = Kind(family, tuple(map(Name, family.parameters)))
    first, second = (Generators(kind, ((letter, 1),), 1) for letter in (U, V))
    alone = by in (By.OPPOSITE, By.DOUBLE)
    names = kind.names(ARGUMENTS[by])
    values = kind.opposite(second.values) if FACTORS[by] < 0 else second.values
    if by is By.DOUBLE:
        values = kind.double(values)
    elif not alone:
        values = kind.sum(first.values, values)
    begins = {g: template(tex) for g, tex in family.zero.items()}
    initial = {second.names[g]: begins[g] for g in names}
    initial |= {names[g]: begins[g] if alone else first.values[g] for g in names}
    there = {name: multiple(rate, FACTORS[by]) for name, rate in kind.rates(names).items()}
    rates = {**second.rates(), **there}
    moving = (*second.moving, *names.values())
    space = Space(
        variables=moving,
        constants=(*family.parameters, *(() if alone else first.moving)),
        nonzero=tuple(g.values[n] for g in (first, second)[alone:] for n in family.nonzero),
        steps=(*(() if alone else first.roots()), *second.roots()),
        field=tuple(EquationOfMotion((name,), Number(1), rates[name]) for name in moving),
    )
    return Along(space, tuple(initial.items()), tuple((names[g], values[g]) for g in names))
