r"""Letters of operators: with :math:`D=d/dt` behind them, :math:`Dq` is the rate of q."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.source.displays import TypedFormula

_UPRIGHT = r"\\math(?:rm|sf|bf|cal|scr|bb|frak)\s*(?:\{{\s*{letter}\s*\}}|\s{letter})"
TOTAL = rf"(?:{_UPRIGHT.format(letter='d')}|d)"
_D = rf"(?:{_UPRIGHT.format(letter='d')}|\\partial(?![A-Za-z])|d)"
_INDEX = r"(?:_(?:\w|\\[A-Za-z]+|\{\s*(?:\w|\\[A-Za-z]+)\s*\}))?"
LETTER = rf"(?:{_UPRIGHT.format(letter='[A-Za-z]')}|\\[A-Za-z]+|[A-Za-z]){_INDEX}"
GAP = r"(?:\s|\\[,;:! ]|\{\})*"
_TIME = r"(?P<by>\\[A-Za-z]+|[A-Za-z])"
RATIO = (
    rf"(?:\\[dt]?frac\s*\{{\s*{_D}\s*\}}\s*\{{\s*{_D}{GAP}{_TIME}\s*\}}"
    rf"|{_D}{GAP}/{GAP}{_D}{GAP}{_TIME.replace('by', 'below')})"
)
RATIO_BY = re.compile(
    rf"\}}\s*\{{\s*{TOTAL}{GAP}(?P<by>\\[A-Za-z]+|[A-Za-z])(?:\s*\^\s*\{{?\s*\d\s*\}}?)?\s*\}}"
    rf"|/{GAP}{TOTAL}{GAP}(?P<below>\\[A-Za-z]+|[A-Za-z])"
)
"""The letter by which a quotient of differentials derives."""
_RATIO_ALONE = re.compile(rf"\s*{RATIO}[\s.,;]*")
EQUALS = r"(?::?=|\\equiv|\\coloneqq|\\colon\s*=)"
LABEL = r"\s*(?:\\label\s*\{[^{}]*\}\s*)?"
_GIVEN = re.compile(rf"{LABEL}(?P<letter>{LETTER})\s*{EQUALS}\s*{RATIO}[\s.,;]*")
_DEFINED = re.compile(rf"{LABEL}&?\s*(?P<letter>{LETTER})\s*&?\s*{EQUALS}")
_ALONE = re.compile(rf"\s*(?P<letter>{LETTER})[\s.,;]*")
DERIVATIVE = (
    r"(?:differential\s+)?(?:operator\s+of\s+)?(?:total\s+|time\s+|ordinary\s+)*"
    r"(?:derivative|differentiation|derivation)(?:\s+operator)?"
)
BY = (
    r"\s+(?:with\s+respect\s+to|in|by)(?:\s+(?:the|its|variable|physical|new|independent|affine"
    r"|polar|azimuthal|angle|angular|true|eccentric|anomaly|longitude|coordinate|parameter"
    r"|argument|arc[\s-]*length|proper\s+time))*\s*"
)
_SAID = re.compile(
    r"[\s,~]*(?:(?:denotes?|be|is|means|stands\s+for|for|being|as)\s+)?(?:the\s+)?"
    rf"{DERIVATIVE}{BY}(?:time\b|§)"
    r"|[\s,~]*(?:denotes?|be|is|means|stands\s+for|for|being|as)\s+(?:the\s+)?time\s+derivative\b"
    r"|[\s,~]*(?:[-—–]+\s*|есть\s+|означает\s+|обозначает\s+)?(?:оператор\w*\s+)?"
    r"(?:полн\w+\s+)?(?:дифференцировани\w+|производн\w+)\s+по\s+(?:времени\b|(?:переменн\w+\s+)?§)"
    r"|[\s,~]*(?:die|la)\s+(?:Ableitung\s+nach(?:\s+der)?|d[ée]riv[ée]e\s+par\s+rapport\s+"
    r"(?:à|a|au))\s+(?:Zeit\b|temps\b|§)",
    re.IGNORECASE,
)
"""What words say behind the letter of an operator; a mark is the formula behind them."""
_OF_SOMETHING = re.compile(r"[\s$~)\\]*(?:of|от|von|de)\b")
"""How words go on that say of what something is the derivative: it is no operator."""
_STANDS_FOR = re.compile(
    r"[\s,~]*(?:(?:denotes?|stands\s+for|is|means|for|instead\s+of|abbreviates"
    r"|(?:in|for)\s+place\s+of|[-—–]+|есть|вместо|означает|обозначает)\s*)?"
    r"(?:the\s+)?(?:operator\s+|оператор\s+)?",
    re.IGNORECASE,
)
"""The words between a letter and the quotient for which it stands."""
_OPEN, _CLOSE = r"(?:\\(?:left|[bB]igg?l?)\s*)?(?:\(|\[|\\\{)", r"(?:\\(?:right|[bB]igg?r?)\s*)?"
_BRACKETS = re.compile(r"\(|\[|\\\{|\)|\]|\\\}")
_GROUP = re.compile(rf"{GAP}(?P<group>{_OPEN})")
_HAT = r"\\(?:d{1,4}ot|bar|hat|tilde|vec|math(?:bf|rm|cal|scr)|boldsymbol|bm|mathbf|overline)"
_NAME = (
    rf"(?:{_HAT}\s*\{{[^{{}}]*(?:\{{[^{{}}]*\}}[^{{}}]*)*\}}|{_HAT}\s*(?:\\[A-Za-z]+|[A-Za-z])"
    r"|\\(?!left|right|[bB]ig|[dt]?frac|cdot|times|partial|q?quad|to|in|sum|sqrt|text|mbox"
    r"|ln|log|exp|a?r?c?(?:sin|cos|tan|cot)h?|arc[a-z]+|s[nh]|int)[A-Za-z]+|[A-Za-z])"
    r"(?:_(?:\w|\\[A-Za-z]+|\{[^{}]*\}))?'*"
)
_OF_NAME = re.compile(rf"{GAP}(?P<name>{_NAME})")
_QUOTIENT = re.compile(
    rf"{GAP}(?P<quotient>\\[dt]?frac\s*(?:\{{[^{{}}]*(?:\{{[^{{}}]*\}}[^{{}}]*)*\}}\s*){{2}})"
)
_POWER = re.compile(r"\s*\^\s*(?:(\d)|\{\s*(\d+)\s*\})")
_RUNS_ON = re.compile(
    r"\s*(?:\^|[A-Za-z(\[]|\\(?!q?quad|[,;:! \\]|[a-z]*eq|[lg]e|cdot|[lr]ight|[bB]ig|end)[A-Za-z])"
)
_ENDS = re.compile(
    r"\s*(?:\^\s*(?:\d|\{\s*\d+\s*\})\s*)?(?:$|[=+\-,;)}/]|\\(?:q?quad|cdot|right|le|ge|\\)(?![A-Za-z]))"
)
"""What stands behind a quantity: nothing on which it acts."""
_ROW = re.compile(rf"(?P<letter>(?:\\partial|d|D)_(?:t|\{{t\}}))\s*(?P<of>{_NAME})\s*&?\s*=")
_OTHERS = re.compile(r"\\d{1,4}ot(?![A-Za-z])|\\partial(?!_(?:t|\{t\}))|'")
_AROUND = 90

HOW_FAR = "how far does the operator {} reach? set brackets"


def with_operators(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    r"""The formulas, with derivatives where the letter of an operator stands that derives.

    What it is, a formula says, as :math:`D=d/dt`, or words, as “D denotes the derivative with
    respect to t”; without words :math:`\partial_tx=y` are equations of motion where no other
    derivative is printed. A letter that another formula gives is no operator.
    """
    said = {
        letter: by
        for letter, by in _said(formulas, text)
        if not any(_is_quantity(one.tex, letter) for one in formulas)
    }
    letters = {**_rated(formulas), **said}
    given = [found for one in formulas if (found := _DEFINED.match(one.tex))]
    other = {_plain(one["letter"]) for one in given if not _GIVEN.fullmatch(one.string)}
    letters = {letter: by for letter, by in letters.items() if letter not in other}
    for formula in formulas:
        own = _GIVEN.fullmatch(formula.tex)
        if own and _plain(own["letter"]) in letters:
            yield replace(formula, tex=own["letter"])
            continue
        if letters and (ratio := _RATIO_ALONE.fullmatch(formula.tex)):
            yield replace(formula, tex=by_of(ratio))  # which is said of the letter beside it
            continue
        yield _derived(formula, letters)


def _plain(letter: str) -> str:
    """A letter, printed as all such letters are."""
    return re.sub(r"[\s{}]|\\math[a-z]+(?![A-Za-z])", "", letter)


def by_of(found: re.Match[str]) -> str:
    """The letter by which a quotient of differentials derives."""
    return found["by"] or found["below"]


def _rated(formulas: Sequence[TypedFormula]) -> Mapping[str, str]:
    r"""The letters, as :math:`d_t`, that derive without words: nothing else does so."""
    if any(_OTHERS.search(one.tex) for one in formulas):
        return {}
    rows = (found for one in formulas for found in _ROW.finditer(one.tex))
    return {_plain(found["letter"]): "t" for found in rows}


def _said(formulas: Sequence[TypedFormula], text: str) -> Iterator[tuple[str, str]]:
    """The letters of operators that formulas or words give, each with what it derives by."""
    for place, one in enumerate(formulas):
        if found := _GIVEN.fullmatch(one.tex):
            yield _plain(found["letter"]), by_of(found)
        behind = formulas[place + 1] if place + 1 < len(formulas) else None
        alone = _ALONE.fullmatch(one.tex) if one.inline else None
        ratio = _RATIO_ALONE.fullmatch(one.tex)
        between = text[one.end : behind.start if behind else one.end + _AROUND].strip("$()\\ \n")
        next_to = behind is not None and behind.start - one.end < _AROUND
        if alone is not None:
            mark = "§" if next_to else ""
            said = _SAID.match(f" {' '.join(between.split())} {mark}")
            by = _ALONE.fullmatch(behind.tex) if behind and said and said[0].endswith("§") else None
            given = _RATIO_ALONE.fullmatch(behind.tex) if behind and next_to else None
            of = text[behind.end :] if behind and by else text[one.end + len(between) :]
            if said and not _OF_SOMETHING.match(of):
                yield _plain(alone["letter"]), by["letter"] if by else "t"
            elif given and _STANDS_FOR.fullmatch(between):
                yield _plain(alone["letter"]), by_of(given)
        if ratio and behind and next_to and re.fullmatch(r"by|with|through|через", between):
            if letter := _ALONE.fullmatch(behind.tex):
                yield _plain(letter["letter"]), by_of(ratio)


def _derived(formula: TypedFormula, letters: Mapping[str, str]) -> TypedFormula:
    """A formula in which derivatives are printed for the letters of operators."""
    tex, trouble = formula.tex, formula.trouble
    for letter, by in letters.items():
        if _ALONE.fullmatch(tex):
            break
        printed = _printed(letter)
        pieces, at = [], 0
        for found in printed.finditer(tex):
            if found.start() < at:
                continue
            applied = _applied(tex, found.end(), by, printed)
            if applied is None:
                trouble = trouble or HOW_FAR.format(found[0].strip())
                continue
            pieces += [tex[at : found.start()], applied[0]]
            at = applied[1]
        tex = "".join((*pieces, tex[at:]))
    if (tex, trouble) == (formula.tex, formula.trouble):
        return formula
    return replace(formula, tex=tex, trouble=trouble)


def _is_quantity(tex: str, letter: str) -> bool:
    """Whether a letter stands for something by itself in a formula that says more than it does."""
    if _ALONE.fullmatch(tex) or _GIVEN.fullmatch(tex):
        return False
    ends = (tex[found.end() :] for found in _printed(letter).finditer(tex))
    return any(_ENDS.match(rest) for rest in ends)


def _printed(letter: str) -> re.Pattern[str]:
    """Where a letter is printed, in whatever type."""
    head, _, index = letter.partition("_")
    own, below = re.escape(head), re.escape(index)
    typed = rf"{_UPRIGHT.format(letter=own)}|{own}" if head.isalpha() else own
    whole = r"(?![A-Za-z])" if head.startswith("\\") else ""
    ends = rf"\s*_\s*(?:{below}|\{{\s*{below}\s*\}})" if index else r"(?!\s*_)"
    return re.compile(rf"(?<![A-Za-z\\_^])(?<![_^]\{{)(?:{typed}){whole}{ends}")


def _applied(tex: str, at: int, by: str, letter: re.Pattern[str]) -> tuple[str, int] | None:
    """The derivative of what stands behind an operator, and where that ends."""
    power = _POWER.match(tex, at)
    order = (power[1] or power[2]) if power else ""
    at = power.end() if power else at
    above = f"d^{order}" if order else "d"
    below = f"d{by}^{order}" if order else f"d{by}"
    ratio = rf"\frac{{{above}}}{{{below}}}"
    if group := _GROUP.match(tex, at):
        end = _closed(tex, group.start("group"))
        return (ratio + tex[group.start("group") : end], end) if end else None
    if found := _QUOTIENT.match(tex, at):
        return rf"{ratio}\left({found['quotient']}\right)", found.end()
    found = _OF_NAME.match(tex, at)
    if found is None or (_RUNS_ON.match(tex, found.end()) and not letter.match(tex, found.end())):
        return None
    return rf"\frac{{{above}{found['name']}}}{{{below}}}", found.end()


def _closed(tex: str, at: int) -> int:
    """Where a bracket ends that opens at a place; 0 if it does not."""
    depth = 0
    for found in _BRACKETS.finditer(tex, at):
        depth += 1 if found[0].endswith(("(", "[", "{")) else -1
        if depth == 0:
            return found.end()
    return 0
