"""The questions of the command ``find``, a module each.

A module has a docstring, ``add_arguments(parser)``, and ``search(on, scene, arguments)``, which
yields one :class:`~kowalevski_cas.verify.found.Finding` after the other; what was found before the
time is over is kept.
"""

from __future__ import annotations

from dataclasses import replace

from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts


def with_constants(on: Elaborations, scene: Scene, *names: str) -> Elaboration:
    """What a scene means that has more constants."""
    words = on.texts.vocabulary
    words = replace(words, scalars=words.scalars.union(names))
    texts = Texts(words, on.texts.sources, on.texts.edits)
    return Elaborations(texts)(scene.having(constants=names))
