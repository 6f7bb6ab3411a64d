"""The displays of a derivation found in a source: by label, by order, by likeness.

A numbered display stands where its label is. An unnumbered one stands where the
order of the derivation has it between numbered ones. An inline formula is sought
between its neighbouring displays, as the one that is most like it.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass

from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.tokens import likeness, words

LIKE = 0.6
"""How much alike an inline formula and what the derivation has for it must be."""
RELATED = 0.3
"""How much alike unnumbered displays must be where there are more or fewer than expected."""
MOVED = 0.8
"""How much alike a formula must be that is found out of its place."""
PATIENCE = 20_000_000
"""Pairs of tokens after which formulas are no longer compared."""


@dataclass(frozen=True)
class Correspondence:
    """A display of the derivation and the formula of the source that stands for it."""

    display: Display
    typed: TypedFormula | None
    moved: bool = False


def find_places(derivation: Derivation, formulas: Sequence[TypedFormula]) -> list[Correspondence]:
    """The places of all displays that the paper prints, in the order of the derivation."""
    displays = [display for display in derivation.displays() if not display.source]
    finder = _Matcher(displays, formulas)
    finder.by_label()
    finder.by_content()
    finder.between(False, RELATED)
    finder.between(True, LIKE)
    finder.anywhere()
    steady = finder.in_order()
    return [
        Correspondence(
            display,
            formulas[finder.found[k]] if k in finder.found else None,
            k in finder.found and k not in steady,
        )
        for k, display in enumerate(displays)
    ]


class _Matcher:
    """Which formula stands for which display, as far as is known."""

    def __init__(self, displays: Sequence[Display], formulas: Sequence[TypedFormula]) -> None:
        self.displays = displays
        self.formulas = formulas
        self.found: dict[int, int] = {}
        self.taken: set[int] = set()
        self.compared = 0

    def take(self, display: int, formula: int) -> None:
        self.found[display] = formula
        self.taken.add(formula)

    def by_label(self) -> None:
        """Displays that are called after their labels."""
        labels: dict[str, int] = {}
        for k, formula in enumerate(self.formulas):
            for label in formula.labels:
                labels.setdefault(label, k)
        for k, display in enumerate(self.displays):
            where = labels.get(display.id)
            if where is not None and where not in self.taken:
                self.take(k, where)

    def by_content(self) -> None:
        """Unnumbered displays that are printed as the derivation has them, and only once."""
        where: dict[tuple[str, ...], list[int]] = {}
        for k, formula in enumerate(self.formulas):
            if not formula.inline and k not in self.taken:
                where.setdefault(words(formula.tex), []).append(k)
        for k, display in enumerate(self.displays):
            places = where.get(words(display.tex), [])
            if not display.inline and k not in self.found and len(places) == 1:
                if places[0] not in self.taken:
                    self.take(k, places[0])

    def anywhere(self) -> None:
        """What is left, wherever something like it stands."""
        for k, display in enumerate(self.displays):
            if k in self.found:
                continue
            free = [
                (self.alike(k, j), formula.inline == display.inline, -j)
                for j, formula in enumerate(self.formulas)
                if j not in self.taken
            ]
            best = max(free, default=(0.0, False, 0))
            if best[0] >= MOVED and len(words(display.tex)) > 3:
                self.take(k, -best[2])

    def alike(self, display: int, formula: int) -> float:
        """How much alike two formulas are; nothing is, once too many were compared."""
        first, second = self.displays[display].tex, self.formulas[formula].tex
        self.compared += len(words(first)) * len(words(second))
        return likeness(first, second) if self.compared < PATIENCE else 0.0

    def between(self, inline: bool, least: float) -> None:
        """Displays, or inline formulas, between the displays that are found, in this order."""
        steady = self.in_order()
        waiting: list[int] = []
        start = 0
        for k in range(len(self.displays) + 1):
            last = k == len(self.displays)
            if last or (k in steady and not self.displays[k].inline):
                end = len(self.formulas) if last else self.found[k]
                free = [
                    j
                    for j in range(start, end)
                    if j not in self.taken and self.formulas[j].inline == inline
                ]
                for display, formula in self._align(waiting, free, least):
                    self.take(display, formula)
                start, waiting = end + 1, []
            elif k not in self.found and self.displays[k].inline == inline:
                waiting.append(k)

    def _align(
        self, displays: list[int], formulas: list[int], least: float
    ) -> list[tuple[int, int]]:
        """Pairs in the same order, so much alike at least, whose likeness adds up to the most."""
        if not displays or not formulas:
            return []

        def is_allowed(display: int, formula: int) -> bool:
            return self.alike(display, formula) >= least

        inline = self.displays[displays[0]].inline
        same = len(displays) == len(formulas)
        if same and (not inline or all(map(is_allowed, displays, formulas))):
            return list(zip(displays, formulas, strict=True))
        best: list[list[tuple[float, list[tuple[int, int]]]]] = [
            [(0.0, [])] * (len(formulas) + 1) for _ in range(len(displays) + 1)
        ]
        for i, display in enumerate(displays, 1):
            for j, formula in enumerate(formulas, 1):
                best[i][j] = max(best[i - 1][j], best[i][j - 1], key=lambda entry: entry[0])
                if is_allowed(display, formula):
                    score, pairs = best[i - 1][j - 1]
                    score += self.alike(display, formula) + 0.01
                    if score > best[i][j][0]:
                        best[i][j] = (score, [*pairs, (display, formula)])
        return best[-1][-1][1]

    def in_order(self) -> set[int]:
        """The largest set of displays whose formulas stand in the order of the derivation."""
        ends: list[int] = []
        chains: list[list[int]] = []
        for k in sorted(self.found):
            where = self.found[k]
            size = bisect_left(ends, where)
            chain = [*(chains[size - 1] if size else []), k]
            ends[size : size + 1] = [where]
            chains[size : size + 1] = [chain]
        return set(chains[-1]) if chains else set()
