r"""Conditionals of TeX: those that can be decided from the text, and those that cannot."""

from __future__ import annotations

import re

from kowalevski_cas.source.meanings import Flag, Macro, Meanings
from kowalevski_cas.source.mouth import Mouth
from kowalevski_cas.source.tex import TypedToken, is_command, is_word

_PRIMITIVE = frozenset(
    rf"\if{name}"
    for name in (
        " cat num dim odd vmode hmode mmode inner x void hbox vbox eof true false case defined"
        " csname fontchar"
    ).split(" ")
)
UNDECIDED = r"\if?"
"""A conditional that no text can have: it cannot be decided."""

_BRACED = re.compile(
    r"\\(?:iff|ifthenelse|ifoot|ifstr\w+|ifdef\w+|ifund\w+|ifbool|iftoggle|ifblank)$"
)
_NUMBERS = re.compile(r"\s*(-?\d+)\s*([<>=])\s*(-?\d+)(?!\d)")


class Conditionals:
    """The conditionals that are open, and whether the next one is true."""

    def __init__(self, mouth: Mouth, meanings: Meanings) -> None:
        self.mouth, self.meanings = mouth, meanings
        self.open: list[int | None] = []
        """For each conditional that cannot be decided, where what it prints begins."""

    @property
    def uncertain(self) -> bool:
        """Whether it cannot be told if the text here is executed."""
        return any(begin is not None for begin in self.open)

    def begins(self, name: str) -> bool:
        r"""Whether a name begins a conditional, which ends with ``\fi``."""
        if name == UNDECIDED or name in _PRIMITIVE:
            return True
        meaning = self.meanings.get(name)
        if meaning is not None:
            return isinstance(meaning, Flag)
        braced = not name.startswith(r"\if") or _BRACED.match(name)
        return not braced and self.mouth.peek() != "{"

    def start(self, name: str, printed: int, mathematics: bool) -> None:
        """A conditional begins, and what it does not print is skipped."""
        value = self.value(name, mathematics)
        if value is None:
            self.open.append(printed)
        else:
            self.open.append(None)
            if not value:
                self.skip(to_else=True)

    def otherwise(self) -> None:
        r"""An ``\else``: what follows is not executed, if what came before was."""
        if self.open and self.open[-1] is None:
            self.skip(to_else=False)

    def skip(self, to_else: bool) -> None:
        r"""Leave out what is not executed, up to ``\fi`` or, perhaps, ``\else``."""
        depth = 0
        while (token := self.mouth.take()) is not None:
            if token.text == r"\fi":
                if depth == 0:
                    self.open.pop()
                    return
                depth -= 1
            elif token.text == r"\else" and depth == 0 and to_else:
                return
            elif is_word(token.text) and self.begins(token.text):
                depth += 1

    def value(self, name: str, mathematics: bool) -> bool | None:
        """Whether a conditional is true; ``None`` if that cannot be told."""
        meaning = self.meanings.get(name)
        if isinstance(meaning, Flag):
            return meaning.value
        if name in (r"\iftrue", r"\iffalse"):
            return name == r"\iftrue"
        if name == r"\ifmmode":
            return mathematics
        if name in (r"\ifx", r"\if"):
            return self._alike(name)
        if name == r"\ifnum":
            return self._compare()
        if name == r"\ifdefined":
            token = self._token()
            known = isinstance(self.meanings.get(token.text), Macro) if token else False
            self.mouth.put_back([token] if token and not known else [])
            return True if known else None
        return None

    def _token(self) -> TypedToken | None:
        """The next token, of a blank one blank; not one behind a control word."""
        token = self.mouth.character()
        if token is not None and token.text.isspace() and token.literal:
            return token._replace(text=" ")
        return token

    def _alike(self, name: str) -> bool | None:
        first = self._token()
        if first is not None and first.text == " " and first.literal:
            first = self._token()  # the blank behind the control word
        second = self._token()
        if first is not None and second is not None and is_word(first.text):
            while second is not None and second.text == " " and second.literal:
                second = self._token()
        if first is None or second is None:
            return None
        if name == r"\if" and (is_command(first.text) or is_command(second.text)):
            same = None
        else:
            same = self.meanings.same(first.text, second.text)
        if same is None:
            self.mouth.put_back([first, second])
        return same

    def _compare(self) -> bool | None:
        taken: list[TypedToken] = []
        while len(taken) < 20 and (token := self.mouth.character()) is not None:
            taken.append(token)
            if not re.fullmatch(r"[-\d<>=]|\s+", token.text):
                break
        match = _NUMBERS.match("".join(token.text for token in taken))
        used = 0
        while match and sum(len(token.text) for token in taken[:used]) < match.end():
            used += 1
        self.mouth.put_back(taken[used:])
        if match is None:
            return None
        first, second = int(match[1]), int(match[3])
        return {"<": first < second, ">": first > second, "=": first == second}[match[2]]
