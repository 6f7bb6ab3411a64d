r"""How large a program is when it is written out: degree and height, from above, never expanded.

A program is a polynomial N in generators and roots over a product of factors. The
rules below follow N and the factors through every step, so that both bounds come
from the formulas themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import log2

from kowalevski_cas.algebra.programs import Op, Program, field_of, steps


@dataclass(frozen=True)
class Size:
    """Bounds for a fraction: the numerator's degree, log2 of the sum of its coefficients' sizes.

    ``below`` are the factors of the denominator, each with its exponent.
    """

    degree: int
    bits: float
    below: Mapping[object, int]


class Sizes:
    """The sizes of programs; those of the factors by which they divide are kept."""

    def __init__(self) -> None:
        self._sizes: dict[Program, Size] = {}
        self._factors: dict[object, tuple[int, float]] = {}

    def __call__(self, program: Program) -> Size:
        """The size of a program."""
        for step in steps([program]) if program not in self._sizes else ():
            if step not in self._sizes:
                self._sizes[step] = self._of(step)
        return self._sizes[program]

    def _of(self, step: Program) -> Size:
        sizes = [self._sizes[arg] for arg in step.args]
        match step.op:
            case Op.NUMBER:
                value = step.number
                assert value is not None
                if value.denominator == 1:
                    return Size(0, log2(max(1, abs(value.numerator))), {})
                self._factors[value.denominator] = 0, log2(value.denominator)
                return Size(0, log2(max(1, abs(value.numerator))), {value.denominator: 1})
            case Op.GENERATOR | Op.ROOT:
                return Size(1, 0.0, {})
            case Op.SUM:
                return self._sum(sizes)
            case Op.PRODUCT:
                a, b = sizes
                below = {k: a.below.get(k, 0) + b.below.get(k, 0) for k in (*a.below, *b.below)}
                return Size(a.degree + b.degree, a.bits + b.bits, below)
            case Op.POWER:
                (base,), n = sizes, int(str(step.data))
                return Size(
                    n * base.degree, n * base.bits, {k: n * e for k, e in base.below.items()}
                )
            case Op.INVERSE:
                (below_it,) = sizes
                self._factors[step] = below_it.degree, below_it.bits
                degree, bits = self._product(below_it.below)
                return Size(degree, bits, {step: 1})
            case Op.ALONG:
                return self._along(step)

    def _product(self, factors: Mapping[object, int]) -> tuple[int, float]:
        known = [(self._factors[key], exponent) for key, exponent in factors.items()]
        return sum(d * e for (d, _), e in known), sum(b * e for (_, b), e in known)

    def _over(self, size: Size, common: Mapping[object, int]) -> tuple[int, float]:
        """Degree and bits of the numerator over a larger denominator."""
        degree, bits = self._product({k: e - size.below.get(k, 0) for k, e in common.items()})
        return size.degree + degree, size.bits + bits

    def _sum(self, sizes: Iterable[Size]) -> Size:
        terms = list(sizes)
        common: dict[object, int] = {}
        for size in terms:
            for key, exponent in size.below.items():
                common[key] = max(exponent, common.get(key, 0))
        over = [self._over(size, common) for size in terms]
        degrees, bits = zip(*over, strict=True)
        return Size(max(degrees), max(bits) + log2(len(over)), common)

    def _along(self, step: Program) -> Size:
        r"""N/D becomes (N'D - ND')/D², where N' has the radicands and the field's factors below.

        With components of the field of degree d over a common denominator F, and the
        radicands r of the roots in N, N' F ∏r has degree deg N - 1 + d + deg ∏r.
        """
        ((inner,), field) = step.args, field_of(step)
        size = self._sizes[inner]
        rate = self._sum([self._sizes[value] for value in field.values()])
        radicands = {s.args[0]: self._sizes[s.args[0]] for s in steps([inner]) if s.op is Op.ROOT}
        for radicand, own in radicands.items():
            self._factors[radicand] = own.degree, own.bits + 1
        roots: dict[object, int] = dict.fromkeys(radicands, 1)
        root_degree, root_bits = self._product(roots)
        denominator_degree, denominator_bits = self._product(dict.fromkeys(size.below, 1))
        grown = size.degree + denominator_degree + root_degree + max(0, rate.degree - 1)
        terms = (len(field) + len(radicands)) * (1 + sum(size.below.values()))
        largest = max([size.degree, root_degree, denominator_degree, 2])
        bits = size.bits + denominator_bits + root_bits + rate.bits + log2(terms) + log2(largest)
        below = {key: exponent + 1 for key, exponent in size.below.items()}
        for key in (*roots, *rate.below):
            below[key] = below.get(key, 0) + max(roots.get(key, 0), rate.below.get(key, 0))
        return Size(max(0, grown), bits, below)
