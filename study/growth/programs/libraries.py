"""The k-th derivatives of functions, and the powers of a matrix, by a library of Python alone.

It is the program ``python libraries.py LIBRARY FILE``; the file has the polynomials as JSON.
"""

import json
import sys
from typing import Any


def python_flint(names: list[str]) -> Any:
    """Generators, the derivative, and what brings a polynomial to its only form."""
    from flint import Ordering, fmpz_mpoly_ctx

    context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
    return context.gens(), lambda p, i: p.derivative(i), lambda p: p


def sympy(names: list[str]) -> Any:
    """The same."""
    from sympy import ZZ, ring

    _, *generators = ring(names, ZZ)
    return generators, lambda p, i: p.diff(generators[i]), lambda p: p


def symengine(names: list[str]) -> Any:
    """The same, of expressions."""
    from symengine import expand, symbols

    generators = symbols(names)
    return generators, lambda p, i: p.diff(generators[i]), expand


def main(library: str, file: str) -> None:
    """Do the work and tell each step."""
    with open(file, encoding="utf-8") as text:
        given = json.load(text)
    names = given["variables"].split(",")
    generators, derivative, normal = globals()[library.replace("-", "_")](names)
    known = dict(zip(names, generators, strict=True))
    zero = 0 * generators[0]

    def read(name: str) -> list[Any]:
        return [normal(eval(word, known) + zero) for word in given[name].split(",")]

    rates, functions, matrix = map(read, ("rates", "functions", "matrix"))
    (d,), (factor,) = map(read, ("divisor", "factor"))
    pole, rise, order, rest, gap, most = (
        int(given[name]) for name in ("pole", "rise", "order", "rest", "gap", "most")
    )

    def along(p: Any) -> Any:
        return normal(sum((derivative(p, i) * rate for i, rate in enumerate(rates)), zero))

    def product(left: list[Any], right: list[Any]) -> list[Any]:
        """Of a matrix with two rows and a matrix or a column, each row after row."""
        width = len(right) // 2
        return [
            left[row] * right[column] + left[row + 1] * right[width + column]
            for row in (0, 2)
            for column in range(width)
        ]

    one = zero + 1
    left, powers, both, rate = functions, [one, zero, zero, one], one, along(d)
    print("step 0", flush=True)
    for k in range(1, most + 1):
        left = [normal(factor * along(p) - pole * rate * p) for p in left]
        pole += rise
        moved = [d**rest * (d * along(n) - (k - 1) * order * rate * n) for n in powers]
        powers = [normal(a + b) for a, b in zip(moved, product(powers, matrix), strict=True)]
        both = normal(both * d**gap)
        right = product(powers, functions)
        if any(normal(both * p - q) != 0 for p, q in zip(left, right, strict=True)):
            print("fails")
            break
        print("step", k, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
