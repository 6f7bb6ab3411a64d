"""The displays and claims of a derivation in the order of the paper, with what was decided."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import count, groupby, zip_longest
from typing import NamedTuple

from kowalevski_cas.audit.roles import Roles
from kowalevski_cas.notation import Formula, NotationError, split_display
from kowalevski_cas.paper import derivation as paper
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import IN_WORDS, Display, Printed, Texts
from kowalevski_cas.report.document import anchor
from kowalevski_cas.verify.outcome import Outcome, Run


class Row(NamedTuple):
    """What stands on a line, its formulas for who asks, and the claim that is about them."""

    source: str
    read: Callable[[], tuple[Formula, ...]]
    outcome: Outcome | None = None

    @classmethod
    def of(cls, outcome: Outcome) -> Row:
        """The formulas of a claim."""
        return cls(outcome.source, lambda: outcome.formulas, outcome)

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """The formulas; none, if they cannot be read."""
        with suppress(NotationError):
            return self.read()
        return ()


class ClaimGroup(NamedTuple):
    """Claims that stand together: a single one, or those of the formulas of one display.

    ``number`` is that of the equation, or else the report's own; ``near`` then says where the paper
    prints it.
    """

    rows: tuple[Row, ...]
    number: str = ""
    near: str = ""

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """The claims."""
        return tuple(row.outcome for row in self.rows if row.outcome)


class ClaimName(NamedTuple):
    """What a claim is called: by the number where it stands, and by its own place among several."""

    number: str
    near: str = ""
    place: int = 0
    several: int = 1


class ReportItem(NamedTuple):
    """A display with the claims about it, or claims about none, which has no formulas.

    ``label`` is the number of the equation and ``display`` the name of what is displayed; ``role``
    says what a display is for that nobody claims, and ``source`` where one comes from that the
    paper does not print.
    """

    rows: tuple[Row, ...] = ()
    stated: tuple[ClaimGroup, ...] = ()
    label: str = ""
    role: str = ""
    display: str = ""
    source: str = ""

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """The claims about the display and about its rows."""
        return tuple(outcome for group in self.stated for outcome in group.outcomes)

    @property
    def anchor(self) -> str:
        """Where a reference to the display leads."""
        if self.outcomes:
            return f"claim.{anchor(self.outcomes[0].claim)}"
        return f"display.{anchor(self.display)}" if self.display else ""


class PaperSection(NamedTuple):
    """A section of the paper; ``copied`` says whether its formulas are those of a print, if any."""

    number: str
    title: str
    items: tuple[ReportItem, ...]
    copied: bool | None = True

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """What was decided in the section."""
        return tuple(outcome for item in self.items for outcome in item.outcomes)


class _DisplayPlace:
    """A display, and what is to be said at it and after it."""

    def __init__(self) -> None:
        self.rows: dict[int, list[Outcome]] = {}
        self.whole: list[Outcome] = []
        self.after: list[tuple[Display | None, Outcome]] = []


def sections(
    run: Run, derivation: paper.Derivation, texts: Texts, every: bool = False
) -> tuple[PaperSection, ...]:
    """The sections of a paper that state something, or all, each in the order of its displays.

    A claim stands at the display that it is about; one about none follows what it mentions.
    """
    roles = Roles(derivation)
    outcomes = {outcome.claim: outcome for outcome in run.outcomes}
    found = []
    for section in derivation.sections:
        items = tuple(_items(section, outcomes, texts, roles))
        if every or any(item.stated for item in items):
            items = number_items(section.number, items)
            found.append(PaperSection(section.number, section.title, items, section.copied))
    return tuple(found)


def number_items(section: str, items: Sequence[ReportItem]) -> tuple[ReportItem, ...]:
    """The items of a section, with a number for all that is stated."""
    numbers, before, found = count(1), "", []
    for item, after in zip_longest(items, items[1:]):
        stated = []
        for k, group in enumerate(item.stated):
            if item.label and not k:
                stated.append(group._replace(number=item.label))
                continue
            near = f"before {after.label}" if after and after.label else before
            number = f"{section}.{next(numbers)}"
            stated.append(group._replace(number=number, near=near if item.display else ""))
        found.append(item._replace(stated=tuple(stated)))
        before = f"after {item.label}" if item.label else before
    return tuple(found)


def numbered(sections: Sequence[PaperSection], numbers: Mapping[str, str]) -> list[PaperSection]:
    """The sections, where displays have these numbers, by their names, and no others."""
    return [
        section._replace(
            items=number_items(
                section.number,
                [
                    item._replace(label=numbers.get(item.display, ""))
                    for item in section.items
                ],
            )
        )
        for section in sections
    ]  # fmt: skip


def names(sections: Sequence[PaperSection]) -> dict[str, ClaimName]:
    """What the claims are called."""
    stated = [group for section in sections for item in section.items for group in item.stated]
    return {
        row.outcome.claim: ClaimName(
            group.number, group.near, place if len(group.rows) > 1 else 0, len(group.outcomes)
        )
        for group in stated
        for place, row in enumerate(group.rows, 1)
        if row.outcome
    }


def labels(sections: Sequence[PaperSection]) -> dict[str, str]:
    """Where the numbers of equations lead."""
    items = (item for section in sections for item in section.items)
    return {item.label: item.anchor for item in items if item.label}


def displays(sections: Sequence[PaperSection]) -> dict[str, str]:
    """The numbers of displays, by their names."""
    return {item.display: item.label for s in sections for item in s.items if item.display}


def _items(
    section: paper.Section, outcomes: dict[str, Outcome], texts: Texts, roles: Roles
) -> Iterator[ReportItem]:
    order = {display: k for k, display in enumerate(section.displays)}
    places = [
        _DisplayPlace() for _ in range(len(order) + 1)
    ]  # the last one stands before all displays
    last = -1
    for claim in section.claims:
        if claim.id not in outcomes:
            continue
        mentioned = [order[p.display] for p in claim.places() if p.display in order]
        home = _home(claim)
        if home in order:
            place, outcome = places[order[home]], outcomes[claim.id]
            if claim.printed is None:
                place.whole.append(outcome)
            else:
                place.rows.setdefault(claim.printed.number, []).append(outcome)
            last = max(last, order[home])
        else:
            last = max([last, *mentioned])
            places[last].after.append((home if claim.printed else None, outcomes[claim.id]))
    yield from _apart(places[-1].after)
    for display, place in zip(section.displays, places, strict=False):
        item = _displays_of(display, place, texts, roles)
        if item.stated or display.source != IN_WORDS:
            yield item
        yield from _apart(place.after)


def _apart(claims: Sequence[tuple[Display | None, Outcome]]) -> Iterator[ReportItem]:
    """Claims about no display of the section: those about one of another section together."""
    for display, ones in groupby(claims, lambda pair: pair[0]):
        outcomes = [outcome for _, outcome in ones]
        if display is None:
            yield from (
                ReportItem(stated=(ClaimGroup((Row.of(outcome),)),)) for outcome in outcomes
            )
        else:
            yield ReportItem(stated=(ClaimGroup(tuple(map(Row.of, outcomes))),))


def _home(claim: Claim) -> Display | None:
    """The display that a claim is about, if it is one."""
    if claim.printed is not None:
        return claim.printed.display
    displays = {printed.display for printed in claim.establishes()}
    return displays.pop() if len(displays) == 1 else None


def _displays_of(display: Display, place: _DisplayPlace, texts: Texts, roles: Roles) -> ReportItem:
    role = roles.at(Printed(display, 1).place).elsewhere
    source = texts.source(display)
    spans: tuple[tuple[int, int], ...] = ()
    with suppress(NotationError):
        spans = split_display(source)
    places = enumerate(spans or ((0, len(source)),), 1)
    rows = tuple(_row(source[start:end], display[k], texts) for k, (start, end) in places)
    stated = tuple(_claims_of(rows, place))
    return ReportItem(rows, stated, display.label, role, display.id, display.source)


def _row(source: str, printed: Printed, texts: Texts) -> Row:
    return Row(source, lambda: (texts.statement(printed).formula,))


def _claims_of(rows: tuple[Row, ...], place: _DisplayPlace) -> Iterator[ClaimGroup]:
    """What is claimed of the rows, then what else is claimed of them, then of all together."""
    claimed = [place.rows.get(number, []) for number in range(1, len(rows) + 1)]
    claimed[0] += [o for k, ones in place.rows.items() if k > len(rows) for o in ones]
    for k, ones in enumerate(zip_longest(*claimed)):
        shown = [row._replace(outcome=outcome) for row, outcome in zip(rows, ones, strict=True)]
        yield ClaimGroup(tuple(row for row in shown if row.outcome or not k))
    whole = place.whole
    if whole and not any(claimed):
        yield ClaimGroup(
            (Row(rows[0].source, lambda: sum((r.read() for r in rows), ()), whole[0]),)
        )
        whole = whole[1:]
    yield from (ClaimGroup((Row.of(outcome),)) for outcome in whole)
