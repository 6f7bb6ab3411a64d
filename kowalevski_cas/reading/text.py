"""The prose of a source around its formulas: sentences, sections, and what they cite.

Formulas are blanked out, one mark in place of each, so that every offset stays that of the text
with macros written out.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.source.displays import DISPLAYS, TypedFormula

_SILENT = re.compile(
    r"(?:\\(?:label|tag\*?)\s*\{[^{}]*\}|\\l?eqno\s*\(?[\w.*']{1,9}\)?"
    r"|\\(?:end|nonumber|notag)(?:\s*\{[^{}]*\})?|\\\\|\\q?quad|\\[,;! ]|[}\s])$"
)
"""What stands at the end of a display, behind its stop."""

MARK = "§"
"""What stands for a formula in the prose."""

_DELIMITER = re.compile(
    rf"\\(?:begin|end)\s*\{{(?:{'|'.join(DISPLAYS)}|array|aligned|split|cases)\*?\}}"
    r"(?:\s*\{[\d\s]*\})?|\\\\(?:\s*\*?\s*\[[^\]\n]{0,20}\])?|\\[\[\]()]|\$\$?|&"
)
_HEADING = re.compile(
    r"\\(?P<level>part|chapter|section|subsection|subsubsection|paragraph|subparagraph)\*?"
    r"\s*(?:\[[^\]]*\])?\s*\{(?P<title>[^{}]*(?:\{[^{}]*\}[^{}]*)*)\}"
    r"|(?:\n[ \t]*\n|\\(?:small|med|big)skip|\\noindent|\\par(?![A-Za-z]))\s*"
    r"(?:\\noindent\s*|\\(?:small|med|big)skip\s*)*"
    r"(?:\{\s*\\(?:bf|it|em|sl|sc|bfseries|itshape|scshape)(?![A-Za-z])|\\text(?:bf|it|sc|sl)\s*\{)"
    r"(?P<bold>[^{}§]*(?:\{[^{}]*\}[^{}§]*)*)\}"
    r"|\n[ \t]*\n\s*(?:\\noindent\s*)?\\emph\s*\{(?!Proof|Доказат)(?P<said>[^{}§]*)\}"
    r"(?:(?<=[.:]\})|(?=\s*\.?(?:---|\\,---|—)))"
)
_LEVELS = "part chapter section subsection subsubsection paragraph subparagraph".split()
_RUN_IN = len(_LEVELS)
_BEGINS = re.compile(
    r"(?:\s|\\end\s*\{[^{}]*\}|\\\]|\$\$|\\label\s*\{[^{}]*\}|\\noindent(?![A-Za-z]))*"
    r"(?:The|This|That|These|Those|We|It|Its|They|Their|One|If|When|Whenever|For|Let|In|On|At|By|From|To|With|Under"
    r"|Here|There|Hence|Thus|Then|Therefore|Now|So|Since|Because|As|After|Before|An?|All|Both|Each|Every|Our|Such"
    r"|Suppose|Assume|Consider|Note|Using|Setting|Putting|Substituting|Differentiating|Moreover|Furthermore|Finally"
    r"|Consequently|Clearly|Obviously|Similarly|However|Indeed|Also|Besides|Equations?|Figure"
    r"|Мы|Это|Эти|Эта|Этот|Если|Когда|Пусть|При|Для|На|По|Здесь|Тогда|Отсюда|Следовательно|Поэтому|Так|Теперь|Итак"
    r"|Уравнени[яе]|Система|Положим|Рассмотрим|Заметим|Очевидно|Кроме|Они?|Она|Оно|Из|Подставляя|Функция)\b"
)
"""Words behind a display that begin a sentence: a stop before them may be left out."""
_ENVIRONMENT = re.compile(r"\\(?P<what>begin|end)\s*\{(?P<name>[^{}]+)\}")
_NEWTHEOREM = re.compile(r"\\newtheorem\*?\s*\{([^{}]+)\}")
_THEOREMS = frozenset(
    "theorem lemma proposition corollary remark example definition claim theo lem prop cor".split()
)
_LISTS = frozenset({"enumerate", "itemize", "description", "list", "compactenum"})
_ENTRY = re.compile(r"\\item(?![A-Za-z])|" + _ENVIRONMENT.pattern)
_ASIDE = frozenset({"abstract", "thebibliography", "keywords"})
_STOP = re.compile(
    r"(?P<paragraph>\n[ \t]*\n\s*)|(?P<end>[.?!])(?=[)\]}'’”»\s]*(?:\s|$))|(?P<break>\\(?:item|par"
    r"|footnote|caption|begin|end|smallskip|medskip|bigskip)(?![A-Za-z]))"
)
_ABBREVIATED = re.compile(
    r"(?:^|[\s(~,{])(?:[A-ZА-ЯЁ]|[Ee]qs?|[Ff]igs?|[Ss]ect?|[Rr]efs?|[Cc]f|resp|vs|i\.\s?e|e\.\s?g"
    r"|[Pp]p?|[Nn]os?|[Vv]ol|[Cc]h|[Cc]hap|т\.\s?[екдп]|см|ср|рис|гл|стр|ур|соотв|напр)$"
)
_WORD = re.compile(r"(?<![\\\w])[^\W\d]{2}")
_FOOTNOTE = re.compile(r"\\(?:footnote(?:text)?|caption)\s*(?:\[[^\]]*\])?\s*\{")
_BRACE = re.compile(r"(?<!\\)[{}]")
_PRINTED = re.compile(r"\((\d[\w.*']{0,8})\)")
_REFERENCE = re.compile(r"\\(?:eq|c|C|auto)?ref\s*\{([^{}]*)\}")


@dataclass(frozen=True)
class TextSection:
    """A part of a text: the levels of its headings, from the outermost, and its interval."""

    title: str
    level: int
    start: int
    end: int

    @property
    def is_run_in(self) -> bool:
        """Whether its heading begins a paragraph, in bold or slanted type."""
        return self.level == _RUN_IN


class Prose:
    """The words of a text from an offset on, with a mark in place of each formula."""

    def __init__(self, text: str, start: int, formulas: Sequence[TypedFormula]) -> None:
        self.start, self.formulas = start, formulas
        pieces, at = [], 0
        for formula in formulas:
            blank = _blank(text[formula.start : formula.end])
            if not formula.inline and _BEGINS.match(text, formula.end):
                blank = f"{blank[:-1]}."
            pieces += [text[at : formula.start], blank]
            at = formula.end
        pieces.append(text[at:])
        self.text = _DELIMITER.sub(lambda found: " " * len(found[0]), "".join(pieces))

    @cached_property
    def stops(self) -> list[int]:
        """The offsets at which sentences begin."""
        return _stops(self.text, self.start)

    @cached_property
    def _main(self) -> tuple[str, list[int]]:
        """The text with its footnotes blanked out, and the offsets at which sentences begin there.

        One that stands within a sentence does not end it.
        """
        text = self.text
        for start, end in self.footnotes:
            if text.startswith(r"\footnote", start):
                text = f"{text[:start]}{' ' * (end - start)}{text[end:]}"
        return text, _stops(text, self.start)

    def _around(self, offset: int) -> tuple[str, list[int]]:
        """The text to which an offset belongs, a footnote or what stands outside of these."""
        return self._main if self.footnote(offset) is None else (self.text, self.stops)

    def sentence(self, offset: int) -> tuple[int, int]:
        """The interval of the sentence around an offset."""
        place = bisect_right(self.stops, offset)
        end = self.stops[place] if place < len(self.stops) else len(self.text)
        return self.stops[max(0, place - 1)], end

    def earlier(self, offset: int, most: int) -> tuple[str, ...]:
        """The words of some sentences that end at an offset or before, the last one first."""
        found: list[str] = []
        text, stops = self._around(offset)
        place = bisect_right(stops, offset) - 1
        while place > 0 and len(found) < most:
            words = " ".join(text[stops[place - 1] : stops[place]].split())
            found += [words] if _WORD.search(words) else []
            place -= 1
        return tuple(found)

    def before(self, offset: int) -> str:
        """The words of a sentence before an offset, without footnotes that interrupt it."""
        text, stops = self._around(offset)
        start = stops[max(0, bisect_right(stops, offset) - 1)]
        return " ".join(text[start:offset].split())

    def between(self, start: int, end: int) -> str:
        """The words in an interval, with single spaces."""
        return " ".join(self.text[start:end].split())

    @cached_property
    def sections(self) -> list[TextSection]:
        """The parts of the text, in the order in which they begin."""
        heads = [
            (
                found.start(),
                _level(found),
                " ".join((found["title"] or found["bold"] or found["said"] or "").split()),
            )
            for found in _HEADING.finditer(self.text, self.start)
        ]
        heads += [(start, level, name) for start, level, name in self._environments()]
        heads.sort()
        found = [TextSection("", -1, self.start, len(self.text))]
        for place, (start, level, title) in enumerate(heads):
            later = (one for one, other, _ in heads[place + 1 :] if other <= level)
            found.append(TextSection(title, level, start, next(later, len(self.text))))
        return found

    def _environments(self) -> Iterator[tuple[int, int, str]]:
        """Where the abstract, the bibliography and what follows them begin."""
        for match in _ENVIRONMENT.finditer(self.text, self.start):
            if match["name"] in _ASIDE:
                title = match["name"] if match["what"] == "begin" else ""
                yield match.start(), 0, title

    def path(self, offset: int) -> tuple[TextSection, ...]:
        """The sections around an offset, from the outermost."""
        return tuple(one for one in self.sections if one.start <= offset < one.end)

    @cached_property
    def statements(self) -> list[tuple[int, int, str]]:
        """Theorem-like environments, each with the proof that follows it."""
        names = {*_NEWTHEOREM.findall(self.text[: self.start] + self.text)} | _THEOREMS
        found: list[tuple[int, int, str]] = []
        opened: list[tuple[str, int]] = []
        for match in _ENVIRONMENT.finditer(self.text, self.start):
            name = match["name"].rstrip("*")
            if match["what"] == "begin":
                opened.append((name, match.start()))
            elif opened and opened[-1][0] == name:
                start = opened.pop()[1]
                if name in names:
                    found.append((start, match.end(), name))
                elif name == "proof" and found and start - found[-1][1] < 200:
                    found[-1] = (found[-1][0], match.end(), found[-1][2])
                elif name == "proof":
                    found.append((start, match.end(), name))
        return found

    def theorem(self, offset: int) -> tuple[int, int] | None:
        """The interval of the theorem, with its proof, around an offset."""
        around = (one[:2] for one in self.statements if one[0] <= offset < one[1])
        return next(around, None)

    @cached_property
    def entries(self) -> list[tuple[int, int]]:
        """The intervals of the items of lists, inner ones first."""
        found: list[tuple[int, int]] = []
        opened: list[int | None] = []
        for match in _ENTRY.finditer(self.text, self.start):
            if match["what"] == "begin" and match["name"] in _LISTS:
                opened.append(None)
            elif opened and (match["what"] is None or match["name"] in _LISTS):
                start = opened.pop()
                if start is not None:
                    found.append((start, match.start()))
                if match["what"] is None:
                    opened.append(match.start())
        return found

    @cached_property
    def footnotes(self) -> list[tuple[int, int]]:
        """The intervals of footnotes and captions, to the brace that closes each."""
        found: list[tuple[int, int]] = []
        for match in _FOOTNOTE.finditer(self.text, self.start):
            depth = 1
            for brace in _BRACE.finditer(self.text, match.end()):
                depth += 1 if brace[0] == "{" else -1
                if depth == 0:
                    found.append((match.start(), brace.end()))
                    break
        return found

    def footnote(self, offset: int) -> tuple[int, int] | None:
        """The interval of the footnote, or the caption, around an offset."""
        return next((one for one in self.footnotes if one[0] <= offset < one[1]), None)

    def entry(self, offset: int) -> tuple[int, int] | None:
        """The interval of the innermost item of a list around an offset."""
        return next((one for one in self.entries if one[0] <= offset < one[1]), None)


def _stops(text: str, start: int) -> list[int]:
    """The offsets at which sentences of a text begin, from an offset on."""
    ends = {start}
    for match in _STOP.finditer(text, start):
        before = text[max(start, match.start() - 12) : match.start()]
        if match["end"] == "." and _ABBREVIATED.search(before):
            continue
        ends.add(match.start() if match["break"] else match.end())
    for heading in _HEADING.finditer(text, start):
        ends |= {heading.start(), heading.end()}
    return sorted(ends)


def references(words: str) -> tuple[str, ...]:
    """The labels that some words cite."""
    found = [label.strip() for one in _REFERENCE.findall(words) for label in one.split(",")]
    for number in _PRINTED.finditer(words):
        before = words[: number.start()].rstrip(" ~\n")
        if before and before[-1] not in ":;":  # else it counts what is listed
            found.append(number[1])
    return tuple(dict.fromkeys(found))


def _blank(formula: str) -> str:
    """A mark, and blanks as many as a formula has signs; a stop at its end stays."""
    body = formula.rstrip()
    while body:
        cut = _SILENT.sub("", body)
        if cut == body:
            break
        body = cut
    stop = "." if body.endswith(".") and not body.endswith("..") else " "
    return f"{MARK}{' ' * (len(formula) - 2)}{stop}" if len(formula) > 1 else MARK[: len(formula)]


def _level(found: re.Match[str]) -> int:
    return _LEVELS.index(found["level"]) if found["level"] else _RUN_IN
