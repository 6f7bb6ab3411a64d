"""Units as a change of variables: each variable over its unit, with a star."""

from __future__ import annotations

from typing import Any

from kowalevski_cas.claims import Scaling
from kowalevski_cas.notation import Quotient, Root
from kowalevski_cas.proof.parts import Parts
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.statements.kinds import state
from kowalevski_cas.proof.trees import CertificateError, Tree, encode


class StarredSpace(SpaceWriter):
    """The space of a simple scene, its names with a star, as a change from another space.

    ``old`` are the definitions of the old variables through the new ones.
    """

    def __init__(
        self, simple: SpaceWriter, source: SpaceWriter, old: dict[str, Tree], change: dict[str, Any]
    ) -> None:
        super().__init__(simple.stage, simple.index, source)
        self.simple, self.old, self.change = simple, old, change

    def close(self) -> None:
        """Nothing is added any more."""

    def data(self) -> dict[str, Any]:
        """The space, as it stands in the certificate."""
        if self.source is None:
            raise CertificateError("the units have no source")
        source, simple = self.source.data(), self.simple
        steps = [
            *(step for step in source["steps"] if step[0] == "root"),
            *([kind, _star(name), _starred(tree)] for kind, name, tree in simple.steps),
            *(["let", name, tree] for name, tree in self.old.items()),
        ]
        data = {
            "variables": [_star(name) for name in simple.scene.variables],
            "constants": source["constants"],
            "steps": steps,
            "change": self.change,
        }
        return data | ({"nonzero": self.nonzero} if self.nonzero else {})


@state.register
def state_scaling(claim: Scaling, parts: Parts) -> None:
    """The equations of the simple scene hold in the units that the claim names."""
    if claim.printed is None:
        raise CertificateError("the unit of time is not printed")
    source = parts.space(claim.scene)
    root = source.stage.texts.formula(claim.printed)
    if not isinstance(root, Root) or not isinstance(root.argument, Quotient):
        raise CertificateError("the unit of time is not the root of a quotient")
    time = source.tree(root)
    square = [encode(root.argument.numerator), encode(root.argument.denominator)]
    source.moving = True
    for name in claim.scene.variables:
        source.need(name)
    old: dict[str, Tree] = {}
    formulas = []
    for names, power, rest in claim.measures:
        if abs(power) > 1:
            raise CertificateError("the unit of time enters to a higher power")
        unit = source.tex(rest)
        for name in names:
            star = _star(name)
            if power == -1:
                old[name] = ["/", ["*", star, time, unit, square[1]], square[0]]
                formulas.append([star, ["/", ["*", name, time], unit]])
            elif power == 0:
                old[name] = ["*", star, unit]
                formulas.append([star, ["/", name, unit]])
            else:
                old[name] = ["*", star, unit, time]
                inverse = ["/", ["*", name, time, square[1]], square[0], unit]
                formulas.append([star, inverse])
    simple = SpaceWriter(parts.bench.finder.stage(claim.simple), len(parts.spaces), None)
    equations = list(simple.equations_of_motion())
    change = {"old": source.index, "formulas": formulas, "time": time}
    parts.spaces.append(StarredSpace(simple, source, old, change))
    shown = [
        [_starred(["*", factor, ["D", ["vector", *names]]]), _starred(right)]
        for names, factor, right in equations
    ]
    parts.parts.append({"space": simple.index, "shows": "follows", "equations": shown})


def _star(name: str) -> str:
    return f"{name}^*"


def _starred(tree: Tree) -> Tree:
    """The tree with a star at every name."""
    if isinstance(tree, str):
        return _star(tree)
    return [tree[0], *map(_starred, tree[1:])] if isinstance(tree, list) else tree
