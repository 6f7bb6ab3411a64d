"""What the words around a statement say of it, and what its members are."""

from __future__ import annotations

import re
from collections.abc import Iterable

from kowalevski_cas.notation import Derivative, Formula, Name, Negative, Number, Vector, to_plain
from kowalevski_cas.paper.names import head
from kowalevski_cas.reading.cues import cue, cues, last_cue
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.rows import is_row
from kowalevski_cas.reading.statements import SourceStatement

ZERO = Number(0)


VERB = re.compile(
    r"[\s~]*(?:(?:also|thus|hence)\s+)?"
    r"(?:is|are|remains?|stays?|does|do|would|will|could|may|might|(?:не\s+)?(?:сохран|постоян)|не\s+меня|есть|явля|оста[её]тся|[-—–]+\s)",
    re.IGNORECASE,
)
"""What says of the expression before it that it is something, or does something."""


AT_TIMES = re.compile(
    r"\b(?:at|when|if|initially|finally|during|while|before|after)\b"
    r"|\bin\s+(?:the|its|this|that|a)\s+(?:\w+\s+)?(?:positions?|states?|limits?|ends?|middle|beginning)\b"
    r"|\b(?:если|когда|при|вначале|сначала|в\s+(?:\w+\s+)?(?:точк|положени|состояни|момент|предел|начал|конц)\w+)\b",
    re.IGNORECASE,
)
"""Words for a place, or a time, of which something may be said alone."""


_CONJUGATE = (
    r"(?:canonically\s+)?(?:conjugate|corresponding|associated|сопряж[её]нн\w+)\s+(?:(?:to|with|с)\s+)?"
    r"(?:the\s+)?(?:\w+\s+){0,2}"
)
"""Words behind a momentum that say of which coordinate it is one."""
_OF_COORDINATE = re.compile(rf"{_CONJUGATE}$", re.IGNORECASE)
_AND = re.compile(
    rf"(?:[\s,~]*{_CONJUGATE}§)?"
    r"(?:[\s,~]*\b(?:unlike|in\s+contrast\s+(?:to|with)|as\s+opposed\s+to|rather\s+than|в\s+отличие\s+от)\s+(?:\w+\s+){0,3}§\s*,)?"
    r"[\s,;~]*(?:(?:and|or|и|или)[\s~]*)?(?:§[\s,;~]*(?:(?:and|or|и|или)[\s~]*)?)*",
    re.IGNORECASE,
)


_BEFORE = re.compile(r"§(?:[\s,;~]|\b(?:and|or|и|или)\b)*$")
_IN_CASE = re.compile(
    r"(?<=§)(?P<and>[\s,~]*\b(?:and|or|и|или)\b)[\s,~]*\b(?:for|if|when|при|если|когда)[\s~]*§[\s~]*,[\s~]*$"
)
"""How words end behind which the next of a list is one for some constants only."""


def _own_lead(item: SourceStatement) -> str:
    """The words before a statement, without those that say something of the one before it."""
    if "§" in item.before and VERB.match(item.lead):
        return _CLAUSE.split(item.lead, maxsplit=1)[-1]
    return item.lead


def clause(item: SourceStatement) -> str:
    """The words right around a statement; not those that say something of the one before it."""
    tail = "" if _CONCLUDES.match(item.tail) else item.tail.lstrip(" ,")
    return f"{_own_lead(item)[-60:]} § {_CLAUSE.split(tail, maxsplit=1)[0][:40]}"


_NEXT = r"(?:,\s*|\b)(?:and|but|while|whereas|и|а|но)\s+(?:\w+\s+){0,3}"
_ALONE = r"[\s~]*(?:is|remains|stays|явля\w+|сохраняется|постоян(?:на|ен|но))\b"
_AGAIN = re.compile(
    rf"[;:]|\b(?:so(?!\s+(?:is|are|do|does)\b)|hence|thus|therefore|whence)\b"
    rf"|\band\s+(?:all|its|their|it|they|there)\b|{_NEXT}(?=§{_ALONE})|,\s*{_NEXT}(?=§)",
    re.IGNORECASE,
)
"""Where something begins to be said of another formula."""
_BEGINS = re.compile(rf"{_NEXT}$", re.IGNORECASE)
_IS_ALONE = re.compile(_ALONE, re.IGNORECASE)


