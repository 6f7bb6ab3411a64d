r"""Functions of which a paper says nothing but what they are functions of, as a potential V(r).

They are names for any values, and so are their derivatives (:mod:`kowalevski_cas.paper.jets`): what
is proved holds for all functions. One that is given anywhere, as by :math:`V(r)=-k/r`, is not any.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

from kowalevski_cas.notation import NotationError
from kowalevski_cas.notation.cursor import is_known
from kowalevski_cas.notation.functions import FUNCTIONS, LETTERS
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.chains import NAME
from kowalevski_cas.paper.initial_values import names_under_dots
from kowalevski_cas.paper.jets import APPLIED, Unknown, arguments, with_jets, without_argument
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.reading.reciprocals import with_reciprocals
from kowalevski_cas.source.displays import TypedFormula

TIME = "t"
_D = r"(?:\\mathrm\s*\{?\s*d\s*\}?|(?<![A-Za-z\\])d)"
_DERIVED = re.compile(
    rf"\\[dt]?frac\s*\{{\s*{_D}\s*(?P<name>{NAME})\s*\}}\s*\{{\s*{_D}\s*(?P<by>{NAME})\s*\}}"
    rf"|{_D}\s*(?P<of>{NAME})\s*/\s*{_D}\s*(?P<at>{NAME})"
)
"""The derivative of a name by another one."""
_RATE = re.compile(
    rf"\\[dt]?frac\s*\{{\s*{_D}(?:\s*\^\s*\d)?\s*(?P<name>{NAME})\s*\}}\s*\{{\s*{_D}\s*t"
    rf"|{_D}(?:\s*\^\s*\d)?\s*(?P<of>{NAME})\s*/\s*{_D}\s*t"
)
"""A rate that is printed as a quotient."""
_WORDS = (
    r"\\(?:begin|end|label|tag|text|mathrm|mathbf|boldsymbol|operatorname\*?)\s*\{[^{}]*\}"
    r"|\\\\\s*\[[^\]]*\]"
)
_RUN = re.compile(rf"{_WORDS}|\\[A-Za-z]+|[A-Za-z](?=[A-Za-z])")
"""A letter right before another one, which is a factor; or a macro, which is a whole."""
_TYPES = (
    r"\\(?:(?:wide)?(?:tilde|hat)|bar|(?:over|under)line|check|breve|vec|math[a-z]+|boldsymbol"
    r"|cal|bf)(?![A-Za-z])"
)
"""What makes another name of a letter."""
_SECTION = re.compile(r"\\(?:section|chapter)\s*\*?\s*(?:\[[^\]]*\])?\s*\{")


def is_of_case(words: str) -> bool:
    """Whether words before a formula in its sentence call it one of several, or number it."""
    return _SPECIAL.search(words) is not None or _ENTRY.match(words) is not None


def free_functions(formulas: Sequence[TypedFormula], text: str) -> tuple[Unknown, ...]:
    """The functions at what moves, of which nothing gives the values, each with its arguments.

    In another section a letter may be a function of something else.
    """
    texts = [_apart(one.tex) for one in formulas]
    times = other_times(one.tex for one in formulas)
    told_by = _told_in_words(formulas, text)
    timed = _told_of_time(formulas, text) | {one for one, by in told_by.items() if by == TIME}
    moving = set[str]().union(*map(_rated, texts)) | {TIME}
    dotted = set[str]().union(*map(names_under_dots, texts))
    given = {
        name
        for place, tex in enumerate(texts)
        for name in _given(tex)
        if name not in timed and not _is_special(name, place, formulas, text)
    }
    lists: dict[str, dict[int, set[tuple[str, ...]]]] = defaultdict(lambda: defaultdict(set))
    orders: dict[str, int] = defaultdict(int)
    sure: set[str] = set()
    for formula, tex in zip(formulas, texts, strict=True):
        section = sum(1 for _ in _SECTION.finditer(text, 0, formula.start))
        for name, by, order in _applications(tex, times):
            if {*by} <= moving | given:
                lists[name][section].add(by)
                orders[name] = max(order, orders[name])
                sure |= {name} if order or {*by} <= moving or _says(tex, name) else set()
    alone = timed - lists.keys()
    found = [Unknown(name, (TIME,), _order(name, texts)) for name in sorted(alone)]
    for name, one in told_by.items():
        if name not in lists and one in moving - {TIME} and _may_be_any(name, given, texts):
            found.append(Unknown(name, (one,), 1))
    for name in lists:
        every = dict.fromkeys(by for own in lists[name].values() for by in own)
        several = any(len(own) > 1 for own in lists[name].values())
        if name in timed and {*every} == {(TIME,)}:
            found.append(Unknown(name, (TIME,), max(orders[name], _order(name, texts))))
            continue
        told = name in sure and (TIME,) not in every
        primed = {by for one in every for by in one} <= dotted
        may_be = not several and _may_be_any(name, given, texts, primed)
        if may_be and (told or not _alone(name, texts)):
            found += [Unknown(name, by, orders[name]) for by in every]
    return (*found, *_with_gradients(texts, {*given, *lists}))


def told_since(
    functions: Iterable[Unknown], formulas: Sequence[TypedFormula], text: str
) -> dict[str, int]:
    """Where the section begins that first makes names, and their derivatives, functions of time."""
    names = names_of(one for one in functions if one.by == (TIME,))
    starts = [one.start() for one in _SECTION.finditer(text)] if names else []
    since: dict[str, int] = {}
    for start, end in zip([0, *starts], [*starts, len(text)], strict=True):
        if names - since.keys():
            before = [one for one in formulas if one.start < end]
            told = names_of(free_functions(before, text[:end]))
            since |= dict.fromkeys(names & told - since.keys(), start)
    return since


_BOLD = r"\\(?:mathbf|boldsymbol|bm|vec)\s*(?:\{\s*\\?[A-Za-z]+\s*\}|\s\\?[A-Za-z]+|\\[A-Za-z]+)"
_GRADIENT = re.compile(
    rf"\\[dt]?frac\s*\{{\s*\\partial\s*(?P<name>{NAME})\s*\}}\s*\{{\s*\\partial\s*(?P<by>{_BOLD})\s*\}}"
)


def _with_gradients(texts: Sequence[str], given: Collection[str]) -> Iterator[Unknown]:
    """The functions that nothing gives, with the vectors by which they are derived."""
    by: dict[str, dict[str, None]] = defaultdict(dict)
    for found in (one for tex in texts for one in _GRADIENT.finditer(tex)):
        by[found["name"].replace(" ", "")] |= dict.fromkeys(arguments(found["by"]))
    for name, vectors in by.items():
        if _may_be_any(name, given, texts):
            yield Unknown(name, (*vectors,), 1)


def _apart(tex: str) -> str:
    """A formula with spaces between letters that are factors, as in xV(x)."""
    return _RUN.sub(lambda found: f"{found[0]} " if len(found[0]) == 1 else found[0], tex)


_CLOCK = re.compile(
    rf"(?<![A-Za-z\\]){_D}\s*(?:t(?![A-Za-z_])|(?P<first>{NAME}))[^=;]*=[^=;]*{_D}\s*(?:t(?![A-Za-z_])|(?P<last>{NAME}))"
)
"""What gives another time: differentials of two names on both sides, one of them of t."""


def other_times(texts: Iterable[str]) -> set[str]:
    """The times that a paper has, with those by which it derives along the motion."""
    found = (one for tex in texts for one in _CLOCK.finditer(tex))
    pairs = [one.group("first", "last") for one in found]
    return {TIME, *(name for pair in pairs if pair.count(None) == 1 for name in pair if name)}


def _applications(
    tex: str, times: Collection[str] = (TIME,)
) -> Iterator[tuple[str, tuple[str, ...], int]]:
    """The names with arguments in brackets, and those that are derived by what is no time."""
    for match in APPLIED.finditer(tex):
        with suppress(NotationError, ValueError):
            yield match["name"].replace(" ", ""), (*arguments(match["by"]),), len(match["primes"])
    for match in _DERIVED.finditer(tex):
        if (by := match["by"] or match["at"]) not in times:
            yield match["name"] or match["of"], (by,), 1


def _says(tex: str, name: str) -> bool:
    """Whether a formula is a function at its argument, or says that a name is one, as f=f(x)."""
    left, equals, right = tex.strip(" .,;").rpartition("=")
    return APPLIED.fullmatch(right.strip()) is not None and (not equals or left.strip() == name)


_OF_TIME = re.compile(
    r"[$\s~)\\]*(?:of\s+(?:the|a)\s+\w+\s+)?(?:is|be|are|denotes?|[-—–]+|есть)?\s*(?:an?|the|some|any)?\s*(?:[\w-]+\s+){0,3}?"
    r"(?:function|функци)",
    re.IGNORECASE,
)
"""How words begin behind what they call a function."""


_GIVEN = re.compile(
    r"\b(?:given|known|prescribed|arbitrary)\b|\b(?:задан|известн|произвольн)\w+", re.IGNORECASE
)
"""Words for a function that no equation determines."""


def _told_of_time(formulas: Sequence[TypedFormula], text: str) -> set[str]:
    """The names at the time in a formula by itself: these are functions, and no products.

    They stand in equations for something else, too: at the time, if they are not said to be given.
    Where no words call them functions nothing is printed that gives them.
    """
    found: dict[str, bool] = {}
    given = {name for one in formulas for name in _given(_apart(one.tex))}
    for formula in formulas:
        match = APPLIED.fullmatch(formula.tex.strip())
        if match and match["by"] == TIME:
            name, said = match["name"].replace(" ", ""), _OF_TIME.match(text, formula.end)
            if said or name not in given:
                found[name] = bool(said and _GIVEN.search(said[0]))
    rows = [one.tex for one in formulas if not one.inline and names_under_dots(one.tex)]
    moved = {*_moved(rows)}
    alone = {
        name
        for name, is_given in found.items()
        if any(map(partial(_stands, name, anywhere=is_given), rows)) and name not in moved
    }
    general = {
        name
        for place, one in enumerate(formulas)
        for name in _given(_apart(one.tex))
        if not _is_special(name, place, formulas, text)
    }
    return alone | _stand_at_time(_parts_of(one.tex for one in formulas), moved, general)


def _stand_at_time(
    parts: Sequence[str], moved: Collection[str], given: Collection[str]
) -> set[str]:
    r"""The names at the time in equations of motion of others, as :math:`\ddot x+k^2(t)x=0`.

    Nobody prints the time alone in brackets as a factor. Where such a name has a rate, the equation
    is one for something else: for what is moved, or given, or stands nowhere at the time and is
    derived more often.
    """
    at = [{name for name, by, _ in _applications(part) if by == (TIME,)} for part in parts]
    rates = [{name: _order(name, [part]) for name in _rated(part)} for part in parts]
    others = {*moved, *given}
    found = {name for own, rated in zip(at, rates, strict=True) if rated for name in own - {*rated}}
    for rated in rates:
        for name in found & {*rated}:
            more = {one for one, order in rated.items() if order > rated[name]}
            if not ({*rated} - {name}) & others and more <= set().union(*at):
                found.remove(name)
    return found - others


def _rated(tex: str) -> set[str]:
    """The names of which rates are printed."""
    quotients = {(one["name"] or one["of"]).replace(" ", "") for one in _RATE.finditer(tex)}
    return names_under_dots(tex) | quotients


def _moved(texts: Iterable[str]) -> Iterator[str]:
    """The names of which equations say how they move: no rate of another one stands there."""
    for part in _parts_of(texts):
        rated = _rated(part)
        yield from rated if len(rated) == 1 else ()


def _parts_of(texts: Iterable[str]) -> list[str]:
    """The parts of formulas between commas and the like."""
    return [part for tex in texts for part in _PARTS.split(tex)]


def _on(group: str) -> str:
    """What something may be a function of: the time, or a letter, which is a group."""
    letter = rf"(?:\w+\s+){{0,2}}\$\s*(?P<{group}>{NAME})\s*\$"
    return rf"(?:(?:(?:the|le)\s+)?(?:time\b|времен\w+|der\s+Zeit|temps\b)|{letter})"


_VARIES = re.compile(
    r"\$?[\s~]*(?:(?:that|which|now|itself|to)\s+)*(?:(?:may|can|is\s+allowed\s+to)\s+)?(?:slowly\s+|медленно\s+)?(?:"
    r"(?:vary|varies|changes?|depends?|depending|varying|hängt|d(?:\\'e|é)pend|varie)(?:\s+\w+ly)?"
    rf"\s+(?:with|in|on|upon|von|du|avec|de)\s+{_on('by0')}"
    rf"|,?\s*(?:(?:is|be|being|ist|est)\s+)?(?:an?|eine|une)\s+(?:\w+\s+){{0,3}}?f[ou]n[ck]tion\s+(?:of|du)?\s*{_on('by1')}"
    rf"|(?:за\w+|меняется)\s+(?:от|со?)\s+{_on('by2')}"
    rf"|(?:[-—–]+|есть|является)\s*(?:\w+\s+){{0,2}}?функци\w+\s+{_on('by3')})",
    re.IGNORECASE,
)
"""How words begin behind a letter that say on what it depends."""
_IS_VARIABLE = re.compile(
    r"\$?[\s~]*(?:(?:that|which|now|itself|to)\s+)*(?:(?:may|can|will|must)\s+)?(?:\w+ly\s+)?(?:"
    r"(?:is|are|be|being|remains)\s+(?:not\s+(?:an?\s+)?constant|(?!not\b|no\b|the\b)(?:\w+\s+){0,2}?(?:variable|time-dependent|modulated"
    r"|non-?constant|varying|unsteady|periodic\s+function(?!\s+of)))|need\s+not\s+be\s+(?:an?\s+)?constant"
    r"|(?:changes?|var(?:y|ies)|(?:in|de)creases?|grows?|decays?|oscillates?|evolves?|fluctuates?|drifts?)\b"
    r"(?!(?:\s+\w+ly)?\s+(?:from|between|over|as|on|if|when|only|sign|like|beyond|to|by|with(?!\s+(?:the\s+)?time))\b|\s*\$)"
    r"|(?:(?:из)?меняется|раст[её]т|убывает|колеблется)\b(?!\s+(?:от|при|лишь|с(?!о\s+времен)))|(?:[-—–]+\s*)?(?:переменн[аоы]|не\s+постоян|непостоян)\w*"
    r"|ist\s+(?:nicht\s+konstant|ver\S{1,3}nderlich|zeitabh)|est\s+variable)",
    re.IGNORECASE,
)
"""How words begin behind a letter that is no constant."""
_AS_IF = re.compile(
    r"\b(?:if|when|whenever|as|while|for|given|fixed|если|когда|при|wenn|si|lorsque)\s+(?:(?:the|an?)\s+)?(?:\w+\s+){0,2}\$?$",
    re.IGNORECASE,
)
"""How words end before a letter of which other values are thought of."""
_VARIABLE = re.compile(
    r"\b(?:variable|(?:slowly\s+)?varying|time-dependent|переменн\w+)\s+"
    r"(?:mass|length|frequency|stiffness|moment|coefficient|field|radius|масс\w+|длин\w+|частот\w+|жесткост\w+)\s*(?:is\s+)?\$?$",
    re.IGNORECASE,
)
"""How words end before a letter that is no constant."""


def _told_in_words(formulas: Sequence[TypedFormula], text: str) -> dict[str, str]:
    """The letters that words make functions of one thing, or an equation as m=m(t), with that.

    They stand alone in equations for something else, of which nothing says how they move.
    """
    found: dict[str, str] = {}
    for formula in formulas:
        name, equals, right = formula.tex.replace(" ", "").partition("=")
        match = APPLIED.fullmatch(right)
        if equals and match and match["name"] == name and match["by"] == TIME:
            found[name] = TIME
        elif formula.inline and re.fullmatch(NAME, formula.tex.strip()):
            if said := _VARIES.match(text, formula.end):
                by = next((said[f"by{k}"] for k in range(4) if said[f"by{k}"]), TIME)
                found[formula.tex.strip()] = by.strip()
            elif _is_variable(formula, text):
                found[formula.tex.strip()] = TIME
    moved = {*_moved(one.tex for one in formulas)}
    given = {name for one in formulas for name in _given(_apart(one.tex))}
    used = {name for one in formulas for name in re.findall(NAME, _apart(one.tex))}
    primed = {
        name
        for one in formulas
        for name in re.findall(rf"({NAME})\s*(?:'|\^\s*\{{?\s*\\prime)", one.tex)
    }
    kept = used - moved - given - primed
    return {name: by for name, by in found.items() if name in kept and name != by}


def _is_variable(letter: TypedFormula, text: str) -> bool:
    """Whether words beside a letter say that it is no constant, and not on what it depends."""
    if _VARIABLE.search(text, 0, letter.start):
        return True
    return _IS_VARIABLE.match(text, letter.end) is not None and not _AS_IF.search(
        text, max(0, letter.start - 60), letter.start
    )


def _stands(name: str, tex: str, anywhere: bool) -> bool:
    """Whether a name stands in a formula at the time, or ``anywhere``."""
    if anywhere:
        return name in re.findall(NAME, _apart(tex))
    return any(one[:2] == (name, (TIME,)) for one in _applications(tex))


_PARTS = re.compile(r"(?<!\\)[,;]|\\\\|\\q?quad(?![A-Za-z])")
_DOTS = r"\\(?P<dots>d{1,3})ot(?![A-Za-z])"
_AT_TIME = r"\s*(?:\\left\s*)?\(\s*t\s*(?:\\right\s*)?\)"


def _with_primes(tex: str, name: str) -> str:
    """A formula with the derivatives of a function of the time by primes instead of dots."""
    dotted = (
        rf"{_DOTS}\s*(?:\{{\s*{re.escape(name)}\s*\}}|{re.escape(name)}(?![A-Za-z]))(?:{_AT_TIME})?"
    )
    return re.sub(dotted, lambda found: name + "'" * len(found["dots"]), tex)


def _order(name: str, texts: Iterable[str]) -> int:
    """The highest order in which a name is derived by dots."""
    dotted = re.compile(rf"{_DOTS}\s*\{{?\s*{re.escape(name)}(?![A-Za-z])")
    return max((len(found["dots"]) for tex in texts for found in dotted.finditer(tex)), default=0)


def _alone(name: str, texts: Iterable[str]) -> bool:
    """Whether a name stands anywhere without an argument, and nothing says there what it is."""
    letter = rf"(?<![A-Za-z\\]){re.escape(name)}(?![A-Za-z_])"
    return any(
        len(re.findall(letter, tex)) > sum(one[0] == name for one in _applications(tex))
        and not _says(tex, name)
        for tex in texts
    )


def _may_be_any(
    name: str, given: Iterable[str], texts: Sequence[str], primed: bool = False
) -> bool:
    """Whether a name is a letter that nothing gives, in one type, and without printed rates.

    Primes without an argument behind them are rates, if it is not ``primed`` by its argument.
    """
    own = re.escape(name)
    primes = "" if primed else rf"|(?<![A-Za-z\\]){own}'+(?!['\s^{{}}\d]*(?:\\left\s*)?\()"
    rated = re.compile(
        rf"\\d{{1,3}}ot\s*\{{?\s*{own}(?![A-Za-z])|d(?:\s*\^\s*\d)?\s*{own}\s*\}}?\s*(?:\{{|/)\s*d\s*t"
        rf"|{_TYPES}\s*\{{?\s*{own}(?![A-Za-z]){primes}"
    )
    letter = is_known(symbol(name).letter) and not symbol(name).is_bold
    known = {*given, *FUNCTIONS, *LETTERS, "d", "e", "i"}
    return letter and name not in known and not any(map(rated.search, texts))


_GIVING = re.compile(
    r"(?:^|[,;:]|\\\\|\\q?quad(?![A-Za-z])|\\(?:begin|label)\s*\{[^{}]*\})\s*(?:\d\s*)?"
    rf"\{{?\s*(?P<name>{NAME})\s*\}}?\s*(?:\\left\s*)?(?P<at>\([^()]*\))?\s*&?="
    r"(?P<right>(?:(?!\\\\)[^=,;()]|\([^()]*\))*)"
)
"""A name, or a multiple of one, alone on a left side."""


_PARTIAL = re.compile(rf"\\partial\s*(?P<name>{NAME})")
"""The function of which a partial derivative is printed."""
_LABEL = r"(?:\\item(?:\s*\[[^\]]*\])?|\(?\w{1,4}\))"
"""How the entry of a list is called, or what begins with it."""
_SPECIAL = re.compile(
    r"\b(?:examples?|instance|cases?|special|particular|consider|if|when|for|let|take|put|choose)\b"
    r"|\b(?:рассмотрим|например|частн\w+|случа\w+|если|при|когда|для|пусть|возьм[её]м|положим)\b",
    re.IGNORECASE,
)
"""Words for one of many functions."""
CONSIDER = re.compile(
    r"\b(?:consider|рассмотрим)(?:\s+\w+){0,3}[\s:~]*(?:\\begin\W.*|\\\[\s*|\$\$\s*)?$",
    re.IGNORECASE,
)
"""How words end behind which a function is given that is not called an example of several."""
_EXAMPLE = re.compile(r"\b(?:examples?|instance|case|например|пример\w*|случа\w+)\b", re.IGNORECASE)
_ENTRY = re.compile(rf"\s*{_LABEL}\s*(?:\$|$)")
_GENERAL = 2
"""In so many displays a function stands before it has a special value: in a law, and of any.

