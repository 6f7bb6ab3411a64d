"""Cofactors: how an expression is a combination of others, found by division."""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flat import Flat
from kowalevski_cas.algebra.flint import coefficients
from kowalevski_cas.algebra.tower import Element

Monomial = tuple[int, ...]

Combination = tuple[fmpq_mpoly, list[fmpq_mpoly]]
"""A polynomial u and cofactors c: u times the target is the sum of c[k] times generator k."""


def cofactors(
    target: Element, generators: Sequence[Element], main: Sequence[tuple[str, ...]] = ()
) -> list[Element] | None:
    """Elements :math:`c_k` with ``target`` = sum of :math:`c_k` ``generators[k]``, or ``None``.

    ``target`` is divided by the generators as polynomials in a set of main
    variables, with coefficients in the others; the leading coefficients by which
    the division multiplies stay in the denominators of the result, and are the
    conditions under which it holds. A multiple of one generator is recognised
    first; then come all variables together (this division needs no condition),
    and each of the sets in ``main``.
    """
    flat = Flat(target.ring)
    contents, numerators = zip(*(flat.without_roots(g) for g in generators), strict=True)
    dividend = flat.polynomial(target)
    sets = [tuple(range(flat.size)), *(flat.indices(names) for names in main)]
    found = _divide_in_turn(dividend, numerators, sets, flat.relations(), depth=2)
    if found is None:
        return None
    unit, quotients = found
    below = flat.inverse(unit) * flat.inverse_denominator(target)
    return [
        target.ring.zero
        if q.is_zero()
        else flat.element(q) * below * (flat.inverse_denominator(g) * content).inverse()
        for q, g, content in zip(quotients, generators, contents, strict=True)
    ]


def _divide_in_turn(
    dividend: fmpq_mpoly,
    divisors: Sequence[fmpq_mpoly],
    sets: Sequence[tuple[int, ...]],
    relations: Sequence[fmpq_mpoly],
    depth: int,
) -> Combination | None:
    """Divide in one set of main variables, and what remains in another one."""
    if dividend.is_zero():
        return dividend.context().constant(1), [dividend] * len(divisors)
    for k, divisor in enumerate(divisors):
        if divisor.is_zero():
            continue
        quotient, remainder = divmod(dividend, divisor)
        if remainder.is_zero():
            zero = dividend.context().constant(0)
            quotients = [quotient if j == k else zero for j in range(len(divisors))]
            return dividend.context().constant(1), quotients
    for main in sets:
        unit, quotients, remainder = pseudo_divide(dividend, divisors, main)
        for relation in relations:
            remainder = divmod(remainder, relation)[1]
        if remainder.is_zero():
            return unit, quotients
        if depth > 1 and remainder != dividend:
            others = [s for s in sets if s != main]
            rest = _divide_in_turn(remainder, divisors, others, relations, depth - 1)
            if rest is not None:
                more, added = rest
                pairs = zip(quotients, added, strict=True)
                return unit * more, [q * more + r for q, r in pairs]
    return None


def pseudo_divide(
    dividend: fmpq_mpoly, divisors: Sequence[fmpq_mpoly], main: tuple[int, ...]
) -> tuple[fmpq_mpoly, list[fmpq_mpoly], fmpq_mpoly]:
    """``unit * dividend = sum of quotients * divisors + remainder``, in the main variables.

    ``unit`` is a product of leading coefficients, free of the main variables. A
    divisor without main variables is passed over.
    """
    context = dividend.context()
    split = [coefficients(g, main) for g in divisors]
    leads = [max(s, default=(0,) * len(main)) for s in split]
    unit = context.constant(1)
    quotients = [context.constant(0)] * len(divisors)
    rest, remainder = coefficients(dividend, main), context.constant(0)
    while rest:
        top = max(rest)
        usable = [
            k
            for k, lead in enumerate(leads)
            if any(lead) and all(a >= b for a, b in zip(top, lead, strict=True))
        ]
        if not usable:
            remainder += rest.pop(top) * _power(context, main, top)
            continue
        k = usable[0]
        lead = split[k][leads[k]]
        shift = tuple(a - b for a, b in zip(top, leads[k], strict=True))
        quotient, left = divmod(rest[top], lead)
        if not left.is_zero():
            quotient = rest[top]
            unit *= lead
            remainder *= lead
            quotients = [q * lead for q in quotients]
            rest = {m: c * lead for m, c in rest.items()}
        quotients[k] += quotient * _power(context, main, shift)
        for monomial, coefficient in split[k].items():
            key = tuple(a + b for a, b in zip(monomial, shift, strict=True))
            value = rest.get(key, context.constant(0)) - quotient * coefficient
            if value.is_zero():
                rest.pop(key, None)
            else:
                rest[key] = value
    return unit, quotients, remainder


def _power(context: fmpq_mpoly_ctx, main: tuple[int, ...], exponents: Monomial) -> fmpq_mpoly:
    full = [0] * context.nvars()
    for k, exponent in zip(main, exponents, strict=True):
        full[k] = exponent
    return context.from_dict({tuple(full): fmpq(1)})
