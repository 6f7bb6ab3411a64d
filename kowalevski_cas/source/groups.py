"""Groups of a text: what is open, whether it is a formula, and where nothing can be told."""

from __future__ import annotations

from kowalevski_cas.source.definitions import EVERYTHING
from kowalevski_cas.source.expanded import ExpandedOutput
from kowalevski_cas.source.meanings import Meanings, Unclear
from kowalevski_cas.source.mouth import Mouth
from kowalevski_cas.source.tex import TypedToken

_MATHEMATICS = frozenset(
    "equation displaymath eqnarray align alignat flalign gather multline dmath math".split()
)
_WORDS = frozenset(rf"\{name}" for name in "text mbox hbox textrm intertext parbox".split())
_CLOSING = {r"\]": r"\[", r"\)": r"\(", "}": "{"}
_OPENING = frozenset(_CLOSING.values())


class Groups:
    """The groups that tokens open and close as they are written."""

    def __init__(
        self, mouth: Mouth, meanings: Meanings, output: ExpandedOutput, notes: list[tuple[int, str]]
    ) -> None:
        self.mouth, self.meanings, self.output, self.notes = mouth, meanings, output, notes
        self.lost = -1
        """Where in the text nothing can be told any more, to the end of a group."""
        self.why = ""

    def sign(self, token: TypedToken) -> None:
        """Write a token; it may begin or end a group."""
        text = token.text
        if text in _CLOSING:
            self.output.emit(token)
            self.close(_CLOSING[text])
        elif text in _OPENING:
            before = self.output.last
            self.meanings.open("words" if text == "{" and before in _WORDS else text)
            self.output.emit(token)
        elif text in ("$", "$$"):
            self.output.emit(token)
            # Two dollars in a row close one inline formula and open the next.
            for piece in [*text] if "$" in self.meanings.kinds else [text]:
                self._dollar(piece)
        else:
            self.output.emit(token)

    def _dollar(self, sign: str) -> None:
        kinds = self.meanings.kinds
        if sign in kinds and (sign == "$$" or "words" not in kinds[kinds.index(sign) :]):
            self.close(sign)
        else:
            self.meanings.open(sign)

    def close(self, kind: str) -> None:
        """A group ends, and with it what could not be told in it."""
        braces = [kind for kind in self.meanings.kinds if kind in ("{", "words")]
        self.meanings.close(braces[-1] if kind == "{" and braces else kind)
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
            self.lost, self.why = self.output.size, meaning.why
            self.notes.append((self.mouth.last, meaning.why))
        elif meaning is None:
            self.end_unknown()

    def end_unknown(self) -> None:
        """An interval ends of which nothing could be told."""
        if self.lost >= 0:
            self.output.lose(self.lost, self.why)
            self.lost = -1
