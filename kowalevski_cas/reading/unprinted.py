"""Statements that a paper does not print: conventions, and what a Hamiltonian implies."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import Name, NotationError, Number, PoissonBracket, Power, read
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.implied import (
    HAMILTONIANS,
    LAGRANGIANS,
    conjugate_pairs,
    implied_equations,
    lagrange,
)
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.reading.cues import cue, force_told
from kowalevski_cas.reading.rows import is_row
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, is_closing
from kowalevski_cas.reading.two_energies import has_squares_of_rates, is_named, two_energies
from kowalevski_cas.source.displays import TypedFormula

SOURCE = "the usual convention"


def unprinted(
    paper: SourcePaper,
    id: str,
    tex: str,
    beside: SourceStatement | None = None,
    source: str = SOURCE,
) -> SourceStatement:
    """A statement that the paper does not print, beside one that it does, or before all."""
    section = beside.printed.display.section if beside else paper.displays[0][0].section
    display = Display(id, tex, section, source=source)
    words = replace(paper.words, functions=paper.words.functions | FUNCTIONS)
    formula = read(tex, words, OpenParser)
    start = beside.typed.start if beside is not None else paper.prose.start
    order = beside.order if beside is not None else -1
    return SourceStatement(
        display[1], TypedFormula(tex, start, start, ""), formula, "", order, (start, start),
        "", "", "", "", 0, paper.prose.path(start), None,
    )  # fmt: skip


def is_printed(item: SourceStatement) -> bool:
    """Whether the paper prints a statement."""
    return not item.printed.display.source


def implied_rows(paper: SourcePaper) -> Iterator[SourceStatement]:
    """The equations of motion of the Hamiltonian, or the Lagrangian, that words call so.

    There are none where it is not known what belongs together. Where a paper prints no rates, but
    of what it defines, or uses the letter of a Hamiltonian elsewhere as one, the letters of
    coordinates and momenta say so.
    """
    defined = {name for one in paper.items if not one.derives for name in one.bare}
    still = all({*one.rates} <= defined for one in paper.items)
    for item in paper.items:
        named = item.bare[:1] and item.members[0].names() & {*HAMILTONIANS, *LAGRANGIANS}
        told = still or _is_told_elsewhere(item, paper)
        moves = (
            cue("hamiltonian", item.words)
            or (told and is_of_momenta(item, paper))
            or is_of_velocities(item, paper)
        )
        if not named or not moves:
            continue
        about = [
            item,
            *definitions_below(item, paper),
            *_brackets(paper),
            *filter(is_closing, paper.items),
        ]
        try:
            found = implied_equations([one.formula for one in about if one.formula is not None])
            yield from (
                unprinted(paper, f"implied-{number}", tex, item)
                for number, tex in enumerate(found, 1)
                if not tex.startswith(BRACKET)
            )
        except (ValueError, NotationError):
            continue
        if found:
            return
    yield from _of_two_energies(paper)


_IN_OTHER = re.compile(
    r"\b(?:in|by|through)\s+(?:the\s+|these\s+|our\s+)?(?:\w+\s+){0,2}?(?:coordinates|variables)\b"
    r"|\bв\s+(?:\w+\s+){0,3}?(?:координатах|переменных)\b",
    re.IGNORECASE,
)
"""Words for other coordinates, in which a Hamiltonian is printed anew."""


def hamiltonians_anew(
    paper: SourcePaper,
) -> Iterator[tuple[tuple[int, int], list[SourceStatement]]]:
    """The Hamiltonians that parts of a paper give anew, with these parts and equations of motion.

    In theorem-like parts they are in letters of their own, or each before has its example too;
    other ones are in coordinates of which words speak, with momenta that stand nowhere before.
    """
    given = [one for one in paper.items if one.bare[:1] and one.bare[0] in HAMILTONIANS]
    heads = [one for one in given if len(one.members) == 2 and _canonical(one)]
    for item in heads:
        if item.typed.inline or item in paper.approximate:
            continue
        if item.theorem is None and not _is_in_new_momenta(item, paper):
            continue
        begins, end = item.theorem or (item.typed.start, item.section.end)
        before = [
            one for one in heads if one.bare[:1] == item.bare[:1] and one.typed.start < begins
        ]
        rows = (one for one in paper.items if one.typed.start < begins)
        met = {name for one in rows for name in one.rates}.union(*(one.names for one in before))
        apart = all(one.theorem for one in before) or met.isdisjoint(_canonical(item))
        apart = apart or item.theorem is None
        within = (one for one in heads if begins <= one.typed.start < end)
        if (
            (not before and item.theorem is not None)
            or not apart
            or [*within] != [item]
            or not has_squares_of_momenta(item, paper)
        ):
            continue
        below = (one for one in definitions_below(item, paper) if begins <= one.typed.start < end)
        about = [one.formula for one in (item, *below) if one.formula is not None]
        with suppress(ValueError, NotationError):
            found = [tex for tex in implied_equations(about) if not tex.startswith(BRACKET)]
            yield (
                (begins, end),
                [
                    unprinted(paper, f"implied-{item.order}-{number}", tex, item)
                    for number, tex in enumerate(found, 1)
                ],
            )


def _is_in_new_momenta(item: SourceStatement, paper: SourcePaper) -> bool:
    """Whether words say that a Hamiltonian is in other coordinates, and its momenta are new.

    Where these coordinates are printed before, that it is the one in them is a claim.
    """
    pairs = _canonical(item)
    before = [one for one in paper.items if one.order < item.order]
    changed = any(
        one.bare[:1] and one.bare[0] not in pairs and one.members[-1].names() & {*pairs[::2]}
        for one in before
        if not one.derives and len(one.members) == 2 and one.bare[:1] != item.bare[:1]
    )
    new = all({*pairs[1::2]}.isdisjoint(one.names) for one in before)
    return bool(_IN_OTHER.search(item.before)) and new and not changed


def _of_two_energies(paper: SourcePaper) -> Iterator[SourceStatement]:
    """The equations of Lagrange of a kinetic and a potential energy, if no words tell more."""
    pair = two_energies(paper.items)
    if pair is None or tells_more(paper.prose.text) or _FIELD.search(paper.prose.text):
        return
    kinetic, potential = pair
    if not is_named(potential):
        return
    beside = max(pair, key=lambda one: one.order)
    for number, x in enumerate(kinetic.rates, 1):
        tex = lagrange(kinetic.bare[0], x, potential.bare[0])
        yield unprinted(paper, f"implied-{number}", tex, beside)


def _is_told_elsewhere(item: SourceStatement, paper: SourcePaper) -> bool:
    """Whether the letter that a statement gives stands in a bracket, or words call it so behind."""
    letter = Name(item.bare[0]) if item.bare else None
    return any(
        (isinstance(side, PoissonBracket) and letter in side.children())
        or (one.members[:1] == (letter,) and cue("hamiltonian", one.lead))
        for one in paper.items
        for side in one.members[:1]
    )


def is_of_momenta(item: SourceStatement, paper: SourcePaper) -> bool:
    """Whether a statement gives the letter of a Hamiltonian by squares of momenta with indices."""
    momenta = _canonical(item)[1::2]
    return has_squares_of_momenta(item, paper) and all(symbol(p).index for p in momenta)


def has_squares_of_momenta(item: SourceStatement, paper: SourcePaper) -> bool:
    """Whether a statement gives the letter of a Hamiltonian by squares of momenta.

    Each has its coordinate by its index, in the formula if that is a number, or none. No words of
    the paper tell of forces, constraints or fields, nor deny anything of it.
    """
    if not item.bare or item.bare[0] not in HAMILTONIANS or len(item.members) != 2:
        return False
    if tells_more(paper.prose.text) or cue("denied", item.words) or _FIELD.search(paper.prose.text):
        return False
    nodes, names = [*item.members[1].nodes()], _canonical(item)
    found = [
        Power(Name(p), Number(2)) in nodes
        and (q in item.names or symbol(p).index.strip("0123456789"))
        for q, p in zip(names[::2], names[1::2], strict=True)
    ]
    return bool(found) and all(found)


def is_of_velocities(item: SourceStatement, paper: SourcePaper) -> bool:
    """Whether a statement gives the letter of a Lagrangian, and no displays have all its equations.

    No words tell of forces, or deny it.
    """
    rows = [one for one in paper.items if is_row(one) and not one.typed.inline]
    accelerated = {name for one in rows for name, order in one.rates.items() if order > 1}
    defined = {name for one in paper.items if not one.derives for name in one.bare}
    follows = defined | ({*item.rates} if accelerated & {*item.rates} else set())
    first = (one for one in rows if {*one.rates.values()} == {1})
    if any(not {*one.rates} <= follows for one in first) or {*item.rates} <= accelerated:
        return False
    told = tells_more(paper.prose.text) or cue("denied", item.words)
    return gives_lagrangian(item) and not told


def tells_more(words: str) -> bool:
    """Whether words tell forces, constraints or rolling: there is more than energies then."""
    return bool(force_told(words) or cue("constraint", words) or cue("rolling", words))


_NAMED = re.compile(
    r"\b(?:is|equals|be|function\w*|length|momentum|operator|form)[\s~:]*$|\blyapunov"
    r"|\b(?:функци|длин|момент|форм)\w*[\s~:—-]*$|\bляпунов|\bравн\w+[\s~:]*$",
    re.IGNORECASE,
)
"""How words end that say what a letter is: it may be no Lagrangian then."""


def gives_lagrangian(item: SourceStatement) -> bool:
    """Whether a statement gives the letter of a Lagrangian by squares of rates."""
    if not item.bare or item.bare[0] not in LAGRANGIANS or len(item.members) != 2:
        return False
    return has_squares_of_rates(item) and not _NAMED.search(item.before)


_FIELD = re.compile(
    r"\b(?:magnet|gyroscop|gyrostat|non-?(?:holonom|canonic)|rotat|gradient|quantum|dissip|damp|drag"
    r"|not\s+(?:\w+\s+){0,3}(?:Hamilton|canonical)"
    r"|магнит|гироскоп|неголоном|враща)",
    re.IGNORECASE,
)
"""Words for what acts, and may be no part of a Hamiltonian in these letters."""


def definitions_below(item: SourceStatement, paper: SourcePaper) -> Iterator[SourceStatement]:
    """What defines the names in a statement, but for its own, and for what moves by name.

    What gives an old coordinate by new ones, behind the Hamiltonian, defines none.
    """
    names, waiting = {*item.bare, *_canonical(item)}, [item]
    while waiting:
        new = waiting.pop().names - names
        names |= new
        heads = ((one, one.members[:1]) for one in paper.items if one.order != item.order)
        found = [one for one, first in heads if first and {*first} & {*map(Name, new)}]
        yield from found
        waiting += found


def _canonical(item: SourceStatement) -> list[str]:
    """The momenta in a statement with their coordinates, if these are known by their names."""
    with suppress(ValueError):
        return [name for pair in conjugate_pairs(sorted(item.names)) for name in pair]
    return []


def _brackets(paper: SourcePaper) -> Iterator[SourceStatement]:
    """The brackets that a paper prints of names which it does not define."""
    first = (item.members[0] for item in paper.items if item.members and not is_closing(item))
    defined = {member.name for member in first if isinstance(member, Name)}
    vectors = {symbol(name).letter for name in defined if symbol(name).is_bold}
    for item in paper.items:
        if item.members and isinstance(bracket := item.members[0], PoissonBracket):
            names = bracket.names()
            if names.isdisjoint(defined) and not {symbol(n).letter for n in names} & vectors:
                yield item
