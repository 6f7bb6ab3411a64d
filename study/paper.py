"""A paper of the library as it is corrected, and its statements: what the steps put to the test."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, cached_property

from kowalevski_cas.algebra import load as load_arithmetic
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.library import find, load
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.sampled import Sampled
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.verify.certificate import Stored, load_certificates
from kowalevski_cas.verify.corrections import recorded_correction
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.statement import Statement

FIRST = "kharlamov2002"


class CorrectedPaper:
    """A derivation with the corrections of its record, whether it accepts them or not.

    ``claims`` are the corrected ones, by id; ``printed`` and ``corrected`` give scenes a meaning.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        self.derivation = load(name)
        self.claims = {claim.id: claim for claim in self.derivation.claims}
        self.printed = Elaborations(self.derivation.texts())
        texts = self.printed.texts
        for id, entry in (load_record(find(name)) or {}).items():
            if isinstance(wanted := entry.get("correction"), str):
                on = self.printed.under(texts)
                if (found := recorded_correction(self.claims[id], on, wanted)) is None:
                    raise ValueError(f"{id} has no correction {wanted}: `make record` writes it")
                neighbour, _ = found
                self.claims[id] = neighbour.claim
                if neighbour.edit is not None and neighbour.printed is not None:
                    texts = texts.with_source(neighbour.printed.display, neighbour.edit.tex)
        self.corrected = self.printed.under(texts)

    @cached_property
    def certificates(self) -> dict[str, Stored]:
        """The certificates that are committed with the derivation."""
        return load_certificates(find(self.name))

    def statement(self, id: str) -> Statement:
        """What the claim with this id says, as corrected."""
        return Statement(self.claims[id], self.corrected)


@cache
def paper(name: str = FIRST) -> CorrectedPaper:
    """The paper with this name, read once."""
    return CorrectedPaper(name)


def exact(arithmetic: str) -> Callable[[Setting], Evaluation]:
    """What evaluates spaces in an exact arithmetic, each space once."""
    polynomials = load_arithmetic(arithmetic)

    @cache
    def of(setting: Setting) -> Evaluation:
        return Evaluation(setting, polynomials, others=of).adjoin_roots()

    return of


def sampler() -> Callable[[Setting], Sampled]:
    """What evaluates spaces in programs, to be put to points; each space once."""
    of = exact("flint")
    return cache(lambda setting: Sampled(of(setting)))


def both(scene: Scene) -> tuple[Evaluation, Sampled]:
    """A scene of the first paper in exact polynomials, and in programs."""
    at = paper().corrected(scene).finder
    return at, Sampled(at)


def sides(id: str, at: Evaluation) -> tuple[Element, Element]:
    """Both sides of the corrected equation of a claim of the first paper, read on any scene."""
    printed, on = paper().claims[id].printed, at.setting
    assert printed is not None and isinstance(on, Elaboration)
    left, right = (at.scalar(on.plain(m)) for m in on.texts.relation(printed).members[:2])
    return left, right
