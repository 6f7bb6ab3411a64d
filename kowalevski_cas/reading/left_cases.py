"""Words alone that leave a case: they end it, set another one up, or say that it does not matter.

Who has supposed :math:`b=0` may go on “if friction is present”, and no formula says so.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.reading.cues import cue, force_told

_BEGINS = r"(?:^|[.;:]\s*|\n\s*|§\s*,?\s*(?:but|while|whereas|and|но|а)\s+)\W*"
_LINKS = (
    r"(?:(?:but|and|even|now|then|also|hence|thus|so|again|however|similarly|finally|next|conversely|likewise|further"
    r"|но|и|а|теперь|однако|аналогично|nun|aber|auch|mais|maintenant)\b\W*)*"
)
_LEAVES = re.compile(
    rf"{_BEGINS}{_LINKS}(?:in\s+(?:the\s+|full\s+)?general(?:ity)?|generally|more\s+generally|otherwise|else|if\s+not"
    r"|в\s+общем\s+случае|иначе|im\s+allgemeinen(?:\s+Fall)?|allgemein|sonst|andernfalls|en\s+g\S*n\S*ral|sinon|autrement)\b"
    r"|\b(?:drop|remov|lift|relax|abandon|discard|giv\w+\s+up|dispens)\w*\s+(?:(?:now|with)\s+)?(?:this\b|these\b|it\b"
    r"|(?:\w+\s+){0,3}(?:assum|restrict|condition|hypothes|requir|simplif)\w*)"
    r"|\bwithout\s+(?:it\b|(?:\w+\s+){0,2}(?:assum|restrict|condition|hypothes|requir|simplif)\w*)"
    r"|\b(?:return|com|go|turn)(?:s|e|es|ing)?\s+back\s+to\b|\breturn(?:s|ing)?\s+to\b"
    r"|\b(?:full|exact|original|complete|unrestricted|general)\s+(?:system|problem|equations?|case|model|motion|generality)\b"
    r"|\b(?:for|in)\s+(?:all|every|any|each|either|both)(?:\s+(?:other|such))?\s+(?:cases?|examples?|bod(?:y|ies)|systems?|values?|parameters?|choices?|tops?)\b"
    r"|\b(?:other|opposite|contrary|converse|remaining|alternative)\s+(?:cases?|situations?|alternatives?|possibilit\w+)\b"
    r"|\b(?:original|physical|dimensional|usual)\s+(?:units?|variables?|time)\b"
    r"|\bfor\s+(?:other|different|generic|super\w+|sub\w+)\s+(?:values?|parameters?|bodies)\b"
    r"|\b(?:holds?|true|valid|so|correct)\s+(?:always|in\s+general|generally|quite\s+generally|without\s+exception)\b"
    r"|\balways\s+(?:holds?|true|valid)\b|\b(?:is|are)\s+not\s+(?:so|the\s+case|true)\b"
    r"|\b(?:whatever|whichever|regardless|irrespective\w*)\b(?!\s+(?:of\s+)?(?:(?:the|its|their)\s+)?"
    r"(?:initial|beginning|motion|position|velocit|speed|amplitude|time|direction|sign|energy|orbit))"
    r"|\bno\s+longer\s+(?:\w+\s+)?(?:assum|suppos|requir|restrict|impos|consider|tru|valid|hold)\w*"
    r"|\bindependent(?:ly)?\s+of\s+(?:the|this|our|these)\s+(?:\w+\s+)?(?:assum|restrict|condition|hypothes|choice)\w*|\bwhether\s+or\s+not\b"
    r"|\b(?:верн[её]мся|возвращаясь|возвратимся|снимем|отбросим|отка[зж]\w+)\b"
    r"|\b(?:в\s+)?(?:противн|остальн|друг|ин)\w+\s+случа\w+"
    r"|\bбез\s+(?:\w+\s+){0,2}(?:предположени|ограничени|услови)\w*|\bобщ(?:ем|ей|ую|ий|ему)\s+(?:случа|задач|систем)\w*"
    r"|\b(?:im|in)\s+(?:anderen|\w*gegengesetzten|übrigen)\s+F(?:all|ällen)\b|\bdans\s+(?:l['’]autre|les\s+autres|le)\s+cas(?:\s+contraire)?\b(?!\s+(?:o[uù]|de|d['’]))"
    r"|\bohne\s+(?:\w+\s+){0,2}(?:Annahme|Voraussetzung|Einschr\S*nkung)|\bsans\s+(?:\w+\s+){0,2}(?:hypoth|restriction|condition)",
    re.IGNORECASE,
)
"""Words that end a case."""
_IDLE = re.compile(
    r"\b(?:assum\w+|restrict\w+|condition|hypothes[ie]s|requirement|choice|case)\b[^.;§]*§?[^.;§]*\b(?:unnecessary|superfluous"
    r"|redundant|(?:in|un)essential|immaterial|irrelevant|not\s+(?:needed|necessary|essential|required|used|fulfilled|satisfied|met|so))\b"
    r"|\b(?:предположени|ограничени|услови|требовани)\w+[^.;§]*§?[^.;§]*\b(?:излишн|несуществен|не\s+нужн|не\s+обязательн)\w*",
    re.IGNORECASE,
)
"""Words that say of a case that it does not matter."""
_IDEAL = re.compile(
    r"\b(?:no|without|absen\w+|neglect\w*|neglig\w*|ignor\w*|disregard\w*|vanish\w*|exclud\w*|free|kein\w*|ohne|verschwinde\w*|sans"
    r"|без|отсутств\w+|пренебр\w+|нет)\b",
    re.IGNORECASE,
)
_NOT = re.compile(r"\b(?:not|nicht|pas|не)\b", re.IGNORECASE)
_SAME = (
    r"(?!(?:this|that|th[eo]se|such|it|so|given|our|its|we|one|respect|regard|help|use|all|every|each|any|as|\w+ing"
    r"|the\s+(?:same|present|latter|above|following)|ce(?:tte|s)?)\b|differentiat|multipl|substitut|integrat|expand|diese"
    r"|эт|так|помощ|всех|всяк|люб|(?:про)?дифференц|(?:по|у)множ|подстав|воспольз|исключ|слож)"
)
"""No words for the case that is there, for motions, or for a means, stand here."""
_THING = (
    r"(?:case|oscillator|pendul(?:um|a)|system|bod(?:y|ies)|top|gyrostat|gyroscope|problem|equation|situation"
    r"|model|particle|rotor|chain|regime)s?"
)
_ANEW = re.compile(
    rf"{_BEGINS}{_LINKS}(?:(?:let\s+us|we|us|now|next|also|may|can|shall|will|again|first)\s+)*"
    r"(?:allow|admit|restor|retain|includ|turn\w*\s+on|switch\w*\s+on|let|suppos|assum|consider|treat|study|discuss|examin|pass"
    r"|proceed|turn|com|go|take|пусть|предполож|рассмотр|перейд|учт|sei|betracht|soit|consid[eé]r)\w*\s+"
    rf"{_SAME}(?:now\s+|next\s+)?{_SAME}(?:[^§.;,]*\b(?:again|present|nun|{_THING})\b|\w+\s+(?:for|also)\b)[^§.;]*[.;]",
    re.IGNORECASE,
)
"""A sentence, or a part of one, without a formula that sets up another case for what follows."""
_IF = re.compile(
    rf"^\W*{_LINKS}(?:(?:if|when|whenever|once|unless|provided(?:\s+that)?|as\s+soon\s+as|если|когда|wenn|falls|si|lorsque|quand)\s+{_SAME}[^§]*"
    rf"|(?:with|при|mit|bei|avec)\s+(?!(?:an?|the|das|der|dem|le|la|l['’])\b){_SAME}[^\W\d]{{2}}[^§]*"
    r"|in\s+(?:the\s+)?presence\s+of\b[^§]*"
    rf"|(?:for|in)\s+(?:an?|the)\s+{_SAME}(?:[\w-]+\s+){{0,3}}?{_THING}\b[^§]*)$",
    re.IGNORECASE,
)
"""How the words before a claim begin that say of which case it is."""


def is_idle(words: str) -> bool:
    """Whether words say that what is supposed does not matter."""
    return _IDLE.search(words) is not None


def leaves_case(between: str, before: Sequence[str]) -> bool:
    """Whether words leave a case: some behind it, or those of which a claim is said.

    ``before`` has the words before the claim in its sentence, and the sentences that this goes on.
    """
    if _LEAVES.search(between) or is_idle(between) or force_told(between):
        return True
    told = (*_ANEW.finditer(between), *filter(None, map(_IF.match, before)))
    return not all(_is_ideal(one[0]) for one in told)


def _is_ideal(words: str) -> bool:
    """Whether words speak of a case in which something is absent."""
    return bool(cue("ideal case", words) or _IDEAL.search(words)) and not _NOT.search(words)
