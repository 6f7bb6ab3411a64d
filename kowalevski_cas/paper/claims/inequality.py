"""Inequalities that are claimed: each real point obeys a printed chain."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import (
    EQUALITIES,
    Edit,
    Formula,
    Number,
    Power,
    Relation,
    Root,
    to_latex,
)
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import ZERO, members, supposed, vanishes
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.roots import root_of_number
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import Comparison, comparisons, root_of
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.goals import Follows, Goal

OTHERS = {"<": (r"\le", ">"), ">": (r"\ge", "<"), r"\le": (r"\ge", "<"), r"\ge": (r"\le", ">")}
"""The signs for which a sign may be a misprint."""


def told_apart(printed: Formula) -> tuple[list[Formula], Relation | None]:
    """The formulas that are printed as equal, and what the last of them is compared with."""
    if not isinstance(printed, Relation) or printed.is_equality:
        return members(printed) if isinstance(printed, Relation) else [printed], None
    first = next(k for k, sign in enumerate(printed.signs) if sign not in EQUALITIES)
    behind = Relation(printed.members[first:], printed.signs[first:])
    return [*printed.members[: first + 1]], behind


def compared(
    on: Elaborations, scene: Scene, chain: Relation, given: tuple[Printed, ...] = ()
) -> Iterator[Goal]:
    """That a chain of comparisons holds wherever the ``given`` equations do."""
    for comparison in comparisons(chain):
        yield from _compared(on, scene, comparison, given)


def _compared(
    on: Elaborations, own: Scene, comparison: Comparison, printed: tuple[Printed, ...]
) -> Iterator[Goal]:
    square = Power(comparison.difference, Number(2))
    # that two sides differ, or are equal, is told by their difference alone: it takes no
    # absolute value
    ordered = comparison.sign in ("<", r"\le") and comparison.number is None
    space = on(with_signs(on, own, Root(square)) if ordered else own)
    given = supposed(on, space, printed)
    if comparison.number is not None:
        yield Follows(space, ((vanishes(Number(int(not comparison.number))),),), given)
        return
    difference = space.formula(comparison.difference)
    stated = {
        "=": vanishes(difference),
        r"\ne": vanishes(ZERO),  # at a point of what is given
    }.get(comparison.sign) or (difference, space.formula(Root(square)))
    yield Follows(space, ((stated,),), given)
    # the absolute value says ≤ only: for a strict sign there is no point with equal sides
    if comparison.sign in ("<", r"\ne"):
        yield Follows(space, (), (*given, vanishes(difference)))


class Inequality(Claim):
    r"""A printed chain, as :math:`I_1\le I_2<I_3`, holds wherever the ``given`` equations do.

    That f is not negative is the equation of f and its absolute value; that it is not zero, that
    f = 0 has no real solution. What is supposed besides are inequalities of the scene.
    """

    given: tuple[Printed, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        yield from compared(on, self.scene, on.texts.comparison(self.own), self.given)

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        r"""The chain with one sign that is weak for a strict one, the other way round, or strict.

        What is larger by a number or a letter is another theorem, and no misprint of this one.
        """
        statement = texts.statement(self.own)
        relation = texts.comparison(self.own)
        for k, sign in enumerate(relation.signs):
            for other in OTHERS.get(sign, ()):
                signs = (*relation.signs[:k], other, *relation.signs[k + 1 :])
                words = f"{other} instead of {sign}"
                changed = Relation(relation.members, signs)
                edit = Edit("sign", (), changed, words, statement, texts.vocabulary)
                yield Neighbour(words, self, texts, self.own, edit)


def with_signs(on: Elaborations, scene: Scene, root: Root) -> Scene:
    """The scene with one more root, and with that of each printed one, which is not negative.

    Roots of numbers are what they are.
    """
    known = on(scene).roots
    names = [name for name in scene.roots if name.startswith(r"\sqrt") and name in known]
    for name in (*names, to_latex(root)):
        printed = on.texts.expression(name)
        if root_of_number(*printed.children()) is None:
            new = (root for root in (name, root_of(printed)) if root not in scene.roots)
            scene = scene.adjoining(*new)
    return scene
