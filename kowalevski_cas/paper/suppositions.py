"""What the inequalities of a scene suppose: what is not negative has a real root."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

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

    def check(self, at: Evaluation) -> None:
        """Refuse what is seen to contradict itself."""
        if (found := _contradiction(self.comparisons, at)) is not None:
            both = " and ".join(to_latex(comparison.said) for comparison in found)
            where = f"what is supposed on “{self.scene.name}”"
            raise Contradictory(f"{where} contradicts itself: {both}")


def _contradiction(
    supposed: Sequence[Comparison], at: Evaluation
) -> tuple[Comparison, Comparison] | None:
    """Two comparisons of which positive multiples add up to a number that is too small, if any do.

    Longer combinations, as of a < b, b < c and c < a, are not looked for.
    """
    known: dict[frozenset[object], list[tuple[Fraction, Comparison]]] = {}
    for comparison in supposed:
        if comparison.sign == r"\ne" or (element := at.scalar(comparison.difference)).denominator:
            continue
        terms = {(mask, e): c for mask, part in element.terms().items() for e, c in part.items()}
        units = [(mask, e) for mask, e in terms if not mask and not any(e)]
        number = sum(map(terms.pop, units), Fraction())
        if not terms:
            continue
        scale = abs(terms[max(terms)])
        part = {(one, c / scale) for one, c in terms.items()}
        for other, before in known.get(frozenset((one, -c) for one, c in part), ()):
            rest = other + number / scale
            if rest < 0 or (rest == 0 and "<" in (comparison.sign, before.sign)):
                return before, comparison
        known.setdefault(frozenset(part), []).append((number / scale, comparison))
    return None
