"""False by little: statements that deceive points, floating point, a modulus or a habit.

Each is made from a true statement by one rule that knows nothing of the statement;
whether the result is false is decided by exact arithmetics, like everything else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kowalevski_cas.notation import (
    Constant,
    Formula,
    Name,
    Negative,
    NotationError,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    replace,
    subtree,
)
from kowalevski_cas.notation.reader import Path
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts

MODULUS = 2**61 - 1
"""A prime, the largest below 2^61: the modulus that a program is likely to take."""

ORDINARY = 5
"""Points are often drawn among the integers from minus this to this."""

_Rule = Callable[[Formula, Scene, Texts], Formula | None]


def near_misses(formula: Formula, scene: Scene, texts: Texts) -> Iterator[tuple[str, Formula]]:
    """The kind of each near miss of a formula on a scene, and what it makes of the formula."""
    for kind, rule in _RULES.items():
        try:
            changed = rule(formula, scene, texts)
        except NotationError:  # a name that these texts do not have
            continue
        if changed is not None:
            yield kind, changed


def _plus(formula: Formula, term: Callable[[Formula], Formula]) -> Formula:
    """The formula with a term more, made from the last member that is an expression."""
    if not isinstance(formula, Relation):
        return Sum((formula, term(formula)))
    names = [k for k, m in enumerate(formula.members) if not isinstance(m, Constant)]
    rich = [k for k in names if not isinstance(formula.members[k], Name)]
    at = (rich or names)[-1]
    member = formula.members[at]
    return replace(formula, (at,), Sum((member, term(member))))


def _first_term(member: Formula) -> Formula:
    return member.terms[0] if isinstance(member, Sum) else member


def _tiny(formula: Formula, scene: Scene, texts: Texts) -> Formula:
    """A coefficient is off by 10^-20."""
    below = Power(Number(10), Number(20))
    return _plus(formula, lambda member: Quotient(_first_term(member), below))


def _modulus(formula: Formula, scene: Scene, texts: Texts) -> Formula:
    """A coefficient is off by a multiple of the modulus."""
    return _plus(formula, lambda member: Product((Number(MODULUS), _first_term(member))))


def _integers(formula: Formula, scene: Scene, texts: Texts) -> Formula | None:
    """A term that vanishes where a variable is a small integer."""
    names = (*scene.variables, *scene.constants)
    if not names:
        return None
    variable = Name(names[0])
    square = Power(variable, Number(2))
    factors = (Sum((square, Negative(Number(k * k)))) for k in range(1, ORDINARY + 1))
    return _plus(formula, lambda _: Product((variable, *factors)))


def _real(formula: Formula, scene: Scene, texts: Texts) -> Formula | None:
    """A term that vanishes where conjugate variables are equal, that is, real."""
    if not scene.conjugates:
        return None
    first, second = scene.conjugates[0]
    return _plus(formula, lambda _: Sum((Name(first), Negative(Name(second)))))


def _equal_fields(formula: Formula, scene: Scene, texts: Texts) -> Formula | None:
    """A term that vanishes exactly where both fields are equally strong."""
    if "c_1" in scene.constants:
        return _plus(formula, lambda _: Sum((Name("c_1"), Name("c_2"))))
    if not {r"\beta_1", r"\alpha_1"} <= set(scene.variables):
        return None
    term = texts.expression(
        r"(\boldsymbol{\alpha},\boldsymbol{\alpha})-(\boldsymbol{\beta},\boldsymbol{\beta})"
    )
    return _plus(formula, lambda _: Product((term, Name(scene.variables[0]))))


def _branch(formula: Formula, scene: Scene, texts: Texts) -> Formula | None:
    """One root is taken with the other sign."""
    path = next(_roots(formula, frozenset(scene.roots)), None)
    if path is None:
        return None
    return replace(formula, path, Negative(subtree(formula, path)))


def _roots(formula: Formula, names: frozenset[str]) -> Iterator[Path]:
    """Where a root stands, by a sign of its own or by a name."""
    if isinstance(formula, Root) or (isinstance(formula, Name) and formula.name in names):
        yield ()
    for index, child in enumerate(formula.children()):
        for path in _roots(child, names):
            yield (index, *path)


_RULES: dict[str, _Rule] = {
    "coefficient off by 10^-20": _tiny,
    "coefficient off by 2^61-1": _modulus,
    "vanishes at small integers": _integers,
    "vanishes at real points": _real,
    "true only for a=b": _equal_fields,
    "wrong branch of a root": _branch,
}
