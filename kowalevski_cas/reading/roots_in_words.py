r"""What words call the roots of an equation for a letter: “x and y are the roots of § = 0”."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from functools import reduce
from itertools import combinations

from kowalevski_cas.algebra.samples import Sample, Valueless, is_zero, precisely
from kowalevski_cas.notation import Formula, Name, Number, Partial, times, to_latex
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, OTHER, UNKNOWNS, Known, StatementRole
from kowalevski_cas.reading.phrases import plain, reach_of_constants
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.tried import variable_of
from kowalevski_cas.reading.unprinted import unprinted

OF_ROOTS = "roots in words"
"""The kind of these claims."""
_ARE_ROOTS = re.compile(
    r"(?P<roots>§(?:[\s,~]*(?:\band|\bor|\bи)?[\s,~]*§)*)[\s,~]+(?:are|is|суть|являются)\s+(?:then\s+|both\s+)?"
    r"(?:(?:the|an?|two|both)\s+)*(?:roots?|корн\w+)\s+(?:of\s+)?(?:(?:the|an?|one|same|\w+)\s+){0,4}?"
    r"(?:equation|polynomial|trinomial|уравнения|многочлена)(?:\s+(?:in|for)\s+§)?[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which the equation is printed of which they name roots."""


_SPOKEN_OF = re.compile(
    r"(?P<letter>§[\s~]*(?:is|denotes|being|есть|[-—–]+)\s+)?(?:(?:the|an?|its|their|one|то\s+есть)\s+)*(?:[\w-]+\s+){0,2}?"
    r"\b(?:roots?|zeros?|корн\w+|корень|нул\w+)\s+(?:(?:of|for)\b(?:\s+(?:the|this|an?|\w+))?"
    r"(?:\s+(?:equation|polynomial|function))?|(?:уравнени|многочлен|функци)\w+)[\s:~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands an equation of which they speak of roots."""


def of_roots_spoken_of(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation of which words speak of roots: nothing says that it holds for what moves.

    For a new letter that words call a root it is supposed.
    """
    found = _SPOKEN_OF.search(item.before)
    if len(item.members) != 2 or item.derives or found is None:
        return None
    before = [one for one in known.of_sentence(item.sentence) if one.order < item.order]
    named = before[-1].formula if found["letter"] and before else None
    varying = known.varying(item.names)
    if isinstance(named, Name) and named.name in item.names and not varying:
        why = f"the words call {plain(named.name)} a root of it"
        if not known.untied([named.name]):
            return StatementRole(ASSUMPTION, why, reach_of_constants(item), (named.name,))
        if not known.is_defined(named.name) and variable_of(item, known) in ("", named.name):
            return StatementRole(ASSUMPTION, why, UNKNOWNS, (named.name,))
    if _roots(item, known):
        return None  # they are named, and are not those of this equation
    why = "words speak of its roots: it is not said to hold always"
    return StatementRole(ASSUMPTION, why, "set") if varying else StatementRole(OTHER, why)


def roots_in_words(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation for a letter, of which words right before it name the roots."""
    if len(item.members) != 2 or item.derives or not (roots := _roots(item, known)):
        return None
    if _has_so_many(item, variable_of(item, known), roots):
        return StatementRole(CLAIM, "the words before it name its roots", OF_ROOTS)
    return None


def _has_so_many(item: SourceStatement, letter: str, roots: Sequence[Formula]) -> bool:
    """Whether an equation has as many roots as words name; not fewer where they name some of them.

    By its degree, which is seen in derivatives at a sample: those that are named are different.
    """
    sides = minus((item.members[0], item.members[1]))
    slopes = [reduce(Partial, [letter] * k, sides) for k in range(1, len(roots) + 2)]
    some = re.search(r"\ban?\s+root\b", item.before) is not None
    with suppress(Valueless, ArithmeticError), precisely():
        sample = Sample(1, {}, (), {}, "t")
        values = [sample.value(root) for root in roots]
        apart = not any(is_zero(one - other) for one, other in combinations(values, 2))
        *_, last, beyond = (is_zero(sample.value(slope)) for slope in slopes)
        return apart and (not (last and beyond) if some else not last and beyond)
    return False


def equation_of_roots(item: SourceStatement, known: Known) -> SourceStatement:
    """The equation that has these roots and no other ones, as a product of differences."""
    letter = Name(variable_of(item, known))
    product = times(*(minus((letter, root)) for root in _roots(item, known)))
    tex = f"{to_latex(product)}={to_latex(Number(0))}"
    return unprinted(
        known.paper, f"roots-{item.order}", tex, item, "the roots of which words speak"
    )


def _roots(item: SourceStatement, known: Known) -> list[Formula]:
    """The expressions that words call roots of an equation, if it has one letter of its own."""
    found = _ARE_ROOTS.search(item.before)
    if found is None or not variable_of(item, known):
        return []
    beside = [one for one in known.items if one.sentence == item.sentence]
    typed = [*dict.fromkeys(one.typed.start for one in beside)]
    first = item.before[: found.start("roots")].count("§")
    starts = typed[first : first + found["roots"].count("§")]
    named = [one for one in beside if one.typed.start in starts]
    formulas = [one.formula for one in named if one.formula is not None and not one.members]
    return formulas if len(formulas) == len(named) == len(starts) else []
