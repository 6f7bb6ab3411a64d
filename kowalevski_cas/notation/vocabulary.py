"""The names that a formula may use, and what each of them is."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.notation.formula import Name
from kowalevski_cas.notation.symbol import symbol

SCALAR, VECTOR, MATRIX = 0, 1, 2
_DIGIT = re.compile(r"\d")


@dataclass(frozen=True)
class Vocabulary:
    r"""The declared names, in canonical LaTeX.

    A name is a letter with its index: ``\omega_1``, ``U_{12}``, ``\ell``,
    ``\boldsymbol{\alpha}``, ``\mathbf{e}_1``, ``\mathrm{sn}``. An index of more than one
    character stands in braces, a star before it: ``x^*_1``. Independent variables are scalars that
    a written-out derivative may have in its denominator; what is ``moving`` may be printed as a
    function of one, as :math:`x(t)`, and is the same name.

    >>> words = Vocabulary(scalars={"x_1", "i"}, times={r"\tau"})
    >>> r"\tau" in words, "x_2" in words
    (True, False)
    """

    scalars: frozenset[str] = frozenset()
    vectors: frozenset[str] = frozenset()
    matrices: frozenset[str] = frozenset()
    functions: frozenset[str] = frozenset()
    times: frozenset[str] = frozenset()
    moving: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        """Accept any iterable of names."""
        for field in ("scalars", "vectors", "matrices", "functions", "times", "moving"):
            object.__setattr__(self, field, frozenset(getattr(self, field)))

    @cached_property
    def ranks(self) -> dict[str, int]:
        """The rank of every name that stands for a value: 0 scalar, 1 vector, 2 matrix."""
        return (
            dict.fromkeys(self.matrices, MATRIX)
            | dict.fromkeys(self.vectors, VECTOR)
            | dict.fromkeys(self.scalars | self.times, SCALAR)
        )

    @cached_property
    def families(self) -> dict[str, int]:
        """The rank of every letter of which there are names with numbers as indices."""
        found = ((symbol(name), rank) for name, rank in self.ranks.items())
        return {parts.head: rank for parts, rank in found if _DIGIT.search(parts.index)}

    def rank(self, name: str) -> int:
        """The rank of a name; that of its letter, if the index is that of a sum."""
        found = self.ranks.get(name)
        return self.families.get(symbol(name).head, SCALAR) if found is None else found

    @cached_property
    def names(self) -> Mapping[str, Name]:
        """One node for every name that stands for a value, shared by all formulas."""
        return _Nodes(self.ranks)

    def __contains__(self, name: str) -> bool:
        """Whether the name is declared, as a value or as a function."""
        return name in self.ranks or name in self.functions


class _Nodes(Mapping[str, Name]):
    """The node of each of some names, made when it is asked for: a book has thousands of names."""

    def __init__(self, names: Mapping[str, int]) -> None:
        self._names = names
        self._made: dict[str, Name] = {}

    def __getitem__(self, name: str) -> Name:
        if name not in self._made:
            if name not in self._names:
                raise KeyError(name)
            self._made[name] = Name(name)
        return self._made[name]

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)
