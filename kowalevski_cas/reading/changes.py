r"""Changes of variables: what moves is given by new names, as :math:`x=r\cos\varphi`.

The equations of motion are then those for the new names, once what is given has been put in: what
is printed as their rates follows, and is claimed.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from kowalevski_cas.notation import Name, Number, Product, Sum, to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.amplitudes import UNIT, conjugate_name, conjugate_of
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.polar import radii
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

CONJUGATE = "the conjugate of what is given by real letters"
"""Where a statement comes from that gives a conjugate."""

_NEAR = re.compile(
    r"\b(?:about|around|near|neighbou?rhood\s+of|вблизи|около|возле|окрестност\w+)\b[^.;:]*$",
    re.IGNORECASE,
)
"""Words behind which a place is printed from which what is given by new names deviates."""


def find_changes(law: Law, items: Sequence[SourceStatement]) -> Iterator[Law]:
    """The law in the new names by which sentences behind it give some of its variables.

    There are as many new names as variables that are given: else it is a set that they describe.
    Momenta that are given by new ones and by new coordinates before them are changed with these.
    """
    found: list[Law] = []
    seen = {*law.mentions, *law.variables, PI}
    for item in items:
        if item.order <= law.order:  # what implies it stands beside it
            seen |= item.names
    later = [one for one in items if one.order > law.order]
    rated = {*law.names.scalars(name for one in later for name in one.rates)}
    for _, group in groupby(later, key=lambda one: one.sentence):
        sentence = [*group]
        before = [one for one in items if one.order < sentence[0].order]
        lengths = radii(before, law)
        given_by_old = _resting(before, {*law.variables}) - lengths
        giving = [
            one
            for one in sentence
            if _gives(one, law, seen - lengths)
            and not gives_factor(one, law, rated)
            and given_by_old.isdisjoint(one.members[1].names())
        ]
        renaming = [one for one in sentence if _renames(one, law, seen, rated)]
        beside = (one for one in sentence if one not in giving and one not in renaming)
        values = (
            one
            for one in beside
            if not (_NEAR.search(one.before) or one.is_const or _is_place(one, giving))
        )
        other = {name for one in values for name in one.bare}
        giving = [one for one in giving if other.isdisjoint(one.bare)]  # else these are values
        if giving:  # beside these a new letter may stand for a variable as it is
            giving += renaming
        given = {name for one in giving for name in _names(one, law)}
        new = dict.fromkeys(
            part
            for one in giving
            for name in sorted(one.names)
            if name not in (seen | other) - lengths | {"t"}
            for part in law.names.scalars([name])
        )
        timed = any("t" in one.names for one in giving)  # else it is a solution
        for names in ([] if timed else [*new], [name for name in new if name in rated]):
            own = giving if len(names) == len(given) else _on_a_set(giving, names)
            if own and {*names} - lengths:  # a length alone is given before
                by = {name for one in own for name in one.members[1].names()}
                first = next((one for one in reversed(found) if by & {*one.new}), None)
                more = first is not None and {*first.given}.isdisjoint(given)
                change, old = (first.change, first.new) if first and more else ((), ())
                found.append(
                    Law((), law.names, base=law, change=(*change, *own), new=(*old, *names))
                )
                yield found[-1]
                break
        for one in sentence:
            seen |= one.names


def _is_place(item: SourceStatement, giving: Sequence[SourceStatement]) -> bool:
    """Whether a value is the place from which what is given deviates, as x=1 beside x=1+ξ."""
    return any(
        one.members[0] == item.members[0]
        and isinstance(one.members[1], Sum)
        and item.members[1] in one.members[1].terms
        for one in giving
        if len(item.members) == 2
    )


def conjugates_given(
    law: Law, items: Sequence[SourceStatement], paper: SourcePaper
) -> Iterator[SourceStatement]:
    r"""The conjugates of what gives complex variables by new letters, which are real.

    So beside :math:`a=re^{i\varphi}` stands :math:`a^*=re^{-i\varphi}`.
    """
    moving = {*law.variables}
    given = {name for one in items for name in one.bare[:1]}
    for item in items:
        name = item.bare[0] if item.bare and len(item.members) == 2 else ""
        other = conjugate_name(name) if name in moving else ""
        if other not in moving or other in given or UNIT not in item.names:
            continue
        left, right = item.members
        if left == Name(name) and not item.derives and right.names().isdisjoint(moving):
            tex = f"{other}={to_latex(conjugate_of(right, moving))}"
            id = f"conjugate-{item.order}-{item.printed.number}"
            yield replace(unprinted(paper, id, tex, item, CONJUGATE), sentence=item.sentence)


def _on_a_set(giving: Sequence[SourceStatement], names: Sequence[str]) -> list[SourceStatement]:
    r"""As many of the statements as there are new names, where each gives a variable by all these.

    So :math:`\gamma_1=\cos\theta` is one, and :math:`\gamma_2=-\sin\theta` beside it says on
    which set the motion is. Words have to introduce the names: else they describe a set.
    """
    having = all({*names} <= one.members[1].names() for one in giving)
    new = having and len(giving) > len(names) and cue("define", giving[0].before)
    return [*giving[: len(names)]] if new else []


def gives_factor(item: SourceStatement, law: Law, rated: Collection[str]) -> bool:
    r"""Whether a component is a product of that of another vector in its law, and of constants.

    So :math:`M_i=I_i\Omega_i` says what :math:`\Omega_i` is, if no rates of it are printed. What is
    no vector of three may be a length, as in :math:`x=l\theta`.
    """
    match item.members:
        case (Name(moving), Product(factors)) if all(isinstance(one, Name) for one in factors):
            own, every = item.members[1].names(), {*law.names.scalars(law.mentions)}
            mentioned = own & every - {*law.variables}
            vectors = {*_components(moving)} <= {*law.variables} and all(
                symbol(name).index == symbol(moving).index and {*_components(name)} <= every
                for name in mentioned
            )
            return vectors and len(mentioned) == 1 and own.isdisjoint(rated)
    return False


def _components(name: str) -> Iterator[str]:
    """The names with one letter and the indices of a vector of three."""
    parts = symbol(name)
    numbers = ("1", "2", "3") if parts.index in ("1", "2", "3") else ("x", "y", "z")
    yield from (replace(parts, index=one).name for one in numbers)


def _resting(items: Sequence[SourceStatement], moving: set[str]) -> set[str]:
    """The names that statements give by what moves, or by such names."""
    found: set[str] = set()
    for one in items:
        if one.bare and one.bare[0] not in moving and one.members[0] == Name(one.bare[0]):
            rest = one.names - {one.bare[0]}
            found |= {one.bare[0]} if rest & (moving | found) else set()
    return found


def _names(item: SourceStatement, law: Law) -> tuple[str, ...]:
    """The variables that stand alone on the left of a statement."""
    return law.names.scalars(item.bare[:1])


def _renames(item: SourceStatement, law: Law, seen: set[str], rated: set[str]) -> bool:
    """Whether a statement has a new letter for a variable of a law, of which a rate is printed."""
    match item.members:
        case (Name(), Name(new)):
            return bool(_names(item, law)) and new in rated - seen and item.bare[0] in law.variables
    return False


def _gives(item: SourceStatement, law: Law, seen: set[str]) -> bool:
    """Whether a statement gives variables of a law by names that are not all known."""
    if len(item.members) != 2 or item.derives or not item.bare:
        return False
    left, right = item.members
    if left != Name(item.bare[0]) or isinstance(right, Name | Number):
        return False
    old = {*law.names.scalars(right.names())} & {*law.variables}
    return not old and {*_names(item, law)} <= {*law.variables} and bool(right.names() - seen)
