"""The labelled set: statements of which it is known whether they are true.

True ones are the identities of the derivations, as corrected. False ones are
their misprints, their single-token mutants, and near misses. The label of each is
what three exact arithmetics say, which have to agree.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, zip_longest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.claims import Claim, FirstIntegral, Identity
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.library import available, find, load
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.stage import StageError
from study.near_misses import near_misses


class Disagreement(Exception):
    """Two exact arithmetics say different things; the message has the statement and both."""


TRUE, MISPRINT, MUTANT = "identity", "misprint", "mutant"


@dataclass(frozen=True, eq=False)
class Labelled:
    """A statement, how it was made, and whether it is true."""

    id: str
    kind: str
    claim: Claim
    texts: Texts

    @cached_property
    def verdicts(self) -> dict[str, bool]:
        """What each exact arithmetic says."""
        return {name: holds(self, Bench(name, self.texts, refute=False)) for name in EXACT}

    @property
    def truth(self) -> bool:
        """The label; raises :class:`Disagreement` if the exact arithmetics do not agree."""
        if len(set(self.verdicts.values())) > 1:
            raise Disagreement(f"{self.id}: {self.verdicts}")
        return self.verdicts[EXACT[0]]


def holds(statement: Labelled, bench: Bench) -> bool:
    """Whether all residuals vanish, in an exact arithmetic."""
    claim = statement.claim
    assert claim.printed is not None
    formula = statement.texts.formula(claim.printed)
    residuals = claim.residuals(formula, bench.stage(claim.scene))
    assert residuals
    return all(residual.is_zero for residual in residuals)


def labelled(mutants: int, names: Sequence[str] = ()) -> list[Labelled]:
    """The labelled set of the named derivations, of the whole library if none is named.

    ``mutants`` is how many are taken of each statement. Statements without meaning,
    as with a name that nothing defines, are left out.
    """
    found: list[Labelled] = []
    for name in names or available():
        for statement in _statements(name, mutants):
            try:
                holds(statement, Bench(EXACT[0], statement.texts, refute=False))
            except (NotationError, StageError, ZeroDivisionError):
                continue
            found.append(statement)
    return found


def spread(statements: Sequence[Labelled], size: int) -> list[Labelled]:
    """At most so many statements, half of them true, the kinds of the others in turn."""
    kinds = Counter(statement.kind for statement in statements)
    shares = {kind: [s for s in statements if s.kind == kind] for kind in kinds}
    true = _thinned(shares.pop(TRUE, []), size // 2)
    others = (_thinned(share, size) for share in shares.values())
    false = [s for s in chain.from_iterable(zip_longest(*others)) if s is not None]
    return [*true, *false[: size - len(true)]]


def _thinned(statements: list[Labelled], size: int) -> list[Labelled]:
    """At most so many, evenly from the whole list."""
    if len(statements) <= size:
        return statements
    return [statements[k * len(statements) // size] for k in range(size)]


def _statements(name: str, mutants: int) -> Iterator[Labelled]:
    derivation = load(name)
    session = Session(derivation, [EXACT[0]], False, load_evidence(find(name)))
    session.run()
    texts = session.texts
    for claim in map(_identity, derivation.claims):
        if claim is None:
            continue
        assert claim.printed is not None
        label = f"{name}/{claim.id}"
        yield Labelled(label, TRUE, claim, texts)
        display = claim.printed.display
        printed = texts.with_source(display, display.tex)
        if printed.formula(claim.printed) != texts.formula(claim.printed):
            yield Labelled(f"{label}/as printed", MISPRINT, claim, printed)
        found = list(claim.neighbours(texts))
        for neighbour in random.Random(label).sample(found, min(mutants, len(found))):
            yield Labelled(f"{label}/{neighbour.words}", MUTANT, claim, neighbour.texts)
        for kind, edit in near_misses(texts.statement(claim.printed), claim.scene, texts):
            yield Labelled(f"{label}/{kind}", kind, claim, texts.edited(claim.printed, edit))


def _identity(claim: Claim) -> Claim | None:
    """A claim that says that some expressions vanish, and nothing else."""
    if isinstance(claim, Identity):
        return Identity(claim.id, claim.scene, claim.printed, claim.words)
    return claim if isinstance(claim, FirstIntegral) and not claim.given else None
