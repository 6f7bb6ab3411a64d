"""The author's own macros, written out within limits.

What is written out remembers from where in the file it came, and what of it cannot be told.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from kowalevski_cas.source.built_in import BUILT_IN
from kowalevski_cas.source.conditionals import Conditionals
from kowalevski_cas.source.definitions import EVERYTHING, Definer, environment
from kowalevski_cas.source.meanings import (
    Alias,
    Environment,
    Flag,
    Macro,
    Meanings,
    Setter,
    Unclear,
)
from kowalevski_cas.source.mouth import Malformed, Mouth
from kowalevski_cas.source.parameters import NO_VALUE
from kowalevski_cas.source.tex import Token, is_word, stripped, typed
from kowalevski_cas.source.text import Source, SourceError

MOST_CALLS = 5_000
"""Macros that one macro of the text may lead to."""
LONGEST_CALL = 100_000
"""Tokens that one macro of the text may be written out as."""
LONGEST = 8_000_000
"""Tokens that all macros of a file may be written out as."""
MOST_NOTES = 20
"""Things that are not understood, after which no more are told."""

_MATHEMATICS = frozenset(
    "equation displaymath eqnarray align alignat flalign gather multline dmath math".split()
)
_WORDS = frozenset(rf"\{name}" for name in "text mbox hbox textrm intertext fbox parbox".split())
_CLOSING = {r"\]": r"\[", r"\)": r"\(", "}": "{"}
_OPENING = frozenset(_CLOSING.values())


@dataclass
class Expanded:
    """A text with macros written out, and where each part of it stands in the file."""

    text: str
    body: int
    """The offset in the text at which the document begins."""
    notes: list[tuple[int, str]]
    """Offsets in the file, and what is to be said about the place."""
    unclear: list[tuple[int, int, str]] = field(default_factory=list)
    """Intervals of the text that cannot be told, and why."""
    _starts: list[int] = field(default_factory=list)
    _pieces: list[tuple[int, int, bool]] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Sort what is asked for by its place."""
        self.unclear.sort()
        self._ends: list[int] = []
        """The furthest end of an unclear interval up to each one."""
        for _, end, _ in self.unclear:
            self._ends.append(max(end, self._ends[-1]) if self._ends else end)

    def origin(self, start: int, end: int) -> tuple[int, int]:
        """The interval of the file that printed an interval of the text."""
        first = self._at(start)
        last = self._at(max(start, end - 1))
        return first[0], last[1]

    def _at(self, offset: int) -> tuple[int, int]:
        index = max(0, bisect_right(self._starts, offset) - 1)
        if index >= len(self._pieces):
            return offset, offset + 1
        start, end, literal = self._pieces[index]
        if literal:
            place = start + offset - self._starts[index]
            return place, place + 1
        return start, end

    def why(self, start: int, end: int) -> str:
        """Why an interval of the text cannot be told; empty if it can."""
        first = bisect_left(self._ends, start)
        for begin, stop, why in self.unclear[first:]:
            if begin > end:
                break
            if stop >= start:
                return why
        return ""


def expand(source: Source) -> Expanded:
    """The visible text of a source with the author's macros written out."""
    return _Writer(source).run()


