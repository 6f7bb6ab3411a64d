"""The names that scenes know, as the readers of formulas take them."""

from __future__ import annotations

from functools import lru_cache

from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.vocabulary import Vocabulary
from kowalevski_cas.paper.names import BRACKET, head, is_bold, is_capital
from kowalevski_cas.paper.scene import Scene


@lru_cache(maxsize=64)  # claims of one system are read in the same scene, one after the other
def vocabulary(scenes: tuple[Scene, ...]) -> Vocabulary:
    """The names of all these scenes; bold capitals that are no declared vectors are matrices."""
    times = frozenset({"t", *(scene.time for scene in scenes)})
    bold = {n for s in scenes for n in (*s.vectors, *s.definitions) if is_bold(n)}
    vectors = {name for scene in scenes for name in scene.vectors}
    capitals = {name for name in bold if is_capital(name)}
    printed = {head(n)[0] for s in scenes for n in s.definitions if s.is_matrix(n)}
    matrices = frozenset((capitals | printed) - vectors)
    still = {n for s in scenes for n in (*s.constants, *s.undefined)}
    moving = {n for s in scenes for n in (*s.variables, *s.definitions)} - still
    parts = ((name, parts) for scene in scenes for name, parts in scene.vectors.items())
    return Vocabulary(
        scalars=times.union(n for scene in scenes for n in scene.names()) - vectors,
        vectors=frozenset(bold | vectors) - matrices,
        matrices=matrices,
        functions=frozenset(
            head(n)[0] for s in scenes for n in s.definitions if head(n)[1] and n[:2] != BRACKET
        ).union(FUNCTIONS),
        times=times,
        moving=frozenset(moving.union(n for n, names in parts if not moving.isdisjoint(names))),
    )
