"""Where what was supposed of constants, or of what moves, is over.

Words leave the case, or speak of other values of what has one in it: who has supposed :math:`b=0`
says “for any b”, or :math:`b>0`, only where this is supposed no more.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from kowalevski_cas.notation import Formula, Name, Number, Relation
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.left_cases import is_idle, leaves_case
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import Prose

_OTHERS = re.compile(
    r"\b(?:any|all|every|each|other|arbitrary|generic|general|positive|negative|non-?zero|non-?vanishing|whatever|whichever"
    r"|irrespective\w*|independent\w*|regardless|values?|small|large|var(?:y|ies)"
    r"|любо\w*|любы\w*|все\w*|всяк\w*|произвольн\w*|други\w*|положительн\w*|отрицательн\w*|ненулев\w*|независимо|малы\w*"
    r"|beliebig\w*|alle\w*|jede\w*|andere\w*|positiv\w*|negativ\w*|tout\w*|tous|quelconque\w*|quel\w*|autres?|positi\w+)\b",
    re.IGNORECASE,
)
"""Words for other values of a letter that they stand beside."""
_VANISHES = re.compile(
    r"\b(?:vanish|zero\b|disappear|absen|drop|mention|omit|null|verschwind|нул|исчез|отсутств|опус)",
    re.IGNORECASE,
)
"""Words beside a letter that is zero; who speaks of it otherwise speaks of other values."""
_REMAINS = re.compile(
    r"\b(?:not|never|no\s+longer|different|other|un\w+|nicht|pas|не|отличн)\b\W*(?:\w+\s+){0,3}?"
    r"(?:vanish|zero|disappear|absen|drop|omit|null|verschwind|нул|исчез|отсутств|опус)",
    re.IGNORECASE,
)
_DENIED = {-1: (">", r"\ge", r"\geq"), 0: ("<", ">", r"\ne", r"\neq"), 1: ("<", r"\le", r"\leq")}
"""The signs that do not hold of numbers, by the sign of their difference."""
_BESIDE = 40
"""So many signs from a letter stand words that are about it."""


_FOR_LONG = re.compile(
    r"\\(?:(?:sub)*section|paragraph)\b"
    r"|\b(?:let|suppos(?:e|es|ed|ing)|assum(?:e|es|ed|ing)|(?:mak|adopt|under|impos|add|introduc)\w*\s+(?:the|an?|this)\s+(?:\w+\s+)?(?:assum|suppos|condit|restrict)\w+|take|put|set|consider|choose|fix|restrict\w*|impose|require|below|always"
    r"|throughout|henceforth|from\s+now\s+on|in\s+what\s+follows|speciali[sz]e\w*|confine|limit\s+ourselves"
    r"|study|treat|discuss|turn\s+to|here|where|units?|напомним|далее|всюду|везде|здесь|где|единиц\w*"
    r"|пусть|предполож\w+|полож\w+|полага\w+|прим\w+|счита\w+|рассм\w+|возьм\w+|выбер\w+"
    r"|sei(?:en)?|setze\w*|betracht\w+|annehm\w+|nehme\w*|soi(?:en)?t|supposons|posons|consid\S+ons|prenons)\b",
    re.IGNORECASE,
)
"""Words that suppose something for what follows; others speak of a case."""
_GOES_ON = re.compile(
    r"\W*(?:then|hence|therefore|thus|so|consequently|accordingly|it\s+follows|in\s+(?:this|that|such)\s+(?:a\s+)?case"
    r"|here|also|тогда|отсюда|следовательно|поэтому|значит|итак|в\s+(?:этом|таком)\s+случае|при\s+этом|здесь"
    r"|dann|daher|somit|hier|alors|donc|ainsi|ici)\b|\W*(?:§|$)",
    re.IGNORECASE,
)
"""How a sentence begins that goes on with the case of which the one before it spoke."""


_NOT_HERE = re.compile(
    r"\b(?:fig(?:ure|s)?|tables?|exercises?|problem\s+\d|computed|authors?|papers?|generali[sz]e|examples?|instance)\b|\be\.\s*g\."
    r"|\[\d+\]|\\cite|\b(?:was|were)\s+(?:assumed|supposed|studied|considered|treated)\b"
    r"|\b(?:could|might|would)\s+(?:\w+\s+)?(?:put|set|take|assume|suppose|choose|require|impose)\b"
    r"|\bрис\b|\b(?:таблиц|работ|упражнени|(?:на)?пример)\w*|предполагал[оаи]сь",
    re.IGNORECASE,
)
"""Words for what is supposed of a figure, in an exercise, or by others."""


_EXERCISE = re.compile(r"\W*(?:exercise|problem|example|упражнение|задача|пример)\b", re.IGNORECASE)
"""How a paragraph begins that stands by itself."""


def goes_on(one: SourceStatement, item: SourceStatement, special: bool, prose: Prose) -> bool:
    """Whether what a statement supposes is supposed for a later sentence as well.

    Where no words suppose a special case for what follows, only such a sentence of the same
    paragraph is about it as says so by its first words.
    """
    if one.sentence == item.sentence or not (special and one.typed.inline):
        return True
    if lasts_to_the_end(one) or (one.theorem is not None and one.theorem == item.theorem):
        return True
    begun = _FOR_LONG.search(one.before) or cue("in this part", one.before)
    lasts = one.theorem is not None or one.entry is not None or begun
    alone = _EXERCISE.match(prose.text, one.paragraph)
    if lasts and not (_NOT_HERE.search(one.words) or alone):
        return True
    return one.paragraph == item.paragraph and _GOES_ON.match(item.before) is not None


_NEAR = 60
"""So many signs behind a statement are words that may say how long it holds."""


def lasts_to_the_end(one: SourceStatement) -> bool:
    """Whether words beside a statement suppose it for all that follows."""
    return bool(cue("to the end", f"{one.before} § {one.tail[:_NEAR]}"))


_GAP = 3
"""So many signs are between sentences at most that follow each other."""
_IN_CASE = re.compile(
    r"\W*(?:and\s+)?(?:in\s+(?:this|that|such\s+a)\s+(?:\w+\s+)?case|в\s+(?:этом|таком)\s+случае"
    r"|in\s+diesem\s+Fall\w*|dans\s+ce\s+cas)\b",
    re.IGNORECASE,
)
"""How a sentence begins that is about the case of which the one before it spoke."""


def names_case(one: SourceStatement, item: SourceStatement) -> bool:
    """Whether a sentence says that it is about the case that the sentence before it supposes."""
    near = one.paragraph == item.paragraph and 0 <= item.sentence[0] - one.sentence[1] < _GAP
    return near and _IN_CASE.match(item.before) is not None


def is_lifted(
    one: SourceStatement,
    item: SourceStatement,
    items: Iterable[SourceStatement],
    assumptions: Iterable[SourceStatement],
    prose: Prose,
) -> bool:
    """Whether what a statement supposes is over where another one stands.

    What a sentence supposes together is one case; a later one may give a constant another number.
    In the general case constants may still be unequal. Only some ``items`` may lift anything.
    """
    compared = one.formula is not None and not one.members
    if not compared and _is_left(one, item, prose):
        return True
    case = [other for other in assumptions if other.sentence == one.sentence]
    values = {name: value for other in case for name, value in _numbers(other)}
    equal = {name for other in case for name in _equal(other)}
    between = [
        other
        for other in (items if values or equal else ())
        if one.order < other.order < item.order and other.sentence != one.sentence
    ]
    return _are_told_apart(equal, between) or any(
        _is_denied(other, values)
        or _speaks_of_others(other, values, prose)
        or (_gives_another(other, values) and not _is_aside(other, one, item))
        for other in between
    )


_APART = re.compile(
    r"\b(?:different|distinct|unequal|differ|not\s+(?:all\s+)?(?:equal|the\s+same)|no\s+two|различн\w*|неравны\w*"
    r"|разны\w*|не\s+равны|не\s+совпада\w+|verschieden\w*|ungleich\w*|diff\S+rents?|distincts?|in[eé]gaux)\b",
    re.IGNORECASE,
)
"""Words for letters that are not equal."""


def _are_told_apart(equal: set[str], between: Iterable[SourceStatement]) -> bool:
    """Whether a sentence names two of the letters that were equal, and says that they differ."""
    named: dict[tuple[int, int], set[str]] = {}
    for one in between:
        if isinstance(one.formula, Name) and _APART.search(one.words):
            named.setdefault(one.sentence, set()).add(one.formula.name)
    return any(len(equal & names) > 1 for names in named.values())


def _equal(one: SourceStatement) -> Iterator[str]:
    """The letters of constants that a statement makes equal."""
    if len(one.members) > 1 and all(isinstance(member, Name) for member in one.members):
        yield from one.bare


_SUPPOSES = (
    r"\b(?:if|when(?:ever)?|under|provided|suppos\w+|assum\w+|если|при|пусть|когда|предполож\w+)[\s,]+"
    r"(?:(?:that|the|this|both|что|condition|relation|restriction|equality|assumption|hypothesis"
    r"|выполнен\w*|выполня\w+|услови\w+|соотношени\w+|равенств\w+)\s+){0,4}\(?"
)
_FAILS = r"(?!\)?[\s~]*(?:(?:does|do|is)\s+not|fails?|is\s+(?:violated|false|replaced)|не\s|наруш))"
"""What stands before the label of a condition that is supposed, and does not stand behind it."""


def is_cited_as_condition(one: SourceStatement, words: str) -> bool:
    """Whether words suppose, by its label, what a statement says: “if (3) holds”."""
    cited = "|".join(map(re.escape, one.typed.labels))
    condition = rf"{_SUPPOSES}\\(?:eq)?ref\s*\{{(?:{cited})\}}{_FAILS}"
    return bool(cited) and re.search(condition, words, re.IGNORECASE) is not None


def _is_left(one: SourceStatement, item: SourceStatement, prose: Prose) -> bool:
    """Whether words behind what is supposed leave its case; a sentence that cites it does not."""
    if is_cited_as_condition(one, item.before):
        return False
    apart = one.sentence != item.sentence
    start = one.sentence[1] if apart else one.typed.end
    words = f"{prose.between(start, item.typed.start)} § {item.tail}"
    told = [item.before, *item.earlier] if apart else []
    behind = (k for k, said in enumerate(told) if not _GOES_ON.match(said))
    idle = not apart and is_idle(item.before)
    return idle or leaves_case(words, told[: next(behind, 0) + 1])


def has_what_vanishes(item: SourceStatement, one: SourceStatement) -> bool:
    """Whether a later sentence prints a letter that is supposed to be zero: there it is not."""
    zero = {name for name, value in _numbers(one) if value == Number(0)}
    return one.sentence != item.sentence and not zero.isdisjoint(item.names)


def _is_aside(other: SourceStatement, one: SourceStatement, item: SourceStatement) -> bool:
    """Whether a sentence speaks of another case aside: in the paragraph of the first one."""
    return other.paragraph == one.paragraph and other.sentence != item.sentence


def may_lift(one: SourceStatement) -> bool:
    """Whether a statement is a letter alone, or compares one with a number, or gives it one."""
    return isinstance(one.formula, Name) or any(not member.names() for member in _members(one))


def _members(one: SourceStatement) -> tuple[Formula, ...]:
    return one.formula.members if isinstance(one.formula, Relation) else ()


def _gives_another(one: SourceStatement, values: dict[str, Formula]) -> bool:
    """Whether a statement gives a letter another number than it has."""
    return any(values.get(name, value) != value for name, value in _numbers(one))


def _is_denied(one: SourceStatement, values: dict[str, Formula]) -> bool:
    """Whether an inequality does not hold of the number that a letter has."""
    match one.formula:
        case Relation((Name(name), Number(bound)), (sign,)) if name in values:
            value = values[name]
            if isinstance(value, Number):
                return sign in _DENIED[(value.value > bound) - (value.value < bound)]
    return False


def _speaks_of_others(one: SourceStatement, values: dict[str, Formula], prose: Prose) -> bool:
    """Whether words beside a letter that has a number speak of other values of it."""
    if not isinstance(one.formula, Name) or one.formula.name not in values:
        return False
    before = prose.between(max(one.typed.start - _BESIDE, one.sentence[0]), one.typed.start)
    behind = prose.between(one.typed.end, min(one.typed.end + _BESIDE, one.sentence[1]))
    beside = (before.rpartition("§")[2], behind.partition("§")[0])
    if any(map(_OTHERS.search, beside)):
        return True
    gone = any(_VANISHES.search(words) and not _REMAINS.search(words) for words in beside)
    return values[one.formula.name] == Number(0) and not gone


def _numbers(one: SourceStatement) -> Iterator[tuple[str, Formula]]:
    """The names to which an equation gives a number, with it."""
    numbers = [member for member in one.members if not member.names()]
    yield from ((name, number) for number in numbers for name in one.bare)