def said_of(item: SourceStatement) -> str:
    """The words of the sentence around a statement, as far as they are not said of another one."""
    before = _AGAIN.split(item.before)[-1]
    if (begins := _BEGINS.search(before)) and _IS_ALONE.match(item.after):
        before = before[begins.end() :]
    return f"{before} § {'' if ends_clause(item) else _AGAIN.split(item.after)[0]}"


_SEMICOLON = re.compile(r";[\s}~]*$")
_OF_IT = re.compile(
    r"[\s~]*(?:this|it|which|that|the\s+(?:former|latter)|это|он[ао]?)\b", re.IGNORECASE
)


def ends_clause(item: SourceStatement) -> bool:
    """Whether a formula ends by a semicolon, and nothing is said of it behind that."""
    return _SEMICOLON.search(item.typed.tex) is not None and not _OF_IT.match(item.tail)


def is_conditional(item: SourceStatement) -> bool:
    """Whether a statement stands in a clause that supposes something, as its sentence began."""
    over = max(last_cue("then", item.before), last_cue("claim", item.before))
    return last_cue("when", item.before) > over


_BESIDE = re.compile(
    r"(?:for|with|under|in\s+the\s+case|при|в\s+случае)\b(?:\s+(?:the\s+)?(?:\w+\s+){0,2}\w+)?",
    re.IGNORECASE,
)
"""Words that suppose something beside a main clause, and are never the main clause."""
_SAYS = re.compile(
    r"\b(?:is|are|reads?|becomes?|gives?|yields?|obtains?|finds?|gets?|has|have"
    r"|есть|имеем|име[ею]т\s+вид|получ\w+|равн\w+)(?:\s+(?:now|then|thus|simply|also))?[\s:,]*$",
    re.IGNORECASE,
)
"""How a main clause ends that a display completes."""


def _is_main(item: SourceStatement) -> bool:
    """Whether a display is what its sentence says, and words only tell beside it for what.

    So it is in “with x=1 and y=2, …”, in “for a given energy …”, and where a verb stands last.
    """
    if item.typed.inline:
        return False
    words = item.lead if item.lead.strip(" ,;~") else item.before
    if cue("suppose", f"{words} ") and not _only_beside(words):
        return False
    alone = "§" not in item.before and not re.search(r"\w", item.after)
    return bool(_SAYS.search(item.lead)) or item.lead.strip() == "," or alone


def _only_beside(words: str) -> bool:
    """Whether some words suppose something, but none so that it is in force behind them."""
    said = [*cues("suppose", f"{words} ")]
    return bool(said) and all(_BESIDE.fullmatch(one[0].strip()) for one in said)


def supposing(item: SourceStatement) -> str:
    """The words by which something is supposed right before a statement."""
    if _is_main(item):
        return ""
    said = cue("suppose", f"{item.lead} ")
    if said:
        return said.strip()
    if is_conditional(item) and cue("then", item.tail[:12]):
        return cue("when", item.before)
    if found := _LET_BE.fullmatch(item.before) if not re.search(r"\w", item.after) else None:
        return found["let"]
    before = item.before.rsplit("§", 1)[0] if "§" in item.before else ""
    between = item.lead.strip(" ,;~")
    joined = between in ("", "and", "и", "or", "или", ", and")
    said = cue("suppose", before) if joined and before else ""
    behind = before.rpartition(said.strip())[2] if said else ""
    if cue("deduced", behind) or cue("then", behind):
        return ""  # what is supposed has ended: “with § we have § and §”
    apart = not item.typed.inline and _ASIDE.search(before) is not None
    return "" if apart and not cue("then", item.tail[:12]) else said


