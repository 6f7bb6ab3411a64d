"""Numbers by which a claim holds: a coefficient in a formula on which it stands, solved for.

An unknown is put in the place of a coefficient, as a constant. What the identities of the claim say
of it alone is a common factor of all their coefficients; where that is linear, it has one value.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import takewhile

from kowalevski_cas.notation import (
    Edit,
    Formula,
    Name,
    NotationError,
    Number,
    Product,
    Quotient,
    edits,
    substitute,
    subtree,
    to_latex,
)
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.relations import common_factors
from kowalevski_cas.verify.statement import Statement

UNKNOWN = Name("?")


def missing_numbers(
    claim: Claim, place: Printed, on: Elaborations, goes_on: Callable[[], bool]
) -> Iterator[Edit]:
    """The edits of a formula that give a claim the one positive coefficient by which it holds.

    They are sought as long as ``goes_on`` says so.
    """
    statement = on.texts.statement(place)
    places = dict.fromkeys(
        edit.path
        for edit in edits(statement, on.texts.vocabulary)
        if edit.kind == "coefficient" and edit.replacement != Number(0)
    )
    for path in takewhile(lambda _: goes_on(), places):
        edit = _with_unknown(Edit("coefficient", path, UNKNOWN, "", statement, on.texts.vocabulary))
        with suppress(NotationError, Meaningless, ZeroDivisionError):
            for number in _solutions(claim, place, edit, on):
                yield _with_number(edit, number)


def _with_unknown(edit: Edit) -> Edit:
    """An edit with an unknown in the place of a number, or as a factor of what is none."""
    printed = subtree(edit.statement.formula, edit.path)
    if _is_number(printed):
        return replace(edit, words=f"for ${to_latex(printed)}$ read $?$")
    factors = printed.factors if isinstance(printed, Product) else (printed,)
    words = f"insert $?$ before ${to_latex(printed)}$"
    return replace(edit, replacement=Product((UNKNOWN, *factors)), words=words)


def _is_number(formula: Formula) -> bool:
    return isinstance(formula, Number) or (
        isinstance(formula, Quotient) and all(isinstance(n, Number) for n in formula.children())
    )


def _solutions(claim: Claim, place: Printed, edit: Edit, on: Elaborations) -> Iterator[Formula]:
    """The values of the unknown by which all identities of a claim hold, if they are positive."""
    edited = claim.edited(on.texts, place, edit)
    scene = edited.claim.scene
    known = replace(scene, constants=(*scene.constants, UNKNOWN.name))
    statement = Statement(replace(edited.claim, scene=known), on.under(edited.texts))
    for factor in common_factors(statement, {UNKNOWN.name}):
        if factor.total_degree() == 1:
            slope, rest = factor.coeffs()
            if (value := -rest / slope) > 0:
                whole = Number(int(value.p))
                yield whole if value.q == 1 else Quotient(whole, Number(int(value.q)))


def _with_number(edit: Edit, number: Formula) -> Edit:
    """The edit with a number for the unknown."""
    replacement = substitute(edit.replacement, {UNKNOWN.name: number})
    words = edit.words.replace(UNKNOWN.name, to_latex(number))
    return replace(edit, replacement=replacement, words=words)
