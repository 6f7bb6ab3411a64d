"""The nearest true statement: one edit away from what is printed, or a factor away."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Neighbour
from kowalevski_cas.notation import NotationError
from kowalevski_cas.stage import StageError
from kowalevski_cas.stage.programs import ProgramStage

DECIDED = 400
"""How many candidates are decided in full, for claims that cannot be screened."""


def correction(claim: Claim, bench: Bench) -> Neighbour | None:
    """The first neighbour of a refuted claim that is true, the most plausible first.

    Candidates are screened at points modulo primes where the kind of claim
    allows it; the others are decided in full, with FLINT.
    """
    finder = bench.finder
    for neighbour in _screened(claim, finder):
        try:
            trial = finder.with_texts(neighbour.texts, refute=False)
            if neighbour.claim.decide(trial).verdict.green:
                return neighbour
        except (NotationError, StageError, ZeroDivisionError):
            continue
    return None


def _screened(claim: Claim, finder: Bench) -> Iterator[Neighbour]:
    """The neighbours that pass the screen, those on the right side of an equation first."""
    neighbours = sorted(
        claim.neighbours(finder.texts), key=lambda n: n.edit is not None and n.edit.path[:1] == (0,)
    )
    stage = None
    if claim.printed is not None:
        stage = ProgramStage(finder.stage(claim.scene))
    decided = 0
    for neighbour in neighbours:
        verdict = None
        if stage is not None and neighbour.edit is not None:
            verdict = _passes(claim, neighbour, stage)
        if verdict is None:
            decided += 1
            verdict = decided <= DECIDED
        if verdict:
            yield neighbour


def _passes(claim: Claim, neighbour: Neighbour, stage: ProgramStage) -> bool | None:
    """Whether the residuals of a candidate vanish at the points; ``None`` if there are none."""
    assert neighbour.edit is not None
    try:
        residuals = claim.residuals(neighbour.edit.formula, stage)
    except (StageError, ZeroDivisionError):
        return False
    return None if residuals is None else all(residual.is_zero for residual in residuals)
