"""The linear part of a vector field at a point of rest: eigenvalues, trace, determinant."""

from __future__ import annotations

from collections.abc import Iterator
from math import factorial

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    times,
    total,
)
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import (
    ONE,
    entries,
    equation,
    equations,
    members,
    minus,
    rate,
    slope,
    vanishes,
)
from kowalevski_cas.paper.claims.inequality import compared, told_apart
from kowalevski_cas.paper.components import row_components
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import Rows, as_matrices, determinant
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.problem.goals import Fails, Follows, Goal
from kowalevski_cas.problem.space import Equation, Meaningless


class OfLinearPart(Claim):
    """What is said of the matrix of the derivatives of the rates at a point of rest.

    The point is where ``relations`` hold: they give all variables; velocities are zero there.
    """

    relations: tuple[Printed, ...]

    def _at_rest(self, on: Elaborations, space: Elaboration) -> tuple[Equation, ...]:
        """The equations of the point."""
        still = (vanishes(Name(name)) for name in space.velocities.values())
        return (*equations(on, space, self.relations), *still)

    def _value(self, on: Elaborations, space: Elaboration) -> Formula:
        """What is printed, or the last member of the equation that is."""
        return space.plain(told_apart(on.texts.as_printed(self.own))[0][-1])

    def _compared(self, on: Elaborations) -> Iterator[Goal]:
        r"""What the printed value is compared with, as in :math:`\lambda=-a<0`."""
        chain = told_apart(on.texts.as_printed(self.own))[1]
        if chain is not None:
            yield from compared(on, self.scene, chain)


class Eigenvalue(OfLinearPart):
    r"""The printed number is an eigenvalue of the linear part of the field at a point of rest.

    The point is where ``relations`` hold: they give all variables. With the matrix J of the
    derivatives of the rates by the variables :math:`\det(J-\lambda E)=0` there.
    """

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        value, given = self._value(on, space), self._at_rest(on, space)
        matrix = _minus(_linear_part(space), value)
        yield Fails(space, (), given)
        yield Follows(space, ((vanishes(determinant(matrix)), *_rest(space)),), given)
        yield from self._compared(on)


class Frequency(OfLinearPart):
    r"""The printed number is the frequency of small oscillations near a point of rest.

    With the matrix J of the linear part :math:`\det(J^2+\omega^2E)=0`: of all real J that are those
    with the eigenvalue :math:`i\omega`. It is not zero. If it ``is_square``, its square is printed.
    """

    is_square: bool

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        value, given = self._value(on, space), self._at_rest(on, space)
        square, matrix = self._square(value), _linear_part(space)
        matrix = _minus(_product(matrix, matrix), Negative(square))
        yield Fails(space, ((vanishes(square),),), given)
        yield Follows(space, ((vanishes(determinant(matrix)), *_rest(space)),), given)
        yield from self._compared(on)

    def _square(self, value: Formula) -> Formula:
        """The square of the frequency, by what is printed."""
        return value if self.is_square else Power(value, Number(2))


class Period(Frequency):
    r"""The printed number is the period of small oscillations: :math:`2\pi` over a frequency."""

    def _square(self, value: Formula) -> Formula:
        whole = Power(Product((Number(2), Name(PI))), Number(2))
        return Quotient(whole, super()._square(value))


class CharacteristicEquation(OfLinearPart):
    r"""The printed equation is the characteristic one of the linear part at a point of rest.

    The difference of its sides, or the printed polynomial, is :math:`c\det(\lambda E-J)`, where the
    ``variable`` is :math:`\lambda`, and c is not zero and free of it.
    """

    variable: str

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        value, given, matrix = self._polynomial(on), self._at_rest(on, space), _linear_part(space)
        # the n-th derivative is n! times the leading coefficient; it is free of λ, else 1/λ would
        # do for λ², as it is half of λ² times its second derivative
        leading = value
        for _ in matrix:
            leading = space.partial(leading, self.variable)
        free = vanishes(space.partial(leading, self.variable))
        same = (*self._same(value, leading, matrix), free, *_rest(space))
        yield Fails(space, ((vanishes(leading),),), given)
        yield Follows(space, (same,), given)

    def _polynomial(self, on: Elaborations) -> Formula:
        """The printed polynomial, or the difference of the sides of the equation."""
        printed = on.texts.formula(self.own)
        space = on(self.scene)
        if isinstance(printed, Relation):
            return minus(equation(on, space, self.own))
        return space.plain(printed)

    def _same(self, value: Formula, leading: Formula, matrix: Rows) -> Iterator[Equation]:
        """That n! times the polynomial is the determinant, times the derivative."""
        below = determinant(_minus(matrix, Name(self.variable)))
        sign = (-1) ** len(matrix) * factorial(len(matrix))
        yield vanishes(total((times(Number(sign), value), Negative(Product((leading, below))))))


