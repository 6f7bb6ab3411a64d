"""A relation among constants, solved for one of them."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction

from kowalevski_cas.algebra.factors import irreducible_factors
from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.squares import sum_of_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Relation, read, to_latex
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import comparisons, is_inequality
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Meaningless


def real_ways(relation: str, scene: Scene) -> list[tuple[str, ...]]:
    r"""The ways in which real constants obey a polynomial relation, each by equations.

    A factor vanishes, and with a sum of squares all that is squared: :math:`a^2=b^2` holds in two
    ways, and :math:`a^2+b^2=0` in one, by two equations. What follows from what is known of the
    constants holds in one way, by none; what contradicts it holds in none. What is no polynomial
    in constants, or irreducible, or gives the square of one by a number, stays as it is printed.
    What is divided by does not vanish. Of :math:`a^2+b^2\le0` there is one way, by two equations.
    """
    formula = read(relation, vocabulary((scene,)))
    printed = formula.names()
    if not printed:
        return [(relation,)]
    try:
        space = Elaborations(Texts(vocabulary((scene,))))(scene)
        if is_inequality(formula):
            return _ways_at_edge(relation, formula, space)
        (difference,) = space.finder.differences(space.equations((relation,)))
    except (Meaningless, ValueError):
        return [(relation,)]
    if difference.is_zero:
        return [()]
    terms = _terms_in_constants(difference, scene)
    if terms is None:
        return [(relation,)]
    ring = difference.ring
    places = ring.polynomials.occurring_places(difference.parts[0])
    names = {ring.polynomials.generators[place] for place in places}
    found = [
        (factor, power, sum_of_squares(factor)) for factor, power in irreducible_factors(terms)
    ]
    alone = len(found) == 1 and found[0][1:] == (1, None)
    by_number = len(names) == 1 and len(terms) == 2 and max(map(sum, terms)) == 2
    if (alone or by_number) and names.issuperset(printed):
        return [(relation,)]
    below = [{0: ring.divisors[index]} for index in difference.denominator]
    nonzero = [rf"{_printed(Element(ring, one, {}), space)}\ne0" for one in below]
    ways = ([base for _, base in squares or ((1, factor),)] for factor, _, squares in found)
    return [(*_zeros(way, difference, space), *nonzero) for way in ways if _can_vanish(way)]


def _ways_at_edge(relation: str, formula: Formula, space: Elaboration) -> list[tuple[str, ...]]:
    """The ways in which an inequality holds of what is a sum of squares, or the opposite of one."""
    assert isinstance(formula, Relation)
    found = [*comparisons(formula)]
    if len(found) != 1 or found[0].sign not in ("<", r"\le"):
        return [(relation,)]
    difference = space.finder.scalar(space.formula(found[0].difference))
    terms = _terms_in_constants(-difference, space.scene)
    squares = sum_of_squares(terms) if terms and not difference.denominator else None
    if squares is None:
        return [(relation,)]
    way = [base for _, base in squares]
    at_edge = found[0].sign == r"\le" and _can_vanish(way)
    return [_zeros(way, difference, space)] if at_edge else []


def _terms_in_constants(element: Element, scene: Scene) -> Terms | None:
    """The numerator of an element, if it is a polynomial in constants."""
    polynomials = element.ring.polynomials
    if {*element.parts} != {0}:
        return None
    places = polynomials.occurring_places(element.parts[0])
    if not {polynomials.generators[place] for place in places} <= {*scene.constants}:
        return None
    return polynomials.terms(element.parts[0])


def _can_vanish(way: Sequence[Terms]) -> bool:
    """Whether none of some polynomials is a number."""
    return all(any(map(any, one)) for one in way)


def _zeros(way: Sequence[Terms], element: Element, space: Elaboration) -> tuple[str, ...]:
    """The equations that polynomials vanish."""
    return tuple(f"{_printed(element.ring.from_terms({0: one}), space)}=0" for one in way)


def _printed(element: Element, space: Elaboration) -> str:
    return to_latex(formula_of(element, space.texts.vocabulary))


def solve_for_constant(relation: str, scene: Scene) -> tuple[str, tuple[str, ...]]:
    r"""A constant, or its square, by the others, as :math:`\alpha=2-\beta` for their sum 2.

    The second part are the factors that the relation prints below a line, which do not vanish.
    A coefficient that is a number is preferred, and then a square with one; what else a constant is
    multiplied by is divided by. If there is no such constant, the string is empty; one of which
    only functions are printed is none.
    """
    space = Elaborations(Texts(vocabulary((scene,))))(scene)
    at, words = space.finder, space.texts.vocabulary
    found = ""
    with suppress(Meaningless):
        difference, *more = at.differences(space.equations((relation,)))
        divisors = (at.ring.divisors[index] for index in difference.denominator)
        printed = tuple(
            to_latex(formula_of(Element(at.ring, {0: one}, {}), words)) for one in divisors
        )
        whole = Element(at.ring, difference.parts, {})
        own = [name for name in scene.constants if name not in space.transcendental]
        for name in () if more else own:
            slope = at.partial(whole, name)
            square = at.partial(slope, name) * at.ring.number(Fraction(1, 2))
            generator = at.ring.generator(name)
            if rational(slope):
                return f"{name}={to_latex(formula_of(generator - whole / slope, words))}", printed
            if rational(square) and (slope - generator * square * at.ring.number(2)).is_zero:
                found = f"{name}^2={to_latex(formula_of(generator**2 - whole / square, words))}"
            elif not slope.is_zero and square.is_zero and not found:
                rest, below = (
                    to_latex(formula_of(slope * generator - whole, words)),
                    to_latex(formula_of(slope, words)),
                )
                found = rf"{name}=\frac{{{rest}}}{{{below}}}"  # also where it cancels
        return found, printed
    return "", ()
