"""What the writers of all formats have in common: each kind of text and block has its method."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable
from importlib.resources import files

from kowalevski_cas import __version__
from kowalevski_cas.notation import Formula
from kowalevski_cas.report.document import Block, Code, Document, Emphasis, Inline, Link, Sign, Text
from kowalevski_cas.report.made import today
from kowalevski_cas.report.marks import Shown
from kowalevski_cas.report.pieces import pieces, width_of
from kowalevski_cas.report.setting import SHORT, Typesetter


class Writer(ABC):
    """Writes a document in a format. The page around it is a skeleton beside this module."""

    page: str
    """The name of the skeleton, in which ``@body@`` stands for what is written."""
    setter: Typesetter
    room = 44.0
    """The width of a display, in em."""
    origin: str
    """A line under the title."""
    emphases: tuple[str, str]
    """Italics, and bold type."""
    whole: tuple[str, str]
    """A formula within a line that is not broken, and one of fractions, higher than the line."""

    def write(self, document: Document) -> str:
        """The document as a file."""
        skeleton = (files(__package__) / "pages" / self.page).read_text(encoding="utf-8")
        parts = self.parts(document)
        return re.sub("@([a-z]+)@", lambda gap: parts[gap[1]], skeleton)

    def parts(self, document: Document) -> dict[str, str]:
        """What the skeleton has gaps for."""
        lines = (self.origin.format(self.text(line)) for line in document.subtitle)
        return {
            "title": self.escape(document.title),
            "short": self.escape(document.short),
            "subtitle": "\n".join(lines),
            "marks": self.marks(),
            "body": self.blocks(document.blocks),
            "version": __version__,
            "date": today().isoformat(),
        }

    # Texts

    def text(self, text: Text) -> str:
        """A run of words, formulas, signs and links."""
        return "".join(map(self.inline, text))

    def inline(self, element: Inline) -> str:
        """A piece of a text."""
        match element:
            case str():
                return self.escape(element)
            case Formula():
                return self.formula(element)
            case Code(text):
                return self.code(text)
            case Sign(verdict):
                return self.sign(verdict)
            case Link(target, (str(name),), True) if "://" not in target:
                return self.code(name)  # a file, which does not go with a page that is sent on
            case Link():
                return self.link(element)
            case Emphasis(text, strong):
                return self.emphases[strong].format(self.text(text))

    # Blocks

    def blocks(self, blocks: Iterable[Block]) -> str:
        """Blocks one under the other."""
        return "\n".join(map(self.block, blocks))

    def block(self, block: Block) -> str:
        """A block by the method of its kind."""
        method = getattr(self, type(block).__name__.lower())
        written: str = method(block)
        return written

    # What a format has to say, beside the methods for blocks

    @abstractmethod
    def escape(self, text: str) -> str:
        """Plain text."""

    @abstractmethod
    def marks(self) -> str:
        """The signs of verdicts, for the skeleton."""

    def formula(self, formula: Formula) -> str:
        """A formula within a line, which is not broken within a short one."""
        text, row = f"${self.setter.inline(formula)}$", pieces(formula, self.setter.printer)
        if width_of(row) > SHORT:
            return text
        return self.whole[any(piece.tall for piece in row)].format(text)

    @abstractmethod
    def code(self, text: str) -> str:
        """Letters as they are typed."""

    @abstractmethod
    def sign(self, verdict: Shown) -> str:
        """The sign of a verdict."""

    @abstractmethod
    def link(self, link: Link) -> str:
        """A link."""
