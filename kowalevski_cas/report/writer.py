"""What the report in every format is written with: words, formulas, points, links."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from kowalevski_cas.notation import Formula, Number, Relation, print_prose, read_prose
from kowalevski_cas.report.context import Report
from kowalevski_cas.report.marks import MARKS
from kowalevski_cas.report.names import anchor
from kowalevski_cas.report.plates import Plate
from kowalevski_cas.report.sentences import listed, number
from kowalevski_cas.report.setting import Setter
from kowalevski_cas.verify.outcome import Condition, Outcome, Point, Value, Verdict

_TEMPLATES: Final = Path(__file__).parent / "templates"
_FILTERS: Final = (
    "words", "sentence", "property", "formula", "value", "display", "cell", "nonzero", "printed",
    "printed_cell", "point", "condition", "link", "links", "thousands", "label", "column",
    "picture", "short",
)  # fmt: skip


class Writer(ABC):
    """Writes a report in a format: its public methods are the filters of the templates."""

    suffix: str
    """The suffix of the templates and of the document."""
    space: str
    """A space between the thousands of a number."""
    setter: Setter

    def __init__(self, report: Report) -> None:
        self.report = report
        self.claims = {outcome.claim for outcome in report.run.outcomes}

    def write(self, plates: Sequence[Plate] = ()) -> str:
        """The document."""
        from jinja2 import Environment, FileSystemLoader, StrictUndefined

        environment = Environment(
            loader=FileSystemLoader(_TEMPLATES),
            block_start_string="((*",
            block_end_string="*))",
            variable_start_string="(((",
            variable_end_string=")))",
            comment_start_string="((=",
            comment_end_string="=))",
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
            keep_trailing_newline=True,
            autoescape=False,
        )
        environment.filters.update({name: getattr(self, name) for name in _FILTERS})
        environment.filters.update(
            listed=listed,
            number=number,
            upfirst=lambda text: text[:1].upper() + text[1:],
        )
        environment.globals.update(MARKS=MARKS, Verdict=Verdict, suffix=self.suffix)
        template = environment.get_template(f"report.{self.suffix}.jinja")
        text = template.render(report=self.report, plates=plates)
        text = re.sub(r"[ \t]+\n", "\n", text)
        return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"

    # What a format has to say

    @abstractmethod
    def escaped(self, text: str) -> str:
        """Plain text."""

    @abstractmethod
    def property(self, text: str) -> str:
        """A text among the properties of the document."""

    @abstractmethod
    def within(self, mathematics: str) -> str:
        """Mathematics within a line."""

    @abstractmethod
    def displayed(self, mathematics: str) -> str:
        """Mathematics on lines of its own."""

    @abstractmethod
    def in_cell(self, mathematics: str) -> str:
        """Mathematics in display style in a cell of a table."""

    @abstractmethod
    def verbatim(self, source: str) -> str:
        """A source as it is typed."""

    @abstractmethod
    def linked(self, claim: str) -> str:
        """The id of a claim of the report, leading to the place where it is treated."""

    @abstractmethod
    def picture(self, report: Report) -> str:
        """The picture of which claim rests on which."""

    # Words

    def words(self, text: str) -> str:
        """Words with mathematics between dollars."""
        prose = read_prose(text, self.report.run.vocabulary)
        return print_prose(prose, self.escaped, self.formula)

    def sentence(self, text: str, end: str = ".") -> str:
        """Words that begin with a capital, where they begin with a letter, and come to an end."""
        text = text.strip()
        stop = "" if text.endswith((".", "!", "?", ":")) else end
        return self.words(text[:1].upper() + text[1:]) + stop

    def link(self, claim: str) -> str:
        """A claim's id, with a link if the report treats it."""
        return self.linked(claim) if claim in self.claims else self.verbatim(claim)

    def links(self, claims: Sequence[str]) -> str:
        """Several ids, as a list in words."""
        return listed([self.link(claim) for claim in claims])

    def thousands(self, number: int) -> str:
        """A number with thin spaces between thousands."""
        return f"{number:,}".replace(",", self.space)

    @staticmethod
    def label(text: str) -> str:
        """A name that every format takes for a label."""
        return anchor(text)

    @staticmethod
    def short(text: str, letters: int = 72) -> str:
        """As much of a text as fits in a running head, cut between words."""
        if len(text) <= letters:
            return text
        return text[:letters].rsplit(" ", 1)[0].rstrip(",;:") + " …"

    # Formulas

    def formula(self, formula: Formula) -> str:
        """A formula within a sentence."""
        return self.within(self.setter.inline(formula))

    def value(self, value: Value) -> str:
        """A value within a sentence."""
        return self.escaped(value) if isinstance(value, str) else self.formula(value)

    def nonzero(self, formula: Formula) -> str:
        """That a formula is not zero, within a sentence."""
        return self.formula(Relation((formula, _ZERO), (r"\ne",)))

    def condition(self, condition: Condition) -> str:
        """What a condition says, within a sentence."""
        return self.nonzero(condition.expression)

    def display(self, formulas: Sequence[Formula], room: float) -> str:
        """Formulas of a step, on lines no wider than ``room`` em; a high display is shortened."""
        return self.displayed(self.setter.display(formulas, room, shorten=True))

    def cell(self, formulas: Sequence[Formula], room: float) -> str:
        """Formulas in a cell of a table."""
        return self.in_cell(self.setter.display(formulas, room))

    def printed(self, outcome: Outcome, room: float) -> str:
        """The formulas of a claim, displayed; as they are typed if they cannot be read."""
        if not outcome.formulas:
            return self.verbatim(outcome.source)
        return self.displayed(self.setter.display(outcome.formulas, room))

    def printed_cell(self, outcome: Outcome, room: float) -> str:
        """The formulas of a claim, in a cell."""
        if not outcome.formulas:
            return self.verbatim(outcome.source)
        return self.cell(outcome.formulas, room)

    @staticmethod
    def column(rows: Sequence[Outcome]) -> float:
        """The part of the line that ids and verdicts leave to the formulas in a table of rows."""
        letters = max(1.1 * len(row.claim) + len(row.verdict.value) for row in rows)
        return round(0.92 - 0.0108 * letters, 2)

    def point(self, at: Point) -> str:
        """``At`` and the coordinates of a point, equal ones together, each a formula of its own."""
        equal: dict[Value, list[Formula]] = {}
        for name, value in at.values.items():
            if name != value:
                equal.setdefault(value, []).append(name)
        out = []
        rest = False
        for value, names in equal.items():
            if value == _ZERO and len(equal) > 1 and len(names) > 3:
                rest = True
            elif isinstance(value, str):
                out.append(f"{self.formula(_chain(names))} = {self.escaped(value)}")
            else:
                out.append(self.formula(_chain([*names, value])))
        if rest:
            out.append(f"the other variables {self.formula(_ZERO)}")
        return f"At {', '.join(out)}, " if out else ""


_ZERO: Final = Number(0)


def _chain(members: Sequence[Formula]) -> Formula:
    """An equality of several members."""
    if len(members) == 1:
        return members[0]
    return Relation(tuple(members), ("=",) * (len(members) - 1))
