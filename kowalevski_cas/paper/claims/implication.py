"""Implications: an equation holds wherever given equations hold."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Name, Negative, Relation, Root, to_latex
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.forms import (
    are_matrices,
    equation,
    equations,
    expression,
    supposed,
    vanishes,
)
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows, Goal
from kowalevski_cas.problem.space import Equation, Meaningless

Equations = tuple[Equation, ...]


class Implication(Claim):
    """The printed equation (a chain, or an expression, equal to zero) follows from the given ones.

    With a ``root``, it follows for one of the two values of this root, and for
    the same one as the equations in ``together``.
    """

    given: tuple[Printed, ...]
    root: str | None = None
    together: tuple[Printed, ...] = ()
    main: tuple[tuple[str, ...], ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        formula = on.texts.formula(self.own)
        if not isinstance(formula, Relation):
            conclusion: Equations = (vanishes(expression(on, space, self.own)),)
        elif len(formula.members) > 2 or are_matrices(formula, space):
            conclusion = equations(on, space, (self.own,))
        else:
            conclusion = (equation(on, space, self.own),)
        stated = (*equations(on, space, self.together), *conclusion)
        given = supposed(on, space, self.given)
        conclusions = [stated]
        if self.root is not None:
            root = space.formula(self.root)
            other = tuple((_flip(a, root), _flip(b, root)) for a, b in stated)
            _check_flipped(root, space, given, stated, other)
            conclusions.append(other)
        yield Follows(space, tuple(conclusions), given, self.main)


def _check_flipped(
    root: Formula, space: Elaboration, given: Equations, stated: Equations, other: Equations
) -> None:
    """Refuse a root that stands in what is given, or that a name or the motion brings along."""
    at = space.finder
    name = root.name if isinstance(root, Name) else to_latex(root)
    if isinstance(root, Root):
        name = at.root_name(root.argument)
    if name not in at.ring.roots:
        raise Meaningless(f"{name} is no root: name one that the scene declares")
    place = at.ring.roots.index(name)
    depending = own = 1 << place
    # a radicand has only roots before its own: one pass finds all that rest on this one
    for bit, radicand in enumerate(at.ring.radicands):
        if any(mask & depending for mask in radicand.parts):
            depending |= 1 << bit
    if any(mask & depending for difference in at.differences(given) for mask in difference.parts):
        raise Meaningless("the root stands in what is given: its values are told apart there")
    for one, turned in zip(at.differences(stated), at.differences(other), strict=True):
        nested = any(mask & depending & ~own for mask in one.parts)
        if nested or not (one.conjugate_root(place) - turned).is_zero:
            raise Meaningless(
                "the root stands in what a name means, in another root or in the motion: "
                "print the equation with the root itself"
            )


def _flip(formula: Formula, root: Formula) -> Formula:
    """The formula with the other value of a root."""
    if formula == root:
        return Negative(root)
    return formula.map_children(lambda child: _flip(child, root))
