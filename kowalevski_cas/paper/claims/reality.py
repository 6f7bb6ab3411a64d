"""Reality: expressions that are real or purely imaginary on real motions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation import Conjugate, Formula, Negative
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.goals import Goal, identity


class Reality(Claim):
    """Some expressions equal their conjugates, others are the negatives of theirs."""

    real: tuple[str, ...]
    imaginary: tuple[str, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        real, imaginary = (list(map(space.formula, group)) for group in (self.real, self.imaginary))
        yield identity(
            space,
            *((formula, Conjugate(formula)) for formula in real),
            *((formula, Negative(Conjugate(formula))) for formula in imaginary),
        )

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        for tex in self.real:
            rest = tuple(t for t in self.real if t != tex)
            claim = replace(self, real=rest, imaginary=(*self.imaginary, tex))
            yield Neighbour(f"{tex} imaginary instead of real", claim, texts)
        for tex in self.imaginary:
            rest = tuple(t for t in self.imaginary if t != tex)
            claim = replace(self, imaginary=rest, real=(*self.real, tex))
            yield Neighbour(f"{tex} real instead of imaginary", claim, texts)
