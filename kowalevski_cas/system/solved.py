"""Relations among constants, solved for one of them."""

from __future__ import annotations

from contextlib import suppress

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.system.equations import with_roots


def solve_for_constant(relation: str, scene: Scene) -> str:
    r"""A constant by the others, as :math:`\alpha=2-\beta` for :math:`\alpha+\beta=2`.

    Its coefficient is a number; if there is none, or no equation, the string is empty.
    """
    space = Elaborations(Texts(vocabulary((scene,))))(with_roots(scene, Display("", relation, "")))
    at = space.finder
    with suppress(Meaningless):
        difference, *more = at.differences(space.equations((relation,)))
        for name in () if more else scene.constants:
            if rational(slope := at.partial(difference, name)):
                value = at.ring.generator(name) - difference / slope
                return f"{name}={to_latex(formula_of(value, space.texts.vocabulary))}"
    return ""
