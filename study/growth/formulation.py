r"""The growing work for programs of others: polynomials with integers, without a root.

What is typed for the set of a claim is made rational, its roots by squares of new variables, and
free of denominators, so that a program needs no more than sums, products and derivatives of
polynomials in one ring. With the polynomials :math:`d` and :math:`Ex` of each variable :math:`x`

.. math:: \frac{d}{dt} = \frac{E}{c\,d^j}, \quad F = \frac{P}{d^p}, \quad M = \frac{N}{c\,d^m},

and the two sides of :math:`F^{(k)}=M_kF` follow from each other, :math:`P` and :math:`N` with the
index 0 being those of :math:`F` and of :math:`M_0=1`:

.. math::

    F^{(k)} = \frac{P_k}{c^kd^{p_k}}, \quad P_{k+1} = d\,EP_k - p_k(Ed)P_k, \quad p_{k+1}=p_k+j+1,

    M_k = \frac{N_k}{c^kd^{mk}}, \quad N_{k+1} = d^{m-j-1}(d\,EN_k-mk(Ed)N_k) + N_kN.

Where nothing is divided by, :math:`j=p=0`, it is :math:`P_{k+1}=EP_k`, and :math:`p_k=0`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import sympy
from sympy import Expr, Symbol

from study.growth.work import certified_set
from study.methods.typed import Expression, TypedEvaluation


@dataclass(frozen=True)
class Formulation:
    """Polynomials and exponents that say the work.

    ``factor`` is what a derivative of P is multiplied by, d or 1; its pole is of the order
    ``pole`` at first, and higher by ``rise`` after each; ``order`` is m, and ``rest`` the exponent
    m − j − 1.
    """

    variables: Sequence[Symbol]
    rates: Sequence[Expr]
    divisor: Expr
    factor: Expr
    functions: Sequence[Expr]
    matrix: Sequence[Expr]
    pole: int
    rise: int
    order: int
    rest: int

    def words(self, power: str) -> dict[str, str]:
        """Each of these as a list in the words of a program, which writes powers like this."""
        lists: Mapping[str, Sequence[object]] = {
            name: value if isinstance(value, (list, tuple)) else [value]
            for name, value in vars(self).items()
        }
        return {
            name: ",".join(str(value).replace("**", power) for value in values)
            for name, values in lists.items()
        } | {"gap": str(self.order - self.rise)}


@cache
def formulation(claim: str) -> Formulation:
    """The growing work for the set of a claim, which is that of its certificate."""
    goal, found, there = certified_set(claim)
    at = TypedEvaluation(there.space)
    typed = [*at.differences(there.given), *(at.scalar(found.values[n]) for n in goal.expressions)]
    rates = {at.ring.symbols[name]: _value(rate) for name, rate in at.rates.items()}  # type: ignore[attr-defined]
    values = [*map(_value, typed)]
    roots = [r for value in values for r in value.atoms(sympy.Pow) if r.exp == sympy.Rational(1, 2)]
    squares = {symbol for root in roots for symbol in root.base.free_symbols}
    new = {x: Symbol(f"g{k}", positive=x in squares or None) for k, x in enumerate(rates)}
    images = {x: new[x] ** 2 if x in squares else new[x] for x in rates}

    def rational(value: Expr) -> Expr:
        return sympy.cancel(sympy.expand(value.subs(images, simultaneous=True)))

    field = [rational(r) / (2 * new[x] if x in squares else 1) for x, r in rates.items()]
    rationals = [*map(rational, values)]
    size = len(there.given)
    return _without_denominators([*new.values()], field, rationals[:size], rationals[size:])


def _value(element: object) -> Expr:
    assert isinstance(element, Expression)
    return sympy.expand(element.value)


def _without_denominators(
    variables: Sequence[Symbol],
    field: Sequence[Expr],
    functions: Sequence[Expr],
    matrix: Sequence[Expr],
) -> Formulation:
    """The same with polynomials."""
    every = [sympy.factor_list(_denominator(values)) for values in (field, functions, matrix)]
    numbers = [number for number, _ in every]
    divisor = sympy.prod(dict.fromkeys(base for _, factors in every for base, _ in factors))
    j, pole, order = (max((e for _, e in factors), default=0) for _, factors in every)
    number = sympy.lcm(numbers[0], numbers[2])
    order = max(order, j + 1)
    divided = j > 0 or pole > 0

    def cleared(values: Sequence[Expr], factor: Expr) -> list[Expr]:
        return [sympy.expand(sympy.cancel(value * factor)) for value in values]

    return Formulation(
        variables=variables,
        rates=cleared(field, number * divisor**j),
        divisor=sympy.expand(divisor),
        factor=sympy.expand(divisor) if divided else sympy.Integer(1),
        functions=cleared(functions, numbers[1] * divisor**pole),
        matrix=cleared(matrix, number * divisor**order),
        pole=int(pole),
        rise=int(j + 1) if divided else 0,
        order=int(order),
        rest=int(order - j - 1),
    )


def _denominator(values: Sequence[Expr]) -> Expr:
    return sympy.lcm_list([sympy.fraction(sympy.together(value))[1] for value in values])
