r"""What a source defines: macros, environments, flags, and what cannot be told.

``\newcommand`` and its like, ``\def`` and ``\let``, the commands of xparse, operators, paired
delimiters, environments and flags are understood. Whatever else gives a name a meaning makes the
name unclear, and what changes the meaning of characters makes all that follows unclear, to the end
of its group.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from kowalevski_cas.source.characters import change_code
from kowalevski_cas.source.meanings import (
    Alias,
    Environment,
    Flag,
    FlagSetter,
    Macro,
    Meaning,
    Meanings,
    Unclear,
)
from kowalevski_cas.source.mouth import Malformed, Mouth
from kowalevski_cas.source.parameters import Parameter, delimited_parameters, specified_parameters
from kowalevski_cas.source.tex import TypedToken, is_command, is_word, source_of_tokens, strip

DEEPEST = 30
"""Macros within macros in a body that is written out at once."""
LONGEST = 10_000
"""Tokens in such a body."""
EVERYTHING = "everything"
"""The name that is unclear where no formula can be told."""


def environment(name: str) -> str:
    """The name under which the meaning of an environment is kept."""
    return f"environment {name}"


def _texts(tokens: Sequence[TypedToken]) -> tuple[str, ...]:
    return tuple(token.text for token in tokens)


class Definer:
    """Reads definitions, where they come next, and keeps what they say."""

    def __init__(self, mouth: Mouth, meanings: Meanings) -> None:
        self.mouth, self.meanings = mouth, meanings
        self.uncertain = False
        """Whether it cannot be told if what is defined here is defined."""
        self.everywhere = False
        self.notes: list[tuple[int, str]] = []
        self.commands: dict[str, Callable[[str], None]] = {
            rf"\{name}": function
            for function, names in (
                (self._new, "newcommand renewcommand providecommand DeclareRobustCommand"),
                (self._define, "def gdef edef xdef"),
                (self._let, "let"),
                (self._operator, "DeclareMathOperator"),
                (self._document, _DOCUMENT),
                (self._delimiter, "DeclarePairedDelimiter DeclarePairedDelimiterX"),
                (self._environment, "newenvironment renewenvironment provideenvironment"),
                (self._xparse_environment, _DOCUMENTED),
                (self._flag, "newif"),
                (self._by_name, "@namedef"),
                (self._code, "catcode mathcode"),
                (
                    self._change,
                    "delcode lccode uccode everymath everydisplay endlinechar escapechar",
                ),
                (self._unclear, _UNCLEAR),
            )
            for name in names.split()
        }

    def run(self, token: TypedToken) -> bool:
        """Read the definition that a token begins; whether it begins one."""
        command = self.commands.get(token.text)
        if command is None:
            return False
        try:
            command(token.text)
        except Malformed:
            what = f"this {token.text} is not understood"
            self.notes.append((token.start, what))
            self.lose(what)
        self.everywhere = False
        return True

    def lose(self, why: str) -> None:
        """From here on no formula can be told."""
        self.meanings.define(EVERYTHING, Unclear(why))

    def define(self, name: str, meaning: Meaning) -> None:
        """The name has this meaning, if it is certain that it is defined."""
        if self.uncertain and isinstance(meaning, Flag):
            meaning = Flag(None)
        elif self.uncertain:
            why = f"{name} is defined in a conditional, which is not executed"
            meaning = Unclear(why, perhaps=True)
        self.meanings.define(name, meaning, self.everywhere)

    def _change(self, command: str) -> None:
        self.lose(f"{command} changes what the characters of the source mean")

    def _code(self, command: str) -> None:
        if not change_code(command, self.mouth):
            self._change(command)

    # -- names ----------------------------------------------------------------------

    def target(self) -> str:
        """The name that is defined."""
        token = self.mouth.visible()
        found = [token] if token is not None else []
        if token is not None and token.text == "{":
            found = [one for one in self.mouth.group(token) if not one.text.isspace()]
        if len(found) != 1 or not (is_command(found[0].text) or found[0].text in self.mouth.active):
            raise Malformed("a name is missing")
        return found[0].text

    def checked(self, command: str, name: str, read: Callable[[], Meaning]) -> None:
        """Define a name by what is read; it is unclear if that is not understood."""
        known = self.meanings.get(name)
        try:
            meaning = read()
        except Malformed:
            at = self.mouth.last
            what = f"this {command} is not understood"
            self.notes.append((at, f"{what}: {name}"))
            meaning = Unclear(what)
        new = command.lower().lstrip("\\")
        if new.startswith("provide") and known is not None:
            return
        if new.startswith("new") and known is not None and known != Alias(r"\relax"):
            meaning = Unclear(f"{name} is new twice")
        self.define(name, meaning)

    # -- commands -------------------------------------------------------------------

    def _new(self, command: str) -> None:
        self.mouth.skips("*")
        self.checked(command, self.target(), self._with_count)

    def _with_count(self) -> Macro:
        """A macro with the number of its arguments in brackets."""
        return Macro(self._parameters(), _texts(self.mouth.argument()))

    def _parameters(self) -> tuple[Parameter, ...]:
        number = self.mouth.optional_argument("[", "]")
        if number is None:
            return ()
        text = source_of_tokens(number).strip()
        if not (text.isdigit() and len(text) == 1):
            raise Malformed("how many arguments?")
        found = [Parameter("m")] * int(text)
        default = self.mouth.optional_argument("[", "]")
        if default is not None and found:
            found[0] = Parameter("o", ("[", "]"), _texts(default))
        return tuple(found)

    def _define(self, command: str) -> None:
        self.everywhere = self.everywhere or command in (r"\gdef", r"\xdef")
        name = self.target()
        fixed = command in (r"\edef", r"\xdef")
        self.checked(command, name, lambda: self._with_delimiters(fixed))

    def _with_delimiters(self, fixed: bool = False) -> Macro:
        r"""A macro as ``\def`` defines it, with whatever stands around its arguments.

        It is ``fixed`` if what stands in it keeps the meaning that it has now.
        """
        printed: list[str] = []
        while (token := self.mouth.character()) is not None and token.text != "{":
            if token.text == "}" or len(printed) > 100:
                break
            if not token.text.isspace():
                printed.append(token.text)
            elif printed and not is_word(printed[-1]):
                printed.append(" ")
        if token is None or token.text != "{":
            raise Malformed("a macro without a body")
        body = _texts(self.mouth.group(token))
        return Macro(delimited_parameters(printed), self._fix(body) if fixed else body)

    def _fix(self, body: Sequence[str], depth: int = 0) -> tuple[str, ...]:
        """The body with macros without arguments written out; others cannot be kept as they are."""
        found: list[str] = []
        for text in body:
            meaning = self.meanings.get(text)
            if isinstance(meaning, Macro) and not meaning.parameters and depth < DEEPEST:
                found += self._fix(meaning.body, depth + 1)
            elif meaning is None or isinstance(meaning, Alias):
                found.append(text if meaning is None else meaning.text)
            else:
                raise Malformed(f"{text} cannot be written out here")
            if len(found) > LONGEST:
                raise Malformed("the body is too long")
        return tuple(found)

    def _by_name(self, command: str) -> None:
        name = "\\" + source_of_tokens(self.mouth.need_group()).strip()
        self.checked("renew", name, self._with_delimiters)

    def _let(self, command: str) -> None:
        name = self.target()
        self.mouth.skips("=")
        token = self.mouth.visible()
        if token is None:
            raise Malformed("what is it?")
        known = self.meanings.get(token.text)
        self.define(name, known if known is not None else Alias(token.text))

    def _operator(self, command: str) -> None:
        self.mouth.skips("*")

        def read() -> Macro:
            body = _texts(self.mouth.argument())
            return Macro((), (r"\operatorname", "{", *body, "}"))

        self.checked("renew", self.target(), read)

    def _document(self, command: str) -> None:
        """A command of xparse."""

        def read() -> Macro:
            parameters = specified_parameters(strip(self.mouth.argument()))
            return Macro(parameters, _texts(self.mouth.argument()))

        self.checked(command, self.target(), read)

    def _delimiter(self, command: str) -> None:
        def read() -> Macro:
            plain = not command.endswith("X")
            number = None if plain else self.mouth.optional_argument("[", "]")
            count = 1 if plain else int(source_of_tokens(number or []).strip() or 0)
            left, right = _texts(self.mouth.argument()), _texts(self.mouth.argument())
            body = ("#1",) if plain else _texts(self.mouth.argument())
            moved = (f"#{int(t[1:]) + 2}" if re.fullmatch("#[1-7]", t) else t for t in body)
            options = (Parameter("s", ("*",)), Parameter("o", ("[", "]")))
            return Macro((*options, *[Parameter("m")] * count), (*left, *moved, *right))

        self.checked("renew", self.target(), read)

    def _environment(self, command: str) -> None:
        self.mouth.skips("*")
        name = source_of_tokens(self.mouth.need_group()).strip()

        def read() -> Environment:
            parameters = self._parameters()
            begin, end = _texts(self.mouth.argument()), _texts(self.mouth.argument())
            return Environment(Macro(parameters, begin), Macro((), end))

        self.checked(command, environment(name), read)

    def _xparse_environment(self, command: str) -> None:
        """An environment of xparse."""
        name = source_of_tokens(self.mouth.need_group()).strip()

        def read() -> Environment:
            parameters = specified_parameters(strip(self.mouth.argument()))
            begin, end = _texts(self.mouth.argument()), _texts(self.mouth.argument())
            if any(text.startswith("#") for text in end):
                raise Malformed("arguments at the end of an environment")
            return Environment(Macro(parameters, begin), Macro((), end))

        self.checked(command, environment(name), read)

    def _flag(self, command: str) -> None:
        name = self.target()
        self.define(name, Flag(False))
        for value in (True, False):
            setter = f"\\{name[3:]}{'true' if value else 'false'}"
            self.define(setter, FlagSetter(name, value))

    def _unclear(self, command: str) -> None:
        name = self.target()
        what = f"this {command} is not understood"
        self.notes.append((self.mouth.last, f"{what}: {name}"))
        self.define(name, Unclear(what))


_KINDS = ("New", "Renew", "Provide", "Declare")
_CHANGING = "delcode lccode uccode everymath everydisplay endlinechar escapechar"
_DOCUMENT = " ".join(f"{k}{e}DocumentCommand" for k in _KINDS for e in ("", "Expandable"))
_DOCUMENTED = " ".join(f"{kind}DocumentEnvironment" for kind in _KINDS)
_UNCLEAR = """futurelet chardef mathchardef countdef dimendef skipdef toksdef DeclareMathSymbol
DeclareMathAccent DeclareMathDelimiter DeclareMathRadical DeclareRobustCommandx newcommandx
renewcommandx providecommandx DeclareTextFontCommand DeclareMathAlphabet SetMathAlphabet newsymbol
DeclarePairedDelimiterXPP"""
