"""Why a changed formula says the same: decided exactly, on every scene that uses it."""

from __future__ import annotations

from fractions import Fraction

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Constant, Formula, NotationError, Relation
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.interpretation import Interpretation


def equivalence(
    interpretation: Interpretation, printed: Printed, old: Formula, new: Formula
) -> str:
    """Why the formulas are equivalent wherever the place is used; empty if that is not shown."""
    reasons: dict[str, None] = {}
    claims = [claim for claim in interpretation.derivation.claims if printed in claim.reads()]
    settings = {
        interpretation.on(claim)(scene): None for claim in claims for scene in claim.scenes()
    }
    for setting in settings:
        try:
            reason = _on(setting, old, new)
        except (NotationError, Meaningless, ArithmeticError, ValueError):
            continue
        if not reason:
            return ""
        reasons[reason] = None
    return "; ".join(reasons)


def _on(setting: Elaboration, old: Formula, new: Formula) -> str:
    first, second = _members(old, setting), _members(new, setting)
    if len(first) != len(second) or not all(map(_is_equality, (old, new))):
        return ""
    pairs = list(zip(first, second, strict=True))
    if all((a - b).is_zero for one, other in pairs for a, b in zip(one, other, strict=True)):
        return "it has the same values"
    if len(pairs) != 2 or len(first[0]) != 1:
        return ""
    (left, left_new), (right, right_new) = pairs
    ratio = _ratio(left_new[0] - right_new[0], left[0] - right[0])
    return f"it is the same equation times {ratio}" if ratio else ""


def _is_equality(formula: Formula) -> bool:
    """Whether a formula relates its members by equality, if it relates any."""
    return not isinstance(formula, Relation) or formula.is_equality


def _members(formula: Formula, setting: Elaboration) -> list[tuple[Element, ...]]:
    parts = formula.members if isinstance(formula, Relation) else (formula,)
    at = setting.finder
    return [at.components(setting.plain(p)) for p in parts if not isinstance(p, Constant)]


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
