r"""Find the Kowalevski exponents: the balances x = c t^-w of the leading terms, and what follows.

Where the motion is not homogeneous, the weights are those under which most terms lead. In the
equations of a balance a variable stands for its c, and constants are in general position. A balance
is principal if its exponents are -1, once, and natural numbers: only there can a Laurent series
begin that has all its free coefficients. The Painlevé test asks for that, and for more.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import replace

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import terms_of, to_fraction
from kowalevski_cas.algebra.present import fraction_formula, name_formula, polynomial_formula
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Negative,
    Number,
    Power,
    Relation,
    Sum,
    Vocabulary,
    times,
    to_latex,
    total,
)
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.search.exponents import Balance, LeadingPart
from kowalevski_cas.verify.found import Finding

LETTERS = (r"\rho", r"\lambda", *(rf"\rho_{k}" for k in range(10)))
"""Names for an exponent, of which the first that the scene does not have is taken."""

BELOW = r" \\ "
"""What stands between the rows of a matrix."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the question: none."""


def search(
    on: Elaborations, scene: Scene, arguments: argparse.Namespace, pool: Pool = HERE
) -> Iterator[Finding]:
    """Of each balance that it solves the leading equations, and its exponents."""
    letter = next(one for one in LETTERS if one not in {*scene.names()})
    scene = scene.having(constants=(letter,))
    words = on.texts.vocabulary
    words = replace(words, scalars=words.scalars | {letter})
    space = Elaborations(Texts(words, on.texts.sources, on.texts.edits))(scene)
    part = LeadingPart(space.finder, letter)
    told = _Told(part, scene, words)
    for balance in part.balances(pool):
        yield Finding(Identity, scene, told.balance(balance), told.equations(balance))
        yield Finding(Identity, scene, told.exponents(balance), told.characteristic(balance))


class _Told:
    """How what is found is said and printed."""

    def __init__(self, part: LeadingPart, scene: Scene, words: Vocabulary) -> None:
        self.part, self.scene = part, scene
        self.names = [name_formula(name, words) for name in part.names]

    def balance(self, balance: Balance) -> str:
        """The weights and the equations for c."""
        shown = zip(self.names, self.part.weights, strict=False)
        weights = ", ".join(f"${to_latex(name)}$ counts {weight}" for name, weight in shown)
        lower = " of the leading terms" if any(self.part.lower) else ""
        return f"a balance{lower}, where {weights}: {self._where(balance)}"

    def _where(self, balance: Balance) -> str:
        """The equations for c."""
        sides: list[tuple[Formula, Formula]] = []
        for place, one in balance.equations.solved:
            variable = self.part.variables[place - 1]
            if one.derivative(place).is_one():
                sides.append((self._formula(variable), self._formula(variable - one)))
            else:
                sides.append((self._formula(one), Number(0)))
        sides += [(self._formula(one), Number(0)) for one in balance.equations.rest]
        return ", ".join(f"${to_latex(Relation(both, ('=',)))}$" for both in sides)

    def equations(self, balance: Balance) -> str:
        """That the field without its lower terms, and w c, vanish where these equations hold."""
        given = [*(one for _, one in balance.equations.solved), *balance.equations.rest]
        members: list[Formula] = []
        for k, (unit, cofactors, _) in enumerate(balance.divisions):
            weight = times(fraction_formula(self.part.weights[k]), self.names[k])
            rate = Sum((Derivative(self.names[k], self.scene.time), weight))
            side = times(self._formula(self.part.multiple), rate)
            lower = self.part.lower[k]
            side = Sum((side, Negative(self._formula(lower)))) if lower else side
            terms = [Negative(one) for one in self._multiples(cofactors, given)]
            members.append(Sum((times(self._formula(unit), side), *terms)))
        return to_latex(Relation((*members, Number(0)), ("=",) * len(members)))

    def exponents(self, balance: Balance) -> str:
        """The roots of the determinant, and whether the balance is principal."""
        numbers = [str(one) for one in balance.exponents]
        numbers += [f"the roots of ${to_latex(self._formula(one))}$" for one in balance.factors]
        if len(self.scene.constants) > 1:
            numbers[-1] += " for general constants"
        said = "principal" if balance.is_principal() else "not principal"
        return f"exponents {', '.join(numbers)}, {said}: {self._where(balance)}"

    def characteristic(self, balance: Balance) -> str:
        """The determinant with what is solved for put in, and its factors."""
        rows = [" & ".join(to_latex(self._formula(e)) for e in row) for row in balance.matrix]
        matrix = rf"\begin{{pmatrix}}{BELOW.join(rows)}\end{{pmatrix}}"
        _, cofactors, rest = balance.characteristic
        content, factors = rest.factor()
        number = fraction_formula(to_fraction(content))
        powers = [
            self._formula(one) if k == 1 else Power(self._formula(one), Number(int(k)))
            for one, k in factors
        ]
        terms = [times(number, *powers), *self._multiples(cofactors, balance.equations.rest)]
        return rf"\det{matrix}={to_latex(total(terms))}"

    def _multiples(
        self, cofactors: Sequence[fmpq_mpoly], given: Sequence[fmpq_mpoly]
    ) -> list[Formula]:
        both = zip(cofactors, given, strict=True)
        return [times(self._formula(c), self._formula(g)) for c, g in both if c]

    def _formula(self, polynomial: fmpq_mpoly) -> Formula:
        terms = {e[1:]: value for e, value in terms_of(polynomial).items()}
        return polynomial_formula(terms, self.names)