class FrequencyEquation(CharacteristicEquation):
    r"""The printed equation is the one of the frequencies of small oscillations at a point of rest.

    It is the characteristic equation with :math:`\lambda=i\omega`, where the ``variable`` is
    :math:`\omega`: the characteristic polynomial is even, and the square of the printed one is
    :math:`c\det(J^2+\omega^2E)`, where c is not zero and free of it.
    """

    def _same(self, value: Formula, leading: Formula, matrix: Rows) -> Iterator[Equation]:
        own = Name(self.variable)
        both = _minus(_product(matrix, matrix), Negative(Power(own, Number(2))))
        times_n = times(Number(factorial(len(matrix))), value)
        two = Number(2)
        yield vanishes(
            total(
                (Power(times_n, two), Negative(Product((Power(leading, two), determinant(both)))))
            )
        )
        here, there = (determinant(_minus(matrix, one)) for one in (own, Negative(own)))
        yield vanishes(total((here, Negative(there))))


class TraceOrDeterminant(OfLinearPart):
    """The printed number is the trace of the linear part at a point of rest, or its determinant."""

    is_trace: bool

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        given, matrix = self._at_rest(on, space), _linear_part(space)
        trace = total(row[k] for k, row in enumerate(matrix))
        own = trace if self.is_trace else determinant(matrix)
        same = vanishes(total((self._value(on, space), Negative(own))))
        yield Follows(space, ((same, *_rest(space)),), given)
        yield from self._compared(on)


class LinearPart(OfLinearPart):
    """The printed matrix, or the last member of the equation, is the linear part of the field.

    It has the derivatives of the rates by the variables: where ``relations`` hold, if some are
    given, and else everywhere.
    """

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        formula = on.texts.formula(self.own)
        last = members(formula)[-1] if isinstance(formula, Relation) else formula
        (printed,) = as_matrices([last], space)
        same = tuple(entries([printed, _linear_part(space)]))
        if not self.relations:
            yield Follows(space, (same,))
            return
        given = self._at_rest(on, space)
        yield Follows(space, ((*same, *_rest(space)),), given)


def _linear_part(space: Elaboration) -> Rows:
    """The derivatives of the rates of what moves, velocities too, by what moves."""
    rates: dict[str, Formula] = {x: Name(rate) for x, rate in space.velocities.items()}
    for row in space.field:
        for name, below, force in row_components(row, space):
            rates[name] = space.plain(force if below == ONE else Quotient(force, below))
    names = _moving(space)
    if missing := [name for name in names if name not in rates]:
        raise Meaningless(f"the rate of {missing[0]} is not printed by itself")
    return tuple(tuple(slope(space, rates[x], y) for y in names) for x in names)


def _moving(space: Elaboration) -> tuple[str, ...]:
    """What moves: the variables, and the velocities of which the rates are printed."""
    return tuple(dict.fromkeys((*space.scene.variables, *space.velocities.values())))


def _rest(space: Elaboration) -> tuple[Equation, ...]:
    """The equations that nothing moves."""
    return tuple(vanishes(rate(Name(name))) for name in space.variables)


def _minus(matrix: Rows, value: Formula) -> Rows:
    """A matrix without a multiple of the unit matrix."""
    return tuple(
        tuple(total((one, Negative(value))) if j == k else one for k, one in enumerate(row))
        for j, row in enumerate(matrix)
    )


def _product(left: Rows, right: Rows) -> Rows:
    """The product of two matrices."""
    return tuple(
        tuple(
            total(times(a, b) for a, b in zip(row, column, strict=True))
            for column in zip(*right, strict=True)
        )
        for row in left
    )
