r"""What a source defines: its macros in their order, and what cannot be told.

``\newcommand`` and its like, ``\DeclareMathOperator``, ``\def``, ``\gdef``, ``\edef``, ``\xdef``
and ``\let`` are understood where they stand outside of all groups: they hold from there on.
Whatever else gives a name a meaning makes the name unclear, and what changes the meaning of
characters makes all formulas unclear. An unclear name is nowhere written out.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

FAILURES = 20
"""Definitions that are not understood, after which no more are looked for."""

_DEFINING = re.compile(
    r"\\(?:(?P<new>newcommand|renewcommand|providecommand|DeclareRobustCommand)"
    r"|(?P<operator>DeclareMathOperator)|(?P<def>def|gdef|edef|xdef)|(?P<let>let)"
    r"|(?P<other>futurelet|mathchardef|chardef|newif|DeclareMathSymbol|DeclareMathAccent"
    r"|DeclareMathDelimiter|(?:New|Renew|Provide|Declare)DocumentCommand|newcommandx"
    r"|DeclarePairedDelimiter)"
    r"|(?P<environment>(?:re)?newenvironment))(?![A-Za-z])\*?\s*"
)
_CHANGING = re.compile(
    r"\\(?:catcode(?!\s*`\\?@)|mathcode|delcode|lccode|uccode|everymath|everydisplay|@namedef"
    r"|expandafter\s*\\(?:[gex]?def|let|(?:re)?newcommand))(?![A-Za-z])"
)
_NAME = re.compile(r"\s*(?:\{\s*(\\(?:[A-Za-z@]+|.))\s*\}|(\\(?:[A-Za-z@]+|.)))\s*", re.DOTALL)
_TARGET = re.compile(r"=?\s*(\\(?:[A-Za-z@]+|.)|[^\s{}])", re.DOTALL)
_WORD = re.compile(r"\s*\{\s*([A-Za-z]+\*?)\s*\}")
_COUNT = re.compile(r"\[\s*([0-9])\s*\]\s*")
_PARAMETERS = re.compile(r"((?:#[1-9])*)\s*(?=\{)")
_BRACE = re.compile(r"\\.|[{}]", re.DOTALL)
_SPACE = re.compile(r"\s*")
MACRO = re.compile(r"\\(?:[A-Za-z@]+|.)", re.DOTALL)
_NESTING = re.compile(
    r"(?P<open>\{|\\[\[(]|\\(?:begingroup|bgroup)(?![A-Za-z])|\\begin\s*\{(?!\s*document\s*\})[^{}]*\})"
    r"|(?P<close>\}|\\[\])]|\\(?:endgroup|egroup)(?![A-Za-z])|\\end\s*\{(?!\s*document\s*\})[^{}]*\})"
    r"|(?P<if>\\if(?!f(?![A-Za-z])|thenelse)[A-Za-z@]*)|(?P<fi>\\fi(?![A-Za-z]))"
    r"|(?P<dollar>\$\$?)|\\.",
    re.DOTALL,
)


@dataclass(frozen=True)
class Macro:
    """A macro: how many arguments it takes, the default of the first, and what it stands for."""

    name: str
    arguments: int
    default: str | None
    body: str


@dataclass
class Definitions:
    """A text without its definitions, and what they say."""

    text: str = ""
    macros: list[tuple[int, Macro]] = field(default_factory=list)
    """Macros, and the offsets from which on they hold."""
    unclear: dict[str, str] = field(default_factory=dict)
    """Names and environments that have a meaning which cannot be told, and why."""
    everything: str = ""
    """Why no formula at all can be told; empty if there is no such reason."""
    conditional: list[tuple[int, int]] = field(default_factory=list)
    """The intervals between an ``\\if`` and its ``\\fi``."""
    notes: list[tuple[int, str]] = field(default_factory=list)
    """Offsets in the file, and what is to be said about the place."""

    def why(self, tex: str, kind: str, offset: int) -> str:
        """Why the meaning of a formula cannot be told; empty if it can."""
        if self.everything:
            return self.everything
        if any(start < offset < end for start, end in self.conditional):
            return "it stands in a conditional, which is not executed"
        names = {*MACRO.findall(tex), *re.findall(r"\\begin\{(\w+)", tex), kind.rstrip("*")}
        return next((self.unclear[name] for name in sorted(names & self.unclear.keys())), "")


def definitions(text: str, styles: Iterable[str] = ()) -> Definitions:
    """The definitions of a text, and before them those of style files."""
    known: dict[str, Macro] = {}
    before = [_Reader(style, known).read() for style in styles]
    found = _Reader(text, known).read()
    for style in reversed(before):
        found.macros[:0] = [(0, macro) for _, macro in style.macros]
        found.unclear = style.unclear | found.unclear
        found.everything = found.everything or style.everything
        found.notes[:0] = [(0, f"in a style file: {words}") for _, words in style.notes]
    return found


class _Reader:
    def __init__(self, text: str, known: dict[str, Macro]) -> None:
        self.text = text
        self.found = Definitions()
        self.known = known
        self.fixed: dict[str, set[str]] = {}
        """Names, and those that were given a meaning by them which does not change with it."""

    def read(self) -> Definitions:
        """Go through the text once."""
        text, found = self.text, self.found
        pieces, at, position = [], 0, 0
        nested = _Nesting(text, found.conditional)
        while (match := _DEFINING.search(text, position)) is not None:
            inside = nested.at(match.start())
            parsed = self.definition(match)
            position = match.end()
            if parsed is None:
                what = f"this {match[0].strip()} is not understood"
                found.notes.append((match.start(), what))
                self.lose(match, what)
                if len(found.notes) == FAILURES:
                    found.everything = "the source has definitions that are not understood"
                    break
                continue
            macro, position = parsed
            if inside and match["def"] not in ("gdef", "xdef"):
                found.notes.append((match.start(), f"{macro.name} is defined inside a group"))
                found.unclear[macro.name] = f"{macro.name} is defined inside a group"
            self.define(macro, match, position)
            nested.skip(position)
            pieces.append(text[at : match.start()])
            pieces.append(re.sub(r"[^\r\n]", " ", text[match.start() : position]))
            at = position
        nested.at(len(text))
        if (changing := _CHANGING.search(text)) is not None:
            found.everything = f"{changing[0]} changes what the characters of the source mean"
            found.notes.append((changing.start(), found.everything))
        found.text = "".join([*pieces, text[at:]])
        return found

    def define(self, macro: Macro, match: re.Match[str], position: int) -> None:
        """From here on the macro holds, unless it is provided for where there is none."""
        known = macro.name in self.known
        if known and "providecommand" in match[0]:
            return
        if known and "newcommand" in match[0] and "renew" not in match[0]:
            self.found.unclear[macro.name] = f"{macro.name} is new twice"
        for other in self.fixed.get(macro.name, ()):
            why = f"{other} is what {macro.name} was before it was defined again"
            self.found.unclear[other] = why
        if match["let"] or match["def"] in ("edef", "xdef"):
            for name in MACRO.findall(macro.body):
                self.fixed.setdefault(name, set()).add(macro.name)
        for inner in _DEFINING.finditer(macro.body):
            self.lose(inner, f"{macro.name} defines names where it is used")
        self.known[macro.name] = macro
        self.found.macros.append((position, macro))

    def lose(self, match: re.Match[str], why: str) -> None:
        """A name, or an environment, has a meaning that cannot be told."""
        named = (_WORD if match["environment"] else _NAME).match(match.string, match.end())
        if named is None:
            self.found.everything = self.found.everything or why
        else:
            self.found.unclear[next(filter(None, named.groups()))] = why

    def definition(self, match: re.Match[str]) -> tuple[Macro, int] | None:
        """The macro that is defined, and the offset behind it; ``None`` if it is not understood."""
        text, named = self.text, _NAME.match(self.text, match.end())
        if named is None or match["other"] or match["environment"]:
            return None
        name, at = named[1] or named[2], named.end()
        if match["let"]:
            return self.same(name, at)
        count, default = 0, None
        if match["def"]:
            parameters = _PARAMETERS.match(text, at)
            if parameters is None:
                return None
            count, at = len(parameters[1]) // 2, parameters.end()
        elif match["new"] and (arguments := _COUNT.match(text, at)) is not None:
            count, at = int(arguments[1]), arguments.end()
            if text[at : at + 1] == "[":
                closing = text.find("]", at)
                if closing < 0:
                    return None
                default = text[at + 1 : closing]
                at = skip(text, closing + 1)
        group = group_at(text, at)
        if group is None:
            return None
        body, at = group
        if match["operator"]:
            body = rf"\operatorname{{{body}}}"
        return Macro(name, count, default, body), at

    def same(self, name: str, at: int) -> tuple[Macro, int] | None:
        """A macro that is let be what another one is now."""
        target = _TARGET.match(self.text, at)
        if target is None:
            return None
        known = self.known.get(target[1], Macro(name, 0, None, target[1]))
        return Macro(name, known.arguments, known.default, known.body), target.end()


class _Nesting:
    """Whether an offset stands inside of a group, a formula or a conditional; asked in order."""

    def __init__(self, text: str, conditional: list[tuple[int, int]]) -> None:
        self.text, self.conditional = text, conditional
        self.marks = self._found(0)
        self.groups, self.dollars, self.ifs = 0, 0, list[int]()
        self.waiting: re.Match[str] | None = None

    def _found(self, start: int) -> Iterator[re.Match[str]]:
        return _NESTING.finditer(self.text, start)

    def skip(self, offset: int) -> None:
        """Go on behind a definition, whose braces are its own."""
        self.marks, self.waiting = self._found(offset), None

    def at(self, offset: int) -> bool:
        """Whether the offset is inside of anything."""
        while True:
            mark = self.waiting or next(self.marks, None)
            self.waiting = mark
            if mark is None or mark.start() >= offset:
                return self.groups > 0 or self.dollars % 2 > 0 or bool(self.ifs)
            self.waiting = None
            kind = mark.lastgroup
            if kind == "open" or kind == "close":
                self.groups = max(0, self.groups + (1 if kind == "open" else -1))
            elif kind == "if":
                self.ifs.append(mark.start())
            elif kind == "fi" and self.ifs:
                self.conditional.append((self.ifs.pop(), mark.end()))
            elif kind == "dollar":
                self.dollars += 1


def skip(text: str, at: int) -> int:
    """The offset behind spaces."""
    match = _SPACE.match(text, at)
    assert match is not None
    return match.end()


def group_at(text: str, at: int) -> tuple[str, int] | None:
    """The content of the group in braces that begins here, and the offset behind it."""
    if text[at : at + 1] != "{":
        return None
    depth = 0
    for brace in _BRACE.finditer(text, at, at + 100_000):
        depth += {"{": 1, "}": -1}.get(brace[0], 0)
        if depth == 0:
            return text[at + 1 : brace.start()], brace.end()
    return None
