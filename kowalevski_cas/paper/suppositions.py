"""What the inequalities of a scene suppose: what is not negative has a real root."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, to_latex
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import Comparison, comparisons, root_of
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Contradictory, Meaningless


class Suppositions:
    """The comparisons that a scene supposes, but for what numbers say of each other.

    Raises :class:`Meaningless` for what is no inequality, or is one that numbers break.
    """

    def __init__(self, scene: Scene, texts: Texts) -> None:
        self.scene, self.texts = scene, texts
        self.comparisons = tuple(self._comparisons())
        self.roots = dict.fromkeys(
            root_of(one.difference) for one in self.comparisons if one.sign != r"\ne"
        )
        """The names of the roots that say what is not negative."""

    def _comparisons(self) -> Iterator[Comparison]:
        for printed in self.scene.signs:
            for comparison in comparisons(self.texts.comparison(printed)):
                if comparison.sign == "=" or comparison.number is False:
                    raise Meaningless(f"{printed.tex} is no inequality that can be supposed")
                if comparison.number is None:
                    yield comparison

    def strict(self) -> Iterator[Formula]:
        """The differences that do not vanish."""
        return (one.difference for one in self.comparisons if one.sign != r"\le")

    def check(self, at: Evaluation, plain: Callable[[Formula], Formula]) -> None:
        """Refuse what is seen to contradict itself."""
        differences = [at.scalar(plain(one.difference)) for one in self.comparisons]
        if found := _contradiction(self.comparisons, differences):
            both = " and ".join(to_latex(comparison.said) for comparison in found)
            where = f"what is supposed on “{self.scene.name}”"
            raise Contradictory(f"{where} contradicts itself: {both}")


def _contradiction(
    supposed: Sequence[Comparison], differences: Sequence[Element]
) -> list[Comparison]:
    """Comparisons of which positive multiples add up to a number that is too small, if any do."""
    from kowalevski_cas.algebra.cones import combination_in_cone  # few scenes suppose anything

    terms = [
        {(mask, e): c for mask, part in one.terms().items() for e, c in part.items()}
        for one in differences
    ]
    known = [
        (comparison, own)
        for comparison, own, element in zip(supposed, terms, differences, strict=True)
        if comparison.sign != r"\ne" and not element.denominator
    ]
    monomials = {(mask, e) for _, own in known for mask, e in own}
    others = sorted(one for one in monomials if one[0] or any(one[1]))
    units = monomials.difference(others)
    # the number 1 is positive as well
    rows = [[Fraction(k == len(others)) for k in range(len(others) + 1)]]
    for _, own in known:
        number = sum((own[unit] for unit in units & own.keys()), Fraction(0))
        rows.append([*(own.get(one, Fraction(0)) for one in others), number])
    for k, row in enumerate(rows):
        if k and known[k - 1][0].sign != "<":
            continue
        weights = combination_in_cone(rows, [-value for value in row])
        if weights is not None:
            weights[k] += 1
            return [one for (one, _), w in zip(known, weights[1:], strict=True) if w]
    return []
