"""The author's own macros, written out within limits.

What is written out remembers from where in the file it came, and what of it cannot be told.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kowalevski_cas.source.built_in import BUILT_IN
from kowalevski_cas.source.conditionals import Conditionals
from kowalevski_cas.source.definitions import Definer, environment
from kowalevski_cas.source.displays import DISPLAYS
from kowalevski_cas.source.expanded import Expanded, ExpandedOutput
from kowalevski_cas.source.frames import FRAMES, framed
from kowalevski_cas.source.groups import Groups
from kowalevski_cas.source.meanings import (
    Alias,
    Environment,
    Flag,
    FlagSetter,
    Macro,
    Meanings,
    Unclear,
)
from kowalevski_cas.source.mouth import Malformed, Mouth
from kowalevski_cas.source.packages import Files
from kowalevski_cas.source.tex import TypedToken, is_word, source_of_tokens, strip
from kowalevski_cas.source.text import Part, Source, SourceError

MOST_CALLS = 5_000
"""Macros that one macro of the text may lead to."""
LONGEST_CALL = 100_000
"""Tokens that one macro of the text may be written out as."""
LONGEST = 8_000_000
"""Tokens that all macros of a file may be written out as."""


def expand(source: Source) -> Expanded:
    """The visible text of a source with the author's macros written out."""
    return _Expander(source).run()


