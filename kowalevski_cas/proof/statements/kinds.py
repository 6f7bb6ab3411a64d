"""What a claim of any kind states in a certificate, and what all kinds share."""

from __future__ import annotations

from functools import singledispatch

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims import (
    Claim,
    InvariantRelations,
)
from kowalevski_cas.proof.parts import Parts
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.paper.texts import Printed

Matrix = list[list[Element]]


@singledispatch
def state(claim: Claim, parts: Parts) -> None:
    """Write what the claim states, for one that holds."""
    raise CertificateError(f"the kind {type(claim).__name__} has no certificates")


@singledispatch
def deny(claim: Claim, parts: Parts) -> None:
    """Write a point at which the claim, as printed, fails."""
    raise CertificateError(f"the kind {type(claim).__name__} has no refutations")


def printed_of(claim: Claim) -> Printed:
    """The place of the formula that the claim is."""
    if claim.printed is None:
        raise CertificateError("the claim is no single formula")
    return claim.printed


def sides_of(space: SpaceWriter, places: tuple[Printed, ...]) -> list[list[Tree]]:
    """Both sides of each printed equation."""
    return [space.sides(printed) for printed in places]


def matrix_of(claim: InvariantRelations, parts: Parts) -> Matrix:
    """The cofactor matrix that was found for invariant relations."""
    matrix = claim.matrix(parts.bench.finder)
    if matrix is None:
        raise CertificateError("no cofactor matrix was found")
    return matrix


def found_row(row: list[Element] | None) -> list[Element]:
    """The cofactors of a combination, which has to have been found."""
    if row is None:
        raise CertificateError("no combination was found")
    return row
