"""The parts of a certificate: what follows, ranks at points, and points of failure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, islice
from typing import Any

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.paper.scene import Change, Scene
from kowalevski_cas.stage import Stage

Equation = list[Tree]
TRIES = 12
"""At how many points a rank is taken at most."""


class Parts:
    """The spaces and parts of one certificate.

    ``bench`` gives meaning to what is written; ``mended`` is the one for the
    corrected statement.
    """

    def __init__(self, bench: Bench) -> None:
        self.bench = self.mended = bench
        self.spaces: list[SpaceWriter] = []
        self.parts: list[dict[str, Any]] = []
        self._known: dict[object, SpaceWriter] = {}
        self.notes: list[str] = []

    def space(self, scene: Scene) -> SpaceWriter:
        """The space of a scene; one for all texts that agree on it."""
        bench = self.bench.finder
        stage = bench.stage(scene)
        key = (scene, bench.texts.changes(frozenset(scene.places())))
        if key not in self._known:
            source = self.space(scene.field.source) if isinstance(scene.field, Change) else None
            self._known[key] = SpaceWriter(stage, len(self.spaces), source)
            self.spaces.append(self._known[key])
        self._known[key].stage = stage
        return self._known[key]

    # -- equations ---------------------------------------------------------------

    def equal(self, space: SpaceWriter, *equations: Equation) -> None:
        """Equations that always hold."""
        for left, right in equations:
            space.take(left)
            space.take(right)
        self.parts.append({"space": space.index, "shows": "follows", "equations": list(equations)})

    def follows(
        self,
        space: SpaceWriter,
        equations: Sequence[Equation],
        given: Sequence[Equation],
        rows: Sequence[Sequence[Element]] = (),
        root: str | None = None,
        proof: Mapping[str, Any] | None = None,
        at: AtPoint | None = None,
    ) -> None:
        """Equations that hold where given ones do, by combinations that were found, or a proof."""
        for left, right in (*equations, *given):
            space.take(left)
            space.take(right)
        combined = {"cofactors": [[space.element(entry) for entry in row] for row in rows]}
        part: dict[str, Any] = {
            "space": space.index,
            "shows": "follows",
            "equations": list(equations),
            "given": list(given),
            **(combined if proof is None else proof),
        }
        if root is not None:
            part["root"] = root
        known = [space.difference(sides) for sides in given]
        part["point"] = lambda: space.point(at or self.exact_point(space, known))
        self.parts.append(part)

    def differ(
        self,
        space: SpaceWriter,
        equation: Equation,
        given: Sequence[Equation] = (),
        at: AtPoint | None = None,
    ) -> None:
        """A point where an equation fails: a given one, or one that is sought."""
        for left, right in (equation, *given):
            space.take(left)
            space.take(right)
        target, known = space.difference(equation), [space.difference(s) for s in given]
        part: dict[str, Any] = {"space": space.index, "shows": "differ", "equation": equation}
        if given:
            part["given"] = list(given)
        part["point"] = lambda: space.point(at or self.exact_point(space, known, target))
        self.parts.append(part)

    def rank(
        self,
        space: SpaceWriter,
        levels: Sequence[Tree],
        functions: Sequence[Tree],
        given: Sequence[Equation],
        dimension: int | None,
    ) -> None:
        """A point where differentials are independent."""
        space.whole = True
        for tree in (*levels, *functions, *(side for sides in given for side in sides)):
            space.take(tree)
        known = [space.difference(sides) for sides in given]
        chosen = [space.value(tree)[0] for tree in (*levels, *functions)] + [k[0] for k in known]
        part: dict[str, Any] = {
            "space": space.index,
            "shows": "rank",
            "levels": list(levels),
            "functions": list(functions),
            "given": list(given),
            "dimension": dimension,
        }
        part["point"] = lambda: space.point(self.exact_point(space, known, independent=chosen))
        self.parts.append(part)

    # -- points ------------------------------------------------------------------

    def exact_point(
        self,
        space: SpaceWriter,
        zero: Sequence[Sequence[Element]],
        apart: Sequence[Element] = (),
        independent: Sequence[Element] = (),
    ) -> AtPoint:
        """A point where some elements vanish, one of others does not, differentials are free.

        It is sought among points in general position, and then where one or two variables vanish.
        """
        from kowalevski_cas.arithmetic.derivation import gradient
        from kowalevski_cas.arithmetic.numbers import rank
        from kowalevski_cas.search.real import real_points

        stage = space.stage
        vanishing = [element for row in zero for element in row]
        avoid = [space.value(tree)[0] for tree in space.nonzero]

        def good(at: AtPoint) -> bool:
            if any(not at(element).is_zero for element in vanishing):
                return False
            if apart and all(at(element).is_zero for element in apart):
                return False
            moving = stage.scene.variables
            rows = [[at(entry) for entry in gradient(f, moving)] for f in independent]
            return rank(rows) == len(rows) and bool(space.point(at))

        names = [name for name in stage.generators if name in stage.scene.variables]
        variables = [stage.ring.generator(name) for name in names]
        norms = [_norm(element, stage) for element in vanishing]
        for further in (c for size in range(3) for c in combinations(variables, size)):
            for point in islice(real_points(stage, [*norms, *further], avoid), TRIES):
                at = AtPoint(stage, point)
                try:
                    if good(at):
                        return at
                except (ZeroDivisionError, CertificateError):
                    continue
        raise CertificateError("no exact point was found")


def _norm(element: Element, stage: Stage) -> Element:
    """The element times its conjugates by the roots that are no variables."""
    for bit, name in enumerate(element.ring.roots):
        inside = any(mask >> bit & 1 for mask in element.parts)
        if inside and name != "i" and name not in stage.scene.variables:
            element = element * element.conjugate_root(bit)
    return element


def minus(sides: Equation) -> Tree:
    """The left minus the right side of an equation."""
    left, right = sides
    return left if right == 0 else ["+", left, ["-", right]]
