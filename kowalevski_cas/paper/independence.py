"""Whether the functions in a goal are known to obey no equations but their own."""

from __future__ import annotations

from math import prod

from kowalevski_cas.notation import Formula, Name, Root
from kowalevski_cas.paper.families import Generators, Kind
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.goals import Exists, Goal, simple
from kowalevski_cas.problem.prune import Reach


def decides(goal: Goal) -> bool:
    """Whether a point where a goal fails refutes what it says of functions.

    It does not where the generators of functions may depend on each other in ways that are not
    known here: as a point there may be none.
    """
    for part in simple(goal):
        if isinstance(part.space, Meaning) and part.space.transcendental.groups:
            reach = Reach(part.space)
            reach.bound = {*goal.bound} if isinstance(goal, Exists) else set()
            reach.goal(part)
            used = [
                group
                for group in part.space.transcendental.groups
                if not reach.names.isdisjoint(group.names.values())
            ]
            if not _independent(used, part.space):
                return False
    return True


def _independent(groups: list[Generators], setting: Meaning) -> bool:
    """Whether generators are known to obey no equations but their own.

    It is not of functions with two moduli, nor with one that may be 0 or 1, where they are
    others, nor of arguments that may have to do with one another; complete integrals of several
    moduli do, and if a parameter is no constant of its own.
    """
    kinds = {group.kind for group in groups if group.kind.parameters}
    complete = [group for group in groups if group.kind.family.is_explicit]
    if complete and not _have_one_modulus(complete, setting):
        return False
    if any(_may_degenerate(kind, setting) for kind in kinds):
        return False
    rest = [group for group in groups if group not in complete]
    return len(kinds) < 2 and (len(rest) < 2 or _are_independent(rest, setting))


def _may_degenerate(kind: Kind, setting: Meaning) -> bool:
    """Whether the discriminant vanishes, or has a root in it, so that it may."""
    # where it vanishes elliptic functions are elementary ones, which obey more equations
    discriminant = setting.plain(kind.formula(kind.family.discriminant, {}))
    names = (setting.transcendental.expanded(parameter).names() for parameter in kind.parameters)
    roots = any(_is_root(Name(name), setting) for name in frozenset[str]().union(*names))
    return roots or setting.finder.scalar(discriminant).is_zero


def _have_one_modulus(groups: list[Generators], setting: Meaning) -> bool:
    """Whether integrals have one modulus, and no parameter but constants that it has not in it."""
    moduli = {group.monomial for group in groups}
    below = {parameter for group in groups for parameter in group.kind.parameters}
    names = {name for group in groups for name in setting.transcendental.names_under(group)}
    constants = {
        constant for constant in map(Name, setting.scene.constants) if constant.name not in names
    }
    return len(moduli) == 1 and constants.issuperset(below)


def _are_independent(groups: list[Generators], setting: Meaning) -> bool:
    """Whether no argument is a sum of multiples of the others; products of names are none.

    Roots may be each other's multiples, and that of a square is none. Over a sum stand terms
    that may cancel.
    """
    parts = [part for group in groups for part in group.monomial]
    odd = [(f, e) for f, e in parts if _is_root(f, setting) or not isinstance(f, Name)]
    inner = {node for f, _ in odd for node in f.nodes() if node == f or _is_root(node, setting)}
    if len(inner) > 1 or len({exponent for _, exponent in odd}) > 1:
        return False
    if any(_is_root(factor, setting) for factor in inner):
        return all(e * e == 1 for _, e in odd) and not any(
            _is_square(factor, setting) for factor in inner
        )
    return len(odd) < 2


def _is_root(formula: Formula, setting: Meaning) -> bool:
    """Whether a formula is a root, as printed or by its name."""
    return isinstance(formula, Root) or getattr(formula, "name", "") in setting.scene.roots


def _is_square(root: Formula, setting: Meaning) -> bool:
    """Whether what a root is taken of may be a square."""
    square = setting.finder.scalar(root) ** 2
    # a quotient is a square where the product of numerator and denominator is one
    below = prod(square.ring.divisors[k] ** e for k, e in square.denominator.items())
    parts = {mask: part * below for mask, part in square.parts.items()}
    return parts.keys() != {0} or all(e % 2 == 0 for _, e in parts[0].factor()[1])