_LET_BE = re.compile(
    r"\W*(?P<let>let|suppose|assume|пусть|предположим)\s+(?!us\b)[^,.;:]*\b(?:be|is|are|acts?|moves?|\w+(?:ен|н[аоы]|ует|уют|[её]тся|ются))\b"
    r"[^,.;:]*,[\s~]*(?:with|так\s+что|причём|причем)?[\s~]*",
    re.IGNORECASE,
)
"""How a sentence begins that supposes that there is something, and of what a condition ends it."""
_ASIDE = re.compile(r"(?:,|\band)\s+(?:with|for|при|для)[\s~]*$", re.IGNORECASE)
"""How words end behind which something is said aside; what is displayed behind that is not."""


PUT = re.compile(r"\b(?:putting|setting|полагая|положив)[\s~]*$", re.IGNORECASE)
"""How words end behind which something is put so, for what follows in the sentence."""


def reach(item: SourceStatement) -> str:
    """How far it reaches what is supposed of what moves."""
    if cue("here", f"{item.before} ") or (is_conditional(item) and cue("then", item.tail[:12])):
        return "set of the sentence"
    if _only_beside(item.before) or PUT.search(joined_lead(item)):
        return "set of the sentence"
    return "set in force" if cue("suppose", f"{joined_lead(item)} ") else "set"


_AT = re.compile(r"\b(?:at|в\s+точке)[\s~]*$", re.IGNORECASE)
"""How words end behind which something is said of one place only."""


_CASE_IN_TITLE = re.compile(
    r"\\(?:(?:sub)*section|paragraph)\*?\s*\{[^{}]*(?:\bcase\b|\bслуча[йея]\b)", re.IGNORECASE
)
"""A heading that names a case: with what it begins is supposed in all of it."""


_EXIST = re.compile(
    r"\bthere\s+(?:is|are|exists?|may|can)\b|\bexists?\b|\bсуществу\w+|\bимеются?\b", re.IGNORECASE
)
"""Words that say that there is something: what is supposed of that is supposed of nothing else."""


def reach_of_constants(item: SourceStatement) -> str:
    """How far it reaches what is supposed of constants; to the end of the section, if empty."""
    beside = _EXIST.search(item.before) and _only_beside(item.before)
    brief = (
        cue("for", f"{item.before} ")
        or cue("if", item.lead)
        or cue("approximate", item.before)
        or bool(_AT.search(item.lead) or beside)
    )
    titled = bool(item.earlier and _CASE_IN_TITLE.match(item.earlier[0]))
    begun = titled and item.before == item.lead and cue("then", item.tail[:12])
    lasting = cue("lasting", item.before) or begun
    return "of the sentence" if item.typed.inline and brief and not lasting else ""


_SEVERAL = re.compile(
    r"\b(?:integrals|constants\s+of\s+(?:the\s+)?motion|интегралы)\s*$", re.IGNORECASE
)
"""How words end behind which several integrals are listed."""
_LISTED = re.compile(
    r"\b(?:(?:integrals|интегралы)\s*(?:are|:|[-—–]+)?|(?<!not\s)(?:con|pre)serves?\s+(?:\w+\s+){0,4})\s*"
    r"(?:§[\s,;]*)+(?:and|и)\s*$",
    re.IGNORECASE,
)
"""How words end behind which the last of several integrals stands."""


_ONE_IS = re.compile(
    r"[\s,;~]*(?:and|и)\s+§[\s,~]*(?:(?:is|remains|stays)\b|(?:сохраняется|постоян(?:на|ен|но))\b)",
    re.IGNORECASE,
)
"""What is said of the last one of two alone."""


