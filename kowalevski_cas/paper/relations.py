"""A relation among constants, solved for one of them."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction

from kowalevski_cas.algebra.factors import irreducible_factors
from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import formula_in, formula_of
from kowalevski_cas.algebra.squares import sum_of_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import read, to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Meaningless


def real_ways(relation: str, scene: Scene) -> list[tuple[str, ...]]:
    r"""The ways in which real constants obey a polynomial relation, each by equations.

    A factor vanishes, and with a sum of squares all that is squared: :math:`a^2=b^2` holds in two
    ways, and :math:`a^2+b^2=0` in one, by two equations. What follows from what is known of the
    constants holds in one way, by none; what contradicts it holds in none. What is no polynomial
    in constants, or irreducible, or gives the square of one by a number, stays as it is printed.
    """
    printed = read(relation, vocabulary((scene,))).names()
    if not printed:
        return [(relation,)]
    try:
        space = Elaborations(Texts(vocabulary((scene,))))(scene)
        (difference,) = space.finder.differences(space.equations((relation,)))
    except (Meaningless, ValueError):
        return [(relation,)]
    if difference.is_zero:
        return [()]
    ring, words = difference.ring, space.texts.vocabulary
    polynomials = ring.polynomials
    known = difference.parts.get(0, polynomials.zero)
    names = {polynomials.generators[place] for place in polynomials.occurring_places(known)}
    if {*difference.parts} != {0} or difference.denominator or not names <= {*scene.constants}:
        return [(relation,)]
    terms = polynomials.terms(known)
    found = [
        (factor, power, sum_of_squares(factor)) for factor, power in irreducible_factors(terms)
    ]
    alone = len(found) == 1 and found[0][1:] == (1, None)
    by_number = len(names) == 1 and len(terms) == 2 and max(map(sum, terms)) == 2
    if (alone or by_number) and names.issuperset(printed):
        return [(relation,)]
    ways = ([base for _, base in squares or ((1, factor),)] for factor, _, squares in found)
    return [
        tuple(f"{to_latex(formula_of(ring.from_terms({0: one}), words))}=0" for one in way)
        for way in ways
        if all(any(map(any, one)) for one in way)  # else a number would have to vanish
    ]


def solve_for_constant(relation: str, scene: Scene) -> tuple[str, tuple[str, ...]]:
    r"""A constant, or its square, by the others, as :math:`\alpha=2-\beta` for their sum 2.

    The second part are the factors that the relation prints below a line, which do not vanish.
    A coefficient that is a number is preferred, and then a square with one; what else a constant is
    multiplied by is divided by. If there is no such constant, the string is empty.
    """
    space = Elaborations(Texts(vocabulary((scene,))))(scene)
    at, words = space.finder, space.texts.vocabulary
    found = ""
    with suppress(Meaningless):
        difference, *more = at.differences(space.equations((relation,)))
        divisors = (at.ring.divisors[index] for index in difference.denominator)
        printed = tuple(to_latex(formula_in(Element(at.ring, {0: one}, {}))) for one in divisors)
        whole = Element(at.ring, difference.parts, {})
        for name in () if more else scene.constants:
            slope = at.partial(whole, name)
            square = at.partial(slope, name) * at.ring.number(Fraction(1, 2))
            generator = at.ring.generator(name)
            if rational(slope):
                return f"{name}={to_latex(formula_of(generator - whole / slope, words))}", printed
            if rational(square) and (slope - generator * square * at.ring.number(2)).is_zero:
                found = f"{name}^2={to_latex(formula_of(generator**2 - whole / square, words))}"
            elif not slope.is_zero and square.is_zero and not found:
                rest, below = (
                    to_latex(formula_in(slope * generator - whole)),
                    to_latex(formula_in(slope)),
                )
                found = rf"{name}=\frac{{{rest}}}{{{below}}}"  # also where it cancels
        return found, printed
    return "", ()
