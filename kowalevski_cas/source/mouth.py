"""The tokens that are still to come, and the arguments that are taken from them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kowalevski_cas.source.tex import (
    PARAGRAPH,
    TypedToken,
    bare,
    characters,
    is_word,
    normal,
    ordinary,
    pattern,
)

LONGEST = 200_000
"""Tokens in one argument."""
PATIENCE = 500_000
"""Tokens that are looked through for the ends of arguments that have none."""


class Malformed(Exception):
    """What stands there is not what is expected; it is left as it is."""


class Mouth:
    """The tokens of a text, and before them those that were put back."""

    def __init__(self, text: str, at: int = 0) -> None:
        self.text = text
        self.at = at
        self.waiting: list[TypedToken] = []
        self.active = ""
        """Characters that may have a meaning as if they were macros."""
        self.at_is_letter = False
        self.last = at
        """The end of the interval of the file that has been taken."""
        self.patience = PATIENCE
        self.blanks: list[TypedToken] = []
        """The blanks before the last visible character."""

    def take(self) -> TypedToken | None:
        """The next token; ``None`` at the end."""
        if self.waiting:
            token = self.waiting.pop()
        else:
            match = pattern(self.active, self.at_is_letter).match(self.text, self.at)
            if match is None:
                return None
            token = TypedToken(match[0], self.at, match.end(), True)
            self.at = match.end()
        if token.end > self.last:
            self.last = token.end
        return token

    def plain(self) -> TypedToken | None:
        """All that comes next and means nothing but itself; ``None`` if there is nothing such."""
        match = None if self.waiting else ordinary(self.active).match(self.text, self.at)
        if match is None:
            return None
        token = TypedToken(match[0], self.at, match.end(), True)
        self.at = self.last = match.end()
        return token

    def put_back(self, tokens: Iterable[TypedToken]) -> None:
        """These tokens come next."""
        found = [*tokens]
        if found and found[0].literal:
            self.last = min(self.last, found[0].start)
        self.waiting.extend(reversed(found))

    def character(self) -> TypedToken | None:
        """The next token; of a run, only its first character."""
        token = self.take()
        if token is None or len(token.text) == 1 or token.text[0] in "\\#$":
            return token
        if token.text.isspace():
            return token
        first, *rest = characters(token)
        self.put_back(rest)
        return first

    def visible(self) -> TypedToken | None:
        """The next character that is no blank; a blank line is none."""
        self.blanks = []
        while (token := self.character()) is not None and token.text.isspace():
            if PARAGRAPH.search(token.text):
                break
            self.blanks.append(token)
        return token

    def unread(self, token: TypedToken | None) -> None:
        """The last visible character comes next, with the blanks before it."""
        self.put_back([*self.blanks, *([token] if token is not None else [])])

    def peek(self) -> str:
        """The text of the next character that is no blank; empty at the end."""
        token = self.visible()
        self.unread(token)
        return token.text if token is not None else ""

    def skips(self, text: str) -> bool:
        """Whether this character comes next, which is taken then."""
        token = self.visible()
        if token is not None and token.text == text:
            return True
        self.unread(token)
        return False

    # -- arguments ------------------------------------------------------------------

    def group(self, opened: TypedToken) -> list[TypedToken]:
        """The tokens up to the brace that closes; the opening one is taken already."""
        found, depth = [opened], 1
        while depth:
            token = self.take()
            if token is None or len(found) > min(LONGEST, self.patience):
                raise self.error_at_end([*found[1:], token], "this brace is never closed")
            depth += {"{": 1, "}": -1}.get(token.text, 0)
            found.append(token)
        return normal(found[1:-1])

    def error_at_end(self, taken: Sequence[TypedToken | None], why: str) -> Malformed:
        """What is to be raised where the end of an argument is missing; the tokens come again."""
        self.patience = max(0, self.patience - len(taken))
        self.put_back(token for token in taken if token is not None)
        return Malformed(why)

    def argument(self) -> list[TypedToken]:
        """A group without its braces, or a single token."""
        token = self.visible()
        if token is None or token.text == "}" or token.text.isspace():
            self.unread(token)
            raise Malformed("an argument is missing")
        return self.group(token) if token.text == "{" else [token]

    def need_group(self) -> list[TypedToken]:
        """A group, which has to be there."""
        if self.peek() != "{":
            raise Malformed("an argument in braces is missing")
        return self.argument()

    def until(self, delimiter: Sequence[str]) -> list[TypedToken]:
        """The tokens before a delimiter that stands outside of braces, without it."""
        found: list[TypedToken] = []
        depth = 0
        size = len(delimiter)
        while True:
            token = self.character()
            ended = token is None or (token.text == "}" and depth == 0)
            if ended or token is None or len(found) > min(LONGEST, self.patience):
                raise self.error_at_end([*found, token], f"{''.join(delimiter)} is missing")
            depth += {"{": 1, "}": -1}.get(token.text, 0)
            if token.text.isspace():
                if found and is_word(found[-1].text):
                    continue
                token = token._replace(text=" ", literal=False)
            found.append(token)
            if depth == 0 and [token.text for token in found[-size:]] == [*delimiter]:
                return bare(normal(found[:-size]))

    def optional_argument(self, opening: str, closing: str) -> list[TypedToken] | None:
        """An optional argument between its brackets; ``None`` if there is none."""
        if not self.skips(opening):
            return None
        found: list[TypedToken] = []
        depth = brackets = 0
        while True:
            token = self.character()
            if token is None or len(found) > min(LONGEST, self.patience):
                raise self.error_at_end([*found, token], f"{opening} is never closed")
            if depth == 0 and token.text == closing:
                if brackets == 0:
                    return bare(normal(found))
                brackets -= 1
            depth += {"{": 1, "}": -1}.get(token.text, 0)
            brackets += token.text == opening and depth == 0
            found.append(token)