def integral_words(item: SourceStatement) -> str:
    """The words near a statement that call it an integral, if no other words stand between."""
    if _OF_COORDINATE.search(item.lead):
        return ""
    if said := said_again(item, "integral"):
        return said
    tail = "" if _ONE_IS.match(item.after) else joined_tail(item)[:60]
    if not re.match(r"[\s,]*(?:which|whence|where|with|that|откуда|где|котор)", tail) and (
        said := cue("integral", f"{tail} ;")  # not of what stands behind these words
    ):
        deduced = last_cue("claim", _CLAUSE.split(item.lead[-30:])[-1]) >= 0
        if not (deduced and item.typed.inline) or words_behind(item, "integral"):
            return said
    if said := cue("integral", last_clause(_own_lead(item))):
        return said
    if item.typed.inline:
        listed = joined_lead(item)
        if _SEVERAL.search(listed):
            return cue("integral", last_clause(listed))
        return cue("integral", item.before) if _LISTED.search(item.before) else _in_list(item)
    return (
        cue("integral", item.before) if item.lead.strip(" ,;") in ("", "and") else announced(item)
    )


_PHRASE = re.compile(
    r"[\s,;:~(–—-]*(?:\b(?:and|и|а\s+также)\b)?[\s,~]*(?:\b(?:the|an?|its|their)\s+)?"
    r"(?:(?!\b(?:is|are|was|were|ha[sd]|have|with|where|if|for|on|at|when|gives?|so|then|hence"
    r"|где|если|при|то|равн\w+|име\w+)\b)[^\W\d_]+[\s~-]*){0,4}[\s,:;~(–—-]*"
)
"""A noun with what belongs to it, and no verb, as it stands before a formula in a list."""


_KIND = r"of\s+(?:the\s+)?(?:\w+[\s~]+){0,3}\w+[\s~]*"
_INTEGRALS_OF = re.compile(rf"\bintegrals\s+{_KIND}$", re.IGNORECASE)
_OF_KIND = re.compile(rf"[\s,;~]*(?:and\s+)?{_KIND}", re.IGNORECASE)
"""Of what integrals are, as it stands before each of a list."""


def _in_list(item: SourceStatement) -> str:
    """The words by which a list behind a colon is announced, or that end it, as one of integrals.

    So it is in “Two quantities are conserved: the mass, M=m, and the energy, E=h”, and in “the
    integrals of momentum P=p and of energy E=h”.
    """
    first, *kinds = item.before.split("§")
    if kinds and _INTEGRALS_OF.search(first) and all(map(_OF_KIND.fullmatch, kinds)):
        return "" if cue("denied", first) else cue("integral", first)
    announcing, colon, listed = item.before.rpartition(":")
    if colon and "§" not in announcing and all(map(_PHRASE.fullmatch, listed.split("§"))):
        return "" if cue("denied", announcing) else cue("integral", last_clause(announcing))
    rest = item.after
    while (found := _PHRASE.match(rest)) and rest[found.end() :].startswith("§"):
        rest = rest[found.end() + 1 :]
    return cue("integral", rest[:40]) if _ARE.match(rest) and rest != item.after else ""


_ARE = re.compile(
    r"[\s,)~]*(?:are|remain|stay)\s+(?:\w+\s+)?(?:conserved|constant|integrals)\b", re.I
)
"""What is said of all formulas of a list."""

