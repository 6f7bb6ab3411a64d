"""Power series modulo a prime, cut off: solutions of differential equations, term by term."""

from __future__ import annotations

ORDER = 14


class Series:
    """The first terms of a power series."""

    def __init__(self, terms):
        self.terms = [*terms][:ORDER] + [0 * terms[0]] * (ORDER - len(terms))

    def _of(self, other):
        return other if isinstance(other, Series) else Series([other])

    def __add__(self, other):
        return Series([a + b for a, b in zip(self.terms, self._of(other).terms, strict=True)])

    def __neg__(self):
        return Series([-a for a in self.terms])

    def __mul__(self, other):
        other = self._of(other).terms
        return Series(
            [
                sum((self.terms[j] * other[k - j] for j in range(k + 1)), 0 * other[0])
                for k in range(ORDER)
            ]
        )

    def __truediv__(self, other):
        below, found = self._of(other).terms, []
        for k in range(ORDER):
            rest = self.terms[k] - sum((found[j] * below[k - j] for j in range(k)), 0 * below[0])
            found.append(rest / below[0])
        return Series(found)

    def __pow__(self, exponent):
        whole = Series([self.terms[0] ** 0])
        for _ in range(exponent):
            whole = whole * self
        return whole

    __radd__, __rmul__ = __add__, __mul__

    def __rtruediv__(self, other):
        return self._of(other) / self

    def __sub__(self, other):
        return self + -self._of(other)

    def __ne__(self, other):
        return any(a != b for a, b in zip(self.terms, self._of(other).terms, strict=True))

    def __eq__(self, other):
        return not self != other

    __hash__ = None

    def integral(self, start):
        """The series that begins so, and has this one for its derivative."""
        return Series([start, *(a / (k + 1) for k, a in enumerate(self.terms[:-1]))])


def solution(rates, initial, value, fixed):
    """The series of names with these initial values; ``value`` evaluates the tree of a rate."""
    found = {name: Series([start]) for name, start in initial.items()}
    for _ in range(ORDER):
        here = {**fixed, **found}
        ahead = {name: value(rates[name], here) for name in initial}
        found = {
            name: (rate if isinstance(rate, Series) else Series([rate])).integral(initial[name])
            for name, rate in ahead.items()
        }
    return found
