r"""Find the Kowalevski exponents: the balances x = c t^-w of the leading terms.

Where the motion is not homogeneous, the weights are those under which most terms lead. In the
equations of a balance a variable stands for its c, and constants are in general position. A balance
is principal if its exponents are -1, once, and natural numbers. The Painlevé test looks whether
Laurent series with all their free constants begin there, and for which real constants of the motion
they do. It is computed, and no claim states it; -v shows the identities that are claimed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import terms_of, to_fraction
from kowalevski_cas.algebra.present import fraction_formula, name_formula, polynomial_formula
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Relation,
    Sum,
    Vocabulary,
    equal,
    power,
    times,
    to_latex,
    total,
)
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.questions import with_constants
from kowalevski_cas.search.branches import Branch
from kowalevski_cas.search.exponents import Balance, LeadingPart
from kowalevski_cas.search.painleve import laurent
from kowalevski_cas.verify.finding import Finding

LETTERS = (r"\rho", r"\lambda", *(rf"\rho_{k}" for k in range(10)))
"""Names for an exponent, of which the first that the scene does not have is taken."""

FREE = ("C", "K", "c", "k")
"""Letters for free constants: the first with which no name of the scene begins is taken."""

BELOW = r" \\ "
"""What stands between the rows of a matrix."""


def search(on: Elaborations, scene: Scene, pool: Pool = HERE) -> Iterator[Finding]:
    """Of each balance that it solves the leading equations, and its exponents."""
    part, space = leading_part(on, scene)
    scene, told = space.scene, _Told(part, space.scene, space.texts.vocabulary)
    said, tex = told.weights(), told.homogeneous()
    yield Finding(Identity, scene, said, tex, steps=True)
    for balance in part.balances(pool):
        said, tex = told.balance(balance), told.steps(balance)
        computed = (told.degrees(balance), told.painleve(balance))
        yield Finding(Identity, scene, said, tex, steps=True, computed=computed)


def leading_part(on: Elaborations, scene: Scene) -> tuple[LeadingPart, Elaboration]:
    """What leads in the motion, and what the scene means with a letter for an exponent."""
    letter = next(letter for letter in LETTERS if letter not in {*scene.names()})
    space = with_constants(on, scene, letter)
    return LeadingPart(space.finder, letter), space


class _Told:
    """How what is found is said and printed."""

    def __init__(self, part: LeadingPart, scene: Scene, words: Vocabulary) -> None:
        self.part, self.scene = part, scene
        self.names = [name_formula(name, words) for name in part.names]
        known = scene.names()
        letter = next(
            letter for letter in FREE if not any(name.startswith(letter) for name in known)
        )
        self.names += [Name(f"{letter}_{k}") for k in range(1, part.size + 1)]
        self.general = " for general constants" if len(scene.constants) > 1 else ""

    def weights(self) -> str:
        """The weights, and of what."""
        shown = zip(self.names, self.part.weights, strict=False)
        counted = ", ".join(f"${to_latex(name)}$ has weight {weight}" for name, weight in shown)
        of = "what leads in the motion" if any(self.part.lower) else "the motion"
        return f"{of} is homogeneous where {counted}"

    def homogeneous(self) -> str:
        """The equations of Euler for the components of the field without its lower terms."""
        members: list[Formula] = []
        for k, weight in enumerate(self.part.weights):
            side = self._leading_terms(k)
            terms = [
                times(fraction_formula(own), name, Partial(side, letters))
                for own, name, letters in zip(
                    self.part.weights, self.names, self.part.names, strict=False
                )
            ]
            more = times(fraction_formula(weight + 1), side)
            members.append(Sum((*terms, Negative(more))))
        return to_latex(equal(*members, Number(0)))

    def _leading_terms(self, place: int) -> Formula:
        """A component of the field without its lower terms, times what makes it a polynomial."""
        rate = Derivative(self.names[place], self.scene.time)
        side, lower = times(self._formula(self.part.multiple), rate), self.part.lower[place]
        return Sum((side, Negative(self._formula(lower)))) if lower else side

    def _where(self, found: Branch) -> str:
        """The equations of a case."""
        sides: list[tuple[Formula, Formula]] = []
        for place, polynomial in found.solved:
            variable = polynomial.context().gens()[place]
            if polynomial.derivative(place).is_one():
                sides.append((self._formula(variable), self._formula(variable - polynomial)))
            else:
                sides.append((self._formula(polynomial), Number(0)))
        sides += [(self._formula(polynomial), Number(0)) for polynomial in found.rest]
        return ", ".join(f"${to_latex(Relation(both, ('=',)))}$" for both in sides)

    def balance(self, balance: Balance) -> str:
        """The equations for c, the roots of the determinant, and whether it is principal."""
        numbers = [f"${to_latex(fraction_formula(exponent))}$" for exponent in balance.exponents]
        numbers += [
            f"the roots of ${to_latex(self._formula(factor))}$" for factor in balance.factors
        ]
        numbers[-1] += self.general
        said = "principal" if balance.is_principal() else "not principal"
        where = self._where(balance.equations)
        return f"balance {where}: exponents {', '.join(numbers)}, {said}"

    def steps(self, balance: Balance) -> str:
        """That it is a balance, and what the determinant of the exponents is."""
        rows = [" & ".join(to_latex(self._formula(e)) for e in row) for row in balance.matrix]
        matrix = rf"\begin{{pmatrix}}{BELOW.join(rows)}\end{{pmatrix}}"
        _, cofactors, rest = balance.characteristic
        terms = [self._factorisation(rest), *self._multiples(cofactors, balance.equations.rest)]
        sides = [*map(to_latex, self._equations(balance))]
        return "=".join([*sides, rf"\det{matrix}{to_latex(Negative(total(terms)))}", "0"])

    def _equations(self, balance: Balance) -> Iterator[Formula]:
        """What vanishes if the field without its lower terms, and w c, do so at the balance."""
        for k, (unit, cofactors, _) in enumerate(balance.divisions):
            weight = times(fraction_formula(self.part.weights[k]), self.names[k])
            side = Sum((self._leading_terms(k), times(self._formula(self.part.multiple), weight)))
            terms = self._multiples(cofactors, balance.equations.equations)
            yield Sum((times(self._formula(unit), side), *map(Negative, terms)))

    def degrees(self, balance: Balance) -> str:
        """Which weights of first integrals the exponents leave, by a theorem of Yoshida."""
        general = self.general if balance.factors else ""
        found = [*dict.fromkeys(str(exponent) for exponent in balance.exponents if exponent > 0)]
        if not found:
            return f"all integrals have leading terms that are critical here{general}"
        shown = " or ".join(filter(None, (", ".join(found[:-1]), found[-1])))
        return f"an integral whose leading terms are not critical here has weight {shown}{general}"

    def painleve(self, balance: Balance) -> str:
        """The Painlevé test at the balance."""
        free = self.part.size - 1
        none = f"no Laurent series with {free} free constants begins here"
        whole = all(weight.denominator == 1 for weight in (*self.part.weights, *balance.exponents))
        if balance.factors or not whole:
            return f"{none}: not all weights and exponents are whole"
        if not balance.is_principal():
            return none
        try:
            found = laurent(self.part, balance)
        except Meaningless as error:
            return f"the Painlevé test of this balance is not decided: {error}"
        if found.logarithm is not None:
            return f"the Painlevé test fails: constants are missing at {found.logarithm}"
        if not found.conditions:
            return f"the Painlevé test is passed: Laurent series with {free} free constants"
        asked = "; ".join(
            f"${to_latex(self._factorisation(polynomial))}=0$ at {exponent}"
            for exponent, polynomial in found.conditions
        )
        cases = ", or ".join(map(self._where, found.cases)) or "never"
        return f"the Painlevé test is passed where {cases}; it asks for {asked}"

    def _factorisation(self, polynomial: fmpq_mpoly) -> Formula:
        content, factors = polynomial.factor()
        powers = [power(self._formula(polynomial), int(k)) for polynomial, k in factors]
        return times(fraction_formula(to_fraction(content)), *powers)

    def _multiples(
        self, cofactors: Sequence[fmpq_mpoly], given: Sequence[fmpq_mpoly]
    ) -> list[Formula]:
        both = zip(cofactors, given, strict=True)
        return [times(self._formula(c), self._formula(g)) for c, g in both if c]

    def _formula(self, polynomial: fmpq_mpoly) -> Formula:
        terms = {e[1:]: value for e, value in terms_of(polynomial).items()}
        return polynomial_formula(terms, self.names[: len(polynomial.context().gens()) - 1])