_CURVES = re.compile(
    r"\b(?:(?:phase|integral)\s+curves|(?:phase\s+)?(?:trajectories|orbits|paths))\s+"
    r"(?:are(?:\s+given\s+by)?|have\s+the\s+equations?)[\s:,~]*$"
    r"|\b(?:фазов|интегральн)\w+\s+(?:крив|траектори)\w+\s*(?:[-—]+|суть|задаются\s+уравнени\w+|имеют\s+вид)[\s:,~]*$",
    re.IGNORECASE,
)
"""How words end behind which the equation of the curves of motion stands."""
_HENCE = re.compile(
    r"\W*(?:hence|thus|therefore|consequently|it\s+follows\s+that|следовательно|отсюда|поэтому)[\s,:~]*"
    r"(?:(?:we|one)\s+(?:have|has|gets?|finds?|obtains?)|получ\w+|имеем)?(?:\s+that)?[\s:,~]*",
    re.IGNORECASE,
)
_SUMMED = re.compile(
    r"\b(?:multipl|add|integrat|summ)(?:y|ying|ing|e)?\b.*\b(?:gives?|yields?|leads?\s+to"
    r"|(?:we|one)\s+(?:then\s+)?(?:have|has|gets?|finds?|obtains?|arrives?\s+at))[\s:,~]*$"
    r"|\b(?:умнож|сложи|склад|проинтегрир)\w+.*\b(?:получ\w+|имеем|находим)[\s:,~]*$",
    re.IGNORECASE | re.DOTALL,
)
"""Words that conclude what follows from the equations of motion."""
_SUCH = re.compile(
    r"\b(?:such|these|those|other|another)\b|\b(?:так|эт|друг)(?:их|ого|ой|ом)\b", re.IGNORECASE
)
"""Words for some motions only, or for other ones."""
CYCLIC = re.compile(
    r"§[\s~]*(?:is|being)\s+(?:then\s+|also\s+|therefore\s+)?(?:an?\s+)?(?:cyclic|ignorable)\b"
    r"|\b(?:cyclic|ignorable)\s+(?:coordinate|variable|angle)s?[\s~]*§"
    r"|§[\s~]*(?:[-—]+|является)?\s*циклическ\w+|\bциклическ\w+\s+координат\w+[\s~]*§",
    re.IGNORECASE,
)
"""Words for a coordinate that does not stand in the energies."""


def is_deduced_level(item: SourceStatement) -> bool:
    """Whether words before a level in the text conclude it, or say that motions lie on such ones.

    That is so for the momentum of a coordinate that the sentence calls cyclic.
    """
    if cue("place", item.words) or _SUCH.search(item.before):
        return False
    concluded = _HENCE.fullmatch(item.before) or _SUMMED.search(item.before)
    of_cyclic = item.rates and CYCLIC.search(item.before)
    return bool(concluded or _CURVES.search(item.lead) or of_cyclic)


_ONE_MORE = re.compile(
    r"\b(?:one\s+more|another|an?\s+\w+\s+one|the\s+(?:other|last|\w+th|second|third)\s+one)\b"
    r"|\bthere\s+(?:is|are)\s+also\b|\bещ[её]\s+один\b|\bещ[её]\s+одно\b|\bдруго[йе]\b|\b(?:второй|третий|четв[её]ртый)\b",
    re.IGNORECASE,
)
"""Words for one more of what was spoken of."""
_IT_IS = re.compile(
    r"\s*(?:It|This\s+one)\s+(?:reads|equals|has\s+the\s+form|(?:can|may)\s+be\s+written|is\s+(?!\w+\s+(?:to|that)\b"
    r"|(?:easy|clear|seen|known|obvious|evident|not)\b))|\s*(?:Он|Это)\s+(?:име|равен|записыва|есть|[-—–])"
)
"""How a sentence begins that prints what was spoken of before."""


DENIES_ALL = re.compile(r"\W*(?:no|none|nothing|neither|ни|никак\w+)\b", re.IGNORECASE)
"""How a sentence begins that says of nothing what it speaks of."""


def announced(item: SourceStatement) -> str:
    """The words by which a display was announced to be an integral: as one more, or as “it”."""
    words = item.before
    if is_row(item):
        return ""
    if said := cue("its constant", item.lead):
        return said
    found = _ONE_MORE.search(words)
    if found and (said := cue("integral", words[: found.start()])):
        return said if "§" in words[: found.start()] else ""
    for before in item.earlier if last_clause(item.before) == item.before else ():
        if not (_ONE_MORE.search(words) or _IT_IS.match(words)) or cue("denied", words):
            return ""
        if said := cue("integral", before):
            return "" if cue("denied", before) or DENIES_ALL.match(before) else said
        words = before
    return ""