class _Expander:
    """The state of writing out: what is written, and from where it came."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.mouth = Mouth(source.visible)
        self.meanings = Meanings()
        self.definer = Definer(self.mouth, self.meanings)
        self.conditionals = Conditionals(self.mouth, self.meanings)
        self.notes = self.definer.notes
        self.body = 0
        self.output = ExpandedOutput()
        self.spans: list[tuple[str, int, str]] = []
        """Open environments that cannot be told, where they begin, and why."""
        self.files = Files(self.mouth, self.definer, self.conditionals)
        self.groups = Groups(self.mouth, self.meanings, self.output, self.notes)
        self.in_style = False
        self.begun = TypedToken("")
        self.mark = (0, 0, 0)
        self.calls = self.call_tokens = self.tokens = 0
        self.commands: dict[str, Callable[[TypedToken], None]] = {
            r"\begin": self.begin,
            r"\end": self.end,
            r"\else": lambda _: self.conditionals.otherwise(),
            r"\fi": self.fi,
            r"\makeatletter": lambda _: self.at_is_letter(True),
            r"\makeatother": lambda _: self.at_is_letter(False),
            r"\AtBeginDocument": self.files.postpone,
            r"\AtEndDocument": lambda _: void(self.mouth.argument()),
            r"\global": lambda _: setattr(self.definer, "everywhere", True),
            r"\long": void, r"\protected": void, r"\outer": void, r"\relax": void,
            r"\begingroup": self.open_group,
            r"\bgroup": self.open_group,
            r"\endgroup": self.close_group,
            r"\egroup": self.close_group,
            r"\aftergroup": void,
            r"\sp": lambda token: self.output.emit(token._replace(text="^", literal=False)),
            r"\sb": lambda token: self.output.emit(token._replace(text="_", literal=False)),
            r"\kern": self.kern,
            r"\input": self.files.input,
            r"\include": self.files.input,
            r"\usepackage": self.files.use,
            r"\RequirePackage": self.files.use,
            r"\documentclass": self.files.use,
            r"\LoadClass": self.files.use,
            r"\DeclareOption": self.files.declare_option,
            r"\ProcessOptions": self.files.process_options,
            r"\ExplSyntaxOn": self.skip_code,
            r"\expandafter": self.expand_after,
            r"\csname": self.by_name,
        }  # fmt: skip

    def run(self) -> Expanded:
        """Read all of the text."""
        parts = [*self.source.parts]
        while (token := self.next(parts)) is not None:
            if token.literal:
                depth = len(self.meanings.kinds)
                self.begun, self.mark = token, (len(self.output.out), self.output.size, depth)
                self.calls = self.call_tokens = 0
            try:
                self.one(token)
            except Malformed as error:
                self.note(token, f"{token.text}: {error}")
                self.output.emit(token, str(error))
        while self.spans:
            self.ended(self.spans[-1][0])
        self.groups.end_unknown()
        return self.output.expanded(self.body, self.notes)

    def next(self, parts: list[Part]) -> TypedToken | None:
        """The next token; where a style begins, the sign @ becomes a letter, to its end."""
        while parts and self.mouth.at >= parts[0].start:
            part = parts.pop(0)
            if part.style != self.in_style:
                self.mouth.at_is_letter = self.in_style = part.style
        return self.mouth.plain() or self.mouth.take()

    def note(self, token: TypedToken, words: str) -> None:
        """Say something about a place of the file."""
        self.notes.append((token.start, words))

    # -- one token ------------------------------------------------------------------

    def one(self, token: TypedToken) -> None:
        """Execute a token, or write it."""
        text = token.text
        if text[0] != "\\" and text not in self.mouth.active:
            self.groups.sign(token)
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
            self.output.emit(token, meaning.why)
        elif isinstance(meaning, FlagSetter):
            self.definer.define(meaning.flag, Flag(meaning.value))
        elif isinstance(meaning, Flag):
            self.conditionals.start(text, self.output.size, self.groups.mathematics)

    def command(self, token: TypedToken) -> None:
        """Execute what TeX and LaTeX provide, as far as it is known here; or write it."""
        text = token.text
        if text in self.commands:
            self.commands[text](token)
        elif self.definer.run(token):
            self.groups.check_lost()
        elif text in BUILT_IN:
            self.put(token, BUILT_IN[text](self.mouth))
        elif text in FRAMES:
            self.put(token, framed(token, self.mouth, self.groups.mathematics))
        elif text[:3] == r"\if" and self.conditionals.begins(text):
            self.conditionals.start(text, self.output.size, self.groups.mathematics)
        else:
            self.groups.sign(token)

    def call(self, token: TypedToken, macro: Macro) -> None:
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

    def put(self, token: TypedToken, tokens: Sequence[TypedToken]) -> None:
        """These tokens come next, in the place of one that they are written for."""
        self.call_tokens += len(tokens)
        self.tokens += len(tokens)
        if self.tokens > LONGEST:
            raise SourceError(f"{self.source.path}: its macros write out too much text")
        self.mouth.put_back(tokens)

    def give_up(self, token: TypedToken) -> None:
        """Leave a macro of the text alone that would be written out without an end."""
        begun = self.begun
        while self.mouth.waiting and not self.mouth.waiting[-1].literal:
            self.mouth.waiting.pop()
        count, size, depth = self.mark
        while len(self.meanings.kinds) > depth:
            self.groups.close(self.meanings.kinds[-1])
        self.output.back(count, size)
        why = f"the macro {begun.text} expands into itself, or into too much; it is left alone"
        self.note(begun, why)
        self.output.emit(begun, why)

    # -- environments ---------------------------------------------------------------

    def begin(self, token: TypedToken) -> None:
        """An environment begins."""
        name = source_of_tokens(self.mouth.need_group()).strip()
        end = max(token.end, self.mouth.last)
        meaning = self.meanings.get(environment(name))
        if isinstance(meaning, Environment):
            self.meanings.open(r"\begingroup")
            self.call(token._replace(end=end), meaning.begin)
            return
        self.meanings.open(name.rstrip("*"))
        self.output.write(rf"\begin{{{name}}}", token.start, end)
        if isinstance(meaning, Unclear) and (not meaning.perhaps or name.rstrip("*") in DISPLAYS):
            self.spans.append((name, self.output.size, meaning.why))
        if name == "document":
            self.meanings.close("document")  # what is defined in the document holds to its end
            self.body = self.output.size
            for tokens in reversed(self.files.later):
                self.put(token, tokens)

    def end(self, token: TypedToken) -> None:
        """An environment ends."""
        name = source_of_tokens(self.mouth.need_group()).strip()
        end = max(token.end, self.mouth.last)
        meaning = self.meanings.get(environment(name))
        if isinstance(meaning, Environment):
            body = meaning.end.written((), token.start, end)
            self.put(token, [*body, TypedToken(r"\endgroup", token.start, end)])
            return
        self.ended(name)
        self.output.write(rf"\end{{{name}}}", token.start, end)
        self.groups.close(name.rstrip("*"))

    def ended(self, name: str) -> None:
        """An environment that cannot be told ends."""
        if self.spans and self.spans[-1][0] == name:
            _, begin, why = self.spans.pop()
            self.output.lose(begin, why)

    # -- commands -------------------------------------------------------------------

    def fi(self, token: TypedToken) -> None:
        """A conditional ends."""
        begin = self.conditionals.open.pop() if self.conditionals.open else None
        if begin is not None:
            self.output.lose(begin, "it stands in a conditional, which is not executed")

    def open_group(self, token: TypedToken) -> None:
        """A group begins that prints no brace."""
        self.meanings.open(r"\begingroup")

    def close_group(self, token: TypedToken) -> None:
        """A group ends that prints no brace."""
        self.groups.close(r"\begingroup")

    def kern(self, token: TypedToken) -> None:
        """A length by name prints nothing."""
        self.mouth.skips("-")
        if is_word(self.mouth.peek()):
            self.mouth.visible()
        else:
            self.output.emit(token)

    def at_is_letter(self, value: bool) -> None:
        """The sign @ is a letter from here on, or is none."""
        self.mouth.at_is_letter = value

    def skip_code(self, token: TypedToken) -> None:
        r"""What stands up to ``\ExplSyntaxOff`` is no LaTeX; what it defines cannot be told."""
        defining = False
        while (one := self.mouth.take()) is not None and one.text != r"\ExplSyntaxOff":
            if defining and is_word(one.text):
                why = f"{one.text} is defined in a language that is not read"
                self.meanings.define(one.text, Unclear(why))
                defining = False
            elif one.text in self.definer.commands or one.text in (r"\cs", r"\tl"):
                defining = one.text in self.definer.commands

    def expand_after(self, token: TypedToken) -> None:
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

    def by_name(self, token: TypedToken) -> None:
        r"""The name that stands up to ``\endcsname``."""
        tokens = strip(self.mouth.until([r"\endcsname"]))
        if any(token.text[0] in "\\{}#" for token in tokens):
            self.mouth.put_back(tokens)
            raise Malformed("this name cannot be told")
        name = "\\" + "".join(token.text for token in tokens)
        self.mouth.put_back([TypedToken(name, token.start, max(token.end, self.mouth.last))])


def void(_: object) -> None:
    """Nothing."""
