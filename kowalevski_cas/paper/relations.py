"""A relation among constants, solved for one of them."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import formula_in, formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Meaningless


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
