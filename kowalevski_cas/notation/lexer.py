r"""LaTeX source to the tokens that print.

The scanner resolves what belongs to typesetting: it drops spacing, sizes, labels and
phantoms, gives every letter its font, and forgets braces that enclose no argument, for
``{a+b}c`` prints as ``a+bc``. Environments become breaks between rows and cells.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.letters import set_accents, set_over, with_stars
from kowalevski_cas.notation.macros import (
    ACTIONS,
    ARGUMENTS,
    BLOCKS,
    JOINING,
    LAYOUTS,
    MARKS,
    MATRICES,
    SPELLING,
    TYPED,
    WORDS,
)
from kowalevski_cas.notation.tokens import DEEPEST, TOKEN, Token, after_group
from kowalevski_cas.notation.words import CONSTANT, DESCRIPTION, with_constants, without_names

LONGEST = 100_000

_NOISE = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
_WORD = re.compile(r"[A-Za-z]+")

OF_WORDS = {r"\mathrm": "", r"\mathit": "", r"\mathsf": r"\mathsf"}
"""The types in which letters in one group are a word, and that of a letter by itself."""
DIRECTIONS = frozenset({r"\perp", r"\parallel"})
"""Relations that are indices of the parts of a vector, or of what belongs to them."""
_LENGTH = re.compile(
    r"\s*=?\s*[-+]?[\d.]+\s*[a-z]{2}(?:\s*(?:plus|minus)\s*[-+]?[\d.]+\s*[a-z]{2,5})*"
)
_GAP = re.compile(r"[\s~]|\\(?:[ ,;:!]|q?quad(?![A-Za-z]))")
_ENVIRONMENT = re.compile(r"\s*\{\s*([A-Za-z]+)\*?\s*\}(?:\s*\[[a-z]\])?")
_CLOSING = re.compile(r"(?:\s|\\right(?![A-Za-z]))*(?:\\\}|\.)")
_ORDER = re.compile(r"\s*\[\s*(\d{1,2})\s*\]")
SHIFTS = ("$", r"\(", r"\)", r"\[", r"\]", ".", ",", ";")
_NULL = re.compile(r"\s*\.")
_OPENING = re.compile(r"\s*(?:\\left\s*)?\(")
_BAR = re.compile(r"\s*(?:\||\\\||\\[vV]ert(?![A-Za-z]))")
_OPENS = re.compile(r"\\left|\\[bB]igg?l")


def scan(tex: str) -> list[Token]:
    """The tokens of a source; an error for noise, excess and unbalanced braces."""
    if len(tex) > LONGEST:
        raise NotationError(f"the formula is longer than {LONGEST} characters", tex, LONGEST)
    if noise := _NOISE.search(tex):
        said = 'a control character stands in the formula; in Python, write it with an r, r"…"'
        raise NotationError(said, tex, noise.start())
    return _Scanner(tex).run()


class _Group(NamedTuple):
    """What is open: braces that are an argument, or others."""

    argument: bool
    outer: str  # the font outside
    owed: int  # the arguments that are awaited behind it
    begin: int
    before: int  # the number of tokens before it
    accents: list[str]  # what stands over it


class _Scanner:
    """The state of one scan: where it is, the font, and the arguments still owed."""

    def __init__(self, tex: str) -> None:
        self.tex = tex
        self.at = 0
        self.tokens: list[Token] = []
        self.font = ""
        self.once = ""  # the font of the next letter or group only
        self.accents: list[str] = []  # what stands over it, the outermost first
        self.owed = 0  # arguments that the last macro still awaits
        self.depth = 0  # open brackets
        self.once_at = 0  # where the font of the next letter, or what stands over it, begins
        self.shift = -1  # where the mathematics ends, once something has been read
        self.groups: list[_Group] = []
        self.halved: list[int] = []  # the open groups, by their number, that have an \over
        self.stacked: list[int] = []  # those of which the rows stand below a sign
        # Open environments: the name, is it a matrix, was a printed brace dropped before it.
        self.environments: list[tuple[str, bool, bool]] = []

    def run(self) -> list[Token]:
        tex, size, match_at = self.tex, len(self.tex), TOKEN.match
        while self.at < size:
            match = match_at(tex, self.at)
            assert match is not None
            kind = match.lastgroup
            start, end = match.span()
            self.at = end
            if kind == "blank":
                continue
            if self.shift >= 0 and match[0] not in SHIFTS:
                raise NotationError("the mathematics ends here, and more follows", tex, self.shift)
            if kind == "letter":
                self.letter(match[0], start)
            elif kind == "mark":
                self.mark(match[0], start)
            elif kind == "macro":
                self.macro(match[0], start)
            else:
                assert kind is not None
                self.plain(kind, match[0], start)
        self.refuse_accents(size)
        if self.groups:
            raise NotationError("this brace is never closed", tex, self.groups[-1].begin)
        if any(matrix for _, matrix, _ in self.environments):
            raise NotationError("the matrix is never closed", tex, size)
        return with_stars(self.tokens)

    def add(self, kind: str, text: str, start: int) -> None:
        """Enter a token: the accents that await a letter stand over it, and over nothing else."""
        if kind == "letter":
            text, self.accents = set_over(self.accents, text), []
        elif kind != "accent":
            self.once = ""
            self.refuse_accents(start)
        self.tokens.append(Token(kind, text, start, self.at))

    def refuse_accents(self, start: int) -> None:
        """An error if a letter is awaited that accents stand over."""
        if self.accents:
            raise NotationError(f"{self.accents[-1]} stands over one letter", self.tex, start)

    def plain(self, kind: str, text: str, start: int) -> None:
        """Enter a number, a break between rows, or an ellipsis; a zero may be a vector."""
        if kind == "row" and self.stacked[-1:] == [len(self.groups)]:
            kind = "comma"
        if kind == "number":
            self.owed = max(0, self.owed - len(text))
        if text == "0" and self.accents == [r"\vec"]:
            self.accents = []
        self.add(kind, text, start)

    def argument(self) -> None:
        """The thing just met is the next argument, if one is owed."""
        if self.owed:
            self.owed -= 1

    def letter(self, text: str, start: int) -> None:
        font = self.once or self.font
        if self.once or self.accents:
            start, self.once = self.once_at, ""
        self.argument()
        if font in OF_WORDS and len(text) == 1:
            word = _WORD.match(self.tex, self.at)
            if font == self.font and word is not None:
                text, self.at = text + word[0], word.end()
            if text in WORDS:
                self.add(WORDS[text], text, start)
                return
            font = r"\mathrm" if len(text) > 1 else OF_WORDS[font]
        font = OF_WORDS[font] if font == r"\mathit" else font
        text = f"{font}{{{text}}}" if font else text
        self.add("letter", SPELLING.get(text, text), start)

    def mark(self, text: str, start: int) -> None:
        text = TYPED.get(text, text)
        if text[0] == "\\":
            self.macro(text, start)
            return
        kind = MARKS.get(text, "noise")
        if kind == "{":
            self.open_group(start)
        elif kind == "}":
            self.close_group(start)
        elif kind == "shift":
            self.do_shift(start)
        elif kind != "blank":
            if kind in "^_":
                self.owed = 1
            elif kind == "open" or kind == "close":
                self.bracket(kind)
            self.add(kind, text, start)

    def bracket(self, kind: str) -> None:
        self.depth += 1 if kind == "open" else -1
        if self.depth + len(self.groups) > DEEPEST:
            raise NotationError(f"brackets deeper than {DEEPEST}", self.tex, self.at - 1)

    def open_group(self, start: int) -> None:
        if len(self.groups) + self.depth >= DEEPEST:
            raise NotationError(f"braces deeper than {DEEPEST}", self.tex, start)
        # After a font macro the braces show how far the font reaches, and nothing else.
        styled = bool(self.once or self.accents)
        argument = self.owed > 0 and not styled
        begin = self.once_at if styled else start
        owed = self.owed - 1 if argument else 0
        before = len(self.tokens)
        self.groups.append(_Group(argument, self.font, owed, begin, before, self.accents))
        self.accents = []
        if argument:
            self.owed = 0
            self.add("{", "{", start)
        self.font, self.once = self.once or self.font, ""

    def close_group(self, start: int) -> None:
        if not self.groups:
            raise NotationError("this brace closes nothing", self.tex, start)
        if self.halved and self.halved[-1] == len(self.groups):
            self.halved.pop()
            self.add("}", "}", start)
        self.refuse_accents(start)
        if self.stacked[-1:] == [len(self.groups)]:
            self.stacked.pop()
        argument, self.font, owed, begin, before, accents = self.groups.pop()
        self.once = ""
        if argument and [token.kind for token in self.tokens[-2:]] in (["^", "{"], ["_", "{"]):
            del self.tokens[-2:]  # nothing is printed above or below
            self.owed = owed
        elif argument:
            self.owed = owed
            self.add("}", "}", start)
        elif accents:
            set_accents(accents, self.tokens[before:], self.tex, start)
        if not argument and self.tokens[before:] and (accents or len(self.tokens) == before + 1):
            # Braces around a single token, as in {\bf e}, belong to it.
            self.tokens[before].start, self.tokens[-1].end = begin, self.at

    def macro(self, text: str, start: int) -> None:
        action = ACTIONS.get(text, "letter")
        if action == "letter" or (text in DIRECTIONS and self.is_index()):
            self.letter(text, start)
        elif action == "blank":
            return
        elif action == "font":
            self.once_at = self.once_at if self.once or self.accents else start
            self.once = SPELLING.get(text, text) or self.once
        elif action == "diacritic":
            self.once_at = self.once_at if self.once or self.accents else start
            self.accents.append(SPELLING.get(text, text))
        elif action == "switch":
            self.font = SPELLING[text]
        elif action in ARGUMENTS:
            self.argument()
            self.owed += ARGUMENTS[action]
            self.add(action, SPELLING.get(text, text) + self.order(action), start)
        elif action in (
            "skip",
            "text",
            "glue",
            "begin",
            "end",
            "number",
            "shift",
            "over",
            "size",
            "stack",
        ):
            getattr(self, "do_" + action)(start)
        else:
            if action == "open" or action == "close":
                self.bracket(action)
            elif action in ("prime", "dots", "const"):
                self.argument()
            name = text[1:] if action in ("operator", "const") else SPELLING.get(text, text)
            self.add(action, name, start)

    def is_index(self) -> bool:
        """Whether what comes is the whole index of a letter, or its beginning."""
        kinds = [token.kind for token in self.tokens[-2:]]
        return kinds[-1:] == ["_"] or kinds == ["_", "{"]

    def order(self, action: str) -> str:
        """The order of a root in brackets, behind the sign."""
        found = _ORDER.match(self.tex, self.at) if action == "sqrt" else None
        self.at = found.end() if found else self.at
        return f"[{found[1]}]" if found else ""

    def do_size(self, start: int) -> None:
        """The size of a bracket, which prints nothing; but it tells which side a bar closes."""
        text = self.tex[start : self.at]
        if null := _NULL.match(self.tex, self.at):
            self.at = null.end()
        elif text[-1] in "tlr" and (bar := _BAR.match(self.tex, self.at)):
            self.at = bar.end()
            kind, name = ("open", r"\lvert") if _OPENS.match(text) else ("close", r"\rvert")
            self.bracket(kind)
            self.add(kind, name, start)

    def do_over(self, start: int) -> None:
        """All that stands before it in its group is divided by all that follows there."""
        if not self.groups or self.halved[-1:] == [len(self.groups)]:
            raise NotationError(r"write \frac for this \over, or set braces", self.tex, start)
        begin, place = self.groups[-1].begin, self.groups[-1].before + self.groups[-1].argument
        self.tokens[place:place] = [
            Token("frac", r"\frac", begin, begin),
            Token("{", "{", begin, begin),
        ]
        self.halved.append(len(self.groups))
        self.add("}", "}", start)
        self.add("{", "{", start)

    def do_stack(self, start: int) -> None:
        """Rows below a sign, as of a sum: each is a condition."""
        self.stacked.append(len(self.groups) + 1)

    def do_skip(self, start: int) -> None:
        self.at = after_group(self.tex, self.at)

    def do_glue(self, start: int) -> None:
        """A length in words, as in hskip 3mm."""
        length = _LENGTH.match(self.tex, self.at)
        if length is None:
            raise NotationError("a length with a unit is expected here", self.tex, self.at)
        self.at = length.end()

    def do_shift(self, start: int) -> None:
        """A dollar, or a bracket of a display: it may open the formula and close it."""
        if self.tokens:
            self.shift = start

    def do_number(self, start: int) -> None:
        """An equation number: nothing after it belongs to the formula."""
        self.at = len(self.tex)

    def do_text(self, start: int) -> None:
        """Words among formulas: an index, the word const, a comma, or nothing but a gap."""
        inside, self.at = self.at, after_group(self.tex, self.at)
        text = _GAP.sub(" ", self.tex[inside : self.at]).strip("{} ")
        words = text.strip(" .,;")
        upright = rf"\mathrm{{{words}}}"
        function = SPELLING.get(upright, upright)
        if words in WORDS:
            self.argument()
            self.add(WORDS[words], words, start)
        elif CONSTANT.fullmatch(words) and self.tokens:
            if self.tokens[-1].kind == "relation":
                self.add("const", "const", start)
            else:
                self.tokens = with_constants(self.tokens, start, self.at)
        elif DESCRIPTION.fullmatch(words):
            self.tokens = without_names(self.tokens, words)
            self.add("comma", words, start)
        elif words.isalnum() and (self.owed or (self.groups and self.groups[-1].argument)):
            self.argument()
            self.add("letter", words if len(words) == 1 else upright, start)
        elif words in JOINING or (text and not words and text != "."):
            self.add("comma", words, start)
        elif function in FUNCTIONS and _OPENING.match(self.tex, self.at):
            self.argument()
            self.add("letter", function, start)  # in the type of words
        elif words:
            told = "mathematics inside of text cannot be read"
            if words.replace(" ", "").replace(".", "").isalpha():
                told = (
                    f"the words “{words}” among formulas are not understood: print what they "
                    "suppose as a formula"
                )
            raise NotationError(told, self.tex, inside)

    def do_begin(self, start: int) -> None:
        name = self.environment(start)
        groups = LAYOUTS.get(name, 0)
        for _ in range(groups):
            self.at = after_group(self.tex, self.at)
        braced = bool(self.tokens) and self.tokens[-1].text == r"\{" and name in LAYOUTS
        if braced:
            self.tokens.pop()
            self.depth -= 1
        barred = bool(self.tokens) and self.tokens[-1].kind == "bar"
        matrix = name in MATRICES or (name == "array" and (self.depth > 0 or barred))
        self.environments.append((name, matrix, braced))
        self.add("begin" if matrix else "block" if name in BLOCKS else "row", name, start)

    def do_end(self, start: int) -> None:
        name = self.environment(start)
        if not self.environments or self.environments[-1][0] != name:
            raise NotationError(f"the end of {name} closes nothing", self.tex, start)
        _, matrix, braced = self.environments.pop()
        self.add("end" if matrix else "block" if name in BLOCKS else "row", name, start)
        # The printed brace before a system is a decoration; so is one behind it.
        if braced and (closing := _CLOSING.match(self.tex, self.at)):
            self.at = closing.end()

    def environment(self, start: int) -> str:
        match = _ENVIRONMENT.match(self.tex, self.at)
        if match is None:
            raise NotationError("the name of an environment is missing", self.tex, start)
        self.at = match.end()
        if match[1] not in LAYOUTS and match[1] not in MATRICES:
            raise NotationError(f"the environment {match[1]} cannot be read", self.tex, start)
        return match[1]
