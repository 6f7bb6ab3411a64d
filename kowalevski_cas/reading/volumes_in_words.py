"""What sentences say of the volume of the phase space: that the flow preserves it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.paper.claims import PreservedMeasure
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.in_words import InWords, is_unsure, sentences_of
from kowalevski_cas.reading.kinematics import is_free
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.measures import volume_element
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.unprinted import unprinted

SAYS = "the flow preserves the volume"
_CITED = r"(?:[\s~]*\(?\\(?:eq)?ref\s*\{[^{}]*\}\)?)?"
_OF_RIGHT_SIDES = (
    r"\b(?:the\s+)?divergence\s+of\s+(?:(?:the|this|our)\s+)?(?:(?:vector|phase)\s+)?"
    rf"(?:field|flow|system|equations|right[\s-]+(?:hand[\s-]+)?sides?)(?:\s+of)?{_CITED}"
)
_OF_RIGHT_SIDES_RU = (
    rf"\bдивергенци[яю]\s+(?:прав\w+\s+част\w+|системы|потока){_CITED}(?:,[^,.;:]{{1,60}},)?"
)
_ZERO = r"(?:vanishes|is\s+(?:(?:identically|always|then)\s+)?(?:equal\s+to\s+)?zero)"
_VOLUME = r"(?:phase\s+)?(?:volume|area|measure)"
_VOLUME_RU = r"фазов\w+\s+(?:объ[её]м|площадь)"
_KEPT = re.compile(
    rf"(?:{_OF_RIGHT_SIDES}\s+{_ZERO}"
    rf"|{_OF_RIGHT_SIDES_RU}\s+(?:тождественно\s+)?равна\s+нулю"
    r"|\b(?:flow|system|equations)\s+(?:preserves?|conserves?)\s+(?:the\s+)?"
    rf"(?:{_VOLUME}\s+(?P<behind>§)|phase\s+(?:volume|area))"
    rf"|\b(?:phase\s+(?:volume|area)|{_VOLUME}\s+(?P<before>§))[\s,]*(?:is|remains)\s+"
    r"(?:preserved|conserved|invariant|constant)"
    rf"|\bпоток\s+сохраняет\s+{_VOLUME_RU}(?:[\s~]*(?P<behind_ru>§))?"
    rf"|\b{_VOLUME_RU}[\s~]*(?P<before_ru>§)?[\s~]*(?:сохраняется|не\s+(?:изменяется|меняется)))"
    r"(?!\w|\s+(?:§|only|if|when|where|on|at|for|in|with|при|если|когда|на|в|только|лишь)\b)",
    re.IGNORECASE,
)
"""Words for it; what the differentials are may stand beside them."""
_FOR_SOME = re.compile(
    r"\b(?:for|with|on|in\s+the\s+case|при|для|на)\b(?!\s+(?:any|all|every|each|люб|вс))", re.I
)
"""Words before these for some constants, or some place only."""


def claims_of_volumes(parts: Parts) -> Iterator[InWords]:
    """That the only law before these words preserves the volume of its variables."""
    for start, words in sentences_of(parts):
        found = _KEPT.search(words)
        if found is None or is_unsure(words) or _FOR_SOME.search(words[: found.start()]):
            continue
        at = start + found.start()
        known = parts.known[parts.part_at(at)]
        law = _law_before(at, known)
        place = next((found.start(k) for k, said in found.groupdict().items() if said), None)
        if law is None or not (place is None or _are_all(start + place, law, known)):
            continue
        before = [one for one in known.items if one.typed.start < at]
        brief = "of the sentence"  # what another sentence supposes for itself is over
        last = next(one for one in reversed(before) if not known.roles[one].kind.endswith(brief))
        one = unprinted(known.paper, f"density-{at}", "1", last)
        rated = (name for row in law.rows for name in row.rates)
        coordinates = dict.fromkeys(law.names.scalars(rated)) if law.momenta else ()
        values: dict[str, object] = {"printed": one.printed, "coordinates": (*coordinates,)}
        span = (at, start + found.end())
        about = (*law.rows, *law.momenta, one)
        yield InWords(span, PreservedMeasure, about, values, "volume", SAYS, last, law)


def _law_before(at: int, known: Known) -> Law | None:
    """The only law of motion before some words, if nothing binds it."""
    laws = [law for law in known.laws if law.first.typed.start < at and not law.change]
    words = known.paper.prose.between(laws[-1].rows[-1].typed.end, at) if laws else ""
    if len(laws) != 1 or laws[0].images or laws[0].base or is_free(laws[0]) or known.bound:
        return None
    return None if cue("another system", words) or known.clocks else laws[0]


def _are_all(start: int, law: Law, known: Known) -> bool:
    """Whether a formula prints the differentials of all that a law of the first order moves."""
    tex = next((one.typed.tex for one in known.items if one.typed.start == start), "")
    first = all(order == 1 for row in law.rows for order in row.rates.values())
    return first and sorted(volume_element(tex)) == sorted(law.variables)
