"""Spaces in FLINT, in which evidence is found and conditions are named."""

from __future__ import annotations

from kowalevski_cas.algebra import load
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Setting


def finder_of(space: Setting) -> Evaluation:
    """The evaluation of a space with FLINT; it is made once, and kept with the space."""
    kept = vars(space)
    if "finder" not in kept:
        kept["finder"] = Evaluation(space, load("flint"), others=finder_of).adjoin_roots()
    found: Evaluation = kept["finder"]
    return found
