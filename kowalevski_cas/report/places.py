"""The displays and claims of a derivation in the order of the paper, with what was decided."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import groupby

from kowalevski_cas.audit.roles import Roles
from kowalevski_cas.notation import Formula, NotationError
from kowalevski_cas.paper import derivation as paper
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.verify.outcome import Outcome, Run


@dataclass(frozen=True)
class Row:
    """A statement of a display, with the claims that are about it alone."""

    formulas: tuple[Formula, ...]
    source: str
    outcomes: tuple[Outcome, ...] = ()


@dataclass(frozen=True)
class Item:
    """A display with the claims about it, or a claim about none, which has no rows.

    ``label`` is the number of the equation and ``display`` the name of what is displayed;
    ``outcomes`` are about the whole; ``role`` says what a display is for that nobody claims, and
    ``source`` where one comes from that the paper does not print.
    """

    rows: tuple[Row, ...] = ()
    outcomes: tuple[Outcome, ...] = ()
    label: str = ""
    role: str = ""
    display: str = ""
    source: str = ""

    @property
    def all(self) -> tuple[Outcome, ...]:
        """The claims about the display and about its rows."""
        return (*(o for row in self.rows for o in row.outcomes), *self.outcomes)

    def names(self) -> Iterator[tuple[str, str]]:
        """The claims that have the number of an equation for a name."""
        if not self.label:
            return
        for number, row in enumerate(self.rows, 1):
            own = f"{self.label[:-1]}.{number})" if len(self.rows) > 1 else self.label
            if row.outcomes:
                yield row.outcomes[0].claim, own
        if self.outcomes and not any(row.outcomes for row in self.rows):
            yield self.outcomes[0].claim, self.label


@dataclass(frozen=True)
class Section:
    """A section of the paper; ``copied`` says whether its formulas are those of the print."""

    number: str
    title: str
    items: tuple[Item, ...]
    copied: bool = True

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """What was decided in the section."""
        return tuple(outcome for item in self.items for outcome in item.all)


@dataclass
class _Place:
    """A display, and what is to be said at it and after it."""

    rows: dict[int, list[Outcome]] = field(default_factory=dict)
    whole: list[Outcome] = field(default_factory=list)
    after: list[tuple[Display | None, Outcome]] = field(default_factory=list)


def sections(run: Run, derivation: paper.Derivation, texts: Texts) -> tuple[Section, ...]:
    """The sections of a paper that state something, each in the order of its displays.

    A claim stands at the display that it is about; one about none follows what it mentions.
    """
    roles = Roles(derivation)
    outcomes = {outcome.claim: outcome for outcome in run.outcomes}
    found = []
    for section in derivation.sections:
        items = tuple(_items(section, outcomes, texts, roles))
        if any(item.all for item in items):
            found.append(Section(section.number, section.title, items, section.copied))
    return tuple(found)


def names(sections: Sequence[Section]) -> dict[str, str]:
    """The claims that are called by the numbers of equations."""
    return {c: name for section in sections for item in section.items for c, name in item.names()}


def _items(
    section: paper.Section, outcomes: dict[str, Outcome], texts: Texts, roles: Roles
) -> Iterator[Item]:
    order = {display: k for k, display in enumerate(section.displays)}
    places = [_Place() for _ in range(len(order) + 1)]  # the last one stands before all displays
    last = -1
    for claim in section.claims:
        if claim.id not in outcomes:
            continue
        mentioned = [order[p.display] for p in claim.places() if p.display in order]
        home = _home(claim)
        if home in order:
            place, outcome = places[order[home]], outcomes[claim.id]
            at = place.whole if claim.printed is None else _row(place, claim.printed)
            at.append(outcome)
            last = max(last, order[home])
        else:
            last = max([last, *mentioned])
            places[last].after.append((home if claim.printed else None, outcomes[claim.id]))
    yield from _apart(places[-1].after)
    for display, place in zip(section.displays, places, strict=False):
        yield _displayed(display, place, texts, roles)
        yield from _apart(place.after)


def _apart(claims: Sequence[tuple[Display | None, Outcome]]) -> Iterator[Item]:
    """Claims about no display of the section: those about one of another section together."""
    for display, ones in groupby(claims, lambda pair: pair[0]):
        outcomes = [outcome for _, outcome in ones]
        if display is None or len(outcomes) == 1:
            yield from (Item(outcomes=(outcome,)) for outcome in outcomes)
        else:
            yield Item(tuple(Row(o.formulas, o.source, (o,)) for o in outcomes))


def _home(claim: Claim) -> Display | None:
    """The display that a claim is about, if it is one."""
    if claim.printed is not None:
        return claim.printed.display
    displays = {printed.display for printed in claim.establishes()}
    return displays.pop() if len(displays) == 1 else None


def _row(place: _Place, printed: Printed) -> list[Outcome]:
    return place.rows.setdefault(printed.number, [])


def _displayed(display: Display, place: _Place, texts: Texts, roles: Roles) -> Item:
    role = roles.at(Printed(display, 1).place).name
    try:
        statements = texts.statements(display)
    except NotationError:
        own = tuple(outcome for row in place.rows.values() for outcome in row)
        row = Row((), texts.source(display), own)
        return Item((row,), tuple(place.whole), display.label, role, display.id, display.source)
    rows = tuple(
        Row((one.formula,), one.source, tuple(place.rows.get(number, ())))
        for number, one in enumerate(statements, 1)
    )
    return Item(rows, tuple(place.whole), display.label, role, display.id, display.source)
