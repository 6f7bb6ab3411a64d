r"""Deviations from a point, as :math:`\xi` in :math:`x=x_0+\xi`, and where their linear part is."""

from __future__ import annotations

import re

from kowalevski_cas.notation import Name, Number, Sum, substitute
from kowalevski_cas.notation.symbol import rate_name
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.degrees import degrees
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.sets import SetOfEquations
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

_FURTHER = re.compile(
    r"\b(?:second|third|higher|quadratic|cubic)\b|\b(?:втор|трет|высш|квадратичн|кубическ)\w*",
    re.IGNORECASE,
)
_LEFT_OUT = re.compile(
    r"\b(?:neglect|omit|drop|ignor|discard)\w*|\b(?:пренебре|отбр)\w*", re.IGNORECASE
)
"""Words for orders beyond the first, and for what is left out."""


def is_linear_in_deviations(item: SourceStatement, known: Known) -> bool:
    """Whether words speak of a linear part, or of what is near, and a linear rate is printed."""
    start = max(item.paragraph, item.section.start)
    words = known.paper.prose.between(start, item.typed.start)
    said = cue("linear part", words) or cue("linear", words) or cue("place", words)
    return bool(said) and _law(item, known) is not None


def at_no_deviation(item: SourceStatement, last: SetOfEquations, known: Known) -> SetOfEquations:
    """The equations of the point from which what a statement derives deviates.

    Of what has no deviation, what was said ``last`` gives the value; there are none if a value is
    not known, or the statement is not linear in what deviates.
    """
    law = _law(item, known)
    if law is None or law.base is None:
        return ()
    elsewhere = (one for one in last if one.order > law.change[-1].order)
    if any(_is_of_other_place(one, row, law) for one in elsewhere for row in law.change):
        return ()
    others = {*law.variables} - {*law.new}
    own = tuple(one for one in last if {*one.bare} & others)
    given = {name for one in own for name in one.bare} & others
    small = {name for name in others - given if _is_called_small(name, item, known)}
    if given | small != others:
        return ()
    orders = law.base.orders
    deviating = {name: one for one in law.change for name in one.bare[:1]}
    second = [
        new
        for name, one in deviating.items()
        if orders.get(name, 0) > 1
        for new in one.names & {*law.new}
    ] + [name for name in others if orders.get(name, 0) > 1]
    zero = [*law.new, *sorted(small), *map(rate_name, sorted(second))]
    about = (
        unprinted(known.paper, f"no-deviation-{k}", f"{name}=0", item)
        for k, name in enumerate(zero)
    )
    return (*own, *about)


def _is_called_small(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether the sentence prints a letter by itself, and leaves out what is not linear in it."""
    beside = known.of_sentence(item.sentence)
    named = any(one.formula == Name(name) and _IN.search(one.lead) for one in beside)
    return named and bool(cue("linear", item.before))


_IN = re.compile(r"(?:\bin|\bsmall|\band|^[\s,]*|\bпо|\bи|\bмал\w+)[\s~]*$", re.IGNORECASE)
"""How words end behind which stands a letter in which something is linear, or small."""


def _is_of_other_place(one: SourceStatement, row: SourceStatement, law: Law) -> bool:
    """Whether a statement gives something else than that from which a change deviates."""
    if one.bare[:1] != row.bare[:1]:
        return False
    still = substitute(row.members[1], {name: Number(0) for name in law.new})
    terms = [term for term in still.terms if term != Number(0)] if isinstance(still, Sum) else []
    return len(terms) != 1 or terms[0] not in one.members


def _law(item: SourceStatement, known: Known) -> Law | None:
    """The law of the deviations in which a statement gives a rate, linear in them."""
    words = known.paper.prose.between(item.section.start, item.sentence[1])
    if not (item.rates and item.members) or (
        _FURTHER.search(words) and not _LEFT_OUT.search(words)
    ):
        return None
    display = [one for one in known.of_sentence(item.sentence) if one.typed is item.typed]
    named = {name for one in display for name in (*one.names, *one.rates)}
    for law in known.laws:
        mine = {*item.rates} <= {*law.variables} and named & {*law.new}
        if mine and law.change and all(_deviates(one, law, known) for one in law.change):
            linear = all(degrees(member, known) <= {0, 1} for member in item.members)
            return law if linear else None
    return None


def _deviates(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether a statement gives what moves by constants and one new name, of the first degree."""
    given = item.members[1]
    new = given.names() & {*law.new}
    return (
        known.varying(given.names()) == [*new] and len(new) == 1 and degrees(given, known) <= {0, 1}
    )