So many partial derivatives are enough.
"""


_STOP = re.compile(r"[.;!?]\s|[.;!?]\s*(?:\\end\s*\{\w+\*?\}|\$\$|\\\])|\n\n")
_FOOTNOTE = re.compile(r"\\footnote\s*\{(?:[^{}]|\{[^{}]*\})*\}")


def _is_special(name: str, place: int, formulas: Sequence[TypedFormula], text: str) -> bool:
    """Whether a function that was any in displays before is given as an example of one."""
    formula = formulas[place]
    sentence = _STOP.split(text[: formula.start])[-1]
    before = [
        _apart(one.tex)
        for one in formulas[:place]
        if not one.inline and one.end <= formula.start - len(sentence)
    ]
    sentence = _STOP.split(_FOOTNOTE.sub(" ", text[: formula.start]))[-1]
    applied = sum(any(name == other for other, *_ in _applications(tex)) for tex in before)
    derived = sum(one["name"] == name for tex in before for one in _PARTIAL.finditer(tex))
    having = [tex for tex in before if re.search(rf"{re.escape(name)}(?![A-Za-z])", tex)]
    if having == before[-1:] and CONSIDER.search(sentence) and not _EXAMPLE.search(sentence):
        return False  # only the equation before it has it, and nothing is said of any function
    return max(applied, derived) >= _GENERAL and is_of_case(sentence)


def _given(tex: str) -> Iterator[str]:
    """The names alone on a left side, but for those that are said to be functions there.

    At an argument that does not stand on the right an equation says where something is.
    """
    for found in _GIVING.finditer(tex):
        name, right = found["name"].replace(" ", ""), found["right"]
        by = re.findall(NAME, found["at"] or "")
        rest = re.findall(NAME, _apart(tex[found.start("right") :]))
        at = not by or any(one in rest for one in by)
        if at and not _says(f"{name}={right}", name):
            yield name


def with_names_alone(
    formulas: Sequence[TypedFormula], functions: Sequence[Unknown]
) -> Iterator[TypedFormula]:
    """The formulas with these functions by their names, and derivatives by primes.

    One that has a function at something else cannot be read.
    """
    for place, formula in enumerate(formulas):
        tex = with_reciprocals(_apart(formula.tex), formulas[:place]) if functions else formula.tex
        tex = _DERIVED.sub(lambda found: _primed(found, functions), _apart(tex))
        for one in functions:
            tex = _with_primes(tex, one.name) if one.by == (TIME,) else tex
        own = [one for one in functions if any(a[:2] == one[:2] for a in _applications(tex))]
        others = [one for one in functions if one.name not in {o.name for o in own}]
        try:
            tex = without_argument(tex, [*own, *others])
        except ValueError as error:
            yield replace(formula, trouble=formula.trouble or str(error))
            continue
        yield formula if tex == _apart(formula.tex) else replace(formula, tex=tex)


def _primed(found: re.Match[str], functions: Sequence[Unknown]) -> str:
    name, by = found["name"] or found["of"], found["by"] or found["at"]
    return f"{name}'" if any(one[:2] == (name, (by,)) for one in functions) else found[0]


def names_of(functions: Iterable[Unknown]) -> frozenset[str]:
    """The names of some functions, and of all their derivatives that are known."""
    jets = (jet for one in functions for jet in one.jets({}))
    return frozenset(name for jet, following, _ in jets for name in (jet, following))


def with_free_functions(scene: Scene, functions: Iterable[Unknown]) -> Scene:
    """A scene with some functions, of which it may define derivatives by something else.

    Raises:
        ValueError: an argument does not move there, or a name is a function of several things.
    """
    jets: list[tuple[str, str, str]] = []
    for one in functions:
        if any(one.name == name for name, _, _ in jets):
            raise ValueError(f"{one.name} is a function of several things")
        if still := [by for by in one.by if by in scene.constants]:
            raise ValueError(f"{one.name} is a function of {still[0]}, which does not move here")
        jets += [jet for jet in one.jets(scene.vectors) if jet[0] not in scene.definitions]
    return with_jets(scene, jets)