def joined_tail(item: SourceStatement) -> str:
    """The words behind a statement, and behind those that only a comma or “and” joins to it."""
    found = _AND.match(item.after)
    joined = item.after[found.end() :] if found else item.after
    return joined.partition("§")[0]


_MAKES = re.compile(
    r"[\s~]*(?:define|form|give|determine|constitute|зада|образу)\w*\s", re.IGNORECASE
)
_SO = re.compile(
    r"\b(?:so|neither|nor)\s+(?:is|are|does|do)\b(?:\s+\w+){0,3}\s*$|\bкак\s+и\b\s*(?:\w+\s*){0,2}$"
    r"|\bas\s+(?:is|are)(?:\s+(?:also|the|its|their|both|functions?|quantit(?:y|ies)|products?|sums?"
    r"|differences?|moment(?:um|a)|energ(?:y|ies)|components?))*[\s~]*$"
    r"|[,;]\s*(?:and\s+)?(?:(?:thus|hence|therefore|consequently|so)\s+)?(?:also|likewise|similarly|equally)"
    r"(?:\s+(?:the|its|their|\w+)){0,3}[\s~]*$"
    r"|,\s*(?:(?:а|и)\s+)?(?:поэтому\s+|значит,?\s+)?(?:также|тоже)(?:\s+и)?[\s~]*$",
    re.IGNORECASE,
)
"""How words end behind which stands what is the same as what was spoken of before."""
_TOO = re.compile(
    r"[\s,~]*(?:(?:is|are)\s+)?(?:(?:another|also|again)\s+)?(?:one\s+(?=of\b|for\b)|ones\s+(?=of\b|for\b)"
    r"|(?:(?:one|so)[\s,]*)?(?:too|as\s+well|also|likewise|similarly)\b\s*(?:$|[.;]|,(?!\s*§)))"
    r"|[\s,~]*(?:[-—]+\s*)?(?:тоже|также)\s*(?:$|[.;,])",
    re.IGNORECASE,
)
"""How words begin behind what is the same as what was spoken of before."""
_OPENS = re.compile(
    r"(?:\\footnote\s*\{|\\item(?:\s*\[[^\]]*\])?|\W|\b(?:and|but|и)\b)*", re.IGNORECASE
)
"""What may stand before the first words of a sentence."""


def said_again(item: SourceStatement, name: str) -> str:
    """The words by which what was spoken of before is something, and by others this is so, too.

    They stand in its sentence, or in the one before, if this denies and supposes nothing.
    """
    so = None if VERB.match(item.tail) else _SO.search(item.lead)
    if not (so or _TOO.match(item.tail)):
        return ""
    words = item.before[: len(item.before) - len(item.lead) + so.start()] if so else item.before
    if _OPENS.fullmatch(words):
        words = item.earlier[0] if item.earlier else ""
        if cue("suppose", words) or DENIES_ALL.match(words):
            return ""
    return "" if cue("denied", words) else cue(name, words)


_LISTS = re.compile(
    r"\b(?:has|have|admits?|possess(?:es)?|by|are|is|namely|following|име[её]т|имеют|допуска\w+|на)\b"
    r"(?:\s+\w+){0,4}[\s:,~]*$",
    re.IGNORECASE,
)
"""How words end behind which a display lists what is something."""
_CLAUSE = re.compile(r"[,;:.]|\b(?:and|but|и|а|но)\b")


_CONCLUDES = re.compile(
    r"\s*[,;:]?\s*(?:and\s+)?(?:so|hence|thus|therefore|whence|consequently|so\s+that|так\s+что|поэтому|следовательно)\b",
    re.IGNORECASE,
)
"""How words begin behind a statement that conclude something else from it."""


