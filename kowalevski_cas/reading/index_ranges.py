r"""Ranges of indices that the text gives: they hold in their sentence, and from there on.

As in “the vortices have the strengths :math:`\Gamma_i`, :math:`i=1,2,3`”.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from kowalevski_cas.reading.text import Prose
from kowalevski_cas.source.displays import TypedFormula

_RANGE = re.compile(
    r"\s*(?P<letter>[a-z])\s*=\s*1\s*,\s*(?:2\s*,\s*)?(?:\\[lc]?dots\s*,\s*)?(?P<last>\d)[\s.,]*"
)
_INDEX = re.compile(r"_\s*(?:\{([^{}]*)\}|(\\?\w))")
_OWN_RANGE = re.compile(r"(?<![_{\w])[a-z]\s*=\s*\d\s*,")


def is_range(formula: TypedFormula) -> bool:
    """Whether a formula says over what an index runs, and nothing else."""
    return _RANGE.fullmatch(formula.tex) is not None


def with_ranges(formulas: Sequence[TypedFormula], prose: Prose) -> list[TypedFormula]:
    """The formulas, with the range of their index where the text gives it.

    A formula with other indices beside, or with shifted ones, is left as it is printed: over what
    they run is not said.
    """
    found = [*formulas]
    for place, formula in enumerate(formulas):
        if not (said := _RANGE.fullmatch(formula.tex)):
            continue
        letter, start = said["letter"], prose.sentence(formula.start)[0]
        for number, other in enumerate(formulas):
            if other.start >= start and number != place and _runs(other.tex, letter):
                found[number] = replace(other, tex=f"{other.tex},\\quad {formula.tex.strip(' .,')}")
    return found


def _runs(tex: str, letter: str) -> bool:
    """Whether a letter is the only index of a formula, as it stands."""
    every = {(group or token).strip() for group, token in _INDEX.findall(tex)}
    indices = {index for index in every if not index.isdigit()}
    letters = {index for index in indices if re.fullmatch("[a-z]+", index)}
    return letters == {letter} and indices == letters and _OWN_RANGE.search(tex) is None
