"""Statements about an exact point, which Rocq decides by computing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from kowalevski_cas.export.format import Inexpressible, Json
from kowalevski_cas.export.rocq.space import Sides, Space
from kowalevski_cas.problem.checker import Element, locate, need


class Place:
    """A point of a space where given equations hold, and the theorem that there is one."""

    def __init__(self, space: Space, point: Json, given: Sequence[Sides]) -> None:
        if point["roots"]:
            raise Inexpressible("a point has coordinates that are no Gaussian rational numbers")
        self.space, self.at = space, locate(space.checked, point, [])
        self.statements = _hold(given)

    @property
    def statement(self) -> str:
        """There is such a point."""
        return "exists p : nat -> gauss,\n  " + " /\\\n  ".join(
            [*self._admissible(), *self.statements]
        )

    @property
    def proof(self) -> list[str]:
        """It is this one."""
        shown = [self._coordinates(self.at.images[name]) for name in self.space.names]
        return [f"exists (point [{'; '.join(shown)}]%Q).", "vm_compute. repeat split."]

    def fails(self, pairs: Sequence[Sides]) -> None:
        """One of these equations fails there."""
        equal = [_equal(sides) for sides in pairs]
        self.statements.append(f"{' && '.join(f'({equality})' for equality in equal)} = false")

    def independent(self, functions: Sequence[str], elements: Sequence[Element]) -> None:
        """The differentials of functions are independent there."""
        space, element = self.space, self.space.checked.ring.number(1)
        variables = space.checked.variables
        partials = "; ".join(space.partial(name) for name in variables)
        word = space.define("partials", f"[{partials}]", "list (expr -> expr)")
        matrix = [
            [self.at(space.checked.along(e, {v: element})) for v in variables] for e in elements
        ]
        rows = [f"map (fun d => at_point p (d ({f}))) {word}" for f in functions]
        columns = "; ".join(map(str, sorted(self._pivots(matrix))))
        self.statements.append(f"vanishes (minor [{'; '.join(rows)}] [{columns}]%nat) = false")

    def _pivots(self, rows: list[list[Element]]) -> Iterator[int]:
        """Columns in which the rows are independent."""
        while rows:
            row = rows.pop()
            k = next((k for k, entry in enumerate(row) if entry.terms), None)
            need(k is not None, "the differentials are dependent")
            assert k is not None
            over = self.at.space.inverse(row[k])
            rows = [[a - r[k] * over * b for a, b in zip(r, row, strict=True)] for r in rows]
            yield k

    def _admissible(self) -> list[str]:
        """The point obeys relations and conditions of the space, and what is real is so there."""
        space = self.space
        squares = [(f"{a} * {a}", b) for a, b in space.sides(space.squares.items())]
        ones = [tree for pair in space.bases.items() for tree in pair]
        squares += [(space.say(tree), "1") for tree in ones]
        nonzero = [f"vanishes (at_point p ({text})) = false" for text in space.conditions()]
        names = [space.term(name) for name in space.names]
        real = [f"equal (at_point p (conjugate {n})) (gbar (at_point p {n})) = true" for n in names]
        return [*_hold(squares), *nonzero, *real]

    def _coordinates(self, value: Element) -> str:
        """A Gaussian rational number."""
        both = (value.terms.get(m, 0) for m in (0, self.at.space.ring.unit["i"]))
        parts = (Fraction(part, value.below) for part in both)
        return f"({', '.join(f'{z.numerator} # {z.denominator}' for z in parts)})"


def _hold(pairs: Sequence[Sides]) -> list[str]:
    return [f"{_equal(sides)} = true" for sides in pairs]


def _equal(sides: Sides) -> str:
    return f"equal (at_point p ({sides[0]})) (at_point p ({sides[1]}))"