_ANOTHER_CLAUSE = re.compile(
    r"\b(?:in\s+order\s+)?to\s+(?:find|obtain|get|construct|derive|deduce|establish|look\s+for)\b[^.;:§]*?(?=\b(?:we|one|let|it|this|put|consider)\b)"
    r"|\b(?:чтобы|для\s+того)\b[^.;:§]*,"
    r"|;|[,:]\s*(?:and|but|while|whereas|и|а|но)\s+"
    r"(?:(?:it|this|that|they|these|we|one|there|он|она|оно|они|это|мы)\b"
    r"|§\s+(?:moves|obeys|satisfies|oscillates|varies|grows|движется|удовлетворяет|меняется)\b)"
    r"(?!\s+(?:reads?|equals?|(?:is|are)\s+(?:given|equal)|ha(?:s|ve)\s+the\s+form|име\w+|рав\w+))",
    re.IGNORECASE,
)
"""What ends a clause behind which another one says something else."""


def last_clause(words: str) -> str:
    """The last of the clauses of some words that have subjects of their own."""
    return _ANOTHER_CLAUSE.split(words)[-1]


def right_behind(item: SourceStatement) -> str:
    """The words behind a statement as far as its clause goes."""
    return right_of(item.tail)


def right_of(words: str) -> str:
    """The first words as far as their clause goes."""
    return _CLAUSE.split(words[:40], maxsplit=1)[0]


_ASIDE = re.compile(
    r"\s*,\s*(?:however|therefore|thus|hence|then|again|too|also|of\s+course|obviously|clearly|evidently|as\s+before"
    r"|однако|следовательно|поэтому|очевидно|конечно)\s*,",
    re.IGNORECASE,
)
"""Words between commas that say nothing of what they stand in."""


def words_behind(item: SourceStatement, name: str) -> str:
    """The words right behind a statement by which it is said to be something."""
    tail = _ASIDE.sub("", joined_tail(item))[:80]
    if not (VERB.match(tail) or _MAKES.match(tail)):
        return ""
    return cue(name, _CLAUSE.split(tail, maxsplit=1)[0])


def words_of(item: SourceStatement, name: str) -> str:
    """The words by which a statement is said to be something, right behind it or before.

    What they say of another formula, or of a set on which something holds, is not said of it.
    """
    if said := words_behind(item, name):
        return said
    lead = _NAMELY.sub("", joined_lead(item))[-60:]
    end = last_cue(name, lead)
    before = _IN_CASE.sub(r"\g<and> ", item.before)
    if end < 0 or cue("here", f"{before} ") or _CLAUSE.search(lead[end:].rstrip(" :~\n")):
        return ""
    return cue(name, lead[end:]) if len(lead[end:].split()) <= 5 else ""


_NAMELY = re.compile(r"[\s,:;~(]*\b(?:namely|viz\.?|that\s+is|а\s+именно)[\s,:~]*$", re.IGNORECASE)
"""Words between what something is called and a formula for it."""
_RESTING = re.compile(
    r"[\s,~]*(?:is|are)\s+(?:(?:all|both|also|again|then|always)\s+)?(?:at\s+rest|stationary|fixed)\b"
    r"(?!\s+\w)|[\s,~]*неподвижн\w+",
    re.IGNORECASE,
)
_OF_POINTS = re.compile(
    r"\b(?:points?|positions?|states?|solutions?|(?:точк|положени|состояни|решени)\w+)[\s~]*$",
    re.IGNORECASE,
)


def resting(item: SourceStatement) -> str:
    """The words behind the equations of some points that say that these do not move."""
    found = _RESTING.match(joined_tail(item))
    return found[0].strip() if found and _OF_POINTS.search(joined_lead(item)) else ""


def listed_words(item: SourceStatement, name: str) -> str:
    """The words before a display that lists what is something, as “has the integrals”."""
    if item.typed.inline or not _LISTS.search(joined_lead(item)):
        return ""
    return cue(name, item.before)


