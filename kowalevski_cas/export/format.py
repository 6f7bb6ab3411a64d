"""What a format of export is: how to say a certificate to a program, and how to read its answer."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from kowalevski_cas.tools import Tool

Json = dict[str, Any]
"""A certificate as it was read (docs/certificate.md), accepted by the checker."""


RANKS = "it rests on ranks modulo a prime, which are not computed there"
SOLUTIONS = (
    "it rests on the uniqueness of solutions of differential equations, which is not known there"
)


class Inexpressible(Exception):
    """The format has no words for what a certificate states; the message says which and why."""


@dataclass(frozen=True)
class Export:
    """Certificates in the language of a program.

    ``shared`` has the files on which the others rest, in the order in which the
    program has to read them; ``names`` the name of the file about each claim, and
    ``texts`` its text; ``omitted`` says why a claim has no file.
    """

    shared: dict[str, str]
    names: dict[str, str]
    texts: dict[str, str]
    omitted: dict[str, str]

    @property
    def files(self) -> dict[str, str]:
        """All files that the program has to read: texts by name."""
        return self.shared | {self.names[claim]: text for claim, text in self.texts.items()}


class Format(ABC):
    """A program that can confirm certificates, and how to speak with it."""

    tool: ClassVar[Tool]
    """The program itself: its name, and how it is called."""

    suffix: ClassVar[str]
    """The end of the names of its files."""

    def shared(self) -> dict[str, str]:
        """Files on which the others rest; none, unless a format says so."""
        return {}

    def project(self, names: Iterable[str]) -> dict[str, str]:
        """What tells the program's own tools how to build files; nothing, unless a format says."""
        return {}

    @abstractmethod
    def translate(self, certificate: Json) -> str:
        """The text of the file about one certificate, all of its parts.

        Raises:
            Inexpressible: one of the parts cannot be said.
        """

    @abstractmethod
    def arguments(self, file: Path) -> list[str]:
        """The arguments for the program to read a file; it runs in the file's folder."""

    @abstractmethod
    def objection(self, text: str, output: str) -> str:
        """Why the output, after exit code 0, does not confirm what ``text`` states.

        Empty only if each statement is confirmed in so many words.
        """

    def files(self, certificates: Mapping[str, Json]) -> Export:
        """The files about certificates, given by claim."""
        export = Export(self.shared(), {}, {}, {})
        for claim, certificate in certificates.items():
            try:
                text = self.translate(certificate)
            except Inexpressible as reason:
                export.omitted[claim] = str(reason)
                continue
            name = identifier(claim) + self.suffix
            while name in export.files:
                name = f"_{name}"
            export.names[claim], export.texts[claim] = name, text
        return export


_SIGNS = {"+": "_plus", "-": "_minus"}


def identifier(name: str) -> str:
    r"""A name of letters, digits and underscores.

    >>> identifier("F1-prime"), identifier("eq16.1"), identifier(r"\sqrt{x_1x_2}"), identifier("4")
    ('F1_prime', 'eq16_1', 'sqrt_x_1x_2', '_4')
    >>> identifier("x_+"), identifier("p^-_1")
    ('x_plus', 'p_minus_1')
    """
    name = re.sub(r"([_^])([-+])", lambda sign: _SIGNS[sign[2]], name.replace("*", "_star"))
    name = re.sub(r"\\mathbf|\\boldsymbol", "bold", re.sub(r"\\text|\\mathrm", "", name))
    name = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")
    return name if name[:1].isalpha() else f"_{name}"
