"""The labelled set: statements of which it is known whether they are true.

True ones are the identities of the derivations, as corrected. False ones are
their misprints, their single-token mutants, and near misses. The label of each is
what three exact arithmetics say, which have to agree.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import chain, zip_longest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.library import available
from kowalevski_cas.limits import time_limit
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Fails, Follows, Problem
from kowalevski_cas.problem.space import Meaningless, Setting
from kowalevski_cas.processes import each
from kowalevski_cas.verify.statement import Statement
from study.near_misses import near_misses
from study.paper import CorrectedPaper, exact, paper


class ArithmeticDisagreement(Exception):
    """Two exact arithmetics say different things; the message has the statement and both."""


SECONDS = 10.0
"""How long a statement may take to be one of the set."""

TRUE, MISPRINT, MUTANT = "identity", "misprint", "mutant"


@dataclass(frozen=True, eq=False)
class Labelled:
    """A statement, how it was made, and whether it is true."""

    id: str
    kind: str
    statement: Statement

    @cached_property
    def verdicts(self) -> dict[str, bool]:
        """What each exact arithmetic says."""
        return {name: holds(self.statement.problem, name) for name in EXACT}

    @property
    def truth(self) -> bool:
        """The label; raises :class:`Disagreement` if the exact arithmetics do not agree."""
        if len(set(self.verdicts.values())) > 1:
            raise ArithmeticDisagreement(f"{self.id}: {self.verdicts}")
        return self.verdicts[EXACT[0]]


def identities(problem: Problem) -> Iterator[Follows]:
    """The goals of a problem that consists of identities; raises ``TypeError`` for any other."""
    for goal in problem.goals:
        if not isinstance(goal, Follows) or isinstance(goal, Fails):
            raise TypeError("it is no identity")
        if goal.given or len(goal.conclusions) != 1:
            raise TypeError("it is no identity")
        yield goal


def residuals(problem: Problem, of: Callable[[Setting], Evaluation]) -> Iterator[Element]:
    """What has to vanish identically for a problem that consists of identities.

    Raises ``TypeError`` for any other problem.
    """
    for goal in identities(problem):
        yield from of(goal.space).differences(goal.conclusions[0])


def holds(problem: Problem, arithmetic: str) -> bool:
    """Whether all residuals vanish, in an exact arithmetic."""
    return all(residual.is_zero for residual in residuals(problem, exact(arithmetic)))


def labelled_set(mutants: int, names: Sequence[str] = ()) -> list[Labelled]:
    """The labelled set of the named derivations, of the whole library if none is named.

    ``mutants`` is how many are taken of each statement. Statements without meaning,
    as with a name that nothing defines, are left out, and so is what is no identity, or is so large
    that FLINT takes longer than ten seconds.
    """
    return [
        statement
        for name in names or available()
        for statement in _statements(paper(name), mutants)
    ]


def spread(statements: Sequence[Labelled], size: int) -> list[Labelled]:
    """At most so many statements, half of them true, the kinds of the others in turn."""
    kinds = Counter(statement.kind for statement in statements)
    shares = {kind: [s for s in statements if s.kind == kind] for kind in kinds}
    true = _every_so_many(shares.pop(TRUE, []), size // 2)
    others = (_every_so_many(share, size) for share in shares.values())
    false = [s for s in chain.from_iterable(zip_longest(*others)) if s is not None]
    return [*true, *false[: size - len(true)]]


def _every_so_many(statements: list[Labelled], size: int) -> list[Labelled]:
    """At most so many, evenly from the whole list."""
    if len(statements) <= size:
        return statements
    return [statements[k * len(statements) // size] for k in range(size)]


def _statements(source: CorrectedPaper, mutants: int) -> Iterator[Labelled]:
    for claim in source.claims.values():
        found = [*_versions(source, claim, mutants)]

        def statement(place: int) -> Statement:
            return Statement(claim, source.corrected.under(found[place][2]))  # noqa: B023 (at once)

        decided = each(partial(_is_decided, statement), range(len(found)))
        kept = [place for place, answered in enumerate(decided) if answered]
        if 0 in kept:  # the identity itself
            for place in kept:
                id, kind, _ = found[place]
                yield Labelled(f"{source.name}/{id}", kind, statement(place))


def _is_decided(statement: Callable[[int], Statement], place: int) -> bool:
    """Whether a statement has a meaning, and is decided while a person waits."""
    try:
        with time_limit(SECONDS):
            holds(statement(place).problem, EXACT[0])
    except (NotationError, Meaningless, ZeroDivisionError, TypeError, TimeoutError, RecursionError):
        return False
    return True


def _versions(
    source: CorrectedPaper, claim: Claim, mutants: int
) -> Iterator[tuple[str, str, Texts]]:
    """An id, a kind and texts for each reading of a claim, the corrected one first."""
    place, texts = claim.printed, source.corrected.texts
    if place is None:
        return
    yield claim.id, TRUE, texts
    printed = source.printed.texts.formula(place)
    if printed != texts.formula(place):
        yield f"{claim.id}/as printed", MISPRINT, texts.reading({place: printed})
    found = list(claim.neighbours(texts))
    label = f"{source.name}/{claim.id}"
    for neighbour in random.Random(label).sample(found, min(mutants, len(found))):
        yield f"{claim.id}/{neighbour.words}", MUTANT, neighbour.texts
    for kind, formula in near_misses(texts.formula(place), claim.scene, texts):
        yield f"{claim.id}/{kind}", kind, texts.reading({place: formula})
