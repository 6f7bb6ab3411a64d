"""Why a changed formula says the same: decided exactly, on every scene that uses it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.audit.memory import Memory
from kowalevski_cas.audit.roles import places_of
from kowalevski_cas.audit.session import base_of
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.formulas import components
from kowalevski_cas.notation import Constant, Formula, NotationError, Relation
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.stage import Stage, StageError, evaluate


def equivalence(memory: Memory, printed: Printed, old: Formula, new: Formula) -> str:
    """Why the formulas are equivalent wherever the place is used; empty if that is not shown."""
    bench = Bench(memory.arithmetics[0], base_of(memory).texts, stages=memory.stages, refute=False)
    reasons: dict[str, None] = {}
    for scene in _scenes(memory, printed):
        try:
            reason = _on(bench.stage(scene), old, new)
        except (NotationError, StageError, ArithmeticError, ValueError):
            continue
        if not reason:
            return ""
        reasons[reason] = None
    return "; ".join(reasons)


def _scenes(memory: Memory, printed: Printed) -> Iterator[Scene]:
    """The scenes on which a place is used, by the scene itself or by a claim."""
    found: dict[Scene, None] = {}
    for claim in memory.derivation.claims:
        if printed in places_of(claim):
            found.update(dict.fromkeys(claim.scenes()))
    yield from found


def _on(stage: Stage, old: Formula, new: Formula) -> str:
    first, second = _members(old, stage), _members(new, stage)
    if len(first) != len(second):
        return ""
    pairs = list(zip(first, second, strict=True))
    if all((a - b).is_zero for one, other in pairs for a, b in zip(one, other, strict=True)):
        return "it has the same values"
    if len(pairs) != 2 or len(first[0]) != 1:
        return ""
    (left, left_new), (right, right_new) = pairs
    ratio = _ratio(left_new[0] - right_new[0], left[0] - right[0])
    return f"it is the same equation times {ratio}" if ratio else ""


def _members(formula: Formula, stage: Stage) -> list[tuple[Element, ...]]:
    parts = formula.members if isinstance(formula, Relation) else (formula,)
    return [components(evaluate(p, stage)) for p in parts if not isinstance(p, Constant)]


def _ratio(new: Element, old: Element) -> Fraction | None:
    """The rational number by which two elements differ, if they do by one."""
    if old.is_zero or new.is_zero:
        return None
    mask, terms = next(iter(old.terms().items()))
    exponents, value = next(iter(terms.items()))
    other = new.terms().get(mask, {}).get(exponents)
    if not other or old.denominator != new.denominator:
        return None
    ratio = Fraction(other) / Fraction(value)
    return ratio if (new - old * old.ring.number(ratio)).is_zero else None