class _Writer:
    """The state of writing out: what is written, and from where it came."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.mouth = Mouth(source.visible)
        self.meanings = Meanings()
        self.definer = Definer(self.mouth, self.meanings)
        self.conditionals = Conditionals(self.mouth, self.meanings)
        self.notes = self.definer.notes
        self.body = 0
        self.later: list[list[Token]] = []
        """What is executed where the document begins."""
        self.out: list[str] = []
        self.starts: list[int] = []
        self.pieces: list[tuple[int, int, bool]] = []
        self.size = 0
        self.unclear: list[tuple[int, int, str]] = []
        self.spans: list[tuple[str, int, str]] = []
        """Open environments that cannot be told, where they begin, and why."""
        self.lost = -1  # where in the text nothing can be told any more, to the end of a group
        self.lost_why = ""
        self.options: list[str] = []
        """The options with which the last style is used."""
        self.declared: dict[str, list[Token]] = {}
        """What the options of a style do."""
        self.begun = Token("")
        self.mark = (0, 0, 0)
        self.calls = self.call_tokens = self.tokens = 0
        self.commands: dict[str, Callable[[Token], None]] = {
            r"\begin": self.begin,
            r"\end": self.end,
            r"\else": lambda _: self.conditionals.otherwise(),
            r"\fi": self.fi,
            r"\makeatletter": lambda _: self.at_is_letter(True),
            r"\makeatother": lambda _: self.at_is_letter(False),
            r"\AtBeginDocument": lambda _: self.later.append(self.mouth.argument()),
            r"\AtEndDocument": lambda _: void(self.mouth.argument()),
            r"\global": lambda _: setattr(self.definer, "everywhere", True),
            r"\long": void, r"\protected": void, r"\outer": void, r"\relax": void,
            r"\begingroup": self.open_group,
            r"\bgroup": self.open_group,
            r"\endgroup": self.close_group,
            r"\egroup": self.close_group,
            r"\aftergroup": void,
            r"\sp": lambda token: self.emit(token._replace(text="^", literal=False)),
            r"\sb": lambda token: self.emit(token._replace(text="_", literal=False)),
            r"\kern": self.kern,
            r"\input": self.input,
            r"\include": self.input,
            r"\usepackage": self.use,
            r"\RequirePackage": self.use,
            r"\documentclass": self.use,
            r"\LoadClass": self.use,
            r"\DeclareOption": self.declare_option,
            r"\ProcessOptions": self.process_options,
            r"\ExplSyntaxOn": self.skip_code,
            r"\expandafter": self.expand_after,
            r"\csname": self.by_name,
        }  # fmt: skip

    def run(self) -> Expanded:
        """Read all of the text."""
        parts, in_style = [(part.start, part.style) for part in self.source.parts], False
        while (token := self.mouth.take()) is not None:
            while parts and self.mouth.at > parts[0][0]:
                before, (_, in_style) = in_style, parts.pop(0)
                if before != in_style:
                    self.mouth.at_is_letter = in_style
            if token.literal:
                self.begun, self.mark = token, (len(self.out), self.size, len(self.meanings.kinds))
                self.calls = self.call_tokens = 0
            try:
                self.one(token)
            except Malformed as error:
                self.note(token, f"{token.text}: {error}")
                self.emit(token, str(error))
        while self.spans:
            self.ended(self.spans[-1][0])
        self.found()
        if len(self.notes) > MOST_NOTES:
            rest = len(self.notes) - MOST_NOTES
            self.notes[MOST_NOTES:] = [(self.notes[MOST_NOTES][0], f"and {rest} notes like these")]
        return Expanded(
            "".join(self.out), self.body, self.notes, self.unclear, self.starts, self.pieces
        )

    def note(self, token: Token, words: str) -> None:
        """Say something about a place of the file."""
        self.notes.append((token.start, words))

    # -- one token ------------------------------------------------------------------

    def one(self, token: Token) -> None:
        """Execute a token, or write it."""
        text = token.text
        if text[0] != "\\" and text not in self.mouth.active:
            self.sign(token)
            return
        self.definer.uncertain = self.conditionals.uncertain
        meaning = self.meanings.get(text)
        if meaning is None:
            self.command(token)
        elif isinstance(meaning, Macro):
            self.call(token, meaning)
        elif isinstance(meaning, Alias):
            self.command(token._replace(text=meaning.text, literal=False))
        elif isinstance(meaning, Unclear):
            self.emit(token, meaning.why)
        elif isinstance(meaning, Setter):
            self.definer.define(meaning.flag, Flag(meaning.value))
        elif isinstance(meaning, Flag):
            self.conditionals.start(text, self.size, self.mathematics)

    def command(self, token: Token) -> None:
        """Execute what TeX and LaTeX provide, as far as it is known here; or write it."""
        text = token.text
        if text in self.commands:
            self.commands[text](token)
        elif self.definer.run(token):
            self.check_lost()
        elif text in BUILT_IN:
            self.put(token, BUILT_IN[text](self.mouth))
        elif text[:3] == r"\if" and self.conditionals.begins(text):
            self.conditionals.start(text, self.size, self.mathematics)
        else:
            self.sign(token)

    def call(self, token: Token, macro: Macro) -> None:
        """A macro comes next as what it stands for."""
        self.calls += 1
        begin = self.mouth.last
        arguments = macro.arguments(self.mouth)
        if self.calls > MOST_CALLS or self.call_tokens > LONGEST_CALL:
            self.give_up(token)
            return
        end = max(token.end, self.mouth.last if self.mouth.last > begin else token.end)
        body = macro.written(arguments, token.start, end)
        self.put(token, body)

    def put(self, token: Token, tokens: Sequence[Token]) -> None:
        """These tokens come next, in the place of one that they are written for."""
        self.call_tokens += len(tokens)
        self.tokens += len(tokens)
        if self.tokens > LONGEST:
            raise SourceError(f"{self.source.path}: its macros write out too much text")
        self.mouth.put_back(tokens)

    def give_up(self, token: Token) -> None:
        """Leave a macro of the text alone that would be written out without an end."""
        begun = self.begun
        while self.mouth.waiting and not self.mouth.waiting[-1].literal:
            self.mouth.waiting.pop()
        count, self.size, depth = self.mark
        while len(self.meanings.kinds) > depth:
            self.close(self.meanings.kinds[-1])
        del self.out[count:], self.starts[count:], self.pieces[count:]
        why = f"the macro {begun.text} expands into itself, or into too much; it is left alone"
        self.note(begun, why)
        self.emit(begun, why)

    # -- groups ---------------------------------------------------------------------

    def sign(self, token: Token) -> None:
        """Write a token; it may begin or end a group."""
        text = token.text
        if text in _CLOSING:
            self.emit(token)
            self.close(_CLOSING[text])
        elif text in _OPENING:
            before = self.out[-1] if self.out else ""
            self.meanings.open("words" if text == "{" and before in _WORDS else text)
            self.emit(token)
        elif text in ("$", "$$"):
            self.emit(token)
            for one in [text] if text not in self.meanings.kinds and text == "$$" else [*text]:
                kinds = self.meanings.kinds
                if one in kinds and (one == "$$" or "words" not in kinds[kinds.index(one) :]):
                    self.close(one)
                else:
                    self.meanings.open(one)
        else:
            self.emit(token)

    def close(self, kind: str) -> None:
        """A group ends, and with it what could not be told in it."""
        kinds = self.meanings.kinds
        if kind == "{" and "words" in kinds and "{" not in kinds[_last(kinds, "words") :]:
            kind = "words"
        self.meanings.close(kind)
        self.check_lost()

    @property
    def mathematics(self) -> bool:
        """Whether a formula is written now."""
        for kind in reversed(self.meanings.kinds):
            if kind == "words":
                return False
            if kind in ("$", "$$", r"\[", r"\(") or kind in _MATHEMATICS:
                return True
        return False

    def check_lost(self) -> None:
        """Begin or end an interval of which nothing can be told."""
        meaning = self.meanings.get(EVERYTHING)
        if isinstance(meaning, Unclear) and self.lost < 0:
            self.lost, self.lost_why = self.size, meaning.why
            self.notes.append((self.mouth.last, meaning.why))
        elif meaning is None:
            self.found()

    def found(self) -> None:
        """An interval ends of which nothing could be told."""
        if self.lost >= 0:
            self.unclear.append((self.lost, self.size, self.lost_why))
            self.lost = -1

    def begin(self, token: Token) -> None:
        """An environment begins."""
        name = typed(self.mouth.braced()).strip()
        end = max(token.end, self.mouth.last)
        meaning = self.meanings.get(environment(name))
        if isinstance(meaning, Environment):
            self.meanings.open(r"\begingroup")
            self.call(token._replace(end=end), meaning.begin)
            return
        self.meanings.open(name.rstrip("*"))
        self.write(rf"\begin{{{name}}}", token.start, end)
        if isinstance(meaning, Unclear):
            self.spans.append((name, self.size, meaning.why))
        if name == "document":
            self.meanings.close("document")  # what is defined in the document holds to its end
            self.body = self.size
            for tokens in reversed(self.later):
                self.put(token, tokens)

    def end(self, token: Token) -> None:
        """An environment ends."""
        name = typed(self.mouth.braced()).strip()
        end = max(token.end, self.mouth.last)
        meaning = self.meanings.get(environment(name))
        if isinstance(meaning, Environment):
            body = meaning.end.written((), token.start, end)
            self.put(token, [*body, Token(r"\endgroup", token.start, end)])
            return
        self.ended(name)
        self.write(rf"\end{{{name}}}", token.start, end)
        self.close(name.rstrip("*"))

    def ended(self, name: str) -> None:
        """An environment that cannot be told ends."""
        if self.spans and self.spans[-1][0] == name:
            _, begin, why = self.spans.pop()
            self.unclear.append((begin, self.size, why))

    # -- commands -------------------------------------------------------------------

    def fi(self, token: Token) -> None:
        """A conditional ends."""
        begin = self.conditionals.open.pop() if self.conditionals.open else None
        if begin is not None:
            why = "it stands in a conditional, which is not executed"
            self.unclear.append((begin, self.size, why))

    def open_group(self, token: Token) -> None:
        """A group begins that prints no brace."""
        self.meanings.open(r"\begingroup")

    def close_group(self, token: Token) -> None:
        """A group ends that prints no brace."""
        self.close(r"\begingroup")

    def kern(self, token: Token) -> None:
        """A length by name prints nothing."""
        self.mouth.skips("-")
        if is_word(self.mouth.peek()):
            self.mouth.visible()
        else:
            self.emit(token)

    def input(self, token: Token) -> None:
        """The text of another file follows, if it was to be found when the files were read."""
        name = typed(self.mouth.argument() if self.mouth.peek() == "{" else self.bare_name())
        if not token.literal:
            self.note(token, f"{name} is named by a macro; it is not read")

    def bare_name(self) -> list[Token]:
        """The name of a file without braces, up to a blank."""
        found = []
        while (one := self.mouth.character()) is not None and not one.text.isspace():
            found.append(one)
        return found

    def use(self, token: Token) -> None:
        """A style, of which the text follows if it stands beside the paper."""
        options = self.mouth.bracketed("[", "]") or []
        self.mouth.argument()
        self.options = [name.strip() for name in typed(options).split(",")]
        self.declared = {}

    def declare_option(self, token: Token) -> None:
        """What an option of a style does."""
        star = self.mouth.skips("*")
        name = "" if star else typed(self.mouth.argument()).strip()
        self.declared[name] = self.mouth.argument()

    def process_options(self, token: Token) -> None:
        """The options that the style is used with do what they do."""
        self.mouth.skips("*")
        for name in reversed(self.options):
            if name in self.declared:
                self.put(token, self.declared[name])

    def at_is_letter(self, value: bool) -> None:
        """The sign @ is a letter from here on, or is none."""
        self.mouth.at_is_letter = value

    def skip_code(self, token: Token) -> None:
        r"""What stands up to ``\ExplSyntaxOff`` is no LaTeX; what it defines cannot be told."""
        defining = False
        while (one := self.mouth.take()) is not None and one.text != r"\ExplSyntaxOff":
            if defining and is_word(one.text):
                why = f"{one.text} is defined in a language that is not read"
                self.meanings.define(one.text, Unclear(why))
                defining = False
            elif one.text in self.definer.commands or one.text in (r"\cs", r"\tl"):
                defining = one.text in self.definer.commands

    def expand_after(self, token: Token) -> None:
        """The token after the next one is expanded once, before the next one is looked at."""
        first = self.mouth.character()
        second = self.mouth.character()
        if first is None or second is None:
            return
        meaning = self.meanings.get(second.text)
        if second.text == r"\csname":
            self.by_name(second)
        elif isinstance(meaning, Macro):
            self.call(second, meaning)
        elif second.text == r"\expandafter":
            self.expand_after(second)
        else:
            self.mouth.put_back([second])
        self.mouth.put_back([first])

    def by_name(self, token: Token) -> None:
        r"""The name that stands up to ``\endcsname``."""
        tokens = stripped(self.mouth.until([r"\endcsname"]))
        if any(one.text[0] in "\\{}#" for one in tokens):
            self.mouth.put_back(tokens)
            raise Malformed("this name cannot be told")
        name = "\\" + "".join(one.text for one in tokens)
        self.mouth.put_back([Token(name, token.start, max(token.end, self.mouth.last))])

    # -- writing --------------------------------------------------------------------

    def emit(self, token: Token, why: str = "") -> None:
        """Write a token; ``why`` it cannot be told what it means, if so."""
        text = token.text
        begin = self.size
        before = self.out[-1] if self.out else ""
        if text[:1].isalpha() and is_word(before):
            self.write(" ", token.start, token.start + 1 if token.literal else token.end)
        if text == NO_VALUE:
            why = "an argument is missing"
        self.write(text, token.start, token.end, token.literal)
        if why:
            self.unclear.append((begin, self.size, why))

    def write(self, text: str, start: int, end: int, literal: bool = False) -> None:
        """Write some text that comes from an interval of the file."""
        self.starts.append(self.size)
        self.pieces.append((start, end, literal))
        self.out.append(text)
        self.size += len(text)


def _last(kinds: Sequence[str], kind: str) -> int:
    return len(kinds) - 1 - [*reversed(kinds)].index(kind)


def void(_: object) -> None:
    """Nothing."""
