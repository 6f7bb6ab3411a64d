"""Relations among constants, one by one."""

from __future__ import annotations

from itertools import pairwise

from kowalevski_cas.notation import (
    Name,
    Relation,
    defined_names,
    read,
    read_display,
    split_display,
    to_latex,
)
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import is_inequality
from kowalevski_cas.paper.vocabulary import vocabulary


def simple_relations(tex: str, scene: Scene) -> list[str]:
    r"""The equations of a list or a chain, as :math:`A=B` and :math:`B=4C` for :math:`A=B=4C`.

    What is no such chain stays as it is printed, and so does one of inequalities only. An
    inequality is one of all names that are listed before it, as in :math:`k,l>0`. Raises
    ``ValueError`` for nothing.
    """
    found: list[str] = []
    for one in read_display(tex, vocabulary((scene,)), OpenParser):
        formula, alone = one.formula, len(split_display(one.source)) == 1
        if isinstance(formula, Relation) and len(formula.members) > 2 and "=" in formula.signs:
            pairs = zip(pairwise(formula.members), formula.signs, strict=True)
            found += (to_latex(Relation(two, (sign,))) for two, sign in pairs)
        else:
            found.append(one.source if alone else to_latex(formula))
    if not found:
        raise ValueError(f"“{tex}” is no relation of constants")
    return found


def speaks_of_constants(tex: str, scene: Scene) -> bool:
    """Whether a constant of the scene stands in a relation."""
    names = read(tex, vocabulary((scene,)), OpenParser).names()
    return not names.isdisjoint(scene.constants)


def with_new_names(tex: str, scene: Scene) -> Scene:
    """A scene with the names that a relation has beside its constants, as further ones.

    An inequality may be the first that is said of a name.
    """
    formula = read(tex, vocabulary((scene,)), OpenParser)
    if not is_inequality(formula) and not speaks_of_constants(tex, scene):
        return scene
    known = {*scene.names(), *scene.vectors, *scene.definitions, scene.time}
    names = (node.name for node in formula.nodes() if isinstance(node, Name))
    return scene.having(constants=tuple(dict.fromkeys(n for n in names if n not in known)))


def gives_constant(tex: str, scene: Scene) -> bool:
    """Whether a relation has a constant, or its square, alone on one side, or gives its sign."""
    formula = read(tex, vocabulary((scene,)), OpenParser)
    members = formula.children()
    return is_inequality(formula) or any(
        name in scene.constants and sum(name in member.names() for member in members) == 1
        for heads in defined_names(tex)
        for name in (*heads.names, *heads.squares)
    )
