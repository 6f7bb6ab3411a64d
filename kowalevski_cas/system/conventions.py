"""How equations of motion are printed, which is how formulas beside them are read."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field
from typing import NamedTuple

from kowalevski_cas.paper.applied import collective_arguments, printed_arguments, without_arguments
from kowalevski_cas.paper.chains import without_chains
from kowalevski_cas.paper.initial_values import without_initial_values
from kowalevski_cas.paper.jets import Unknown, without_argument
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.subscripts import derived_in_index, with_derivatives, with_rates
from kowalevski_cas.system.beside import columns, with_columns_in_bold, with_upright_unit
from kowalevski_cas.system.bracket_laws import with_laws_of_brackets
from kowalevski_cas.system.indices import (
    counts,
    has_permutation,
    with_counts,
    with_length,
    with_pairs,
    with_range_of_names,
    with_ranges,
    with_symmetry,
)
from kowalevski_cas.system.inverses import without_inverses
from kowalevski_cas.system.maps import has_bars, with_primes, without_steps
from kowalevski_cas.system.partials import moving_names, with_partials
from kowalevski_cas.system.real_parts import with_real_parts
from kowalevski_cas.system.skew_matrices import with_skew_matrices
from kowalevski_cas.system.unknown import (
    said_functions,
    unknown_functions,
    with_rates_of_functions,
    without_said_functions,
)
from kowalevski_cas.system.vectors import Vectors


@dataclass(frozen=True)
class Conventions:
    """The conventions of a print."""

    columns: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """The vectors that are printed in italics, with their components."""
    derived: str = ""
    """The variable by which indices derive, if they do."""
    barred: bool = False
    """Whether bars stand over images of a map."""
    counts: Mapping[str, str] = field(default_factory=dict)
    """The letters that say how far indices run, with their numbers."""
    applied: Mapping[str, str] = field(default_factory=dict)
    """The arguments of names that are defined; they are called by their names alone."""
    functions: tuple[Unknown, ...] = ()
    """The functions of which nothing is known; they are called by their names alone."""
    summed: bool = False
    """Whether indices that stand twice are summed over, though no sums are printed."""
    ends: Set[str] = frozenset()
    """The names that only close a chain, or end it: a sum over all links has none of them."""

    def plain(self, tex: str, scene: Scene) -> str:
        """A formula in the names of a scene, without what is printed by convention."""
        jets = {name for name, _, _ in scene.jets}
        moving = {*scene.variables} - jets - {scene.time}
        plain = with_columns_in_bold(with_rates(tex), self.columns)
        plain = with_partials(with_counts(plain, self.counts), moving)
        plain = with_derivatives(plain, self.derived)
        applied = {**collective_arguments([plain]), **self.applied}
        plain = without_arguments(without_argument(plain, self.functions), applied)
        plain = with_primes(plain) if self.barred else plain
        links = [one for one in (*scene.names(), *scene.vectors) if one not in self.ends]
        return with_ranges(plain, links, self.summed)


class PlainPrint(NamedTuple):
    """A print without its conventions, and what it says besides."""

    tex: str
    conventions: Conventions
    equalities: tuple[tuple[str, str], ...]
    """The members of its chains, which have to be equal."""
    said: tuple[str, ...]
    """The names that words say to be functions."""


def spelled_out(tex: str) -> str:
    """A print with what its author does not say: what i is, real parts, laws of any function."""
    tex = with_real_parts(with_rates_of_functions(with_upright_unit(with_rates(tex))))
    return with_skew_matrices(with_laws_of_brackets(tex))


def plain_print(tex: str, vectors: Vectors, map: bool) -> PlainPrint:
    """Equations of motion, or a map, as they are printed, and by which conventions."""
    in_italics = columns(tex)
    tex = with_columns_in_bold(tex, in_italics)
    rows = (rf"\mathbf{{{one}}}=({','.join(parts)})" for one, parts in in_italics.items())
    tex = r",\quad ".join((tex, *rows))
    derived = derived_in_index([tex])
    barred = map and has_bars(tex)
    tex = without_inverses(without_steps(tex) if barred else tex)
    numbers = counts(tex)
    tex = with_counts(tex, numbers)
    moving = () if map else moving_names(tex)
    tex, equalities = without_chains(tex if map else without_initial_values(tex, moving), moving)
    if not map:
        tex = with_range_of_names(with_pairs(with_symmetry(with_length(tex))))
        tex = with_partials(tex, moving_names(tex))
    applied = printed_arguments([tex], vectors)
    functions = (*unknown_functions(tex),)
    said, tex = (*said_functions(tex),), without_said_functions(tex)
    conventions = Conventions(
        in_italics, derived, barred, numbers, applied, functions, has_permutation(tex)
    )
    return PlainPrint(conventions.plain(tex, Scene("")), conventions, equalities, said)
