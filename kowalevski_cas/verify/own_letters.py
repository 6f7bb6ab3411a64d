"""Letters of a claim that nothing has on which it stands: no edit of another formula cancels them.

What has to vanish is a sum over their powers, of which each term would have to vanish by itself. So
another formula is to blame only if an edit brings them there, if it defines what stands beside them
in a term, or if they are but a factor of all, as where a mass stands before each term.
"""

from __future__ import annotations

from kowalevski_cas.notation import Name
from kowalevski_cas.notation.scales import MODULUS, Scales
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.mentions import mentions
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.verify.statement import Statement


def own_letters(statement: Statement) -> frozenset[str]:
    """The constants in an identity that stand in nothing behind it, and are no factor of it.

    There are none if a claim is more than identities.
    """
    claim, behind = statement.claim, set[str]()
    for goal in statement.claimed:
        if type(goal) is not Follows or goal.given or not isinstance(goal.space, Elaboration):
            return frozenset()
        behind |= _behind(goal, goal.space)
    said = [Scales(formula) for formula in claim.formulas(statement.on.texts)]
    names = {name for one in said for name in one.names}
    own = frozenset(names.intersection(claim.scene.constants)) - behind
    degrees = (sum(scale.get(name, 0) for name in own) for one in said for scale in one.alike)
    under = any(own & scale.keys() for one in said for scale in one.pure)
    return own if under or any(degree % MODULUS for degree in degrees) else frozenset()


def defined_beside(statement: Statement, letters: frozenset[str]) -> frozenset[Printed]:
    """The definitions of what stands in a claim in a term with one of these letters.

    With another one of them such a term may vanish by itself.
    """
    texts, defined = statement.on.texts, statement.claim.scene.definitions
    formulas = statement.claim.formulas(texts) if letters else ()
    members = (side for one in formulas for side in getattr(one, "members", (one,)))
    terms = (term for side in members for term in getattr(side, "terms", (side,)))
    waiting = {name for term in terms if letters & term.names() for name in term.names()}
    found = set[Printed]()
    while waiting:
        place = defined.get(waiting.pop())
        if place is not None and place not in found:
            found.add(place)
            waiting |= texts.formula(place).names()
    return frozenset(found)


def _behind(goal: Follows, space: Elaboration) -> set[str]:
    """The names that stand in the definitions and rates behind a goal, also under functions."""
    reach = Reach(space)
    if space.variables:
        reach.move()
    functions = space.transcendental
    under = {n: functions.names_under(g) for g in functions.groups for n in g.names.values()}
    for conclusion in goal.conclusions:
        for node in (
            node for equation in conclusion for side in equation for node in mentions(side)
        ):
            still = isinstance(node, Name) and (node.name in space.constants or node.name in under)
            if not still:
                reach.formula(node)
    return reach.names.union(*(under.get(name, ()) for name in reach.names))
