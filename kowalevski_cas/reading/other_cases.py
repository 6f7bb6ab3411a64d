"""Rates that words set up for another case: what stands behind them may be meant of that one.

Rates of what moves that hold by the law follow from it. Where they do not, and words speak of a
case, of what is added, or of what the equation becomes, they may be another law, to the end of
their section: what is said there of motions can be read in two ways.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    EverywhereIndependent,
    Identity,
    Implication,
    Independence,
    Inequality,
    Involution,
)
from kowalevski_cas.processes import each
from kowalevski_cas.reading.choice import may_hold
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.given_anew import GIVEN_ANEW
from kowalevski_cas.reading.known import CLAIM, MORE, UNREAD, Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.phrases import joined_lead
from kowalevski_cas.reading.restated import orders_of, times_of
from kowalevski_cas.reading.rows import highest_order, is_row
from kowalevski_cas.reading.rung import Rung
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.verify.interpretation import Interpretation

OTHERWISE = (
    "${}$ (line {}) does not hold by the equations of motion: it may be another law, and this "
    "may be said of it; print all equations of that law in a display"
)
ANOTHER_FUNCTION = (
    "${}$ (line {}) gives a function of the law once more: this is said of another law; print its "
    "equations of motion in a display"
)
NOT_CLAIMED = ("denied", "excepted", "quoted", "asked", MORE)
"""The kinds of what is printed and not claimed as it is."""
_RATE = re.compile(r"\\d{1,4}ot(?![A-Za-z])[^=]*=|\\frac\s*\{\\?(?:mathrm\s*)?\{?d[^=]*=")
"""A printed rate."""
_SUPPOSED = re.compile(
    r"\b(?:now|here|if|when|with|under|suppose|let|consider|take|assume"
    r"|теперь|здесь|если|когда|при|пусть|рассмотрим|предположим)\b"
    r"(?!\s+(?:respect|this|th[eo]se|the\s+(?:help|notation)|этом|\(?\\))[^§]*$",
    re.IGNORECASE,
)
"""How words end that suppose something without a formula, right before what then is so."""
_OF_THIS = re.compile(
    r"\bits\b|\b(?:this|the)\s+(?:linear(?:i[sz]ed)?|approximate|simplified)\s+(?:equations?|system|oscillator|model)"
    r"|\bthis\s+(?:equation|system)|\b(?:его|её)\b|\bэт(?:о|ого)\s+уравнени\w+|\bлинейн\w+\s+(?:уравнени|систем)\w+",
    re.IGNORECASE,
)
"""Words for the equation that was spoken of last."""
_BY_ALGEBRA = (
    Casimir, EverywhereIndependent, Identity, Implication, Independence, Inequality, Involution,
)  # fmt: skip
"""What says nothing of motions, if nothing is derived there."""


class OtherCases:
    """The rates of a paper that may be laws of other cases, and what stands behind them.

    So are those that words set up in more variables, if the law before does not follow from them:
    ``again`` has the claims that it does, by the first of these rates.
    """

    def __init__(
        self,
        parts: Parts,
        candidates: Mapping[SourceStatement, Sequence[Rung]],
        again: Mapping[SourceStatement, Sequence[Rung]],
        interpretation: Interpretation,
    ) -> None:
        self.parts = parts
        candidates = {**candidates, **again}
        asked = [one for one in parts.roles if self._is_asked(one, candidates.get(one, ()))]
        asked += again

        def fails(place: int) -> bool:
            rungs = [one for one in candidates.get(asked[place], ()) if not one.elsewhere]
            held = (may_hold(one, interpretation.on(one.claim)) for one in rungs)
            return not (rungs and all(held) if asked[place] in again else any(held))

        found = each(fails, range(len(asked)), late=lambda _: False)
        self.rows = [row for row, failing in zip(asked, found, strict=True) if failing]
        self.anew = [one for one, role in parts.roles.items() if role.kind == GIVEN_ANEW]

    def _is_asked(self, item: SourceStatement, rungs: Sequence[Rung]) -> bool:
        """Whether a statement gives rates of what moves, and words set up another case for it."""
        role, known = self.parts.roles[item], self.parts.of(item)
        start = max(item.paragraph, item.section.start)
        force = cue(
            "force",
            f"{item.sections[-1].title} {known.paper.prose.between(start, item.sentence[1])}",
        )
        if role.name == UNREAD or role.kind in NOT_CLAIMED or (role.name == CLAIM and not rungs):
            return bool(force) and _RATE.search(item.typed.tex) is not None
        gives = is_row(item) or _is_of_equal_rates(item)
        if role.name != CLAIM or not gives or not _is_whole(item, known):
            return False
        if not force and _restates(item):
            return False
        before = item.earlier[0] if item.earlier else ""
        words = f"{item.sections[-1].title} {before} {item.words}"
        if len(item.rates) > 1 and min(item.rates.values()) == 1:
            return False  # it may be a constraint
        case = bool(cue("another case", words) or cue("system", joined_lead(item))) or any(
            map(_SUPPOSED.search, (item.lead, before))
        )
        case = case or self._law_behind(item) is not None
        return bool(force) or (role.kind != "approximate" and case)

    def _law_behind(self, row: SourceStatement) -> Law | None:
        """The law behind a row for what it moves, if there is none before it."""
        known = self.parts.of(row)
        rated = {*known.names.scalars(row.rates)}
        laws = [law for law in known.laws if rated & {*law.variables} and not law.images]
        behind = bool(laws) and all(row.order < law.first.order for law in laws)
        return min(laws, key=lambda law: law.first.order) if behind else None

    def otherwise(self, item: SourceStatement, start: int, claim: Claim) -> str:
        """Why a claim at a place of the text may be meant of another law; empty if it is not."""
        known = self.parts.of(item)
        if any(item in one.items for law in known.laws for one in law.again):
            return ""
        defining = (
            one
            for name in item.names
            for inner in known.below(name)
            for one in known.definitions.get(inner, ())
        )
        derives = item.derives or any(one.derives for one in defining)
        for row in self.anew if derives or known.varying(item.names) else ():
            if row.typed is not item.typed and self._reaches(row, start):
                return self._told(ANOTHER_FUNCTION, row)
        if isinstance(claim, _BY_ALGEBRA) and not derives:
            return ""
        moving = {*claim.scene.variables}
        for row in (*self.rows, *self._approximate(item, start)):
            rated = {*known.names.scalars(row.rates)}
            reached = row.typed is not item.typed and self._reaches(row, start)
            if reached and (rated & moving or row.formula is None):
                return self._told(OTHERWISE, row)
        return ""

    def _told(self, why: str, row: SourceStatement) -> str:
        """A reason, with a row and its line."""
        line = self.parts.paper.lines.get(row.printed.display.id, 0)
        return why.format(row.typed.tex.strip(" ."), line)

    def _approximate(self, item: SourceStatement, start: int) -> list[SourceStatement]:
        """The last equation before a place that holds approximately, if words speak of its motions.

        It stands in the paragraph, or alone in the section, and is no law by itself.
        """
        approximate = item in self.parts.paper.approximate
        if approximate or not _OF_THIS.search(item.before):
            return []
        laws = self.parts.of(item).laws
        before = [
            one
            for one in self.parts.paper.approximate
            if one.derives and one.typed.start < start and one.section is item.section
            and one.sentence != item.sentence  # else they are equations of one system
            and not any(one in law.items for law in laws)
        ]  # fmt: skip
        return [max(before, key=lambda one: one.order)] if before else []

    def _reaches(self, row: SourceStatement, start: int) -> bool:
        """Whether a place stands beside a row, or behind it, in its section, or in its footnote.

        A row before the law reaches to it.
        """
        headed = [one for one in row.sections if not one.is_run_in]
        footnote = self.parts.paper.prose.footnote(row.typed.start)
        end = footnote[1] if footnote is not None else headed[-1].end
        if law := self._law_behind(row):
            end = min(end, law.first.typed.start)
        return row.sentence[0] <= start < end


def _restates(item: SourceStatement) -> bool:
    """Whether the words right before rates only print the law once more, as in components.

    One that fails is a misprint then: no other case is set up.
    """
    words = joined_lead(item)
    if cue("another case", words) or _OTHERS.search(words):
        return False
    supposing = map(_SUPPOSED.search, (item.lead, words))
    return bool(cue("restated", words) or (cue("that is", words) and not any(supposing)))


_OTHERS = re.compile(
    r"§|\b(?:without|instead|modified|perturb\w+|other|another|new|case|model|torque|control\w*)\b"
    r"|\b(?:без|вместо|друг\w+|нов\w+|случа\w+|модел\w+|возмущ\w+|управл\w+)",
    re.IGNORECASE,
)
"""Words for what may be another law, also in components."""


def _is_of_equal_rates(item: SourceStatement) -> bool:
    r"""Whether a chain gives several rates one value, as :math:`\ddot x=\ddot y=0`."""
    orders = [highest_order(member) for member in item.members]
    return len(orders) > 2 and all(orders[:-1]) and not orders[-1]


def _is_whole(item: SourceStatement, known: Known) -> bool:
    """Whether a statement gives rates as a law does: as high as there, by the same time."""
    own = orders_of((item,), known.names)
    for law in known.laws:
        orders = orders_of(law.rows, law.names)
        if own.keys() <= orders.keys() and times_of((item,)) <= times_of(law.rows):
            return all(order >= orders[name] for name, order in own.items())
    return False
