"""Relations among constants, one by one."""

from __future__ import annotations

from itertools import pairwise

from kowalevski_cas.notation import Name, Relation, defined_names, read, to_latex
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.paper.vocabulary import vocabulary


def simple_relations(tex: str, scene: Scene) -> list[str]:
    r"""The equations of a list or a chain, as :math:`A=B` and :math:`B=4C` for :math:`A=B=4C`.

    What is no such chain stays as it is printed. Raises ``ValueError`` for nothing.
    """
    found: list[str] = []
    for place in Display("where", tex, ""):
        formula = read(place.tex, vocabulary((scene,)), OpenParser)
        if isinstance(formula, Relation) and len(formula.members) > 2 and {*formula.signs} == {"="}:
            found += (f"{to_latex(a)}={to_latex(b)}" for a, b in pairwise(formula.members))
        else:
            found.append(place.tex)
    if not found:
        raise ValueError(f"“{tex}” is no relation of constants")
    return found


def speaks_of_constants(tex: str, scene: Scene) -> bool:
    """Whether a constant of the scene stands in a relation."""
    names = read(tex, vocabulary((scene,)), OpenParser).names()
    return not names.isdisjoint(scene.constants)


def with_new_names(tex: str, scene: Scene) -> Scene:
    """A scene with the names that a relation has beside its constants, as further ones."""
    if not speaks_of_constants(tex, scene):
        return scene
    formula = read(tex, vocabulary((scene,)), OpenParser)
    known = {*scene.names(), *scene.vectors, *scene.definitions, scene.time}
    names = (node.name for node in formula.nodes() if isinstance(node, Name))
    return scene.having(constants=tuple(dict.fromkeys(n for n in names if n not in known)))


def gives_constant(tex: str, scene: Scene) -> bool:
    """Whether a relation has a constant, or its square, alone on one side only."""
    members = read(tex, vocabulary((scene,)), OpenParser).children()
    return any(
        name in scene.constants and sum(name in member.names() for member in members) == 1
        for heads in defined_names(tex)
        for name in (*heads.names, *heads.squares)
    )