def joined_lead(item: SourceStatement) -> str:
    """The words before a statement, and before those that only a comma or “and” joins to it."""
    words = _IN_CASE.sub(r"\g<and> ", item.before)
    while (cut := _BEFORE.sub("", words)) != words:
        words = cut
    return words.rpartition("§")[2]


_THEY_SOLVE = re.compile(
    r"\b(?:is|are)\s+(?:a\s+|the\s+)?(?:points?|solutions?|roots?|zeros?)\s+"
    r"(?:of|at|where|in)(?:\s+which)?[\s:~]*$"
    r"|\b(?:found|determined|obtained)\s+(?:from|by)(?:\s+the)?(?:\s+(?:equations?|conditions?|system))?[\s:~]*$"
    r"|\b(?:находят?ся|определя\w+)(?:\s+из)?(?:\s+(?:услови\w+|уравнени\w+|систем\w+))?[\s:~]*$"
    r"|(?:явля\w+|суть|[-—–])\s*(?:точк\w+|решени\w+|корн\w+|нул\w+)"
    r"(?:,?\s+в\s+которых|\s+(?:уравнени|систем)\w+)?[\s:~]*$"
    r"|,\s*(?:namely|that\s+is|i\.\s*e\.|а\s+именно|то\s+есть)[\s,]*(?:the\s+)?"
    r"(?:roots?|zeros?|solutions?|корн\w+|нул\w+|решени\w+)\s+(?:of|(?:the\s+)?equations?|уравнени\w+)"
    r"(?:\s+(?:the\s+)?equations?)?[\s:~]*$"
)
"""How words end before the equations that something satisfies."""
_EQUATIONS_BEFORE = re.compile(r"(?:§|[\s,]|\b(?:and|и)\b)*$")
"""What stands before one of several equations."""
_THEY = re.compile(r"\s*(?:They|These|Это|Они)\b")


def solved_by(item: SourceStatement, name: str) -> str:
    """The words for what equations are the set of: in their sentence, or before, if “they” are."""
    words = _EQUATIONS_BEFORE.sub("", item.before)
    if not (found := _THEY_SOLVE.search(words)):
        return ""
    if _THEY.match(words):
        return cue(name, item.earlier[0]) if item.earlier else ""
    return cue(name, words[: found.start()])


def is_number(members: Iterable[Formula]) -> bool:
    """Whether some members are numbers, at least one."""
    found = [*members]
    return bool(found) and all(is_value(m) and not m.names() for m in found)


def is_value(formula: Formula) -> bool:
    """Whether a member is a number, a name, or a vector of numbers."""
    if isinstance(formula, Negative):
        return is_value(formula.argument)
    if isinstance(formula, Vector):
        return all(map(is_value, formula.components))
    return (
        not any(isinstance(n, Derivative) for n in formula.nodes()) and len([*formula.nodes()]) <= 5
    )


IMPLIES = re.compile(r"[\s~]*(?:would\s+)?(?:impl(?:y|ies)|entails?|forces?|влечёт|влечет)\b")
"""How words begin that say what would follow from something."""


def is_level(item: SourceStatement, known: Known) -> bool:
    """Whether an equation gives a function a value."""
    fixed = [m for m in item.members if not known.varying(m.names())]
    return (bool(fixed) and len(fixed) < len(item.members)) or "\\equiv" in getattr(
        item.formula, "signs", ()
    )


def set_beside(item: SourceStatement, known: Known) -> bool:
    """Whether a statement stands beside one of what vanishes, and is no rate, in its display.

    Where all are rates, words have to speak of a set.
    """
    beside = [one for one in known.paper.items if one.typed is item.typed and one is not item]
    zeros = [one for one in beside if ZERO in one.members]
    said = cue("invariant", item.words) or cue("equilibrium", item.words)
    return bool(zeros and said) or not all(one.derives for one in zeros)


def plain(name: str) -> str:
    """A name as it is told in a terminal, without arguments."""
    return to_plain(Name(name)) if not head(name)[1] else head(name)[0]
