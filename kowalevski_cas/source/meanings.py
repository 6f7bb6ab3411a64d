"""What names mean while a text is read: macros, flags, other names, or nothing that can be told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from kowalevski_cas.source.mouth import Malformed, Mouth
from kowalevski_cas.source.parameters import Parameter
from kowalevski_cas.source.tex import TypedToken, is_command


@dataclass(frozen=True)
class Macro:
    """A macro: the arguments that it takes, and what it stands for."""

    parameters: tuple[Parameter, ...]
    body: tuple[str, ...]

    def arguments(self, mouth: Mouth) -> list[list[TypedToken]]:
        """The arguments that come next; if they are not as expected, they are put back."""
        found: list[list[TypedToken]] = []
        for parameter in self.parameters:
            try:
                argument = parameter.take(mouth)
            except Malformed:
                for taken in reversed(found):
                    mouth.put_back([TypedToken("{"), *taken, TypedToken("}")])
                raise
            if parameter.kind != "=":
                found.append(argument)
        return found

    def written(
        self, arguments: Sequence[Sequence[TypedToken]], start: int, end: int
    ) -> list[TypedToken]:
        """The body with the arguments in their places, all of it from one interval of the file."""
        found: list[TypedToken] = []
        for text in self.body:
            if text[0] != "#" or len(text) == 1:
                found.append(TypedToken(text, start, end))
            elif (hashes := text.count("#")) % 2 and text[-1].isdigit():
                number = int(text[-1])
                found += [TypedToken("#" * (hashes // 2), start, end)] if hashes > 1 else []
                if number <= len(arguments):
                    found += [
                        TypedToken(argument.text, start, end) for argument in arguments[number - 1]
                    ]
            else:
                found.append(TypedToken("#" * (hashes // 2) + text[hashes:], start, end))
        return found


@dataclass(frozen=True)
class Alias:
    """A name that stands for another one, whatever that one means: it prints as it."""

    text: str


@dataclass(frozen=True)
class Flag:
    """A conditional that is true, or false, or neither for certain."""

    value: bool | None


@dataclass(frozen=True)
class FlagSetter:
    """A name that sets a flag."""

    flag: str
    value: bool


@dataclass(frozen=True)
class Unclear:
    """A name of which the meaning cannot be told, and why."""

    why: str
    perhaps: bool = False
    """Whether it may not be defined at all."""


@dataclass(frozen=True)
class Environment:
    """What an environment of the author's begins and ends with."""

    begin: Macro
    end: Macro


Meaning = Macro | Alias | Flag | FlagSetter | Unclear | Environment


@dataclass
class Meanings:
    """The meanings that hold, and those that will hold again when a group ends."""

    known: dict[str, Meaning] = field(default_factory=dict)
    kinds: list[str] = field(default_factory=list)
    """The groups that are open: braces, dollars, environments."""
    saved: list[dict[str, Meaning | None]] = field(default_factory=list)

    def get(self, name: str) -> Meaning | None:
        """What a name means by the text; ``None`` if the text says nothing of it."""
        return self.known.get(name)

    def define(self, name: str, meaning: Meaning, everywhere: bool = False) -> None:
        """From here on the name has this meaning, to the end of the group, or for good."""
        if everywhere:
            for saved in self.saved:
                saved.pop(name, None)
        elif self.saved:
            self.saved[-1].setdefault(name, self.known.get(name))
        self.known[name] = meaning

    def open(self, kind: str) -> None:
        """A group begins."""
        self.kinds.append(kind)
        self.saved.append({})

    def close(self, kind: str) -> None:
        """A group ends, and those in it; nothing happens if none of this kind is open."""
        if kind in self.kinds:
            while True:
                for name, meaning in self.saved.pop().items():
                    if meaning is None:
                        del self.known[name]
                    else:
                        self.known[name] = meaning
                if self.kinds.pop() == kind:
                    break

    def same(self, first: str, second: str) -> bool | None:
        """Whether two tokens mean the same; ``None`` if it cannot be told."""
        if first == second:
            return True
        one, other = self.known.get(first), self.known.get(second)
        one, other = (
            meaning if meaning is not None else Alias(text)
            for meaning, text in ((one, first), (other, second))
        )
        if isinstance(one, Unclear) or isinstance(other, Unclear):
            return None
        if isinstance(one, Alias) and isinstance(other, Alias):
            # Two names that are not defined may be both undefined, or one may be the other.
            both = is_command(one.text) and is_command(other.text)
            return True if one == other else None if both else False
        return one == other
